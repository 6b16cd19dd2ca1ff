// What is drawn over time, and in which unit.

/// The curves of each plot: of a picture, in the plot's unit.
export const plots = [
  {
    id: "force", title: "Normal force F_n (negative in compression)", unit: "kN", events: true,
    curves: [{ label: "F_n", colour: "first", of: ({ motion }) => scaled(motion.normal_force_N, 1e-3) }],
  },
  {
    id: "speed", title: "Rotation speed f", unit: "Hz",
    curves: [{ label: "f", colour: "second", of: ({ motion }) => motion.speed_Hz }],
  },
  {
    id: "energy", title: "Energy from the mass loss on, and where it goes", unit: "J",
    curves: [
      { label: "kinetic", colour: "first", of: ({ motion }) => motion.kinetic_energy_J },
      { label: "in the ring", colour: "second", of: ({ motion }) => motion.contact_energy_J },
      { label: "in the supports", colour: "third", of: ({ motion }) => motion.support_energy_J },
      { label: "to friction", colour: "fourth", of: (picture) => lost(picture, "friction") },
      { label: "to the ring's damper", colour: "fifth", of: (picture) => lost(picture, "contact_damping") },
      { label: "to the supports' dampers", colour: "sixth", of: (picture) => lost(picture, "support_damping") },
      { label: "from the motor", colour: "seventh", of: (picture) => gained(picture, "motor") },
    ],
  },
  {
    id: "displacement", title: "Displacement: q1 in the rotating axes, rho from the ring's centre", unit: "mm",
    curves: [
      { label: "rho", colour: "first", of: ({ motion }) => scaled(motion.rho_m, 1e3) },
      { label: "q1", colour: "third", of: ({ motion }) => scaled(motion.q1_m, 1e3) },
    ],
  },
];

const scaled = (column, factor) => column.map((value) => factor * value);
const lost = (picture, cause) => scaled(gained(picture, cause), -1);

/// A work is known at the end of each step; between them it is drawn straight.
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
