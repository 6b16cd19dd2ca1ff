// A run as a story: the kinds of motion that follow each other, and its moments in sentences.
import { outcomes } from "./outcome.js";

/// Intervals of flight, impacts, sliding and rolling, s.
export function bandsOf({ events, from_s, until_s }) {
  const bands = [];
  const add = (name, begin_s) => {
    if (bands.length > 0) bands.at(-1).until_s = begin_s;
    bands.push({ name, from_s: begin_s, until_s });
  };
  add("flight", from_s);
  const contacts = contactsOf(events, until_s);
  contacts.forEach(({ from_s: begin_s, until_s: end_s, rolls_s, slips_s }, n) => {
    const lasts = n === contacts.length - 1 && (rolls_s !== null || end_s === until_s);
    if (lasts) add("sliding", begin_s);
    else if (bands.at(-1).name !== "impacts") add("impacts", begin_s);
    if (lasts && rolls_s !== null) add("rolling", rolls_s);
    if (lasts && slips_s !== null) add("sliding", slips_s);
    if (n === contacts.length - 1 && end_s < until_s) add("flight", end_s);
  });
  return bands.filter((band) => band.until_s > band.from_s);
}

/// Each contact from touch-down to release, with the onset and end of rolling, if any.
function contactsOf(events, until_s) {
  const all = [];
  for (const { event, time_s } of events) {
    if (event === "touch_down" || event === "renewed_contact")
      all.push({ from_s: time_s, until_s, rolls_s: null, slips_s: null });
    const last = all.at(-1);
    if (!last) continue;
    if (event === "release" && last.until_s === until_s) last.until_s = time_s;
    if (event === "rolling_onset") last.rolls_s ??= time_s;
    if (event === "break_away") last.slips_s ??= time_s;
  }
  return all;
}

/// The time at which O is farthest out, after another time.
function farthest({ time_s, x_a_m, y_a_m }, from_s) {
  let best = time_s.length - 1, most = -1;
  for (let row = 0; row < time_s.length; ++row) {
    const rho = Math.hypot(x_a_m[row], y_a_m[row]);
    if (time_s[row] >= from_s && rho > most) [best, most] = [row, rho];
  }
  return time_s[best];
}

const inKilonewton = (force_N) => `${(force_N / 1e3).toFixed(0)}\u00a0kN`;
const inHertz = (f) => `${f.toFixed(f < 100 ? 1 : 0)}\u00a0Hz`;
const ms = (duration_s) => `${(1e3 * duration_s).toFixed(1)}\u00a0ms`;

/// Moments in their order: time, title and sentence. The last one depends on the outcome.
export function storyOf(picture) {
  const { summary, events, mass_loss_s: loss_s, from_s } = picture;
  const { inputs, speed_at_mass_loss_Hz: speed_Hz, critical_speed_Hz: critical_Hz } = summary;
  if (loss_s === null) return [{ time_s: from_s, title: "No loss", text: "The rotor keeps all of its mass." }];
  const further_m = inputs.eccentricity * (inputs.unbalance_factor - 1);
  const clearance_mm = 1e3 * (inputs.stator_radius - inputs.rotor_radius);
  const first = events.find(({ event }) => event === "touch_down");
  const story = [
    { time_s: from_s, title: "Before the loss", text: `At ${inHertz(speed_Hz)} the rotor turns quietly about its mass centre, ` +
      `${(speed_Hz / critical_Hz).toFixed(speed_Hz < 3 * critical_Hz ? 1 : 0)} times as fast as its critical speed.` },
    { time_s: loss_s, title: "A piece leaves the rim", text: "The mass centre of the rotor is now " +
      `${(1e3 * further_m).toFixed(1)}\u00a0mm further out and keeps moving. The rotor swings towards the ring.` },
  ];
  if (!first) {
    story.push({ time_s: farthest(picture.motion, loss_s), title: "It stays clear", text: "The swing reaches " +
      `${(1e3 * summary.max_displacement_m).toFixed(2)}\u00a0mm of the ${clearance_mm.toFixed(1)}\u00a0mm of clearance: the rotor was too slow to touch the ring.` });
    return story;
  }
  story.push({ time_s: first.time_s, title: "First impact", text: `${ms(first.time_s - loss_s)} later it has crossed the ` +
    `${clearance_mm.toFixed(1)}\u00a0mm of clearance. The faster the rotor turns, the further it swings out.` });
  const rolls_s = summary.rolling_onset_s;
  const bands = bandsOf(picture);
  const end = bands.find(({ name }) => name === "sliding") ?? bands.at(-1);
  const many = summary.touch_downs;
  story.push({ time_s: rolls_s === null ? first.time_s + 0.5 * (end.from_s - first.time_s) : 0.3 * end.from_s + 0.7 * rolls_s,
    title: many > 1 ? `${many} touch-downs, then sliding` : "Sliding", text: "Friction at the rim slows the rotation " +
      "and drives the whirl of the centre, against the rotation." });
  if (rolls_s === null) {
    story.at(-1).title = many > 1 ? `${many} touch-downs` : "One touch-down";
    story.push({ time_s: summary.peak_time_s, title: "No rolling", text: `The largest force is ` +
      `${inKilonewton(summary.peak_normal_force_N)}. At the end of this run the rotor ${outcomes[summary.outcome]}.` });
    return story;
  }
  story.push({ time_s: rolls_s, title: "Slip ends", text: `At ${inHertz(summary.rolling_onset_speed_Hz)}, ` +
    `${ms(rolls_s - first.time_s)} after the first contact, the rim rolls along the ring: most of the remaining energy is in the backward whirl.` });
  story.push({ time_s: summary.peak_time_s, title: "Largest force", text: `The ring holds the mass on this circle with ` +
    `${inKilonewton(summary.peak_normal_force_N)}, ${Math.round(summary.peak_normal_force_N / (9.81 * inputs.mass) / 100) * 100} times the rotor's weight.` });
  return story;
}
