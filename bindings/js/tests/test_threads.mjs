// SPDX-License-Identifier: MIT
// Threads over shared memory. The other tests run with threads, too: node run.mjs 3
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { grey, loadOneThread, loadThreads, refused, test, threads } from "./support.mjs";
import { runPrograms } from "../examples/programs.mjs";
import { load, startThreads, systemFunctions } from "../lib/threads.js";
import { HEIGHT, makeScene } from "./pool_scene.mjs";

const stored = readFileSync(new URL("../../programs.txt", import.meta.url), "utf8").trim().split("\n");

/** Runs `body` where globals have other values; undefined removes one. */
async function withGlobals(values, body) {
  const kept = Object.keys(values).map((name) => [name, Object.getOwnPropertyDescriptor(globalThis, name)]);
  for (const [name, value] of Object.entries(values)) {
    delete globalThis[name];
    if (value !== undefined) Object.defineProperty(globalThis, name, { value, configurable: true });
  }
  try {
    await body();
  } finally {
    for (const [name, property] of kept) {
      delete globalThis[name];
      if (property) Object.defineProperty(globalThis, name, property);
    }
  }
}

test("threads/clock", async () => {
  const memory = { buffer: new ArrayBuffer(16) };
  const { clock_gettime: clock } = systemFunctions(memory);
  for (const [now, wanted] of [[0, [0, 0]], [1000, [1, 0]], [1250.5, [1, 250500000]],
                               [1999.9999999, [1, 999999999]], [999.9999999999999, [0, 999999999]]]) {
    await withGlobals({ performance: { now: () => now } }, () => clock(0, 8));
    assert.deepEqual([...new Int32Array(memory.buffer, 8, 2)], wanted);
  }
});

test("threads/processors", async () => {
  for (const hardwareConcurrency of [1, 64, 65, 256, undefined]) {
    await withGlobals({ navigator: { hardwareConcurrency }, SharedArrayBuffer: undefined }, async () => {
      assert.equal((await load({ oneThread: process.env.SHD_WASM })).threadCount, 1);
    });
  }
});

test("threads/failed_start", async () => {
  const memory = { buffer: new ArrayBuffer(16) };
  const started = [];
  const raw = { shd_js_start_thread: (index) => { started.push(index); return 0; }, shd_js_mailboxes: () => 0,
                shd_js_stack_top: () => 0 };
  // Each worker answers in one way: null for success, a text, an exception, or a failure of the worker itself.
  for (const [bad, wanted] of [["no memory", /^Error: no memory$/], [new Error("a bug"), /^Error: a bug$/],
                               [undefined, /^Error: no worker$/]]) {
    const ended = [];
    const makeWorker = async () => {
      const index = makeWorker.count++;
      if (index === 2 && bad === undefined) throw new Error("no worker");
      const listeners = {};
      return {
        on(event, listener) { listeners[event] = listener; },
        once(event, listener) { listeners[event] = listener; },
        unref() {},
        postMessage() {
          if (index !== 2) listeners.message(null);
          else if (bad instanceof Error) listeners.error(bad);
          else listeners.message(bad);
        },
        terminate: () => ended.push(index),
      };
    };
    makeWorker.count = 0;
    const made = Array.from({ length: 4 }, () => ({}));
    await assert.rejects(startThreads(null, memory, raw, made, 4, makeWorker), wanted);
    assert.deepEqual(ended, bad === undefined ? [0, 1] : [0, 1, 2, 3]);
  }
  const refusing = { ...raw, shd_js_start_thread: () => 11 };
  const ended = [];
  await assert.rejects(startThreads(null, memory, refusing, [], 1, async () => ({ terminate: () => ended.push(0) })),
                       /threads: thread 1 could not be made/);
  assert.deepEqual(ended, [0]);
});

/** A test of an instance with a number of threads; they are a part of the run with threads. */
function withThreads(name, count, body) {
  if (!threads) return;
  test(`threads/${name}`, async () => {
    const shd = await loadThreads(count);
    try {
      await body(shd, await loadOneThread());
    } finally {
      shd.close();
    }
  });
}

