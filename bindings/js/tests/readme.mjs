// SPDX-License-Identifier: MIT
// Writes the programs of a page: node readme.mjs README.md FOLDER. Program i is FOLDER/README.<i>.mjs.
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The blocks of JavaScript in a text of Markdown. */
export const programsOf = (text) => [...text.matchAll(/^```js\n(.*?)^```$/gms)].map(([, program]) => program);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [page, folder] = process.argv.slice(2);
  const programs = programsOf(readFileSync(page, "utf8"));
  programs.forEach((program, i) => writeFileSync(join(folder, `${basename(page, ".md")}.${i + 1}.mjs`), program));
  if (!programs.length) throw new Error(`${page} has no program`);
}
