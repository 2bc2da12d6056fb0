// SPDX-License-Identifier: MIT
// A tilted square with texture coordinates that are linear on the screen, and with those that are linear on the square.
import { Cache } from "../playground/cache.js";
import { enums } from "../lib/api.js";
import { textureOf } from "../playground/textures.js";
import { Picture } from "./picture.js";
import { COLOURS, label, MARK, number, panels } from "./paint.js";

const SIZE = 320, TITLE = 22, DISTANCE = 3.1, FOV = 0.9;
const WAYS = [["Affine", "affine"], ["Perspective-correct", "none"]];

export function make({ shd, context }) {
  if (!("affine" in enums.draw_flag)) throw new Error("this build has no affine interpolation");
  const { width: columns, height: rows, texels } = textureOf("checker");
  const texture = new shd.Texture(context, { format: "rgba8_srgb", width: columns, height: rows, texels,
                                             tables: "mipmap" });
  const sampler = new shd.Sampler(context, { filter: "anisotropic", wrapU: "clamp", wrapV: "clamp" });
  const slots = [{ target: "diffuse", texture, sampler, uvTransform: [0.5, 0, 0, 0, 0.5, 0] }];
  const material = new shd.Material(context, { model: "unlit", diffuse: [1, 1, 1], slots });
  const pictures = WAYS.map(() => new Picture({ shd, context }, SIZE, SIZE));
  const cache = new Cache();
  let places = null, tilt = 1.05, turn = 0.35;

  /** The square turned about its normal, and tilted away from the picture; without a tilt it faces the eye. */
  const matrix = () => {
    const [c, s, d, t] = [Math.cos(turn), Math.sin(turn), Math.sin(tilt), Math.cos(tilt)];
    return [c, s * t, -s * d, 0, 0, d, t, 0, s, -c * t, c * d, 0, 0, 0, 0, 1];
  };
  /** Depth and place in a panel of a point of the right edge, 0 = near end, 1 = far end. */
  function edgeAt(share, panel = { x: 0, y: 0, width: 1, height: 1 }) {
    const m = matrix(), z = 1 - 2 * share;
    const [x, y, depth] = [m[0] + m[8] * z, m[1] + m[9] * z, DISTANCE - m[2] - m[10] * z];
    const scale = 0.5 / (Math.tan(FOV / 2) * depth);
    return { depth, at: [panel.x + panel.width * (0.5 + scale * x), panel.y + panel.height * (0.5 - scale * y)] };
  }
  /** The share of the way along the edge that is shown halfway on the screen: correct, and affine in `count` parts. */
  function sharesOf(count) {
    const [near, far] = [edgeAt(0).depth, edgeAt(1).depth];
    const onScreen = (share) => (share * far) / ((1 - share) * near + share * far);
    let part = 0;
    while (part < count - 1 && onScreen((part + 1) / count) < 0.5) ++part;
    const [from, to] = [part, part + 1].map((k) => onScreen(k / count));
    return { near, far, share: near / (near + far), affine: (part + (0.5 - from) / (to - from)) / count };
  }

  return {
    label: "Affine and perspective-correct texture coordinates: drag to tilt the square",
    settings: { segments: { label: "Squares across", min: 1, max: 8, step: 1, value: 1 } },
    heightOf: (width) => layOut(width).height,
    handles: () => [{
      label: "Tilt", fill: COLOURS[0],
      at: [places[0].x + places[0].width * (0.5 + turn / 2), places[0].y + (places[0].height * tilt) / 1.6],
      move: (x, y) => {
        turn = Math.min(Math.max(2 * ((x - places[0].x) / places[0].width - 0.5), -0.8), 0.8);
        tilt = Math.min(Math.max((1.6 * (y - places[0].y)) / places[0].height, 0.2), 1.3);
      },
    }],
    draw(target, { width, ink }, { segments }) {
      ({ places } = layOut(width));
      const desc = { kind: "plane", size: [2, 1, 2], segments: [segments, 0, segments] };
      const mesh = cache.get("mesh", desc, () => shd.Mesh.shape(context, desc));
      const camera = { eye: [0, 0, DISTANCE], fovY: FOV };
      const { near, far, share, affine } = sharesOf(segments);
      WAYS.forEach(([name, flags], i) => {
        pictures[i].render({ draws: [{ mesh, material, flags, objectToWorld: matrix() }], camera,
                             clearColor: [0.03, 0.035, 0.045, 1] });
        pictures[i].draw(target, places[i]);
        label(target, name, [places[i].x + places[i].width / 2, places[i].y - TITLE / 2], { colour: ink, halo: null });
        target.beginPath();
        target.arc(...edgeAt(share, places[i]).at, 6, 0, 2 * Math.PI);
        Object.assign(target, { fillStyle: MARK, strokeStyle: "#000", lineWidth: 1 });
        target.fill();
        target.stroke();
      });
      cache.sweep();
      return {
        text: `Right edge: depth ${number(near)} at its near end, ${number(far)} at its far end\nAt the yellow point, `
          + `halfway on the screen, v is ${number(affine, 3)} of the way affine, and ${number(share, 3)} in perspective`,
        values: { near, far, share, affine },
      };
    },
  };
}

const layOut = (width) => panels(width, WAYS.length, { least: 150, most: 420, top: TITLE });
