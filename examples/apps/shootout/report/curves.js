// SPDX-License-Identifier: MIT
// Level views, the rosette, the level curve and the figures of a course.
'use strict';

function pictureFigure(parent, title, uri, hash) {
  const figure = html('figure', null, parent), image = html('img', null, figure);
  image.alt = title;
  image.src = uri;
  image.addEventListener('load', () => figure.classList.toggle('wide', image.naturalWidth > 1.5 * image.naturalHeight));
  caption(figure, title, hash);
}

function drawLevels() {
  const grid = element('levels-grid'), nearest = element('levels-nearest').checked ? 1 : 0;
  grid.replaceChildren();
  for (const level of pictures.levels) {
    if (level.workload === element('levels-workload').value && level.nearest === nearest) {
      pictureFigure(grid, level.profile, level.png, level.hash);
    }
  }
}

function startLevels() {
  fill(element('levels-workload'), [...new Set(pictures.levels.map((l) => l.workload))].map((title) => [title, title]));
  for (const id of ['levels-workload', 'levels-nearest']) element(id).addEventListener('change', drawLevels);
  const levelColours = ['#0073b3', '#57b5e8', '#009e73', '#f0e342', '#e69f00', '#d65e00', '#cc78a6', '#999999', '#d9d9d9'];
  levelColours.forEach((colour, i) => {
    const span = html('span', null, element('levels-legend'));
    html('i', null, span, 'box').style.background = colour;
    span.append(i === levelColours.length - 1 ? i + ' and coarser' : i);
  });
  drawLevels();
}

/** Dark blue, purple, orange, yellow for 0..1. */
function heat(v) {
  const stops = [[20, 20, 60], [110, 30, 110], [220, 80, 50], [250, 180, 40], [255, 250, 190]];
  const at = Math.min(0.9999, Math.max(0, v)) * (stops.length - 1), i = Math.floor(at), f = at - i;
  return `rgb(${stops[i].map((c, k) => Math.round(c + f * (stops[i + 1][k] - c))).join(',')})`;
}

function rosetteFigure(row, largest, parent) {
  const cells = Math.round(Math.sqrt(row.errors.length)), figure = html('figure', null, parent);
  const graph = svg('svg', { viewBox: '0 0 210 210', role: 'img' }, figure);
  const title = data.settings[row.s].title;
  graph.setAttribute('aria-label', title);
  const at = (radius, angle) => [4 + radius * Math.cos(angle), 204 - radius * Math.sin(angle)].map((v) => v.toFixed(2)).join(' ');
  for (let ring = 0; ring < cells; ++ring) {
    for (let column = 0; column < cells; ++column) {
      const r0 = 20 + 180 * ring / cells, r1 = 20 + 180 * (ring + 1) / cells;
      const a0 = Math.PI / 2 * column / cells, a1 = Math.PI / 2 * (column + 1) / cells;
      const value = row.errors[ring * cells + column];
      const cell = svg('path', { d: `M${at(r0, a0)} L${at(r1, a0)} A${r1} ${r1} 0 0 0 ${at(r1, a1)} L${at(r0, a1)} A${r0} ${r0} 0 0 1 ${at(r0, a0)}`,
        fill: heat(Math.sqrt(value / largest)) }, graph);
      tipOn(cell, `${title}\n${(90 * column / (cells - 1)).toFixed(0)} degrees, ratio ${(2 ** (6 * ring / (cells - 1))).toFixed(1)}\nrms error ${value}`);
    }
  }
  caption(figure, title, hashOf(row.errors.join()));
}

