// SPDX-License-Identifier: MIT
// <shd-figure name="texels">text</shd-figure>: a figure of this folder. It starts when it comes into view, and replaces
// the text, which stays where it cannot start. All figures of a page share one instance of the library.
import { control, element } from "../playground/setting.js";
import { load } from "../lib/index.js";
import { Stage } from "./stage.js";

const AHEAD = "300px";  // distance from the view at which a figure starts
const REST = 300;       // [ms] without a change, until a rough figure is drawn in full
const SHEETS = ["../playground/setting.css", "style.css"];

let library = null;
let lastStart = Promise.resolve();  // figures start one after the other, so that the first one is there soon

/** The library and its context, loaded once. */
function loadOnce() {
  library ??= load(new URL("shd-figures.wasm", import.meta.url)).then((shd) => ({ shd, context: new shd.Context() }));
  return library;
}

const observer = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (!isIntersecting) continue;
    observer.unobserve(target);
    target.start();
  }
}, { rootMargin: AHEAD });

/** The style sheets, which all figures share. */
const sheets = Promise.all(SHEETS.map(async (name) => {
  const response = await fetch(new URL(name, import.meta.url));
  return new CSSStyleSheet().replace(await response.text());
}));

class ShdFigure extends HTMLElement {
  #figure = null;
  #stage = null;
  #controls = [];
  #text = element("output", { id: "text", className: "text" });
  #rest = 0;
  #hasStarted = false;
  /** The values of the settings. */
  state = {};
  /** What the text states, as numbers. */
  values = {};

  connectedCallback() {
    if (!this.#hasStarted) observer.observe(this);
  }

  /** Starts after the figures before it. */
  start() {
    this.#hasStarted = true;
    const before = lastStart;
    lastStart = this.#start(before).catch((problem) => {
      this.dispatchEvent(new CustomEvent("problem", { detail: problem }));
    });
  }

  async #start(before) {
    const name = this.getAttribute("name");
    if (!/^[a-z-]+$/.test(name)) throw new Error(`${name} is no name of a figure`);
    const [{ make }, { shd, context }] = await Promise.all([import(`./${name}.js`), loadOnce(), before]);
    const figure = make({ shd, context });
    this.#figure = figure;
    for (const [key, { value }] of Object.entries(figure.settings)) this.state[key] = value;
    await this.#build();
    this.#watchTheme();
    this.#draw();
    this.dataset.ready = "";
    this.dispatchEvent(new CustomEvent("ready", { bubbles: true }));
  }

  /** Canvas, controls and text, in a tree that styles of the page do not reach. */
  async #build() {
    const { label, settings } = this.#figure;
    const rows = element("div", { className: "settings" });
    for (const [key, setting] of Object.entries(settings)) {
      const made = control(setting, `set-${key}`, (value) => this.set({ [key]: value }));
      rows.append(made.row);
      this.#controls.push([key, made]);
    }
    this.#stage = new Stage(this, label, () => this.#draw());
    const box = element("div", { className: "figure" }, this.#stage.element, rows, this.#text);
    box.setAttribute("role", "group");
    box.setAttribute("aria-label", label);
    const adoptedStyleSheets = await sheets;
    Object.assign(this.attachShadow({ mode: "open" }), { adoptedStyleSheets }).append(box);
    this.#stage.start(this.#figure);
  }

  /** Changes settings. */
  set(changes) {
    Object.assign(this.state, changes);
    this.#stage.change();
  }

  /** Draws anew when the page changes between light and dark. */
  #watchTheme() {
    const redraw = () => this.#stage.change();
    const changes = new MutationObserver(redraw);
    for (const watched of [document.documentElement, document.body]) changes.observe(watched, { attributes: true });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  }

  #draw() {
    for (const [key, { show }] of this.#controls) show(this.state[key]);
    try {
      const { text, values, isRough } = this.#stage.draw(this.state);
      this.#text.value = text;
      this.values = values;
      clearTimeout(this.#rest);
      if (isRough) this.#rest = setTimeout(() => this.#stage.settle(), REST);
      this.#text.classList.remove("problem");
    } catch (problem) {
      this.#text.value = problem.message;
      this.#text.classList.add("problem");
    }
  }
}

customElements.define("shd-figure", ShdFigure);