for (const count of [1, 2, 3, 8]) {
  withThreads(`same_bits/${count}`, count, (shd, one) => {
    assert.equal(shd.threadCount, count);
    assert.deepEqual(runPrograms(shd).lines, stored);
    const rows = [0, HEIGHT];
    assert.deepEqual(makeScene(shd)(rows), makeScene(one)(rows));
  });
}

withThreads("worker_count", 4, (shd) => {
  for (const [workerCount, wanted] of [[0, 4], [1, 1], [2, 2], [4, 4], [7, 4], [undefined, 4]]) {
    assert.equal(new shd.Context({ workerCount }).workerCount, wanted);
  }
  assert.equal(new shd.Context().workerCount, 4);
  refused(() => new shd.Context({ workerCount: 2000 }), "context.worker_count: 2000");
  refused(() => new shd.Context({ workerCount: "2" }), "desc.workerCount: a number");
  refused(() => new shd.Context({ executor: {} }), "desc.executor: not available");
});

/** A frame whose tiles are given to a function; the workers that drew them are collected. */
function drawTiles(shd, context, more = {}) {
  const framebuffer = new shd.Framebuffer(context, { width: 512, height: 512, sampleCount: 4 });
  const draws = [{ mesh: shd.Mesh.shape(context, { kind: "torus" }), material: new shd.Material(context) }];
  const workers = new Set();
  const present = (tile) => { workers.add(tile.worker); };
  shd.render(context, { framebuffer, draws, lights: [], camera: { eye: [0, 1, 2] }, present, ...more });
  framebuffer.close();
  return workers;
}

withThreads("several_work", 4, (shd) => {
  const context = new shd.Context();
  const workers = new Set();
  for (let frame = 0; frame < 200 && workers.size < 2; ++frame) {
    for (const worker of drawTiles(shd, context)) workers.add(worker);
  }
  assert(workers.size >= 2, `only worker ${[...workers]}`);
});

withThreads("exceptions", 4, (shd) => {
  const context = new shd.Context();
  for (let i = 0; i < 50; ++i) {
    const problem = new RangeError(`${i}`);
    assert.throws(() => drawTiles(shd, context, { present() { throw problem; } }), (got) => got === problem);
    refused(() => drawTiles(shd, context, { progress: () => false }), "", "cancelled");
  }
  drawTiles(shd, context);
});

withThreads("failing_tiles", 4, (shd) => {
  const context = new shd.Context();
  const cache = new shd.TileCache(context, { tileBytes: 1024, budgetBytes: 1 << 20 });
  const sampler = new shd.Sampler(context, { filter: "bilinear" });
  const count = 1 << 16;
  const u = Float32Array.from({ length: count }, (_, i) => ((i * 40503) % count) / count);
  let load = (tiles) => { for (const tile of tiles) tile.texels.fill(tile.area.x / 2); };
  const texture = new shd.Texture(context, { format: "r8", width: 512, height: 512,
                                             tiles: { cache, load: (tiles) => load(tiles) } });
  const good = load;
  for (let i = 0; i < 50; ++i) {
    const problem = new RangeError(`${i}`);
    load = () => { throw problem; };
    assert.throws(() => texture.sample(sampler, { u, v: u }), (got) => got === problem);
  }
  load = () => texture.sample(sampler, { u: [0.5], v: [0.5] });
  refused(() => texture.sample(sampler, { u, v: u }), "shd_texture_sample: a function that loads tiles may not");
  load = good;
  const { channel } = texture.sample(sampler, { u, v: u });
  const one = new shd.Context({ workerCount: 1 });
  const texels = Uint8Array.from({ length: 512 * 512 }, (_, i) => Math.floor((i % 512) / 32) * 16);
  const wanted = new shd.Texture(one, { format: "r8", width: 512, height: 512, texels }).sample(sampler, { u, v: u });
  assert.deepEqual(channel[0], wanted.channel[0]);
});

