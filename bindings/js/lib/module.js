// SPDX-License-Identifier: MIT
// An instance of the library: its memory and references, and what users see of it.
import { invoke } from "./call.js";
import { Allocation, Memory } from "./memory.js";
import { Context as ContextObject, Environment, Light, Material, Mesh, Polyhedron, Sampler, Shadow,
    Texture, TileCache, Volume } from "./objects.js";
import { Bitmap } from "./bitmap.js";
import { Framebuffer } from "./framebuffer.js";
import { Scene } from "./scene.js";
import { ShdError, refuse } from "./error.js";

/** One instance of the library with its own memory. Objects of two instances cannot be mixed. */
class Module {
  #defaults = new Map();
  #released = [];
  constructor(callbacks, raw, threads) {
    this.callbacks = callbacks;
    this.threads = threads;
    this.raw = raw;
    this.memory = new Memory(raw, () => this.failure);
    this.registry = new FinalizationRegistry((reference) => this.release(reference));
    callbacks.start(this.memory, raw);
  }
  /** Bytes of a struct with the defaults of the library. */
  defaults(struct) {
    let bytes = this.#defaults.get(struct.name);
    if (!bytes) {
      const address = this.memory.allocate(struct.size);
      this.memory.fill(address, struct.size);
      if (struct.kind) this.raw.shd_desc_init(struct.kind, address, struct.size);
      bytes = new Uint8Array(this.memory.buffer, address, struct.size).slice();
      this.memory.free(address);
      this.#defaults.set(struct.name, bytes);
    }
    return bytes;
  }
  /** Why threads have ended, or null. No function of C may follow: it could wait for such a thread. */
  get failure() {
    return this.threads?.failure ?? null;
  }
  /** Gives a reference back; inside a program, after the call that runs it. */
  release(reference) {
    this.#released.push(reference);
    this.flush();
  }
  flush() {
    if (!this.#released.length || this.failure) return;
    while (!this.callbacks.depth && this.#released.length) this.#released.pop().close();
  }
}

const TYPES = [Int8Array, Uint8Array, Uint8ClampedArray, Int16Array, Uint16Array, Int32Array, Uint32Array, Float32Array,
               Float64Array];

/** What load() returns. `threads` has the threads of an instance with shared memory (threads.js). */
export function makeShd(callbacks, raw, threads = null) {
  const module = new Module(callbacks, raw, threads);
  class Context extends ContextObject {
    constructor(desc) { super(module, threads ? threads.contextDesc(desc) : desc); }
  }
  const shd = {
    Bitmap, Context, Environment, Framebuffer, Light, Material, Mesh, Polyhedron, Sampler, Scene, Shadow, ShdError,
    Texture, TileCache, Volume,
    /** Threads that contexts use, at most. */
    threadCount: threads?.count ?? 1,
    /** Ends the threads. Later calls of an instance with threads throw. */
    close() {
      if (callbacks.depth) refuse("close", "it may not be called inside a program");
      threads?.close();
    },
    get version() {
      const number = raw.shd_version();
      return [number >> 16, (number >> 8) & 255, number & 255].join(".");
    },
    /** An array in the memory of WebAssembly, which calls use without a copy. */
    allocate(type, length) {
      if (!TYPES.includes(type)) refuse("type", "a constructor of typed arrays, such as Float32Array");
      if (!Number.isInteger(length) || length < 0) refuse("length", `${length}, not an integer of 0 or more`);
      return new Allocation(module.memory, type, length);
    },
    /** Renders a frame, and returns its statistics. */
    render(context, desc) {
      const stats = {};
      invoke(module, "shd_render", [context, { ...desc, stats }]);
      return stats;
    },
    /** Calls a function of C by its name with JavaScript values; returns what it writes through `out_` parameters. */
    call(name, ...values) {
      return invoke(module, name, values);
    },
  };
  // Consoles do not print these: the functions of C, with addresses for pointers, and the memory.
  return Object.defineProperties(shd, { raw: { value: raw }, memory: { value: module.memory } });
}
