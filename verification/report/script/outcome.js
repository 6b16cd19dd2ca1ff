// The outcome of a run, in words and numbers.

/// Completes the sentence "The rotor ...", by the outcome of the summary.
export const outcomes = {
  rolling: "has come to roll along the ring",
  stalled: "is stalled below 1.5 times its critical speed: the motor cannot raise it",
  sliding: "slides along the ring without leaving it",
  freed: "has touched the ring and is clear of it again",
  no_contact: "does not touch the ring",
  bouncing: "bounces, and further contacts are possible",
  undecided: "has not touched the ring so far, but contact is possible",
};

/// With a number of significant digits.
export const digits = (value, count) => Number(value.toPrecision(count)).toString();
export const inKilonewton = (force_N) => `${(force_N / 1e3).toFixed(1)} kN`;
const inSeconds = (time_s) => `${time_s.toFixed(4)} s`;

export function sentence(summary) {
  const parts = [`The rotor ${outcomes[summary.outcome]}.`];
  const { touch_downs: touchDowns, first_contact_s, rolling_onset_s, peak_normal_force_N } = summary;
  if (touchDowns > 0)
    parts.push(`It touches down ${touchDowns === 1 ? "once" : `${touchDowns} times`}, first at ` +
      inSeconds(first_contact_s) +
      (peak_normal_force_N === null ? "." : `, and presses on the ring with up to ${inKilonewton(peak_normal_force_N)}.`));
  if (rolling_onset_s !== null)
    parts.push(`Rolling sets in at ${inSeconds(rolling_onset_s)}, ` +
      `${digits(1e3 * (rolling_onset_s - first_contact_s), 3)} ms after the first contact.`);
  return parts.concat(summary.remarks.map((remark) => `Remark: ${remark}.`)).join(" ");
}

/// Rows of the table of numbers: name, value in the summary, and format.
const rows = [
  ["outcome", (s) => s.outcome.replace("_", " ")],
  ["touch-downs", (s) => String(s.touch_downs)],
  ["first contact", (s) => s.first_contact_s, inSeconds],
  ["onset of rolling", (s) => s.rolling_onset_s, inSeconds],
  ["speed then", (s) => s.rolling_onset_speed_Hz, (f) => `${f.toFixed(2)} Hz`],
  ["largest normal force", (s) => s.peak_normal_force_N, inKilonewton],
  ["when", (s) => s.peak_time_s, inSeconds],
  ["largest displacement", (s) => s.max_displacement_m, (rho) => `${(1e3 * rho).toFixed(3)} mm`],
  ["whirl, mean of rolling", (s) => s.whirl_frequency_Hz, (f) => `${f.toFixed(1)} Hz`],
  ["speed at the loss", (s) => s.speed_at_mass_loss_Hz, (f) => `${f.toFixed(2)} Hz`],
  ["speed at the end", (s) => s.final_speed_Hz, (f) => `${f.toFixed(2)} Hz`],
];

/// Each number's name and text.
export const numbersOf = (summary) => rows.map(([name, of, shown = String]) =>
  [name, of(summary) === null ? "–" : shown(of(summary))]);

/// Fills a table's body, one row per number.
export function showNumbers(body, summary) {
  body.replaceChildren(...numbersOf(summary).map(([name, text]) => {
    const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
    head.scope = "row";
    [head.textContent, cell.textContent] = [name, text];
    row.append(head, cell);
    return row;
  }));
}
