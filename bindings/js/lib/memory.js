// SPDX-License-Identifier: MIT
// The memory of WebAssembly: views, allocations, and scratch memory of calls.
import { ShdError, refuse, describe } from "./error.js";

const BLOCK = 1 << 16;
const ALIGNMENT = 16;
const texts = new TextDecoder();
const encoder = new TextEncoder();

/** An array in the memory of WebAssembly, which calls take without a copy. */
export class Allocation {
  #memory;
  #type;
  constructor(memory, type, length) {
    this.#memory = memory;
    this.#type = type;
    this.length = length;
    this.address = memory.allocate(Math.max(1, length * type.BYTES_PER_ELEMENT));
    memory.registry.register(this, this.address, this);
  }
  /** The elements. The array is valid until the memory grows; take it anew after calls that make objects. */
  get array() {
    if (!this.address) refuse("allocation", "it is closed");
    return new this.#type(this.#memory.buffer, this.address, this.length);
  }
  close() {
    if (!this.address) return;
    this.#memory.registry.unregister(this);
    this.#memory.free(this.address);
    this.address = 0;
  }
}
if (Symbol.dispose) Allocation.prototype[Symbol.dispose] = Allocation.prototype.close;

/** Views over the memory, and scratch memory that is given back in reverse order. */
export class Memory {
  #exports;
  #view = null;
  #blocks = [];
  #used = 0;
  #shared = new WeakSet();  // shared buffers from before the memory grew, which stay valid
  #failureOf;
  /** `failureOf` returns null, or the error that ends all calls. */
  constructor(exports, failureOf = () => null) {
    this.#exports = exports;
    this.#failureOf = failureOf;
    this.registry = new FinalizationRegistry((address) => this.free(address));
  }
  get buffer() {
    const { buffer } = this.#exports.memory;
    if (!(buffer instanceof ArrayBuffer)) this.#shared.add(buffer);
    return buffer;
  }
  /** A DataView of the whole memory; a new one after the memory grew. */
  get view() {
    if (this.#view?.buffer !== this.buffer) this.#view = new DataView(this.buffer);
    return this.#view;
  }
  allocate(size) {
    const failure = this.#failureOf();
    if (failure) throw failure;
    const address = size <= 0x7fffffff ? this.#exports.malloc(size) >>> 0 : 0;
    if (!address) throw new ShdError("out_of_memory", `${size} bytes could not be allocated for WebAssembly`);
    return address;
  }
  free(address) {
    if (!this.#failureOf()) this.#exports.free(address);
  }
  /** Scratch memory until release(mark()). */
  scratch(size) {
    const rounded = (size + ALIGNMENT - 1) & -ALIGNMENT;
    let block = this.#blocks.at(-1);
    if (!block || this.#used + rounded > block.size) {
      block = { size: Math.max(BLOCK, rounded), address: 0, before: this.#used };
      block.address = this.allocate(block.size);
      this.#blocks.push(block);
      this.#used = 0;
    }
    const address = block.address + this.#used;
    this.#used += rounded;
    return address;
  }
  mark() {
    return { blocks: this.#blocks.length, used: this.#used };
  }
  release(mark) {
    while (this.#blocks.length > Math.max(1, mark.blocks)) this.free(this.#blocks.pop().address);
    this.#used = mark.blocks ? mark.used : 0;
  }
  array(type, address, length) {
    return new type(this.buffer, address, length);
  }
  /** Whether a typed array lies in this memory. */
  has(array) {
    return array.buffer === this.buffer || this.#shared.has(array.buffer);
  }
  fill(address, size, byte = 0) {
    new Uint8Array(this.buffer, address, size).fill(byte);
  }
  text(address) {
    if (!address) return "";
    const bytes = new Uint8Array(this.buffer, address);
    return texts.decode(bytes.slice(0, bytes.indexOf(0)));
  }
  writeText(text, name) {
    if (typeof text !== "string") refuse(name, `a string, not ${describe(text)}`);
    const bytes = encoder.encode(text);
    const address = this.scratch(bytes.length + 1);
    const target = new Uint8Array(this.buffer, address, bytes.length + 1);
    target.set(bytes);
    target[bytes.length] = 0;
    return address;
  }
}
