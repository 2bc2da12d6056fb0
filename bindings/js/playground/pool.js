// SPDX-License-Identifier: MIT
// Workers that draw one band of rows each. Every worker has its own instance of the library.

/** Rows at which bands begin, so that all bands take the time that the last frame took on average. */
export function balance(edges, times, height) {
  const total = times.reduce((sum, time) => sum + time, 0);
  const made = [0];
  for (let k = 1; k < times.length; ++k) {
    let rest = (total * k) / times.length;
    let band = 0;
    while (band < times.length - 1 && rest > times[band]) rest -= times[band++];
    const part = times[band] > 0 ? rest / times[band] : 0;
    const row = Math.round(edges[band] + part * (edges[band + 1] - edges[band]));
    made.push(Math.min(height - 1, Math.max(made[k - 1] + 1, row)));
  }
  return [...made, height];
}

/** Compiles shd.wasm once for all workers, which share the code. */
async function compile() {
  const response = await fetch(new URL("../lib/shd.wasm", import.meta.url));
  if (!response.ok) throw new Error(`shd.wasm: ${response.status}. Build it and copy it to lib/`);
  return WebAssembly.compile(await response.arrayBuffer());
}

export class Pool {
  #workers;
  #waiting = new Map();
  #module = compile();
  #next = 1;
  #edges = new Map();  // by height of the picture
  constructor(count) {
    this.#workers = Array.from({ length: count }, () => {
      const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }) => {
        const { resolve, reject } = this.#waiting.get(data.id);
        this.#waiting.delete(data.id);
        if (data.problem) reject(new Error(data.problem));
        else resolve(data);
      };
      worker.onerror = (event) => {
        for (const { reject } of this.#waiting.values()) reject(new Error(event.message || "a worker did not start"));
        this.#waiting.clear();
      };
      return worker;
    });
  }
  async #ask(worker, message) {
    const id = this.#next++;
    const module = await this.#module;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      worker.postMessage({ id, module, ...message });
    });
  }
  /** Draws a state: bands of pixels, and the milliseconds of the slowest band. */
  async draw(state) {
    const height = Number(state.size.split("x")[1]);
    const count = this.#workers.length;
    const equal = () => Array.from({ length: count + 1 }, (_, i) => Math.round((height * i) / count));
    const edges = this.#edges.get(height) ?? equal();
    const bands = await Promise.all(this.#workers.map((worker, i) =>
      this.#ask(worker, { state, rows: [edges[i], edges[i + 1]] })));
    const times = bands.map((band) => band.milliseconds);
    const wanted = balance(edges, times, height);
    // Half the way: times are noisy.
    this.#edges.set(height, edges.map((edge, i) => Math.round((edge + wanted[i]) / 2)));
    const fragments = bands.reduce((sum, band) => sum + band.fragments, 0);
    return { bands, edges, size: state.size, milliseconds: Math.max(...times), fragments };
  }
  /** The footprint of a pixel of a frame that draw() returned. */
  async footprint({ edges }, x, y) {
    const worker = this.#workers.findLast((_, i) => edges[i] <= y);
    return (await this.#ask(worker, { pointer: { x, y } })).footprint;
  }
  get count() {
    return this.#workers.length;
  }
}
