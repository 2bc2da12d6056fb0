// SPDX-License-Identifier: MIT
// A setting {label, value, and options, a toggle, or a range whose values may have names}: its values, and its control. Native controls: they have the
// keyboard and the names of the platform. Pages with other settings take them, too (../figures).

const title = (text) => text.replaceAll("_", " ");

export function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** A value that a setting can have: a text of an address, or a number outside its range, is brought into it. */
export function fitted({ options, toggle, min, max, step, value: otherwise }, value) {
  if (toggle) return value === true || value === "1" ? true : value === false || value === "0" ? false : otherwise;
  if (options) return options.includes(String(value)) ? String(value) : otherwise;
  const number = Number.parseFloat(value);
  if (!Number.isFinite(number)) return otherwise;
  const steps = Math.round((Math.min(max, Math.max(min, number)) - min) / step);
  return Number((min + steps * step).toFixed(4));
}

export const optionOf = (value) => element("option", { value }, title(value));

/** The control of a setting, as {row, show(value)}. `id` is unique in its document; `onChange` gets values. */
export function control(setting, id, onChange) {
  const { label, options, toggle, min, max, step, names = {} } = setting;
  if (toggle) {
    const input = element("input", { type: "checkbox", id, className: "switch" });
    input.addEventListener("change", () => onChange(input.checked));
    const row = element("label", { className: "row toggle", htmlFor: id }, element("span", {}, label), input);
    return { row, show: (value) => { input.checked = value; } };
  }
  if (options) {
    const select = element("select", { id }, ...options.map(optionOf));
    select.addEventListener("change", () => onChange(select.value));
    const row = element("div", { className: "row" }, element("label", { htmlFor: id }, label), select);
    return { row, show: (value) => { select.value = value; } };
  }
  const input = element("input", { type: "range", id, min, max, step });
  const output = element("output", { htmlFor: id });
  input.addEventListener("input", () => onChange(fitted(setting, input.value)));
  const row = element("div", { className: "row range" }, element("label", { htmlFor: id }, label), output, input);
  return { row, show: (value) => { input.value = value; output.value = names[value] ?? String(value); } };
}
