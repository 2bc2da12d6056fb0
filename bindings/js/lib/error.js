// SPDX-License-Identifier: MIT
import { enums } from "./api.js";

const names = Object.fromEntries(Object.entries(enums.result).map(([name, value]) => [value, name]));

/** A call failed. `result` is "invalid_argument", "out_of_memory", ...; the message names the argument. */
export class ShdError extends Error {
  constructor(result, message) {
    super(message);
    this.name = "ShdError";
    this.result = typeof result === "number" ? (names[result] ?? String(result)).replace("error_", "") : result;
  }
}

export function refuse(name, text) {
  throw new ShdError("invalid_argument", `${name}: ${text}`);
}

/** How a value is named in a message. */
export function describe(value) {
  if (value === null || value === undefined || typeof value === "boolean"
      || typeof value === "number") return `${value}`;
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "function") return "a function";
  return `a value of type ${value.constructor?.name ?? "Object"}`;
}

/** Edits that make `b` of `a`: insertions, deletions and replacements (Levenshtein, 1966). */
function distance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j) {
      next.push(Math.min(row[j] + 1, next[j - 1] + 1, row[j - 1] + Number(a[i - 1] !== b[j - 1])));
    }
    row = next;
  }
  return row[b.length];
}

const FEW = 8;

/** What is said of an unknown name: the known names if they are few, or the most similar one. */
export function suggest(name, names) {
  if (names.length <= FEW) return `there are ${names.join(", ")}`;
  const plain = (text) => text.toLowerCase().replaceAll("_", "");
  const rated = names.map((known) => [distance(plain(name), plain(known)), known]).sort(([a], [b]) => a - b);
  const [edits, nearest] = rated[0];
  return edits <= Math.max(1, Math.floor(name.length / 3)) ? `did you mean ${nearest}?` : "lib/api.d.ts lists them";
}
