// SPDX-License-Identifier: MIT
// Draws models in a headless Chromium: node scene_page.mjs CHROMIUM [FOLDER]. FOLDER has the package in node_modules; by
// default the page uses the files of this folder and SHD_WASM.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { openPage } from "./browser.mjs";
import { FILES } from "./scene_files.mjs";

const [chromium, folder] = process.argv.slice(2);
if (!folder && !readFileSync(process.env.SHD_WASM).includes("shd_scene_load_memory")) {
  console.log("skipped: the module reads no files");
  process.exit(77);
}
const base = folder ? "/node_modules/shd" : "";
const PAGE = `<!doctype html><title>models</title><script type="module">
const post = (result) => fetch("/result", { method: "POST", body: JSON.stringify(result) });
try {
  const { hashLines } = await import("/tests/scene_hash.mjs");
  const files = {};
  for (const name of ${JSON.stringify(Object.keys(FILES))}) {
    files[name] = await (await fetch("/models/" + encodeURI(name))).arrayBuffer();
  }
  const lines = {};
  for (const name of ["index", "threads"]) {
    const { load } = await import("${base}/lib/" + name + ".js");
    const shd = await load();
    lines[name] = hashLines(shd, new shd.Context(), files);
    shd.close();
  }
  await post({ lines });
} catch (problem) {
  await post({ problem: String(problem.stack ?? problem) });
}
</script>`;

function find(path) {
  if (path === "/scene.html") return PAGE;
  if (path.startsWith("/models/")) return FILES[path.slice("/models/".length)];
  return folder && path.startsWith("/node_modules/") ? readFileSync(join(folder, path)) : undefined;
}

const { lines, problem } = await openPage(chromium, { page: "/scene.html", find });
assert.equal(problem, undefined, problem);
const stored = readFileSync(new URL("scene_hashes.txt", import.meta.url), "utf8").trim().split("\n").slice(1);
assert.deepEqual(lines, { index: stored, threads: stored });
console.log(`Chromium draws ${stored.length} models`);
