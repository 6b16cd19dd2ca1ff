// The state of the rotor at a time between the rows of a trace.

/// The last row at or before a time.
export function rowAt(times, time_s) {
  let low = 0,
    high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time_s) low = middle;
    else high = middle - 1;
  }
  return low;
}

/// The columns at that time, by their names, interpolated linearly between two rows; the contact
/// state is that of the first row.
export function stateAt(motion, time_s) {
  const row = rowAt(motion.time_s, time_s);
  const next = Math.min(row + 1, motion.time_s.length - 1);
  const length = motion.time_s[next] - motion.time_s[row];
  const share = length > 0 ? Math.min(1, Math.max(0, (time_s - motion.time_s[row]) / length)) : 0;
  const now = Object.fromEntries(
    Object.entries(motion).map(([name, column]) => [
      name,
      column[row] + share * (column[next] - column[row]),
    ]),
  );
  if (motion.contact_state) now.contact_state = motion.contact_state[row];
  return now;
}

/// The distance of O from the ring's centre, m.
export const rhoAt = ({ x_a_m, y_a_m }, row) => Math.hypot(x_a_m[row], y_a_m[row]);

/// Turns of O per second about the ring's centre, positive with the rotation (from x_a to y_a).
export function whirlAt(motion, time_s) {
  const about_s = 5e-5; // a small part of a turn
  const { x_a_m: x, y_a_m: y } = stateAt(motion, time_s - about_s);
  const { x_a_m: x1, y_a_m: y1 } = stateAt(motion, time_s + about_s);
  return Math.atan2(x * y1 - y * x1, x * x1 + y * y1) / (4 * Math.PI * about_s);
}

/// When the force is largest, or O farthest out after the loss; not before the last touch-down that
/// leads to rolling or sliding.
export function climaxOf({ summary, events, motion, mass_loss_s: loss_s }) {
  const { peak_time_s: peak_s, rolling_onset_s: rolls_s } = summary;
  const last = events.findLast(
    ({ event, time_s }) => event === "touch_down" && time_s <= (rolls_s ?? Infinity),
  );
  if (last) return Math.max(peak_s, last.time_s);
  let best = motion.time_s.length - 1,
    most = -1;
  motion.time_s.forEach((time_s, row) => {
    const rho = rhoAt(motion, row);
    if (time_s >= loss_s && rho > most) [best, most] = [row, rho];
  });
  return motion.time_s[best];
}

const contact_states = ["in flight", "sliding", "rolling", "in flight"];

/// Times are in milliseconds after the mass loss.
export const inMilliseconds = (time_s, loss_s) => 1e3 * (time_s - loss_s);

export const inWords = (now, loss_s) =>
  `${inMilliseconds(now.time_s, loss_s).toFixed(2).replace("-", "−")}\u00a0ms after the loss: ` +
  `${contact_states[Math.round(now.contact_state)]}, ${now.speed_Hz.toFixed(1)}\u00a0Hz` +
  (now.normal_force_N < 0 ? `, ${(-now.normal_force_N / 1e3).toFixed(0)}\u00a0kN` : "");
