// SPDX-License-Identifier: MIT
// The footprint of a clicked pixel, and the texels that a filter reads for it.
'use strict';

const picked = { index: 0 };

function textureOf(workload) {
  const key = frameKeys.find((k) => k.startsWith(workload + '/'));
  return key ? key.split('/')[1] : data.textures[0].name;
}

function drawTapFrame() {
  const entry = taps[+element('taps-workload').value], frame = element('taps-frame');
  frame.replaceChildren();
  const key = frameKeys.find((k) => k.startsWith(entry.workload + '/'));
  if (key) svg('image', { href: pictures.frames[key + '/truth'], width: 400, height: 400 }, frame);
  const scale = 400 / data.options.edge;
  entry.lookups.forEach((lookup, i) => {
    const dot = svg('circle', { cx: (lookup[0] + 0.5) * scale, cy: (lookup[1] + 0.5) * scale, r: i === picked.index ? 8 : 5,
      fill: i === picked.index ? '#d2601a' : '#fff', stroke: '#1c2330', 'stroke-width': 1.5 }, frame);
    dot.addEventListener('click', () => { picked.index = i; drawTapFrame(); drawTaps(); });
  });
}

/** Corners of the pixel in base texels around its centre: the centre plus or minus half of each derivative. */
function cornersOf(lookup, edge) {
  const [, , u, v, ux, vx, uy, vy] = lookup;
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) =>
    [edge * (u + (a * ux + b * uy) / 2), edge * (v + (a * vx + b * vy) / 2)]);
}

/** Taps as squares of base texels, moved by whole textures next to the point. */
function squaresOf(list, lookup, edge) {
  const squares = [];
  for (let i = 0; i < list.length; i += 5) {
    const [levelU, levelV, x, y, weight] = list.slice(i, i + 5);
    const w = 2 ** levelU, h = 2 ** levelV;
    const near = (at, to) => at + edge * Math.round((to - at) / edge);
    squares.push({ x: near((x + 0.5) * w, lookup[2] * edge) - w / 2, y: near((y + 0.5) * h, lookup[3] * edge) - h / 2,
      w, h, weight: weight / 1e4, level: levelU === levelV ? levelU : levelU + ', ' + levelV });
  }
  return squares;
}

function drawTaps() {
  const entry = taps[+element('taps-workload').value], name = element('taps-setting').value;
  const lookup = entry.lookups[picked.index], edge = data.options.texture_edge;
  const corners = cornersOf(lookup, edge), squares = squaresOf(entry.taps[name][picked.index], lookup, edge);
  const view = element('taps-view');
  view.replaceChildren();
  const xs = [...corners.map((c) => c[0]), ...squares.flatMap((s) => [s.x, s.x + s.w])];
  const ys = [...corners.map((c) => c[1]), ...squares.flatMap((s) => [s.y, s.y + s.h])];
  const cx = (Math.min(...xs) + Math.max(...xs)) / 2, cy = (Math.min(...ys) + Math.max(...ys)) / 2;
  const span = 1.12 * Math.max((Math.max(...xs) - Math.min(...xs)) / 600, (Math.max(...ys) - Math.min(...ys)) / 400, 6 / 400);
  const px = (x) => 300 + (x - cx) / span, py = (y) => 200 + (y - cy) / span;
  const image = pictures.textures[textureOf(entry.workload)];
  const first = (c, half) => Math.floor((c - half * span) / edge), last = (c, half) => Math.floor((c + half * span) / edge);
  for (let i = first(cx, 300); i <= last(cx, 300) && i < first(cx, 300) + 4; ++i) {
    for (let k = first(cy, 200); k <= last(cy, 200) && k < first(cy, 200) + 4; ++k) {
      svg('image', { href: image, x: px(i * edge), y: py(k * edge), width: edge / span, height: edge / span, opacity: 0.3,
        preserveAspectRatio: 'none', style: 'image-rendering:pixelated' }, view);
    }
  }
  const largest = Math.max(...squares.map((s) => Math.abs(s.weight)));
  for (const s of squares.sort((a, b) => b.w * b.h - a.w * a.h)) {
    const box = svg('rect', { x: px(s.x), y: py(s.y), width: s.w / span, height: s.h / span,
      fill: s.weight < 0 ? '#b3261e' : '#0f62c4', 'fill-opacity': 0.08 + 0.7 * Math.abs(s.weight) / largest, stroke: '#0f62c4',
      'stroke-opacity': 0.6, 'stroke-width': 0.7 }, view);
    tipOn(box, `level ${s.level}, weight ${s.weight.toFixed(4)}`);
  }
  svg('polygon', { points: corners.map((c) => px(c[0]) + ',' + py(c[1])).join(' '), fill: 'none', stroke: '#d2601a',
    'stroke-width': 2 }, view);
  svg('circle', { cx: px(lookup[2] * edge), cy: py(lookup[3] * edge), r: 3, fill: '#d2601a' }, view);
  const sum = squares.reduce((total, s) => total + s.weight, 0);
  element('taps-caption').textContent = `Pixel (${lookup[0]}, ${lookup[1]}): ${squares.length} different texels of levels ` +
    `${[...new Set(squares.map((s) => s.level))].sort().join(' and ')}; weights sum to ${sum.toFixed(3)}. ` +
    stamp(hashOf(JSON.stringify(entry.taps[name][picked.index])));
}

function startTaps() {
  fill(element('taps-workload'), taps.map((entry, i) => [i, data.workloads.find((w) => w.name === entry.workload).title]));
  fill(element('taps-setting'), Object.keys(taps[0].taps).map((name) => [name, data.settings.find((s) => s.name === name).title]));
  element('taps-setting').value = 'anisotropic_16';
  picked.index = Math.min(13, taps[0].lookups.length - 1);
  element('taps-workload').addEventListener('change', () => { drawTapFrame(); drawTaps(); });
  element('taps-setting').addEventListener('change', drawTaps);
  drawTapFrame();
  drawTaps();
}
