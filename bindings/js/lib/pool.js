// SPDX-License-Identifier: MIT
// Workers that each have an instance of the library: Pool is for the page, serve() for the module of a worker.
import { compile, isNode, processors } from "./instance.js";
import { ShdError, describe, refuse } from "./error.js";

/**
 * Rows at which bands begin, so that all bands would take the time that these bands took on average. Each band has one
 * row or more. The edges stay if no time was measured: clocks of browsers are coarse.
 */
export function balance(edges, times) {
  const height = edges.at(-1);
  const total = times.reduce((sum, time) => sum + time, 0);
  if (total === 0) return [...edges];
  const made = [0];
  for (let k = 1; k < times.length; ++k) {
    let rest = (total * k) / times.length;
    let band = 0;
    while (band < times.length - 1 && rest > times[band]) rest -= times[band++];
    const part = times[band] > 0 ? rest / times[band] : 0;
    const row = Math.round(edges[band] + part * (edges[band + 1] - edges[band]));
    made.push(Math.min(height - (times.length - k), Math.max(made[k - 1] + 1, row)));
  }
  return [...made, height];
}

/** A worker of a page or of Node, and its calls. */
class Member {
  own = [];     // calls for this worker
  job = null;   // the call that it runs
  problem = null;
  constructor(worker, pool) {
    this.worker = worker;
    const receive = (data) => this.#receive(data, pool);
    const fail = (text) => this.fail(new Error(text));
    if (typeof worker.on === "function") {  // worker_threads
      worker.on("message", receive);
      worker.on("error", (problem) => this.fail(problem));
      worker.on("exit", () => fail("the worker has ended"));
      worker.unref();  // waiting workers do not keep the process
    } else {
      worker.onmessage = ({ data }) => receive(data);
      worker.onerror = (event) => fail(event.message || "the worker did not start");
    }
  }
  #receive(data, pool) {
    const { job } = this;
    if (!job) return;
    this.job = null;
    this.worker.unref?.();
    if (data.problem) job.reject(revive(data.problem));
    else job.resolve(data);
    pool.next();
  }
  run(job, module) {
    this.job = job;
    this.worker.ref?.();
    this.worker.postMessage({ module, name: job.name, values: job.values });
  }
  /** Rejects every call of the worker, also those that follow. */
  fail(problem) {
    this.problem ??= problem;
    for (const job of [this.job, ...this.own.splice(0)]) job?.reject(this.problem);
    this.job = null;
  }
}

/** An exception of a worker. */
function revive({ result, message, stack }) {
  const made = result ? new ShdError(result, message) : new Error(message);
  return Object.assign(made, { stack });
}

/**
 * Workers that run functions of a module. `start` makes one worker; `count` is the number of workers, by default that
 * of the processors, and `source` is shd.wasm as for load(). The code is compiled once.
 */
