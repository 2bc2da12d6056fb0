// SPDX-License-Identifier: MIT
// The WebAssembly instance: where its bytes come from, and what it imports.

export const isNode = () => typeof process !== "undefined" && Boolean(process.versions?.node);

/** Number of threads that the machine runs at once, or 4 where it is unknown, as in Node before 21. */
export const processors = () => globalThis.navigator?.hardwareConcurrency ?? 4;

/** The bytes of a URL or path. Node reads files itself: its fetch does not take them. */
async function readBytes(source) {
  if (ArrayBuffer.isView(source) || source instanceof ArrayBuffer) return source;
  const url = source ?? new URL("./shd.wasm", import.meta.url);
  if (isNode() && !/^https?:/.test(String(url))) {
    const { readFile } = await import("node:fs/promises");
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/** The compiled code of a URL, a path, bytes or a WebAssembly.Module. Instances and workers share it. */
export async function compile(source) {
  return source instanceof WebAssembly.Module ? source : WebAssembly.compile(await readBytes(source));
}

/** Clocks and the end of the process, which the C library takes from its system. */
function systemImports(memoryOf) {
  return {
    env: { emscripten_notify_memory_growth() {} },
    wasi_snapshot_preview1: {
      proc_exit(code) {
        throw new Error(`shd.wasm stopped with code ${code}`);
      },
      clock_time_get(_clock, _precision, address) {
        const nanoseconds = BigInt(Math.round(performance.now() * 1e6));
        new DataView(memoryOf().buffer).setBigUint64(address, nanoseconds, true);
        return 0;
      },
    },
  };
}

/** Compiles and starts shd.wasm. `callbacks` has the functions that C calls. */
export async function instantiate(source, callbacks) {
  let exports;
  const imports = { ...systemImports(() => exports.memory), shd: callbacks };
  ({ exports } = await WebAssembly.instantiate(await compile(source), imports));
  exports._initialize();
  return exports;
}
