// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { load, ShdError } from "../lib/index.js";

export { ShdError };

const cases = [];

/** Registers a test; each has its own instance of the library. */
export function test(name, body) {
  cases.push([name, body]);
}

test.run = async () => {
  const module = await WebAssembly.compile(await (await import("node:fs/promises")).readFile(
    process.env.SHD_WASM ?? new URL("../lib/shd.wasm", import.meta.url)));
  let failed = 0;
  for (const [name, body] of cases) {
    try {
      const shd = await load(module);
      await body(shd, new shd.Context());
      console.log(`ok ${name}`);
    } catch (problem) {
      failed += 1;
      console.log(`FAILED ${name}\n${problem.stack}`);
    }
  }
  console.log(`${cases.length - failed} of ${cases.length} passed`);
  process.exitCode = failed ? 1 : 0;
};

/** A call throws a ShdError whose message begins with `text`, and whose result is `result`. */
export function refused(call, text, result = "invalid_argument") {
  assert.throws(call, (problem) => {
    assert(problem instanceof ShdError, problem.stack);
    assert.equal(problem.result, result);
    assert(problem.message.startsWith(text), `${JSON.stringify(problem.message)} does not begin with ${text}`);
    return true;
  });
}

export function grey(shd, context, size = 4) {
  const texels = new Uint8Array(size * size).map((_, i) => i * 16);
  return new shd.Texture(context, { format: "r8", width: size, height: size, texels, tables: "mipmap" });
}
