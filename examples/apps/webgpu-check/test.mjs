// SPDX-License-Identifier: MIT
// Opens the page in a headless Chromium with a software device, and prints the verdicts:
//
//   node test.mjs CHROMIUM SHD_WASM
//
// Exit code 77: there is no module or no WebGPU.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { openPage } from "../../../bindings/js/tests/browser.mjs";

const ROOT = fileURLToPath(new URL("../../..", import.meta.url));
const PAGE = "/examples/apps/webgpu-check/index.html";
const LOOKUPS = 1000;
const FLAGS = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"];
const [chromium, wasm] = process.argv.slice(2);
const REPORT = `<script type="module">
  while (!window.verdict) await new Promise((resume) => setTimeout(resume, 50));
  const verdict = await window.verdict;
  await fetch("/verdict", { method: "POST", body: JSON.stringify({ ...verdict, text: document.body.innerText }) });
</script>`;

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

/** Files of the repository. The page reports to the server. */
function find(path) {
  const bytes = readFileSync(path === "/bindings/js/lib/shd.wasm" ? wasm : join(ROOT, path));
  return path === PAGE ? bytes.toString().replace("</body>", `${REPORT}</body>`) : bytes;
}

if (!existsSync(wasm)) skip(`there is no ${wasm} (examples/apps/webgpu-check/README.md)`);
const { problem, reason, name, verdicts, refused, lookups, text } = await openPage(chromium, {
  page: `${PAGE}?lookups=${LOOKUPS}`, flags: FLAGS, seconds: 120, find,
});
if (reason) skip(reason);
assert.equal(problem, undefined);
console.log(`device: ${name}`);
for (const row of verdicts) {
  const plan = `${row.format} ${row.size} ${row.wrap} ${row.filter} by ${row.by}`;
  const excess = row.refused ? `, largest excess ${row.worst[0].excess.toPrecision(3)}` : "";
  console.log(`${plan}: ${row.refused} of ${row.lookups} refused${excess}`);
}
console.log(`${refused} of ${lookups} lookups are not legal`);
// The judge itself: libshd is legal, and a bug of half a texel is not.
for (const row of verdicts) {
  const label = `${row.filter}, ${row.wrap}, ${row.format}, by ${row.by}`;
  assert.equal(row.library, 0, label);
  assert(row.shifted > 0.1 * row.lookups, `${label}: ${row.shifted} shifted lookups are refused`);
}
// SwiftShader has places of 16 bits and approximations of levels, so that a few lookups are not legal.
for (const row of verdicts) {
  assert(row.refused <= 0.01 * row.lookups, `${row.filter}: ${row.refused} of ${row.lookups} lookups are refused`);
}
assert.equal(lookups, LOOKUPS * verdicts.length);
assert.equal(verdicts.length, 28);
const sentence = refused ? `${refused} of ${lookups} lookups are not legal.` : `All ${lookups} lookups are legal.`;
assert(text.includes(sentence), text);
assert(text.includes(`Device: ${name}`), text);
