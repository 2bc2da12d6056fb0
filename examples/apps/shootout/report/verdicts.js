// SPDX-License-Identifier: MIT
// Lookups judged by shd_texture_bounds(): the share that is refused, and why.
'use strict';
const verdicts = JSON.parse(element('verdicts-data').textContent);

/** Sums of the rows of one family, filter and preset: the targets of shd are one family. */
function verdictOf(family, filter, rules) {
  const rows = verdicts.rows.filter((row) => verdicts.families[row.i] === family && row.f === filter && row.r === rules);
  const sum = (key) => rows.reduce((total, row) => total + row[key], 0);
  return {
    judged: sum('judged'), refused: sum('refused'), unexplained: sum('unexplained'),
    explained: verdicts.departures[family].map((_, d) => rows.reduce((total, row) => total + row.explained[d], 0)),
    farthest: Math.max(0, ...rows.map((row) => row.farthest)),
  };
}

function reasonsOf(family, cell) {
  if (!cell.judged) return 'Not judged: the rules of shd alone.';
  const count = (value) => value.toLocaleString('en');
  const reasons = verdicts.departures[family].map((departure, d) => [departure.name, cell.explained[d]])
    .concat([['not explained', cell.unexplained]]).filter(([, number]) => number)
    .map(([name, number]) => `${name}: ${count(number)}`);
  const far = cell.refused ? ` The farthest is ${(255 * cell.farthest).toPrecision(3)} steps of 8 bits from its bounds.` : '';
  return `${count(cell.refused)} of ${count(cell.judged)} refused.${far} ${reasons.join('; ')}`;
}

function drawVerdicts() {
  const families = [...new Set(verdicts.families)], table = element('verdicts-table');
  const head = html('tr', null, table);
  html('th', 'By', head, 'row');
  html('th', 'Filter', head, 'row');
  for (const rules of verdicts.rules) html('th', rules, head);
  let own = 0, judged = 0;
  for (const family of families) {
    verdicts.filters.forEach((filter, f) => {
      const row = html('tr', null, table);
      html('th', family, row, 'row');
      html('th', filter, row, 'row');
      verdicts.rules.forEach((_, r) => {
        const cell = verdictOf(family, f, r);
        if (family === 'shd') own += cell.refused, judged += cell.judged;
        const share = 100 * cell.refused / cell.judged;
        const text = !cell.judged ? '–' : cell.refused ? `${share < 0.005 ? '< 0.01' : share.toFixed(2)} %` : '0';
        tipOn(html('td', text, row), reasonsOf(family, cell));
      });
    });
  }
  const targets = verdicts.implementations.filter((_, i) => verdicts.families[i] === 'shd');
  element('verdicts-verdict').textContent = `shd: ${own} of ${judged.toLocaleString('en')} values refused (${targets.join('; ')}).`;
  const missing = verdicts.missing.length ? ` Not judged: ${verdicts.missing.join('; ')}.` : '';
  element('verdicts-text').textContent = `${verdicts.lookups.toLocaleString('en')} lookups of each implementation, with ` +
    'footprints of 1/8 to 64 texels and ratios of 1 to 16, on textures with the same levels for all: ' +
    `${verdicts.textures.join('; ')}. shd_texture_bounds() computes the legal values.${missing}`;
  for (const family of families.filter((name) => name !== 'shd')) {
    const rows = verdicts.rows.filter((row) => verdicts.families[row.i] === family);
    const add = (name, number, text) => {
      const item = html('li', null, element('verdicts-departures'));
      html('b', `${family}, ${name}: ${number.toLocaleString('en')}. `, item);
      html('span', text, item);
    };
    verdicts.departures[family].forEach((departure, d) => {
      add(departure.name, rows.reduce((sum, row) => sum + row.explained[d], 0), departure.text);
    });
    const worst = rows.reduce((a, b) => (b.farthest_unexplained > a.farthest_unexplained ? b : a));
    add('not explained', rows.reduce((sum, row) => sum + row.unexplained, 0), worst.example);
  }
}
