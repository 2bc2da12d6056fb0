// SPDX-License-Identifier: MIT
// JavaScript values to structs of C. Every message names the field.
import { enums } from "./api.js";
import { arrayOf, RANGES, structOf } from "./layout.js";
import { placeData, writeColumns } from "./column.js";
import { checkPixels } from "./pixels.js";
import { Executor } from "./executor.js";
import { refuse, describe, suggest } from "./error.js";

const FACES = 6;  // of a cube
const SETTERS = { f32: "setFloat32", f64: "setFloat64", u8: "setUint8", u16: "setUint16", u32: "setUint32",
                  i32: "setInt32", u64: "setBigUint64" };

/** A number that fits a type of C. Numbers for u64 become a BigInt. */
export function numberOf(type, value, label) {
  if (typeof value === "boolean") value = Number(value);
  if (typeof value !== "number") refuse(label, `a number, not ${describe(value)}`);
  const isWord = type === "u64";
  const range = isWord ? [0, 2n ** 64n - 1n] : RANGES.get(arrayOf(type));
  if (range && !(Number.isInteger(value) && value >= range[0] && value <= range[1])) {
    refuse(label, `${value}, not an integer of ${range[0]}..${range[1]}`);
  }
  return isWord ? BigInt(value) : value;
}

function writeNumber(view, address, type, value, label) {
  view[SETTERS[type]](address, numberOf(type, value, label), true);
}

/** A constant by its name, or by several names joined by "|". */
export function enumValue(kind, value, label) {
  if (typeof value === "number" && Number.isInteger(value)) return value;
  if (Array.isArray(value)) value = value.join("|");
  if (typeof value !== "string") refuse(label, `a name, not ${describe(value)}`);
  let bits = 0;
  for (const part of value.split("|")) {
    const found = enums[kind][part.trim()];
    if (found === undefined) {
      refuse(label, `no ${kind} is ${describe(part)}; ${suggest(part, Object.keys(enums[kind]))}`);
    }
    bits |= found;
  }
  return bits;
}

function writeNumbers(call, address, field, value, label) {
  if (value === null || typeof value !== "object" || !("length" in value)) {
    refuse(label, `${field.count} numbers, not ${describe(value)}`);
  }
  const isNested = Array.isArray(value) && typeof value[0] === "object";
  const flat = isNested ? value.map((v) => Array.from(v)).flat() : value;
  if (isNested ? flat.length > field.count : flat.length !== field.count) {
    refuse(label, `${flat.length} numbers, not ${field.count}`);
  }
  const size = arrayOf(field.type).BYTES_PER_ELEMENT;
  for (let i = 0; i < flat.length; ++i) {
    writeNumber(call.memory.view, address + i * size, field.type, flat[i], `${label}[${i}]`);
  }
}

/** The address of a list of structs, columns, objects or constants. */
function writeList(call, field, value, label, state) {
  const isList = Array.isArray(value);
  if (!isList && (field.kind === "handles" || value === null || typeof value !== "object")) {
    refuse(label, `a list, not ${describe(value)}`);
  }
  const items = isList ? value : [value];
  setCount(call, state, field, items.length, label);
  if (!items.length) return 0;
  if (field.kind !== "list") {
    const address = call.allocate(4 * items.length);
    const words = items.map((item, i) => {
      const name = `${label}[${i}]`;
      if (field.kind === "numbers") return enumValue(field.type, item, name);
      return item === null ? 0 : call.handle(item, field.type, name);
    });
    words.forEach((word, i) => call.memory.view.setUint32(address + 4 * i, word, true));
    return address;
  }
  const { size } = structOf(field.type);
  const address = call.allocate(size * items.length);
  const rows = call.rowsOfLists[field.name];
  const outer = rows === undefined ? state : { counts: new Map([["count", rows]]) };
  items.forEach((item, i) => writeStruct(call, field.type, address + i * size, item, isList ? `${label}[${i}]` : label,
                                         outer));
  return address;
}

/** The elements that count as one of the length: a number, or the value of a field. */
function unitOf(call, state, field) {
  const other = state.struct.fields.get(field.unit);
  return other ? Math.max(1, call.memory.view.getUint32(state.address + other.offset, true)) : Number(field.unit);
}

/** Sets the field that has the length of a list, or compares it with an earlier list. */
function setCount(call, state, field, count, label) {
  if (!field.counter) return;
  const unit = unitOf(call, state, field);
  const units = count / unit;
  if (!Number.isInteger(units)) refuse(label, `${count} elements, not a multiple of ${unit}`);
  const known = state.counts.get(field.counter);
  if (known === undefined) {
    state.counts.set(field.counter, units);
    const counter = state.struct.fields.get(field.counter);
    writeNumber(call.memory.view, state.address + counter.offset, "u32", units, label);
  } else if (known !== units) {
    const hint = units ? "" : " (arrays over the memory of WebAssembly become empty when it grows)";
    refuse(label, `${units} elements, not ${field.counter} = ${known}${hint}`);
  }
}

