// The page: from a knob that is turned to the pictures of the run.
import figures from "figures";

import { onColoursChanged } from "./colours.js";
import { Engine } from "./engine.js";
import { Knobs } from "./knobs.js";
import { Orbit } from "./orbit.js";
import { sentence, showEvents, showNumbers } from "./outcome.js";
import { Plots } from "./plots.js";
import { RotorView } from "./rotor.js";
import { addressOf, commandOf, settingsIn } from "./settings.js";
import { Sureness } from "./sureness.js";

const at = (id) => document.getElementById(id);

let [options, comparedOptions = null] = settingsIn(location.hash);
let picture = null, compared = null, drawn = [];
let knobs = null;

const engine = new Engine({
  onProgress: (time_s, { until }) =>
    say(`The run has got to ${time_s.toFixed(2)} s${until ? ` of ${until} s` : ""} …`, "busy"),
  onFailure: (reason) => say(`This browser cannot run the engine: ${reason}`, "refused"),
  onNumbers: (numbers) => {
    if (knobs) return; // of a worker that had to be started again
    knobs = new Knobs(at("knobs"), numbers, turn);
    refresh();
    if (comparedOptions) compare(comparedOptions);
  },
});
const background = new Engine(); // for what nobody waits for

const plots = new Plots(at("plots"), (from_s, until_s) => {
  orbit.showPart(from_s, until_s);
  rotor.showPart(from_s, until_s);
});
const orbit = new Orbit(at("orbit"));
const rotor = new RotorView(at("rotor"), at("rotor-state"), (time_s) => plots.markNow(time_s));
const sureness = new Sureness(at("sureness"), (curves) => {
  drawn = curves;
  showBehind();
});

// ---- settings

/// States an option by its text, or takes it back; what it stands for cannot be stated beside it.
function turn(option, text, insteadOf) {
  const { [option]: before, ...others } = options;
  if (text !== null && insteadOf) delete others[insteadOf];
  if (text !== null && option === "mass-loss-time") delete others["mass-loss-speed-hz"];
  options = text === null ? others : { ...others, [option]: text };
  refresh();
}

function use(stated) {
  options = stated;
  refresh();
}

/// Whatever was asked before: this is what is wanted now.
async function refresh() {
  const asked_ms = performance.now();
  history.replaceState(null, "", addressOf(options, ...(comparedOptions ? [comparedOptions] : [])));
  at("command").textContent = commandOf(options);
  showSwitches();
  knobs.show(options, "");
  sureness.forget();
  const mine = options;
  const answer = await engine.ask({ kind: "run", options });
  if (answer === null) return;
  if (answer.refusal) {
    say(answer.refusal, "refused");
    knobs.show(mine, answer.refusal);
    return;
  }
  show(answer);
  document.body.dataset.shows = addressOf(mine); // for who waits for it
  requestAnimationFrame(() => performance.measure("input to picture", { start: asked_ms }));
  if (at("sure").getAttribute("aria-pressed") === "true") sureness.ask(mine);
}

// ---- pictures

function show(answer) {
  const kept = plots.part[0] !== null && picture.from_s === answer.from_s && picture.until_s === answer.until_s;
  picture = answer;
  const { inputs } = picture.summary;
  const radius_m = inputs.rotor_radius, clearance_m = inputs.stator_radius - radius_m;
  say("");
  at("outcome").textContent = sentence(picture.summary);
  at("summary").textContent = JSON.stringify(picture.summary, null, 2);
  showEvents(at("events"), picture.events);
  showTable();
  plots.show(picture, kept);
  showBehind();
  orbit.show(picture, clearance_m);
  rotor.show(picture, { clearance_m, radius_m });
  document.body.classList.add("ready");
}

function showTable() {
  at("compared-head").hidden = compared === null;
  showNumbers(at("numbers"), [picture, compared].filter(Boolean).map(({ summary }) => summary));
}

/// Each is shifted so that its mass loss meets that of the picture.
function showBehind() {
  const shifted = (other, colour) => ({ picture: other, colour,
    later_s: other.mass_loss_s && picture.mass_loss_s ? other.mass_loss_s - picture.mass_loss_s : 0 });
  const all = drawn.map((draw) => shifted(draw, "draw"));
  if (compared && picture) all.push(shifted(compared, "compared"));
  plots.showBehind(all);
  orbit.showBehind(compared && picture ? all.at(-1) : null);
}

/// `why` the pictures are not those of the setting, if they are not: busy or refused.
function say(text, why = "") {
  mention(text, why === "refused");
  document.body.classList.toggle("stale", why !== "");
}

/// What says nothing of the pictures.
function mention(text, isRefusal = false) {
  at("status").textContent = text;
  at("status").classList.toggle("refusal", isRefusal);
}

// ---- another setting to compare with

