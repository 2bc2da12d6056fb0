// SPDX-License-Identifier: MIT
// Draws in a worker, so that the page answers while a slow frame is drawn.
import { serve } from "../lib/pool.js";
import { describe } from "./scene.js";
import { falseColour, LEVELS, ratioOf, RATIO_COLOURS } from "./falsecolour.js";
import { Renderer } from "./renderer.js";
import { setTexture } from "./textures.js";

/** Replaces the colours of pixels by those of a view. `first` is the number of the first pixel. */
function applyView(made, view, pixels, first) {
  if (view === "shaded") return undefined;
  const read = (plane) => made.readPlane(plane).subarray(first, first + pixels.length / 4);
  const depth = read("depth");
  if (view === "level") {
    const level = read("lod");
    return falseColour(pixels, LEVELS, (i) => (depth[i] < 1 ? Math.max(0, level[i]) : -1));
  }
  const [dudx, dvdx, dudy, dvdy] = ["dudx", "dvdx", "dudy", "dvdy"].map(read);
  return falseColour(pixels, RATIO_COLOURS, (i) => (depth[i] < 1 ? Math.log2(ratioOf(dudx[i], dvdx[i], dudy[i],
      dvdy[i])) : -1));
}

serve((shd) => {
  const made = new Renderer(shd);
  let whole = null;
  return {
    setTexture,
    footprint: (x, y) => made.footprint(x, y),
    /** Draws rows of a state. */
    draw(rows, state) {
      const scene = describe(state);
      const stats = made.draw(scene, state.view, state.inspect, rows);
      whole = made.readColor(whole?.length === scene.width * scene.height * 4 ? whole : null);
      const [first, last] = rows.map((y) => y * scene.width);
      const pixels = whole.slice(4 * first, 4 * last);
      applyView(made, state.view, pixels, first);
      return { ...stats, width: scene.width, height: scene.height, pixels };
    },
  };
});