export class Pool {
  #members;
  #jobs = [];  // calls for any worker
  #module;
  #edges = new Map();  // by height of the picture
  constructor(start, { count = processors(), source } = {}) {
    if (typeof start !== "function") refuse("start", `a function that makes a Worker, not ${describe(start)}`);
    if (!Number.isInteger(count) || count < 1) refuse("count", `${count}, not 1 or more workers`);
    this.#members = [];
    this.#module = null;
    try {
      while (this.#members.length < count) this.#members.push(new Member(start(), this));
    } catch (problem) {
      this.#end(problem);
      throw problem;
    }
    compile(source).then((module) => { this.#module = module; this.next(); }, (problem) => this.#end(problem));
  }
  get count() {
    return this.#members.length;
  }
  /** Runs `name(...values)` in the next worker that is free. Arrays of the result are moved, others are copied. */
  async call(name, ...values) {
    return (await this.#ask(this.#jobs, name, values)).value;
  }
  /** Runs `name(...values)` in every worker. Returns a list with one result for each worker. */
  async all(name, ...values) {
    const answers = await Promise.all(this.#members.map(({ own }) => this.#ask(own, name, values)));
    return answers.map(({ value }) => value);
  }
  /**
   * Runs `name([first, last], ...values)` in every worker, each with other rows of 0..height. Returns a list of
   * `{rows, value, milliseconds}`. The next picture of this height has bands that take equal times.
   */
  async bands(height, name, ...values) {
    if (!Number.isInteger(height) || height < 1) refuse("height", `${height}, not 1 or more rows`);
    const members = this.#members.slice(0, height);
    const count = members.length;
    const edges = this.#edges.get(height)
      ?? Array.from({ length: count + 1 }, (_, i) => Math.round((height * i) / count));
    const rowsOf = (i) => [edges[i], edges[i + 1]];
    const bands = await Promise.all(members.map(({ own }, i) => this.#ask(own, name, [rowsOf(i), ...values])));
    const wanted = balance(edges, bands.map(({ milliseconds }) => milliseconds));
    // Half the way: times are noisy.
    this.#edges.set(height, edges.map((edge, i) => Math.round((edge + wanted[i]) / 2)));
    return bands.map(({ value, milliseconds }, i) => ({ rows: rowsOf(i), value, milliseconds }));
  }
  /** Runs `name(...values)` in the worker `index`, such as that of a band. */
  async callOn(index, name, ...values) {
    const member = this.#members[index] ?? refuse("index", `${index}, not 0..${this.count - 1}`);
    return (await this.#ask(member.own, name, values)).value;
  }
  /** Ends the workers. Calls that run are rejected. */
  close() {
    this.#end(new Error("the pool is closed"));
  }
  #ask(queue, name, values) {
    return new Promise((resolve, reject) => {
      queue.push({ name, values, resolve, reject });
      this.next();
    });
  }
  /** Ends the workers, and rejects all calls. */
  #end(problem) {
    for (const member of this.#members) {
      member.fail(problem);
      member.worker.terminate();
    }
    this.next();
  }
  /** Gives calls to the workers that are free; the workers call it. */
  next() {
    const alive = this.#members.filter(({ problem }) => !problem);
    for (const member of this.#members) if (member.problem) member.fail(member.problem);
    if (!alive.length) for (const job of this.#jobs.splice(0)) job.reject(this.#members[0].problem);
    if (!this.#module) return;
    for (const member of alive) {
      const job = member.job ? null : member.own.shift() ?? this.#jobs.shift();
      if (job) member.run(job, this.#module);
    }
  }
}
if (Symbol.dispose) Pool.prototype[Symbol.dispose] = Pool.prototype.close;

/** A view over a copy of the bytes of a view. That of a Buffer of Node is a Uint8Array, as for postMessage(). */
function copyOf(view) {
  const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength).slice();
  return view instanceof Uint8Array ? bytes : new view.constructor(bytes.buffer);
}

/** Arrays over the memory of WebAssembly are copied, and all buffers are listed: they are moved to the page. */
function pack(value, memory, buffers) {
  if (value instanceof ArrayBuffer) buffers.add(value);
  if (ArrayBuffer.isView(value)) {
    // Small Buffers of Node share one memory, which stays in the worker.
    if (value.buffer === memory.buffer || globalThis.Buffer?.isBuffer(value)) value = copyOf(value);
    if (value.buffer instanceof ArrayBuffer) buffers.add(value.buffer);
    return value;
  }
  if (Array.isArray(value)) return value.map((item) => pack(item, memory, buffers));
  if (value == null || Object.getPrototypeOf(value) !== Object.prototype) return value;
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, pack(item, memory, buffers)]));
}

/**
 * Answers the calls of a Pool; the module of a worker calls it once. `start` gets the instance of the library, and
 * returns the functions that the pool calls, or a promise of them.
 */
export function serve(start) {
  let made = null;
  const begin = async (module) => {
    const { load } = await import("./index.js");
    const shd = await load(module);
    return { shd, functions: await start(shd) };
  };
  const answer = async ({ module, name, values }) => {
    const { shd, functions } = await (made ??= begin(module));
    if (!Object.hasOwn(functions, name)) {
      throw new TypeError(`the worker has no function ${name}; there are ${Object.keys(functions).join(", ")}`);
    }
    const since = performance.now();
    const value = await functions[name](...values);
    const milliseconds = performance.now() - since;
    const buffers = new Set();
    return [{ value: pack(value, shd.memory, buffers), milliseconds }, [...buffers]];
  };
  let tail = Promise.resolve();  // calls run one after the other
  listen((data, post) => {
    tail = tail.then(() => answer(data)).then((reply) => post(...reply))
      .catch(({ result, message, stack }) => post({ problem: { result, message, stack } }));
  });
}

/** Calls `receive(data, post)` for each message of the page, or of the thread that made this one in Node. */
function listen(receive) {
  if (!isNode()) {
    globalThis.onmessage = ({ data }) => receive(data, (...reply) => globalThis.postMessage(...reply));
    return;
  }
  import("node:worker_threads").then(({ parentPort }) => {
    parentPort.on("message", (data) => receive(data, (...reply) => parentPort.postMessage(...reply)));
  });
}
