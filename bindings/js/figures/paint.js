// SPDX-License-Identifier: MIT
// Drawing on a canvas in CSS pixels.

/** Colours of points, vectors and texels; they stand out on light and on dark pages. */
export const COLOURS = ["#e4572e", "#2f9e6e", "#3a86e0", "#b04bc9"];
export const MARK = "#f2a900";

/** A number as a text; zeros have no sign. */
export const number = (value, digits = 2) => value.toFixed(digits).replace(/^-(?=[0.]+$)/, "");

/** A point as a text. */
export const point = (values, digits = 2) => `(${values.map((v) => number(v, digits)).join(", ")})`;

export function path(target, points, isClosed = true) {
  target.beginPath();
  points.forEach(([x, y], i) => (i ? target.lineTo(x, y) : target.moveTo(x, y)));
  if (isClosed) target.closePath();
}

export function line(target, from, to, colour, width = 1.5) {
  path(target, [from, to], false);
  Object.assign(target, { strokeStyle: colour, lineWidth: width });
  target.stroke();
}

export function arrow(target, from, to, colour) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 1) return;
  const [x, y] = [(8 * dx) / length, (8 * dy) / length];
  line(target, from, [to[0] - x, to[1] - y], "#fff", 4.5);
  line(target, from, [to[0] - x / 2, to[1] - y / 2], colour, 2.5);
  path(target, [to, [to[0] - 1.4 * x - 0.6 * y, to[1] - 1.4 * y + 0.6 * x],
                [to[0] - 1.4 * x + 0.6 * y, to[1] - 1.4 * y - 0.6 * x]]);
  target.fillStyle = colour;
  target.fill();
}

/** A text with a halo, so that it can be read on any ground. */
export function label(target, text, [x, y], options = {}) {
  const { size = 13, align = "center", colour = "#fff", halo = "rgb(0 0 0 / 75%)" } = options;
  Object.assign(target, { font: `600 ${size}px system-ui, "DejaVu Sans", sans-serif`, textAlign: align,
                          textBaseline: "middle", lineJoin: "round" });
  if (halo) {
    Object.assign(target, { strokeStyle: halo, lineWidth: 3 });
    target.strokeText(text, x, y);
  }
  target.fillStyle = colour;
  target.fillText(text, x, y);
}

/** The lines of a grid of `columns` x `rows` cells. */
export function grid(target, { x, y, width, height }, columns, rows, colour) {
  target.beginPath();
  for (let i = 0; i <= columns; ++i) {
    target.moveTo(x + (i * width) / columns, y);
    target.lineTo(x + (i * width) / columns, y + height);
  }
  for (let j = 0; j <= rows; ++j) {
    target.moveTo(x, y + (j * height) / rows);
    target.lineTo(x + width, y + (j * height) / rows);
  }
  Object.assign(target, { strokeStyle: colour, lineWidth: 1 });
  target.stroke();
}

/** Texels with their shares: `shares` has [column, row, weight]; the text is there if it fits. */
export function shares(target, { x, y, width, height }, columns, rows, list) {
  const [w, h] = [width / columns, height / rows];
  const largest = Math.max(...list.map(([, , weight]) => Math.abs(weight)), 1e-6);
  for (const [i, j, weight] of list) {
    target.globalAlpha = 0.25 + (0.6 * Math.abs(weight)) / largest;
    target.fillStyle = weight < 0 ? COLOURS[2] : MARK;
    target.fillRect(x + i * w, y + j * h, w, h);
    target.globalAlpha = 1;
    Object.assign(target, { strokeStyle: "rgb(0 0 0 / 60%)", lineWidth: 1 });
    target.strokeRect(x + i * w + 0.5, y + j * h + 0.5, w - 1, h - 1);
    const text = number(100 * weight, Math.abs(weight) < 0.0995 && w >= 34 ? 1 : 0);
    if (w < 20 || h < 14 || Math.abs(weight) < 5e-4) continue;
    label(target, text, [x + (i + 0.5) * w, y + (j + 0.5) * h], { size: Math.min(14, w / 2.2) });
  }
}

/** The places of `count` panels of equal size, `aspect` = width / height, in rows of as many as fit. */
export function panels(width, count, { aspect = 1, least = 200, most = 420, gap = 12, top = 0 } = {}) {
  const perRow = Math.max(1, Math.min(count, Math.floor((width + gap) / (least + gap))));
  const rows = Math.ceil(count / perRow);
  const size = Math.min(most, (width - gap * (perRow - 1)) / perRow);
  const step = [size + gap, size / aspect + top + gap];
  const left = (width - (perRow * step[0] - gap)) / 2;
  const places = Array.from({ length: count }, (_, i) => ({
    x: left + (i % perRow) * step[0], y: top + Math.floor(i / perRow) * step[1], width: size, height: size / aspect,
  }));
  return { places, height: rows * step[1] - gap };
}
