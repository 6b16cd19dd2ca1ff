// The interactive part of the page: a run, recorded or computed, as a rotor in its ring, curves and
// results.
import { Engine, isEmbedded } from "./engine.js";
import { OutcomeMap } from "./map.js";
import { climaxOf, inWords, stateAt } from "./motion.js";
import { numbersOf, sentence } from "./outcome.js";
import { Plots } from "./plots.js";
import { Recorded } from "./recorded.js";
import { RotorView } from "./rotor.js";
import { addressOf, commandOf, inSet, leftOutOf, setOf, sets, settingsIn } from "./settings.js";
import { showSteps } from "./steps.js";

const at = (id) => document.getElementById(id);
const { runs, maps, lines } = JSON.parse(at("instrument-data").textContent);
const recorded = new Recorded(runs);
const engine = isEmbedded() ? new Engine() : null;
document.body.classList.toggle("has-engine", engine !== null);

let options = settingsIn(location.hash);
let picture = null,
  others = [],
  playing = false,
  last_ms = null,
  time_s = 0;

// ---- pictures

const rotor = new RotorView(at("rotor"), at("rotor-state"));
const plots = new Plots(at("plots"), (to_s) => {
  play(false);
  goTo(to_s);
});
/// Shows settings, then the curves of the other equations beside them; replaces all earlier
/// requests.
async function refresh() {
  const asked_ms = performance.now(),
    mine = options;
  let off = false; // the map
  at("command").textContent = commandOf(options);
  for (const set of sets) at(set).checked = setOf(options) === set;
  for (const input of at("inputs").elements)
    if (input.name) {
      const asked = options[input.name] ?? input.defaultValue;
      input.value = asked;
      input.previousElementSibling.textContent = Number(
        (asked * (input.dataset.per ?? 1)).toPrecision(6),
      );
      off = off || Number(asked) !== Number(input.defaultValue);
    }
  document.body.classList.toggle("off-map", off);
  if (!picture) show(recorded.answer({}), {}); // a refused address leaves the paper's run
  // A run that lasts is announced, and the pictures do not match until it ends.
  const lasts = setTimeout(() => {
    at("status").textContent = "The engine computes …";
    document.body.classList.add("stale");
  }, 200);
  const answer =
    recorded.answer(mine) ??
    (engine
      ? await engine.ask(mine)
      : {
          refusal:
            "This page has no engine; make deps-explore explore embeds it. " +
            "Only the pins of the map are recorded.",
        });
  clearTimeout(lasts);
  if (answer === null) return;
  const leftOut = leftOutOf(location.hash);
  // Why the pictures do not match.
  at("status").textContent =
    answer.refusal ?? (leftOut.length ? `Not understood: ${leftOut.join(", ")}.` : "");
  document.body.classList.toggle("stale", Boolean(answer.refusal));
  if (answer.refusal) return;
  performance.measure("engine run", { start: asked_ms });
  show(answer, mine);
  document.body.dataset.shows = addressOf(mine); // for tests that wait for it
  requestAnimationFrame(() => performance.measure("input to picture", { start: asked_ms }));
  if (others.length > 0 || !engine) return;
  const other = await engine.ask(otherOf(mine));
  if (mine !== options || !other?.motion) return;
  others = [other];
  plots.show([picture, other], plots.part, time_s);
}

/// The same settings in the other equations.
const otherOf = (of) =>
  inSet(
    of,
    sets.find((set) => set !== setOf(of)),
  );

function show(answer, of) {
  const same_part =
    picture && picture.from_s === answer.from_s && picture.until_s === answer.until_s;
  const part = same_part ? plots.part : null;
  picture = answer;
  others = [recorded.answer(otherOf(of))].filter(Boolean);
  const { summary } = picture;
  if (!same_part) time_s = climaxOf(picture);
  at("outcome").textContent = sentence(summary);
  at("summary").textContent = JSON.stringify(summary, null, 2);
  at("numbers").innerHTML = numbersOf(summary)
    .map(([name, text]) => `<tr><th scope="row">${name}</th><td>${text}</td></tr>`)
    .join("");
  rotor.picture = picture;
  plots.show([picture, ...others], part ?? accident(), time_s);
  map.show({
    set: setOf(of),
    speed_Hz: summary.speed_at_mass_loss_Hz,
    friction: summary.inputs.friction,
  });
  goTo(time_s);
}

