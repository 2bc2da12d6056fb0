// SPDX-License-Identifier: MIT
// Verdicts on results of lookups, by the bounds of libshd in WebAssembly.

const CHANNELS = ["r", "g", "b", "a"];
export const MAX_ANISOTROPY = 8;

/** Deterministic numbers in [0, 1): the generator of Marsaglia, "Xorshift RNGs" (2003). */
export function randomNumbers(seed) {
  let state = seed | 1;
  return () => {
    state ^= state << 13, state ^= state >>> 17, state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

/** Noise about a colour of each level, so that a wrong level shows. */
export function makeImage(format, width, height, seed) {
  const next = randomNumbers(seed);
  const levels = [];
  for (let level = 0; level === 0 || (width | height) >> level; ++level) {
    const bytes = new Uint8Array(4 * Math.max(width >> level, 1) * Math.max(height >> level, 1));
    bytes.forEach((_, i) => { bytes[i] = 255 * (0.3 * (((level * 5 + (i % 4) * 2) % 11) / 10) + 0.7 * next()); });
    levels.push(bytes);
  }
  return { format, width, height, levels };
}

/** Points in the image and beside it, some of them on the grid of half texels, and footprints of 1/4 to 32 texels. */
export function makeLookups(image, count, withLod, seed) {
  const next = randomNumbers(seed);
  const make = (value) => Float32Array.from({ length: count }, value);
  const coordinate = (size) => make(() => {
    const x = next() < 0.7 ? next() : 4 * next() - 1.5;
    return next() < 0.1 ? Math.floor(x * 2 * size) / (2 * size) : x;
  });
  const lookups = { u: coordinate(image.width), v: coordinate(image.height) };
  if (withLod) return { ...lookups, lod: make(() => 8 * next() - 1) };
  const size = make(() => 2 ** (7 * next() - 2));
  const ratio = make(() => 2 ** (3 * next()));
  const derivative = (texels, shorter) =>
    make((_, i) => ((2 * next() - 1) * size[i]) / (shorter ? ratio[i] : 1) / texels);
  return { ...lookups, dudx: derivative(image.width), dvdx: derivative(image.height),
           dudy: derivative(image.width, true), dvdy: derivative(image.height, true) };
}

/** A texture and a sampler in the library, with the rules of WebGPU. */
export class Judge {
  constructor(shd, image, { filter, wrap }) {
    this.shd = shd;
    this.context = new shd.Context();
    const size = (level) => ({ width: Math.max(image.width >> level, 1), height: Math.max(image.height >> level, 1) });
    this.texture = new shd.Texture(this.context, {
      format: image.format, width: image.width, height: image.height, texels: image.levels[0], tables: "mipmap",
      levelImages: image.levels.slice(1).map((pixels, i) => ({ format: image.format, ...size(i + 1), pixels })),
    });
    this.sampler = new shd.Sampler(this.context, { filter, wrapU: wrap[0], wrapV: wrap[1], profile: "vulkan",
                                                   maxAnisotropy: MAX_ANISOTROPY });
    this.rules = shd.call("shd_bounds_desc_from_rules", "webgpu");
  }

  /** Columns of the smallest and the largest legal values. */
  bounds(lookups) {
    const columns = () => ({ channel: CHANNELS.map(() => new Float32Array(lookups.u.length)) });
    const lower = columns(), upper = columns();
    this.shd.call("shd_texture_bounds", this.texture, this.sampler, lookups, this.rules, lower, upper);
    return { lower: lower.channel, upper: upper.channel };
  }

  /** The refused lookups, the farthest first: { row, channel, value, low, high, excess }. */
  refusals(lookups, results) {
    const { lower, upper } = this.bounds(lookups);
    const refused = [];
    for (let row = 0; row < lookups.u.length; ++row) {
      let worst = null;
      results.forEach((column, c) => {
        const value = column[row], low = lower[c][row], high = upper[c][row];
        const excess = Number.isNaN(value) ? Infinity : Math.max(low - value, value - high, 0);
        if (excess > (worst?.excess ?? 0)) worst = { row, channel: CHANNELS[c], value, low, high, excess };
      });
      if (worst) refused.push(worst);
    }
    return refused.sort((a, b) => b.excess - a.excess);
  }

  /** What the library itself returns. */
  sample(lookups) {
    return this.texture.sample(this.sampler, lookups).channel;
  }

  close() {
    for (const object of [this.sampler, this.texture, this.context]) object.close();
  }
}
