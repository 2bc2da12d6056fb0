// SPDX-License-Identifier: MIT
// A call of the C library with JavaScript values.
import { functions } from "./api.js";
import { arrayOf, enumName, structOf } from "./layout.js";
import { enumValue, numberOf, writeStruct } from "./write.js";
import { placeBytes } from "./column.js";
import { readLists, readStruct } from "./read.js";
import { rowsOf, rowsOfLists } from "./rows.js";
import { ShdError, describe, refuse } from "./error.js";

// Functions that a program may call.
const IN_PROGRAMS = /^shd_(texture_(sample|query_levels|explain)|solid_evaluate|format_size|last_error)$/;
// References belong to the objects; addresses are for users of `raw`.
const RAW_ONLY = /^shd_(\w+_(retain|release)|context_(allocate|free|parallel_for)|object_\w+|desc_init)$/;
// Parameters that are const structs, but whose columns or pixels are written.
const WRITTEN = new Set(["out", "levels", "mixed", "to"]);

/** What lives for one call: scratch memory, references, and copies that are made after it. */
export class Call {
  constructor(module, allocate = null) {
    this.module = module;
    this.memory = module.memory;
    this.isPrepared = allocate !== null;
    this.allocate = allocate ?? ((size) => this.memory.scratch(size));
    this.keep = [];
    this.after = [];
    this.groups = [];
    this.placed = new Map();
    this.pinned = [];  // allocations that an object borrows
    this.rows = undefined;
    this.rowsOfLists = {};
    this.isOut = false;
  }
  /** The handle of an object of this module. */
  handle(object, kind, label) {
    if (object?.kind !== kind) {
      refuse(label, `a ${kind}, not ${describe(object)}`);
    }
    const reference = object.reference(label);
    if (object.module !== this.module) refuse(label, "it belongs to another instance of shd");
    this.keep.push(reference);
    return reference.handle;
  }
  /** The number of functions for user_data. */
  addFunctions(functions) {
    const id = this.module.callbacks.add(functions);
    this.groups.push(id);
    return id;
  }
  /** Columns without a count of their own have as many elements as the lookups of the call. */
  checkRows(length, label) {
    if (this.rows === undefined) this.rows = length;
    else if (length !== this.rows) refuse(label, `${length} elements, not ${this.rows}`);
  }
  writeDefault(struct, address) {
    new Uint8Array(this.memory.buffer, address, struct.size).set(this.module.defaults(struct));
  }
  /** A struct with its defaults. */
  default(name) {
    const struct = structOf(name);
    const address = this.allocate(struct.size);
    this.writeDefault(struct, address);
    return address;
  }
  read(name, address) {
    return readStruct(this.memory, name, address);
  }
  /** A struct from a value. */
  struct(name, value, label) {
    const address = this.allocate(structOf(name).size);
    writeStruct(this, name, address, value, label, null);
    return address;
  }
  finish() {
    for (const copy of this.after) copy();
  }
}

