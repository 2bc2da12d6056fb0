// SPDX-License-Identifier: MIT
// The settings of a picture, and their text in the address of the page. Values that are defaults are left out.
import { fitted } from "./setting.js";

const FILTERS = ["nearest", "bilinear", "bicubic", "hermite", "nearest_mip", "bilinear_mip", "trilinear", "anisotropic",
    "ewa"];

const side = (filter) => ({
  filter: { label: "Filter", options: FILTERS, value: filter },
  anisotropy: { label: "Max anisotropy", options: ["2", "4", "8", "16"], value: "16" },
  bias: { label: "Level bias", min: -3, max: 3, step: 0.25, value: 0 },
  precision: { label: "Precision", options: ["full", "fast"], value: "full" },
});

/** Every setting: label, default, and options or range. */
export const SETTINGS = {
  shape: { label: "Shape", options: ["teapot", "torus", "sphere", "plane"], value: "torus" },
  texture: { label: "Texture", options: ["checker", "wood", "brick", "zone"], value: "brick" },
  repeat: { label: "Repeat", min: 0.5, max: 8, step: 0.5, value: 1 },
  floor: { label: "Floor", toggle: true, value: true },
  model: { label: "Model", options: ["lambert", "blinn_phong", "metallic_roughness", "gooch", "toon", "unlit"],
      value: "blinn_phong" },
  roughness: { label: "Roughness", min: 0.05, max: 1, step: 0.05, value: 0.4 },
  sun: { label: "Direction [°]", min: -180, max: 180, step: 1, value: 40 },
  height: { label: "Elevation [°]", min: 5, max: 90, step: 1, value: 50 },
  power: { label: "Intensity", min: 0, max: 3, step: 0.05, value: 1.2 },
  shadow: { label: "Shadow", toggle: true, value: true },
  view: { label: "Show", options: ["shaded", "level", "anisotropy"], value: "shaded" },
  inspect: { label: "Footprint at the pointer", toggle: true, value: false },
  samples: { label: "Samples", options: ["1", "4"], value: "1" },
  size: { label: "Pixels", options: ["320x240", "640x480", "960x720"], value: "640x480" },
  compare: { label: "Compare A | B", toggle: true, value: true },
  wipe: { min: 0, max: 1, step: 0.001, value: 0.5 },
  azimuth: { min: -180, max: 180, step: 0.1, value: 25 },
  elevation: { min: 2, max: 88, step: 0.1, value: 14 },
  distance: { min: 1.5, max: 20, step: 0.01, value: 5 },
  ...prefixed("a", side("bilinear")),
  ...prefixed("b", side("anisotropic")),
};

function prefixed(prefix, settings) {
  return Object.fromEntries(Object.entries(settings).map(([key, value]) => [`${prefix}.${key}`, value]));
}

export const defaults = () => Object.fromEntries(Object.entries(SETTINGS).map(([key, { value }]) => [key, value]));

/** A value that a setting can have: a text of an address, or a number outside its range, is brought into it. */
export const fit = (key, value) => fitted(SETTINGS[key], value);

const format = (value) => (typeof value === "boolean" ? (value ? "1" : "0") : String(value));

/** The text after # for a state. */
export function toHash(state) {
  const isStored = (key) => state[key] !== SETTINGS[key].value && !(key === "texture" && state[key] === "own");
  return Object.keys(SETTINGS).filter(isStored)
    .map((key) => `${key}=${encodeURIComponent(format(state[key]))}`).join("&");
}

/** The state of a text after #. Unknown keys and values are ignored. */
export function fromHash(text) {
  const state = defaults();
  for (const [key, value] of new URLSearchParams(text.replace(/^#/, ""))) {
    if (Object.hasOwn(SETTINGS, key)) state[key] = fit(key, value);
  }
  return state;
}

/** Settings of one side of the picture. */
export function sideOf(state, prefix) {
  const value = (key) => state[`${prefix}.${key}`];
  return { filter: value("filter"), maxAnisotropy: Number(value("anisotropy")), lodBias: value("bias"),
      precision: value("precision") };
}
