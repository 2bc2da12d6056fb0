// SPDX-License-Identifier: MIT
// Structs of C to JavaScript objects. Pointers and columns are left out, and so are lists that are not asked for.
import { arrayOf, enumName, flagNames, structOf } from "./layout.js";

function readOne(memory, field, address) {
  const { view } = memory;
  switch (field.type) {
    case "f32": return view.getFloat32(address, true);
    case "f64": return view.getFloat64(address, true);
    case "u64": return Number(view.getBigUint64(address, true));
    case "u8": return view.getUint8(address);
    case "u16": return view.getUint16(address, true);
    case "i32": return view.getInt32(address, true);
    default: return view.getUint32(address, true);
  }
}

function readField(memory, field, address) {
  switch (field.kind) {
    case "number": {
      if (field.count === 1) return readOne(memory, field, address);
      return Array.from(memory.array(arrayOf(field.type), address, field.count), Number);
    }
    case "enum": {
      const nameAt = (i) => enumName(field.type, memory.view.getInt32(address + 4 * i, true));
      const names = Array.from({ length: field.count }, (_, i) => nameAt(i));
      return field.count === 1 ? names[0] : names;
    }
    case "flags": return flagNames(field.type, memory.view.getUint32(address, true));
    case "struct": return readStruct(memory, field.type, address);
    default: return undefined;
  }
}

/** The numbers and names of a struct as an object. */
export function readStruct(memory, name, address) {
  const made = {};
  for (const field of structOf(name).list) {
    if (field.name === "structSize") continue;
    const value = readField(memory, field, address + field.offset);
    if (value !== undefined) made[field.name] = value;
  }
  return made;
}

/** Reads the structs of lists, whose lengths are those of the lists in `value`. Lists of columns stay as they are. */
export function readLists(memory, name, address, value) {
  for (const field of structOf(name).list) {
    const list = value[field.name];
    if (field.kind !== "list" || /_(in|out)$/.test(field.type) || !Array.isArray(list)) continue;
    const [first, { size }] = [memory.view.getUint32(address + field.offset, true), structOf(field.type)];
    list.forEach((item, i) => Object.assign(item, readStruct(memory, field.type, first + i * size)));
  }
}
