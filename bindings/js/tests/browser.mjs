// SPDX-License-Identifier: MIT
// Serves the package to a headless Chromium, whose page posts its results: node browser.mjs CHROMIUM. Other tests take
// the server, and the page that posts one result.
import { createServer } from "node:http";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const TYPES = { html: "text/html", js: "text/javascript", mjs: "text/javascript", css: "text/css",
                wasm: "application/wasm", svg: "image/svg+xml", png: "image/png" };
const BUILT = { "/lib/shd.wasm": process.env.SHD_WASM, "/lib/shd-threads.wasm": process.env.SHD_WASM_THREADS,
                "/figures/shd-figures.wasm": process.env.SHD_WASM_FIGURES };

const PAGE = `<!doctype html><title>shd</title><script type="module">
const post = (result) => fetch("/result", { method: "POST", body: JSON.stringify(result) });
try {
  const { load } = await import("/lib/index.js");
  const { runPrograms, runSpeed } = await import("/examples/programs.mjs");
  const { renderFloor } = await import("/bench/floor.mjs");
  const { Pool } = await import("/lib/pool.js");
  const { HEIGHT, makeScene } = await import("/tests/pool_scene.mjs");
  const shd = await load();
  const whole = makeScene(shd)([0, HEIGHT]);
  for (const count of [1, 3]) {
    const pool = new Pool(() => new Worker("/tests/pool_worker.mjs", { type: "module" }), { count });
    for (let frame = 0; frame < 2; ++frame) {
      const bytes = (await pool.bands(HEIGHT, "draw")).flatMap(({ value }) => [...value]);
      if (bytes.length !== whole.length || whole.some((byte, i) => byte !== bytes[i])) {
        throw new Error(\`\${count} workers draw other pixels\`);
      }
    }
    await pool.call("refuse").then(() => { throw new Error("no error"); }, (problem) => {
      if (problem.result !== "invalid_argument") throw problem;
    });
    pool.close();
  }
  const threads = await import("/lib/threads.js");
  if (!threads.hasThreads()) throw new Error("the page cannot share memory");
  const shared = await threads.load({ threads: 3 });
  const lines = runPrograms(shd).lines;
  if (runPrograms(shared).lines.join() !== lines.join()) throw new Error("threads have other hashes");
  if (new shared.Context().workerCount !== 3) throw new Error("no threads");
  const drawn = makeScene(shared)([0, HEIGHT]);
  if (whole.some((byte, i) => byte !== drawn[i])) throw new Error("threads draw other pixels");
  shared.close();
  await post({ lines, times: [...runSpeed(shd), renderFloor(shd)] });
} catch (problem) {
  await post({ problem: String(problem.stack ?? problem) });
}
</script>`;

/** A server of the package's files at a free port. `onResult` gets what a page posts; `find` may know other files. */
export function serve(onResult = () => {}, find = () => undefined) {
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(request.url.split("?")[0])).replace(/^(\.\.[/\\])+/, "");
    if (request.method === "POST") {
      let body = "";
      request.on("data", (part) => { body += part; });
      request.on("end", () => { response.end(); onResult(JSON.parse(body)); });
      return;
    }
    try {
      const bytes = path === "/" ? PAGE : find(path) ?? readFileSync(BUILT[path] ?? join(ROOT, path));
      // With these headers a page may share memory with its workers.
      response.setHeader("cross-origin-opener-policy", "same-origin");
      response.setHeader("cross-origin-embedder-policy", "require-corp");
      response.setHeader("content-type", path === "/" ? "text/html" : TYPES[path.split(".").pop()] ?? "text/plain");
      response.end(bytes);
    } catch {
      response.statusCode = 404;
      response.end();
    }
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

const FLAGS = ["--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking",
               "--disable-component-update", "--disable-dev-shm-usage", "--disable-quic", "--disable-sync"];

/**
 * Opens a page of serve() in Chromium with more flags. Returns what the page posts, or a `problem` if it posts nothing.
 */
export async function openPage(chromium, { page = "/", flags = ["--disable-gpu"], seconds = 60, find } = {}) {
  let receive;
  const result = new Promise((resolve) => { receive = resolve; });
  const server = await serve((posted) => receive(posted), find);
  const folder = mkdtempSync(join(tmpdir(), "shd-browser-"));
  const url = `http://127.0.0.1:${server.address().port}${page}`;
  // The command is a script that starts processes: all of them are one group.
  const child = spawn(chromium, [...FLAGS, ...flags, `--user-data-dir=${folder}`, url],
                      { detached: true, stdio: "ignore" });
  child.on("error", (problem) => receive({ problem: String(problem) }));
  const timer = setTimeout(() => receive({ problem: `no result within ${seconds} seconds` }), 1000 * seconds);
  try {
    return await result;
  } finally {
    clearTimeout(timer);
    try { process.kill(-child.pid, "SIGKILL"); } catch { /* it has ended */ }
    server.close(), server.closeAllConnections();
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

async function main(chromium) {
  const result = await openPage(chromium);
  if (result.problem) {
    console.error(result.problem);
    process.exit(1);
  }
  for (const line of result.times) console.error(line);
  console.log(result.lines.join("\n"));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main(process.argv[2] ?? "chromium");
