// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { grey, refused, test, threads } from "./support.mjs";

const half = [0.125, 0.375, 0.625, 0.875];

test("lookup/values", (shd, context) => {
  const { channel } = grey(shd, context).sample(new shd.Sampler(context, { filter: "nearest" }), { u: half, v: half });
  assert.deepEqual([...channel[0]], [0, 80, 160, 240].map((v) => Math.fround(v / 255)));
});

test("lookup/blocks", (shd, context) => {
  // The first row of BC1 is red, blue and colours between them; BC7 is one colour, in mode 6.
  const bc1 = Uint8Array.of(0x00, 0xf8, 0x1f, 0x00, 0xe4, 0, 0, 0);
  const bc7 = Uint8Array.of(192, 255, 159, 66, 1, 0, 254, 255, 1, 0, 0, 0, 0, 0, 0, 0);
  const sampler = new shd.Sampler(context, { filter: "nearest_mip" });
  const codes = (desc, lod) => {
    const { channel } = new shd.Texture(context, desc).sample(sampler, { u: [0.375], v: [0.125], lod: [lod] });
    return channel.map((values) => Math.round(values[0] * 255));
  };
  assert.deepEqual(codes({ format: "bc1_rgb", width: 4, height: 4, texels: bc1 }, 0), [0, 0, 255, 255]);
  assert.deepEqual(codes({ format: "bc7", width: 3, height: 1, texels: bc7 }, 0), [255, 41, 1, 255]);
  const levelImages = [{ format: "bc7", width: 4, height: 2, pixels: bc7 }];
  const desc = { format: "bc7", width: 8, height: 4, texels: new Uint8Array(32), tables: "mipmap", levelImages };
  assert.deepEqual([codes(desc, 0), codes(desc, 1)], [[0, 0, 0, 0], [255, 41, 1, 255]]);
  refused(() => codes({ ...desc, texels: bc7 }, 0), "desc.texels: 16 bytes, fewer than the 32");
  levelImages[0].pixels = bc1;
  refused(() => codes(desc, 0), "desc.levelImages[0].pixels: 8 bytes, fewer than the 16");
});

test("lookup/columns", (shd, context) => {
  const texture = grey(shd, context), sampler = new shd.Sampler(context);
  const uv = Float32Array.from(half.flatMap((v) => [v, v]));
  const want = texture.sample(sampler, { u: half, v: half }).channel[0];
  const strided = texture.sample(sampler, { count: 4, u: { data: uv, stride: 2 }, v: { data: uv, offset: 1,
      stride: 2 } },
                                 { channel: [new Float32Array(4)] });
  assert.deepEqual(strided.channel[0], want);
  const whole = new Float32Array(16);
  const out = texture.sample(sampler, { u: half, v: half }, { channel: whole });
  assert.deepEqual(whole.filter((_, i) => i % 4 === 0), want);
  assert.equal(out.nonfiniteCount, 0);
  const gaps = new Float32Array(8).fill(7);
  texture.sample(sampler, { u: half, v: half }, { channel: [{ data: gaps, stride: 2 }] });
  assert.deepEqual([...gaps], [...want].flatMap((v) => [v, 7]));
});

