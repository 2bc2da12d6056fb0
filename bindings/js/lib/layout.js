// SPDX-License-Identifier: MIT
// The packed words of api.js as objects, each made when it is first used.
import * as api from "./api.js";

const NUMBERS = {
  f32: Float32Array, f64: Float64Array, u8: Uint8Array, u16: Uint16Array, u32: Uint32Array, i32: Int32Array,
  u64: BigUint64Array,
};

/** The typed array of a word for numbers, such as f32. */
export const arrayOf = (word) => NUMBERS[word];

/** The smallest and the largest integer that a typed array holds; others hold any number. */
export const RANGES = new Map([
  [Uint8Array, [0, 255]], [Uint16Array, [0, 65535]], [Uint32Array, [0, 4294967295]],
  [Int32Array, [-2147483648, 2147483647]],
]);

/** A field: kind and name of its type, offset, number of elements, and the field that has its length. */
function unpackField(name, [offset, word, count = 1, rows = ""]) {
  const [kind, type = "", way = ""] = word.split(":");
  const [counter, unit = "1"] = rows.split("*");  // the unit is a number, or the name of a field
  return { name, offset, kind: NUMBERS[kind] ? "number" : kind, type: NUMBERS[kind] ? kind : type, way, count, counter,
           unit };
}

const structs = new Map();

/** A struct: size, kind for shd_desc_init(), and fields by name. */
export function structOf(name) {
  let made = structs.get(name);
  if (!made) {
    const { size, align, kind, fields } = api.structs[name];
    const list = Object.entries(fields).map(([key, packed]) => unpackField(key, packed));
    made = { name, size, align, kind, list, fields: new Map(list.map((f) => [f.name, f])) };
    structs.set(name, made);
  }
  return made;
}

const names = new Map();

/** Names of an enum's values. */
function namesOf(kind) {
  if (!names.has(kind)) names.set(kind, new Map(Object.entries(api.enums[kind]).map(([k, v]) => [v, k])));
  return names.get(kind);
}

/** A constant's name, or its number if it has no name. */
export const enumName = (kind, value) => namesOf(kind).get(value) ?? value;

/** Names of the bits, joined by "|". */
export function flagNames(kind, value) {
  const exact = namesOf(kind).get(value);
  if (exact) return exact;
  const single = [...namesOf(kind)].filter(([bit]) => bit && !(bit & (bit - 1)) && value & bit);
  return single.map(([, name]) => name).join("|");
}
