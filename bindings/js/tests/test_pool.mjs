// SPDX-License-Identifier: MIT
// The pool of workers in Node.
import assert from "node:assert/strict";
import { Worker } from "node:worker_threads";
import { refused, ShdError, test } from "./support.mjs";
import { balance, Pool } from "../lib/pool.js";
import { HEIGHT, makeScene, WIDTH } from "./pool_scene.mjs";

const source = process.env.SHD_WASM;
const start = () => new Worker(new URL("./pool_worker.mjs", import.meta.url));

/** Runs a test with a pool, which is closed after it. */
function withPool(name, count, body) {
  test(name, async (shd) => {
    const pool = new Pool(start, { count, source });
    try {
      await body(pool, shd);
    } finally {
      pool.close();
    }
  });
}

const join = (bands) => Uint8Array.from(bands.flatMap(({ value }) => [...value]));

for (const count of [1, 2, 3, 5]) {
  withPool(`pool/same_bits/${count}`, count, async (pool, shd) => {
    const whole = Uint8Array.from(makeScene(shd)([0, HEIGHT]));
    for (let frame = 0; frame < 3; ++frame) {
      const bands = await pool.bands(HEIGHT, "draw");
      assert.equal(bands.length, count);
      assert.deepEqual([bands[0].rows[0], bands.at(-1).rows[1]], [0, HEIGHT]);
      bands.slice(1).forEach(({ rows }, i) => assert.equal(rows[0], bands[i].rows[1]));
      for (const { rows, value } of bands) assert.equal(value.length, 4 * WIDTH * (rows[1] - rows[0]));
      assert.deepEqual(join(bands), whole);
    }
  });
}

withPool("pool/calls", 2, async (pool) => {
  assert.equal(pool.count, 2);
  assert.deepEqual(await pool.call("echo", 1, "two", [3]), [1, "two", [3]]);
  assert.deepEqual(await pool.all("echo", 7), [[7], [7]]);
  const many = await Promise.all(Array.from({ length: 50 }, () => pool.call("count")));
  assert.equal(Math.max(...many) + Math.max(...(await pool.all("count"))) >= 50, true);
  const before = await pool.callOn(1, "count");
  assert.equal(await pool.callOn(1, "count"), before + 1);  // the same worker
  assert.deepEqual((await pool.bands(1, "echo", "more")).map(({ rows, value }) => [rows, value]),
                   [[[0, 1], [[0, 1], "more"]]]);
  const { view, list, text, data, bytes, small } = await pool.call("memory");
  assert.deepEqual([...view, ...list[0], text], [1, 2, 3, 4, 5, "text"]);
  assert.equal(view.buffer.byteLength, 16);  // not all of the memory
  assert.deepEqual([0, 4, 8, 12].map((offset) => data.getFloat32(offset, true)), [1, 2, 3, 4]);
  assert.equal(data.buffer.byteLength, 16);
  assert.deepEqual([...new Float32Array(bytes.buffer)], [1, 2, 3, 4]);
  assert.equal(new TextDecoder().decode(small.buffer), "small");  // not all that small Buffers share
});

withPool("pool/problems", 2, async (pool) => {
  await assert.rejects(pool.call("refuse"), (problem) => problem instanceof ShdError
    && problem.result === "invalid_argument" && problem.message.startsWith("sampler.max_anisotropy: 99"));
  await assert.rejects(pool.call("drow"), /the worker has no function drow; there are draw, echo/);
  await assert.rejects(pool.bands(0, "draw"), /height: 0, not 1 or more rows/);
  await assert.rejects(pool.callOn(2, "count"), /index: 2, not 0\.\.1/);
  refused(() => new Pool("worker.js"), "start: a function that makes a Worker, not \"worker.js\"");
  refused(() => new Pool(start, { count: 0 }), "count: 0, not 1 or more workers");
  await pool.callOn(0, "end").catch(() => {});  // the worker may break before it answers
  await assert.rejects(async () => { for (;;) await pool.callOn(0, "count"); }, /this worker breaks/);
  assert.equal(typeof await pool.call("count"), "number");  // the other worker goes on
  const waiting = pool.call("count");
  pool.close();
  await assert.rejects(waiting, /the pool is closed/);
  await assert.rejects(pool.call("count"), /the pool is closed|breaks/);
});

test("pool/no_module", async () => {
  const pool = new Pool(start, { count: 1, source: "/nowhere/shd.wasm" });
  await assert.rejects(pool.call("count"), /nowhere/);
  pool.close();
});

test("pool/ends_workers", async () => {
  const ended = [];
  let made = 0;
  const makeWorker = () => {
    const index = made++;
    if (index === 3) throw new Error("no fourth worker");
    return { postMessage() {}, terminate: () => ended.push(index) };
  };
  assert.throws(() => new Pool(makeWorker, { count: 5, source }), /no fourth worker/);
  assert.deepEqual(ended.splice(0), [0, 1, 2]);
  made = 0;
  const pool = new Pool(makeWorker, { count: 2, source: "/nowhere/shd.wasm" });
  await assert.rejects(pool.all("count"), /nowhere/);
  assert.deepEqual(ended, [0, 1]);
});

test("pool/balance", () => {
  assert.deepEqual(balance([0, 50, 100], [10, 10]), [0, 50, 100]);
  assert.deepEqual(balance([0, 50, 100], [30, 10]), [0, 33, 100]);
  assert.deepEqual(balance([0, 1, 2], [0, 0]), [0, 1, 2]);
  assert.deepEqual(balance([0, 40, 80, 120], [0, 0, 90]), [0, 93, 107, 120]);
  // Each band keeps a row.
  assert.deepEqual(balance([0, 1, 2, 3], [1, 1, 50]), [0, 1, 2, 3]);
  assert.deepEqual(balance([0, 1, 2, 3, 4, 5, 6, 7, 8], [0, 0, 0, 0, 0, 0, 0, 50]), [0, 1, 2, 3, 4, 5, 6, 7, 8]);
  assert.deepEqual(balance([0, 4, 8, 12], [0, 0, 9]), [0, 9, 11, 12]);
  assert.deepEqual(balance([0, 10, 11, 12], [1, 1, 100]), [0, 10, 11, 12]);
  assert.deepEqual(balance([0, 1, 2, 12], [100, 1, 1]), [0, 1, 2, 12]);
  // Equal times move no edge. A coarse clock measures 0 for all of them.
  assert.deepEqual(balance([0, 5, 10], [0, 0]), [0, 5, 10]);
  assert.deepEqual(balance([0, 3, 7, 10], [0, 0, 0]), [0, 3, 7, 10]);
  assert.deepEqual(balance([0, 3, 7, 10], [4, 4, 4]), [0, 3, 7, 10]);
});
