// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { load as loadOne, ShdError } from "../lib/index.js";
import { load as loadShared } from "../lib/threads.js";

export { ShdError };

/** Threads of the instances of all tests: node run.mjs [threads]; without a number they are those of shd.wasm. */
export const threads = process.argv[2] ? Number(process.argv[2]) : undefined;
const file = threads ? process.env.SHD_WASM_THREADS ?? new URL("../lib/shd-threads.wasm", import.meta.url)
                     : process.env.SHD_WASM ?? new URL("../lib/shd.wasm", import.meta.url);
const module = await WebAssembly.compile(await readFile(file));

/** Whether the module was built with the libraries of libraries.sh. */
export const readsFiles = WebAssembly.Module.exports(module).some(({ name }) => name === "shd_scene_load_memory");

/** A new instance of shd.wasm. */
export const loadOneThread = () => loadOne(process.env.SHD_WASM);
/** A new instance with a number of threads. */
export const loadThreads = (count) => loadShared({ threads: count, source: module });
/** A new instance. */
export const load = () => (threads ? loadThreads(threads) : loadOne(module));

const cases = [];

/** Registers a test; each has its own instance of the library. */
export function test(name, body) {
  cases.push([name, body]);
}

test.run = async () => {
  let failed = 0;
  for (const [name, body] of cases) {
    const shd = await load();
    try {
      await body(shd, new shd.Context());
      console.log(`ok ${name}`);
    } catch (problem) {
      failed += 1;
      console.log(`FAILED ${name}\n${problem.stack}`);
    } finally {
      shd.close();
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
