// SPDX-License-Identifier: MIT
// The three programs that every binding has (bindings/c/programs.c), for Node and browsers.
//
//   node programs.mjs            prints the hashes
//   node programs.mjs --speed    prints the time of a call of one lookup, and of a batch of 2^20
import { load } from "../lib/index.js";

const SIZE = 64;
const LOOKUPS = 16384;

/** FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte, in two halves of 32 bits. */
export function hashBytes(bytes, [high, low] = [0xcbf29ce4, 0x84222325]) {
  for (const byte of bytes) {
    low ^= byte;
    const product = (low >>> 0) * 0x1b3;
    high = (Math.imul(high, 0x1b3) + Math.floor(product / 0x100000000) + ((low & 0xffffff) << 8)) >>> 0;
    low = product >>> 0;
  }
  return [high >>> 0, low >>> 0];
}

const hex = (hash) => hash.map((word) => word.toString(16).padStart(8, "0")).join("");

function createTexture(shd, context) {
  const texels = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 0, i = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x, i += 4) texels.set([x * 4, y * 4, (x ^ y) * 4, 255], i);
  }
  return new shd.Texture(context, { width: SIZE, height: SIZE, format: "rgba8_srgb", texels, tables: "mipmap" });
}

/** 1. A batch of lookups: footprints of many sizes and directions, filtered with EWA. */
function lookUp(shd, context) {
  const texture = createTexture(shd, context);
  const sampler = new shd.Sampler(context, { filter: "ewa", maxAnisotropy: 16 });
  const column = (f) => Float32Array.from({ length: LOOKUPS }, (_, i) => f(i));
  const { channel } = texture.sample(sampler, {
    u: column((i) => (i % 128) / 64),
    v: column((i) => Math.floor(i / 128) / 128),
    dudx: column((i) => (1 + (i % 7)) / 256),
    dvdx: column((i) => (i % 5) / 512),
    dudy: column((i) => (i % 3) / -512),
    dvdy: column((i) => (1 + (i % 11)) / 1024),
  });
  let hash;
  for (const values of channel) hash = hashBytes(new Uint8Array(values.buffer), hash);
  return hash;
}

/** A torus of one material in the light of the sun, with four samples a pixel, as RGBA8 in sRGB. */
function draw(shd, context, material) {
  const framebuffer = new shd.Framebuffer(context, { width: 320, height: 200, sampleCount: 4 });
  shd.render(context, {
    framebuffer,
    draws: [{ mesh: shd.Mesh.shape(context, { kind: "torus" }), material }],
    lights: [new shd.Light(context, { kind: "directional", direction: [-0.5, -1, -0.25] })],
    camera: { eye: [0.5, 1.5, 2] },
  });
  return framebuffer.readColor("rgba8_srgb");
}

/** 2. A frame: the material has a texture. */
function drawTextured(shd, context) {
  const texture = createTexture(shd, context);
  const sampler = new shd.Sampler(context, { filter: "trilinear", maxAnisotropy: 16 });
  const slots = [{ target: "diffuse", texture, sampler }];
  return draw(shd, context, new shd.Material(context, { model: "blinn_phong", slots }));
}

/** 3. A fragment program: shows the texture coordinates. */
function drawProgram(shd, context) {
  const fragment = (fragments, out) => {
    out.r.set(fragments.u);
    out.g.set(fragments.v);
    out.b.fill(0.25);
  };
  return draw(shd, context, new shd.Material(context, { model: "program", program: { fragment } }));
}

/** The lines of bindings/programs.txt, and the pixels of the frame. */
export function runPrograms(shd) {
  const context = new shd.Context();
  const lookup = lookUp(shd, context);
  const frame = drawTextured(shd, context);
  const program = drawProgram(shd, context);
  const lines = [`lookup ${hex(lookup)}`, `frame ${hex(hashBytes(frame))}`, `program ${hex(hashBytes(program))}`];
  return { lines, frame };
}

/** Seconds of `calls` calls, the best of seven. */
function measure(run, calls) {
  let best = Infinity;
  for (let trial = 0; trial < 7; ++trial) {
    const start = performance.now();
    for (let i = 0; i < calls; ++i) run();
    best = Math.min(best, performance.now() - start);
  }
  return best / 1e3 / calls;
}

/** Lines with the time of one lookup, and of 2^20. */
export function runSpeed(shd) {
  const count = 1 << 20;
  const context = new shd.Context({ workerCount: 1 });
  const texture = createTexture(shd, context);
  const sampler = new shd.Sampler(context, { filter: "trilinear", maxAnisotropy: 16 });
  const [u, v, lod, ...channel] = Array.from({ length: 7 }, () => shd.allocate(Float32Array, count));
  const fill = (column, f) => column.array.forEach((_, i, array) => { array[i] = f(i); });
  fill(u, (i) => (i % 1024) / 1024);
  fill(v, (i) => Math.floor(i / 1024) / 1024);
  fill(lod, (i) => (i % 16) / 8);
  const first = (column) => column.array.subarray(0, 1);
  const one = texture.lookup(sampler, { u: first(u), v: first(v), lod: first(lod) }, { channel: channel.map(first) });
  const all = texture.lookup(sampler, { u, v, lod }, { channel });
  return [`call ${(1e9 * measure(() => one.run(), 200000)).toFixed(2)} ns`,
          `batch ${(1e3 * measure(() => all.run(), 3)).toFixed(4)} ms`];
}

if (typeof process !== "undefined" && process.argv?.[1]?.endsWith("programs.mjs")) {
  const shd = await load(process.env.SHD_WASM);
  console.log((process.argv[2] === "--speed" ? runSpeed(shd) : runPrograms(shd).lines).join("\n"));
}
