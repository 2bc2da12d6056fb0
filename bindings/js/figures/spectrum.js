// SPDX-License-Identifier: MIT
// The spectrum of a square picture.

/** Fourier transform of `count` complex numbers at a stride, in place (Cooley and Tukey 1965). */
function transform(re, im, first, stride, count) {
  for (let i = 1, j = 0; i < count; ++i) {
    let bit = count >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i >= j) continue;
    const [a, b] = [first + i * stride, first + j * stride];
    [re[a], re[b], im[a], im[b]] = [re[b], re[a], im[b], im[a]];
  }
  for (let size = 2; size <= count; size *= 2) {
    for (let k = 0; k < size / 2; ++k) {
      const angle = (-2 * Math.PI * k) / size, c = Math.cos(angle), s = Math.sin(angle);
      for (let i = k; i < count; i += size) {
        const [a, b] = [first + i * stride, first + (i + size / 2) * stride];
        const x = re[b] * c - im[b] * s, y = re[b] * s + im[b] * c;
        re[b] = re[a] - x, im[b] = im[a] - y;
        re[a] += x, im[a] += y;
      }
    }
  }
}

/**
 * Bytes of a grey picture of the amplitudes in decibels, with frequency 0 in the middle, and the share of the power
 * above half of the largest frequency. `values` are size x size; a Hann window hides the edges.
 */
export function spectrum(values, size, floor = -90) {
  const hann = Float64Array.from({ length: size }, (_, i) => 0.5 - 0.5 * Math.cos((2 * Math.PI * (i + 0.5)) / size));
  const mean = values.reduce((sum, v) => sum + v, 0) / values.length;
  const re = Float64Array.from(values, (v, i) => (v - mean) * hann[i % size] * hann[Math.floor(i / size)]);
  const im = new Float64Array(size * size);
  for (let y = 0; y < size; ++y) transform(re, im, y * size, 1, size);
  for (let x = 0; x < size; ++x) transform(re, im, x, size, size);
  const bytes = new Uint8ClampedArray(4 * size * size);
  let [power, high] = [0, 0];
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const from = ((y + size / 2) % size) * size + ((x + size / 2) % size);
      const amplitude = (4 * Math.hypot(re[from], im[from])) / (size * size);
      power += amplitude ** 2;
      if (Math.max(Math.abs(x - size / 2), Math.abs(y - size / 2)) > size / 4) high += amplitude ** 2;
      const grey = 255 * (1 - (20 * Math.log10(Math.max(amplitude, 1e-9))) / floor);
      bytes.set([grey, grey, grey, 255], 4 * (y * size + x));
    }
  }
  return { bytes, high: power ? high / power : 0 };
}
