// The accident in five steps: a picture beside the text, and one control for each step. Runs are
// recorded.
import { stepPanels } from "./curves.js";
import { climaxOf, stateAt } from "./motion.js";
import { inKilonewton } from "./outcome.js";
import { outcomes } from "./words.js";
import { Plots } from "./plots.js";
import { RotorView } from "./rotor.js";
import { inSet, sets } from "./settings.js";

const film_ms = 5000;
const losses = [
  { "mass-loss-time": "9.4" },
  { "mass-loss-time": "14.15" },
  { "mass-loss-time": "19.1" },
  {},
];
const ended = ({ events, summary }) =>
  events.find(({ event, time_s }) => event === "release" && time_s > summary.first_contact_s)
    .time_s;
const indented_um = ({ summary: { inputs } }, { x_a_m, y_a_m }) =>
  Math.max(0, 1e6 * (Math.hypot(x_a_m, y_a_m) - inputs.stator_radius + inputs.rotor_radius));
const inBothSets = (one, other, words) => `As printed ${words(one)}, corrected ${words(other)}.`;
const atLoss = ({ summary }) => `${summary.speed_at_mass_loss_Hz.toFixed(0)}\u00a0Hz`;
/// From one to a thousand, on a logarithmic slider.
const guessed = (value) => Number((10 ** ((3 * value) / 100)).toPrecision(2));

/// The panel below the rotor, the cases that the control selects, the least end of the panel's axis,
/// which is the same for all of them, the time shown, s, and the words beside the control.
const steps = {
  swing: {
    panel: "distance",
    cases: losses,
    names: atLoss,
    compares: true,
    part: (...both) => [
      both[0].mass_loss_s - 1e-3,
      Math.max(...both.map((run) => run.summary.first_contact_s ?? climaxOf(run))) + 1e-3,
    ],
    says: (run, corrected) =>
      `${atLoss(run)}. ` +
      inBothSets(
        run,
        corrected,
        ({ summary: { first_contact_s: first_s, peak_displacement_m }, mass_loss_s }) =>
          first_s === null
            ? `no: it swings out to ${(1e3 * peak_displacement_m).toFixed(2)}\u00a0mm`
            : `yes, after ${(1e3 * (first_s - mass_loss_s)).toFixed(1)}\u00a0ms`,
      ),
  },
  touch: {
    panel: "force",
    follows: true,
    part: (run) => [run.summary.first_contact_s - 1e-4, ended(run) + 1e-4],
    says: (run, corrected, now) =>
      `${inKilonewton(-now.normal_force_N)}; ` +
      `the ring is pressed in by ${indented_um(run, now).toFixed(0)}\u00a0μm.`,
  },
  brake: {
    panel: "speed",
    cases: [{ friction: "0.08" }, { friction: "0.2" }, {}],
    names: ({ summary }) => summary.inputs.friction,
    part: (run) => [
      run.summary.first_contact_s - 1e-3,
      Math.min(run.until_s, (run.summary.rolling_onset_s ?? run.until_s) + 2e-3),
    ],
    says: ({ summary: { inputs, outcome, rolling_onset_s, first_contact_s, touch_downs } }) =>
      `μ = ${inputs.friction}: ${touch_downs} touch-downs; the rotor ${outcomes[outcome]}` +
      (rolling_onset_s === null
        ? "."
        : `, ${(1e3 * (rolling_onset_s - first_contact_s)).toFixed(1)}\u00a0ms ` +
          "after the first contact."),
  },
  roll: {
    panel: "velocity",
    guesses: "roll-answer",
    stops: [1, 10, 100, 1000],
    part: (run) => [run.summary.rolling_onset_s - 4e-3, run.summary.rolling_onset_s + 4e-3],
    says: (run, corrected, now, value) =>
      guessed(value) === 1 ? "once" : `${guessed(value)} times`,
  },
  force: {
    panel: "force",
    cases: losses.slice(1),
    names: atLoss,
    compares: true,
    reaches: (runs) =>
      1e-3 * Math.max(...runs.map(({ summary }) => summary.peak_normal_force_N ?? 0)),
    part: (run, corrected) => [
      run.mass_loss_s - 1e-3,
      Math.max(run.summary.peak_time_s, corrected.summary.peak_time_s) + 5e-3,
    ],
    says: (run, corrected) =>
      `${atLoss(run)}. ` +
      inBothSets(run, corrected, ({ summary: { peak_normal_force_N: peak_N } }) =>
        peak_N === null ? "no contact" : inKilonewton(peak_N),
      ),
  },
};

