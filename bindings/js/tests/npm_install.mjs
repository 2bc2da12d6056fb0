// SPDX-License-Identifier: MIT
// Exit codes of npm_install.sh: registries that cannot be reached, that refuse, and that have no such package.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const SCRIPT = fileURLToPath(new URL("./npm_install.sh", import.meta.url));

/** Exit code and text of npm_install.sh, whose registry is `url`. */
async function install(url) {
  const folder = mkdtempSync(join(tmpdir(), "shd-npm-"));
  const env = { ...process.env, npm_config_registry: url, npm_config_cache: join(folder, "cache"),
                npm_config_fetch_timeout: "1000" };
  const child = spawn(SCRIPT, ["typescript@5"], { cwd: folder, env, stdio: ["ignore", "pipe", "inherit"] });
  let text = "";
  child.stdout.on("data", (part) => { text += part; });
  const [code] = await once(child, "close");
  rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  return { code, text };
}

/** The same for a server that runs `answer`. */
async function installFrom(answer) {
  const server = createServer(answer);
  await once(server.listen(0, "127.0.0.1"), "listening");
  const result = await install(`http://127.0.0.1:${server.address().port}/`);
  server.close(), server.closeAllConnections();
  return result;
}

for (const [name, made, code, text] of [
  ["no server", install("http://127.0.0.1:1/"), 77, /^skipped: .* cannot be reached \(ECONNREFUSED\)\n$/],
  ["no host", install("http://registry.invalid/"), 77, /^skipped: .* cannot be reached \(E(NOTFOUND|AI_AGAIN)\)\n$/],
  ["no answer", installFrom(() => {}), 77, /^skipped: .* cannot be reached \(\w+\)\n$/],
  ["no package", installFrom((_, response) => { response.statusCode = 404; response.end("{}"); }), 1, /code E404/],
  ["forbidden", installFrom((_, response) => { response.statusCode = 403; response.end("{}"); }), 1, /code E403/],
  ["no version", installFrom((_, response) => response.end('{"name":"typescript","versions":{},"dist-tags":{}}')), 1,
   /^npm .*code E/],
]) {
  const result = await made;
  assert.equal(result.code, code, `${name}: ${result.text}`);
  assert.match(result.text, text, name);
}
console.log("a test is skipped only where the registry of npm cannot be reached");
