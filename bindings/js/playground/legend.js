// SPDX-License-Identifier: MIT
import { LEVELS, RATIO_COLOURS, RATIOS } from "./falsecolour.js";

const legend = document.querySelector("#legend");
const TABLES = {
  level: ["Level of detail", LEVELS.map((colour, i) => [colour, i])],
  anisotropy: ["Ratio of the footprint's axes", RATIO_COLOURS.map((colour, i) => [colour, RATIOS[i]])],
};

/** The colours of a view. */
export function showLegend(view) {
  legend.hidden = !TABLES[view];
  if (legend.hidden) return;
  const [title, rows] = TABLES[view];
  legend.replaceChildren(title, ...rows.map(([colour, label]) => {
    const swatch = document.createElement("span");
    swatch.style.setProperty("--colour", colour);
    swatch.textContent = label;
    return swatch;
  }));
}
