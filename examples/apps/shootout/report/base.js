// SPDX-License-Identifier: MIT
// Data of the page, and what all of its parts use.
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const pictures = JSON.parse(document.getElementById('pictures').textContent);
const taps = JSON.parse(document.getElementById('taps-data').textContent);
const element = (id) => document.getElementById(id);
const colours = { shd: '#0f62c4', OpenImageIO: '#d2601a', llvmpipe: '#2b8a57', lavapipe: '#b13bd6' };
// The filters of lavapipe are nearly those of llvmpipe. So its points are smaller and lie in the others, and its lines
// are dashed.
const marks = {
  shd: { radius: 3.4, edge: 0.8, line: 1.6, dashes: 'none', opacity: 0.8 },
  OpenImageIO: { radius: 3.4, edge: 0.8, line: 1.6, dashes: 'none', opacity: 0.8 },
  llvmpipe: { radius: 4.4, edge: 0.8, line: 2.6, dashes: 'none', opacity: 0.8 },
  lavapipe: { radius: 2.5, edge: 0, line: 1.6, dashes: '6 5', opacity: 1 },
};
const svgNames = 'http://www.w3.org/2000/svg';

const costs = new Map(data.costs.map((row) => [row.w + '/' + row.s, row]));
const tables = new Map(data.tables.map((row) => [row.s, row]));
const rowOf = new Map(data.rows.map((row) => [row.w + '/' + row.t + '/' + row.s, row]));
const motionOf = new Map(data.motions.map((row) => [row.w + '/' + row.t + '/' + row.s, row]));
const peers = [...new Set(data.settings.map((setting) => setting.who))].filter((who) => who !== 'shd');

function svg(name, attributes, parent) {
  const node = document.createElementNS(svgNames, name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (parent) parent.appendChild(node);
  return node;
}

function html(name, text, parent, className) {
  const node = document.createElement(name);
  if (text !== undefined && text !== null) node.textContent = text;
  if (className) node.className = className;
  if (parent) parent.appendChild(node);
  return node;
}

function fill(select, items) {
  select.replaceChildren();
  for (const [value, text] of items) {
    const option = html('option', text, select);
    option.value = value;
  }
}

/** Machine, commit and hash, which every figure has. */
const stamp = (hash) => `${data.machine.cpu}, ${data.machine.commit}, #${hash}`;

function caption(figure, title, hash) {
  const node = html('figcaption', null, figure);
  html('b', title, node);
  html('span', stamp(hash), node, 'stamp');
}

/** FNV-1a of a text, for figures that the page draws from numbers. */
function hashOf(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; ++i) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, '0');
}

function showTip(event, text) {
  const tip = element('tip');
  tip.textContent = text;
  tip.hidden = false;
  tip.style.left = Math.min(event.clientX + 14, innerWidth - tip.offsetWidth - 10) + 'px';
  tip.style.top = Math.min(event.clientY + 14, innerHeight - tip.offsetHeight - 10) + 'px';
}

function tipOn(node, text) {
  node.addEventListener('pointermove', (event) => showTip(event, text));
  node.addEventListener('pointerleave', () => { element('tip').hidden = true; });
}

const number = (value, digits) => value === null || value === undefined ? '–' : value.toFixed(digits);
