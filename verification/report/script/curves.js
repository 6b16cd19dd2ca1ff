// The curves over time and their units.

const scaled = (column, factor) => column.map((value) => factor * value);
const lost = (picture, cause) => scaled(gained(picture, cause), -1);

/// The panels: curves, or areas stacked from below, in the panel's unit.
export const panels = [
  {
    title: "normal force", unit: "kN", share: 0.4, events: true,
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
