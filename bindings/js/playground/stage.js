// SPDX-License-Identifier: MIT
// The picture: pointer and keys turn the model and move the divider between A and B.
import { fit } from "./state.js";

const TURN = 0.35;  // degrees per CSS pixel
const KEYS = {
  ArrowLeft: ["azimuth", -4], ArrowRight: ["azimuth", 4], ArrowUp: ["elevation", 3], ArrowDown: ["elevation", -3],
  "+": ["distance", -0.3], "=": ["distance", -0.3], "-": ["distance", 0.3], "[": ["wipe", -0.02], "]": ["wipe", 0.02],
};

export class Stage {
  #canvas = document.querySelector("#picture");
  #divider = document.querySelector("#divider");
  #state = null;
  #pointers = new Map();
  #pinch = 0;
  /** `onChange` gets a part of the state, `onHover` a pixel or null. */
  constructor(onChange, onHover) {
    this.change = (key, value) => onChange(key, fit(key, key === "azimuth" ? ((value + 540) % 360) - 180 : value));
    this.hover = onHover;
    this.#listen();
  }
  #listen() {
    const canvas = this.#canvas;
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.#pointers.set(event.pointerId, event);
    });
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const name of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(name, (event) => { this.#pointers.delete(event.pointerId); this.#pinch = 0; });
    }
    canvas.addEventListener("pointerleave", () => this.hover(null));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.change("distance", this.#state.distance * Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.#key(event, KEYS[event.key]));
    this.#divider.addEventListener("keydown", (event) => {
      const steps = { ArrowLeft: -0.02, ArrowRight: 0.02, Home: -1, End: 1 }[event.key];
      this.#key(event, steps && ["wipe", steps]);
    });
    this.#divider.addEventListener("pointerdown", (event) => this.#divider.setPointerCapture(event.pointerId));
    this.#divider.addEventListener("pointermove", (event) => {
      if (!this.#divider.hasPointerCapture(event.pointerId)) return;
      const { left, width } = canvas.getBoundingClientRect();
      this.change("wipe", (event.clientX - left) / width);
    });
  }
  #key(event, action) {
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.change(action[0], this.#state[action[0]] + action[1]);
  }
  #move(event) {
    const before = this.#pointers.get(event.pointerId);
    if (!before) return this.#hover(event);
    this.#pointers.set(event.pointerId, event);
    if (this.#pointers.size > 1) return this.#zoom();
    this.change("azimuth", this.#state.azimuth - (event.clientX - before.clientX) * TURN);
    return this.change("elevation", this.#state.elevation + (event.clientY - before.clientY) * TURN);
  }
  #zoom() {
    const [a, b] = this.#pointers.values();
    const gap = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    if (this.#pinch) this.change("distance", (this.#state.distance * this.#pinch) / gap);
    this.#pinch = gap;
  }
  #hover(event) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    const x = Math.floor(((event.clientX - left) / width) * this.#canvas.width);
    const y = Math.floor(((event.clientY - top) / height) * this.#canvas.height);
    this.hover(x >= 0 && y >= 0 && x < this.#canvas.width && y < this.#canvas.height ? { x, y } : null);
  }
  show(state) {
    this.#state = state;
    this.#divider.hidden = !state.compare;
    this.#divider.style.left = `${100 * state.wipe}%`;
    this.#divider.ariaValueNow = String(Math.round(100 * state.wipe));
  }
  /** Puts the bands of a frame on the canvas. */
  put({ bands }) {
    const [{ value: { width, height } }] = bands;
    const canvas = this.#canvas;
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const target = canvas.getContext("2d");
    for (const { value: { pixels }, rows: [top, bottom] } of bands) {
      if (bottom > top) target.putImageData(new ImageData(pixels, width, bottom - top), 0, top);
    }
  }
}
