// The page with the engine, compared with the program: part of check_page.mjs.
import { execFileSync } from "node:child_process";

let page, rotor, expect;
const text = (id) => page.textContent(`#${id}`);
/// Waits until the pictures match the settings in the address.
const shown = () =>
  page.waitForFunction(
    () => document.body.dataset.shows === location.hash.replace(/^#?/, "#"),
    null,
    { timeout: 60_000 },
  );
const summary = async () => JSON.parse(await text("summary"));
async function set(options, timeout = 60_000) {
  const hash = "#" + new URLSearchParams(options);
  await page.evaluate((to) => {
    delete document.body.dataset.shows;
    location.hash = to;
    dispatchEvent(new HashChangeEvent("hashchange"));
  }, hash);
  await page.waitForFunction((to) => document.body.dataset.shows === to, hash, { timeout });
}

const native = (options) =>
  JSON.parse(
    execFileSync(
      rotor,
      [
        "run",
        "--json",
        ...Object.entries(options).flatMap(([option, value]) => [`--${option}`, value]),
      ],
      { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] },
    ),
  );

// ---- the numbers

/// Every number of a summary by its path, without the cost of the run.
const costs = ["right_hand_sides", "contact_evaluations", "steps", "located_events"];
function leaves(json, name = "") {
  if (json === null || typeof json !== "object") return [[name, json]];
  return Object.entries(json)
    .filter(([key]) => !costs.includes(key))
    .flatMap(([key, value]) => leaves(value, `${name}/${key}`));
}

/// Two programs with sines that differ in the last digit differ by the rounding of one, multiplied
/// by the run. That is less than the effect of a tolerance ten times as large; values that do not
/// depend on the tolerance must agree to ten digits.
function compare(options, seen) {
  const [stated, looser, ours] = [
    native(options),
    native({ ...options, tolerance: "1e-10" }),
    seen,
  ].map((json) => Object.fromEntries(leaves(json)));
  let worst = 0;
  for (const [name, value] of Object.entries(stated)) {
    if (name === "/tolerance" || name.startsWith("/inputs/")) continue;
    const is_number = typeof value === "number",
      off = Math.abs(ours[name] - value);
    const error = is_number ? Math.abs(looser[name] - value) + 1e-10 * Math.abs(value) : 0;
    if (error > 0) worst = Math.max(worst, off / error);
    expect(
      is_number ? off <= error : ours[name] === value,
      `${JSON.stringify(options)}: ${name} is ${ours[name]}, not ${value} within ${error}`,
    );
  }
  for (const name of Object.keys(ours)) expect(name in stated, `${name} is new`);
  return worst;
}

const settings = [
  {},
  { friction: "0.2", equations: "published" },
  { friction: "0.15", "mass-loss-time": "20" },
  { "mass-loss-speed-Hz": "75" },
  { clearance: "0.001", friction: "0.1", "mass-loss-time": "19.1" },
  { "unbalance-factor": "4" },
];

async function checkNumbers() {
  let worst = 0;
  for (const options of settings) {
    await set(options);
    worst = Math.max(worst, compare(options, await summary()));
  }
  console.log(
    `${settings.length} settings: every number as rotor run --json has it, ` +
      "within the error of the run; " +
      `the largest difference is ${(100 * worst).toFixed(0)} % of it`,
  );
}

// ---- sliders, map, refusals

async function checkInputs() {
  await set({});
  await page.fill("[name=clearance]", "0.002");
  await shown();
  expect(
    (await text("command")) === "build/rotor run --clearance 0.002 --json",
    "the command is another one",
  );
  expect(
    Math.abs((await summary()).inputs.stator_radius - 0.062) < 1e-12,
    "the clearance is another one",
  );
  await page.click("#paper");
  await shown();
  expect(
    (await summary()).inputs.stator_radius === 0.063,
    "one click does not restore the paper's clearance",
  );

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
  const [engine_ms, picture_ms] = await page.evaluate(() =>
    ["engine run", "input to picture"].map(
      (name) =>
        performance
          .getEntriesByName(name)
          .slice(-15)
          .map(({ duration }) => duration)
          .sort((one, other) => one - other)[7],
    ),
  );
  console.log(
    `from a drag to the picture: ${picture_ms.toFixed(0)} ms at the median, ` +
      `${(picture_ms / engine_ms).toFixed(1)} runs of the engine`,
  );
  await page.locator(".marker").press("ArrowRight");
  await shown();
  expect(
    (await summary()).speed_at_mass_loss_Hz > dragged + 0.5,
    "an arrow key does not move the marker",
  );

  // A run of half a minute is announced, and ended by the next settings.
  await page.evaluate(() => (location.hash = "#mass-loss-time=1.8e6"));
  await page.waitForFunction(() => document.body.classList.contains("stale"));
  await page.waitForTimeout(1200);
  await set({ friction: "0.25" }, 20_000);
  await page.waitForSelector("body:not(.stale)");

  await page.evaluate(() => (location.hash = "#friction=-1"));
  await page.waitForFunction(() =>
    document.getElementById("status").textContent.startsWith("--friction"),
  );
  await set({});
  expect((await text("status")) === "", "a refusal stays when it is over");
}

export async function checkEngine(of) {
  ({ page, rotor, expect } = of);
  await checkNumbers();
  await checkInputs();
}
