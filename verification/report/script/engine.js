// The page's side of the worker: the newest request wins.

const textOf = (id) => document.getElementById(id)?.textContent ?? null;

/// Whether the page has the engine.
export const isEmbedded = () => textOf("engine-wasm") !== null;

async function compiled() {
  const packed = Uint8Array.from(atob(textOf("engine-wasm")), (letter) => letter.charCodeAt(0));
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
}

const patience_ms = 1000; // with a run whose answer is no longer wanted

export class Engine {
  #module = compiled();
  #worker;
  #started; // resolves when the worker has its module
  #asked = null; // the request in progress
  #asked_ms = 0;
  #next = null; // the request after that

  constructor() {
    this.#start();
  }

  #start() {
    const worker = new Worker(
      URL.createObjectURL(new Blob([textOf("engine-worker")], { type: "text/javascript" })),
    );
    worker.onmessage = ({ data }) => this.#finish(data);
    worker.onerror = ({ message }) => this.#asked && this.#finish({ refusal: message });
    this.#worker = worker;
    this.#started = this.#module.then((wasm) => worker.postMessage({ wasm }));
  }

  /// An answer, or null if a newer request replaced it. A run that lasts is ended then.
  ask(options) {
    return new Promise((resolve) => {
      this.#next?.resolve(null);
      this.#next = { options, resolve };
      if (this.#asked && performance.now() - this.#asked_ms > patience_ms) {
        this.#worker.terminate();
        this.#start();
        this.#finish(null);
      } else if (!this.#asked) this.#send();
    });
  }

  #send() {
    this.#asked = this.#next;
    this.#asked_ms = performance.now();
    this.#next = null;
    this.#started.then(
      () => this.#worker.postMessage({ options: this.#asked.options }),
      (error) => this.#finish({ refusal: `this browser cannot run the engine: ${error.message}` }),
    );
  }

  #finish(answer) {
    const { resolve } = this.#asked;
    this.#asked = null;
    if (this.#next) this.#send();
    resolve(answer);
  }
}
