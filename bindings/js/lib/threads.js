// SPDX-License-Identifier: MIT
// shd with threads: Web Workers over one shared memory. `import { load } from "shd/threads"`.
import { Callbacks } from "./callback.js";
import { compile, isNode, processors } from "./instance.js";
import { load as loadOneThread } from "./index.js";
import { makeShd } from "./module.js";
import { Executor } from "./executor.js";
import { describe, refuse } from "./error.js";
import { callbacks as table } from "./api.js";

const PAGE = 65536, FIRST_PAGES = 512, MOST_PAGES = 32768;  // of the link in CMakeLists.txt
const MOST_THREADS = 64;
// s_pool and struct mailbox of threads.c, in words of 32 bits
const SIGNAL = 0, REQUESTS = 1, STOPPED = 4, FIRST_MAILBOX = 6, MAILBOX = 18, WORDS = 2;
const TEXT = 64;  // bytes of `words` in a mailbox
const WAITING = 1, ANSWERED = 2;

/** Whether memory can be shared: in Node, and in pages that are isolated by their headers. */
export const hasThreads = () => typeof SharedArrayBuffer === "function"
  && (isNode() || globalThis.crossOriginIsolated === true);

/** The functions that a module with threads imports; the others of Emscripten are never called. */
export function threadImports(module, memory, known) {
  const imports = {};
  for (const { module: from, name, kind } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    if (kind !== "function") continue;
    imports[from][name] = known[name] ?? (() => { throw new Error(`shd-threads.wasm called ${name}`); });
  }
  imports.env.memory = memory;
  return imports;
}

/** Functions of the system, which every thread has. */
export function systemFunctions(memory) {
  const clock = (kind, address) => {  // struct timespec
    const now = performance.now(), seconds = Math.floor(now / 1000);
    new Int32Array(memory.buffer, address, 2).set([seconds, Math.floor((now - 1000 * seconds) * 1e6)]);
    return 0;
  };
  return {
    emscripten_get_now: () => performance.now(),
    emscripten_resize_heap(size) {
      const missing = Math.ceil(((size >>> 0) - memory.buffer.byteLength) / PAGE);
      try {
        if (missing > 0) memory.grow(missing);
        return 1;
      } catch {
        return 0;
      }
    },
    emscripten_memcpy_big(to, from, count) {
      new Uint8Array(memory.buffer).copyWithin(to >>> 0, from >>> 0, (from >>> 0) + (count >>> 0));
    },
    emscripten_check_blocking_allowed() {},
    clock_gettime: clock, __clock_gettime: clock,
    _emscripten_default_pthread_stack_size: () => 2 * 1024 * 1024,
    setTempRet0() {},
  };
}

const names = Object.keys(table).map((name) => name.replace(".", "_"));
const lengths = new Map(Object.values(table).map(([, , parameters], i) => [names[i], parameters.length]));

/** Functions for a thread: each waits until the calling thread has run the function of that name. */
export function forwardingImports(memory, address, index) {
  const mailbox = address / 4 + FIRST_MAILBOX + index * MAILBOX;
  return Object.fromEntries(names.map((name, i) => [name, (...values) => {
    const words = new Int32Array(memory.buffer);
    words[mailbox + 1] = i;
    new Float64Array(memory.buffer, 4 * (mailbox + WORDS), values.length).set(values);
    Atomics.store(words, mailbox, WAITING);
    Atomics.add(words, address / 4 + REQUESTS, 1);
    Atomics.add(words, address / 4 + SIGNAL, 1);
    Atomics.notify(words, address / 4 + SIGNAL);
    while (Atomics.load(words, mailbox) === WAITING) Atomics.wait(words, mailbox, WAITING);
    return new Float64Array(memory.buffer, 4 * (mailbox + WORDS), 1)[0];
  }]));
}

/** Ends the call that waits for thread `index`, which `problem` has stopped; its mailbox has the text. */
export function reportStop(memory, address, index, problem) {
  const words = new Int32Array(memory.buffer);
  const mailbox = address / 4 + FIRST_MAILBOX + index * MAILBOX;
  const text = new Uint8Array(memory.buffer, 4 * (mailbox + WORDS), TEXT).fill(0);
  text.set(new TextEncoder().encode(`${problem}`).subarray(0, TEXT));
  Atomics.compareExchange(words, address / 4 + STOPPED, 0, index);
  Atomics.add(words, address / 4 + SIGNAL, 1);
  Atomics.notify(words, address / 4 + SIGNAL);
}

/** An error for thread `index`, which has stopped. */
function stopOf(memory, address, index) {
  const mailbox = address / 4 + FIRST_MAILBOX + index * MAILBOX;
  const bytes = new Uint8Array(memory.buffer, 4 * (mailbox + WORDS), TEXT).slice();
  const text = new TextDecoder().decode(bytes).replace(/\0+$/, "");
  return new Error(`thread ${index} has stopped (${text}); another load() makes a new instance`);
}

/** Runs the functions that threads wait for. */
function answer(memory, address, callbacks) {
  const words = new Int32Array(memory.buffer);
  for (let index = 0; index < MOST_THREADS; ++index) {
    const mailbox = address / 4 + FIRST_MAILBOX + index * MAILBOX;
    if (Atomics.load(words, mailbox) !== WAITING) continue;
    const name = names[words[mailbox + 1]];
    const values = new Float64Array(memory.buffer, 4 * (mailbox + WORDS), lengths.get(name));
    values[0] = callbacks[name](...values) ?? 0;
    Atomics.store(words, mailbox, ANSWERED);
    Atomics.notify(words, mailbox);
  }
}

