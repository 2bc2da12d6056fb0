// SPDX-License-Identifier: MIT
// Functions of JavaScript that the library calls. An exception becomes that of the call that ran the function.
import { callbacks as table } from "./api.js";
import { arrayOf, enumName, structOf } from "./layout.js";
import { readStruct } from "./read.js";
import { bytesOf } from "./column.js";
import { ShdError, describe } from "./error.js";

const NOT_FOUND = 4, CANCELLED = 8, FAILED = 9;
const LENGTHS = { objectToWorld: 16, worldToView: 16, viewToClip: 16, eye: 3 };
const POINTERS = { attribute: "attributeCount", varying: "varyingCount" };

/** A struct of the library during a callback; columns are arrays over its memory. */
class Record {
  constructor(memory, name, address, rows) {
    const { fields } = structOf(name);
    this._memory = memory;
    this._address = address;
    this._fields = fields;
    this._cache = new Map();
    this._rows = fields.has("count") ? memory.view.getUint32(address + fields.get("count").offset, true) : rows;
  }
  _word(name) {
    if (!this._address) throw new ShdError("invalid_argument", `${name}: the program of these columns has returned`);
    return this._memory.view.getUint32(this._address + this._fields.get(name).offset, true);
  }
  _view(address, type, length) {
    return address ? this._memory.array(type, address, length) : null;
  }
  _pointers(address, count) {
    return address ? Array.from(this._memory.array(Uint32Array, address, count)) : [];
  }
  _get(name) {
    const known = this._cache.get(name);
    if (this._address && known && known.buffer === this._memory.buffer) return known.value;
    const value = this._make(name);
    this._cache.set(name, { value, buffer: this._memory.buffer });
    return value;
  }
  _make(name) {
    const field = this._fields.get(name);
    const word = this._word(name);
    if (field.kind === "number") return word;
    if (field.kind === "struct") return readStruct(this._memory, field.type, this._address + field.offset);
    if (name === "uniforms") return word;
    if (POINTERS[name]) {
      return this._pointers(word, this._word(POINTERS[name])).map((p) => this._view(p, Float32Array, this._rows));
    }
    if (name === "target") {
      const pointers = this._pointers(word, 4 * this._word("targetCount"));
      const all = pointers.map((p) => this._view(p, Float32Array, this._rows));
      return Array.from({ length: all.length / 4 }, (_, i) => all.slice(4 * i, 4 * i + 4));
    }
    if (name === "texels") return this._view(word, Uint8Array, this._word("rowStride") * this._get("area").height);
    if (name === "channel") {
      const stride = this._word("rowStride") / 4, { width, height } = this._get("area");
      return this._pointers(this._address + field.offset, 4)
        .map((p) => this._view(p, Float32Array, stride * (height - 1) + width));
    }
    return this._view(word, arrayOf(field.type), LENGTHS[name] ?? this._rows);
  }
}

const classes = new Map();

/** The class of a struct, with a getter for each field. */
function recordOf(name) {
  if (!classes.has(name)) {
    const made = class extends Record {};
    for (const field of structOf(name).list) {
      Object.defineProperty(made.prototype, field.name, { get() { return this._get(field.name); }, enumerable: true });
    }
    classes.set(name, made);
  }
  return classes.get(name);
}

/** Functions by the number that C passes as user_data. */
export class Callbacks {
  #groups = new Map();
  #next = 1;
  #memory = null;
  #raw = null;
  depth = 0;
  loads = 0;  // functions that load tiles and have not returned
  failure = null;

  start(memory, raw) {
    this.#memory = memory;
    this.#raw = raw;
  }
  /** The functions that shd.wasm imports. */
  imports() {
    return Object.fromEntries(Object.entries(table).map(([name, [, result, parameters]]) => {
      const data = parameters.findIndex(([key]) => key === "userData" || key === "taskData");
      return [name.replace(".", "_"), (...words) => this.#run(name, result, parameters, words, words[data])];
    }));
  }
  /** Groups of functions that objects or calls use. */
  get size() {
    return this.#groups.size;
  }
  address(name) {
    return this.#raw.shd_js_callback(table[name][0]);
  }
  add(functions) {
    this.#groups.set(this.#next, functions);
    return this.#next++;
  }
  remove(id) {
    this.#groups.delete(id);
  }
  #argument(name, [key, type], word, earlier, count) {
    const memory = this.#memory;
    const [kind, rest] = type.split(":");
    if (name === "load_tiles_fn") {
      const { size } = structOf(rest);
      return Array.from({ length: count }, (_, i) => new (recordOf(rest))(memory, rest, (word >>> 0) + i * size, 0));
    }
    const rows = earlier.find((e) => e instanceof Record)?._rows;
    if (kind === "list") return new (recordOf(rest))(memory, rest, word >>> 0, rows);
    if (kind === "text") return memory.text(word >>> 0);
    if (kind === "enum") return enumName(rest, word);
    if (name === "slot_fn" && key === "out") {
      const pointers = memory.array(Uint32Array, word >>> 0, 4);
      return Array.from(pointers, (p) => (p ? memory.array(Float32Array, p, rows) : null));
    }
    if (kind === "data" && rows !== undefined) return memory.array(arrayOf(rest), word >>> 0, rows);
    return word;
  }
  /** Gives C the bytes of a file, which stay until the call that asked for them returns. */
  #find(find, name, outBytes, outSize) {
    const answer = find(name), memory = this.#memory;
    if (answer === null || answer === undefined) return NOT_FOUND;
    const bytes = bytesOf(answer);
    if (!bytes) throw new TypeError(`scene.find: bytes or null for "${name}", not ${describe(answer)}`);
    const address = memory.scratch(bytes.length || 1);
    new Uint8Array(memory.buffer, address, bytes.length).set(bytes);
    memory.view.setUint32(outBytes, address, true);
    memory.view.setUint32(outSize, bytes.length, true);
    return 0;
  }
  #run(name, result, parameters, words, id) {
    const isVoid = result === "void";
    if (this.failure && name !== "log.write") return isVoid ? undefined : FAILED;
    const values = [];
    const loads = Number(name === "load_tiles_fn");
    this.depth += 1;
    this.loads += loads;
    try {
      parameters.forEach((parameter, i) => {
        const isRest = parameter[0] === "userData" || (name === "load_tiles_fn" && parameter[0] === "count");
        if (!isRest) values.push(this.#argument(name, parameter, words[i], values, words[i + 1]));
      });
      if (name === "scene_desc.find") return this.#find(this.#groups.get(id)[name], ...values);
      const returned = this.#groups.get(id)[name](...values);
      if (isVoid) return undefined;
      return name === "progress.report" && returned === false ? CANCELLED : 0;
    } catch (problem) {
      this.failure ??= { problem };
      return isVoid ? undefined : FAILED;
    } finally {
      this.depth -= 1;
      this.loads -= loads;
      for (const value of values.flat()) if (value instanceof Record) value._address = 0;
    }
  }
  /** Throws what a function threw, once the outermost call has returned. */
  throwFailure() {
    if (!this.failure || this.depth) return;
    const { problem } = this.failure;
    this.failure = null;
    throw problem;
  }
}
