// SPDX-License-Identifier: MIT
// Opens the page in a headless Chromium with a software device, and prints the verdicts:
//
//   node test.mjs CHROMIUM SHD_WASM
//
// Exit code 77: there is no module or no WebGPU.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../..", import.meta.url));
const PAGE = "/examples/apps/webgpu-check/index.html";
const TYPES = { html: "text/html", js: "text/javascript", css: "text/css", wasm: "application/wasm" };
const LOOKUPS = 1000;
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

/** The repository at a free port. The page reports to it. */
function serve(onVerdict) {
  const server = createServer((request, response) => {
    if (request.method === "POST") {
      let body = "";
      request.on("data", (part) => { body += part; });
      request.on("end", () => { response.end(); onVerdict(JSON.parse(body)); });
      return;
    }
    const path = normalize(decodeURIComponent(request.url.split("?")[0])).replace(/^(\.\.[/\\])+/, "");
    try {
      const bytes = readFileSync(path === "/bindings/js/lib/shd.wasm" ? wasm : join(ROOT, path));
      response.setHeader("content-type", TYPES[path.split(".").pop()] ?? "text/plain");
      response.end(path === PAGE ? bytes.toString().replace("</body>", `${REPORT}</body>`) : bytes);
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

async function openPage() {
  const folder = mkdtempSync(join(tmpdir(), "shd-webgpu-"));
  let receive;
  const result = new Promise((resolve) => { receive = resolve; });
  const server = await serve((verdict) => receive(verdict));
  const flags = ["--headless", "--no-sandbox", "--no-first-run", "--disable-quic", "--disable-background-networking",
                 "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--enable-unsafe-webgpu",
                 "--use-webgpu-adapter=swiftshader", `--user-data-dir=${folder}`];
  const url = `http://127.0.0.1:${server.address().port}${PAGE}?lookups=${LOOKUPS}`;
  // The command is a script that starts processes: all of them are one group.
  const child = spawn(chromium, [...flags, url], { detached: true, stdio: "ignore" });
  child.on("error", (problem) => receive({ problem: String(problem) }));
  const timer = setTimeout(() => receive({ problem: "no verdict within 120 seconds" }), 120000);
  const verdict = await result;
  clearTimeout(timer);
  try { process.kill(-child.pid, "SIGKILL"); } catch { /* it has ended */ }
  server.close(), server.closeAllConnections();
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  return verdict;
}

if (!existsSync(wasm)) skip(`there is no ${wasm} (examples/apps/webgpu-check/README.md)`);
const { problem, reason, name, verdicts, refused, lookups, text } = await openPage();
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
