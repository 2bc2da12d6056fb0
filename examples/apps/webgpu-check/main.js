// SPDX-License-Identifier: MIT
// The page: finds a device, judges it and shows the verdicts.
import { load } from "../../../bindings/js/lib/index.js";
import { checkDevice } from "./check.js";
import { openDevice } from "./units.js";

const FIRST = 2000, MORE = 20000, SHOWN = 5;
const $ = (selector) => document.querySelector(selector);
const short = (x) => (Number.isFinite(x) ? Number(x.toPrecision(4)) : x);

function addCell(row, text, className = "") {
  const cell = row.insertCell();
  cell.textContent = text;
  cell.className = className;
}

function showVerdict(verdict) {
  const row = $("tbody").insertRow();
  const { format, size, wrap, filter, by } = verdict;
  for (const text of [`${format} ${size}`, wrap, filter, by]) addCell(row, text);
  addCell(row, `${verdict.refused} of ${verdict.lookups}`, `number ${verdict.refused ? "bad" : "good"}`);
  addCell(row, verdict.refused ? short(verdict.worst[0].excess) : "0", "number");
  addCell(row, `${verdict.shifted} of ${verdict.lookups}`, "number");
}

function showWorst(verdicts) {
  const all = verdicts.flatMap((verdict) => verdict.worst.map((worst) => ({ verdict, ...worst })));
  all.sort((a, b) => b.excess - a.excess);
  for (const { verdict, channel, value, low, high, lookup } of all.slice(0, SHOWN)) {
    const item = document.createElement("li");
    const place = Object.entries(lookup).map(([name, x]) => `${name} ${short(x)}`).join(", ");
    item.textContent = `${verdict.filter}, ${verdict.format}: ${channel} = ${short(value)} is not in ${short(low)} to `
      + `${short(high)}; lookup ${place}`;
    $("#worst ul").append(item);
  }
  $("#worst").hidden = !all.length;
}

/** Judges the device, and returns what the page shows. */
async function run(count) {
  const { device, name, reason } = await openDevice();
  if (!device) {
    $("#device").textContent = `No verdict: ${reason}.`;
    return { reason };
  }
  $("#device").textContent = `Device: ${name}. libshd judges ${count} lookups of each filter.`;
  const shd = await load();
  for (const part of document.querySelectorAll("table, .note")) part.hidden = false;
  const verdicts = await checkDevice(shd, device, count, async (verdict) => {
    showVerdict(verdict);
    await new Promise(requestAnimationFrame);
  });
  device.destroy();
  const refused = verdicts.reduce((sum, verdict) => sum + verdict.refused, 0);
  const lookups = verdicts.reduce((sum, verdict) => sum + verdict.lookups, 0);
  $("#verdict").textContent = refused ? `${refused} of ${lookups} lookups are not legal.`
    : `All ${lookups} lookups are legal.`;
  $("#verdict").className = refused ? "bad" : "good";
  showWorst(verdicts);
  $("#again").hidden = false;
  return { name, verdicts, refused, lookups };
}

function start(count) {
  for (const list of [$("tbody"), $("#worst ul")]) list.replaceChildren();
  $("#again").hidden = true;
  $("#verdict").textContent = "";
  /** The result, for programs that drive the page. */
  window.verdict = run(count).catch((problem) => {
    $("#device").textContent = `No verdict: ${problem.message}`;
    return { problem: String(problem.stack ?? problem) };
  });
}

$("#again").addEventListener("click", () => start(MORE));
start(Number(new URLSearchParams(location.search).get("lookups")) || FIRST);
