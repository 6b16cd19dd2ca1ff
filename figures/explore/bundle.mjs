// Makes one file of the page, its scripts and the engine: node bundle.mjs FOLDER OUT, where FOLDER
// has engine.js, engine.wasm and, in npm/, what package.json names.
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const [folder, out] = process.argv.slice(2).map((name) => path.resolve(name));
const require = createRequire(path.join(folder, "npm/package.json"));
const esbuild = require("esbuild");
const toml = require("smol-toml");

const text = (...names) => readFileSync(path.join(here, ...names), "utf8");

/// The settings of the published figures, as options; those by the published method are left out,
/// which has no events.
function figures() {
  const scenes = path.join(here, "../paper");
  return readdirSync(scenes).filter((name) => name.endsWith(".toml")).sort().map((name) => {
    const scene = toml.parse(readFileSync(path.join(scenes, name), "utf8"));
    const stated = { ...scene.parameters };
    if (scene.window?.from_s > 0) stated.from = scene.window.from_s;
    const runs = (scene.run ?? [{ name: "run" }])
      .filter((run) => run.method !== "rk4")
      .map(({ name: called, ...more }) => ({ name: called, options: optionsOf({ ...stated, ...more }) }));
    return { number: Number(name.match(/\d+/)[0]), title: scene.title, runs };
  });
}

const optionsOf = (stated) => Object.fromEntries(Object.entries(stated)
  .filter(([, value]) => value !== false)
  .map(([name, value]) => [name.replaceAll("_", "-"), value === true ? "" : String(value)]));

/// Modules that are not files, or not beside the page.
const made = {
  name: "made",
  setup(build) {
    const from = (filter, load) => {
      build.onResolve({ filter }, ({ path: name }) => ({ path: name, namespace: "made" }));
      build.onLoad({ filter, namespace: "made" }, load);
    };
    from(/^figures$/, () => ({ contents: JSON.stringify(figures()), loader: "json" }));
    from(/^printed-inputs.csv$/, () => ({ contents: text("../../reference-data/printed-inputs.csv"), loader: "text" }));
    from(/^engine.wasm$/, () => ({ contents: readFileSync(path.join(folder, "engine.wasm")), loader: "binary" }));
    from(/^worker source$/, async () => ({ contents: await script("worker.js", "iife"), loader: "text" }));
  },
};

async function script(name, format) {
  const { outputFiles } = await esbuild.build({
    entryPoints: [path.join(here, "page", name)],
    bundle: true,
    minify: true,
    format,
    target: "es2022",
    write: false,
    logOverride: { "empty-import-meta": "silent" }, // emscripten asks where it is, which is nowhere
    nodePaths: [path.join(folder, "npm/node_modules")],
    alias: { "emscripten engine": path.join(folder, "engine.js") },
    plugins: [made],
  });
  return outputFiles[0].text;
}

const licences = `<!--
This page holds, beside its own scripts (MIT): uPlot, whose licence follows; and compiled into the engine
Boost (Boost Software License), Eigen (MPL 2.0), fmt and nlohmann-json (MIT), and emscripten's C and C++
libraries (MIT; Apache 2.0 with LLVM exceptions).

${readFileSync(require.resolve("uplot/LICENSE"), "utf8").trim()}
-->`;

const style = readFileSync(require.resolve("uplot/dist/uPlot.min.css"), "utf8") + text("page/style.css");
const code = (await script("main.js", "esm")).replaceAll("</script", "<\\/script");
const page = text("page/index.html")
  .replace("/* style */", () => style)
  .replace("<!-- licences -->", () => licences)
  .replace("/* script */", () => code);
writeFileSync(out, page);
