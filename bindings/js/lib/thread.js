// SPDX-License-Identifier: MIT
// A thread of threads.js: it runs tasks until it is ended.
import { isNode } from "./instance.js";
import { forwardingImports, reportStop, systemFunctions, threadImports } from "./threads.js";

/** The instance of a thread. */
async function prepare({ module, memory, thread, index, mailboxes, stackTop }) {
  const known = { ...systemFunctions(memory), ...forwardingImports(memory, mailboxes, index) };
  const { exports } = await WebAssembly.instantiate(module, threadImports(module, memory, known));
  exports.stackRestore(stackTop);  // before any function that uses the stack
  exports._emscripten_thread_init(thread, 0, 0, 1);
  exports.emscripten_tls_init();
  return exports;
}

/** Posts null before the thread runs, or the text of a problem. */
async function run(message, post) {
  let exports;
  try {
    exports = await prepare(message);
  } catch (problem) {
    post(`${problem}`);
    return;
  }
  post(null);
  const { memory, start, argument, index, mailboxes } = message;
  try {
    exports.__indirect_function_table.get(start)(argument);
  } catch (problem) {
    reportStop(memory, mailboxes, index, problem);
  }
}

if (isNode()) {
  const { parentPort } = await import("node:worker_threads");
  parentPort.once("message", (data) => run(data, (message) => parentPort.postMessage(message)));
} else {
  globalThis.onmessage = ({ data }) => run(data, (message) => globalThis.postMessage(message));
}