test("lookup/kinds", (shd, context) => {
  const desc = { format: "r32f", width: 1, height: 1, texels: new Float32Array([0, 1, 2, 3, 4, 5]) };
  const make = (more) => new shd.Texture(context, { ...desc, ...more });
  const info = (more) => {
    const { kind, depth, layerCount } = make(more).info;
    return `${kind} ${depth} ${layerCount}`;
  };
  assert.equal(info({}), "2d 0 1");
  assert.equal(info({ depth: 6 }), "3d 6 1");
  assert.equal(info({ projection: "lat_long" }), "directions 0 1");
  assert.equal(info({ projection: "cube" }), "directions 0 6");
  const axes = { u: [1, -1, 0, 0, 0, 0], v: [0, 0, 1, -1, 0, 0], w: [0, 0, 0, 0, 1, -1] };
  const found = make({ projection: "cube" }).sample(new shd.Sampler(context, { filter: "nearest" }), axes).channel[0];
  assert.deepEqual([...found], [0, 1, 2, 3, 4, 5]);
  const image = (value) => ({ format: "r32f", width: 1, height: 1, pixels: new Float32Array([value]) });
  const levels = { width: 2, height: 2, tables: "mipmap", levelImages: [10, 11, 12, 13, 14, 15].map(image) };
  for (const more of [{ projection: "cube" }, { layerCount: 6 }]) {
    const made = make({ ...levels, ...more, texels: new Float32Array(24) });
    assert.deepEqual([0, 5].map((face) => made.readLevel(face, 1, image(0)).pixels[0]), [10, 15]);
  }
  const table = make({ ...levels, texels: new Float32Array(24).fill(5), projection: "cube" });
  const face = { table: "mipmap", view: "picture", layer: 5 };
  assert.deepEqual([table.tableInfo(face).width, [...table.readTable(face)].filter((_, i) => i % 4 === 0)],
                   [3, [5, 5, 15, 5, 5, 0]]);
  refused(() => table.readTable({ table: "ripmap" }), "table.table: SHD_TABLE_RIPMAP, but the texture does not have");
  const few = { ...levels, texels: new Float32Array(24), projection: "cube", levelImages: [image(0)] };
  refused(() => make(few), "desc.levelImages: 1 elements, not a multiple of 6");
  refused(() => make({ depth: 6, projection: "cube" }), "desc.kind: depth is of 3D textures and projection of");
  refused(() => make({ depth: 7 }), "desc.texels: 24 bytes, fewer than the 28");
  refused(() => make({ projection: "cube", texels: new Float32Array(2) }), "desc.texels: 8 bytes, fewer than the 24");
  refused(() => make({ depth: 6, projection: "cube", kind: "3d" }), "texture.projection: 4, but texture.kind is not");
  refused(() => make({ depth: 7, layerCount: 6, kind: "2d" }), "texture.depth: 7, but texture.kind is not");
  refused(() => make({ projection: "cube", layerCount: 9, texels: new Float32Array(9) }), "texture.layer_count: 9");
  refused(() => make({ kind: "4d" }), 'desc.kind: no texture_kind is "4d"; there are 2d, 3d, directions');
  refused(() => make({ projection: "none" }), "texture.projection");
});

test("lookup/allocation", (shd, context) => {
  const texture = grey(shd, context), sampler = new shd.Sampler(context);
  const [u, v, r] = [0, 1, 2].map(() => shd.allocate(Float32Array, 4));
  u.array.set(half), v.array.set(half);
  texture.sample(sampler, { u, v }, { channel: [r] });
  assert.deepEqual(r.array, texture.sample(sampler, { u: half, v: half }).channel[0]);
  const lookup = texture.lookup(sampler, { u: u.array, v }, { channel: [r] });
  const before = r.array.slice();
  r.array.fill(0);
  texture.close(), sampler.close();  // the lookup has references of its own
  lookup.run();
  assert.deepEqual(r.array, before);
  lookup.close(), lookup.close();
  refused(() => lookup.run(), "lookup: it is closed");
  u.close(), u.close();
  refused(() => u.array, "allocation: it is closed");
});

test("lookup/growth", (shd, context) => {
  const texture = grey(shd, context), sampler = new shd.Sampler(context, { filter: "nearest" });
  const u = shd.allocate(Float32Array, 4);
  u.array.set(half);
  const old = u.array;
  const big = shd.allocate(Uint8Array, 64 << 20);
  assert.notEqual(old.buffer, shd.memory.buffer);  // the memory grew
  assert.deepEqual([...u.array], half.map(Math.fround));
  if (threads) {  // shared buffers stay valid
    const out = shd.allocate(Float32Array, 4);
    texture.lookup(sampler, { u: old, v: old }, { channel: [out] }).run();
    assert.deepEqual([...out.array], [0, 80, 160, 240].map((v) => Math.fround(v / 255)));
  } else {
    refused(() => texture.sample(sampler, { u: half, v: old }), "lookups.v: 0 elements, not count = 4 (arrays over");
  }
  big.close();
});

