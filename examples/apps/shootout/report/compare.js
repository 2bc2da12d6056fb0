// SPDX-License-Identifier: MIT
// Two pictures under a wipe, a flicker, a difference or the map of FLIP, with zoom.
'use strict';

const stage = { wipe: 0.5, zoom: 3, x: 0.5, y: 0.5, phase: 0, a: null, b: null, flip: null, timer: 0 };
const canvas = element('stage-canvas');
const frameKeys = [...new Set(Object.keys(pictures.frames).map((key) => key.split('/').slice(0, 2).join('/')))];

function titleOf(key) {
  const [w, t] = key.split('/');
  return data.workloads.find((x) => x.name === w).title + ' – ' + data.textures.find((x) => x.name === t).title;
}

function load(uri) {
  return new Promise((resolve, reject) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.onerror = () => reject(new Error('a picture of the page cannot be decoded'));
    image.src = uri;
  });
}

function pixelsOf(image, edge) {
  const copy = document.createElement('canvas');
  copy.width = copy.height = edge;
  const context = copy.getContext('2d');
  context.imageSmoothingEnabled = false;
  context.drawImage(image, 0, 0, edge, edge);
  return [copy, context, context.getImageData(0, 0, edge, edge)];
}

/** |a - b| x 4 of each channel. */
function differenceOf(a, b) {
  const [copy, context, first] = pixelsOf(a, a.width), second = pixelsOf(b, a.width)[2];
  for (let i = 0; i < first.data.length; ++i) {
    if (i % 4 !== 3) first.data[i] = Math.min(255, 4 * Math.abs(first.data[i] - second.data[i]));
  }
  context.putImageData(first, 0, 0);
  return copy;
}

/** A map in the colours black, purple, orange, white. */
function heatOf(image) {
  const [copy, context, pixels] = pixelsOf(image, image.width);
  for (let i = 0; i < pixels.data.length; i += 4) {
    const v = pixels.data[i] / 255;
    pixels.data[i] = 255 * Math.min(1, 2.2 * v);
    pixels.data[i + 1] = 255 * Math.max(0, Math.min(1, 2.4 * (v - 0.35)));
    pixels.data[i + 2] = 255 * (v < 0.35 ? 1.6 * v : Math.max(0.1, Math.min(1, 0.56 - 1.6 * (v - 0.35) + 3 * Math.max(0, v - 0.65))));
  }
  context.putImageData(pixels, 0, 0);
  return copy;
}

function drawStage() {
  if (!stage.a || !stage.b) return;
  const context = canvas.getContext('2d'), view = element('compare-view').value;
  const size = stage.a.width * stage.zoom;
  const left = Math.round(canvas.width / 2 - stage.x * size), top = Math.round(canvas.height / 2 - stage.y * size);
  const draw = (image) => context.drawImage(image, left, top, size, size);
  context.imageSmoothingEnabled = false;
  context.fillStyle = '#262b33';
  context.fillRect(0, 0, canvas.width, canvas.height);
  if (view === 'difference') return draw(stage.difference = stage.difference || differenceOf(stage.a, stage.b));
  if (view === 'flip' && stage.flip) return draw(stage.heat = stage.heat || heatOf(stage.flip));
  if (view === 'flip') {
    context.fillStyle = '#fff';
    context.font = '16px sans-serif';
    return context.fillText('The truth has no error map. Choose a filter on the right.', 30, 40);
  }
  if (view === 'flicker') return draw(stage.phase ? stage.b : stage.a);
  draw(stage.a);
  const x = Math.round(stage.wipe * canvas.width);
  context.save();
  context.beginPath();
  context.rect(x, 0, canvas.width - x, canvas.height);
  context.clip();
  draw(stage.b);
  context.restore();
  context.fillStyle = '#fff';
  context.fillRect(x - 1, 0, 2, canvas.height);
  context.beginPath();
  context.arc(x, canvas.height / 2, 9, 0, 7);
  context.fill();
  context.fillStyle = '#1c2330';
  context.font = 'bold 12px sans-serif';
  context.textAlign = 'center';
  context.fillText('\u2194', x, canvas.height / 2 + 4);
}

