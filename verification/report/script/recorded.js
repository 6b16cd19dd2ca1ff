// Runs embedded in the page, in the form of the engine's answers.

/// A column from [least, greatest, steps of a 65535th as base64].
export function column([least, greatest, text]) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const steps = new Uint16Array(bytes.buffer);
  return Float64Array.from(steps, (step) => least + (step * (greatest - least)) / 65535);
}

/// A canonical form of settings: numbers as numbers, without the default equations.
const keyOf = (options) =>
  JSON.stringify(
    Object.entries(options)
      .filter(([name, text]) => !(name === "equations" && text === "corrected"))
      .map(([name, text]) => [name, Number.isNaN(Number(text)) ? text : Number(text)])
      .sort(),
  );

export class Recorded {
  #runs;
  constructor(runs) {
    this.#runs = new Map(runs.map((run) => [keyOf(run.options), run]));
  }
  /// The answer of the engine to these options, or null.
  answer(options) {
    const run = this.#runs.get(keyOf(options));
    if (!run) return null;
    run.answer ??= {
      ...run,
      motion: Object.fromEntries(
        Object.entries(run.motion).map(([name, packed]) => [name, column(packed)]),
      ),
    };
    return run.answer;
  }
}