test("lookup/misuse", (shd, context) => {
  const texture = grey(shd, context), sampler = new shd.Sampler(context);
  const sample = (lookups, out) => () => texture.sample(sampler, lookups, out);
  refused(sample({ u: new Int16Array(4), v: half }),
          "lookups.u: a Float32Array, not a value of type Int16Array; Float32Array.from(values) converts it");
  refused(sample({ u: new BigInt64Array(4), v: half }), "lookups.u: a Float32Array, not a value of type BigInt64Array");
  refused(sample({ u: half, v: half }, { channel: [new Float64Array(4)] }), "out.channel[0]: a Float32Array, not a");
  refused(sample({ u: half, v: half.slice(1) }), "lookups.v: 3 elements, not count = 4");
  refused(sample({ u: half, v: [0, "1", 2, 3] }), "lookups.v[1]: a number, not \"1\"");
  refused(sample({ u: { data: new Float32Array(8), stride: -2 }, v: half }), "lookups.u.stride: -2");
  refused(sample({ u: { data: new Float32Array(8), stride: 1.5 }, v: half }), "lookups.u.stride: 1.5");
  refused(sample({ u: { data: new Float32Array(8), offset: 9 }, v: half }), "lookups.u.offset: 9, not 0..8");
  refused(sample({ u: half, v: half }, { channel: [new Float32Array(3)] }), "out.channel: 3 elements, not 4");
  refused(sample({ u: half, v: half }, { channel: [[0, 0, 0, 0]] }), "out.channel[0]: a Float32Array");
  refused(sample({ u: half, v: half, bias: 1 }), "lookups.bias: lookups has no such field; lib/api.d.ts lists them");
  refused(sample({ u: half }), "lookups.v");
  refused(() => texture.sample(null, { u: half, v: half }), "sampler: a sampler, not null");
  refused(() => texture.sample(texture, { u: half, v: half }), "sampler: a sampler, not a value of type Texture");
  refused(() => texture.lookup(sampler, { u: new Float32Array(1), v: new Float32Array(1) },
      {}), "lookups.u: arrays of a");
});

test("lookup/explain", (shd, context) => {
  const texture = grey(shd, context), sampler = new shd.Sampler(context, { filter: "ewa" });
  const explanation = texture.explain(sampler, { u: [0.5], v: [0.5], dudx: [1], dvdy: [0.25] });
  assert.equal(explanation.filter, "ewa");
  assert(explanation.tapCount > 1 && Math.hypot(...explanation.longerAxis) === 4, JSON.stringify(explanation));
  const { taps, blends, tapCount, blendCount } = explanation;
  assert.deepEqual([taps.length, blends.length], [tapCount, blendCount]);
  assert(Math.abs(taps.reduce((sum, { weight }) => sum + weight, 0) - 1) < 1e-6 && taps.every(({ weight }) => weight > 0));
  const nodes = taps.map(({ value }) => value[0]);
  const f = Math.fround;  // the tree of blends gives the bits of the result
  for (const { a, b, s } of blends) {
    nodes.push(s === 0 ? nodes[a] : f(nodes[a] + f(s * f(nodes[b] - nodes[a]))));
  }
  const last = nodes.at(-1), [high, low] = [explanation.scaleHigh[0], explanation.scaleLow[0]];
  assert.equal(low === 0 ? f(last * high) : f(f(last * high) + f(last * low)), explanation.result[0]);
  const { lod, level } = texture.queryLevels(sampler, { u: [0.5], v: [0.5], lod: [1.25] });
  assert.deepEqual([lod[0], level[0]], [1.25, 1]);
});
