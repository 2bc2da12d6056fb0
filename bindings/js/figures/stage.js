// SPDX-License-Identifier: MIT
// The canvas of a figure, with handles that pointers and arrow keys move. A figure is
//
//   { label, settings, heightOf(width, state), handles(view, state), draw(target, view, state) }
//
// `view` has the width and height in CSS pixels, and the colour of the text. A handle is { label, at: [x, y],
// move(x, y), fill }. draw() returns { text, values, isRough }: the numbers of the figure in words, and for programs. A
// figure that is rough while it changes is drawn again when it rests, with view.isResting.
import { element } from "../playground/setting.js";

const STEP = 4, LONG_STEP = 20;  // CSS pixels of an arrow key, and with Shift
const DIRECTIONS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const REACH = 40;                // CSS pixels from the canvas' pointer to the handle that it takes

export class Stage {
  #canvas = element("canvas");
  #buttons = [];
  #handles = [];
  #figure = null;
  #host;
  #onChange;
  #isStale = false;
  #isResting = false;
  #state = null;
  #view = { width: 0, height: 0 };
  element = element("div", { className: "stage" }, this.#canvas);

  /** `onChange` is called once before the next frame after changes. */
  constructor(host, label, onChange) {
    this.#host = host;
    this.#onChange = onChange;
    this.#canvas.setAttribute("role", "img");
    this.#canvas.setAttribute("aria-label", label);
    this.#canvas.addEventListener("pointerdown", (event) => this.#take(event));
  }

  start(figure) {
    this.#figure = figure;
    new ResizeObserver(() => {
      if (this.element.clientWidth !== this.#view.width) this.change();
    }).observe(this.element);
  }

  /** Draws in full what does not change any more. */
  settle() {
    this.#isResting = true;
    this.#onChange();
    this.#isResting = false;
  }

  /** Draws before the next frame. */
  change() {
    if (this.#isStale) return;
    this.#isStale = true;
    requestAnimationFrame(() => {
      this.#isStale = false;
      this.#onChange();
    });
  }

  draw(state) {
    this.#state = state;
    this.#layOut(state);
    const target = this.#canvas.getContext("2d");
    const { width, height, scale } = this.#view;
    target.setTransform(scale, 0, 0, scale, 0, 0);
    target.clearRect(0, 0, width, height);
    const made = this.#figure.draw(target, this.#view, state);
    this.#handles = this.#figure.handles(this.#view, state);
    this.#showHandles();
    return made;
  }

  /** The size and colours of the place. The canvas has a pixel for each pixel of the screen. */
  #layOut(state) {
    const width = this.element.clientWidth;
    const height = Math.round(this.#figure.heightOf(width, state));
    const scale = Math.min(devicePixelRatio, 3);
    const ink = getComputedStyle(this.#host).color;
    const [r, g, b] = ink.match(/[\d.]+/g).map(Number);
    const isDark = r + 2 * g + b > 510;
    this.#view = { width, height, scale, ink, isResting: this.#isResting };
    this.#host.style.colorScheme = isDark ? "dark" : "light";
    const size = [width, height].map((v) => Math.max(1, Math.round(v * scale)));
    if (this.#canvas.width !== size[0] || this.#canvas.height !== size[1]) {
      [this.#canvas.width, this.#canvas.height] = size;
      this.#canvas.style.height = `${height}px`;
    }
  }

  #showHandles() {
    while (this.#buttons.length < this.#handles.length) this.#addButton();
    this.#buttons.forEach((button, i) => {
      const handle = this.#handles[i];
      button.hidden = !handle;
      if (!handle) return;
      button.setAttribute("aria-label", `${handle.label}: arrow keys move it`);
      button.style.left = `${handle.at[0]}px`;
      button.style.top = `${handle.at[1]}px`;
      button.style.setProperty("--fill", handle.fill ?? "#fff");
    });
  }

  #addButton() {
    const index = this.#buttons.length;
    const button = element("button", { type: "button", className: "handle" });
    button.setAttribute("aria-describedby", "text");
    button.addEventListener("pointerdown", (event) => this.#drag(button, index, event));
    button.addEventListener("keydown", (event) => {
      const direction = DIRECTIONS[event.key];
      if (!direction || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      const step = event.shiftKey ? LONG_STEP : STEP;
      const { at } = this.#handles[index];
      this.#move(index, at[0] + step * direction[0], at[1] + step * direction[1]);
    });
    this.#buttons.push(button);
    this.element.append(button);
  }

  /** The mouse may press beside a handle. Fingers on the canvas scroll the page. */
  #take(event) {
    if (event.pointerType !== "mouse" || event.button !== 0) return;
    const { left, top } = this.#canvas.getBoundingClientRect();
    const gaps = this.#handles.map(({ at }) => Math.hypot(event.clientX - left - at[0], event.clientY - top - at[1]));
    const nearest = gaps.indexOf(Math.min(...gaps));
    if (nearest < 0 || (this.#handles.length > 1 && gaps[nearest] > REACH)) return;
    this.#drag(this.#buttons[nearest], nearest, event);
  }

  #drag(button, index, event) {
    event.preventDefault();
    button.focus({ preventScroll: true });
    button.setPointerCapture(event.pointerId);
    const ends = new AbortController();
    const follow = ({ clientX, clientY, pointerId }) => {
      if (pointerId !== event.pointerId) return;
      const { left, top } = this.#canvas.getBoundingClientRect();
      this.#move(index, clientX - left, clientY - top);
    };
    button.addEventListener("pointermove", follow, { signal: ends.signal });
    for (const name of ["pointerup", "pointercancel"]) {
      button.addEventListener(name, () => ends.abort(), { signal: ends.signal });
    }
    if (event.currentTarget === this.#canvas) follow(event);
  }

  #move(index, x, y) {
    const clamp = (v, end) => Math.min(Math.max(v, 0), end);
    this.#handles[index]?.move(clamp(x, this.#view.width), clamp(y, this.#view.height));
    this.#handles = this.#figure.handles(this.#view, this.#state);  // the next key may come before the next frame
    this.change();
  }
}
