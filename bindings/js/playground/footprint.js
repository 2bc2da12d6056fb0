// SPDX-License-Identifier: MIT
// The footprint of the pixel at the pointer, drawn over the texture.
import { textureOf } from "./textures.js";

const panel = document.querySelector("#footprint");
const canvas = panel.querySelector("canvas");
const text = panel.querySelector("output");
const tiles = new Map();  // canvases of textures

function tileOf(texture) {
  if (!tiles.has(texture)) {
    const { width, height, texels } = texture;
    const tile = Object.assign(document.createElement("canvas"), { width, height });
    tile.getContext("2d").putImageData(new ImageData(new Uint8ClampedArray(texels), width, height), 0, 0);
    tiles.set(texture, tile);
  }
  return tiles.get(texture);
}

/** Texels that the panel shows: a power of two that contains the ellipse. */
function extentOf({ longer }, { width, height }) {
  const need = 3 * Math.hypot(...longer);
  return Math.min(4 * Math.max(width, height), Math.max(16, 2 ** Math.ceil(Math.log2(need))));
}

function drawEllipse(target, scale, { longer, shorter }) {
  const [long, short] = [Math.hypot(...longer), Math.hypot(...shorter)].map((v) => Math.max(v * scale, 1.5));
  target.beginPath();
  target.ellipse(canvas.width / 2, canvas.height / 2, long, short, Math.atan2(longer[1], longer[0]), 0, 2 * Math.PI);
  target.fillStyle = "rgb(255 170 40 / 35%)";
  target.fill();
  target.lineWidth = 2;
  target.strokeStyle = "#ff9d1c";
  target.stroke();
}

/** Shows a footprint in the texture `name`, or hides the panel. */
export function showFootprint(footprint, name) {
  panel.classList.toggle("empty", !footprint);
  if (!footprint) return;
  const texture = textureOf(name);
  const extent = extentOf(footprint, texture);
  const scale = canvas.width / extent;
  const target = canvas.getContext("2d");
  target.setTransform(scale, 0, 0, scale, canvas.width / 2, canvas.height / 2);
  target.imageSmoothingEnabled = scale < 1;
  const whole = (v) => v - Math.floor(v);
  const { width, height } = texture;
  const [x, y] = [whole(footprint.u) * width, whole(footprint.v) * height];
  const [across, down] = [width, height].map((size) => Math.ceil(extent / 2 / size) + 1);
  for (let j = -down; j <= down; ++j) {
    for (let i = -across; i <= across; ++i) target.drawImage(tileOf(texture), i * width - x, j * height - y);
  }
  target.setTransform(1, 0, 0, 1, 0, 0);
  drawEllipse(target, scale, footprint);
  const [long, short] = [footprint.longer, footprint.shorter].map((axis) => 2 * Math.hypot(...axis));
  text.value = `${footprint.side}: ${footprint.filter.replaceAll("_", " ")} · ${footprint.taps} texels read
${long.toFixed(1)} × ${short.toFixed(1)} texels, ratio ${(long / Math.max(short, 1e-6)).toFixed(1)}
level of detail ${footprint.lod.toFixed(2)}`;
}

export function hideFootprint(hidden) {
  panel.hidden = hidden;
}