withThreads("programs_sample", 3, (shd, one) => {
  const draw = (instance) => {
    const context = new instance.Context();
    const texels = Uint8Array.from({ length: 64 * 64 }, (_, i) => (i * 7919) % 251);
    const texture = new instance.Texture(context, { format: "r8", width: 64, height: 64, texels });
    const sampler = new instance.Sampler(context);
    const fragment = ({ u, v }, out) => {
      out.r.set(texture.sample(sampler, { u: u.slice(), v: v.slice() }).channel[0]);
      out.g.set(u), out.b.fill(0);
    };
    const material = new instance.Material(context, { model: "program", program: { fragment } });
    const framebuffer = new instance.Framebuffer(context, { width: 256, height: 256 });
    const draws = [{ mesh: instance.Mesh.shape(context, { kind: "torus" }), material }];
    instance.render(context, { framebuffer, draws, camera: { eye: [0, 1, 2] } });
    return framebuffer.readColor();
  };
  assert.deepEqual(draw(shd), draw(one));
});

withThreads("trap", 4, (shd) => {
  const context = new shd.Context();
  const framebuffer = new shd.Framebuffer(context, { width: 256, height: 256 });
  const mesh = shd.Mesh.shape(context, { kind: "torus" });
  const [u, r] = [shd.allocate(Float32Array, 4), shd.allocate(Float32Array, 4)];
  const lookup = grey(shd, context).lookup(new shd.Sampler(context), { u, v: u }, { channel: [r] });
  lookup.run();
  shd.raw.shd_js_callback = () => 0x7fffffff;  // no function has this number
  const material = new shd.Material(context, { model: "program", program: { fragment() {} } });
  const draw = () => shd.render(context, { framebuffer, draws: [{ mesh, material }], camera: { eye: [0, 1, 2] } });
  const stopped = /^Error: thread [123] has stopped \(RuntimeError: .+\); another load\(\) makes a new instance$/;
  assert.throws(draw, stopped);
  assert.throws(draw, stopped);
  assert.throws(() => new shd.Context(), stopped);
  assert.throws(() => lookup.run(), stopped);
  assert.throws(() => shd.allocate(Float32Array, 4), stopped);
  lookup.close(), framebuffer.close(), u.close(), context.close();
});

withThreads("closed", 3, (shd) => {
  const context = new shd.Context();
  const framebuffer = new shd.Framebuffer(context, { width: 64, height: 64 });
  const draws = [{ mesh: shd.Mesh.shape(context, { kind: "torus" }), material: new shd.Material(context) }];
  const draw = (more) => shd.render(context, { framebuffer, draws, camera: { eye: [0, 1, 2] }, ...more });
  refused(() => draw({ present: () => shd.close() }), "close: it may not be called inside a program");
  draw();
  shd.close(), shd.close();
  for (const call of [draw, () => framebuffer.readColor(), () => shd.allocate(Uint8Array, 1)]) {
    assert.throws(call, /^Error: shd is closed: its threads have ended$/);
  }
  framebuffer.close(), context.close();
});

withThreads("closed_without_threads", 1, (shd) => {
  shd.close();
  assert.equal(new shd.Context().workerCount, 1);
});

withThreads("misuse", 1, async () => {
  for (const [count, text] of [[0, "0"], [65, "65"], [1.5, "1.5"], ["2", '"2"']]) {
    await assert.rejects(load({ threads: count }), new RegExp(`threads: ${text}, not 1\\.\\.64`));
  }
  await assert.rejects(load({ source: "/nowhere/shd-threads.wasm" }), /nowhere/);
  await withGlobals({ SharedArrayBuffer: undefined }, async () => {
    const shd = await load({ threads: 4, oneThread: process.env.SHD_WASM });
    assert.deepEqual([shd.threadCount, new shd.Context().workerCount], [1, 1]);
  });
});
