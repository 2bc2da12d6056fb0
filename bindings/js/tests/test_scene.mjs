// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { readsFiles, refused, test as register } from "./support.mjs";
import { FILES, JPEG, PNG, externalModel } from "./scene_files.mjs";
import { hashLines } from "./scene_hash.mjs";
import { MODEL } from "./model.mjs";

const GLB = FILES["model.glb"], EXTERNAL = FILES["external.gltf"], BUFFER = FILES["square.bin"];
const test = readsFiles ? register : (name) => console.log(`skipped ${name}: the module reads no files`);
const PLAIN = "; its material is plain";
const MISSING = ["a.jpg", "b c.png"].map((name) => `cannot open "pictures/${name}": No such file or directory${PLAIN}`);

test("scene/hashes", (shd, context) => {
  const stored = readFileSync(new URL("scene_hashes.txt", import.meta.url), "utf8").trim().split("\n").slice(1);
  assert.deepEqual(hashLines(shd, context, FILES), stored);
});

test("scene/parts", (shd, context) => {
  const scene = new shd.Scene(context, EXTERNAL, { name: "external.gltf", find: FILES });
  assert.deepEqual(scene.warnings, []);
  assert.deepEqual(["mesh", "material", "texture", "light", "camera", "animation"].map((part) => scene.names(part).length),
                   [2, 2, 2, 1, 1, 0]);
  assert.deepEqual(scene.names("texture"), ["pictures/a.jpg", "pictures/b c.png"]);
  assert.deepEqual(scene.names("camera"), ["front"]);
  assert.deepEqual(scene.textures.map(({ info }) => [info.width, info.height, info.format]),
                   Array(2).fill([16, 16, "rgba8_srgb"]));
  assert.equal(scene.info.triangleCount, 4);
  assert.deepEqual(scene.cameras[0].eye, [0, 0, 5]);
  assert.deepEqual([...scene.meshes[0].read("positions")], [...MODEL.position]);
  const { min, max, center, radius } = scene.bounds;
  assert.deepEqual([max[1], min[1], center], [1, -1, [0, 0, 0]]);
  assert(Math.abs(radius - Math.hypot(2.1, 1)) < 1e-6);
  assert.equal(scene.draws[1].mesh, scene.meshes[1]);
  assert.equal(Math.fround(1.1), scene.draws[1].objectToWorld[12]);
  const frame = { clearColor: [0, 0, 0, 1] };
  assert.equal(scene.fillRender(frame), frame);
  assert.deepEqual([frame.draws.length, frame.lights[0]], [2, scene.lights[0]]);
  const [mesh] = scene.meshes;
  scene.close(), scene.close();
  assert(mesh.isClosed);
  refused(() => scene.info, "scene: the scene is closed");
  refused(() => scene.meshes, "scene: the scene is closed");
});

