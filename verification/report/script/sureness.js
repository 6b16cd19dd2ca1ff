// "How sure is this?": the same run with inputs drawn within their printed digits, in the background.
import { Engine } from "./engine.js";
import { inKilonewton, outcomes } from "./outcome.js";

const draw_count = 30;

export class Sureness {
  #engine = null; // only for draws; started when needed
  #words;
  #onCurves;
  #asked = 0; // which request the draws belong to

  /// Writes the result in words, and shows the curves of the draws.
  constructor(words, onCurves) {
    this.#words = words;
    this.#onCurves = onCurves;
  }

  async ask(options) {
    const asked = this.forget();
    this.#engine ??= new Engine();
    this.#words.ariaBusy = "true"; // a screen reader waits for the sentences
    const draws = [];
    for (let n = 0; n < draw_count; ++n) {
      const draw = await this.#engine.ask({ kind: "draw", options, n, count: draw_count });
      if (asked !== this.#asked) return;
      draws.push(draw);
      this.#words.replaceChildren(line(`${draws.length} of ${draw_count} …`));
    }
    const drawn = draws.filter((draw) => !draw.refusal);
    this.#onCurves(drawn);
    this.#words.replaceChildren(...sentences(drawn, draws.length - drawn.length).map(line));
    this.#words.ariaBusy = "false";
  }

  forget() {
    this.#engine?.drop();
    this.#onCurves([]);
    this.#words.replaceChildren();
    this.#words.ariaBusy = "false";
    return ++this.#asked;
  }
}

function sentences(drawn, refused) {
  if (drawn.length === 0) return ["All draws are refused."];
  const summaries = drawn.map(({ summary }) => summary);
  const all = Object.keys(outcomes)
    .map((outcome) => [outcome, summaries.filter((summary) => summary.outcome === outcome).length])
    .filter(([, count]) => count > 0)
    .sort(([, one], [, other]) => other - one)
    .map(([outcome, count]) => `In ${count} of ${draw_count} draws the rotor ${outcomes[outcome]}.`);
  const peaks = summaries.map((summary) => summary.peak_normal_force_N).filter((force) => force !== null);
  if (peaks.length > 0) all.push(`Largest normal force: ${range(peaks, inKilonewton)}.`);
  all.push(`Touch-downs: ${range(summaries.map((summary) => summary.touch_downs), String)}.`);
  if (refused > 0) all.push(`Refused draws: ${refused}.`);
  all.push(`Inputs at their printed values vary within their printed digits: ${drawn[0].drawn
    .map(({ quantity, from, to }) => `${quantity.replaceAll("_", " ")} ${from} … ${to}`).join(", ") || "none"}. Inputs set ` +
    "to other values keep them. Grey curves: the draws, each shifted to its own mass loss.");
  return all;
}

function range(values, shown) {
  const sorted = [...values].sort((one, other) => one - other);
  const at = (share) => shown(sorted[Math.round(share * (sorted.length - 1))]);
  return `${at(0)} … ${at(1)}, median ${at(0.5)}`;
}

function line(text) {
  const paragraph = document.createElement("p");
  paragraph.textContent = text;
  return paragraph;
}
