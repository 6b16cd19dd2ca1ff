// Where the rotor is at a time, between the rows of a trace.

/// The last row that is not later than a time.
export function rowAt(times, time_s) {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time_s) low = middle;
    else high = middle - 1;
  }
  return low;
}

/// The columns at that time, by their names, drawn straight between two rows.
export function stateAt(motion, time_s) {
  const row = rowAt(motion.time_s, time_s);
  const next = Math.min(row + 1, motion.time_s.length - 1);
  const length = motion.time_s[next] - motion.time_s[row];
  const share = length > 0 ? Math.min(1, (time_s - motion.time_s[row]) / length) : 0;
  return Object.fromEntries(Object.entries(motion).map(([name, column]) =>
    [name, column[row] + share * (column[next] - column[row])]));
}

const contact_states = ["free", "sliding", "rolling", "free, ring indented"];

export const inWords = (now) => `t = ${now.time_s.toFixed(5)} s, ${contact_states[Math.round(now.contact_state)]}, ` +
  `f = ${now.speed_Hz.toFixed(1)} Hz, F_n = ${(now.normal_force_N / 1e3).toFixed(0)} kN`;
