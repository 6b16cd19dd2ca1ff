// The kinds of motion of a run that follow each other.

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
