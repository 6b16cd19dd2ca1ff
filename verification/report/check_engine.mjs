// The page with the engine, compared with the program: part of check_page.mjs.
import { execFileSync, spawnSync } from "node:child_process";

let page, rotor, expect;
const say = (text) => console.log(text);
const text = (id) => page.textContent(`#${id}`);
/// Waits until the pictures match the settings in the address.
const shown = () => page.waitForFunction(
  () => document.body.dataset.shows === location.hash.split("/")[0].replace(/^#?/, "#"), null, { timeout: 60_000 });
const summary = async () => JSON.parse(await text("summary"));
async function set(options) {
  const hash = "#" + new URLSearchParams(options);
  await page.evaluate((to) => {
    delete document.body.dataset.shows;
    location.hash = `${to}/`;
    dispatchEvent(new HashChangeEvent("hashchange"));
  }, hash);
  await page.waitForFunction((to) => document.body.dataset.shows === to, hash, { timeout: 60_000 });
}

const argumentsOf = (options) =>
  Object.entries(options).flatMap(([option, value]) => (value === "" ? [`--${option}`] : [`--${option}`, value]));
const native = (options) => JSON.parse(execFileSync(rotor,
  ["run", "--energy", "--json", ...argumentsOf(options)], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));

// ---- the numbers

/// Every number of a summary by its path, without the cost of the run.
const costs = ["right_hand_sides", "contact_evaluations", "steps", "located_events"];
function leaves(json, name = "") {
  if (json === null || typeof json !== "object") return [[name, json]];
  return Object.entries(json).filter(([key]) => !costs.includes(key))
    .flatMap(([key, value]) => leaves(value, `${name}/${key}`));
}

/// Two programs with sines that differ in the last digit differ by the rounding of one, multiplied by the
/// run. That is less than the effect of a tolerance ten times as large; values that do not depend on the
/// tolerance must agree to ten digits. Energies are compared relative to the energy of the rotor.
function compare(options) {
  const stated = native(options);
  const looser = Object.fromEntries(leaves(native({ ...options, tolerance: "1e-10" })));
  const energy = stated.energy_J.until_end.initial;
  let worst = 0;
  return (seen) => {
    const ours = Object.fromEntries(leaves(seen));
    for (const [name, value] of leaves(stated)) {
      if (name === "/tolerance" || name.startsWith("/inputs/")) continue;
      if (typeof value !== "number") {
        expect(ours[name] === value, `${JSON.stringify(options)}: ${name} is ${ours[name]}, not ${value}`);
        continue;
      }
      const scale = name.startsWith("/energy_J") ? energy : Math.abs(value);
      const error = Math.abs(looser[name] - value) + 1e-10 * scale;
      const off = Math.abs(ours[name] - value);
      worst = Math.max(worst, error > 0 ? off / error : 0);
      expect(off <= error, `${JSON.stringify(options)}: ${name} is ${ours[name]}, not ${value} within ${error}`);
    }
    for (const name of Object.keys(ours)) expect(name in Object.fromEntries(leaves(stated)), `${name} is new`);
    return worst;
  };
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
  let worst = 0;
  for (const options of settings) {
    await set(options);
    worst = Math.max(worst, compare(options)(await summary()));
  }
  say(`${settings.length} settings: every number as rotor run --json has it, within the error of the run; ` +
    `the largest difference is ${(100 * worst).toFixed(0)} % of it`);
}

// ---- knobs, address, refusals

async function checkKnobs() {
  await set({});
  await page.focus("#friction");
  await page.fill("#friction", "0.2");
  await shown();
  expect((await text("command")) === "build/rotor run --friction 0.2 --energy --json", "the command is another one");
  expect((await summary()).touch_downs === 12, "friction 0.2 has 12 touch-downs");

  await page.getByRole("slider", { name: /coefficient of Coulomb friction/ }).focus();
  await page.keyboard.press("ArrowRight");
  await shown();
  const { inputs } = await summary();
  expect(inputs.friction > 0.2 && inputs.friction < 0.21, `an arrow key turns the friction to ${inputs.friction}`);
  await page.click(".knob:has(#friction) .reset");
  await shown();
  expect((await summary()).inputs.friction === 0.3, "one click does not restore the paper's friction");

  await page.fill("#mass-loss-speed-hz", "75");
  await shown();
  const speed = (await summary()).speed_at_mass_loss_Hz;
  expect(Math.abs(speed - 75) < 1e-6, `the mass is lost at ${speed} Hz`);
  await page.fill("#mass-loss-time", "20");
  await shown();
  expect((await summary()).inputs.mass_loss_time === 20, "the time of the mass loss does not replace its speed");
  await page.click("#paper");
  await shown();

  await page.check("#velocity-jump");
  await page.check("#gravity-moment");
  await shown();
  expect((await summary()).equations === "consistent", "both corrections are not the consistent equations");
  await page.click("#paper");
  await shown();

  // On the map: a drag reruns the instrument.
  await page.locator("#map").scrollIntoViewIfNeeded();
  const box = await page.locator("#map").boundingBox();
  await page.mouse.move(box.x + 0.55 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  for (let n = 0; n < 20; ++n) {
    await page.mouse.move(box.x + (0.55 - 0.01 * n) * box.width, box.y + 0.5 * box.height);
    await page.waitForTimeout(150);
  }
  await page.mouse.up();
  await shown();
  const dragged = (await summary()).speed_at_mass_loss_Hz;
  expect(dragged > 40 && dragged < 100, `a drag on the map shows ${dragged} Hz`);
  const [engine_ms, picture_ms] = await page.evaluate(() => ["engine run", "input to picture"].map((name) =>
    performance.getEntriesByName(name).slice(-15).map(({ duration }) => duration).sort((one, other) => one - other)[7]));
  say(`from a drag to the picture: ${picture_ms.toFixed(0)} ms at the median, ${(picture_ms / engine_ms).toFixed(1)} runs of the engine`);
  await page.locator(".marker").press("ArrowRight");
  await shown();
  expect((await summary()).speed_at_mass_loss_Hz > dragged + 0.5, "an arrow key does not move the marker");
  await page.click("#paper");
  await shown();
}

async function checkRefusals() {
  for (const [option, value] of [["friction", "-1"], ["unbalance-factor", "0.5"], ["clearance", "wide"],
    ["eccentricity", "0.07"], ["mass-loss-speed-hz", "200"], ["unbalance-factor", "400"]]) {
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

/// A rotor that takes minutes reports progress, and is dropped when the next one is requested.
async function checkLongRuns() {
  await page.evaluate(() => (location.hash = "#torque=0.01&until=100000&from=99999&support-damping=0"));
  await page.waitForFunction(() => /^The run has reached/.test(document.getElementById("status").textContent), null, { timeout: 60_000 });
  const before = Date.now();
  await set({});
  const waited_s = (Date.now() - before) / 1e3;
  expect(waited_s < 5, `a long run was dropped after ${waited_s} s`);
  say(`a long run is dropped, and the next one shown, in ${waited_s.toFixed(2)} s`);
}

export async function checkEngine(of) {
  ({ page, rotor, expect } = of);
  await shown();
  await page.click("#more > summary");
  await page.waitForSelector("#friction");
  await checkNumbers();
  await checkKnobs();
  await checkRefusals();
  await checkLongRuns();
}