/** A Web Worker, or a thread of Node, that runs thread.js. */
async function startWorker() {
  if (!isNode()) return new Worker(new URL("./thread.js", import.meta.url), { type: "module" });
  const { Worker: NodeWorker } = await import("node:worker_threads");
  return new NodeWorker(new URL("./thread.js", import.meta.url), { execArgv: [] });
}

/** Resolves when the worker runs its thread. It answers null, or the text of a problem. */
function begin(worker, message) {
  return new Promise((resolve, reject) => {
    const receive = (problem) => (problem === null ? resolve() : reject(new Error(problem)));
    if (worker.on) {
      worker.once("message", (problem) => { worker.unref(); receive(problem); });
      worker.on("error", reject);
    } else {
      worker.onmessage = ({ data }) => receive(data);
      worker.onerror = (event) => reject(new Error(event.message || "a thread did not start"));
    }
    worker.postMessage(message);
  });
}

/** The threads of an instance. */
class Threads {
  #raw;
  #workers;
  #stopped;
  #closed = null;
  constructor(raw, workers) {
    this.#raw = raw;
    this.#workers = workers;
    this.#stopped = new Int32Array(raw.memory.buffer, raw.shd_js_mailboxes() + 4 * STOPPED, 1);
    this.count = workers.length + 1;
  }
  /** A desc whose context uses the threads. workerCount: 0 = all of them, 1 = none beside the calling thread. */
  contextDesc(desc = {}) {
    const { workerCount = 0, ...others } = desc ?? {};
    const isPlain = Number.isInteger(workerCount) && workerCount >= 0 && workerCount <= 1024 && !others.executor;
    if (!isPlain || workerCount === 1 || this.count === 1) return desc;
    const workers = Math.min(workerCount || this.count, this.count);
    return { ...others, executor: new Executor(this.#raw.shd_js_executor(), workers) };
  }
  /** An error if a thread has stopped or close() has ended them, or null. */
  get failure() {
    if (this.#closed) return this.#closed;
    const index = Atomics.load(this.#stopped, 0);
    return index ? stopOf(this.#raw.memory, this.#raw.shd_js_mailboxes(), index) : null;
  }
  close() {
    if (this.count > 1) this.#closed ??= new Error("shd is closed: its threads have ended");
    for (const worker of this.#workers.splice(0)) worker.terminate();
  }
}

/** Starts `count` workers for threads that pthread_create() makes. If one fails, all of them are ended. */
export async function startThreads(module, memory, raw, made, count, makeWorker = startWorker) {
  const mayWait = isNode() || typeof document === "undefined";
  const workers = [];
  try {
    while (workers.length < count) workers.push(await makeWorker());
    const messages = workers.map((_, i) => {
      if (raw.shd_js_start_thread(i + 1, Number(mayWait))) refuse("threads", `thread ${i + 1} could not be made`);
      const { thread, start, argument } = made.pop();
      return { module, memory, thread, start, argument, index: i + 1, mailboxes: raw.shd_js_mailboxes(),
               stackTop: raw.shd_js_stack_top(thread) };
    });
    await Promise.all(workers.map((worker, i) => begin(worker, messages[i])));
    return new Threads(raw, workers);
  } catch (problem) {
    for (const worker of workers) worker.terminate();
    throw problem;
  }
}

/**
 * Loads shd-threads.wasm with `threads` threads, the calling one included. Where memory cannot be shared, the instance
 * has one thread and is that of shd.wasm. `source` and `oneThread` are these two files, as for load() of "shd".
 */
export async function load({ threads = Math.min(processors(), MOST_THREADS), source, oneThread } = {}) {
  if (!Number.isInteger(threads) || threads < 1 || threads > MOST_THREADS) {
    refuse("threads", `${describe(threads)}, not 1..${MOST_THREADS}`);
  }
  if (!hasThreads()) return loadOneThread(oneThread);
  const memory = new WebAssembly.Memory({ initial: FIRST_PAGES, maximum: MOST_PAGES, shared: true });
  const module = await compile(source ?? new URL("./shd-threads.wasm", import.meta.url));
  const callbacks = new Callbacks();
  const functions = callbacks.imports();
  const made = [];  // threads of pthread_create() whose workers do not run yet
  let raw = null;
  const known = {
    ...systemFunctions(memory), ...functions,
    answer: () => answer(memory, raw.shd_js_mailboxes(), functions),
    has_functions: () => Number(callbacks.size > 0),
    __pthread_create_js(thread, attributes, start, argument) {
      made.push({ thread, start, argument });
      return 0;
    },
    __emscripten_init_main_thread_js(thread) {
      const isPage = typeof document !== "undefined";
      raw._emscripten_thread_init(thread, Number(isPage), 1, Number(!isPage));
    },
  };
  const { exports } = await WebAssembly.instantiate(module, threadImports(module, memory, known));
  raw = { ...exports, memory };
  raw.emscripten_tls_init();
  raw.__wasm_call_ctors();
  const started = await startThreads(module, memory, raw, made, threads - 1);
  return makeShd(callbacks, raw, started);
}
