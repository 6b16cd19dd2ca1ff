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
    self.postMessage(picture, Object.values(picture.motion).map((column) => column.buffer));
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

/// Converts rows, one after the other, to arrays by the columns' names.
function columns(names, rows) {
  const count = rows.length / names.length;
  return Object.fromEntries(names.map((name, i) => {
    const column = new Float64Array(count);
    for (let row = 0; row < count; ++row) column[row] = rows[row * names.length + i];
    return [name, column];
  }));
}
