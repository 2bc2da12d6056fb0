// SPDX-License-Identifier: MIT
// Elements for settings. Native controls: they have the keyboard and the names of the platform.
import { fit, SETTINGS } from "./state.js";

const title = (text) => text.replaceAll("_", " ");

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** A control of a setting, as {row, show(value)}. */
function control(key, label, onChange) {
  const { options, toggle, min, max, step } = SETTINGS[key];
  const id = `set-${key.replace(".", "-")}`;
  if (toggle) {
    const input = element("input", { type: "checkbox", id, className: "switch" });
    input.addEventListener("change", () => onChange(key, input.checked));
    const row = element("label", { className: "row toggle", htmlFor: id }, element("span", {}, label), input);
    return { row, show: (value) => { input.checked = value; } };
  }
  if (options) {
    const select = element("select", { id }, ...options.map((value) => element("option", { value }, title(value))));
    select.addEventListener("change", () => onChange(key, select.value));
    const row = element("div", { className: "row" }, element("label", { htmlFor: id }, label), select);
    return { row, show: (value) => { select.value = value; } };
  }
  const input = element("input", { type: "range", id, min, max, step });
  const output = element("output", { htmlFor: id });
  input.addEventListener("input", () => onChange(key, fit(key, input.value)));
  const row = element("div", { className: "row range" }, element("label", { htmlFor: id }, label), output, input);
  return { row, show: (value) => { input.value = value; output.value = String(value); } };
}

/** Adds a value that a setting can have. */
export function addOption(key, value) {
  SETTINGS[key].options.push(value);
  document.querySelector(`#set-${key}`).append(element("option", { value }, title(value)));
}

/** Fills the groups of the page, and returns a function that shows a state in them. */
export function buildControls(onChange) {
  const shown = new Map();
  for (const group of document.querySelectorAll("[data-settings]")) {
    for (const key of group.dataset.settings.split(" ")) {
      const made = control(key, SETTINGS[key].label, onChange);
      shown.set(key, made);
      group.append(made.row);
    }
  }
  return (state) => {
    for (const [key, { show }] of shown) show(state[key]);
    document.body.classList.toggle("comparing", state.compare);
  };
}
