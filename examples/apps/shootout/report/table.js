// SPDX-License-Identifier: MIT
// The sortable table of one workload and texture.
'use strict';

const movieIndex = (name) => data.movies.findIndex((movie) => movie.name === name);
const moving = (name, key) => (c) => (motionOf.get(movieIndex(name) + '/' + c.t + '/' + c.s) || {})[key];
// heading, unit, value of {row, cost, table, s, t}, digits, 1 = larger is better
const columns = [
  ['Filter', '', (c) => data.settings[c.s].title, null, 0],
  ['PSNR', 'dB', (c) => c.error[0], 2, 1], ['SSIM', '', (c) => c.error[1], 4, 1], ['FLIP', '', (c) => c.error[4], 4, -1],
  ['mean', '', (c) => c.error[2], 4, -1], ['max', '', (c) => c.error[3], 3, -1],
  ['aliasing', '', (c) => c.row.aliasing, 4, -1], ['blur', '', (c) => c.row.blur, 4, -1],
  ['texels', 'mean', (c) => c.cost.texels, 1, -1], ['texels', 'most', (c) => c.cost.most_texels, 0, -1],
  ['bytes', 'a lookup', (c) => c.cost.bytes, 0, -1],
  ['time', 'ns, whole', (c) => c.cost.whole_ns, 1, -1], ['time', 'ns, cached', (c) => c.cost.cached_ns, 1, -1],
  ['tables', 'MiB', (c) => c.table && c.table.bytes / 1048576, 2, -1], ['build', 'ms', (c) => c.table && c.table.build_ms, 2, -1],
  ['zoom', 'dB', moving('zoom', 'psnr'), 2, 1], ['zoom', 'flicker', moving('zoom', 'flicker'), 4, -1],
  ['pan', 'dB', moving('pan', 'psnr'), 2, 1], ['pan', 'flicker', moving('pan', 'flicker'), 4, -1],
];
let sorted = { column: 1, direction: -1 };

function cellsOfTable() {
  const w = +element('table-workload').value, t = +element('table-texture').value, truth = element('table-truth').value;
  const words = element('table-filter').value.toLowerCase();
  const list = [];
  data.settings.forEach((setting, s) => {
    const row = rowOf.get(w + '/' + t + '/' + s);
    if (!row || !(setting.title + ' ' + setting.name).toLowerCase().includes(words)) return;
    list.push({ s, t, row, error: row[truth], cost: costs.get(w + '/' + s), table: tables.get(s) });
  });
  return list;
}

function compareValues(a, b) {
  const missing = (value) => value === null || value === undefined;
  const x = columns[sorted.column][2](a), y = columns[sorted.column][2](b);
  if (missing(x) || missing(y)) return missing(x) - missing(y);
  return sorted.direction * (x < y ? -1 : x > y ? 1 : 0);
}

function drawHead() {
  const head = html('tr', null, element('rows').tHead);
  columns.forEach((column, i) => {
    const th = html('th', column[0], head);
    th.tabIndex = 0;
    html('small', column[1] || '\u00a0', th);
    const sort = () => {
      sorted = { column: i, direction: sorted.column === i ? -sorted.direction : column[4] > 0 ? -1 : 1 };
      drawTable();
    };
    th.addEventListener('click', sort);
    th.addEventListener('keydown', (event) => { if (event.key === 'Enter') sort(); });
  });
}

function drawTable() {
  const list = cellsOfTable(), body = element('rows').tBodies[0];
  const best = columns.map((column) => {
    const values = list.filter((c) => data.settings[c.s].name !== 'exact').map(column[2])
      .filter((v) => typeof v === 'number');
    return column[4] === 0 || !values.length ? null : column[4] > 0 ? Math.max(...values) : Math.min(...values);
  });
  [...element('rows').tHead.rows[0].cells].forEach((th, i) => {
    if (i === sorted.column) th.setAttribute('aria-sort', sorted.direction > 0 ? 'ascending' : 'descending');
    else th.removeAttribute('aria-sort');
  });
  body.replaceChildren();
  for (const c of list.sort(compareValues)) {
    const tr = html('tr', null, body), setting = data.settings[c.s];
    columns.forEach((column, i) => {
      const value = column[2](c), td = html('td', null, tr, value === best[i] && i > 0 ? 'best' : '');
      if (i === 0) html('span', null, td, 'dot').style.background = colours[setting.who];
      td.append(i === 0 ? value : (setting.estimated && i >= 8 && i <= 10 && value !== null ? '~' : '') + number(value, column[3]));
    });
    tr.title = '#' + c.row.hash;
    tr.addEventListener('click', () => compareWithTruth(+element('table-workload').value, c.t, setting.name));
  }
}
