// The interactive part of the page: a run, recorded or computed, as a rotor in its ring, curves and a story.
import { onColoursChanged } from "./colours.js";
import { Engine, isEmbedded } from "./engine.js";
import { Knobs } from "./knobs.js";
import { letters, OutcomeMap } from "./map.js";
import { inWords, stateAt } from "./motion.js";
import { sentence, showNumbers } from "./outcome.js";
import { Plots } from "./plots.js";
import { Recorded } from "./recorded.js";
import { RotorView } from "./rotor.js";
import { addressOf, commandOf, corrections, inSet, setOf, settingsIn } from "./settings.js";
import { showSteps } from "./steps.js";
import { storyOf } from "./story.js";

const at = (id) => document.getElementById(id);
const { runs, maps, knobs: groups } = JSON.parse(at("instrument-data").textContent);
const recorded = new Recorded(runs);
const has_engine = isEmbedded();
document.body.classList.toggle("has-engine", has_engine);

/// The settings in the address, unless it names a part of the page.
const stated = () => (at(location.hash.slice(1)) ? {} : settingsIn(location.hash));
let options = stated();
let picture = null, story = [], knobs = null, playing = false, last_ms = null, time_s = 0;

const engine = has_engine && new Engine({
  onProgress: (at_s, { until }) => say(`The run has reached ${at_s.toFixed(2)} s${until ? ` of ${until} s` : ""} …`, "busy"),
  onFailure: (reason) => say(`This browser cannot run the engine: ${reason}`, "refused"),
  onNumbers: (numbers) => {
    if (knobs) return; // from a worker that was restarted
    knobs = new Knobs(at("knobs"), groups, numbers, turn);
    knobs.show(options, "");
  },
});

// ---- pictures

const rotor = new RotorView(at("rotor"), at("rotor-state"));
const plots = new Plots(at("plots"), (to_s) => { play(false); goTo(to_s); });
/// Shows settings; replaces all earlier requests.
async function refresh() {
  const asked_ms = performance.now(), mine = options;
  at("command").textContent = commandOf(options);
  showSwitches();
  knobs?.show(options, "");
  const answer = recorded.answer(options) ?? (engine ? await engine.ask(options)
    : { refusal: "This page has no engine; make deps-explore explore embeds it. Only the pins of the map are recorded." });
  if (answer === null) return;
  if (answer.refusal) {
    say(answer.refusal, "refused");
    knobs?.show(mine, answer.refusal);
    return;
  }
  performance.measure("engine run", { start: asked_ms });
  show(answer);
  document.body.dataset.shows = addressOf(mine); // for tests that wait for it
  requestAnimationFrame(() => performance.measure("input to picture", { start: asked_ms }));
}

function show(answer) {
  const same_part = picture && picture.from_s === answer.from_s && picture.until_s === answer.until_s;
  const part = same_part ? plots.part : null;
  picture = answer;
  story = storyOf(picture);
  if (!same_part) time_s = story.at(-1).time_s;
  at("outcome").textContent = sentence(picture.summary);
  at("summary").textContent = JSON.stringify(picture.summary, null, 2);
  showNumbers(at("numbers"), picture.summary);
  showStory();
  say("");
  rotor.show(picture, time_s);
  plots.show(picture, part ?? accident(), time_s);
  map.show({ set: setOf(options) ?? "published", speed_Hz: picture.summary.speed_at_mass_loss_Hz ?? picture.summary.final_speed_Hz,
    friction: picture.summary.inputs.friction });
  goTo(time_s);
}

/// From just before the loss to some time after the last moment of the story.
function accident() {
  const [begin, end] = [picture.mass_loss_s ?? picture.from_s, story.at(-1).time_s];
  const lasts = Math.max(end - begin, 0.01);
  return [begin - 0.08 * lasts, end + 0.25 * lasts];
}

function goTo(to_s) {
  time_s = Math.min(picture.until_s, Math.max(picture.from_s, to_s));
  plots.markNow(time_s);
  rotor.goTo(time_s);
  const now = story.findLastIndex((moment) => moment.time_s <= time_s);
  [...at("story").children].forEach((item, n) => item.firstElementChild.setAttribute("aria-current", n === now ? "step" : "false"));
  const slider = at("plots");
  slider.setAttribute("aria-valuenow", (1e3 * (time_s - (picture.mass_loss_s ?? 0))).toFixed(2));
  slider.setAttribute("aria-valuetext", inWords(stateAt(picture.motion, time_s), picture.mass_loss_s));
}

function showStory() {
  at("story").replaceChildren(...story.map(({ time_s: when_s, title, text }) => {
    const item = document.createElement("li"), button = document.createElement("button"), strong = document.createElement("strong");
    button.type = "button";
    strong.textContent = title;
    button.append(strong, " ", text);
    button.addEventListener("click", () => { play(false); goTo(when_s); });
    item.append(button);
    return item;
  }));
}

/// `why`: the reason why the pictures do not match the settings, busy or refused.
function say(text, why = "") {
  at("status").textContent = text;
  at("status").classList.toggle("refusal", why === "refused");
  document.body.classList.toggle("stale", why !== "");
}

// ---- settings and the address

function use(wanted) {
  options = wanted;
  history.replaceState(null, "", addressOf(options));
  refresh();
}

