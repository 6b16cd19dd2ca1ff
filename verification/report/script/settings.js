// Settings are options of `rotor run` without their dashes, and their texts. Defaults are the paper's
// values. The page's address has the same options.

const flag = "no-mass-loss"; // the one option without a text

export const optionOf = (name) => name.replaceAll("_", "-");

/// A number as it would be typed: 8e8, not 800000000.
export const textOf = (number) =>
  Math.abs(number) >= 1e5 ? number.toExponential().replace("+", "") : String(number);

/// Settings from an address such as #friction=0.2&until=29.2/. Anything that does not look like an option or
/// number is left out, because an address is untrusted.
export function settingsIn(hash) {
  const options = Object.fromEntries([...new URLSearchParams(hash.replace(/^#|\/.*/g, ""))].filter(
    ([option, text]) => /^[a-z-]+$/.test(option) && /^[\w.+-]*$/.test(text)));
  if (options.equations === "corrected") options.equations = "consistent"; // as the program has it
  return options;
}

export const addressOf = (options) => "#" + new URLSearchParams(options);

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