test("scene/find", (shd, context) => {
  const asked = [];
  const find = (name) => { asked.push(name); return FILES[name]?.buffer.slice(FILES[name].byteOffset,
      FILES[name].byteOffset + FILES[name].length); };
  assert.deepEqual(new shd.Scene(context, EXTERNAL, { find }).warnings, []);
  assert.deepEqual([...new Set(asked)].sort(), ["pictures/a.jpg", "pictures/b c.png", "square.bin"]);
  const some = new Map([["square.bin", BUFFER]]);
  assert.deepEqual(new shd.Scene(context, EXTERNAL, { find: some }).warnings, MISSING);
  assert.throws(() => new shd.Scene(context, EXTERNAL, { find() { throw new RangeError("mine"); } }),
                { name: "RangeError", message: "mine" });
  assert.throws(() => new shd.Scene(context, EXTERNAL, { find: async () => BUFFER }),
                { message: /^scene\.find: bytes or null for "[^"]+", not a value of type Promise$/ });
  assert.throws(() => new shd.Scene(context, EXTERNAL, { find: (name) => { shd.render(context, {}); return name; } }),
                { message: "shd_render: it may not be called inside a program" });
  refused(() => new shd.Scene(context, EXTERNAL, { find: 5 }), "desc.find: a function, not 5");
  assert.deepEqual(new shd.Scene(context, GLB).warnings, []);  // the instance works on
});

test("scene/refused", (shd, context) => {
  const scene = (bytes, options) => () => new shd.Scene(context, bytes, options);
  const required = (name) => Buffer.from(JSON.stringify({ ...externalModel(), extensionsRequired: [name] }));
  refused(scene(GLB.subarray(0, -40)), '"": binary glTF: the header says 2204 bytes, the file has 2164', "corrupt");
  refused(scene(GLB.subarray(0, 100), { name: "a.glb" }), '"a.glb": binary glTF: the header says 2204 bytes', "corrupt");
  refused(scene(Buffer.from("hello"), { name: "a.txt" }), '"a.txt": the content is not glTF 2.0, OBJ, PLY or STL',
          "unsupported");
  refused(scene(Buffer.from('{"asset":{"version":"2.0"')), '"": JSON: parse error at line 1, column 26', "corrupt");
  refused(scene(new Uint8Array(0)), "size: 0 bytes are no model", "corrupt");
  refused(scene(EXTERNAL, { name: "external.gltf" }), '"external.gltf": no triangles in it: mesh "meshes[1]": '
          + 'buffers[0].uri: cannot open "square.bin"', "unsupported");
  refused(scene(EXTERNAL, { find: { "square.bin": BUFFER }, flags: "require_textures" }),
          '"": cannot open "pictures/a.jpg": No such file', "not_found");
  refused(scene(required("VENDOR_a")), '"": required extensions are not supported: VENDOR_a', "unsupported");
  refused(scene(GLB, { maxTriangles: 1 }), '"": 2 triangles are above scene.max_triangles 1', "limit");
  refused(scene(GLB, { maxFileBytes: 100 }), 'with "" its files have more bytes than scene.max_file_bytes 100', "limit");
  refused(scene("model.glb"), 'bytes: a Uint8Array or an ArrayBuffer, not "model.glb"');
  refused(scene(GLB, { nam: "a.glb" }), "desc.nam: scene_desc has no such field");
  refused(() => new shd.Scene(context, GLB).names("triangle"), "part: triangle is none of mesh,");
  const moving = new shd.Scene(context, FILES["moving.gltf"]);
  assert.deepEqual(moving.animationTimes(0), [0, 2]);
  refused(() => moving.animationTimes(1), "animation: 1, but the scene has 1 animations", "not_found");
  refused(() => moving.pose("run", 1), 'animation: "run" is not one of ["slide"]');
});

test("scene/warnings", (shd, context) => {
  const lines = [];
  const logged = new shd.Context({ log: (level, message) => lines.push([level, message]) });
  const find = { ...FILES, "pictures/a.jpg": JPEG.subarray(0, 300), "pictures/b c.png": PNG.subarray(0, 200) };
  const { warnings } = new shd.Scene(logged, EXTERNAL, { find });
  assert.deepEqual(warnings, [`"pictures/a.jpg": JPEG: the end is missing${PLAIN}`,
                              `"pictures/b c.png": PNG: cut off at byte 200${PLAIN}`]);
  assert.deepEqual(lines.filter(([level]) => level === "warning").map(([, message]) => message), warnings);
});

test("scene/images", (shd, context) => {
  const bitmap = new shd.Bitmap(context, PNG);
  assert.deepEqual([bitmap.width, bitmap.height, bitmap.format, bitmap.colorSpace], [16, 16, "rgba8_srgb", "sRGB"]);
  assert.deepEqual([...bitmap.readPixels()], [...MODEL.texels]);
  assert.deepEqual(bitmap.info, { fileFormat: "png", flags: "none", channelCount: 4 });
  const picture = new shd.Bitmap(context, JPEG.buffer.slice(JPEG.byteOffset, JPEG.byteOffset + JPEG.length));
  assert.deepEqual([picture.info.fileFormat, picture.info.channelCount, picture.readPixels().length], ["jpeg", 3, 1024]);
  const texture = shd.Texture.load(context, PNG, { tables: "mipmap" });
  const sampler = new shd.Sampler(context, { filter: "nearest" });
  assert(Math.abs(texture.sample(sampler, { u: [0.5 / 16], v: [0.5 / 16] }).channel[3][0] - 1) < 1e-6);
  assert.equal(texture.info.levelCount, 5);
  const damaged = Uint8Array.from(PNG);
  damaged[200] ^= 255;
  for (const load of [(bytes) => new shd.Bitmap(context, bytes), (bytes) => shd.Texture.load(context, bytes)]) {
    refused(() => load(damaged), "PNG: the chunk at byte 33 is damaged", "corrupt");
    refused(() => load(JPEG.subarray(0, 200)), "JPEG: the end is missing", "corrupt");
    refused(() => load(Buffer.from(`GIF89a${" ".repeat(90)}`)), "the content is GIF, which load.formats does not allow",
            "unsupported");
    refused(() => load(Buffer.from("nothing")), "the content is of no known image format", "unsupported");
    refused(() => load([1, 2]), "bytes: a Uint8Array or an ArrayBuffer, not a value of type Array");
  }
});

test("scene/no_leak", (shd, context) => {
  const make = () => {
    const scene = new shd.Scene(context, EXTERNAL, { find: FILES });
    assert.equal(scene.draws.length, 2);
    scene.close();
    assert.throws(() => new shd.Scene(context, GLB.subarray(0, 1000)));
    assert.throws(() => new shd.Bitmap(context, PNG.subarray(0, 200)));
  };
  for (let i = 0; i < 10; ++i) make();
  const size = shd.memory.buffer.byteLength;
  for (let i = 0; i < 500; ++i) make();
  assert.equal(shd.memory.buffer.byteLength, size);
});

/** Numbers of a linear congruential generator (Knuth, 1997, section 3.3.4), so that a failure can be repeated. */
function makeRandom(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor(((state >>> 8) / 2 ** 24) * below);
  };
}

/** Files that are cut or changed are read, or refused with an error of shd. */
test("scene/mutants", (shd, context) => {
  const random = makeRandom(12345), digits = "0123456789-.,:[]{}\"e";
  const read = (name, bytes) => {
    const find = (other) => (other === name ? bytes : FILES[other]);
    const model = /^pictures|bin$/.test(name) ? "external.gltf" : name;
    const limits = { maxFileBytes: 2 ** 22, maxVertices: 2 ** 16, maxTriangles: 2 ** 16, timeLimit: 5 };
    try {
      new shd.Scene(context, find(model), { name: model, find, ...limits }).close();
      return true;
    } catch (problem) {
      assert.equal(problem.name, "ShdError", problem.stack);
      assert.notEqual(problem.result, "internal", problem.message);
      return false;
    }
  };
  let good = 0, bad = 0;
  for (const [name, whole] of Object.entries(FILES)) {
    for (let i = 0; i < 600; ++i) {
      const bytes = Uint8Array.from(i % 4 ? whole : whole.subarray(0, random(whole.length)));
      for (let k = random(4); bytes.length && k >= 0; --k) {
        bytes[random(bytes.length)] = random(2) ? random(256) : digits.charCodeAt(random(digits.length));
      }
      if (read(name, bytes)) good += 1; else bad += 1;
    }
  }
  assert(good > 500 && bad > 500, `${good} files were read, ${bad} refused`);
});
