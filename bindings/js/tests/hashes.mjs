// SPDX-License-Identifier: MIT
// Runs wasm_hashes.wasm, which prints the hashes of tests/golden/hashes.txt: node hashes.mjs wasm_hashes.wasm
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const wasi = new WASI({ version: "preview1", args: ["hashes", "--hashes"] });
const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {
  wasi_snapshot_preview1: wasi.wasiImport,
  env: { emscripten_notify_memory_growth() {} },
});
process.exitCode = wasi.start(instance);
