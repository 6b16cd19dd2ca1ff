// Settings are options of `rotor run` without their dashes, and their texts. Defaults are the paper's
// values. The page's address has the same options.

const flag = "no-mass-loss"; // the one option without a text

export const optionOf = (name) => name.replaceAll("_", "-");

/// A number as it would be typed: 8e8, not 800000000.
export const textOf = (number) =>
  Math.abs(number) >= 1e5 ? number.toExponential().replace("+", "") : String(number);

/// The least and the greatest magnification of an orbit.
export const zooms = [0.5, 100];

const number = (text) => (/^[+-]?\d+(\.\d+)?(e[+-]?\d+)?$/i.test(text) && Number.isFinite(Number(text)) ? Number(text) : undefined);
const view_of = {
  at: number, from: number, until: number, // ms
  zoom: (text) => (number(text) >= zooms[0] && number(text) <= zooms[1] ? number(text) : undefined),
  frame: (text) => (["ring", "stator", "rotating"].includes(text) ? text : undefined),
};

/// Settings from an address such as #friction=0.2&until=29.2, and after a slash the view. Anything that
/// does not look like an option or number is left out, because an address is untrusted.
export function settingsIn(hash) {
  const [options = {}, texts = {}] = hash
    .replace(/^#/, "")
    .split("/")
    .map((part) => Object.fromEntries([...new URLSearchParams(part)].filter(
      ([option, text]) => /^[a-z-]+$/.test(option) && /^[\w.+-]*$/.test(text))));
  if (options.equations === "corrected") options.equations = "consistent"; // as the program has it
  const view = Object.entries(view_of).map(([name, of]) => [name, of(texts[name])]).filter(([, value]) => value !== undefined);
  return [options, Object.fromEntries(view)];
}

/// The time and the part of a picture that a view states, if they lie in it; otherwise null.
export function placeIn({ at, from, until }, { from_s, until_s, mass_loss_s }) {
  const rounding_s = 1e-6; // of addresses
  const in_s = (ms) => (mass_loss_s ?? 0) + ms / 1e3;
  const lies_in = (ms) => in_s(ms) >= from_s - rounding_s && in_s(ms) <= until_s + rounding_s;
  return { time_s: lies_in(at) ? in_s(at) : null,
    part: lies_in(from) && lies_in(until) && from < until ? [in_s(from), in_s(until)] : null };
}

export const addressOf = (...parts) => "#" + parts.map((part) => new URLSearchParams(part).toString()).join("/");

/// The two corrections of the equations by their own names, even if their common name was stated.
export function corrections({ equations, ...others }) {
  return equations === "consistent" ? { "velocity-jump": "once", "gravity-moment": "balanced", ...others } : others;
}

/// The set of equations that has a map, or null for a mixed one.
export function setOf(options) {
  const { "velocity-jump": jump = "twice", "gravity-moment": moment = "as-printed" } = corrections(options);
  return jump === "once" && moment === "balanced" ? "consistent" : jump !== "once" && moment !== "balanced" ? "published" : null;
}

/// The same settings in a set of equations.
export function inSet(options, set) {
  const { equations, "velocity-jump": jump, "gravity-moment": moment, ...others } = options;
  return set === "consistent" ? { ...others, equations: set } : others;
}

/// The command that repeats a run, without the start of a trace.
export function commandOf({ from, ...options }) {
  const words = Object.entries(options).map(([option, text]) =>
    option === flag ? `--${option}` : `--${option} ${quoted(text)}`);
  return ["build/rotor run", ...words, "--energy --json"].join(" ");
}

const quoted = (text) => (/^[\w.+-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`);
