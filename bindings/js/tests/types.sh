#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles programs with the declarations of a package: types.sh [package]; default: this folder. The programs of
# README.md and docs/bindings.md and example.ts have no error, and wrong.ts has those that its comments name. TypeScript
# 5 and three.js are taken from the registry of npm to $WORK/types; exit code 77: it cannot be reached.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
package=$(cd "${1:-$here/..}" && pwd)
mkdir -p "$WORK/types"
cd "$WORK/types"
"$here/npm_install.sh" typescript@5 three @types/three
rm -rf node_modules/shd programs wrong
ln -s "$package" node_modules/shd
mkdir programs wrong
"$NODE" "$here/readme.mjs" "$package/README.md" programs
"$NODE" "$here/readme.mjs" "$here/../../../docs/bindings.md" programs
cp "$here/readme.d.ts" programs
cp "$here/example.ts" programs/example.mts
cp "$here/wrong.ts" wrong/wrong.mts
# "types": only packages that a program names are read.
for folder in programs wrong; do
  cat >"$folder/tsconfig.json" <<'JSON'
{"compilerOptions": {"strict": true, "noEmit": true, "allowJs": true, "checkJs": true, "target": "esnext",
                     "module": "nodenext", "moduleResolution": "nodenext", "types": []}}
JSON
done
for lib in esnext es2022; do
  npx tsc --pretty false --project programs --lib "$lib,dom,dom.iterable"
done
npx tsc --pretty false --project wrong --lib es2022,dom >errors.txt && { echo "wrong.ts compiles"; exit 1; }
# "line code" of each error, and of each line that names one
sed -n 's/^wrong\/wrong\.mts(\([0-9]*\),.*error \(TS[0-9]*\):.*/\1 \2/p' errors.txt >found.txt
grep -n '// TS[0-9]*$' wrong/wrong.mts | sed 's/:.* / /' >wanted.txt
diff wanted.txt found.txt || { cat errors.txt; exit 1; }
echo "$(ls programs/*.m* | wc -l) programs compile, and $(wc -l <wanted.txt) wrong lines do not"
