// What `make check-explore` does: turns the knobs of the page in a browser without a screen, and holds
// what it shows against the program: node explore.mjs PAGE ROTOR NPM CHROMIUM, where NPM has
// node_modules.
import { execFileSync, spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

import { outcomes } from "../../figures/explore/page/outcome.js";
import { commandOf, settingsIn } from "../../figures/explore/page/settings.js";

const [page_file, rotor, npm, executablePath] = process.argv.slice(2).map((name) => path.resolve(name));
const require = createRequire(path.join(npm, "package.json"));
const { chromium } = require("playwright-core");

let failures = 0;
function expect(holds, what) {
  if (holds) return;
  ++failures;
  console.error(`FAILED: ${what}`);
}
const say = (text) => console.log(text);

const browser = await chromium.launch({
  executablePath,
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--disable-background-networking"],
});
const context = await browser.newContext({ viewport: { width: 1400, height: 1000 }, reducedMotion: "reduce" });
const page = await context.newPage();
page.on("console", (message) => expect(message.type() !== "error", `console: ${message.text()}`));
page.on("pageerror", (error) => expect(false, `error on the page: ${error.stack}`));
page.on("request", (request) =>
  expect(/^(file|blob|data):/.test(request.url()), `the page asks the network for ${request.url()}`));

// Whatever an address says, the command is that of one program, in plain words.
for (const hash of ["#friction=0.2&x%3Btouch%20p%3B%23=1", "#friction=0.2%3Btouch%20p", "#%24(touch p)=&until=1`p`",
  "#until=29.2%0Atouch%20p%0A&a%0Ap=1", "#friction='&until='", "#--=%1b[2J&\u202e=1"])
  expect(/^build\/rotor run( --[a-z-]+ [\w.+-]+)* --energy --json$/.test(commandOf(settingsIn(hash)[0])),
    `the command of ${hash} is ${commandOf(settingsIn(hash)[0])}`);

const address = pathToFileURL(page_file).href;
const text = (id) => page.textContent(`#${id}`);
/// Until the pictures are those of the setting that the address states.
const shown = (timeout = 60_000) => page.waitForFunction(
  () => document.body.dataset.shows === location.hash.split("/")[0].replace(/^#?/, "#"), null, { timeout });
const summary = async () => JSON.parse(await text("summary"));
async function set(options) {
  const hash = "#" + new URLSearchParams(options);
  await page.evaluate((to) => {
    if (location.hash.replace(/^#?/, "#") === to) return;
    delete document.body.dataset.shows;
    location.hash = to;
  }, hash);
  await page.waitForFunction((to) => document.body.dataset.shows === to, hash, { timeout: 60_000 });
}

const argumentsOf = (options) =>
  Object.entries(options).flatMap(([option, value]) => (value === "" ? [`--${option}`] : [`--${option}`, value]));
const native = (options) => JSON.parse(execFileSync(rotor,
  ["run", "--energy", "--json", ...argumentsOf(options)], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));

// ---- the numbers

/// Every number of a summary by the path to it; what a run has cost is none of them.
const costs = ["right_hand_sides", "contact_evaluations", "steps", "located_events"];
function leaves(json, name = "") {
  if (json === null || typeof json !== "object") return [[name, json]];
  return Object.entries(json).filter(([key]) => !costs.includes(key))
    .flatMap(([key, value]) => leaves(value, `${name}/${key}`));
}

/// Two programs whose sines differ in the last digit, 1e-16, which contacts multiply by up to 1e7; energies
/// are differences of what the rotor has.
function compare(options, seen) {
  const expected = native(options), ours = Object.fromEntries(leaves(seen));
  const { initial, kinetic } = expected.energy_J.until_end;
  for (const [name, value] of leaves(expected)) {
    const scale = name.startsWith("/energy_J") ? Math.max(initial, kinetic) : Math.abs(value);
    expect(typeof value === "number" ? Math.abs(ours[name] - value) <= 1e-8 * scale : ours[name] === value,
      `${JSON.stringify(options)}: ${name} is ${ours[name]}, not ${value}`);
    delete ours[name];
  }
  expect(Object.keys(ours).length === 0, `new on the page: ${Object.keys(ours)}`);
}

const settings = [
  {},
  { friction: "0.2", equations: "consistent" },
  { friction: "0.15", "mass-loss-time": "20" },
  { "mass-loss-speed-hz": "75" },
  { "no-mass-loss": "", until: "6.5" },
  { clearance: "0.001", friction: "0.1", until: "29.2" },
  { "unbalance-factor": "4", torque: "0.5" },
];

async function checkNumbers() {
  for (const options of settings) {
    await set(options);
    compare(options, await summary());
  }
}

/// The outcomes of draws over the rounding of the inputs are all that there are.
async function checkShares() {
  await set({ friction: "0.08" });
  await page.click("#sure");
  await page.waitForFunction(() => document.querySelectorAll("#sureness p").length > 1, null, { timeout: 120_000 });
  const told = await text("sureness");
  await page.click("#sure");
  const count = Object.values(outcomes)
    .map((words) => Number(told.match(new RegExp(`In (\\d+) of 30 draws the rotor ${words}\\.`))?.[1] ?? 0))
    .reduce((one, other) => one + other);
  expect(count === 30, `the draws have ${count} outcomes, not 30`);
  for (const what of ["Largest normal force", "Touch-downs"]) {
    const [least, greatest, median] = told.match(new RegExp(`${what}: (\\S+)(?: kN)? … (\\S+)(?: kN)?, median ([\\d.]*\\d)`))
      ?.slice(1).map(Number) ?? [];
    expect(least <= median && median <= greatest, `${what} from ${least} to ${greatest}, median ${median}`);
  }
}

// ---- the pictures

/// To be called before the page is there: notes what its canvases are given, by their names.
const noteDrawing = (page) => page.addInitScript(() => {
  window.drawn = {};
  const of = (context) => (window.drawn[context.canvas.id] ??= { lines: [], texts: [] });
  const { lineTo, fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.lineTo = function (x, y) {
    of(this).lines.push([x, y]);
    return lineTo.call(this, x, y);
  };
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    of(this).texts.push(text);
    return fillText.call(this, text, ...place);
  };
});

/// The columns of the trace of a run, by their names.
function traceOf(options, from_s) {
  const text = execFileSync(rotor, ["run", ...options, "--from", String(from_s), "--trace", "-"],
    { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 });
  const [head, ...rows] = text.split("\n").filter((line) => line && !line.startsWith("#"))
    .map((line) => line.split(","));
  return Object.fromEntries(head.map((name, i) => [name, rows.map((row) => Number(row[i]))]));
}

const least = (column) => column.reduce((one, other) => Math.min(one, other));
const greatest = (column) => column.reduce((one, other) => Math.max(one, other));
const about = (value, expected, scale, what) =>
  expect(Math.abs(value - expected) <= 1e-3 * scale, `${what} is ${value}, not ${expected}`);

/// Curves, as their ranges are told to those who do not see them, and the orbit, against the program's trace.
async function checkDrawing() {
  await set({ friction: "0.2", until: "29.2" });
  await page.waitForTimeout(300);
  const told = (id) => page.textContent(`#${id} .unseen`);
  const [, from_s] = (await told("force")).match(/^Between (\S+) and/);
  const trace = traceOf(["--friction", "0.2", "--until", "29.2"], from_s);
  for (const [id, label, column, factor, unit] of [
    ["force", "F_n", "normal_force_N", 1e-3, "kN"], ["speed", "f", "speed_Hz", 1, "Hz"],
    ["displacement", "rho", "rho_m", 1e3, "mm"], ["displacement", "q1", "q1_m", 1e3, "mm"],
    ["energy", "kinetic", "kinetic_energy_J", 1, "J"], ["energy", "in the ring", "contact_energy_J", 1, "J"]]) {
    const words = await told(id);
    const [, from, to, its] = words.match(new RegExp(`(?:: |, )${label} from (\\S+) to (\\S+) (\\w+)`)) ?? [];
    const values = trace[column].map((value) => factor * value), size = greatest(values) - least(values);
    expect(its === unit, `${label} is in ${its}, not ${unit}: ${words}`);
    about(Number(from), least(values), size, `the least ${label}`);
    about(Number(to), greatest(values), size, `the greatest ${label}`);
  }

  // The orbit: x_a down, y_a to the right, the clearance fitting in.
  await page.evaluate(() => {
    window.drawn.orbit = { lines: [], texts: [] };
    document.getElementById("frame").dispatchEvent(new Event("change"));
  });
  await page.waitForTimeout(300);
  const orbit = await page.evaluate(() => ({ ...window.drawn.orbit, width: document.getElementById("orbit").clientWidth,
    height: document.getElementById("orbit").clientHeight }));
  const { inputs } = await summary();
  const pixels = orbit.width / 2 / (1.25 * (inputs.stator_radius - inputs.rotor_radius));
  const curve = orbit.lines.slice(0, -1); // and the bar that shows the scale
  for (const [i, column, middle] of [[0, "y_a_m", orbit.width / 2], [1, "x_a_m", orbit.height / 2]]) {
    const places = curve.map((point) => (point[i] - middle) / pixels);
    about(least(places), least(trace[column]), 3e-3, `the orbit's least ${column}`);
    about(greatest(places), greatest(trace[column]), 3e-3, `the orbit's greatest ${column}`);
  }
}

// ---- knobs, address, refusals

async function checkKnobs() {
  await set({});
  await page.focus("#friction");
  await page.fill("#friction", "0.2");
  await shown();
  expect((await page.evaluate(() => location.hash)) === "#friction=0.2", "the address does not hold the friction");
  expect((await text("command")) === "build/rotor run --friction 0.2 --energy --json", "the command is another one");
  expect((await summary()).touch_downs === 12, "friction 0.2 has 12 touch-downs");

  await page.selectOption("#figure", { label: "Fig. 12" });
  await shown();
  expect((await summary()).inputs.mass_loss_time === 19.1, "Fig. 12 is not the mass loss at 19.1 s");
  await page.check("#velocity-jump");
  await page.check("#gravity-moment");
  await shown();
  expect((await summary()).equations === "consistent", "both corrections are not the consistent equations");
  await page.click("#paper");
  await shown();

  await page.click("#keep");
  await page.fill("#friction", "0.1");
  await page.waitForFunction(() => document.querySelectorAll("#numbers tr:first-child td").length === 2);
  await page.reload();
  await page.waitForFunction(() => document.querySelectorAll("#numbers tr:first-child td").length === 2);
  expect((await summary()).inputs.friction === 0.1, "the address does not keep two settings");
  await page.click("#alone");
  await page.click("#paper");
  await shown();
}

async function checkRefusals() {
  for (const [option, value] of [["friction", "-1"], ["clearance", "wide"], ["mass-loss-speed-hz", "200"]]) {
    await set({});
    await page.fill(`#${option}`, value);
    await page.waitForFunction(() => document.getElementById("status").classList.contains("refusal"));
    const { stderr } = spawnSync(rotor, ["run", `--${option}`, value], { encoding: "utf8" });
    const refusal = await text("status");
    expect(`rotor: ${refusal}\n` === stderr, `${option} ${value}: "${refusal}", not "${stderr}"`);
  }
  await set({});
  expect((await text("status")) === "", "a refusal stays when it is over");
}

/// A rotor that takes minutes says how far it is, and leaves when the next one comes.
async function checkLongRuns() {
  await page.evaluate(() => (location.hash = "#torque=0.01&until=100000&from=99999&support-damping=0"));
  await page.waitForFunction(() => /^The run has got to/.test(document.getElementById("status").textContent), null, { timeout: 60_000 });
  const before = Date.now();
  await set({});
  const waited_s = (Date.now() - before) / 1e3;
  expect(waited_s < 5, `a long run was dropped after ${waited_s} s`);
  say(`a long run is dropped, and the next one shown, in ${waited_s.toFixed(2)} s`);
}

async function checkFiles() {
  await set({ friction: "0.2", from: "29.1" });
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
  const ours = readFileSync(await download.path(), "utf8").split("\n");
  const theirs = execFileSync(rotor, ["run", "--friction", "0.2", "--from", "29.1", "--trace", "-"],
    { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 28 }).split("\n");
  // Without the closed forms, whose last digits depend on the mathematical library.
  const head = (lines) => lines.slice(0, lines.findIndex((line) => !line.startsWith("#")) + 1)
    .filter((line) => !line.includes("by closed forms")).join("\n");
  expect(head(ours) === head(theirs), "the CSV has another head");
  expect(Math.abs(ours.length - theirs.length) < 0.01 * theirs.length, `the CSV has ${ours.length} rows, not ${theirs.length}`);
}

async function checkAccess() {
  await page.addScriptTag({ path: require.resolve("axe-core/axe.min.js") });
  for (const [width, colorScheme] of [[1400, "light"], [1400, "dark"], [360, "light"]]) {
    await page.setViewportSize({ width, height: 800 });
    await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
    await page.waitForTimeout(300);
    const { violations } = await page.evaluate(() => window.axe.run());
    for (const { id, impact, nodes } of violations)
      expect(!["serious", "critical"].includes(impact), `${width} px, ${colorScheme}: ${id}: ${nodes.map(({ html }) => html).join(" ")}`);
    const over = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    expect(over <= 0, `at ${width} px the page is ${over} px too wide`);
  }
}

try {
  await noteDrawing(page);
  await page.goto(address);
  await shown();
  await checkNumbers();
  await checkDrawing();
  await checkKnobs();
  await checkRefusals();
  await checkLongRuns();
  await checkFiles();
  await checkShares();
  await checkAccess();
} finally {
  await browser.close();
}
say(failures === 0 ? "The page shows what the program says." : `${failures} failures`);
process.exitCode = failures === 0 ? 0 : 1;
