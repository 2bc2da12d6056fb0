// SPDX-License-Identifier: MIT
// A thread of threads.js: it runs tasks until it is ended.
import { isNode } from "./instance.js";
import { forwardingImports, systemFunctions, threadImports } from "./threads.js";

async function run({ module, memory, thread, start, argument, index, mailboxes, stackTop }, post) {
  const known = { ...systemFunctions(memory), ...forwardingImports(memory, mailboxes, index) };
  const { exports } = await WebAssembly.instantiate(module, threadImports(module, memory, known));
  exports.stackRestore(stackTop);  // before any function that uses the stack
  exports._emscripten_thread_init(thread, 0, 0, 1);
  exports.emscripten_tls_init();
  post("ready");
  exports.__indirect_function_table.get(start)(argument);
}

if (isNode()) {
  const { parentPort } = await import("node:worker_threads");
  parentPort.once("message", (data) => run(data, (message) => parentPort.postMessage(message)));
} else {
  globalThis.onmessage = ({ data }) => run(data, (message) => globalThis.postMessage(message));
}