/// A rotor with the curve of a step.
class Stage {
  #rotor;
  #plots;
  #curve;
  #key;
  constructor(figure) {
    const [rotor, curve] = figure.querySelectorAll("canvas");
    this.#curve = curve;
    this.#key = figure.querySelector(".sets");
    this.#rotor = new RotorView(rotor, figure.querySelector(".now"));
    this.#plots = new Plots(curve);
  }
  show(picture, corrected, { panel, compares }, part, reaches) {
    this.#plots.panels = [{ ...stepPanels[panel], reaches }];
    this.#curve.ariaLabel = `${stepPanels[panel].title} over time`;
    this.#plots.show(compares ? [picture, corrected] : [picture], part, part[0]);
    this.#key.lastElementChild.hidden = !compares;
    this.#rotor.picture = picture;
  }
  goTo(time_s) {
    this.#plots.markNow(time_s);
    this.#rotor.goTo(time_s);
  }
}

/// One picture stays beside the text; on a phone each step has its own.
export function showSteps(recorded) {
  const beside = document.getElementById("stage"),
    shared = new Stage(beside);
  const is_calm = matchMedia("(prefers-reduced-motion: reduce)");
  const seen = new Map(); // what to do when a step comes into view
  let playing = 0;
  for (const [id, step] of Object.entries(steps)) {
    const article = document.getElementById(id),
      input = article.querySelector("input"),
      output = article.querySelector("output");
    const figure = beside.cloneNode(true);
    figure.removeAttribute("id");
    article.firstElementChild.after(figure);
    const own = new Stage(figure);
    let picture, corrected, part;
    const inAll = (of) => sets.map((set) => recorded.answer(inSet(of, set)));
    const reaches = step.reaches?.(step.cases.flatMap(inAll));
    const stops = step.stops ?? step.cases?.map((of) => step.names(recorded.answer(of)));
    if (step.cases) input.max = input.value = stops.length - 1;
    // Below the slider; the words beside the control have them.
    const names = stops?.map((name) => `<span>${name}</span>`).join("");
    const row = `<span class="stops" aria-hidden="true">${names}</span>`;
    if (stops) input.insertAdjacentHTML("afterend", row);
    const goTo = (time_s) => {
      for (const stage of [shared, own]) stage.goTo(time_s);
      output.textContent = step.says(
        picture,
        corrected,
        stateAt(picture.motion, time_s),
        Number(input.value),
      );
      input.setAttribute("aria-valuetext", output.textContent);
    };
    const show = () => {
      const of = step.cases?.[Number(input.value)] ?? {};
      [picture, corrected] = inAll(of);
      part = step.part(picture, corrected);
      for (const stage of [shared, own]) stage.show(picture, corrected, step, part, reaches);
    };
    const film = () => {
      show();
      const begun_ms = performance.now(),
        mine = ++playing;
      const next = (now_ms) => {
        if (mine !== playing) return;
        const passed = is_calm.matches
          ? 1
          : Math.min(1, Math.max(0, (now_ms - begun_ms) / film_ms));
        const share = is_calm.matches && step.follows ? 0.5 : passed;
        if (step.follows) input.value = 100 * share;
        goTo(part[0] + share * (Math.min(part[1], picture.until_s) - part[0]));
        if (passed < 1) requestAnimationFrame(next);
      };
      next(begun_ms);
    };
    input.addEventListener("input", () => {
      if (step.cases) return film();
      ++playing; // stops a film
      if (step.follows) show();
      goTo(step.follows ? part[0] + (input.value / 100) * (part[1] - part[0]) : part[0]);
    });
    if (step.guesses) {
      const answer = () => {
        document.getElementById(step.guesses).open = true;
        film();
      };
      input.addEventListener("pointerup", answer);
      input.addEventListener("keydown", (event) => event.key === "Enter" && answer());
    }
    show();
    goTo(part[0] + (step.follows ? 0.5 : 1) * (Math.min(part[1], picture.until_s) - part[0]));
    seen.set(article, () => {
      for (const other of seen.keys()) other.classList.toggle("current", other === article);
      film();
    });
  }
  // The step that crosses the middle of the screen.
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) if (isIntersecting) seen.get(target)();
    },
    { rootMargin: "-45% 0px -54% 0px" },
  );
  for (const article of seen.keys()) observer.observe(article);
  seen.values().next().value();
}
