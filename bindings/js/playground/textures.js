// SPDX-License-Identifier: MIT
// Textures: patterns of 512 x 512 texels, and one image of the visitor. All are RGBA8 in sRGB.

const SIZE = 512;

/** A value of 0..1 from two integers. */
function noise(x, y) {
  let bits = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b);
  bits = Math.imul(bits ^ (bits >>> 15), 0x2c1b3c6d);
  bits = Math.imul(bits ^ (bits >>> 12), 0x297a2d39);
  return ((bits ^ (bits >>> 15)) >>> 0) / 0xffffffff;
}

/** Smooth noise that repeats after `period` cells. */
function smoothNoise(x, y, period) {
  const [x0, y0] = [Math.floor(x), Math.floor(y)];
  const ease = (t) => t * t * (3 - 2 * t);
  const [s, t] = [ease(x - x0), ease(y - y0)];
  const at = (i, j) => noise((x0 + i + period) % period, (y0 + j + period) % period);
  const mix = (a, b, f) => a + (b - a) * f;
  return mix(mix(at(0, 0), at(1, 0), s), mix(at(0, 1), at(1, 1), s), t);
}

const blend = (from, to, f) => from.map((v, i) => v + (to[i] - v) * f);

const PATTERNS = {
  checker(x, y) {
    return ((x >> 5) + (y >> 5)) & 1 ? [236, 232, 222] : [38, 52, 74];
  },
  wood(x, y) {
    const plank = Math.floor(y / 128);
    const grain = smoothNoise(x / 64 + 3 * plank, y / 8, 64);
    const rings = Math.sin((y / 9 + 9 * smoothNoise(x / 128 + plank, y / 48, 16)) * 1.7) * 0.5 + 0.5;
    const colour = blend([96, 54, 26], [196, 136, 78], 0.55 * rings + 0.3 * grain + 0.15 * noise(plank, 7));
    const isGap = y % 128 < 3 || (x + 190 * plank) % 512 < 3;
    return isGap ? blend(colour, [28, 16, 8], 0.8) : colour;
  },
  brick(x, y) {
    const row = Math.floor(y / 64);
    const shifted = (x + (row & 1 ? 64 : 0)) % 512;
    const column = Math.floor(shifted / 128);
    const edge = Math.min(shifted % 128, 127 - (shifted % 128), y % 64, 63 - (y % 64));
    const rough = smoothNoise(x / 6, y / 6, 85);
    const mortar = blend([176, 168, 154], [148, 140, 128], rough);
    const brick = blend([128, 48, 34], [190, 92, 62], 0.65 * noise(column, row) + 0.35 * rough);
    return blend(mortar, brick, Math.min(1, Math.max(0, (edge - 3) / 2.5)));
  },
  zone(x, y) {
    const [dx, dy] = [x - 255.5, y - 255.5];
    const wave = 0.5 + 0.5 * Math.cos((Math.PI * (dx * dx + dy * dy)) / 1024);
    return blend([24, 30, 44], [240, 238, 230], wave);
  },
};

/** The texels of a pattern. */
function makeTexels(name) {
  const texels = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 0, i = 0; y < SIZE; ++y) {
    for (let x = 0; x < SIZE; ++x, i += 4) {
      const [r, g, b] = PATTERNS[name](x, y);
      texels[i] = r, texels[i + 1] = g, texels[i + 2] = b, texels[i + 3] = 255;
    }
  }
  return texels;
}

const made = new Map();

/** Replaces the texture `name`. `id` differs for each image that had this name. */
export function setTexture(name, texture) {
  made.set(name, { ...texture, id: (made.get(name)?.id ?? 0) + 1 });
}

/** A texture by its name: {width, height, texels, id}. */
export function textureOf(name) {
  if (!made.has(name)) setTexture(name, { width: SIZE, height: SIZE, texels: makeTexels(name) });
  return made.get(name);
}
