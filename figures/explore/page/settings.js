// Settings are what the command line would state: options of `rotor run` without their dashes, and
// their texts. What is not stated is the paper's. The same options stand in the page's address.

const flag = "no-mass-loss"; // the one option without a text

export const optionOf = (name) => name.replaceAll("_", "-");

/// A number as one would type it: 8e8, not 800000000.
export const textOf = (number) =>
  Math.abs(number) >= 1e5 ? number.toExponential().replace("+", "") : String(number);

/// Settings from an address, such as #friction=0.2&until=29.2, or two of them with a slash between. What
/// no option or number looks like is left out: anybody may have written the address.
export function settingsIn(hash) {
  return hash
    .replace(/^#/, "")
    .split("/")
    .map((part) => Object.fromEntries([...new URLSearchParams(part)].filter(
      ([option, text]) => /^[a-z-]+$/.test(option) && /^[\w.+-]*$/.test(text))));
}

export function addressOf(...settings) {
  return "#" + settings.map((options) => new URLSearchParams(options).toString()).join("/");
}

/// The command that repeats a run. Where a trace begins is no part of that.
export function commandOf({ from, ...options }) {
  const words = Object.entries(options).map(([option, text]) =>
    option === flag ? `--${option}` : `--${option} ${quoted(text)}`);
  return ["build/rotor run", ...words, "--energy --json"].join(" ");
}

const quoted = (text) => (/^[\w.+-]+$/.test(text) ? text : `'${text.replaceAll("'", `'\\''`)}'`);