function writeField(call, state, field, value, label) {
  const { memory } = call;
  const address = state.address + field.offset;
  switch (field.kind) {
    case "number":
      if (field.count > 1) return writeNumbers(call, address, field, value, label);
      return writeNumber(memory.view, address, field.type, value, label);
    case "enum":
    case "flags": {
      const list = field.count > 1 ? value : [value];
      if (list.length !== field.count) refuse(label, `${list.length} constants, not ${field.count}`);
      return list.forEach((v, i) => memory.view.setInt32(address + 4 * i, enumValue(field.type, v, label), true));
    }
    case "struct":
      return writeStruct(call, field.type, address, value, label, null);
    case "column": {
      const length = writeColumns(call, address, field, value, label);
      if (length < 0) return undefined;
      if (field.counter) return setCount(call, state, field, length, label);
      return call.checkRows(length, label);
    }
    case "data": {
      const placed = placeData(call, value, field.type, label);
      state.data.set(field.name, placed);
      setCount(call, state, field, placed.length, label);
      return memory.view.setUint32(address, placed.address, true);
    }
    case "handle":
      return memory.view.setUint32(address, call.handle(value, field.type, label), true);
    case "function":
      if (field.type === "scene_desc.find") value = finderOf(value);
      if (typeof value !== "function") refuse(label, `a function, not ${describe(value)}`);
      state.functions[field.type] = value;
      return memory.view.setUint32(address, call.module.callbacks.address(field.type), true);
    case "text":
      return memory.view.setUint32(address, memory.writeText(value, label), true);
    case "address":
      return writeNumber(memory.view, address, "u32", value, label);
    default:
      if (/_(stats|info)$/.test(field.type)) return writeStats(call, address, field, value);
      return memory.view.setUint32(address, writeList(call, field, value, label, state), true);
  }
}

/** The function that answers names of files from a Map or an object. */
function finderOf(value) {
  if (value instanceof Map) return (name) => value.get(name);
  return isPlain(value) ? (name) => (Object.hasOwn(value, name) ? value[name] : null) : value;
}

/** Statistics or properties: an object that gets their values after the call. */
function writeStats(call, address, field, value) {
  const where = call.default(field.type);
  call.memory.view.setUint32(address, where, true);
  call.after.push(() => Object.assign(value, call.read(field.type, where)));
}

// Structs of functions that an instance cannot use: it has one thread and its own memory.
const UNAVAILABLE = new Set(["allocator", "executor", "display"]);

const isPlain = (value) => value !== null && typeof value === "object" && !Array.isArray(value)
    && !ArrayBuffer.isView(value);

/** A depth or a projection that is given without a kind decides the kind of a texture. */
function completeTexture(value, label) {
  let { kind } = value;
  if (kind == null && value.depth != null && value.projection != null) {
    refuse(`${label}.kind`, "depth is of 3D textures and projection of directions; give the kind, too");
  }
  if (kind == null && value.depth != null) kind = "3d";
  if (kind == null && value.projection != null) kind = "directions";
  if (kind == null) return value;
  const { texture_kind: kinds, projection: projections } = enums;
  const isCube = enumValue("texture_kind", kind, `${label}.kind`) === kinds.directions && value.projection != null
      && enumValue("projection", value.projection, `${label}.projection`) === projections.cube;
  return isCube && (value.layerCount ?? 1) === 1 ? { ...value, kind, layerCount: FACES } : { ...value, kind };
}

/** What is not written as it stands: functions for structs with one function, kinds of textures, sources of slots. */
function complete(struct, value, label) {
  if (UNAVAILABLE.has(struct.name)) refuse(label, "not available in JavaScript");
  const first = struct.list.find((f) => f.kind === "function");
  if (typeof value === "function" && first) value = { [first.name]: value };
  if (!isPlain(value)) refuse(label, `an object with fields of ${struct.name}, not ${describe(value)}`);
  if (struct.name === "texture_desc") return completeTexture(value, label);
  if (struct.name !== "slot" || value.source !== undefined) return value;
  const source = { texture: "texture", procedure: "procedure", solid: "solid", attribute: "vertex" };
  const given = Object.keys(source).find((key) => value[key] !== undefined);
  return given ? { ...value, source: source[given] } : value;
}

function unknownField(struct, key, label) {
  const names = struct.list.map((f) => f.name).filter((n) => n !== "structSize" && n !== "userData");
  refuse(`${label}.${key}`, `${struct.name} has no such field; ${suggest(key, names)}`);
}

// Numbers first, so that lengths can be compared; lists of columns last.
const ORDER = { number: 0, enum: 1, flags: 1, column: 2, list: 4 };
const orderOf = (field) => ORDER[field.kind] ?? 3;

/** Writes a struct at `address`; fields that are not given have the library's defaults. */
export function writeStruct(call, name, address, value, label, outer) {
  const struct = structOf(name);
  if (name.endsWith("_in") || name.endsWith("_out")) {
    if (value == null) return call.memory.fill(address, struct.size);
    const [type, way] = name.split("_");
    const length = writeColumns(call, address, { type, way, count: 1 }, value, label);
    const rows = outer?.counts.get("vertexCount") ?? outer?.counts.get("count") ?? call.rows;
    if (rows !== undefined && length !== rows) refuse(label, `${length} elements, not ${rows}`);
    return undefined;
  }
  if (value instanceof Executor) return value.write(call.memory.view, address);
  value = complete(struct, value, label);
  call.writeDefault(struct, address);
  const state = { struct, address, counts: new Map(), data: new Map(), functions: {} };
  const fields = [];
  for (const key of Object.keys(value)) {
    if (value[key] === undefined) continue;
    const field = struct.fields.get(key);
    if (!field || key === "structSize" || key === "userData") unknownField(struct, key, label);
    if (value[key] !== null) fields.push(field);
  }
  fields.sort((a, b) => orderOf(a) - orderOf(b));
  for (const field of fields) {
    writeField(call, state, field, value[field.name], `${label}.${field.name}`);
    if (field.kind === "number" && field.count === 1) state.counts.set(field.name, value[field.name]);
  }
  if (state.counts.has("count")) call.rows ??= state.counts.get("count");
  checkPixels(call, struct, address, state.data, label);
  const data = struct.fields.get("userData");
  if (data && Object.keys(state.functions).length) {
    call.memory.view.setUint32(address + data.offset, call.addFunctions(state.functions), true);
  }
  return undefined;
}
