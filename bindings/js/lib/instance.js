// SPDX-License-Identifier: MIT
// The WebAssembly instance: where its bytes come from, and what it imports.

export const isNode = () => typeof process !== "undefined" && Boolean(process.versions?.node);

/** Number of threads that the machine runs at once, or 4 where it is unknown, as in Node before 21. */
export const processors = () => globalThis.navigator?.hardwareConcurrency ?? 4;

/** The compiled code of a URL or path. Node reads files itself: its fetch does not take them. */
async function compileFile(url) {
  if (isNode() && !/^https?:/.test(String(url))) {
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  // Browsers compile while the bytes arrive, if the server states their type.
  const isStated = /^application\/wasm\b/.test(response.headers.get("content-type"));
  return isStated ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** The compiled code of a URL, a path, bytes or a WebAssembly.Module. Instances and workers share it. */
export async function compile(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (ArrayBuffer.isView(source) || source instanceof ArrayBuffer) return WebAssembly.compile(source);
  return compileFile(source ?? new URL("./shd.wasm", import.meta.url));
}

const NO_FUNCTION = 52;  // ENOSYS of WASI
const OF_FILES = /^(__syscall|fd_|environ_)/;

/** A function of the system for files, which answers that it is absent; undefined for other names. */
export function absentFunction(name) {
  if (!OF_FILES.test(name)) return undefined;
  return name.startsWith("__syscall") ? () => -NO_FUNCTION : () => NO_FUNCTION;
}

/** The word that longjmp() of Emscripten leaves for its caller. */
export function tempWord() {
  let word = 0;
  return { setTempRet0(value) { word = value; }, getTempRet0: () => word };
}

/** Clocks and the end of the process, which the C library takes from its system. */
function systemImports(memoryOf) {
  return {
    env: { emscripten_notify_memory_growth() {}, ...tempWord() },
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
  const module = await compile(source);
  const imports = { ...systemImports(() => exports.memory), shd: callbacks };
  for (const { module: from, name } of WebAssembly.Module.imports(module)) imports[from][name] ??= absentFunction(name);
  ({ exports } = await WebAssembly.instantiate(module, imports));
  exports._initialize();
  return exports;
}
