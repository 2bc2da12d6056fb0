// SPDX-License-Identifier: MIT
// The page: finds a device, judges it and shows the verdicts.
import { checkDevice } from "./check.js";
import { FAULTS, openDevice } from "./units.js";

const FIRST = 2000, MORE = 20000, SHOWN = 3;
const $ = (selector) => document.querySelector(selector);
const query = new URLSearchParams(location.search);
const fault = query.get("fault") ?? undefined;

function addCell(row, text, className = "") {
  const cell = row.insertCell();
  cell.textContent = text;
  cell.className = className;
}

/** A row of the table and, for refused lookups, the text of shd-check. */
function showVerdict({ format, size, wrap, filter, by, refused, lookups, excess, reason, text }) {
  const row = $("tbody").insertRow();
  for (const cell of [`${format} ${size}`, wrap, filter, by]) addCell(row, cell);
  addCell(row, `${refused} of ${lookups}`, `number ${refused ? "bad" : "good"}`);
  addCell(row, excess.toPrecision(3), "number");
  addCell(row, reason ? `${reason.options} (${reason.explained})` : refused ? "nothing" : "");
  if (!refused) return;
  const item = document.createElement("details");
  const summary = document.createElement("summary"), output = document.createElement("pre");
  summary.textContent = `${filter}, wrap ${wrap}, ${format} ${size}, by ${by}: ${refused} of ${lookups} refused`;
  output.textContent = text;
  item.append(summary, output);
  $("#reasons div").append(item);
  $("#reasons").hidden = false;
}

/** What explains most refused lookups of all rows. */
function showReasons(verdicts) {
  const sums = new Map();
  for (const { reason } of verdicts.filter((verdict) => verdict.reason)) {
    const sum = sums.get(reason.options) ?? { ...reason, explained: 0 };
    sums.set(reason.options, { ...sum, explained: sum.explained + reason.explained });
  }
  const best = [...sums.values()].sort((a, b) => b.explained - a.explained);
  for (const { options, text, explained } of best.slice(0, SHOWN)) {
    const item = document.createElement("li"), code = document.createElement("code");
    code.textContent = options;
    item.append(`${explained} of them are legal with `, code, `: ${text}.`);
    $("#explained").append(item);
  }
}

/** Judges the device, and returns what the page shows. */
async function run(count) {
  const { device, name, reason } = await openDevice();
  if (!device) {
    $("#device").textContent = `No verdict: ${reason}.`;
    return { reason };
  }
  $("#device").textContent = `Device: ${name}. shd-check judges ${count} lookups of each filter.`;
  for (const part of document.querySelectorAll("table, .note")) part.hidden = false;
  const verdicts = await checkDevice(device, count, fault, async (verdict) => {
    showVerdict(verdict);
    await new Promise(requestAnimationFrame);
  });
  device.destroy();
  const sum = (member) => verdicts.reduce((total, verdict) => total + verdict[member], 0);
  const refused = sum("refused"), lookups = sum("lookups");
  $("#verdict").textContent = refused ? `${refused} of ${lookups} lookups are not legal.`
    : `All ${lookups} lookups are legal.`;
  $("#verdict").className = refused ? "bad" : "good";
  showReasons(verdicts);
  $("#again").hidden = false;
  return { name, verdicts, refused, lookups };
}

function start(count) {
  for (const list of [$("tbody"), $("#explained"), $("#reasons div")]) list.replaceChildren();
  for (const part of [$("#again"), $("#reasons")]) part.hidden = true;
  $("#verdict").textContent = "";
  /** The result, for programs that drive the page. */
  window.verdict = run(count).catch((problem) => {
    $("#device").textContent = `No verdict: ${problem.message}`;
    return { problem: String(problem.stack ?? problem) };
  });
}

/** Links to the page with each fault. */
function showFaults() {
  for (const name of [undefined, ...Object.keys(FAULTS)]) {
    const link = document.createElement("a");
    link.textContent = name ?? "none";
    link.href = name ? `?fault=${name}` : "?";
    if (name === fault) link.setAttribute("aria-current", "page");
    $("#faults").append(" ", link);
  }
}

showFaults();
$("#again").addEventListener("click", () => start(MORE));
if (fault === undefined || fault in FAULTS) {
  start(Number(query.get("lookups")) || FIRST);
} else {
  $("#device").textContent = `No verdict: fault=${fault} is not one of ${Object.keys(FAULTS).join(", ")}.`;
}
