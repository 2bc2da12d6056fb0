// SPDX-License-Identifier: MIT
// A model as arrays and as a GLB file (glTF 2.0, section 4): a square with a texture of 16 x 16 texels.
import { encodePng } from "../examples/png.mjs";

const SIDE = 16;

export const MODEL = {
  position: Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0),
  normal: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
  uv: Float32Array.of(0, 1, 1, 1, 1, 0, 0, 0),
  indices: Uint16Array.of(0, 1, 2, 0, 2, 3),
  matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.25, 0.5, 0, 1],
  color: [1, 0.75, 0.5], roughness: 0.75,
  width: SIDE, height: SIDE,
  texels: Uint8Array.from({ length: SIDE * SIDE * 4 }, (_, i) => (i % 4 === 3 ? 255 : (i * 7919) % 251)),
};

/** Bytes with a length that is a multiple of 4. */
const padded = (bytes, fill = 0) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, fill)]);

function chunk(type, bytes, fill) {
  const whole = padded(Buffer.from(bytes), fill);
  const head = Buffer.alloc(8);
  head.writeUInt32LE(whole.length, 0);
  head.write(type, 4, "latin1");
  return Buffer.concat([head, whole]);
}

/** The bytes of model.glb. */
export function makeModel() {
  const { position, normal, uv, indices, color, roughness, matrix } = MODEL;
  const arrays = [position, normal, uv, indices].map((array) => Buffer.from(array.buffer));
  const parts = [...arrays, encodePng(SIDE, SIDE, MODEL.texels)].map((bytes) => padded(bytes));
  let byteOffset = 0;
  const bufferViews = parts.map(({ length }) => {
    byteOffset += length;
    return { buffer: 0, byteOffset: byteOffset - length, byteLength: length };
  });
  bufferViews[3].byteLength = indices.byteLength;
  const json = {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, matrix }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [...color, 1], metallicFactor: 0, roughnessFactor: roughness,
                                          baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }], images: [{ bufferView: 4, mimeType: "image/png" }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 4, type: "VEC3", min: [-1, -1, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: 5126, count: 4, type: "VEC3" },
      { bufferView: 2, componentType: 5126, count: 4, type: "VEC2" },
      { bufferView: 3, componentType: 5123, count: 6, type: "SCALAR" },
    ],
    bufferViews, buffers: [{ byteLength: byteOffset }],
  };
  const chunks = Buffer.concat([chunk("JSON", JSON.stringify(json), 0x20), chunk("BIN\0", Buffer.concat(parts))]);
  const head = Buffer.alloc(12);
  head.write("glTF", 0, "latin1");
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + chunks.length, 8);
  return Buffer.concat([head, chunks]);
}
