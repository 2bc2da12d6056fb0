// SPDX-License-Identifier: MIT
// Types of the pool of workers.
/// <reference lib="esnext.disposable" />
import type { Shd } from "./index.js";

/** Functions of a worker by their names. */
export type Functions = Record<string, (...values: any[]) => any>;
type Result<F extends Functions, Name extends keyof F> = Awaited<ReturnType<F[Name]>>;
type Rest<Values extends any[]> = Values extends [any, ...infer Others] ? Others : any[];

/** What a pool needs of a Worker of a page or of node:worker_threads. */
export interface AnyWorker {
  postMessage(message: any): void;
  terminate(): unknown;
}

export interface PoolOptions {
  /** Workers, by default the number of processors, or 4 where it is unknown. */
  count?: number;
  /** shd.wasm, as for load(). */
  source?: string | URL | ArrayBuffer | Uint8Array | WebAssembly.Module;
}

/** A part of a picture: rows first..last - 1, the result of its function, and the time that the function took. */
export interface Band<T> { rows: [first: number, last: number]; value: T; milliseconds: number }

/**
 * Workers that each have an instance of the library and run functions of a module, which calls serve(). Arrays of a
 * result are moved to the caller; other values are copied.
 */
export class Pool<F extends Functions = Functions> {
  /** `start` makes one worker: `() => new Worker(new URL("./worker.js", import.meta.url), { type: "module" })`. */
  constructor(start: () => AnyWorker, options?: PoolOptions);
  readonly count: number;
  /** Runs a function in the next worker that is free. */
  call<Name extends keyof F>(name: Name, ...values: Parameters<F[Name]>): Promise<Result<F, Name>>;
  /** Runs a function in one worker, such as that of a band. */
  callOn<Name extends keyof F>(index: number, name: Name, ...values: Parameters<F[Name]>): Promise<Result<F, Name>>;
  /** Runs a function in every worker. */
  all<Name extends keyof F>(name: Name, ...values: Parameters<F[Name]>): Promise<Result<F, Name>[]>;
  /**
   * Runs a function in every worker with the rows of a band as the first argument. The bands cover 0..height; later
   * pictures of this height have bands that take equal times.
   */
  bands<Name extends keyof F>(height: number, name: Name, ...values: Rest<Parameters<F[Name]>>):
    Promise<Band<Result<F, Name>>[]>;
  /** Ends the workers. Calls that run are rejected. */
  close(): void;
  [Symbol.dispose](): void;
}

/** Answers the calls of a pool: the module of a worker calls it once with a function that returns its functions. */
export function serve(start: (shd: Shd) => Functions | Promise<Functions>): void;

/** Rows at which bands begin, so that all of them would take equal times. */
export function balance(edges: number[], times: number[]): number[];
