// SPDX-License-Identifier: MIT
// Pixels on a canvas of a figure.
import { element } from "../playground/setting.js";

/** A picture of `width` x `height` pixels that is drawn at any size. */
export class Pixels {
  #paper = element("canvas");
  constructor(width, height) {
    [this.#paper.width, this.#paper.height] = [width, height];
  }
  /** Sets the bytes r, g, b, a of all pixels. */
  put(bytes) {
    const { width, height } = this.#paper;
    this.#paper.getContext("2d").putImageData(new ImageData(bytes, width, height), 0, 0);
    return this;
  }
  draw(target, { x, y, width, height }, isSmooth = true) {
    target.imageSmoothingEnabled = isSmooth;
    target.imageSmoothingQuality = "high";
    target.drawImage(this.#paper, x, y, width, height);
  }
}

/** A frame of the library. */
export class Picture extends Pixels {
  #shd;
  #context;
  #bytes = null;
  constructor({ shd, context }, width, height, sampleCount = 4) {
    super(width, height);
    [this.#shd, this.#context] = [shd, context];
    this.framebuffer = new shd.Framebuffer(context, { width, height, sampleCount, colorFormat: "rgba32f" });
  }
  render(frame) {
    this.#shd.render(this.#context, { framebuffer: this.framebuffer, ...frame });
    this.#bytes = this.framebuffer.readColor("rgba8_srgb", this.#bytes);
    return this.put(this.#bytes);
  }
}

const STEPS = 4096;
const encoded = Uint8ClampedArray.from({ length: STEPS + 1 }, (_, i) => {
  const v = i / STEPS;
  return 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
});

/** The byte of sRGB for a linear value. */
export const encode = (value) => encoded[Math.round(STEPS * Math.min(Math.max(value, 0), 1))];

/** Bytes for ImageData from linear columns r, g and b. */
export function bytesOf([r, g, b]) {
  const bytes = new Uint8ClampedArray(4 * r.length);
  for (let i = 0; i < r.length; ++i) {
    bytes[4 * i] = encode(r[i]), bytes[4 * i + 1] = encode(g[i]), bytes[4 * i + 2] = encode(b[i]);
    bytes[4 * i + 3] = 255;
  }
  return bytes;
}

export const cssOf = (rgb) => `rgb(${rgb.slice(0, 3).map(encode).join(" ")})`;
