// SPDX-License-Identifier: MIT
// Model files of the tests: node scene_files.mjs FOLDER writes them.
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { encodePng } from "../examples/png.mjs";
import { MODEL, makeModel } from "./model.mjs";

/** A picture of 16 x 16 pixels with colours at half the resolution. */
export const JPEG = Buffer.from(
  "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAA0JCgsKCA0LCgsODg0PEyAVExISEyccHhcgLikxMC4pLSwzOko+MzZGNywtQFdBRkxOUlNSMj5aYVpQ" +
  "YEpRUk//2wBDAQ4ODhMREyYVFSZPNS01T09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT09PT0//wAARCAAQABAD" +
  "ASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABQb/xAAbEAABBQEBAAAAAAAAAAAAAAARAAQFEyISgf/EABUBAQEAAAAAAAAAAAAAAAAAAAAD" +
  "/8QAHxEAAQIGAwAAAAAAAAAAAAAAEgAFAwQRITFBgaGy/9oADAMBAAIRAxEAPwCYax9Iz0fEu1j6RklKNY+kZJTDWPpGej4kedDYjyNfRdKrU4Yu" +
  "v//Z", "base64");
export const PNG = encodePng(MODEL.width, MODEL.height, MODEL.texels);

const { position, normal, uv, indices } = MODEL;
const BUFFER = Buffer.concat([position, normal, uv, indices].map((array) => Buffer.from(array.buffer)));

/** Two squares with pictures of their own, a camera and a light. Buffer and pictures are other files. */
export function externalModel() {
  const material = (index) => ({ pbrMetallicRoughness: { metallicFactor: 0, baseColorTexture: { index } } });
  const square = (index) => ({ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3,
                                              material: index }] });
  const light = { type: "directional", color: [1, 0.9, 0.8], intensity: 3 };
  return {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0, 1, 2, 3] }],
    extensionsUsed: ["KHR_lights_punctual"], extensions: { KHR_lights_punctual: { lights: [light] } },
    nodes: [{ mesh: 0, translation: [-1.1, 0, 0] }, { mesh: 1, translation: [1.1, 0, 0], name: "right" },
            { camera: 0, translation: [0, 0, 5] }, { extensions: { KHR_lights_punctual: { light: 0 } } }],
    cameras: [{ type: "perspective", perspective: { yfov: 0.8, znear: 0.1, zfar: 10 }, name: "front" }],
    meshes: [square(0), square(1)], materials: [material(0), material(1)],
    textures: [{ source: 0 }, { source: 1 }], images: [{ uri: "pictures/a.jpg" }, { uri: "pictures/b%20c.png" }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [-1, -1, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC3" },
      { bufferView: 2, componentType: 5126, count: 4, type: "VEC2" },
      { bufferView: 3, componentType: 5123, count: 6, type: "SCALAR" },
    ],
    bufferViews: [[0, 48], [48, 48], [96, 32], [128, 12]].map(
      ([byteOffset, byteLength]) => ({ buffer: 0, byteOffset, byteLength })),
    buffers: [{ uri: "square.bin", byteLength: BUFFER.length }],
  };
}

/** A square that moves to the right within two seconds. */
function movingModel() {
  const model = externalModel();
  const times = Buffer.from(Float32Array.of(0, 2, -1.1, 0, 0, 0.5, 0.25, 0).buffer);
  model.buffers = [{ uri: `data:application/octet-stream;base64,${Buffer.concat([BUFFER, times]).toString("base64")}`,
                     byteLength: BUFFER.length + 32 }];
  model.bufferViews.push({ buffer: 0, byteOffset: 140, byteLength: 8 }, { buffer: 0, byteOffset: 148, byteLength: 24 });
  model.accessors.push({ bufferView: 4, componentType: 5126, count: 2, type: "SCALAR", min: [0], max: [2] },
                       { bufferView: 5, componentType: 5126, count: 2, type: "VEC3" });
  model.animations = [{ name: "slide", channels: [{ sampler: 0, target: { node: 0, path: "translation" } }],
                        samplers: [{ input: 4, output: 5 }] }];
  for (const image of model.images) delete image.uri;
  Object.assign(model.images[0], { uri: `data:image/jpeg;base64,${JPEG.toString("base64")}` });
  Object.assign(model.images[1], { uri: `data:image/png;base64,${PNG.toString("base64")}` });
  return model;
}

const OBJ = `mtllib square.mtl
v -1 -1 0
v 1 -1 0
v 1 1 0.5
v -1 1 0.5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl painted
f 1/1 2/2 3/3 4/4
`;
const MTL = "newmtl painted\nKd 1 0.9 0.8\nmap_Kd pictures/b c.png\n";

/** All files by their names. */
export const FILES = {
  "model.glb": makeModel(), "external.gltf": Buffer.from(JSON.stringify(externalModel())),
  "moving.gltf": Buffer.from(JSON.stringify(movingModel())), "square.obj": Buffer.from(OBJ), "square.mtl": Buffer.from(MTL),
  "square.bin": BUFFER, "pictures/a.jpg": JPEG, "pictures/b c.png": PNG,
};

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const [name, bytes] of Object.entries(FILES)) {
    const path = join(process.argv[2], name);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, bytes);
  }
}
