#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The quick report is whole, figures have names, and bad options are refused.
# Usage: check_quick.sh SHD_SHOOTOUT FOLDER
set -euo pipefail
program=$1 folder=$2
mkdir -p "$folder"

"$program" --quick -o "$folder"
python3 - "$folder" <<'PYTHON'
import csv, json, math, pathlib, sys
folder = pathlib.Path(sys.argv[1])
report = json.loads((folder / "shootout.json").read_text())
page = (folder / "shootout.html").read_text()
lines = list(csv.DictReader((folder / "shootout.csv").open()))
counts = [len(report[key]) for key in ("workloads", "textures", "settings")]
assert len(report["rows"]) == len(lines) == math.prod(counts), (len(report["rows"]), len(lines), counts)
assert "http://" not in page.replace("http://www.w3.org/2000/svg", "") and "https://" not in page, "the page needs a network"
assert len(page) < 15e6, len(page)
psnr = {(line["workload"], line["texture"], line["setting"]): float(line["psnr_db"]) for line in lines}
floor = {name: psnr["floor", "checker", name] for name in ("nearest", "trilinear", "anisotropic_16", "exact")}
assert list(floor.values()) == sorted(floor.values()), floor
for texels in (8, 12, 16, 24, 32):
    most = [float(line["most_texels"]) for line in lines if line["setting"] == f"one_level_{texels}"]
    assert max(most) <= texels, (texels, max(most))
register = [psnr["one_to_one", "text", name] for name in ("nearest", "bilinear", "bicubic")]
assert max(register) - min(register) < 0.01, f"texels in register are not reproduced: {register}"
verdicts = json.loads((folder / "verdicts.json").read_text())
for row in verdicts["rows"]:
    assert sum(row["explained"]) + row["unexplained"] == row["refused"] <= row["judged"], row
    assert verdicts["families"][row["i"]] != "shd" or row["refused"] == 0, row
for peer in ("OpenImageIO", "llvmpipe", "lavapipe"):
    assert peer in verdicts["families"] or peer in " ".join(verdicts["missing"]), f"{peer} is silently absent"
print(len(lines), "pictures; PSNR of the floor:", floor)
PYTHON

"$program" --figure overblur -o "$folder"
[ "$(head -c 4 "$folder/overblur.png" | tail -c 3)" = PNG ]

# Without a device of Vulkan, lavapipe is named as missing and has no rows.
without=$(VK_DRIVER_FILES=/no/driver VK_ICD_FILENAMES=/no/driver "$program" --list)
[[ $without == *"missing peer: lavapipe"* ]] || { echo "lavapipe is not named as missing"; exit 1; }
[[ $without != *lavapipe_trilinear* ]] || { echo "lavapipe has rows without a device"; exit 1; }

# refused TEXT OPTION...: the program fails, and its message has the text
refused() {
  local text=$1 message
  shift
  if message=$("$program" "$@" 2>&1); then echo "accepted: $*"; exit 1; fi
  [[ $message == *"$text"* ]] || { echo "no \"$text\" in: $message"; exit 1; }
}
refused "--no-such is not an option" --no-such
refused "--figure: \"best\" is not one of all, " --figure best
refused "--verdicts: \"10\" is not a whole number 1000..1e9" --verdicts 10
refused "--verdicts needs a value" --verdicts
refused "--threads: \"0\" is not a whole number 1..256" --threads 0
refused "--threads: \"2x\" is not a whole number 1..256" --threads 2x
refused "--photograph: \"/no/file\" is not a file" --photograph /no/file
refused "--output needs a value: the name of a file" -o
echo "shootout: all checks passed"
