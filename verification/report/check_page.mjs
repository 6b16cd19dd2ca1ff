// Checks the reviewer's page in headless Chromium: `node check_page.mjs PAGE CHROMIUM ROTOR`.
// Prints one line per fault. Needs playwright-core and axe-core.
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

import { checkEngine } from "./check_engine.mjs";

const [page_file, chromium_path, rotor] = process.argv.slice(2);
const address = "file://" + path.resolve(page_file);
const installed = createRequire(
  path.resolve(path.dirname(page_file), "../check-report/package.json"),
);
const { chromium } = installed("playwright-core");
const axe = fs.readFileSync(installed.resolve("axe-core/axe.min.js"), "utf8");

const most_bytes = 2e6;
const pictures = fs
  .readdirSync("figures/paper")
  .filter((file) => /^fig\d+\.toml$/.test(file)).length;
const faults = [];
const expect = (holds, fault) => {
  if (!holds) faults.push(fault);
};

// What is at fault in the page, by what is wrong with it; `all` finds elements there.
const in_contents = {
  "links lead nowhere": () =>
    all("a[href^='#']").filter(
      (link) => !document.getElementById(link.getAttribute("href").slice(1)),
    ),
  "figures have no size": () =>
    all("#figures article > details > figure > svg").filter(
      ({ clientWidth, clientHeight }) => clientWidth <= 200 || clientHeight <= 100,
    ),
  // With a mathematical font and without.
  "subscripts are not lower than their letters": () =>
    ["", "DejaVu Serif"].flatMap((font) =>
      all("math msub, math msubsup").filter((sub) => {
        const { style } = sub.closest("math"),
          [letter, index] = sub.children;
        style.fontFamily = font;
        const [above, below] = [letter, index].map(
            (element) => element.getBoundingClientRect().bottom,
          ),
          padding = parseFloat(getComputedStyle(letter).paddingBottom);
        style.removeProperty("font-family");
        return below < above - padding + 2;
      }),
    ),
  // They are as people write them, outside commands and scenes.
  "numbers are raw": () => {
    const copy = document.querySelector("main").cloneNode(true);
    for (const part of copy.querySelectorAll("pre, code, svg, style, math")) part.remove();
    return (
      copy.innerHTML.replace(/<[^>]*>/g, " ").match(/\d[eE][-+]?\d+|(?<=^|[\s(])-\d[\d.]*/gm) ?? []
    );
  },
  "sliders with few values do not show them": () =>
    all("input[type=range]").filter(
      ({ min, max, step, nextElementSibling: next }) =>
        (max - min) / (step || 1) < 5 && next.children.length !== (max - min) / (step || 1) + 1,
    ),
};
const in_look = {
  // WCAG 2.2, 2.5.8; a radio button has its label's size.
  "controls are below 24 px": () =>
    all("button:enabled, input, summary, nav a, [tabindex='0']").filter((element) => {
      const { width, height } = (
        element.type === "radio" ? element.parentElement : element
      ).getBoundingClientRect();
      return element.checkVisibility() && Math.min(width, height) < 24;
    }),
  "verdicts of figures are hidden": () =>
    all("#figures article .sign").filter((sign) => !sign.checkVisibility()),
  "heights are above 14000 px, or 20000 px with figures at full size": () =>
    [document.documentElement.scrollHeight].filter(
      (height) => innerWidth !== 768 && height > (innerWidth > 768 ? 20e3 : 14e3),
    ),
  "widths, with all details open, make the page scroll sideways": () => {
    const closed = all("details:not([open])");
    for (const details of closed) details.open = true;
    const { scrollWidth } = document.documentElement;
    for (const details of closed) details.open = false;
    return [scrollWidth].filter((width) => width > innerWidth);
  },
};
async function check(page, name, checks) {
  for (const [fault, find] of Object.entries(checks)) {
    const found = await page.evaluate(`(${find})().map((at) => at.outerHTML?.slice(0, 80) ?? at)`);
    expect(
      found.length === 0,
      `${name}: ${found.length} ${fault}: ${found.slice(0, 4).join("; ")}`,
    );
  }
}

// The contents of pictures are hidden meanwhile, because they take most of the time.
async function check_axe(page, name) {
  const hidden = await page.addStyleTag({ content: "figure svg > * { display: none }" });
  const { violations } = await page.evaluate(() => axe.run({ exclude: [["figure svg > *"]] }));
  await hidden.evaluate((style) => style.remove());
  for (const found of violations)
    faults.push(
      `${name}: ${found.help} (${found.id}): ${found.nodes
        .map((n) => n.target)
        .slice(0, 3)
        .join("; ")}`,
    );
}

// Whatever an address says, there is a run, which plays and can be zoomed.
async function check_addresses(browser) {
  for (const hash of [
    "friction=1e999",
    "friction=0.123",
    "mass-loss-time=-1",
    "clearance=x",
    "equations=neither",
    "%00=&friction",
  ]) {
    const page = await browser.newPage({ viewport: desktop });
    page.setDefaultTimeout(120e3); // beside other parts of CI
    page.on("pageerror", (error) => faults.push(`#${hash}: ${error.message}`));
    await page.goto(`${address}#${hash}`);
    for (const id of ["play", "zoom-in", "zoom-out", "show-accident", "play"])
      await page.click(`#${id}`);
    await page.press("#plots", "ArrowRight");
    expect(/^The rotor/.test(await page.textContent("#outcome")), `#${hash}: no run is shown`);
    await page.close();
  }
}

const state = (page) => page.textContent("#rotor-state");
const ms_of = async (page) => Number((await state(page)).match(/^[−\d.]+/)[0].replace("−", "-"));
const shown = (page, hash) =>
  page
    .waitForFunction((to) => document.body.dataset.shows === to, hash, { timeout: 20e3 })
    .catch(() => faults.push(`${hash} is not shown`));

// Five steps, each with its formula and one control, which changes the words beside it; the picture
// stays beside the text, and on a phone each step has its own above its text.
async function check_steps(page, is_phone) {
  const steps = await page.$$(".step");
  expect(steps.length === 5, `${steps.length} steps instead of 5`);
  for (const step of steps) {
    await step.scrollIntoViewIfNeeded();
    const id = await step.getAttribute("id"),
      control = await step.$("input"),
      says = () => step.$eval("output", (output) => output.textContent);
    expect(
      (await (await step.$("math")).isVisible()) && (await step.$$("input")).length === 1,
      `${id} has no formula, or not one control`,
    );
    await control.press("Home");
    const stage = await (is_phone ? step.$(".stage") : page.$("#stage")),
      first = await says();
    const shows = await stage.$eval(".now", (now) => now.textContent);
    expect(!shows.startsWith("−"), `the picture of ${id} ends ${shows}`);
    await control.fill(await control.evaluate(({ max }) => String(Math.round(max / 2))));
    expect(
      (await says()) !== first && (await control.getAttribute("aria-valuetext")) === (await says()),
      `the control of ${id} changes nothing`,
    );
    const [picture, text] = await Promise.all([
      stage.boundingBox(),
      (await step.$("p")).boundingBox(),
    ]);
    const is_placed = is_phone
      ? picture?.y + picture?.height <= text.y
      : picture?.y >= 0 &&
        picture.y + picture.height <= page.viewportSize().height &&
        picture.x + picture.width <= text.x;
    expect(
      is_placed,
      `the picture is not ${is_phone ? "above" : "beside"} the text of ${id}: ` +
        JSON.stringify([picture, text]),
    );
  }
  expect(!(await page.isVisible("#roll-answer p")), "a slider moved by keys opens the answer");
  await page.press("#roll-control", "Enter");
  expect(await page.isVisible("#roll-answer p"), "a guess does not show the answer");
}

// Without scripts, and on paper: the strip of the accident, text and formulas, and no control.
async function check_unscripted(browser) {
  for (const javaScriptEnabled of [false, true]) {
    const context = await browser.newContext({ viewport: desktop, javaScriptEnabled }),
      page = await context.newPage();
    page.setDefaultTimeout(120e3);
    await page.goto(address);
    if (javaScriptEnabled) await page.emulateMedia({ media: "print" });
    expect(
      (await page.isVisible(".stills svg")) && !(await page.isVisible(".control, .stage, #try")),
      `scripts ${javaScriptEnabled}: the strip is not shown alone`,
    );
    for (const part of await page.$$(".step math, .step p.note"))
      expect(await part.isVisible(), "a formula or note is hidden without scripts");
    const closed = await page.$$eval(
      "details",
      (all) =>
        all.filter((details) => details.checkVisibility() && !details.children[1].checkVisibility())
          .length,
    );
    expect(!javaScriptEnabled || closed === 0, `${closed} folded parts are printed closed`);
    await context.close();
  }
}

// The time follows mouse, keys and the clock.
async function check_time(page) {
  await page.$eval("#try", (part) => part.scrollIntoView());
  const box = await page.locator("#plots").boundingBox(),
    seen = [];
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 100);
  await page.mouse.down();
  for (const share of [0.4, 0.6]) {
    await page.mouse.move(box.x + share * box.width, box.y + 100);
    seen.push(await ms_of(page));
  }
  await page.mouse.up();
  expect(seen[1] > seen[0] + 1, `scrubbing goes from ${seen[0]} to ${seen[1]} ms`);
  const scrubs_ms = await page.evaluate(async () => {
    const plots = document.getElementById("plots"),
      all = [];
    for (let n = 0; n < 21; ++n) {
      const begun = performance.now();
      plots.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
      await new Promise(requestAnimationFrame);
      all.push(performance.now() - begun);
    }
    return all.sort((one, other) => one - other)[10];
  });
  expect((await ms_of(page)) > seen[1], "an arrow key does not move the time");
  await page.press("#plots", "Home");
  await page.click("#play");
  const from = [await ms_of(page), Date.now()];
  await page.waitForTimeout(3000);
  // The film is 1000 times slower: this is 1 if no frame is late.
  const passed = (((await ms_of(page)) - from[0]) * 1000) / (Date.now() - from[1]);
  await page.click("#play");
  expect(passed > 0.1 && passed < 1.2, `the film runs ${passed} times as fast as stated`);
  const stopped = await state(page);
  await page.waitForTimeout(200);
  expect((await state(page)) === stopped, "the film cannot be stopped");
  return scrubs_ms;
}

