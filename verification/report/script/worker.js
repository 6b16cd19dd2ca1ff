// Computes runs, after emscripten's script, whose function is Module.

let engine;

self.onmessage = async ({ data }) => {
  if (data.wasm) {
    engine = startEngine(data);
    return;
  }
  const { metadata, motion, refusal } = (await engine).run(JSON.stringify(data.options));
  if (refusal) self.postMessage({ refusal });
  else {
    const picture = JSON.parse(metadata);
    picture.motion = columns(picture.motion, motion);
    self.postMessage(
      picture,
      Object.values(picture.motion).map((column) => column.buffer),
    );
  }
};

async function startEngine({ wasm }) {
  const module = await Module({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(wasm, imports).then(done);
      return {};
    },
  });
  return new module.Engine();
}

/// Rows, one after the other, as arrays by the columns' names.
const columns = (names, rows) =>
  Object.fromEntries(
    names.map((name, i) => [
      name,
      Float64Array.from(
        { length: rows.length / names.length },
        (_, row) => rows[row * names.length + i],
      ),
    ]),
  );