/// States an option by its text, or removes it; another option for the same quantity is removed.
function turn(option, text, insteadOf) {
  const { [option]: before, ...others } = options;
  if (text !== null && insteadOf) delete others[insteadOf];
  if (text !== null && option === "mass-loss-time") delete others["mass-loss-speed-hz"];
  use(text === null ? others : { ...others, [option]: text });
}

function bringIntoView() {
  const is_calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  at("try").scrollIntoView({ behavior: is_calm ? "auto" : "smooth" });
  at("play").focus({ preventScroll: true });
}
document.addEventListener("click", (event) => {
  const link = event.target.closest("a.moment");
  if (!link) return;
  event.preventDefault(); // the address may be that of the run which is shown
  history.pushState(null, "", link.hash);
  options = settingsIn(link.hash);
  refresh();
  bringIntoView();
});

window.addEventListener("hashchange", () => {
  if (at(location.hash.slice(1))) return;
  options = stated();
  refresh();
});

const switches = [["velocity-jump", "once"], ["gravity-moment", "balanced"], ["no-mass-loss", ""]];
function showSwitches() {
  for (const [option, text] of switches) at(option).checked = corrections(options)[option] === text;
  for (const set of ["published", "consistent"]) at(set).checked = setOf(options) === set;
  for (const pick of document.querySelectorAll("a.moment")) pick.hidden = !has_engine && !recorded.has(settingsIn(pick.hash));
}
for (const set of ["published", "consistent"]) at(set).addEventListener("change", () => use(inSet(options, set)));
for (const [option, text] of switches)
  at(option).addEventListener("change", () => {
    const { [option]: before, ...others } = corrections(options);
    if (at(option).checked && option === "no-mass-loss") {
      delete others["mass-loss-time"];
      delete others["mass-loss-speed-hz"];
      others.until ??= String(picture?.until_s ?? 10);
    }
    use(at(option).checked ? { ...others, [option]: text } : others);
  });
at("paper").addEventListener("click", () => use({}));

// ---- the map

const pins = runs.filter(({ options: of }) => !of.equations).map(({ options: of, summary }) => ({
  label: summary.inputs.friction === 0.3 ? `${summary.speed_at_mass_loss_Hz.toFixed(0)} Hz` : `μ = ${summary.inputs.friction}`,
  speed_Hz: summary.speed_at_mass_loss_Hz, friction: summary.inputs.friction, options: of }));
const map = new OutcomeMap(at("map"), { maps, pins,
  onPick: (of) => {
    use(inSet(of, setOf(options) ?? "published"));
    bringIntoView();
  },
  onDrag: engine && ((speed_Hz, friction) => {
    const { "mass-loss-time": time, "mass-loss-speed-hz": speed, "no-mass-loss": none, from, until, ...others } = options;
    use({ ...others, friction: friction.toFixed(3), "mass-loss-speed-hz": speed_Hz.toFixed(1) });
  }) });

// ---- playing, zoom

const slowness = 1000; // times as slow as the accident
function play(on) {
  playing = on;
  last_ms = null;
  at("play").textContent = on ? "Pause" : "Play";
  if (on) requestAnimationFrame(step);
}
function step(now_ms) {
  if (!playing) return;
  const passed_s = last_ms === null ? 0 : Math.min((now_ms - last_ms) / 1e3, 0.1);
  last_ms = now_ms;
  const next_s = time_s + passed_s / slowness;
  if (next_s > plots.part[1]) return play(false);
  goTo(next_s);
  requestAnimationFrame(step);
}
at("play").addEventListener("click", () => {
  if (!playing && time_s >= story.at(-1).time_s - 1e-9) goTo(plots.part[0]);
  play(!playing);
});

const views = {
  "zoom-in": () => plots.stretch(0.5), "zoom-out": () => plots.stretch(2),
  "show-all": () => plots.showPart(picture.from_s, picture.until_s), "show-accident": () => plots.showPart(...accident()),
};
for (const [id, act] of Object.entries(views)) at(id).addEventListener("click", act);

const cells = Object.values(maps).flatMap((of) => of.cells).join("");
at("map-key").replaceChildren(...Object.entries(letters).filter(([letter]) => cells.includes(letter)).map(([, name]) => {
  const item = document.createElement("li");
  item.style.setProperty("--of", `var(--${name})`);
  item.textContent = name.replace("_", " ") + (name === "stalled" ? ", or no result" : "");
  return item;
}));
// A phone shows counts of claims and names of figures first; what a reader opens survives a reload, and a
// link opens whatever its target is in.
const is_phone = matchMedia("(max-width: 48rem)").matches;
document.querySelectorAll(".card, .group").forEach((folded, n) => {
  const kept = sessionStorage.getItem(n);
  folded.open = kept ? kept === "open" : folded.open && !is_phone;
  folded.firstElementChild.addEventListener("click", () => sessionStorage.setItem(n, folded.open ? "closed" : "open"));
});
function openTarget() {
  const target = at(location.hash.slice(1));
  const card = target?.querySelector(".card");
  if (card) card.open = true;
  for (let part = target?.closest("details"); part; part = part.parentElement.closest("details")) part.open = true;
  if (card || target?.closest("details")) target.scrollIntoView();
}
window.addEventListener("hashchange", openTarget);
openTarget();

onColoursChanged(() => {
  for (const seen of [plots, rotor, map]) seen.paint();
});
showSteps(recorded);
refresh();
