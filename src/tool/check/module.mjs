// SPDX-License-Identifier: MIT
// The end of shd-check.mjs. In front of it is Emscripten's function Module, which makes an instance of the program.

const inNode = typeof process === "object" && Boolean(process.versions?.node);
let compiled;

async function compile() {
  const address = new URL("shd-check.wasm", import.meta.url);
  if (!inNode) return WebAssembly.compile(await (await fetch(address)).arrayBuffer());
  return WebAssembly.compile((await import("node:fs")).readFileSync(address));
}

/**
 * Runs shd-check with the words of its command line. `files` has the bytes or the text of each file by its path, or null
 * for a folder. Returns the exit code, what the program prints to its two streams, and `read`, which returns the text of
 * a file.
 */
export async function shdCheck(words, files) {
  const program = await (compiled ??= compile());
  const streams = { output: "", errors: "" };
  const { FS, callMain } = await Module({
    print: (line) => { streams.output += `${line}\n`; },
    printErr: (line) => { streams.errors += `${line}\n`; },
    instantiateWasm: (imports, receive) => { WebAssembly.instantiate(program, imports).then(receive); return {}; },
  });
  for (const [path, content] of Object.entries(files)) {
    const folder = content === null ? path : path.slice(0, path.lastIndexOf("/") + 1);
    if (!FS.analyzePath(folder).exists) FS.mkdirTree(folder);
    if (content !== null) FS.writeFile(path, content);
  }
  const code = callMain(words);
  return { code, ...streams, read: (path) => FS.readFile(path, { encoding: "utf8" }) };
}

/** The program for Node. Files that the command line names are read before it, and the report is written after it. */
async function main(words) {
  const { existsSync, readFileSync, statSync, writeFileSync } = await import("node:fs");
  const { dirname } = await import("node:path");
  const files = {};
  const values = words.map((word) => word.replace(/^--[a-z-]+=/, ""));
  for (const path of values) {
    const status = path && statSync(path, { throwIfNoEntry: false });
    if (status) files[path] = status.isFile() ? readFileSync(path) : null;
  }
  const report = values[words.findIndex((word, i) => word.startsWith("--report=") || words[i - 1] === "--report")];
  if (report && existsSync(dirname(report))) files[report] = "";
  const { code, output, errors, read } = await shdCheck(words, files);
  if (report in files && read(report)) writeFileSync(report, read(report));
  process.stdout.write(output);
  process.stderr.write(errors);
  process.exitCode = code;
}

if (inNode && process.argv[1]) {
  const { realpathSync } = await import("node:fs");
  const { pathToFileURL } = await import("node:url");
  if (pathToFileURL(realpathSync(process.argv[1])).href === import.meta.url) await main(process.argv.slice(2));
}
