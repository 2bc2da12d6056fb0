// SPDX-License-Identifier: MIT
// Objects that the collector closes. Needs node --expose-gc. These tests come first: after tests that exhaust the
// memory of an instance, Node 20 was seen to collect objects without running their finalisers.
import assert from "node:assert/strict";
import { test } from "./support.mjs";

let found = 0;
const registry = new FinalizationRegistry(() => { found += 1; });  // a local one would be collected itself

test("garbage/memory", async (shd, context) => {
  if (!globalThis.gc) return console.log("  nothing was tested: node runs without --expose-gc");
  const make = () => new shd.Framebuffer(context, { width: 1024, height: 1024 });
  for (let i = 0; i < 8; ++i) registry.register(make(), i);
  for (let i = 0; i < 200 && found < 8; ++i) {
    globalThis.gc();
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
  assert.equal(found, 8);
  await new Promise((resolve) => setTimeout(resolve, 50));  // the registry of the module may run after that of the test
  const size = shd.memory.buffer.byteLength;
  for (const framebuffer of Array.from({ length: 6 }, make)) framebuffer.close();
  assert.equal(shd.memory.buffer.byteLength, size);  // memory of the collected ones was used again
});