function drawRosettes() {
  const names = ['nearest', 'bilinear_mip', 'trilinear', 'ripmap', 'summed_area', 'summed_area_oriented', 'one_level_16', 'anisotropic_16',
    'ewa_16', 'anisotropic_vulkan', 'OpenImageIO_trilinear', 'OpenImageIO_anisotropic_16', 'llvmpipe_trilinear', 'llvmpipe_anisotropic_16',
    'lavapipe_trilinear', 'lavapipe_anisotropic_16'];
  const rows = data.rosette.filter((row) => names.includes(data.settings[row.s].name))
    .sort((a, b) => names.indexOf(data.settings[a.s].name) - names.indexOf(data.settings[b.s].name));
  if (!rows.length) {
    html('p', 'This quick run has no rosette, because it has no photograph.', element('rosette-grid'), 'note');
    return;
  }
  const largest = rows.flatMap((row) => row.errors).sort((a, b) => a - b)[Math.floor(0.98 * rows.length * rows[0].errors.length)];
  rows.forEach((row) => rosetteFigure(row, largest, element('rosette-grid')));
  for (const share of [0, 0.0625, 0.25, 0.5625, 1]) {
    const span = html('span', null, element('rosette-scale'));
    html('i', null, span, 'box').style.background = heat(Math.sqrt(share));
    span.append((share * largest).toFixed(3) + (share === 1 ? ' and more' : ''));
  }
}

const shownCurves = new Set(['trilinear', 'trilinear_exact', 'bilinear_mip', 'ewa_16', 'OpenImageIO_trilinear', 'llvmpipe_trilinear']);
const curvePalette = ['#0f62c4', '#e0559a', '#7a8797', '#6a3fb5', '#d2601a', '#2b8a57', '#b08a00', '#00929c'];

function drawCurve() {
  const width = 980, height = 330, left = 44, bottom = 34, top = 10, box = element('curve-plot');
  box.replaceChildren();
  const graph = svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Level transfer' }, box);
  const lods = data.level_curve.lod, px = (l) => left + (l + 2) / 8 * (width - left - 10);
  const py = (c) => height - bottom - (Math.log2(Math.max(c, 0.25)) + 2) / 4 * (height - top - bottom);
  for (let l = -2; l <= 6; ++l) {
    svg('line', { class: 'axis', x1: px(l), x2: px(l), y1: top, y2: height - bottom }, graph);
    svg('text', { x: px(l), y: height - bottom + 14, 'text-anchor': 'middle' }, graph).textContent = l < 0 ? '1/' + 2 ** -l : 2 ** l;
  }
  for (const c of [0.25, 0.5, 1, 2, 4]) {
    svg('line', { class: 'axis', x1: left, x2: width - 10, y1: py(c), y2: py(c), 'stroke-width': c === 1 ? 2.5 : 1 }, graph);
    svg('text', { x: left - 5, y: py(c) + 3, 'text-anchor': 'end' }, graph).textContent = c;
  }
  svg('text', { x: width - 10, y: height - 4, 'text-anchor': 'end' }, graph).textContent = 'footprint [texels]';
  const legend = element('curve-legend');
  legend.replaceChildren();
  const listed = data.level_curve.settings.filter((row) => [...shownCurves].includes(data.settings[row.s].name) || row.listed);
  listed.forEach((row, i) => {
    row.listed = true;
    const setting = data.settings[row.s], colour = curvePalette[i % curvePalette.length], on = shownCurves.has(setting.name);
    const button = html('button', null, legend);
    html('i', null, button).style.background = colour;
    button.append(setting.title);
    button.type = 'button';
    button.setAttribute('aria-pressed', on);
    button.addEventListener('click', () => { if (on) shownCurves.delete(setting.name); else shownCurves.add(setting.name); drawCurve(); });
    if (!on) return;
    const line = svg('polyline', { fill: 'none', stroke: colour, 'stroke-width': 1.8,
      points: row.contrast.map((c, k) => `${px(lods[k]).toFixed(1)},${py(Math.min(c, 4)).toFixed(1)}`).join(' ') }, graph);
    tipOn(line, setting.title);
  });
  html('p', stamp(hashOf(JSON.stringify(data.level_curve.settings.map((r) => r.contrast)))), box, 'stamp');
}

function drawFigures() {
  for (const figure of pictures.figures) pictureFigure(element('figures-grid'), figure.title, figure.png, figure.hash);
}
