// SPDX-License-Identifier: MIT
// Fronts of budgets, and quality over cost.
'use strict';

/** Six bars a cell, one for each budget: high and blue where shd is on the front. */
function frontCell(w, t, peer, budgets, found, parent) {
  const td = html('td', null, parent);
  for (const budget of budgets) {
    const row = found.get([w, t, peer, budget].join('/'));
    if (!row) continue;
    const mark = html('i', null, td, row.default_on ? 'on' : row.on ? 'profile' : 'off');
    tipOn(mark, `${data.workloads[w].title}\n${data.textures[t].title}, ${budget} texels, ${peer}\n` +
      `shd: ${data.settings[row.own].title}\n${data.settings[row.other].title}\nlead ${row.lead.toFixed(2)} dB, ` +
      `with the default profile ${row.default_lead.toFixed(2)} dB`);
  }
}

function drawFronts() {
  const budgets = [...new Set(data.fronts.map((row) => row.budget))];
  const found = new Map(data.fronts.map((row) => [[row.w, row.t, row.peer, row.budget].join('/'), row]));
  const on = data.fronts.filter((row) => row.on).length, usual = data.fronts.filter((row) => row.default_on).length;
  element('front-verdict').textContent = data.fronts.length === 0 ? 'No peer is installed.' :
    `shd is on the front in ${on} of ${data.fronts.length} cases (${(100 * on / data.fronts.length).toFixed(1)} %), ` +
    `with its default profile in ${usual} (${(100 * usual / data.fronts.length).toFixed(1)} %).`;
  element('front-budgets').textContent = budgets.join(', ');
  const table = element('front-table'), head = html('tr', null, table), second = html('tr', null, table);
  html('th', 'Workload', head, 'row').rowSpan = 2;
  for (const texture of data.textures) {
    html('th', texture.name.replace('_', ' '), head).colSpan = peers.length;
    for (const peer of peers) html('th', peer === 'OpenImageIO' ? 'OIIO' : peer, second, 'peer');
  }
  data.workloads.forEach((workload, w) => {
    const tr = html('tr', null, table);
    html('th', workload.title.split(':')[0], tr, 'row');
    data.textures.forEach((texture, t) => { for (const peer of peers) frontCell(w, t, peer, budgets, found, tr); });
  });
  const misses = data.fronts.filter((row) => !row.on), box = element('front-misses');
  box.querySelector('summary').textContent = misses.length ? `Where it is not (${misses.length})` : 'It is on the front everywhere.';
  for (const row of misses) {
    html('li', `${data.workloads[row.w].name}, ${data.textures[row.t].name}, ${row.budget} texels: ` +
      `${data.settings[row.other].title} is ${(-row.lead).toFixed(2)} dB better than ${data.settings[row.own].title}`,
      box.querySelector('ul'));
  }
}

const measures = [['psnr', 'PSNR [dB]', 0, 1], ['ssim', 'SSIM', 1, 1], ['flip', 'FLIP', 4, -1], ['mean', 'mean error', 2, -1]];

/** Points of one workload: cost across, quality up, larger is better. */
function pointsOf(w, t, across, measure) {
  const points = [];
  data.settings.forEach((setting, s) => {
    const row = rowOf.get(w + '/' + t + '/' + s), cost = costs.get(w + '/' + s);
    if (!row || !cost || cost[across] === null || setting.name === 'exact') return;
    points.push({ s, setting, x: cost[across], y: row.samples[measure[2]], good: measure[3] * row.samples[measure[2]] });
  });
  return points;
}

function frontOf(points) {
  const front = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || b.good - a.good)) {
    if (!front.length || point.good > front[front.length - 1].good) front.push(point);
  }
  return front;
}

function plot(w, t, across, measure, parent) {
  const width = 300, height = 200, left = 36, right = 8, top = 8, bottom = 30;
  const points = pointsOf(w, t, across, measure);
  const figure = html('figure', null, parent);
  const graph = svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img' }, figure);
  const title = data.workloads[w].title;
  graph.setAttribute('aria-label', `${title}: ${measure[1]} over ${across}`);
  const xs = points.map((p) => Math.log2(p.x)), ys = points.map((p) => p.y);
  const x0 = Math.floor(Math.min(...xs)), x1 = Math.max(Math.ceil(Math.max(...xs)), x0 + 1);
  const span = Math.max(...ys) - Math.min(...ys) || 2, y0 = Math.min(...ys) - 0.06 * span, y1 = Math.max(...ys) + 0.06 * span;
  const px = (x) => left + (Math.log2(x) - x0) / (x1 - x0) * (width - left - right);
  const py = (y) => measure[3] > 0 ? height - bottom - (y - y0) / (y1 - y0) * (height - top - bottom)
    : top + (y - y0) / (y1 - y0) * (height - top - bottom);
  const every = Math.ceil((x1 - x0) / 7);
  for (let k = x0; k <= x1; k += every) {
    svg('line', { class: 'axis', x1: px(2 ** k), x2: px(2 ** k), y1: top, y2: height - bottom }, graph);
    svg('text', { x: px(2 ** k), y: height - bottom + 12, 'text-anchor': 'middle' }, graph).textContent = +(2 ** k).toPrecision(3);
  }
  const unit = 10 ** Math.floor(Math.log10((y1 - y0) / 3)), step = [1, 2, 5, 10].map((f) => f * unit).find((u) => (y1 - y0) / u <= 6);
  for (let y = Math.ceil(y0 / step) * step; y <= y1; y += step) {
    svg('line', { class: 'axis', x1: left, x2: width - right, y1: py(y), y2: py(y) }, graph);
    svg('text', { x: left - 4, y: py(y) + 3, 'text-anchor': 'end' }, graph).textContent = +y.toPrecision(4);
  }
  svg('text', { x: width - right, y: height - 4, 'text-anchor': 'end' }, graph).textContent =
    across === 'texels' ? 'texels a lookup' : 'ns a lookup';
  for (const who of ['shd', ...peers]) {
    const line = frontOf(points.filter((p) => p.setting.who === who));
    svg('polyline', { points: line.map((p) => `${px(p.x)},${py(p.y)}`).join(' '), fill: 'none', stroke: colours[who],
      'stroke-width': marks[who].line, 'stroke-opacity': marks[who].opacity, 'stroke-dasharray': marks[who].dashes }, graph);
  }
  for (const p of points) {
    const mark = marks[p.setting.who];
    const dot = svg('circle', { cx: px(p.x), cy: py(p.y), r: mark.radius, fill: colours[p.setting.who], 'fill-opacity': mark.opacity,
      stroke: '#fff', 'stroke-width': mark.edge }, graph);
    tipOn(dot, `${p.setting.title}\n${measure[1]} ${+p.y.toPrecision(5)}, ${+p.x.toPrecision(4)} ${across === 'texels' ? 'texels' : 'ns'}`);
  }
  caption(figure, title, hashOf(points.map((p) => p.x + ',' + p.y).join(';')));
}

function drawPlots() {
  const t = +element('plot-texture').value, across = element('plot-across').value;
  const measure = measures.find((m) => m[0] === element('plot-up').value);
  const grid = element('plot-grid');
  grid.replaceChildren();
  data.workloads.forEach((workload, w) => plot(w, t, across, measure, grid));
}

function whoLegend(parent) {
  for (const who of ['shd', ...peers]) {
    const span = html('span', null, parent);
    html('i', null, span).style.background = colours[who];
    span.append(who);
  }
}
