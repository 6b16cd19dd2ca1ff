// The page's side of a worker: the newest request wins.

const textOf = (id) => document.getElementById(id)?.textContent ?? null;

/// Whether the page has the engine.
export const isEmbedded = () => textOf("engine-wasm") !== null;

let compiled = null, workerAddress = null; // shared by all workers
async function compile() {
  const packed = Uint8Array.from(atob(textOf("engine-wasm")), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

// A run takes some 30 ms; a new worker takes as long, and must run up again. A worker that has been busy
// for less than this is not replaced.
const patience_ms = 200;

export class Engine {
  #worker = null;
  #started; // resolves when the worker has its module
  #asked = null; // the request in progress
  #next = null; // the request after that
  #patience = 0;
  #hear;

  /// Reports the progress of a long run, s; once, the inputs that can be stated; and the reason if the
  /// engine cannot run.
  constructor({ onProgress = () => {}, onNumbers = () => {}, onFailure = () => {} } = {}) {
    this.#hear = { onProgress, onNumbers, onFailure };
    this.#start();
  }

  /// An answer, or null if a newer request replaced it.
  ask(options) {
    return new Promise((resolve) => {
      this.#next?.resolve(null);
      this.#next = { options, resolve };
      if (!this.#asked) this.#send();
      else this.#patience ||= setTimeout(() => this.#restart(), patience_ms);
    });
  }

  #start() {
    workerAddress ??= URL.createObjectURL(new Blob([textOf("engine-worker")], { type: "text/javascript" }));
    compiled ??= compile();
    const worker = new Worker(workerAddress);
    worker.onmessage = ({ data }) => {
      if (data.numbers) this.#hear.onNumbers(data.numbers);
      else if (data.answer) this.#finish(data.answer);
      else this.#hear.onProgress(data.progress, this.#asked?.options);
    };
    worker.onerror = ({ message }) => this.#asked && this.#finish({ refusal: message });
    this.#worker = worker;
    this.#started = compiled.then((wasm) => worker.postMessage({ wasm }));
    this.#started.catch((error) => this.#hear.onFailure(error.message));
  }

  #restart() {
    this.#worker.terminate();
    this.#start();
    this.#finish(null);
  }

  #send() {
    this.#asked = this.#next;
    this.#next = null;
    const worker = this.#worker;
    this.#started.then(() => worker.postMessage({ options: this.#asked.options }));
  }

  #finish(answer) {
    clearTimeout(this.#patience);
    this.#patience = 0;
    const { resolve } = this.#asked;
    this.#asked = null;
    if (this.#next) this.#send();
    resolve(answer);
  }
}
