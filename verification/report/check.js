// Checks the reviewer's page in headless Chromium: `node check.js PAGE CHROMIUM`. Says what is wrong, a
// line each. Needs playwright-core and axe-core.
"use strict";
const fs = require("fs");
const path = require("path");
const { createRequire } = require("module");
const [page_file, chromium_path] = process.argv.slice(2);
const installed = createRequire(path.resolve(path.dirname(page_file), "../check-report/package.json"));
const { chromium } = installed("playwright-core");
const axe = fs.readFileSync(installed.resolve("axe-core/axe.min.js"), "utf8");

const most_bytes = 4e6;
const pictures = fs.readdirSync("figures/paper").filter((file) => /^fig\d+\.toml$/.test(file)).length;
const faults = [];
const expect = (holds, fault) => { if (!holds) faults.push(fault); };

// Links within the page, and to files beside it.
async function check_links(page) {
  const links = await page.$$eval("a[href]", (all) => all.map((a) => a.getAttribute("href")));
  const ids = new Set(await page.$$eval("[id]", (all) => all.map((e) => e.id)));
  for (const link of new Set(links)) {
    const is_there = link.startsWith("#") ? ids.has(link.slice(1))
      : fs.existsSync(path.join(path.dirname(page_file), decodeURIComponent(link)));
    expect(is_there, `the link ${link} leads nowhere`);
  }
  return links.length;
}

async function check_pictures(page) {
  const boxes = await page.$$eval("#figures article", (all) => all.map((article) => {
    const svg = article.querySelector("figure svg");
    const box = svg ? svg.getBoundingClientRect() : { width: 0, height: 0 };
    return { id: article.id, width: box.width, height: box.height };
  }));
  expect(boxes.length === pictures, `${boxes.length} figures instead of ${pictures}`);
  for (const box of boxes) expect(box.width > 200 && box.height > 100, `${box.id} has no picture with a size`);
}

// What curves consist of is hidden meanwhile: that takes most of the time, and the pictures stay.
async function check_axe(page, name) {
  const hidden = await page.addStyleTag({ content: "figure svg > * { display: none }" });
  const { violations } = await page.evaluate(() => axe.run({ exclude: [["figure svg > *"]] }));
  await hidden.evaluate((style) => style.remove());
  for (const found of violations)
    if (found.impact === "serious" || found.impact === "critical")
      faults.push(`${name}: ${found.help} (${found.id}): ${found.nodes.map((n) => n.target).slice(0, 3).join("; ")}`);
}

// The film runs when it is asked to, and stops.
async function check_film(page) {
  if (!(await page.isVisible("#film-play"))) return faults.push("there is no film");
  const time = () => page.$eval("#film-time", (range) => Number(range.value));
  await page.click("#film-play");
  const runs = page.waitForFunction(() => Number(document.getElementById("film-time").value) > 0);
  await runs.catch(() => faults.push("the film does not run"));
  await page.click("#film-play");
  const stopped = await time();
  await page.waitForTimeout(200);
  expect((await time()) === stopped, "the film cannot be stopped");
}

const desktop = { width: 1280, height: 900 };
const looks = [
  { name: "desktop", viewport: desktop, media: {} },
  { name: "dark", viewport: desktop, media: { colorScheme: "dark" } },
  { name: "phone", viewport: { width: 360, height: 740 }, media: {} },
];

(async () => {
  const bytes = fs.statSync(page_file).size;
  expect(bytes < most_bytes, `${bytes} bytes, more than ${most_bytes}`);
  // As root Chromium has no sandbox.
  const browser = await chromium.launch({ executablePath: chromium_path, args: process.getuid() ? [] : ["--no-sandbox"] });
  const page = await browser.newPage({ viewport: desktop });
  page.setDefaultTimeout(300e3);
  page.on("console", (message) => { if (message.type() === "error") faults.push(message.text()); });
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) faults.push(`asks the network for ${request.url()}`);
  });
  await page.goto("file://" + path.resolve(page_file));
  const links = await check_links(page);
  await check_pictures(page);
  await check_film(page);
  await page.evaluate(axe);
  for (const { name, viewport, media } of looks) {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme: "light", ...media });
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(width <= viewport.width, `${name}: scrolls sideways, ${width} px wide`);
    await check_axe(page, name);
  }
  await page.emulateMedia({ reducedMotion: "reduce" });
  expect(!(await page.isVisible("#film")), "the film is shown to readers who ask for reduced motion");
  await browser.close();
  for (const fault of faults) console.error("check-report: " + fault);
  console.log(`${page_file}: ${(bytes / 1e6).toFixed(2)} MB, ${links} links, ${looks.length} looks, ${faults.length} faults`);
  process.exit(faults.length ? 1 : 0);
})().catch((error) => {
  console.error("check-report: " + error.message);
  process.exit(1);
});
