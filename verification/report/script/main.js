// The interactive part of the page: a run, recorded or computed, as a rotor in its ring, curves and a story.
import { onColoursChanged } from "./colours.js";
import { Engine, isEmbedded } from "./engine.js";
import { Knobs } from "./knobs.js";
import { OutcomeMap, outcomes } from "./map.js";
import { inWords, stateAt } from "./motion.js";
import { Orbit } from "./orbit.js";
import { sentence, showEvents, showNumbers } from "./outcome.js";
import { Plots } from "./plots.js";
import { Recorded } from "./recorded.js";
import { RotorView } from "./rotor.js";
import { addressOf, commandOf, corrections, inSet, placeIn, setOf, settingsIn } from "./settings.js";
import { showSteps } from "./steps.js";
import { storyOf } from "./story.js";
import { Sureness } from "./sureness.js";

const at = (id) => document.getElementById(id);
const { runs, maps, knobs: groups } = JSON.parse(at("instrument-data").textContent);
const recorded = new Recorded(runs);
const has_engine = isEmbedded();
document.body.classList.toggle("has-engine", has_engine);

/// The settings in the address, unless it names a part of the page.
const stated = () => (at(location.hash.slice(1)) ? [{}, {}] : settingsIn(location.hash));
let [options, view] = stated();
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
const background = has_engine && new Engine(); // for work in the background

// ---- pictures

const rotor = new RotorView(at("rotor"), at("rotor-state"));
const orbit = new Orbit(at("orbit"));
const plots = new Plots(at("plots"), {
  onTime: (to_s) => { play(false); goTo(to_s); keepView(); },
  onPart: (from_s, until_s) => {
    const [from, until] = accident(), near = 1e-6;
    plots.zoomed = until_s - from_s < Math.min(until, picture.until_s) - Math.max(from, picture.from_s) - near;
    orbit.showPart(from_s, until_s);
    keepView();
  },
});
const sureness = has_engine && new Sureness(at("sureness"), (draws) => plots.showBehind(draws.map((drawn) =>
  ({ picture: drawn, later_s: drawn.mass_loss_s && picture.mass_loss_s ? drawn.mass_loss_s - picture.mass_loss_s : 0 }))));

/// Shows settings; replaces all earlier requests.
async function refresh() {
  const asked_ms = performance.now(), mine = options;
  at("command").textContent = commandOf(options);
  showSwitches();
  knobs?.show(options, "");
  if (sureness) sureness.forget();
  const answer = recorded.answer(options) ?? (engine ? await engine.ask({ kind: "run", options })
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
  if (at("sure").getAttribute("aria-pressed") === "true") sureness.ask(mine);
}

function show(answer) {
  const same_part = picture && picture.from_s === answer.from_s && picture.until_s === answer.until_s;
  const part = same_part ? plots.part : null;
  picture = answer;
  story = storyOf(picture);
  const place = placeIn(view, picture);
  time_s = place.time_s ?? (same_part ? time_s : story.at(-1).time_s);
  at("outcome").textContent = sentence(picture.summary);
  at("summary").textContent = JSON.stringify(picture.summary, null, 2);
  showEvents(at("events"), picture.events);
  showNumbers(at("numbers"), picture.summary);
  showStory();
  say("");
  orbit.show(picture, time_s);
  rotor.show(picture, time_s);
  plots.show(picture, place.part ?? part ?? accident(), time_s);
  view = { frame: view.frame, zoom: view.zoom };
  map.show({ set: setOf(options) ?? "published", speed_Hz: picture.summary.speed_at_mass_loss_Hz ?? picture.summary.final_speed_Hz,
    friction: picture.summary.inputs.friction });
  goTo(time_s);
  keepView();
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
  for (const seen of [rotor, orbit]) seen.goTo(time_s);
  const now = story.findLastIndex((moment) => moment.time_s <= time_s + 1e-6); // an address is rounded
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
    button.addEventListener("click", () => { play(false); goTo(when_s); keepView(); });
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
  history.replaceState(null, "", addressOf(options)); // the view is added with the pictures
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
  [options, view] = settingsIn(link.hash);
  showFrame();
  refresh();
  bringIntoView();
});

