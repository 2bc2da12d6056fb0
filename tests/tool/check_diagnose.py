#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants bugs in tables of lookups, and checks that shd-check --diagnose names each bug first.

    check_diagnose.py SHD_CHECK LOOKUP_TABLE FOLDER PAGE [COMMAND...]

PAGE is docs/diagnose.md, whose examples are run. COMMAND is another shd-check, which must print the same;
exit code 77: its last word is no file.
LOOKUP_TABLE is a texture unit in doubles that shares no code with the library.
"""
import csv
import json
import pathlib
import random
import re
import struct
import subprocess
import sys

from check_shd_check import npy

ROWS = 200
NEAREST, BILINEAR, NEAREST_MIP, BILINEAR_MIP, TRILINEAR, ANISOTROPIC = 1, 2, 4, 5, 0, 8
FILTERS = {NEAREST: "nearest", BILINEAR: "bilinear", NEAREST_MIP: "nearest-mip", BILINEAR_MIP: "bilinear-mip",
           TRILINEAR: "trilinear", ANISOTROPIC: "anisotropic"}


def decode(x):
    return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4


def encode(x):
    return x * 12.92 if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055


def on_colors(function):
    def change(row):
        for name in "rgb":
            row[name] = function(row[name])
    return change


def reorder(order):
    """The columns r, g, b and a receive the channels of `order`."""
    def change(row):
        row.update(zip("rgba", [row[name] for name in order]))
    return change


def times(names, factor):
    def change(row):
        for name in names:
            row[name] *= factor
    return change


# The unit, the options that the user believes in, the options that name the bug, and a change of the rows.
SRGB = "format=srgb8"
PLANTED = {
    "wrap_clamp": ("wrap_u=1 wrap_v=1", "", "--wrap clamp"),
    "wrap_mirror": ("wrap_u=2 wrap_v=2 filter=0", "", "--wrap mirror"),
    "wrap_one_axis": ("wrap_v=1 filter=8", "", "--wrap repeat,clamp"),
    "border": ("wrap_u=3 wrap_v=3 bug=border", "--wrap border --border 0.6,0.6,0.6,0.6", "--border 0,0,0,0"),
    "half_texel": ("bug=shift a=0.5 b=0.5", "", "--assume half-texel-right-down"),
    "half_texel_left": ("bug=shift a=-0.5 filter=1", "", "--assume half-texel-left"),
    "half_texel_up": ("bug=shift b=-0.5 filter=5", "", "--assume half-texel-up"),
    "half_texel_trilinear": ("bug=shift a=0.5 b=0.5 filter=0", "", "--assume half-texel-right-down"),
    "half_texel_lod": ("bug=shift a=0.5 filter=0 lod=1", "", "--assume half-texel-right"),
    "half_base_texel": ("filter=0", "", "--assume half-base-texel-left", lambda row: row.update(u=row["u"] + 0.5 / 32)),
    "flipped_v": ("bug=mirrored_axis option=1 wrap_v=1", "--wrap repeat,clamp", "--assume flipped-v"),
    "flipped_u": ("bug=mirrored_axis option=0 filter=0", "", "--assume flipped-u"),
    "swapped_uv": ("bug=swapped_axes", "", "--assume swapped-uv"),
    "in_texels": ("", "", "--assume coordinates-in-texels", times("uv", 32)),
    "layers_from_1": ("layers=3 filter=0", "", "--assume previous-layer", lambda row: row.update(layer=row["layer"] + 1)),
    "bgra": ("filter=0", "", "--assume order-bgra", reorder("bgra")),
    "argb": ("filter=0", "", "--assume order-argb", reorder("argb")),
    "codes": ("", "", "--assume results-in-codes", times("rgba", 255)),
    "not_decoded": (SRGB + " bug=no_decode", "--srgb", "--assume srgb-not-decoded"),
    "decoded_late": (SRGB + " bug=filter_first filter=0", "--srgb", "--assume srgb-decoded-late"),
    "decoded_again": (SRGB, "--srgb", "--assume srgb-decoded-again", on_colors(decode)),
    "encoded": (SRGB + " filter=0", "--srgb", "--assume srgb-encoded", on_colors(encode)),
    "decoded_linear": (SRGB, "", "--srgb"),
    "decoded_twice": (SRGB + " filter=1", "--srgb", "--assume srgb-decoded-twice", on_colors(decode)),
    "alpha_decoded": (SRGB + " bug=alpha_decoded", "--srgb", "--assume alpha-decoded"),
    "bias_up": ("bug=level_shift a=1 filter=0", "", "--bias 1"),
    "bias_down": ("bug=level_shift a=-1 filter=0", "", "--bias -1"),
    "no_bias": ("bug=no_bias bias=1.5 filter=0", "--bias 1.5", "--bias 0"),
    "no_clamp": ("bug=no_clamps lod_max=2 filter=0", "--lod-max 2", "--lod-min 0 --lod-max 32"),
    "level_0": ("lod_max=0 filter=8", "", "--lod-min 0 --lod-max 0"),
    "level_doubled": ("bug=level_scale a=2 filter=0", "--rules opengl", "--assume level-doubled"),
    "level_halved": ("bug=level_scale a=0.5 filter=0 lod=1", "", "--assume level-halved"),
    "natural_log": ("bug=level_scale a=0.693147 filter=0", "--rules d3d11", "--assume level-natural-log"),
    "one_step": ("bug=one_step option=0 filter=0", "", "--assume no-derivatives-in-x"),
    "shorter_axis": ("bug=shorter_axis filter=0", "", "--assume shorter-axis"),
    "one_size": ("bug=one_size option=0 filter=0 width=64 height=16", "", "--assume width-for-both"),
    "derivatives_in_texels": ("filter=0", "", "--assume derivatives-in-texels",
                              times(["dudx", "dvdx", "dudy", "dvdy"], 32)),
    "transposed": ("filter=8", "--rules d3d11", "--assume transposed-derivatives",
                   lambda row: row.update(dvdx=row["dudy"], dudy=row["dvdx"])),
    "anisotropic": ("filter=8", "--filter trilinear --rules d3d11", "--filter anisotropic"),
    "more_anisotropic": ("filter=8 max_anisotropy=8", "--max-anisotropy 2", "--max-anisotropy 8"),
    "nearest": ("filter=1", "--filter bilinear", "--filter nearest"),
    "mip_nearest": ("filter=5", "--filter trilinear", "--filter bilinear-mip"),
    "no_mip": ("filter=2", "--filter trilinear", "--filter bilinear"),
    # Rounding to the nearest of 3 bits is within the two neighbours of 4 bits, and three roundings of 8 bits are as far
    # as one of 7 bits.
    "few_bits": ("bug=few_bits option=3", "--subtexel-bits 8 --weight-bits 12", "--subtexel-bits 4"),
    "weight_bits": ("weight_bits=8 subtexel_bits=16", "--rules d3d11 --subtexel-bits 12 --weight-bits 16 --result-bits 24",
                    "--weight-bits 7"),
    "result_bits": ("result_bits=7 subtexel_bits=16", "--rules d3d11", "--result-bits 7"),
    "cube_flipped": ("cube=1 filter=0", "--cube", "--assume flipped-w",
                     lambda row: row.update(w=-row["w"], dwdx=-row["dwdx"], dwdy=-row["dwdy"])),
    "cube_swapped": ("cube=1", "--cube", "--assume swapped-vw", lambda row: row.update(v=row["w"], w=row["v"],
                     dvdx=row["dwdx"], dwdx=row["dvdx"], dvdy=row["dwdy"], dwdy=row["dvdy"])),
    "cube_bias": ("cube=1 filter=0 bug=level_shift a=1 lod=1", "--cube", "--bias 1", lambda row: row.pop("dwdx")),
    "two": ("wrap_u=1 wrap_v=1 filter=0", "", "--wrap clamp --assume order-bgra", reorder("bgra")),
    "two_named": ("bug=shift a=0.5 b=0.5 filter=5", "", "--assume order-bgra,half-texel-right-down", reorder("bgra")),
    "two_options": ("bug=level_shift a=1 filter=0 wrap_u=1 wrap_v=1", "", "--wrap clamp --bias 1"),
}


class Bench:
    def __init__(self, program, table, folder, other):
        self.programs, self.table, self.folder = [[program]] + ([other] if other else []), table, folder
        self.failures, self.count = 0, 0

    def make(self, name, unit, change=None, rows=ROWS):
        """The folder of a table, and the arguments that name its files."""
        folder = self.folder / name
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        subprocess.run([self.table, folder, f"rows={rows}", *unit.split()], check=True, timeout=60)
        path = folder / "lookups.csv"
        if change:
            table = [{key: float(text) for key, text in row.items()} for row in csv.DictReader(path.open())]
            for row in table:
                change(row)
            write(path, table)
        levels = sorted(folder.glob("level*.npy"), key=lambda level: int(level.stem[5:]))
        filter_ = int(dict(word.split("=") for word in unit.split()).get("filter", BILINEAR))
        return ["--filter", FILTERS[filter_], *[word for level in levels[1:] for word in ("--level", level)],
                levels[0], path]

    def run(self, arguments):
        results = []
        for program in self.programs:
            done = subprocess.run([*program, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True,
                                  timeout=120, check=False)
            results.append((done.returncode, done.stdout + done.stderr))
        if results[0] != results[-1]:
            self.failures += 1
            print(f"{arguments}: exit {results[0][0]} and {results[-1][0]}:\n{results[0][1]}and:\n{results[-1][1]}")
        return results[0]

    def expect(self, name, arguments, code, *texts):
        self.count += 1
        returned, output = self.run(arguments)
        if returned != code or any(text not in output for text in texts):
            self.failures += 1
            print(f"{name}: exit {returned} instead of {code}, expected {texts}, got:\n{output[:3000]}")
        return output


def write(path, table):
    names = list(table[0]) if table else ["u", "v", "layer", "r"]
    path.write_text("\n".join([",".join(names), *(",".join(repr(row[n]) for n in names) for row in table)]) + "\n")


def first_finding(output):
    """The line after "diagnosis by"."""
    lines = output.splitlines()
    at = [i for i, line in enumerate(lines) if line.startswith("diagnosis by")]
    return lines[at[0] + 1].strip() if at else output


def check_planted(bench):
    for name, (unit, options, wanted, *change) in PLANTED.items():
        files = bench.make(name, unit, *change)
        # The last --filter counts.
        arguments = [*files[:2], *options.split(), *files[2:]]
        output = bench.expect(name, ["--diagnose", "--list", "0", *arguments], 1, f"of {ROWS} lookups are not legal")
        found = first_finding(output)
        if found != f"legal in {ROWS} of {ROWS} with {wanted}":
            bench.failures += 1
            print(f"{name}: wanted {wanted}, found:\n{output[:3000]}")
        # The options of each finding make as many rows legal as its line has.
        for legal, named in re.findall(rf"legal in (\d+) of {ROWS} with (.+)", output):
            again = ["--list", "0", *arguments[:-2], *named.split(), *arguments[-2:]]
            refused = ROWS - int(legal)
            said = bench.expect(f"{name} again", again, int(refused > 0), "lookups are not legal")
            if not said.startswith(f"{refused} of {ROWS} lookups"):
                bench.failures += 1
                print(f"{name}: {named} was to refuse {refused}: {said}")


def check_right(bench):
    for filter_ in FILTERS:
        files = bench.make("right", f"filter={filter_}")
        bench.expect("right", ["--diagnose", *files], 0, f"0 of {ROWS} lookups", "diagnosis: nothing to explain")


def check_garbage(bench):
    numbers = random.Random(7)
    for filter_ in (BILINEAR, TRILINEAR, ANISOTROPIC):
        files = bench.make("garbage", f"filter={filter_}",
                           lambda row: row.update({name: numbers.random() for name in "rgba"}))
        output = bench.expect("garbage", ["--diagnose", "--list", "0", *files], 1, "diagnosis: none of ",
                              "hypotheses and their pairs explains half of the ", " refused lookups")
        assert "diagnosis by" not in output and "with --" not in output


def check_formats(bench):
    """Comparisons, and texels that are no codes. Nearest lookups of the centres of 8 x 8 texels."""
    numbers = random.Random(3)
    centres = [(numbers.randrange(8), numbers.randrange(8)) for _ in range(ROWS)]
    image, table = bench.folder / "texels.npy", bench.folder / "texels.csv"
    arguments = ["--filter", "nearest", "--diagnose", "--list", "0", image, table]
    codes = [numbers.randrange(256) for _ in range(64)]
    npy(image, "'|u1'", "(8, 8)", bytes(codes))
    references = [numbers.random() for _ in centres]
    write(table, [{"u": (x + 0.5) / 8, "v": (y + 0.5) / 8, "reference": z, "r": float(z >= codes[8 * y + x] / 255)}
                  for (x, y), z in zip(centres, references)])
    bench.expect("comparison", ["--compare", "less", *arguments], 1,
                 f"legal in {ROWS} of {ROWS} with --compare greater-equal\n")
    for type_ in "ef":
        data = struct.pack(f"<192{type_}", *(numbers.random() for _ in range(192)))
        texels = struct.unpack(f"<192{type_}", data)
        npy(image, f"'<f{len(data) // 192}'", "(8, 8, 3)", data)
        write(table, [{"u": (x + 0.5) / 8, "v": (y + 0.5) / 8,
                       **{name: decode(texels[3 * (8 * y + x) + c]) for name, c in zip("rgb", (2, 1, 0))}}
                      for x, y in centres])
        bench.expect(f"floats {type_}", arguments, 1,
                     f"legal in {ROWS} of {ROWS} with --assume order-bgr,srgb-decoded-again\n")


def check_edges(bench):
    files = bench.make("edges", "wrap_u=1 wrap_v=1 bug=none", rows=64)
    path = files[-1]
    table = [{key: float(text) for key, text in row.items()} for row in csv.DictReader(path.open())]
    bad = bench.run(["--report", bench.folder / "all.json", *files])
    assert bad[0] == 1
    worst = json.loads((bench.folder / "all.json").read_text())["refusals"][0]
    write(path, [])
    bench.expect("no rows", ["--diagnose", *files], 0, "0 of 0 lookups are not legal\n", "nothing to explain")
    for name in ("half-texel-left", "results-in-codes"):
        bench.expect("no rows", ["--assume", name, *files], 0, "0 of 0 lookups are not legal\n")
    write(path, [table[worst["row"]]])
    bench.expect("one row", ["--diagnose", *files], 1, "1 of 1 lookups are not legal", "legal in 1 of 1 with ",
                 "explain all lookups; they differ in other lookups only")
    table[3]["g"] = float("nan")
    table[4]["r"] = float("inf")
    write(path, table)
    bench.expect("not finite", ["--diagnose", *files], 1, "row 3: g = nan", "inf away",
                 "diagnosis: 2 results are NaN or infinite, and no hypothesis is about them",
                 "legal in 62 of 62 with --wrap clamp\n")
    write(path, [dict(table[3]), dict(table[4])])
    output = bench.expect("none finite", ["--diagnose", *files], 1, "2 of 2 lookups are not legal",
                          "diagnosis: 2 results are NaN")
    assert "hypotheses" not in output
    for row in table[:5]:
        row.update(u=float("nan"), v=float("inf"), dudx=float("nan"))
    write(path, table)
    bench.expect("NaN lookups", ["--diagnose", *files], 1, "diagnosis")

    # A part of the rows has another reason, so that the best hypothesis does not explain all.
    files = bench.make("part", "wrap_u=1 wrap_v=1")
    table = [{key: float(text) for key, text in row.items()} for row in csv.DictReader(files[-1].open())]
    for row in table[:7]:
        row["r"] = 3.0
    write(files[-1], table)
    bench.expect("part", ["--diagnose", *files], 1, "legal in 193 of 200 with --wrap clamp\n",
                 "none of them explains all lookups")
    # More rows than the diagnosis samples.
    files = bench.make("many", "wrap_u=1 wrap_v=1", rows=20000)
    bench.expect("many", ["--diagnose", "--list", "0", *files], 1, "legal in 20000 of 20000 with --wrap clamp\n")


def check_reports(bench):
    files = bench.make("report", "bug=shift a=0.5 b=0.5 filter=0")
    output = bench.expect("order", ["--list", "200", *files], 1, "    lookup: u ", " dudx ", " layer 0")
    away = [float(line.split(", ")[-1].split()[0]) for line in output.splitlines() if line.startswith("row ")]
    assert away == sorted(away, reverse=True) and len(away) > 100, away
    assert f"the farthest is {away[0]:.3g} outside" in output, output[-300:]
    paths = {kind: bench.folder / f"report.{kind}" for kind in ("csv", "json")}
    for path in paths.values():
        bench.expect("report", ["--diagnose", "--list", "0", "--report", path, *files], 1)
    rows = list(csv.DictReader(paths["csv"].open()))
    refused = [row for row in rows if row["legal"] == "0"]
    for row in rows:
        outside = any(not float(row[c + "_low"]) <= float(row[c]) <= float(row[c + "_high"]) for c in "rgba")
        assert outside == (row["legal"] == "0") == (max(float(row[c + "_excess"]) for c in "rgba") > 0), row
    document = json.loads(paths["json"].read_text())
    assert len(rows) == ROWS == document["lookups"] and len(refused) == document["refused"] == len(away)
    assert {row["row"] for row in document["refusals"]} == {int(row["row"]) for row in refused}
    first = document["diagnosis"][0]
    assert first["options"] == "--assume half-texel-right-down" and first["legal"] == ROWS, first
    assert first["explained"] == len(away)
    table = [{key: float(text) for key, text in row.items()} for row in csv.DictReader(files[-1].open())]
    table[5]["r"] = float("nan")
    write(files[-1], table)
    bench.expect("nan in JSON", ["--report", paths["json"], "--list", "0", *files], 1)
    assert json.loads(paths["json"].read_text())["refusals"][0]["r"] == "nan"

    bench.expect("report name", ["--report", "a.txt", *files], 2, "--report: \"a.txt\" is not the name of a file that ends")
    bench.expect("report folder", ["--report", bench.folder / "absent" / "a.csv", *files], 4, "cannot be written")
    bench.expect("assume", ["--assume", "flipped-w", *files], 2, "--assume: \"flipped-w\" is not one of ", "flipped-v")
    bench.expect("assume near", ["--assume", "half-texel-rigth", *files], 2, "did you mean half-texel-right?")


def check_page(bench, page):
    """Runs each command of the page, a line that begins with "$ ", and compares the lines that follow it."""
    commands = 0
    for block in page.read_text().split("```")[1::2]:
        for part in ("\n" + block).split("\n$ ")[1:]:
            command, _, wanted = part.replace("\\\n", " ").partition("\n")
            words = command.split()
            output = ""
            if words[0] == "lookup_table":
                subprocess.run([bench.table, *words[1:]], cwd=bench.folder, check=True, timeout=60)
            else:
                output = bench.run(words[1:])[1]
            commands += 1
            if output.strip() != wanted.strip():
                bench.failures += 1
                print(f"{page.name}: {command} prints:\n{output}")
    assert commands >= 6, commands


def main():
    other = sys.argv[5:]
    if other and not pathlib.Path(other[-1]).exists():
        print(f"skipped: there is no {other[-1]} (examples/apps/webgpu-check/README.md)")
        return 77
    bench = Bench(*map(lambda path: pathlib.Path(path).resolve(), sys.argv[1:4]), other)
    bench.folder.mkdir(parents=True, exist_ok=True)
    check_planted(bench)
    check_right(bench)
    check_garbage(bench)
    check_formats(bench)
    check_edges(bench)
    check_reports(bench)
    check_page(bench, pathlib.Path(sys.argv[4]))
    print(f"{bench.count} calls, {len(PLANTED)} planted bugs, {bench.failures} failures")
    return bench.failures != 0


if __name__ == "__main__":
    sys.exit(main())
