// SPDX-License-Identifier: MIT
'use strict';

function describe() {
  const m = data.machine;
  element('machine').textContent = `${m.cpu}, ${m.cores} cores; ${m.compiler}; shd ${m.commit}; ${m.date}. ${data.peers.join('; ')}.`;
  element('footer').textContent = `shd ${m.commit}, ${m.date}. Results: #${hashOf(JSON.stringify(data.rows))}.`;
  if (data.missing.length) {
    element('missing').hidden = false;
    element('missing').textContent = 'Without rows: ' + data.missing.join('; ') + '.';
  }
  const o = data.options;
  element('method-text').textContent = `Frames of ${o.edge} x ${o.edge} pixels and textures of ${o.texture_edge} x ${o.texture_edge} ` +
    `RGBA8 texels. The truth is the mean of ${o.samples} x ${o.samples} regular samples a pixel of the bilinear reconstruction, projected in ` +
    `doubles and shaded one by one. Movies have frames of ${o.movie_edge} x ${o.movie_edge} pixels. Times are of one thread, the ` +
    'fastest of several runs; in cache: 256 neighbouring lookups again and again.';
}

function start() {
  describe();
  drawFronts();
  whoLegend(element('plot-legend'));
  const textures = data.textures.map((texture, i) => [i, texture.title]);
  fill(element('plot-texture'), textures);
  fill(element('table-texture'), textures);
  fill(element('plot-up'), measures.map((m) => [m[0], m[1]]));
  fill(element('table-workload'), data.workloads.map((workload, i) => [i, workload.title]));
  for (const id of ['plot-texture', 'plot-across', 'plot-up']) element(id).addEventListener('change', drawPlots);
  for (const id of ['table-workload', 'table-texture', 'table-truth']) element(id).addEventListener('change', drawTable);
  element('table-filter').addEventListener('input', drawTable);
  for (const form of document.forms) form.addEventListener('submit', (event) => event.preventDefault());
  drawPlots();
  drawHead();
  drawTable();
  startTaps();
  startLevels();
  drawRosettes();
  drawCurve();
  drawVerdicts();
  drawFigures();
  return startCompare();
}
start().then(() => { document.body.dataset.ready = 'yes'; });
