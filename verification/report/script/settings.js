// Settings are options of `rotor run` without their dashes, and their texts. Defaults are the
// paper's values in the corrected equations. The page's address has the same options.

const known = [
  "friction",
  "clearance",
  "ring-offset-x",
  "ring-offset-y",
  "unbalance-factor",
  "mass-loss-time",
  "mass-loss-speed-Hz",
  "equations",
];

/// Settings from an address such as #friction=0.2&clearance=2e-3. Anything else is left out,
/// because an address is untrusted.
export function settingsIn(hash) {
  return Object.fromEntries(
    [...new URLSearchParams(hash.slice(1))].filter(
      ([option, text]) =>
        known.includes(option) &&
        (option === "equations"
          ? /^[a-z]+$/.test(text)
          : text !== "" && Number.isFinite(Number(text))),
    ),
  );
}

/// What an address has besides settings, such as friction=abc.
export const leftOutOf = (hash) =>
  [...new URLSearchParams(hash.slice(1))]
    .filter(([option, text]) => text && !(option in settingsIn(hash)))
    .map((setting) => setting.join("="));

export const addressOf = (options) => "#" + new URLSearchParams(options);

export const sets = ["published", "corrected"];
export const setOf = ({ equations }) => (equations === "published" ? "published" : "corrected");

/// The same settings in a set of equations.
export const inSet = ({ equations, ...others }, set) =>
  set === "published" ? { ...others, equations: set } : others;

/// The command that repeats a run.
export const commandOf = (options) =>
  [
    "build/rotor run",
    ...Object.entries(options).map(([option, text]) => `--${option} ${text}`),
    "--json",
  ].join(" ");