/// From just before the loss to some time after the largest force, in both sets of equations.
function accident() {
  const begin = picture.mass_loss_s,
    lasts = Math.max(0.01, ...[picture, ...others].map((run) => climaxOf(run) - begin));
  return [begin - 0.08 * lasts, begin + 1.25 * lasts];
}

function goTo(to_s) {
  time_s = Math.min(picture.until_s, Math.max(picture.from_s, to_s));
  plots.markNow(time_s);
  rotor.goTo(time_s);
  const slider = at("plots");
  slider.setAttribute("aria-valuenow", (1e3 * (time_s - picture.mass_loss_s)).toFixed(2));
  slider.setAttribute(
    "aria-valuetext",
    inWords(stateAt(picture.motion, time_s), picture.mass_loss_s),
  );
}

// ---- settings and the address

function use(wanted) {
  options = wanted;
  history.replaceState(null, "", addressOf(options));
  refresh();
}

window.addEventListener("hashchange", () => {
  if (at(location.hash.slice(1))) return openTarget();
  options = settingsIn(location.hash);
  refresh();
});
for (const set of sets) at(set).addEventListener("change", () => use(inSet(options, set)));
at("inputs").addEventListener("input", ({ target }) =>
  use({ ...options, [target.name]: target.value }),
);
at("paper").addEventListener("click", () => use({}));

// ---- the map

const pins = runs
  .filter(({ options: of }) => !of.equations)
  .map(({ options: of, summary }) => ({
    label:
      summary.inputs.friction === 0.3
        ? `${summary.speed_at_mass_loss_Hz.toFixed(0)} Hz`
        : `μ = ${summary.inputs.friction}`,
    speed_Hz: summary.speed_at_mass_loss_Hz,
    friction: summary.inputs.friction,
    options: of,
  }));
const map = new OutcomeMap(at("map"), {
  maps,
  lines,
  pins,
  onPick: (of) => {
    use(inSet(of, setOf(options)));
    at("try").scrollIntoView({
      behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth",
    });
    at("play").focus({ preventScroll: true });
  },
  onDrag:
    engine &&
    ((speed_Hz, friction) => {
      const { "mass-loss-time": time, ...others } = options;
      use({ ...others, friction: friction.toFixed(3), "mass-loss-speed-Hz": speed_Hz.toFixed(1) });
    }),
});

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
  if (!playing && time_s >= climaxOf(picture) - 1e-9) goTo(plots.part[0]);
  play(!playing);
});

at("zoom-in").addEventListener("click", () => plots.stretch(0.5));
at("zoom-out").addEventListener("click", () => plots.stretch(2));
at("show-accident").addEventListener("click", () => plots.showPart(...accident()));

map.showKey(at("map-key"));

// The tabulator stops once at many numbers; arrow keys move on from there.
for (const group of document.querySelectorAll(".claims-picture, #claims .scroll")) {
  const rows = [...group.querySelectorAll("a, summary")];
  for (const row of rows) row.tabIndex = -1;
  group.addEventListener("keydown", (event) => {
    const shown = rows.filter((row) => row.checkVisibility()),
      step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    (shown[shown.indexOf(event.target) + step] ?? group).focus();
  });
}

// A phone shows the names of figures first; a link opens its target, and whatever that is in.
for (const card of document.querySelectorAll(".card"))
  if (matchMedia("(max-width: 40rem)").matches) card.open = false;
  else card.firstElementChild.tabIndex = -1;
function openTarget() {
  const target = at(location.hash.slice(1));
  const inside =
    target?.querySelector(".card") ?? target?.closest(".number")?.querySelector("details");
  if (inside) inside.open = true;
  for (let part = target?.closest("details"); part; part = part.parentElement.closest("details"))
    part.open = true;
  if (inside || target?.closest("details")) target.scrollIntoView();
}

// Rows of claims with what is searched for, and the headings above them.
at("find").addEventListener("input", ({ target }) => {
  const text = target.value.toLowerCase();
  for (const row of document.querySelectorAll(".number"))
    row.hidden = !row.textContent.toLowerCase().includes(text);
  for (const passage of document.querySelectorAll(".claims tbody"))
    passage.hidden = !passage.querySelector(".number:not([hidden])");
});

openTarget();

showSteps(recorded);
refresh();
