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
