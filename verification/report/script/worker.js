// Computes runs, after emscripten's script, whose function is Module. A busy worker receives no messages:
// to stop it, terminate it.

let engine;

self.onmessage = async ({ data }) => {
  if (data.wasm) {
    engine = startEngine(data);
    return;
  }
  const { explorer } = await engine;
  const onProgress = (time_s) => self.postMessage({ progress: time_s });
  const answer = explorer.run(JSON.stringify(data.options), onProgress);
  const picture = answer.metadata ? read(answer) : answer;
  self.postMessage({ answer: picture }, buffersOf(picture));
};

async function startEngine({ wasm }) {
  const module = await Module({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(wasm, imports).then(done);
      return {};
    },
  });
  const explorer = new module.Engine();
  self.postMessage({ numbers: JSON.parse(explorer.describeNumbers()) });
  return { explorer };
}

function read({ metadata, motion, works }) {
  const picture = JSON.parse(metadata);
  picture.motion = columns(picture.motion, motion);
  picture.works = columns(picture.works, works);
  return picture;
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

const buffersOf = ({ motion = {}, works = {} }) =>
  [...Object.values(motion), ...Object.values(works)].map((column) => column.buffer);
