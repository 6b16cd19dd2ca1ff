// Settings are options of `rotor run` without their dashes, and their texts. Defaults are the paper's
// values. The page's address has the same options.

const known = ["friction", "clearance", "unbalance-factor", "mass-loss-time", "mass-loss-speed-hz", "equations"];

/// Settings from an address such as #friction=0.2&clearance=2e-3. Anything else is left out, because an
/// address is untrusted.
export function settingsIn(hash) {
  const options = Object.fromEntries([...new URLSearchParams(hash.slice(1))].filter(
    ([option, text]) => known.includes(option) && (option === "equations" ? /^[a-z]+$/.test(text) : text !== "" && Number.isFinite(Number(text)))));
  if (options.equations === "consistent") options.equations = "corrected"; // its name before version 5 of the schema
  return options;
}

/// What an address has besides settings, such as friction=abc.
export const leftOutOf = (hash) => [...new URLSearchParams(hash.slice(1))].filter(([option, text]) => text && !(option in settingsIn(hash)))
  .map((setting) => setting.join("="));

export const addressOf = (options) => "#" + new URLSearchParams(options);

export const sets = ["published", "corrected"];
export const setOf = ({ equations }) => (equations === "corrected" ? "corrected" : "published");

/// The same settings in a set of equations.
export const inSet = ({ equations, ...others }, set) => (set === "corrected" ? { ...others, equations: set } : others);

/// The command that repeats a run.
export const commandOf = (options) =>
  ["build/rotor run", ...Object.entries(options).map(([option, text]) => `--${option} ${text}`), "--json"].join(" ");