/// How many pixels in the upper part of a canvas have nearly a set's colour.
const inked = (page, canvas, set) =>
  page.$eval(
    canvas,
    (of, name) => {
      const { data } = of.getContext("2d").getImageData(0, 0, of.width, 0.4 * of.height);
      const ink = getComputedStyle(document.documentElement)
        .getPropertyValue(`--${name}`)
        .match(/\w\w/g)
        .map((part) => parseInt(part, 16));
      let count = 0;
      for (let n = 0; n < data.length; n += 4)
        count += ink.every((part, i) => Math.abs(data[n + i] - part) < 4);
      return count;
    },
    set,
  );

// Pins show the paper's cases; with corrected equations there is no contact at 75 Hz. The curves
// show both sets, and a run has the colour of its equations. Returns how long the slowest pin takes, ms.
async function check_pins(page) {
  const slowest_ms = await page.evaluate(async () => {
    const pins = all(".pin").map((pin) => ({ pin, ms: Infinity }));
    for (const one of Array(5).fill(pins).flat()) {
      // the least of five, because other programs run, too
      const begun = performance.now();
      delete document.body.dataset.shows;
      one.pin.click();
      while (!document.body.dataset.shows) await new Promise(requestAnimationFrame);
      one.ms = Math.min(one.ms, performance.now() - begun);
    }
    return Math.max(...pins.map(({ ms }) => ms));
  });
  await page.check("#published");
  await page.getByRole("button", { name: /^150 Hz/ }).click();
  expect(
    (await inked(page, "#rotor", "corrected")) === 0,
    "a run as printed has the colour of the corrected equations",
  );
  const outcome = () => page.textContent("#outcome");
  await page.getByRole("button", { name: /^75 Hz/ }).click();
  await shown(page, "#mass-loss-time=14.15&equations=published");
  expect(/roll.* 136\.\d kN/.test(await outcome()), `at 75 Hz: ${await outcome()}`);
  await page.check("#corrected");
  await shown(page, "#mass-loss-time=14.15");
  expect(/does not touch/.test(await outcome()), `at 75 Hz, corrected: ${await outcome()}`);
  for (const set of ["published", "corrected"])
    expect((await inked(page, "#plots", set)) > 20, `no curve ${set} at 75 Hz`);
  await page.getByRole("button", { name: /^μ = 0.2/ }).press("Enter");
  await shown(page, "#friction=0.2");
  await page.reload(); // the address keeps the settings
  await shown(page, "#friction=0.2");
  return slowest_ms;
}

