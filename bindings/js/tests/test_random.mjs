// SPDX-License-Identifier: MIT
// Random values for every function: each call works or throws an error of this module, and the library goes on.
import assert from "node:assert/strict";
import { functions, structs } from "../lib/api.js";
import { structOf } from "../lib/layout.js";
import { ShdError, test } from "./support.mjs";

const ROUNDS = 40;

function generator(seed) {
  let state = seed;
  return (count) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 4294967296) * count);
  };
}

/** Values of many types; some fit a field, most do not. */
function makeValues(shd, context) {
  const framebuffer = new shd.Framebuffer(context, { width: 8, height: 8 });
  const mesh = shd.Mesh.shape(context, { kind: "box" });
  const texture = new shd.Texture(context, { format: "r8", width: 2, height: 2, texels: new Uint8Array(4),
      tables: "mipmap" });
  const objects = [context, framebuffer, mesh, texture, new shd.Sampler(context), new shd.Material(context),
      new shd.Light(context),
                   new shd.Shadow(context, { size: 16 })];
  const plain = [null, undefined, 0, 1, 2, 3, -1, 1.5, NaN, 1e30, true, "", "ewa", "rgba8", "lambert|toon",
      Symbol.iterator.description,
                 [], [1], [1, 2, 3], [0, 1, 2, 3], [[1, 2], [3]], {}, { u: [1], v: [1] }, new Float32Array(3),
                     new Float32Array(4),
                 new Uint32Array(3), new Uint8Array(64), new Float64Array(2), new ArrayBuffer(16), () => 0,
                     { data: new Float32Array(4), stride: 2 }];
  return [...plain, ...objects];
}

/** A desc with some fields of a struct. */
function randomDesc(name, pick, values, depth = 0) {
  const desc = {};
  for (const field of structOf(name).list) {
    if (pick(3)) continue;
    const isNested = (field.kind === "list" || field.kind === "struct") && structs[field.type] && depth < 3;
    desc[field.name] = isNested && pick(4) ? randomDesc(field.type, pick, values,
        depth + 1) : values[pick(values.length)];
  }
  return desc;
}

function argumentOf(word, pick, values) {
  const [kind, type] = word.split(":");
  if (!pick(5)) return values[pick(values.length)];
  if (kind === "handle") return values.find((value) => value?.kind === type);
  if (kind === "in" || kind === "inout") return randomDesc(type, pick, values);
  return values[pick(values.length)];
}

test("random/every_function", (shd, context) => {
  const pick = generator(2024);
  const values = makeValues(shd, context);
  let refusals = 0, successes = 0;
  for (const [name, [, parameters]] of Object.entries(functions)) {
    const words = parameters.map(([, word]) => word).filter((word) => !/^(new|read|write):/.test(word));
    for (let round = 0; round < ROUNDS; ++round) {
      try {
        shd.call(name, ...words.map((word) => argumentOf(word, pick, values)));
        successes += 1;
      } catch (problem) {
        assert(problem instanceof ShdError, `${name}: ${problem.stack}`);
        refusals += 1;
      }
    }
  }
  assert(successes > 100 && refusals > 1000, `${successes} calls worked, ${refusals} were refused`);
  assert.equal(new shd.Texture(context, { format: "r8", width: 1, height: 1, texels: [255] }).info.width, 1);
});

test("random/classes", (shd, context) => {
  const pick = generator(7);
  const values = makeValues(shd, context);
  const descs = { Texture: "texture_desc", Sampler: "sampler_desc", Mesh: "mesh_desc", Material: "material_desc",
      Light: "light_desc",
                  Framebuffer: "framebuffer_desc", Environment: "environment_desc", Shadow: "shadow_desc",
                      Volume: "volume_desc", Polyhedron: "polyhedron_desc" };
  for (const [name, desc] of Object.entries(descs)) {
    for (let round = 0; round < 10 * ROUNDS; ++round) {
      try {
        new shd[name](context, randomDesc(desc, pick, values)).close();
      } catch (problem) {
        assert(problem instanceof ShdError, `${name}: ${problem.stack}`);
      }
    }
  }
});