async function compare(stated) {
  comparedOptions = stated;
  compared = null;
  if (stated) {
    const answer = await background.ask({ kind: "run", options: stated });
    if (comparedOptions !== stated) return; // there is another one by now
    if (answer === null || answer.refusal) comparedOptions = null;
    else compared = answer;
  }
  at("swap").disabled = at("alone").disabled = compared === null;
  at("compared-command").textContent = compared ? commandOf(comparedOptions) : "";
  history.replaceState(null, "", addressOf(options, ...(comparedOptions ? [comparedOptions] : [])));
  showBehind();
  if (picture) showTable();
}

at("keep").addEventListener("click", () => compare(options));
at("alone").addEventListener("click", () => compare(null));
at("swap").addEventListener("click", () => {
  const other = options;
  use(comparedOptions);
  compare(other);
});

// ---- the published figures

for (const { number, title, runs } of figures) {
  const group = document.createElement("optgroup");
  group.label = `Fig. ${number}: ${title}`;
  for (const { name, options: stated } of runs) {
    const choice = new Option(runs.length > 1 ? `Fig. ${number}, ${name}` : `Fig. ${number}`);
    choice.value = addressOf(stated);
    group.append(choice);
  }
  at("figure").append(group);
}
at("figure").addEventListener("change", () => use(settingsIn(at("figure").value)[0]));
at("paper").addEventListener("click", () => use({}));

// ---- switches: each correction of the equations, and whether mass is lost

const switches = [
  ["velocity-jump", "once"],
  ["gravity-moment", "balanced"],
  ["no-mass-loss", ""],
];

/// The two corrections by their own names, whichever name they had together.
function corrections() {
  const { equations, ...others } = options;
  return equations === "consistent"
    ? { "velocity-jump": "once", "gravity-moment": "balanced", ...others }
    : others;
}

function showSwitches() {
  const stated = corrections();
  for (const [option, text] of switches) at(option).checked = stated[option] === text;
}

for (const [option, text] of switches)
  at(option).addEventListener("change", () => {
    const { [option]: before, ...others } = corrections();
    if (at(option).checked && option === "no-mass-loss") {
      delete others["mass-loss-time"];
      delete others["mass-loss-speed-hz"];
      others.until ??= String(picture?.until_s ?? 10);
    }
    use(at(option).checked ? { ...others, [option]: text } : others);
  });

// ---- what is done with a run

at("copy").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText(commandOf(options));
    mention("The command is in the clipboard.");
  } catch { // which a browser may refuse
    getSelection().selectAllChildren(at("command"));
    mention("The command is selected below: copy it.");
  }
});
at("save").addEventListener("click", async () => {
  const { csv, refusal } = (await background.ask({ kind: "trace", options })) ?? {};
  if (refusal) say(refusal, "refused");
  if (!csv) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([csv], { type: "text/csv" }));
  link.download = "trace.csv";
  link.click();
  URL.revokeObjectURL(link.href);
});
at("sure").addEventListener("click", () => {
  const on = at("sure").getAttribute("aria-pressed") !== "true";
  at("sure").setAttribute("aria-pressed", String(on));
  if (on && picture) sureness.ask(options);
  else sureness.forget();
});

// ---- the part of the time that is shown

function stretch(factor, shift = 0) {
  const [from, until] = plots.part;
  const middle = (from + until) / 2 + shift * (until - from), half = (factor * (until - from)) / 2;
  plots.showPart(middle - half, middle + half);
}
const views = {
  "zoom-in": () => stretch(0.5),
  "zoom-out": () => stretch(2),
  earlier: () => stretch(1, -0.25),
  later: () => stretch(1, 0.25),
  "show-all": () => plots.showPart(picture.from_s, picture.until_s),
  "show-contact": () => around(picture.summary.first_contact_s),
  "show-rolling": () => around(picture.summary.rolling_onset_s),
};
function around(time_s) {
  if (time_s !== null) plots.showPart(time_s - 0.002, time_s + 0.004);
}
for (const [id, act] of Object.entries(views)) at(id).addEventListener("click", () => picture && act());

// ---- orbit and rotor

at("frame").addEventListener("change", () => orbit.showFrame(at("frame").value));
at("orbit-in").addEventListener("click", () => orbit.zoom(1.5));
at("orbit-out").addEventListener("click", () => orbit.zoom(1 / 1.5));
at("orbit-fit").addEventListener("click", () => orbit.fit());
at("slowness").addEventListener("change", () => (rotor.slowness = Number(at("slowness").value)));
at("play").addEventListener("click", () => play(!rotor.playing));

function play(on) {
  rotor.playing = on;
  at("play").textContent = on ? "Pause" : "Play";
}

play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
onColoursChanged(() => {
  plots.recolour();
  orbit.draw();
});
window.addEventListener("hashchange", () => {
  const [stated, other = null] = settingsIn(location.hash);
  compare(other);
  use(stated);
});