async function chooseFrames() {
  const frame = element('compare-frame').value, a = element('compare-a').value, b = element('compare-b').value;
  const [first, second] = await Promise.all([load(pictures.frames[frame + '/' + a]), load(pictures.frames[frame + '/' + b])]);
  const map = pictures.flips[frame + '/' + b];
  const flip = map ? await load(map) : null;
  Object.assign(stage, { a: first, b: second, flip, difference: null, heat: null });
  const [w, t] = frame.split('/').map((name, i) => (i ? data.textures : data.workloads).findIndex((x) => x.name === name));
  const texts = [a, b].map((name) => {
    const s = data.settings.findIndex((x) => x.name === name), row = rowOf.get(w + '/' + t + '/' + s);
    return row ? `${data.settings[s].title}: ${row.samples[0].toFixed(2)} dB, FLIP ${row.samples[4].toFixed(4)}, #${row.hash}` :
      `Truth, ${data.options.samples} x ${data.options.samples} samples a pixel`;
  });
  element('compare-caption').textContent = `Left: ${texts[0]}. Right: ${texts[1]}. ${data.machine.cpu}, ${data.machine.commit}.`;
  drawStage();
}

function fillSides() {
  const frame = element('compare-frame').value, old = [element('compare-a').value, element('compare-b').value];
  const names = Object.keys(pictures.frames).filter((key) => key.startsWith(frame + '/')).map((key) => key.split('/')[2]);
  const items = names.map((name) => [name, name === 'truth' ? 'Truth' : data.settings.find((x) => x.name === name).title]);
  [['compare-a', 'trilinear'], ['compare-b', 'anisotropic_16']].forEach(([id, usual], i) => {
    fill(element(id), items);
    element(id).value = names.includes(old[i]) ? old[i] : usual;
  });
}

function compareWithTruth(w, t, setting) {
  const frame = data.workloads[w].name + '/' + data.textures[t].name;
  if (!pictures.frames[frame + '/' + setting]) return;
  element('compare-frame').value = frame;
  fillSides();
  element('compare-a').value = 'truth';
  element('compare-b').value = setting;
  chooseFrames();
  element('compare').scrollIntoView();
}

function setZoom(zoom) {
  stage.zoom = Math.min(16, Math.max(1, zoom));
  element('compare-zoom').value = stage.zoom;
  element('compare-zoom-text').textContent = stage.zoom;
  drawStage();
}

function startCompare() {
  fill(element('compare-frame'), frameKeys.map((key) => [key, titleOf(key)]));
  const usual = frameKeys.find((key) => key.startsWith('floor_45/checker') || key.startsWith('floor/'));
  if (usual) element('compare-frame').value = usual;
  fillSides();
  element('compare-frame').addEventListener('change', () => { fillSides(); chooseFrames(); });
  for (const id of ['compare-a', 'compare-b']) element(id).addEventListener('change', chooseFrames);
  element('compare-view').addEventListener('change', drawStage);
  element('compare-zoom').addEventListener('input', () => setZoom(+element('compare-zoom').value));
  setZoom(Math.floor(canvas.height / data.options.edge));
  let drag = null;
  const box = element('stage');
  box.addEventListener('pointerdown', (event) => {
    box.setPointerCapture(event.pointerId);
    const at = (event.clientX - box.getBoundingClientRect().left) / box.clientWidth;
    const wipes = element('compare-view').value === 'wipe' && !event.shiftKey;
    drag = { wipes, x: event.clientX, y: event.clientY };
    if (wipes) { stage.wipe = at; drawStage(); }
  });
  box.addEventListener('pointermove', (event) => {
    if (!drag) return;
    if (drag.wipes) {
      stage.wipe = Math.min(1, Math.max(0, (event.clientX - box.getBoundingClientRect().left) / box.clientWidth));
    } else {
      const scale = canvas.width / box.clientWidth / (stage.a.width * stage.zoom);
      stage.x -= (event.clientX - drag.x) * scale;
      stage.y -= (event.clientY - drag.y) * scale;
      drag.x = event.clientX, drag.y = event.clientY;
    }
    drawStage();
  });
  box.addEventListener('pointerup', () => { drag = null; });
  box.addEventListener('wheel', (event) => { event.preventDefault(); setZoom(stage.zoom - Math.sign(event.deltaY)); }, { passive: false });
  box.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: -0.02, ArrowRight: 0.02 }[event.key];
    if (step) { stage.wipe = Math.min(1, Math.max(0, stage.wipe + step)); drawStage(); event.preventDefault(); }
  });
  setInterval(() => {
    if (element('compare-view').value !== 'flicker') return;
    stage.phase ^= 1;
    drawStage();
  }, 500);
  return chooseFrames();
}