// A name in the picture of claims opens its row; what is searched for leaves the rows that have it.
async function check_claims(page) {
  await page.locator(".claims-picture a[href='#number-rolls_75']").click();
  expect(
    /such a value in 7\s%/.test(await page.innerText("#number-rolls_75")),
    "the picture does not open the row of rolls_75",
  );
  await page.fill("#find", "ends in rolling as");
  const found = await page.$$eval(".number", (rows) =>
    rows.filter((row) => row.checkVisibility()).map(({ id }) => id),
  );
  expect(found.join() === "number-rolls_75", `the search leaves ${found}`);
  await page.fill("#find", "");
}

// The tabulator reaches whatever a mouse can use; of a group of radio buttons, the one that is
// chosen; and a list of numbers of claims once, from where arrow keys reach each. 90 presses do.
async function check_keyboard(page) {
  const count = await page.evaluate(() => {
    window.unreached = new Set(
      all("a[href], button:enabled, select, summary, input, [tabindex='0']").filter(
        (element) =>
          element.checkVisibility() &&
          getComputedStyle(element).pointerEvents !== "none" &&
          !(element.type === "radio" && !element.checked),
      ),
    );
    document.addEventListener("focusin", ({ target }) => window.unreached.delete(target));
    return window.unreached.size;
  });
  for (let stops = 0; stops < 90; ++stops) {
    await page.keyboard.press("Tab");
    const rows = await page.$$eval(":focus:not(body) [tabindex='-1']", ({ length }) => length);
    for (let n = 0; n < rows; ++n) await page.keyboard.press("ArrowDown");
  }
  const unreached = await page.evaluate(() =>
    [...window.unreached].map((element) => element.outerHTML.slice(0, 80)),
  );
  expect(
    count > 50 && unreached.length === 0,
    `the tabulator does not reach ${unreached.join("; ")}`,
  );
}