/** Words for the parameters of a function, and what is returned after it. */
class Arguments {
  constructor(call, entry, values) {
    this.call = call;
    this.words = [];
    this.results = [];
    const queue = [...values];
    for (const [key, word, length] of entry[1]) {
      const [kind, type] = word.split(":");
      const isResult = kind === "new" || kind === "read" || kind === "write";
      this.words.push(isResult ? this.result(key, kind, type, length) : this.argument(key, kind, type, length, queue));
    }
    if (queue.length) throw new TypeError(`${queue.length} arguments too many`);
  }
  result(key, kind, type, length) {
    const { call } = this;
    if (kind === "read") {
      const address = call.default(type);
      this.results.push([key, () => call.read(type, address)]);
      return address;
    }
    const array = kind === "new" ? Uint32Array : arrayOf(type);
    const address = call.allocate(array.BYTES_PER_ELEMENT * (length ?? 1));
    const read = () => Array.from(call.memory.array(array, address, length ?? 1));
    this.results.push([key, () => (length > 1 ? array.from(read()) : read()[0])]);
    return address;
  }
  argument(key, kind, type, length, queue) {
    const { call } = this;
    if (kind === "size") return this.size;
    const value = queue.shift();
    const list = () => (Array.isArray(value) ? value : [value]);
    call.isOut = WRITTEN.has(key);
    switch (kind) {
      case "handle": return call.handle(value, type, key);
      case "enum": case "flags": return enumValue(type, value ?? 0, key);
      case "numbers": return this.numbers(key, type, length, value);
      case "text": return call.memory.writeText(value, key);
      case "in": return value == null ? 0 : this.structs(type, list(), key);
      case "inout": return this.inout(type, value, key);
      case "bytes": {
        const placed = placeBytes(call, value, key);
        this.size = placed.size;
        return placed.address;
      }
      default: return numberOf(kind, value, key);
    }
  }
  numbers(key, type, length, value) {
    const numbers = Array.from(value ?? []);
    if (numbers.length !== length || numbers.some((n) => typeof n !== "number")) {
      refuse(key, `${length} numbers, not ${describe(value)}${numbers.length ? ` of ${numbers.length}` : ""}`);
    }
    const address = this.call.allocate(length * arrayOf(type).BYTES_PER_ELEMENT);
    this.call.memory.array(arrayOf(type), address, length).set(numbers);
    return address;
  }
  structs(type, values, key) {
    const { size } = structOf(type);
    const address = this.call.allocate(size * values.length);
    values.forEach((value, i) => {
      const label = values.length > 1 ? `${key}[${i}]` : key;
      writeStruct(this.call, type, address + i * size, value, label, null);
    });
    return address;
  }
  /** A struct that the library reads and writes: numbers that it writes become fields of the value, and of its lists. */
  inout(type, value, key) {
    const address = this.call.struct(type, value, key);
    this.call.after.push(() => {
      Object.assign(value, this.call.read(type, address));
      readLists(this.call.memory, type, address, value);
    });
    return address;
  }
}

function check(module, result, name) {
  module.callbacks.throwFailure();
  if (result === 0) return;
  throw new ShdError(result, module.memory.text(module.raw.shd_last_error() >>> 0) || `${name} failed`);
}

/** Calls a function of C by name. Returns what it writes through its out parameters; `made` gets the Call. */
export function invoke(module, name, values, made = null) {
  const entry = functions[name];
  if (!entry) throw new TypeError(`libshd has no function ${name}`);
  if (RAW_ONLY.test(name)) refuse(name, "only shd.raw has it; objects have close()");
  if (module.callbacks.depth && !IN_PROGRAMS.test(name)) refuse(name, "it may not be called inside a program");
  // It could wait for a tile of a thread that waits for the function.
  if (module.callbacks.loads && module.threads) {
    refuse(name, "a function that loads tiles may not call it in an instance with threads");
  }
  if (!module.raw[name]) throw new ShdError("unsupported", `${name}: this build of shd.wasm reads no files`);
  const { failure } = module;
  if (failure) throw failure;
  const rows = rowsOf(name, values);
  const mark = module.memory.mark();
  const call = new Call(module);
  call.rows = rows;
  call.rowsOfLists = rowsOfLists(name, values);
  let isDone = false;
  try {
    const { words, results } = new Arguments(call, entry, values);
    const returned = module.raw[name](...words);
    if (entry[0] === "shd_result") check(module, returned, name);
    call.finish();
    made?.(call);
    isDone = true;
    if (entry[0] === "text") return module.memory.text(returned >>> 0);
    if (entry[0] === "u32") return returned >>> 0;
    if (entry[0] !== "shd_result") return returned;
    if (results.length === 1) return results[0][1]();
    return results.length ? Object.fromEntries(results.map(([key, read]) => [key, read()])) : undefined;
  } catch (problem) {
    throw module.failure ?? problem;
  } finally {
    if (!isDone || !made) for (const id of call.groups) module.callbacks.remove(id);
    if (!module.failure) {
      module.memory.release(mark);
      module.flush();
    }
  }
}

export { check, enumName };
