// A run as a story: the kinds of motion that follow each other, and its moments in sentences.
import { digits } from "./outcome.js";
import { outcomes } from "./words.js";

/// Intervals of flight, impacts, sliding and rolling, s.
export function bandsOf({ events, from_s, until_s }) {
  const bands = [];
  const add = (name, time_s) => {
    const begin_s = Math.max(time_s, from_s);
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

const inKilonewton = (force_N) => `${digits(force_N / 1e3, 3)}\u00a0kN`;
const inHertz = (f) => `${f.toFixed(Math.abs(f) < 100 ? 1 : 0).replace("-", "−")}\u00a0Hz`;
const inMillimetres = (length_m, count) => `${digits(1e3 * length_m, count)}\u00a0mm`;
const ms = (duration_s) => `${(1e3 * duration_s).toFixed(1)}\u00a0ms`;

/// Moments in the order of their times, within what is shown: time, title and sentence.
export function storyOf(picture) {
  const { summary, events, motion, mass_loss_s: loss_s, from_s, until_s } = picture;
  const { inputs, outcome, first_contact_s: first_s, rolling_onset_s: rolls_s, peak_time_s: peak_s } = summary;
  const lost = summary.mass_loss_reached, clear_before = lost && (first_s === null || first_s >= loss_s);
  const clearance = `${inMillimetres(inputs.stator_radius - inputs.rotor_radius, 3)} of clearance`;
  const story = [];
  const add = (time_s, title, ...sentences) =>
    story.push({ time_s: Math.min(until_s, Math.max(from_s, time_s)), title, text: sentences.filter(Boolean).join(" ") });
  const told = () => story.sort((one, other) => one.time_s - other.time_s);

  const speed_Hz = summary.speed_at_mass_loss_Hz, ratio = speed_Hz / summary.critical_speed_Hz;
  const is_overcritical = ratio > 2 && Number.isFinite(ratio); // it turns nearly about its mass centre
  if (!lost) add(from_s, "No loss", "The rotor keeps all of its mass.");
  else {
    add(from_s, "Before the loss", !clear_before ? "The rotor touches the ring before a piece is lost."
      : `At ${inHertz(speed_Hz)} the rotor turns ` + (is_overcritical ? `quietly about its mass centre, ${digits(ratio, 2)} times as fast as its critical speed.`
        : Number.isFinite(ratio) ? `at ${digits(ratio, 2)} times its critical speed.` : "without supports that could vibrate."));
    add(loss_s, "A piece leaves the rim", "The mass centre of the rotor is now " +
      `${inMillimetres(inputs.eccentricity * (inputs.unbalance_factor - 1), 2)} further out and keeps moving.`, clear_before && "The rotor swings outwards.");
  }

  if (first_s === null) {
    const reach_m = summary.max_displacement_m ?? summary.max_displacement_before_loss_m;
    add(farthest(motion, lost ? loss_s : from_s), outcome === "no_contact" ? "It stays clear" : "No contact so far",
      `The swing reaches ${inMillimetres(reach_m, 3)} of the ${clearance}.`, `The rotor ${outcomes[outcome]}.`);
    return told();
  }
  add(first_s, "First impact", clear_before ? `${ms(first_s - loss_s)} later it has crossed the ${clearance}.`
    : `At ${first_s.toFixed(4)}\u00a0s it has crossed the ${clearance}.`,
    clear_before && is_overcritical && "The faster the rotor turns, the further it swings out.");

  const contacts = contactsOf(events, until_s);
  const last = contacts.findLast((contact) => rolls_s === null || contact.from_s <= rolls_s) ?? { from_s: first_s };
  const count = events.filter(({ event, time_s }) => event === "touch_down" && (rolls_s === null || time_s <= rolls_s)).length;
  const braking = inputs.friction > 0 ? "Friction at the rim slows the rotation and drives the whirl of the centre, against the rotation."
    : "Without friction the ring only pushes the rotor back.";
  const force = peak_s !== null && inKilonewton(summary.peak_normal_force_N);
  if (rolls_s === null) {
    add(last.from_s, count > 1 ? `${count} touch-downs` : "One touch-down", braking);
    add(Math.max(peak_s ?? 0, last.from_s), "No rolling", force && `The largest force is ${force}.`,
      `At the end of this run the rotor ${outcomes[outcome]}.`);
    return told();
  }
  add(0.3 * last.from_s + 0.7 * rolls_s, count > 1 ? `${count} touch-downs, then sliding` : "Sliding", braking);
  const whirl_has_most = inputs.mass * inputs.rotor_radius ** 2 > inputs.inertia; // v_O is the rim's speed
  add(rolls_s, "Slip ends", `At ${inHertz(summary.rolling_onset_speed_Hz)}, ${ms(rolls_s - first_s)} after the first contact, ` +
    `the rim rolls along the ring${whirl_has_most ? ": most of the remaining energy is in the backward whirl" : ""}.`);
  if (force)
    add(peak_s, "Largest force", (peak_s < rolls_s ? "The hardest impact presses with " : "The ring holds the mass on this circle with ") +
      `${force}, ${digits(summary.peak_normal_force_N / (9.81 * inputs.mass), 2)} times the rotor's weight.`);
  return told();
}
