// SPDX-License-Identifier: MIT
// Textures in tile caches.
import assert from "node:assert/strict";
import { refused, test } from "./support.mjs";
import { structs } from "../lib/api.js";

const WIDTH = 100, HEIGHT = 70, COUNT = 500;
const REGION = { level: 1, area: { width: 50, height: 35 } };
const side = (size, level) => Math.max(1, size >> level);

const lookups = {
  u: Float32Array.from({ length: COUNT }, (_, i) => (i * 37 % COUNT) / COUNT),
  v: Float32Array.from({ length: COUNT }, (_, i) => (i * 91 % COUNT) / COUNT),
  lod: Float32Array.from({ length: COUNT }, (_, i) => i / 83),
};

/** A texture in memory, and a function that loads its levels as tiles; `source.problem` is thrown in place of some. */
function makeSource(shd, context) {
  const texels = Uint8Array.from({ length: WIDTH * HEIGHT * 4 }, (_, i) => (i * 7919) % 251);
  const desc = { format: "rgba8", width: WIDTH, height: HEIGHT, tables: "mipmap" };
  const memory = new shd.Texture(context, { ...desc, texels });
  const levels = Array.from({ length: memory.info.levelCount }, (_, level) => {
    const [width, height] = [side(WIDTH, level), side(HEIGHT, level)];
    return memory.readLevel(0, level, { format: "rgba8", width, height, pixels: new Uint8Array(width * height * 4) })
      .pixels;
  });
  const source = { memory, calls: 0, tiles: 0, problem: null, kept: null };
  source.cache = new shd.TileCache(context, { tileBytes: 1024, budgetBytes: 1 << 20 });
  source.load = (tiles) => {
    source.calls += 1;
    source.tiles += tiles.length;
    if (source.problem) {
      const { problem } = source;
      source.problem = null;
      throw problem;
    }
    for (const tile of tiles) {
      const { x, y: top, width, height } = tile.area;
      for (let y = 0; y < height; ++y) {
        const first = 4 * ((top + y) * side(WIDTH, tile.level) + x);
        tile.texels.set(levels[tile.level].subarray(first, first + 4 * width), y * tile.rowStride);
      }
      source.kept = tile;
    }
  };
  source.make = (more) => new shd.Texture(context, { ...desc, tiles: { cache: source.cache, load: source.load },
                                                     ...more });
  source.sample = (texture, missingTiles = "wait") => {
    const sampler = new shd.Sampler(context, { filter: "trilinear", missingTiles });
    return texture.sample(sampler, lookups).channel.map((channel) => new Uint32Array(channel.buffer));
  };
  source.expected = source.sample(memory);
  return source;
}

test("tiles/bits_of_memory", (shd, context) => {
  const source = makeSource(shd, context);
  const texture = source.make();
  assert.deepEqual(source.sample(texture), source.expected);
  const { loadCount, loadedTileCount, residentTileCount } = source.cache.stats;
  assert.deepEqual([loadCount, loadedTileCount, residentTileCount], [source.calls, source.tiles, source.tiles]);
  source.sample(texture);
  assert.equal(source.calls, loadCount);
  refused(() => source.kept.texels, "texels: the program of these columns has returned");
});

test("tiles/exception", (shd, context) => {
  const source = makeSource(shd, context);
  const problem = new RangeError("no tile");
  const sampler = new shd.Sampler(context, { filter: "trilinear" });
  const red = shd.allocate(Float32Array, COUNT);
  const columns = Object.fromEntries(Object.entries(lookups).map(([key, values]) => {
    const column = shd.allocate(Float32Array, COUNT);
    column.array.set(values);
    return [key, column];
  }));
  for (const call of [source.sample, (t) => t.loadTiles(REGION), (t) => t.pinTiles(REGION),
                      (t) => t.lookup(sampler, columns, { channel: [red] }).run()]) {
    const texture = source.make();
    source.problem = problem;
    assert.throws(() => call(texture), (got) => got === problem);
    assert.deepEqual(source.sample(texture), source.expected);
  }
  const texture = source.make();
  const batch = texture.lookup(sampler, columns, { channel: [red] });
  texture.close();  // the batch keeps the function
  batch.run();
  batch.close();
  assert.deepEqual(new Uint32Array(red.array.slice().buffer), source.expected[0]);
});

