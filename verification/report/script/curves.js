// The curves over time and their units.
import { whirlAt } from "./motion.js";

const scaled = (column, factor) => column.map((value) => factor * value);
const lost = (picture, cause) => scaled(gained(picture, cause), -1);

/// The panels: curves, or areas stacked from below, in the panel's unit.
export const panels = [
  {
    title: "normal force", unit: "kN", share: 0.4,
    curves: [{ label: "normal force", colour: "first", of: ({ motion }) => scaled(motion.normal_force_N, -1e-3) }],
  },
  {
    title: "speed", unit: "Hz", share: 0.2,
    curves: [{ label: "speed", colour: "second", of: ({ motion }) => motion.speed_Hz }],
  },
  {
    title: "where the energy is", unit: "kJ", share: 0.4, stacked: true,
    curves: [
      { label: "motion", colour: "area-1", of: ({ motion }) => scaled(motion.kinetic_energy_J, 1e-3) },
      { label: "supports", colour: "area-2", of: (picture) => sum(scaled(picture.motion.support_energy_J, 1e-3), scaled(lost(picture, "support_damping"), 1e-3)) },
      { label: "ring", colour: "area-3", of: ({ motion }) => scaled(motion.contact_energy_J, 1e-3) },
      { label: "ring's damper", colour: "area-4", of: (picture) => scaled(lost(picture, "contact_damping"), 1e-3) },
      { label: "lost to friction", colour: "area-5", of: (picture) => scaled(lost(picture, "friction"), 1e-3) },
    ],
  },
];

/// Single panels, each beside a step of the accident.
export const stepPanels = {
  force: { ...panels[0], share: 1 },
  speed: { ...panels[1], share: 1 },
  distance: {
    title: "distance of O from the axis", unit: "mm", share: 1,
    level: ({ summary: { inputs } }) => ({ value: 1e3 * (inputs.stator_radius - inputs.rotor_radius), text: "clearance" }),
    curves: [{ label: "distance", colour: "first", of: ({ motion }) => motion.x_a_m.map((x, row) => 1e3 * Math.hypot(x, motion.y_a_m[row])) }],
  },
  velocity: {
    title: "velocity: rim, and O backwards", unit: "m/s", share: 1,
    curves: [
      { label: "rim", colour: "second", of: ({ motion, summary: { inputs } }) => scaled(motion.speed_Hz, 2 * Math.PI * inputs.rotor_radius) },
      { label: "O", colour: "first", of: ({ motion }) => motion.time_s.map((time_s, row) =>
        -2 * Math.PI * whirlAt(motion, time_s) * Math.hypot(motion.x_a_m[row], motion.y_a_m[row])) },
    ],
  },
};

const sum = (one, other) => one.map((value, i) => value + other[i]);

/// A work is known at the end of each step; between steps it is drawn straight.
function gained({ motion, works }, cause) {
  const times = works.time_s, values = works[cause];
  let next = 0;
  return motion.time_s.map((time_s) => {
    while (next < times.length && times[next] < time_s) ++next;
    if (next === 0 || next === times.length) return values[Math.max(0, next - 1)] ?? 0;
    const share = (time_s - times[next - 1]) / (times[next] - times[next - 1]);
    return values[next - 1] + share * (values[next] - values[next - 1]);
  });
}

/// Round numbers in a range, about so many, with enough decimals to differ.
export function ticks(least, greatest, about) {
  const rough = (greatest - least) / about, decade = 10 ** Math.floor(Math.log10(rough));
  const step = decade * [1, 2, 5, 10].find((digit) => digit * decade >= rough);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const all = [];
  for (let n = Math.ceil(least / step - 1e-9); n * step <= greatest + 1e-9 * step; ++n)
    all.push({ value: n * step, text: (n * step + 0).toFixed(digits).replace("-", "−") });
  return all;
}
