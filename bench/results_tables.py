#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of README.md and docs/ from the results that bench/results/ keeps.

    results_tables.py [--check] [--root DIR] [--use SLUG]

A table lies between the marks <!-- NAME:begin SLUG --> and <!-- NAME:end -->. NAME is a table below, SLUG a folder of
bench/results; the table `processors` takes several. --use changes the folder in all other marks. --check writes nothing,
prints what differs and exits 1 then.
"""
import argparse
import json
import pathlib
import re
import sys

MARKED = re.compile(r"(<!-- (?P<name>[\w-]+):begin )(?P<slugs>[\w-]+(?: [\w-]+)*)( -->\n)(?P<text>.*?)(<!-- (?P=name):end -->)", re.S)
MARK = re.compile(r"<!-- [\w-]+:(?:begin|end)\b")
OTHER_TARGETS = {"SCALAR", "EMU128"}
SHORT_LIST = ("nearest", "bilinear_mip", "trilinear", "ripmap", "summed_area_oriented", "ewa_16", "one_level_8",
              "one_level_16", "anisotropic_16", "exact")
SHORT_PEERS = ("_trilinear", "_anisotropic_16")
FRAMES = (  # title, row of llvmpipe and of float planes, row of RGBA8
    ("8 spheres, 2 k triangles: trilinear texture, two point lights, Blinn-Phong per fragment", "spheres/2k", "rgba8/2k"),
    ("64 spheres, 100 k triangles, the same", "spheres/100k", "rgba8/100k"),
    ("1,000 spheres, 1 M triangles, the same", "spheres/1M", "rgba8/1M"),
    ("one textured quadrilateral, trilinear, unlit", "quad/trilinear", "quad/trilinear_rgba8"),
    ("the quadrilateral with SHD_PRECISION_FAST", None, "quad/trilinear_fast_rgba8"),
    ("perspective floor, trilinear, unlit", "floor/trilinear", "floor/trilinear_rgba8"),
    ("the trilinear floor with SHD_PRECISION_FAST", None, "floor/trilinear_fast_rgba8"),
    ("perspective floor, anisotropic 16, unlit", "floor/anisotropic", "floor/anisotropic_rgba8"),
    ("the anisotropic floor with SHD_PRECISION_FAST", None, "floor/anisotropic_fast_rgba8"),
)
PEERS = (("llvmpipe", "llvmpipe"), ("openimageio", "OpenImageIO"))
PROCESSOR_ROWS = (  # title, row of shd for each target, row of each peer
    ("frame: 8 spheres, 2 k triangles, texture, 2 lights", "frame/rgba8/2k/{}", "frame/spheres/2k/{}"),
    ("frame: 1,000 spheres, 1 M triangles, the same", "frame/rgba8/1M/{}", "frame/spheres/1M/{}"),
    ("frame: floor, trilinear", "frame/floor/trilinear_rgba8/{}", "frame/floor/trilinear/{}"),
    ("frame: floor, anisotropic 16", "frame/floor/anisotropic_rgba8/{}", "frame/floor/anisotropic/{}"),
    *((f"lookups: {title}", *2 * (f"texture/{row}/rgba8/{{}}/floor/edge:2048",)) for title, row in
      (("nearest", "nearest"), ("trilinear", "trilinear"), ("anisotropic 16", "anisotropic"))),
)
LOOKUPS = (("nearest", "nearest"), ("bilinear", "bilinear"), ("trilinear", "trilinear"),
           ("anisotropic 16", "anisotropic"), ("EWA 16, peers anisotropic", "ewa"))
SHADOWS = (("`HARD`", "the nearest texel", "hard"), ("`PCF`, 3 x 3", "16 texels, smooth", "pcf_3x3"),
           ("`PCF`, 7 x 7", "64 texels", "pcf_7x7"), ("`VARIANCE`", "any blur, four texels", "variance"),
           ("`SUMMED_AREA_VARIANCE`", "a box of any size", "summed_area_variance"),
           ("`PCSS`, 7 x 7", "245 texels", "pcss_7x7"))


class Results:
    """The files of one processor."""

    def __init__(self, folder):
        self.bench = json.loads((folder / "bench.json").read_text(encoding="utf-8"))
        report = folder / "shootout.json"  # absent for machines that only shd-bench ran on
        self.shootout = json.loads(report.read_text(encoding="utf-8")) if report.exists() else {}
        self.targets = [name for name in self.bench["context"]["simd"].split() if name not in OTHER_TARGETS]

    def value(self, name, key):
        return self.bench["rows"].get(name, {}).get(key)

    def ms(self, name):
        return self.value(name, "ms")

    def rate(self, name, unit=1e6):
        items = self.value(name, "items_per_second")
        return None if items is None else items / unit


def number(value, digits=3):
    """`digits` significant digits, as a person writes them."""
    if value is None:
        return ""
    if value == 0:
        return "0"
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e" in text or abs(value) >= 10 ** (digits - 1) else text


def table(heads, rows):
    yield "| " + " | ".join(heads) + " |"
    yield "|---" * len(heads) + "|"
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def ratio(results, name, other):
    time, reference = results.ms(name), results.ms(other)
    return None if time is None or reference is None else reference / time


def frames_table(results):
    def rows():
        for title, planes, bytes_ in FRAMES:
            base = planes or bytes_.replace("_fast_rgba8", "")
            peer = f"frame/{base}/llvmpipe"
            cells = [", ".join(f"{value:.1f}" for target in results.targets
                               if (value := ratio(results, f"frame/{name}/{target}", peer)) is not None) if name else ""
                     for name in (bytes_, planes)]
            yield title, number(results.ms(peer), 2) + " ms" if planes else "", *cells
    return table(["frame, 1024 x 1024", "llvmpipe", "RGBA8", "float planes"], rows())


def processors_table(*processors):
    """Milliseconds of frames and of as many lookups as a frame has pixels. Cells of shd have a time for each SIMD target,
    bold where it is longer than that of the fastest peer. The last line has the versions of the compiler and the peers."""
    def cells(results, own, peers):
        times = [results.ms(peer) for peer in peers]
        least = min((time for time in times if time is not None), default=float("inf"))
        texts = ((number(time), time > least) for target in results.targets
                 if (time := results.ms(own.format(target))) is not None)
        yield ", ".join(f"**{text}**" if is_slower else text for text, is_slower in texts)
        yield from (number(time) for time in times)

    def rows():
        for title, own, peer in PROCESSOR_ROWS:
            peers = [peer.format(who) for who, _ in PEERS]
            yield title, *(cell for results in processors for cell in cells(results, own, peers))
    names = [re.sub(r"\(R\)| Processor", "", results.bench["context"]["cpu"]) for results in processors]
    heads = [head for name in names for head in (f"{name}: shd", *(title for _, title in PEERS))]
    yield from without_empty_columns(["ms, one thread, 1024 x 1024 RGBA8", *heads], list(rows()))
    yield ""
    parts = (part for results in processors for part in versions(results) if not part.startswith("OpenColorIO"))
    yield "; ".join(dict.fromkeys(parts)) + "."


def without_empty_columns(heads, rows):
    kept = [i for i in range(len(heads)) if any(row[i] for row in rows)]
    return table([heads[i] for i in kept], ([row[i] for i in kept] for row in rows))


def lookup_cells(results, row, who):
    peer_row = "anisotropic" if row == "ewa" and who in ("llvmpipe", "openimageio") else row
    return number(results.rate(f"texture/{peer_row}/rgba8/{who}/floor/edge:2048"))


def lookups_table(results):
    who = [*results.targets, "llvmpipe", "openimageio"]
    heads = ["M lookups/s, perspective floor, RGBA8 to float RGBA", *(dict(PEERS).get(w, w) for w in who)]
    return table(heads, ([title, *(lookup_cells(results, row, w) for w in who)] for title, row in LOOKUPS))


def calls_table(results):
    counts = (1, 4, 16, 64)

    def rows():
        for title, row in (("bilinear", "bilinear"), ("trilinear", "trilinear"), ("anisotropic 16", "anisotropic"),
                           ("EWA 16", "ewa")):
            cells = [", ".join(number(results.value(f"call/{row}/{target}/count:{count}", "ns_per_call"))
                               for target in reversed(results.targets)) for count in counts]
            yield title, *cells, number(results.value(f"call/{row}/openimageio", "ns_per_call"))
    return table(["lookups in the call", *map(str, counts), "OpenImageIO, 1"], rows())


def displays_table(results):
    who = ["opencolorio", "exact", *reversed(results.targets)]
    views = (("plain sRGB", "plain_srgb"), ("ACES 1.0 SDR, sRGB", "aces_srgb"))
    rows = ([title, *(number(results.rate(f"display/{view}/{w}")) for w in who)] for title, view in views)
    return table(["view", "OpenColorIO", *who[1:]], rows)


def shadows_table(results):
    def rows():
        for title, method, row in SHADOWS:
            cells = [", ".join(number(results.rate(f"shadow/{row}/{light}/{target}/floor/size:256"))
                               for light in ("directional", "point")) for target in results.targets]
            yield title, method, *cells
    return table(["filter", "method", f"M lookups/s, {results.targets[0]}", *results.targets[1:]], rows())


def filters_table(results, names=None):
    """The best PSNR first."""
    def rows():
        for row in sorted(results.shootout["filters"], key=lambda r: -r["psnr"]):
            peer = row["who"] != "shd" and row["name"].endswith(SHORT_PEERS)
            if names and row["name"] not in names and not peer:
                continue
            texels = ("at least " if row["estimated"] and row["texels"] is not None else "") + number(row["texels"])
            yield (row["title"], row["who"], f"{row['psnr']:.2f}", f"{row['ssim']:.3f}", f"{row['flip']:.3f}", texels,
                   number(row["ns"]))
    return table(["filter", "by", "PSNR [dB]", "SSIM", "FLIP", "texels", "ns a lookup"], rows())


def short_filters_table(results):
    return filters_table(results, SHORT_LIST)


def fronts_table(results):
    fronts = results.shootout["fronts"]
    budgets = sorted({row["budget"] for row in fronts})
    counts = {(row["peer"], row["budget"]): f"{row['on']} of {row['of']}" for row in fronts}
    rows = ([peer, *(counts.get((peer, budget), "") for budget in budgets)] for peer in sorted({r["peer"] for r in fronts}))
    return table(["peer", *(f"{budget} texels" for budget in budgets)], rows)


def versions(results):
    context = results.bench["context"]
    return [context["compiler"], *(f"{name} {context[key].removeprefix(name + ' ')}" for name, key in
            (("llvmpipe", "llvmpipe"), ("OpenImageIO", "openimageio"), ("OpenColorIO", "opencolorio")) if key in context)]


def bench_machine(results):
    context = results.bench["context"]
    return ["; ".join([context["date"], f"{context['cpu']} ({context['simd'].split()[0]})", *versions(results)]) + "."]


def shootout_machine(results):
    report = results.shootout
    machine, options = report["machine"], report["options"]
    return [f"{machine['date']}, {machine['cpu']}, {machine['compiler']}; {'; '.join(report['peers'])}. Means of "
            f"{report['pictures']} pictures of {options['edge']} x {options['edge']} pixels."]


TABLES = {
    "processors": processors_table, "frames": frames_table, "lookups": lookups_table, "calls": calls_table,
    "displays": displays_table, "shadows": shadows_table, "filters": filters_table, "shootout": short_filters_table,
    "fronts": fronts_table,
    "bench-machine": bench_machine, "shootout-machine": shootout_machine,
}


class Writer:
    def __init__(self, root, use):
        self.folder, self.use, self.results, self.problems = root / "bench/results", use, {}, []

    def of(self, slug):
        if slug not in self.results:
            self.results[slug] = Results(self.folder / slug)
        return self.results[slug]

    def render(self, page, text):
        marks, found = len(MARK.findall(text)), len(MARKED.findall(text))
        if marks != 2 * found:
            self.problems.append(f"{page}: {marks} marks, but {found} pairs of NAME:begin SLUG and NAME:end")

        def replace(match):
            name, slugs = match["name"], match["slugs"].split()
            if self.use and name != "processors":
                slugs = [self.use]
            if name not in TABLES:
                self.problems.append(f"{page}: {name} is none of the tables {', '.join(TABLES)}")
                return match[0]
            try:
                lines = "\n".join(TABLES[name](*map(self.of, slugs)))
            except (OSError, ValueError, KeyError, IndexError, TypeError) as error:
                self.problems.append(f"{page}: {name} of {' '.join(slugs)}: {type(error).__name__} {error}")
                return match[0]
            return f"{match[1]}{' '.join(slugs)}{match[4]}{lines}\n{match[6]}"
        return MARKED.sub(replace, text)


def first_difference(page, old, new):
    for number_of_line, (have, want) in enumerate(zip(old.splitlines(), new.splitlines()), start=1):
        if have != want:
            return f"{page}:{number_of_line}: the results give: {want}"
    return f"{page}: the results give another number of lines"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    parser.add_argument("--use", help="folder of bench/results for all tables")
    options = parser.parse_args()
    writer, count = Writer(options.root, options.use), 0
    for path in [options.root / "README.md", *sorted((options.root / "docs").glob("*.md"))]:
        old, page = path.read_text(encoding="utf-8"), path.relative_to(options.root)
        new = writer.render(page, old)
        count += len(MARKED.findall(old))
        if new == old:
            continue
        if options.check:
            writer.problems.append(first_difference(page, old, new))
        else:
            path.write_text(new, encoding="utf-8")
    if count == 0:
        writer.problems.append("no page has a table of bench/results")
    print("\n".join([*writer.problems, f"style.results: {count} tables, {len(writer.problems)} problems"]))
    sys.exit(1 if writer.problems else 0)


if __name__ == "__main__":
    main()