const desktop = { width: 1440, height: 900 };
const looks = {
  desktop,
  dark: desktop,
  tablet: { width: 768, height: 1024 },
  phone: { width: 360, height: 740 },
};

(async () => {
  const bytes = fs.statSync(page_file).size;
  // Chromium has no sandbox when run as root.
  const browser = await chromium.launch({
    executablePath: chromium_path,
    args: process.getuid() ? [] : ["--no-sandbox"],
  });
  // A film of a step is at its end at once.
  const page = await browser.newPage({ viewport: desktop, reducedMotion: "reduce" });
  page.setDefaultTimeout(300e3);
  await page.addInitScript(() => {
    window.all = (selector) => [...document.querySelectorAll(selector)];
  });
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(message.text());
  });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) =>
    expect(/^(file|data|blob):/.test(request.url()), `asks the network for ${request.url()}`),
  );
  await page.goto(address);
  await shown(page, "#");
  const without_engine =
    bytes -
    (await page.$$eval("#engine-wasm, #engine-worker", (all) =>
      all.reduce((sum, { textContent }) => sum + textContent.length, 0),
    ));
  expect(
    without_engine <= most_bytes,
    `${without_engine} bytes without the engine, more than ${most_bytes}`,
  );
  for (const file of await page.$$eval("a:not([href^='#'])", (links) =>
    links.map((link) => link.getAttribute("href")),
  ))
    expect(
      fs.existsSync(path.join(path.dirname(page_file), decodeURIComponent(file))),
      `there is no ${file}`,
    );
  const seen = await page.locator("#figures article > details > figure > svg").count();
  expect(seen === pictures, `${seen} figures instead of ${pictures}`);
  await check(page, "page", in_contents);
  await check_addresses(browser);
  await check_steps(page, false);
  await check_unscripted(browser);
  const scrubs_ms = await check_time(page);
  const slowest_ms = await check_pins(page);
  await check_claims(page);
  await check_keyboard(page);
  if (await page.$("body.has-engine")) await checkEngine({ page, rotor, expect });
  for (const [name, viewport] of Object.entries(looks)) {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme: name === "dark" ? "dark" : "light" });
    await page.reload();
    await page.waitForTimeout(300);
    await page.evaluate(axe);
    await check_axe(page, name);
    await check(page, name, in_look);
    if (name !== "phone") continue;
    await check_steps(page, true);
    await page.click("#fig05 summary");
    expect(
      (await page.isVisible("#fig05 figure svg")) && !(await page.isVisible("#fig06 figure svg")),
      "a card that was opened is not the only one",
    );
  }
  await browser.close();
  for (const fault of faults) console.error("check-report: " + fault);
  console.log(
    `${page_file}: ${(bytes / 1e6).toFixed(2)} MB, a key redraws in ${scrubs_ms.toFixed(0)} ms, ` +
      `a pin in ${slowest_ms.toFixed(0)} ms at most, ${faults.length} faults`,
  );
  process.exit(faults.length ? 1 : 0);
})().catch((error) => {
  console.error("check-report: " + error.message);
  process.exit(1);
});
