// SPDX-License-Identifier: MIT
// The weights of a filter that has no list of its texels: its results in textures in which one texel is 1 and all
// others are 0.

const FILTERS = ["summed_area", "exact"];
const CHANNELS = 4, LEAST = 1e-7;

export class Impulses {
  #make;
  #made = null;
  #size;
  constructor({ shd, context }, size) {
    this.#size = size;
    this.#make = () => {
      const count = size * size, layerCount = count / CHANNELS;
      const texels = new Float32Array(count * count);
      for (let k = 0; k < count; ++k) {
        const layer = Math.floor(k / CHANNELS);
        texels[(layer * count + k) * CHANNELS + (k % CHANNELS)] = 1;
      }
      return new shd.Texture(context, { format: "rgba32f", width: size, height: size, layerCount, texels,
                                        tables: "mipmap|summed_area" });
    };
  }
  /** Whether a filter is of this kind. */
  serves(filter) {
    return FILTERS.includes(filter);
  }
  /** Texels of level 0 with their weights, [[x, y, weight]], from a batch with a lookup for each layer. */
  weigh(sampler, lookup) {
    this.#made ??= this.#make();
    const size = this.#size, count = (size * size) / CHANNELS;
    const lookups = Object.fromEntries(Object.entries(lookup).map(([key, [value]]) =>
      [key, new Float32Array(count).fill(value)]));
    lookups.layer = Uint32Array.from({ length: count }, (_, layer) => layer);
    const { channel } = this.#made.sample(sampler, lookups);
    const list = [];
    for (let k = 0; k < size * size; ++k) {
      const weight = channel[k % CHANNELS][Math.floor(k / CHANNELS)];
      if (weight > LEAST) list.push([k % size, Math.floor(k / size), weight]);
    }
    return list;
  }
}
