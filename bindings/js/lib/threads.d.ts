// SPDX-License-Identifier: MIT
// Types of the module with threads.
import type { Shd } from "./index.js";

type Source = string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module;

export interface ThreadOptions {
  /**
   * Threads, the calling one included: 1..64. The default is the number of processors, at most 64. It is 4
   * where the number of processors is unknown.
   */
  threads?: number;
  /** shd-threads.wasm, by default the file beside this module. */
  source?: Source;
  /** shd.wasm for pages whose memory cannot be shared, by default the file beside this module. */
  oneThread?: Source;
}

/** Whether memory can be shared: in Node, and in pages with the headers of cross-origin isolation. */
export function hasThreads(): boolean;

/** Loads the module with threads, or the one with one thread where memory cannot be shared. */
export function load(options?: ThreadOptions): Promise<Shd>;
