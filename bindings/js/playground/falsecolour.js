// SPDX-License-Identifier: MIT
// Planes of numbers as colours.

/** Colours of levels 0..9, from fine to coarse. */
export const LEVELS = ["#e8eef4", "#7fd0e8", "#3fa7d6", "#2f6fb5", "#37449c", "#6b3fa0",
                       "#a63a94", "#d6456b", "#ee7b3c", "#f5c542"];
/** Ratios of the footprint's axes and their colours. */
export const RATIOS = [1, 2, 4, 8, 16, 32];
export const RATIO_COLOURS = ["#e9f5ee", "#8fd3b6", "#3fa58a", "#f0b840", "#e06a2c", "#b3202c"];

const rgb = (text) => [1, 3, 5].map((i) => Number.parseInt(text.slice(i, i + 2), 16));

/** Mixes colours of a list by a number between 0 and its last index, and keeps some of the shading. */
function paint(pixels, at, colours, value, shade) {
  const place = Math.min(Math.max(value, 0), colours.length - 1);
  const first = Math.min(Math.floor(place), colours.length - 2);
  const part = place - first;
  for (let c = 0; c < 3; ++c) {
    pixels[at + c] = (colours[first][c] * (1 - part) + colours[first + 1][c] * part) * shade;
  }
}

/** Replaces the colours of objects; `valueOf(i)` is the place in the list of colours, below 0 for no object. */
export function falseColour(pixels, colours, valueOf) {
  const list = colours.map(rgb);
  for (let i = 0; i < pixels.length / 4; ++i) {
    const value = valueOf(i);
    if (value < 0) continue;
    const luma = (pixels[4 * i] + 2 * pixels[4 * i + 1] + pixels[4 * i + 2]) / 1020;
    paint(pixels, 4 * i, list, value, 0.7 + 0.3 * luma);
  }
}

/** Ratio of the axes of the footprint from the derivatives: singular values of their matrix. */
export function ratioOf(dudx, dvdx, dudy, dvdy) {
  const sum = dudx * dudx + dvdx * dvdx + dudy * dudy + dvdy * dvdy;
  const determinant = Math.abs(dudx * dvdy - dvdx * dudy);
  if (!(determinant > 0)) return sum > 0 ? 64 : 1;
  const root = Math.sqrt(Math.max(0, sum * sum - 4 * determinant * determinant));
  return Math.min(64, (sum + root) / (2 * determinant));
}