let keeping = 0;
function keepView() {
  clearTimeout(keeping);
  if (picture) keeping = setTimeout(() => history.replaceState(null, "", address()), 150);
}
function address() {
  const ms = (when_s) => (1e3 * (when_s - (picture.mass_loss_s ?? 0))).toFixed(3), [from, until] = plots.part;
  return addressOf(options, { at: ms(time_s), from: ms(from), until: ms(until), frame: at("frame").value, zoom: orbit.zoom.toFixed(2) });
}
window.addEventListener("hashchange", () => {
  if (at(location.hash.slice(1))) return;
  [options, view] = stated();
  showFrame();
  refresh();
});

const switches = [["velocity-jump", "once"], ["gravity-moment", "balanced"], ["no-mass-loss", ""]];
function showSwitches() {
  for (const [option, text] of switches) at(option).checked = corrections(options)[option] === text;
  for (const set of ["published", "consistent"]) at(set).checked = setOf(options) === set;
  for (const pick of document.querySelectorAll("a.moment")) pick.hidden = !has_engine && !recorded.has(settingsIn(pick.hash)[0]);
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

// ---- playing, frame, zoom

function play(on) {
  playing = on;
  last_ms = null;
  at("play").textContent = on ? "Pause" : "Play";
  if (on) requestAnimationFrame(step);
  else keepView();
}
function step(now_ms) {
  if (!playing) return;
  const passed_s = last_ms === null ? 0 : Math.min((now_ms - last_ms) / 1e3, 0.1);
  last_ms = now_ms;
  const next_s = time_s + passed_s / Number(at("slowness").value);
  if (next_s > plots.part[1]) return play(false);
  goTo(next_s);
  requestAnimationFrame(step);
}
at("play").addEventListener("click", () => {
  if (!playing && time_s >= story.at(-1).time_s - 1e-9) goTo(plots.part[0]);
  play(!playing);
});

function showFrame() {
  if (view.frame) at("frame").value = view.frame;
  if (view.zoom) orbit.zoom = view.zoom;
  const is_orbit = at("frame").value !== "ring";
  at("rotor").hidden = is_orbit;
  at("orbit").hidden = !is_orbit;
  orbit.frame = at("frame").value === "rotating" ? "rotating" : "stator";
  rotor.paint();
}
at("frame").addEventListener("change", () => { view = {}; showFrame(); keepView(); });

const views = {
  "zoom-in": () => plots.stretch(0.5), "zoom-out": () => plots.stretch(2),
  "show-all": () => plots.showPart(picture.from_s, picture.until_s), "show-accident": () => plots.showPart(...accident()),
};
for (const [id, act] of Object.entries(views)) at(id).addEventListener("click", act);

// ---- saving a run

function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
at("save-picture").addEventListener("click", () => {
  const [scene, curves] = [at(at("rotor").hidden ? "orbit" : "rotor"), at("plots")];
  const both = document.createElement("canvas"), ctx = both.getContext("2d");
  both.width = scene.width + curves.width;
  both.height = Math.max(scene.height, curves.height);
  ctx.fillStyle = getComputedStyle(document.body).backgroundColor;
  ctx.fillRect(0, 0, both.width, both.height);
  ctx.drawImage(scene, 0, 0);
  ctx.drawImage(curves, scene.width, 0);
  both.toBlob((blob) => download(blob, "accident.png"));
});
at("copy-link").addEventListener("click", async () => {
  history.replaceState(null, "", address());
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link has been copied to the clipboard.");
  } catch { // a browser may refuse
    say("The link is in the address bar.");
  }
});
at("save").addEventListener("click", async () => {
  const { csv, refusal } = (await background.ask({ kind: "trace", options })) ?? {};
  if (refusal) say(refusal, "refused");
  if (csv) download(new Blob([csv], { type: "text/csv" }), "trace.csv");
});
at("sure").addEventListener("click", () => {
  const on = at("sure").getAttribute("aria-pressed") !== "true";
  at("sure").setAttribute("aria-pressed", String(on));
  if (on && picture) sureness.ask(options);
  else sureness.forget();
});

const cells = Object.values(maps).flatMap((of) => of.cells).join("");
at("map-key").replaceChildren(...Object.entries(outcomes).filter(([letter]) => cells.includes(letter)).map(([letter, name]) => {
  const item = document.createElement("li");
  item.className = `outcome-${letter === "-" ? "none" : letter}`;
  item.textContent = name;
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
  for (const seen of [plots, orbit, rotor, map]) seen.paint();
});
showSteps(recorded);
showFrame();
refresh();
