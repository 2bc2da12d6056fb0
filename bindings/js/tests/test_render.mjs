// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { refused, test } from "./support.mjs";
import { runPrograms } from "../examples/programs.mjs";

function scene(shd, context, material) {
  const framebuffer = new shd.Framebuffer(context, { width: 64, height: 48, aovs: "uv|level" });
  const mesh = shd.Mesh.shape(context, { kind: "torus" });
  const draws = [{ mesh, material: new shd.Material(context, material) }];
  return { framebuffer, draws, camera: { eye: [0, 1, 3] } };
}

const program = (fragment) => ({ model: "program", program: { fragment } });

test("render/programs", (shd) => {
  const stored = readFileSync(new URL("../../programs.txt", import.meta.url), "utf8");
  assert.equal(`${runPrograms(shd).lines.join("\n")}\n`, stored);
});

test("render/planes", (shd, context) => {
  const frame = scene(shd, context, {});
  const stats = shd.render(context, frame);
  assert(stats.fragmentCount > 500 && stats.triangleCount > 100);
  const depth = frame.framebuffer.readPlane("depth"), view = frame.framebuffer.viewPlane("depth");
  const rows = Array.from({ length: 48 }, (_, y) => [...view.array.subarray(y * view.rowStride,
      y * view.rowStride + 64)]);
  assert.deepEqual(rows.flat(), [...depth]);
  assert(frame.framebuffer.readPlane("level") instanceof Uint32Array);
  assert.equal(frame.framebuffer.readColor("rgba32f").length, 64 * 48 * 4);
  refused(() => frame.framebuffer.readColor("r8"), "format: r8 is none of");
  refused(() => frame.framebuffer.readColor("rgba8", new Uint8ClampedArray(5)), "out.pixels: 5 bytes, fewer than");
  refused(() => frame.framebuffer.viewPlane("nx"), "plane: 7", "not_found");
  refused(() => frame.framebuffer.viewPlane("hue"), "plane: hue is none of");
});

test("render/short_columns", (shd, context) => {
  const { framebuffer, draws } = scene(shd, context, {});
  refused(() => shd.call("shd_framebuffer_read_plane", framebuffer, "depth",
      new Float32Array(8)), "out: 8 elements, not 3072");
  refused(() => shd.call("shd_mesh_read_indices", draws[0].mesh, new Uint32Array(8)), "out: 8 elements, not");
  const { vertexCount } = draws[0].mesh.info;
  const column = () => new Float32Array(vertexCount);
  refused(() => shd.call("shd_mesh_read_uv", draws[0].mesh, [column(), column().subarray(1)]),
          `out[1]: ${vertexCount - 1} elements, not ${vertexCount}`);
  refused(() => shd.call("shd_mesh_read_uv", framebuffer, [column()]), "mesh: a mesh, not");
});

test("render/throwing_program", (shd, context) => {
  const frame = scene(shd, context, program(() => { throw new RangeError("no colours left"); }));
  assert.throws(() => shd.render(context, frame), /RangeError: no colours left/);
  assert.throws(() => shd.render(context, frame), RangeError);
  frame.draws = [];
  shd.render(context, frame);  // the next frame is not concerned
});

test("render/program_misuse", (shd, context) => {
  let kept;
  const frame = scene(shd, context, program((fragments) => { kept = fragments; }));
  shd.render(context, frame);
  refused(() => kept.u, "u: the program of these columns has returned");
  const nested = scene(shd, context, program(() => shd.render(context, frame)));
  refused(() => shd.render(context, nested), "shd_render: it may not be called inside a program");
  const closing = scene(shd, context, program(() => closing.draws[0].material.close()));
  shd.render(context, closing);  // closed after the frame
  refused(() => shd.render(context, closing), "desc.draws[0].material: the material is closed");
  refused(() => new shd.Material(context, program(7)), "desc.program.fragment: a function, not 7");
});

