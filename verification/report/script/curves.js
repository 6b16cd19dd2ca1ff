// The curves over time and their units.
import { rhoAt, whirlAt } from "./motion.js";

const scaled = (column, factor) => column.map((value) => factor * value);

const force = {
  title: "normal force",
  unit: "kN",
  share: 0.4,
  curves: [{ of: ({ motion }) => scaled(motion.normal_force_N, -1e-3) }],
};
const speed = {
  title: "speed",
  unit: "Hz",
  share: 0.25,
  curves: [{ of: ({ motion }) => motion.speed_Hz }],
};
const distance = {
  title: "distance of O from the axis",
  unit: "mm",
  share: 0.35,
  level: ({ summary: { inputs } }) => ({
    value: 1e3 * (inputs.stator_radius - inputs.rotor_radius),
    text: "clearance",
  }),
  curves: [{ of: ({ motion }) => motion.x_a_m.map((x, row) => 1e3 * rhoAt(motion, row)) }],
};
const velocity = {
  title: "velocity: rim, and O backwards",
  unit: "m/s",
  curves: [
    {
      label: "rim",
      of: ({ motion, summary: { inputs } }) =>
        scaled(motion.speed_Hz, 2 * Math.PI * inputs.rotor_radius),
    },
    {
      label: "O",
      dashes: [6, 3],
      of: ({ motion }) =>
        motion.time_s.map((at_s, row) => -2 * Math.PI * whirlAt(motion, at_s) * rhoAt(motion, row)),
    },
  ],
};

/// The panels of a run, one below the other, and single ones, each beside a step of the accident.
export const panels = [distance, force, speed];
export const stepPanels = { force, speed, distance, velocity };

/// Round numbers in a range, about so many, with enough decimals to differ.
export function ticks(least, greatest, about) {
  const rough = (greatest - least) / about,
    decade = 10 ** Math.floor(Math.log10(rough));
  const step = decade * [1, 2, 5, 10].find((digit) => digit * decade >= rough);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const all = [];
  for (let n = Math.ceil(least / step - 1e-9); n * step <= greatest + 1e-9 * step; ++n)
    all.push({ value: n * step, text: (n * step + 0).toFixed(digits).replace("-", "−") });
  return all;
}
