// Takes the README's picture of the page: node preview.mjs PAGE NPM CHROMIUM OUT.
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [file, npm, executablePath, out] = process.argv.slice(2).map((name) => path.resolve(name));
const { chromium } = createRequire(path.join(npm, "package.json"))("playwright-core");

const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1300, height: 720 }, deviceScaleFactor: 0.64, reducedMotion: "reduce" });
await page.goto(pathToFileURL(file).href + "#friction=0.2");
await page.waitForSelector("body[data-shows]");
await page.waitForTimeout(500);
await page.screenshot({ path: out });
await browser.close();
