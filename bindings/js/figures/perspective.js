// SPDX-License-Identifier: MIT
// A tilted square with texture coordinates that are linear on the screen, and with those that are linear on the square.
import { enums } from "../lib/api.js";
import { textureOf } from "../playground/textures.js";
import { Picture } from "./picture.js";
import { COLOURS, label, number, panels } from "./paint.js";

const SIZE = 320, TITLE = 22;
const WAYS = [["Affine", "affine"], ["Perspective-correct", "none"]];

export function make({ shd, context }) {
  if (!("affine" in enums.draw_flag)) throw new Error("this build has no affine interpolation");
  const { width: columns, height: rows, texels } = textureOf("checker");
  const texture = new shd.Texture(context, { format: "rgba8_srgb", width: columns, height: rows, texels, tables: "mipmap" });
  const sampler = new shd.Sampler(context, { filter: "anisotropic", wrapU: "clamp", wrapV: "clamp" });
  const pictures = WAYS.map(() => new Picture({ shd, context }, SIZE, SIZE));
  const material = new shd.Material(context, { model: "unlit", diffuse: [1, 1, 1],
                                               slots: [{ target: "diffuse", texture, sampler }] });
  const meshes = new Map();
  let places = null, tilt = 1.05, turn = 0.35;

  const meshOf = (segments) => {
    if (!meshes.has(segments)) {
      meshes.set(segments, shd.Mesh.shape(context, { kind: "plane", size: [2, 1, 2], segments: [segments, 0, segments] }));
    }
    return meshes.get(segments);
  };
  /** The square turned about y, then tilted away from the picture. */
  const matrix = () => {
    const [c, s, d, t] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const rotate = [c, s * t, -s * d, 0, 0, d, t, 0, s, -c * t, c * d, 0, 0, 0, 0, 1];
    return rotate;
  };
  const CAMERA = { eye: [0, 0.9, 2.6], target: [0, -0.05, 0], fovY: 0.9 };

  /** The share of the way from the near to the far edge that a step of 1/2 on the screen has on the square. */
  function middleOf() {
    const m = matrix();
    const length = Math.hypot(...CAMERA.eye);
    const depth = (z) => CAMERA.eye.reduce((sum, e, i) => sum + (e - m[8 + i] * z) * e, 0) / length;
    const [near, far] = [depth(1), depth(-1)];
    return { near, far, share: near / (near + far) };
  }

  return {
    label: "Affine and perspective-correct texture coordinates: drag to tilt the square",
    settings: { segments: { label: "Squares across", min: 1, max: 8, step: 1, value: 1 } },
    heightOf: (width) => layOut(width).height,
    handles: () => [{
      label: "Tilt", at: [places[0].x + places[0].width * (0.5 + turn / 2), places[0].y + places[0].height * (tilt / 1.6)],
      fill: COLOURS[0],
      move: (x, y) => {
        turn = Math.min(Math.max(2 * ((x - places[0].x) / places[0].width - 0.5), -0.8), 0.8);
        tilt = Math.min(Math.max((1.6 * (y - places[0].y)) / places[0].height, 0.2), 1.35);
      },
    }],
    draw(target, { width, ink }, { segments }) {
      ({ places } = layOut(width));
      WAYS.forEach(([name, flags], i) => {
        pictures[i].render({ draws: [{ mesh: meshOf(segments), material, flags, objectToWorld: matrix() }], camera: CAMERA,
                             clearColor: [0.03, 0.035, 0.045, 1] });
        pictures[i].draw(target, places[i]);
        label(target, name, [places[i].x + places[i].width / 2, places[i].y - TITLE / 2], { colour: ink, halo: null });
      });
      const { near, far, share } = middleOf();
      return {
        text: `Depth of the near edge ${number(near)}, of the far edge ${number(far)}\n`
          + `Halfway between them on the screen, affine v is 0.500 of the way; perspective-correct v is ${number(share, 3)}`,
        values: { near, far, share },
      };
    },
  };
}

const layOut = (width) => panels(width, WAYS.length, { least: 150, most: 420, top: TITLE });
