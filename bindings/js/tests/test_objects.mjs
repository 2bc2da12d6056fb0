// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { inspect } from "node:util";
import { grey, load, refused, test, threads } from "./support.mjs";

test("objects/close", (shd, context) => {
  const sampler = new shd.Sampler(context);
  const texture = grey(shd, context);
  sampler.close(), sampler.close();
  refused(() => texture.sample(sampler, { u: [0], v: [0] }), "sampler: the sampler is closed");
  texture.close();
  refused(() => texture.info, "texture: the texture is closed");
  context.close();
  refused(() => new shd.Sampler(context), "context: the context is closed");
});

test("objects/printed", (shd, context) => {
  assert.equal(inspect(context), `Context { simdTarget: 'WASM', workerCount: ${threads ?? 1} }`);
  assert.match(inspect(grey(shd, context)), /^Texture \{\s+info: \{\s+kind: '2d',\s+format: 'r8',\s+width: 4,/);
  assert.equal(inspect([shd.Mesh.shape(context, { kind: "plane" })], { depth: 0 }).split("\n").length, 1);
  const sampler = new shd.Sampler(context);
  assert.equal(inspect(sampler), "Sampler {}");
  sampler.close();
  assert.equal(inspect(sampler), "Sampler { isClosed: true }");
  assert(inspect(shd).split("\n").length < 25, inspect(shd));
});

const OCTAHEDRON = { vertexCount: 6, indexCount: 24,
                     position: [[1, 0, 0, -1, 0, 0], [0, 1, 0, 0, -1, 0], [0, 0, 1, 0, 0, -1]],
                     indices: [0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5] };
// The first bits of SHA-256 of the weights, as native libshd has them.
const WEIGHTS = { mean_value: "46b2901333d77f14", wachspress: "a2f46c3f2cf58ab0" };

test("objects/polyhedron", (shd, context) => {
  const count = 1000, position = [0, 1, 2].map(() => new Float32Array(count));
  for (let i = 0, seed = 1; i < 3 * count; ++i) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    position[i % 3][Math.floor(i / 3)] = (seed >>> 8) / 2 ** 24 * 3 - 1.5;
  }
  for (const kind of ["mean_value", "wachspress"]) {
    const cage = new shd.Polyhedron(context, { ...OCTAHEDRON, kind }), hash = createHash("sha256");
    const { weight, outsideCount } = cage.evaluate({ count, position },
                                                   { weight: OCTAHEDRON.position[0].map(() => new Float32Array(count)) });
    for (const column of weight) hash.update(new Uint8Array(column.buffer));
    assert.equal(hash.digest("hex").slice(0, 16), WEIGHTS[kind]);
    assert(outsideCount > 500 && outsideCount < count, outsideCount);
    const value = [new Float32Array(1)];
    cage.interpolate({ count: 1, position: [[0.25], [0.5], [0]] }, { valueCount: 1, vertexValue: [OCTAHEDRON.position[1]],
                                                                    value });
    assert(Math.abs(value[0][0] - 0.5) < 1e-6, value[0][0]);
    cage.close();
  }
  const cage = new shd.Polyhedron(context, OCTAHEDRON), points = { count: 2, position: [[0, 0], [0, 0], [0, 0]] };
  refused(() => cage.interpolate(points, { vertexValue: [[1, 2, 3, 4, 5]], value: [new Float32Array(2)] }),
          "out.vertexValue[0]: 5 elements, not 6");
  refused(() => cage.interpolate(points, { vertexValue: [OCTAHEDRON.position[0]], value: [new Float32Array(1)] }),
          "out.value[0]: 1 elements, not 2");
  refused(() => cage.evaluate(points, { weight: [new Float32Array(2)] }), "weights.weight_count: 1 is not in 6..6");
  refused(() => new shd.Polyhedron(context, { ...OCTAHEDRON, vertexCount: undefined }), "desc.vertexCount");
  refused(() => new shd.Polyhedron(context, { ...OCTAHEDRON, indexCount: 21, indices: OCTAHEDRON.indices.slice(3) }),
          "polyhedron");
});

test("objects/no_leak", (shd, context) => {
  const make = () => {
    const texture = grey(shd, context, 64), sampler = new shd.Sampler(context);
    const material = new shd.Material(context, { slots: [{ target: "diffuse", texture, sampler }] });
    for (const object of [texture, sampler, material]) object.close();
    for (const desc of [{ filter: "best" }, { maxAnisotropy: 1e9 }]) assert.throws(() => new shd.Sampler(context,
        desc));
  };
  for (let i = 0; i < 10; ++i) make();
  const size = shd.memory.buffer.byteLength;
  for (let i = 0; i < 5000; ++i) make();
  assert.equal(shd.memory.buffer.byteLength, size);
});

test("objects/descs", (shd, context) => {
  assert.equal(shd.version, "0.1.0");
  assert.equal(context.simdTarget, "WASM");
  assert.equal(context.workerCount, threads ?? 1);
  const texture = grey(shd, context);
  assert.deepEqual({ ...texture.info, byteSize: 0 }, {
    kind: "2d", format: "r8", width: 4, height: 4, layerCount: 1, levelCount: 3, tables: "mipmap", flags: "none", byteSize: 0, depth: 0,
    projection: "none",
  });
  const camera = shd.call("shd_view_from_camera", { eye: [0, 0, 5] });
  assert.deepEqual(camera.eye, [0, 0, 5]);
  assert.deepEqual([...shd.call("shd_matrix_invert", new Float32Array([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0,
      1]))],
                   [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]);
  assert.deepEqual(shd.call("shd_shape_count", { kind: "plane" }), { vertexCount: 4, indexCount: 6 });
});

test("objects/misuse", async (shd, context) => {
  const texture = (desc) => () => new shd.Texture(context, desc);
  const texels = new Uint8Array(4);
  refused(texture({ format: "r8", width: 4, height: 4, texels }), "desc.texels: 4 bytes, fewer than the 16");
  refused(texture({ format: "r9", width: 1, height: 1, texels }), "desc.format: no format is \"r9\"; did you mean r8?");
  refused(texture({ format: "r8", width: 1.5, height: 1, texels }), "desc.width: 1.5, not an integer of 0..4294967295");
  refused(texture({ format: "r8", width: 0, height: 1, texels }), "texture.width: 0");
  refused(texture({ format: "r8", width: 2, height: 2, texels, flags: "borrow" }), "desc.texels: borrowed texels");
  refused(texture({ format: "r8", width: 2, height: 2, texels: [0, 0, 0, 256] }), "desc.texels[3]: an integer of 0..255, not 256");
  refused(texture("r8"), "desc: an object with fields of texture_desc, not \"r8\"");
  refused(() => new shd.Sampler(context, { anisotropy: 8 }),
          "desc.anisotropy: sampler_desc has no such field; did you mean maxAnisotropy?");
  refused(() => new shd.Sampler(context, { max_anisotropy: 8 }),
          "desc.max_anisotropy: sampler_desc has no such field; did you mean maxAnisotropy?");
  refused(() => new shd.Sampler(context, { filter: "ewwa" }), 'desc.filter: no filter is "ewwa"; did you mean ewa?');
  refused(() => new shd.Sampler(context, { filter: "best" }), 'desc.filter: no filter is "best"; lib/api.d.ts lists');
  refused(() => new shd.Sampler(context, { maxAnisotropy: "8" }), "desc.maxAnisotropy: a number, not \"8\"");
  refused(() => new shd.Sampler(context, { maxAnisotropy: 100 }), "sampler.max_anisotropy: 100");
  refused(() => new shd.Sampler(context, { border: [1, 2] }), "desc.border: 2 numbers, not 4");
  refused(() => new shd.Sampler({}), "context: the first argument is a Context");
  refused(() => new shd.Context({ simd: "avx2" }), "context.simd", "unsupported");
  refused(() => shd.allocate(Float32Array, -1), "length: -1");
  refused(() => shd.allocate(Array, 1), "type: a constructor");
  refused(() => shd.allocate(Uint8Array, 3e9), "3000000000 bytes could not be", "out_of_memory");
  const other = await load();
  refused(() => new shd.Material(context, { slots: [{ target: "diffuse", texture: grey(other,
      new other.Context()) }] }),
          "desc.slots[0].texture: it belongs to another instance");
});

test("objects/borrow", (shd, context) => {
  const texels = shd.allocate(Uint8Array, 4);
  texels.array.fill(255);
  const texture = new shd.Texture(context, { format: "r8", width: 2, height: 2, texels, flags: "borrow" });
  assert.equal(texture.sample(new shd.Sampler(context), { u: [0.5], v: [0.5] }).channel[0][0], 1);
  refused(() => new shd.Context({ executor: { parallelFor() {} } }), "desc.executor: not available");
  refused(() => new shd.Context({ allocator: {} }), "desc.allocator: not available");
});

test("objects/out_of_memory", (shd, context) => {
  const make = () => new shd.Framebuffer(context, { width: 16384, height: 16384, sampleCount: 16 });
  refused(make, "", "out_of_memory");
  assert.equal(grey(shd, context).info.width, 4);  // the library goes on
});

test("objects/mesh", (shd, context) => {
  const position = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const mesh = new shd.Mesh(context, { position, indices: [0, 1, 2], uv: [0, 0, 1, 0, 0, 1], attributes: [[1, 2, 3]] });
  assert.equal(mesh.info.triangleCount, 1);
  assert.deepEqual(mesh.read("positions"), position);
  assert.deepEqual([...mesh.readIndices()], [0, 1, 2]);
  assert.deepEqual([...mesh.readAttribute(0)], [1, 2, 3]);
  assert.equal(mesh.tessellate(context, { segments: 2 }).info.triangleCount, 4);
  const projected = new shd.Mesh(context, { position, uvProjection: "planar" });
  assert.deepEqual([...projected.read("uv")].slice(0, 2), [0.5, 0.5]);
  const doubles = Float64Array.from(position), integers = Int32Array.of(0, 1, 2);
  const converted = new shd.Mesh(context, { position: doubles, indices: integers });
  assert.deepEqual(converted.read("positions"), position);
  const shifted = { data: Float64Array.from([9, ...position]), offset: 1 };
  const strided = new shd.Mesh(context, { position: shifted, indices: Uint8Array.of(0, 1, 2) });
  assert.deepEqual(strided.read("positions"), position);
  const indexed = (indices) => () => new shd.Mesh(context, { position, indices });
  refused(indexed(Int32Array.of(0, 1, -1)), "desc.indices[2]: an integer of 0..4294967295, not -1");
  refused(indexed([0, 1.5, 2]), "desc.indices[1]: an integer of 0..4294967295, not 1.5");
  refused(indexed(Float32Array.of(0, 1, 2)),
          "desc.indices: a Uint32Array, not a value of type Float32Array; Uint32Array.from");
  refused(() => new shd.Mesh(context, { position, uv: [0, 0] }), "desc.uv: 1 elements, not vertexCount = 3");
  refused(() => new shd.Mesh(context, { position
      : position.subarray(1) }), "desc.position: 8 elements, not a multiple of 3");
  refused(() => new shd.Mesh(context, { position, attributes: [[1, 2]] }), "desc.attributes[0]: 2 elements, not 3");
  refused(() => new shd.Mesh(context, { position, indices: [0, 1, 3] }), "mesh.indices");
  refused(() => mesh.read("colour"), "part: colour");
  const shape = shd.Mesh.shape(context, { kind: "plane" });
  assert(shape instanceof shd.Mesh);
  assert.deepEqual([...shape.read("uv")].sort(), [0, 0, 0, 0, 1, 1, 1, 1]);
});