test("render/program_lookups", (shd, context) => {
  const texture = new shd.Texture(context, { format: "r8", width: 1, height: 1, texels: [51] });
  const sampler = new shd.Sampler(context);
  const frame = scene(shd, context, program((fragments, out) => {
    const { channel } = texture.sample(sampler, { u: fragments.u, v: fragments.v });
    out.r.set(channel[0]);
  }));
  shd.render(context, frame);
  const pixels = frame.framebuffer.readColor("rgba32f");
  assert(pixels.some((v, i) => i % 4 === 0 && Math.abs(v - 0.2) < 1e-6));
});

test("render/callbacks", (shd, context) => {
  const fractions = [], tiles = [];
  const frame = { ...scene(shd, context, {
    slots: [{ target: "diffuse", procedure: (fragments, out) => out[0].fill(0.5) }],
    program: { vertex: (vertices, out) => out.u.set(vertices.v) },
  }) };
  shd.render(context, { ...frame, progress: (f) => { fractions.push(f); }, present: (tile) => tiles.push([tile.area.x,
      tile.area.y, tile.channel[0][0]]) });
  assert.equal(fractions.at(-1), 1);
  assert.equal(tiles.length, 1);
  shd.render(context, { ...frame, progress: () => true });
  refused(() => shd.render(context, { ...frame, progress: () => false }), "", "cancelled");
  const lines = [];
  const logged = new shd.Context({ log: (level, message) => lines.push([level, message]) });
  shd.raw.shd_context_log(logged.reference("context").handle, 2, shd.memory.writeText("hello", "text"));
  assert.deepEqual(lines, [["warning", "hello"]]);
});

test("render/vertex_program_throws", (shd, context) => {
  const frame = scene(shd, context, { program: { vertex: () => { throw new TypeError("vertex"); } } });
  assert.throws(() => shd.render(context, frame), TypeError);
});

test("render/shadow_environment_volume", (shd, context) => {
  const pixels = new Float32Array(8 * 4 * 4).fill(0.5);
  const environment = new shd.Environment(context, { image: { format: "rgba32f", width: 8, height: 4, pixels } });
  assert(Math.abs(environment.info.mean[0] - 0.5) < 1e-3);
  const light = new shd.Light(context, { kind: "directional", direction: [0, -1, 0] });
  const shadow = new shd.Shadow(context, { size: 64 });
  const frame = scene(shd, context, { model: "metallic_roughness" });
  shadow.render(context, { light, draws: frame.draws, nearPlane: -5, farPlane: 5, boundsMin: [-2, -2, -2],
      boundsMax: [2, 2, 2] });
  const points = { position: [[0, 1, NaN], [-1, -1, 0], [0, 0, 0]] };  // below the hole, below the ring, nowhere
  const shaded = shadow.sample(points, { visibility: new Float32Array(3) });
  assert.deepEqual([...shaded.visibility.subarray(0, 2), shaded.nonfiniteCount], [1, 0, 1]);
  const depths = shadow.readMap();
  assert.deepEqual([shadow.info.faceCount, depths.length, depths[0]], [1, 64 * 64, Infinity]);
  assert(depths.some((depth) => Math.abs(depth) < 2));
  const channel = [0, 1, 2].map(() => new Float32Array(2));
  for (const sample of ["sampleIrradiance", "sampleRadiance"]) {
    const made = environment[sample]({ direction: [[0, NaN], [1, 0], [0, 0]] }, { channel });
    const expected = sample === "sampleRadiance" ? 0.5 : Math.PI / 2;
    assert(Math.abs(channel[1][0] - expected) < 1e-2, channel[1][0]);
    assert.equal(made.nonfiniteCount, 1);
  }
  const stats = shd.render(context, { ...frame, lights: [light], shadows: [shadow], environment });
  assert(stats.fragmentCount > 500);
  refused(() => shd.render(context, { ...frame, lights: [light], shadows: [shadow,
      null] }), "desc.shadows: 2 elements, not lightCount = 1");
});
