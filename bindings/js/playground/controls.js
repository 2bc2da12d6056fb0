// SPDX-License-Identifier: MIT
// The controls of the page.
import { control, optionOf } from "./setting.js";
import { SETTINGS } from "./state.js";

const idOf = (key) => `set-${key.replace(".", "-")}`;

/** Adds a value that a setting can have. */
export function addOption(key, value) {
  SETTINGS[key].options.push(value);
  document.querySelector(`#${idOf(key)}`).append(optionOf(value));
}

/** Fills the groups of the page, and returns a function that shows a state in them. */
export function buildControls(onChange) {
  const shown = new Map();
  for (const group of document.querySelectorAll("[data-settings]")) {
    for (const key of group.dataset.settings.split(" ")) {
      const made = control(SETTINGS[key], idOf(key), (value) => onChange(key, value));
      shown.set(key, made);
      group.append(made.row);
    }
  }
  return (state) => {
    for (const [key, { show }] of shown) show(state[key]);
    document.body.classList.toggle("comparing", state.compare);
  };
}
