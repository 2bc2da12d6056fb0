// SPDX-License-Identifier: MIT
// Columns and other numbers behind pointers: arrays in the memory of WebAssembly are used in place, others are copied.
import { arrayOf, RANGES } from "./layout.js";
import { Allocation } from "./memory.js";
import { refuse, describe } from "./error.js";

const isTyped = (value) => ArrayBuffer.isView(value) && !(value instanceof DataView);

/** A copy of numbers with another type of elements. Integers are in the range of the type. */
function converted(values, type, label) {
  const range = RANGES.get(type);
  const isGood = range ? (v) => Number.isInteger(v) && v >= range[0] && v <= range[1] : (v) => typeof v === "number";
  const bad = values.findIndex((v) => !isGood(v));
  if (bad >= 0) {
    const wanted = range ? `an integer of ${range[0]}..${range[1]}` : "a number";
    refuse(`${label}[${bad}]`, `${wanted}, not ${describe(values[bad])}`);
  }
  return type.from(values);
}

/** Whether the numbers of an array mean the same as elements of `type`; those of other arrays may need a scale. */
function isConvertible(value, type) {
  if (Array.isArray(value)) return true;
  const isInteger = /^(Int|Uint)(8|16|32)Array$/.test(value?.constructor?.name ?? "");
  return RANGES.has(type) ? isInteger : value instanceof Float64Array;
}

/** A typed array of a value, which may be an allocation or, for input, a list of numbers or another typed array. */
function typed(value, type, isOut, label) {
  if (value instanceof Allocation) value = value.array;
  if (value instanceof type) return value;
  if (!isOut && isConvertible(value, type)) return converted(value, type, label);
  const cure = isTyped(value) && !isOut ? `; ${type.name}.from(values) converts it` : "";
  return refuse(label, `a ${type.name}, not ${describe(value)}${cure}`);
}

/** The address of an array. An array elsewhere is copied to the call's memory; output is copied back after the call. */
export function place(call, array, isOut, isWhole) {
  const { memory } = call;
  if (memory.has(array)) return array.byteOffset;
  if (call.isPrepared) refuse(call.label, "arrays of a prepared lookup must be made by allocate()");
  if (!array.byteLength) return 0;  // also the state of an array over memory that grew
  if (call.placed.has(array)) return call.placed.get(array);  // several columns of one array
  const address = call.allocate(array.byteLength);
  call.placed.set(array, address);
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  if (!isOut || !isWhole) new Uint8Array(memory.buffer, address, bytes.length).set(bytes);
  if (isOut) call.after.push(() => bytes.set(new Uint8Array(memory.buffer, address, bytes.length)));
  return address;
}

/** One column: {address, stride, length}. A value is an array, or {data, offset, stride} in elements. */
function single(call, value, word, isOut, label) {
  const type = arrayOf(word);
  const isStrided = value !== null && typeof value === "object" && "data" in value && !isTyped(value);
  const { offset = 0, stride = 1 } = isStrided ? value : {};
  const array = typed(isStrided ? value.data : value, type, isOut, label);
  if (!Number.isInteger(stride) || stride < 1) refuse(`${label}.stride`, `${stride}, not 1 or more elements`);
  if (!Number.isInteger(offset) || offset < 0 || offset > array.length) {
    refuse(`${label}.offset`, `${offset}, not 0..${array.length} elements`);
  }
  call.label = label;
  const address = place(call, array, isOut, !isStrided) + offset * type.BYTES_PER_ELEMENT;
  return { address, stride: stride * type.BYTES_PER_ELEMENT, length: Math.ceil((array.length - offset) / stride) };
}

/** Columns of a vector: one interleaved array, or a list of columns of which some may be null. */
function vector(call, value, field, isOut, label) {
  const isList = Array.isArray(value) && typeof value[0] !== "number";
  if (isList) {
    if (value.length > field.count) refuse(label, `${value.length} columns, not ${field.count}`);
    return value.map((v, i) => (v == null ? null : single(call, v, field.type, isOut, `${label}[${i}]`)));
  }
  const whole = single(call, value, field.type, isOut, label);
  const size = arrayOf(field.type).BYTES_PER_ELEMENT;
  if (whole.stride === size && whole.length % field.count) {
    refuse(label, `${whole.length} elements, not a multiple of ${field.count}`);
  }
  const isPacked = whole.stride === size;
  const rows = isPacked ? whole.length / field.count : whole.length;
  return Array.from({ length: field.count }, (_, i) => ({
    address: whole.address + i * size, stride: isPacked ? field.count * size : whole.stride, length: rows,
  }));
}

/** Writes the columns of a field, and returns their common length. */
export function writeColumns(call, address, field, value, label) {
  const isOut = field.way === "out";
  const columns = field.count > 1 ? vector(call, value, field, isOut, label)
                                  : [single(call, value, field.type, isOut, label)];
  let length = -1;
  columns.forEach((column, i) => {
    if (!column) return;
    if (length >= 0 && column.length !== length) refuse(`${label}[${i}]`, `${column.length} elements, not ${length}`);
    length = column.length;
    call.memory.view.setUint32(address + 8 * i, column.address, true);
    call.memory.view.setUint32(address + 8 * i + 4, column.stride, true);
  });
  return length;
}

/** The bytes of a file as an array, or null if a value has none. */
export function bytesOf(value) {
  if (value instanceof Allocation) value = value.array;
  if (value instanceof ArrayBuffer) return new Uint8Array(value);
  return ArrayBuffer.isView(value) ? new Uint8Array(value.buffer, value.byteOffset, value.byteLength) : null;
}

/** The address and size of the bytes of a file. */
export function placeBytes(call, value, label) {
  const bytes = bytesOf(value) ?? refuse(label, `a Uint8Array or an ArrayBuffer, not ${describe(value)}`);
  call.label = label;
  return { address: place(call, bytes, false, true) || call.allocate(1), size: bytes.length };
}

/** The address and length of numbers or bytes. `void *` takes any typed array. */
export function placeData(call, value, word, label) {
  const allocation = value instanceof Allocation ? value : null;
  if (allocation) value = value.array;
  if (value instanceof ArrayBuffer) value = new Uint8Array(value);
  const isBytes = word === "u8" && isTyped(value);
  const array = isBytes ? value : typed(value, arrayOf(word), call.isOut, label);
  call.label = label;
  return { address: place(call, array, call.isOut, true), length: array.length, bytes: array.byteLength,
           allocation };
}