test("tiles/requested", (shd, context) => {
  const source = makeSource(shd, context);
  const texture = source.make();
  source.sample(texture, "coarser");
  assert.equal(source.calls, 0);
  source.problem = new RangeError("no tile");
  assert.throws(() => source.cache.loadRequested(), RangeError);
  do source.sample(texture, "coarser"); while (source.cache.loadRequested(8));
  assert.deepEqual(source.sample(texture, "coarser"), source.expected);
});

test("tiles/regions", (shd, context) => {
  const source = makeSource(shd, context);
  const texture = source.make();
  texture.pinTiles(REGION);
  assert.equal(source.cache.stats.pinnedTileCount, 12);
  texture.unpinTiles(REGION);
  assert.equal(source.cache.stats.pinnedTileCount, 0);
  assert.throws(() => texture.unpinTiles(REGION), /pinned/);
  texture.loadTiles(REGION);
  assert.equal(source.tiles, 12);
  texture.dropTiles(REGION);
  texture.loadTiles(REGION);
  assert.equal(source.tiles, 24);
});

test("tiles/lifetime", (shd, context) => {
  const source = makeSource(shd, context);
  const texture = source.make();
  const material = new shd.Material(context, { model: "unlit", slots: [{ target: "diffuse", texture }] });
  texture.close();
  source.cache.close();
  const framebuffer = new shd.Framebuffer(context, { width: 8, height: 8 });
  const mesh = shd.Mesh.shape(context, { kind: "sphere" });
  shd.render(context, { framebuffer, draws: [{ mesh, material }], camera: { eye: [0, 0, 3] } });
  assert(source.calls > 0);
});

test("tiles/refused", (shd, context) => {
  const source = makeSource(shd, context);
  refused(() => source.make({ depth: 2, tables: "ripmap" }), "texture.tables", "unsupported");
  refused(() => source.make({ tiles: { cache: source.cache, load: 3 } }), "desc.tiles.load: a function, not 3");
  refused(() => source.make({ tiles: { cache: context, load: source.load } }), "desc.tiles.cache: a tile_cache");
  refused(() => new shd.TileCache(context, { budgetBytes: 1 }), "tile_cache.budget_bytes: 1 is not");
  for (const budgetBytes of [NaN, Infinity, 0.5, -1, 2 ** 64]) {
    refused(() => new shd.TileCache(context, { budgetBytes }),
            `desc.budgetBytes: ${budgetBytes}, not an integer of 0..18446744073709551615`);
  }
  for (const count of [NaN, 0.5, -1, 2 ** 32]) {
    refused(() => source.cache.loadRequested(count), `maxTiles: ${count}, not an integer of 0..4294967295`);
  }
  refused(() => source.memory.loadTiles({ ...REGION, left: 1 }),
          "region.left: tile_region has no such field; there are layer, level, area");
});

/** Every struct that begins with its size has a kind, except those that the library gives to programs. */
test("tiles/kinds", (shd) => {
  const given = new Set(["fragments", "radiance", "vertices", "vertex_outputs", "rays", "present_tile"]);
  for (const [name, { size, kind, fields }] of Object.entries(structs)) {
    if (!fields.structSize || given.has(name)) continue;
    const address = shd.raw.malloc(size);
    assert.equal(shd.raw.shd_desc_init(kind, address, size), 0, name);
    assert.equal(shd.memory.view.getUint32(address, true), size, name);
    shd.raw.free(address);
  }
});
