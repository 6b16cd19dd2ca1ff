// The outcome of a run, in words and numbers.
import { outcomes, results } from "./words.js";

export const inKilonewton = (force_N) => `${(force_N / 1e3).toFixed(1)} kN`;
const lasting = (time_s) =>
  time_s < 1 ? `${Number((1e3 * time_s).toPrecision(3))} ms` : `${time_s.toPrecision(3)} s`;
const inSeconds = (time_s) => `${time_s.toFixed(4)} s`;

export function sentence(summary) {
  const parts = [`The rotor ${outcomes[summary.outcome]}.`];
  const { touch_downs: count, first_contact_s, rolling_onset_s, peak_normal_force_N } = summary;
  if (count > 0)
    parts.push(
      `It touches down ${count === 1 ? "once" : `${count} times`}, first at ` +
        inSeconds(first_contact_s) +
        (peak_normal_force_N === null
          ? "."
          : `, and presses on the ring with up to ${inKilonewton(peak_normal_force_N)}.`),
    );
  if (rolling_onset_s !== null)
    parts.push(
      `Rolling sets in at ${inSeconds(rolling_onset_s)}, ` +
        `${lasting(rolling_onset_s - first_contact_s)} after the first contact.`,
    );
  return parts.concat(summary.remarks.map((remark) => `Remark: ${remark}.`)).join(" ");
}

/// A result in the unit that follows from its key's.
const inUnit = {
  s: inSeconds,
  N: inKilonewton,
  m: (rho) => `${(1e3 * rho).toFixed(3)} mm`,
  Hz: (f) => `${f.toFixed(2)} Hz`,
};
const inText = (key, value = null) =>
  value === null
    ? "–"
    : (inUnit[key.split("_").at(-1)] ?? ((count) => String(+count.toFixed(3))))(value).replace(
        /^-/,
        "−",
      );

/// Each number's name and text.
export const numbersOf = (summary) =>
  [["outcome", summary.outcome.replace("_", " ")]].concat(
    Object.entries(results).map(([key, label]) => [label, inText(key, summary[key])]),
  );
