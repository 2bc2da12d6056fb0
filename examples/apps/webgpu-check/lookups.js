// SPDX-License-Identifier: MIT
// The textures and lookups with which a unit is judged.

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
