// SPDX-License-Identifier: MIT
// Opens the page in a headless Chromium with a software device, and prints the verdicts:
//
//   node test.mjs CHROMIUM FOLDER
//
// FOLDER has shd-check.mjs and shd-check.wasm. Exit code 77: it has none, or there is no WebGPU.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { openPage } from "../../../bindings/js/tests/browser.mjs";

const ROOT = fileURLToPath(new URL("../../..", import.meta.url));
const PAGE = "/examples/apps/webgpu-check/index.html";
const LOOKUPS = 1000, LOOKUPS_OF_FAULTS = 200;
/** Words of the options that explain a fault. */
const FAULTS = { "clamp": "--wrap clamp", "nearest": "--filter nearest", "half-texel": "texel-right-down",
                 "flip-v": "flipped-v", "coarse": "--bias ", "bgra": "order-bgra", "srgb-twice": "srgb" };
const FLAGS = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"];
const [chromium, folder] = process.argv.slice(2);
const REPORT = `<script type="module">
  while (!window.verdict) await new Promise((resume) => setTimeout(resume, 50));
  const verdict = await window.verdict;
  await fetch("/verdict", { method: "POST", body: JSON.stringify({ ...verdict, text: document.body.innerText }) });
</script>`;

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

/** Files of the repository, and the module. The page reports to the server. */
function find(path) {
  const bytes = readFileSync(/\/shd-check\.(mjs|wasm)$/.test(path) ? join(folder, basename(path)) : join(ROOT, path));
  return path === PAGE ? bytes.toString().replace("</body>", `${REPORT}</body>`) : bytes;
}

/** What the page shows. */
async function judge(query) {
  const result = await openPage(chromium, { page: `${PAGE}?${query}`, flags: FLAGS, seconds: 240, find });
  if (result.reason) skip(result.reason);
  assert.equal(result.problem, undefined);
  assert.equal(result.verdicts.length, 28);
  const { refused, lookups, text } = result;
  assert(text.includes(refused ? `${refused} of ${lookups} lookups are not legal.` : `All ${lookups} lookups`), text);
  return result;
}

if (!existsSync(join(folder, "shd-check.mjs"))) {
  skip(`there is no shd-check.mjs in ${folder} (examples/apps/webgpu-check/README.md)`);
}
const { name, verdicts, refused, lookups, text } = await judge(`lookups=${LOOKUPS}`);
console.log(`device: ${name}`);
for (const row of verdicts) {
  const plan = `${row.format} ${row.size} ${row.wrap} ${row.filter} by ${row.by}`;
  const excess = row.refused ? `, largest excess ${row.excess.toPrecision(3)}` : "";
  console.log(`${plan}: ${row.refused} of ${row.lookups} refused${excess}`);
}
console.log(`${refused} of ${lookups} lookups are not legal`);
// SwiftShader has places of 16 bits and approximations of levels, so that a few lookups are not legal.
for (const row of verdicts) {
  assert(row.refused <= 0.01 * row.lookups, `${row.filter}: ${row.refused} of ${row.lookups} lookups are refused`);
  assert(row.text.startsWith("row ") === row.refused > 0, row.text);
  assert(row.text.includes(`${row.refused} of ${LOOKUPS} lookups are not legal`), row.text);
}
assert.equal(lookups, LOOKUPS * verdicts.length);
assert(text.includes(`Device: ${name}`), text);

for (const [fault, words] of Object.entries(FAULTS)) {
  const result = await judge(`lookups=${LOOKUPS_OF_FAULTS}&fault=${fault}`);
  const named = result.verdicts.filter(({ reason }) => reason?.options.includes(words));
  const explained = named.reduce((sum, { reason }) => sum + reason.explained, 0);
  console.log(`${fault}: ${explained} of ${result.refused} refused lookups are explained by ${words}`);
  assert(result.refused > 0.1 * result.lookups, `${fault}: ${result.refused} of ${result.lookups} are refused`);
  assert(explained >= 0.8 * result.refused, `${fault}: ${explained} of ${result.refused} are explained`);
  assert(result.text.match(/of them are legal with .*/)?.[0].includes(words), result.text);
}
