#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures this machine and keeps what the tables of README.md and docs/ quote, in bench/results/<processor>/.

    keep_results.py --build FOLDER [--shootout FOLDER] [--bench FILE [--processor NAME]] [--min-time SECONDS]
                    [--repetitions COUNT] [--out FOLDER]

Runs shd-bench and shd-shootout of the build on a machine that should be quiet, for about a quarter of an hour; the
figures are medians of interleaved repetitions. --shootout takes a finished report, --bench a finished JSON of
shd-bench. With --processor these are figures of another machine, which needs no report. results_tables.py then writes
the tables.
"""
import argparse
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
WHO = "(SSE4|AVX2|AVX512|NEON|llvmpipe|openimageio|opencolorio|exact)"
ROWS = "|".join([
    f"^frame/(spheres|rgba8)/[^/]*/{WHO}$",
    f"^frame/(quad|floor)/[^/]*/{WHO}$",
    f"^texture/(nearest|bilinear|trilinear|anisotropic|ewa)/rgba8/{WHO}/floor/edge:2048$",
    f"^call/(bilinear|trilinear|anisotropic|ewa)/{WHO}(/count:(1|4|16|64))?$",
    f"^display/(plain_srgb|aces_srgb)/{WHO}$",
    f"^shadow/(hard|pcf_3x3|pcf_7x7|variance|summed_area_variance|pcss_7x7)/[^/]*/{WHO}/floor/size:256$",
])
KEPT_CONTEXT = ("date", "num_cpus", "cpu", "simd", "shd", "commit", "compiler", "llvmpipe", "openimageio",
                "opencolorio")
SCENES = ("floor", "floor_45", "tunnel", "sphere")
CSV_COLUMNS = ("workload", "texture", "setting", "psnr_db", "ssim", "flip", "texels", "whole_ns")


def fail(text):
    sys.exit(f"keep_results.py: {text}")


def slug_of_machine():
    """Name, family and model of the processor: virtual machines give several processors one name."""
    fields = dict(re.findall(r"^(model name|cpu family|model)\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(),
                             re.MULTILINE))
    if "model name" not in fields:
        fail("/proc/cpuinfo has no model name")
    name = re.sub(r"\((r|tm)\)|cpu|processor|@.*", " ", fields["model name"].lower())
    words = [*re.findall(r"[a-z0-9]+", name), fields.get("cpu family", ""), fields.get("model", "")]
    return "-".join(word for word in words if word)


def run(command):
    if not command[0].is_file():
        fail(f"{command[0]} is missing; --build names a finished build with SHD_BUILD_BENCH and SHD_BUILD_EXAMPLES")
    print("== " + " ".join(map(str, command)), flush=True)
    if subprocess.run(command, check=False).returncode != 0:
        fail(f"{command[0]} failed")


def read_json(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        return fail(f"{path}: {error}")


def rounded(value):
    return float(f"{value:.4g}") if isinstance(value, float) else value


def small_bench(run_of_bench):
    """Medians of processor time and of rates. Other load of the machine changes them less than wall time."""
    rows = {}
    for row in run_of_bench["benchmarks"]:
        if row.get("aggregate_name") != "median":
            continue
        name, scale = row["run_name"], {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}[row["time_unit"]]
        rows[name] = {"ms": rounded(row["cpu_time"] * scale)}
        rows[name] |= {key: rounded(row[key]) for key in ("items_per_second", "ns_per_call") if key in row}
    if not rows:
        fail("the JSON of shd-bench has no medians; it needs --benchmark_repetitions")
    context = {key: run_of_bench["context"][key] for key in KEPT_CONTEXT if key in run_of_bench["context"]}
    return {"context": context | {"date": context["date"][:10]}, "rows": rows}


def mean(values):
    values = [value for value in values if value is not None]
    return rounded(float(sum(values)) / len(values)) if values else None


def small_filters(report):
    """One row a setting: means over the scenes that minify, and over all textures."""
    scenes = {number for number, workload in enumerate(report["workloads"]) if workload["name"] in SCENES}
    if len(scenes) != len(SCENES):
        fail(f"the report lacks one of the workloads {', '.join(SCENES)}")
    for number, setting in enumerate(report["settings"]):
        samples = [row["samples"] for row in report["rows"] if row["s"] == number and row["w"] in scenes]
        costs = [row for row in report["costs"] if row["s"] == number and row["w"] in scenes]
        yield setting | {"psnr": mean([s[0] for s in samples]), "ssim": mean([s[1] for s in samples]),
                         "flip": mean([s[4] for s in samples]), "texels": mean([c.get("texels") for c in costs]),
                         "ns": mean([c.get("whole_ns") for c in costs])}


def small_fronts(report):
    """Cases of each peer and budget, and the cases in which shd is on the front."""
    counts = {}
    for row in report["fronts"]:
        count = counts.setdefault((row["peer"], row["budget"]), {"on": 0, "default_on": 0, "of": 0})
        count["on"] += int(row["on"])
        count["default_on"] += int(row["default_on"])
        count["of"] += 1
    return [{"peer": peer, "budget": budget} | count for (peer, budget), count in sorted(counts.items())]


def small_shootout(report):
    if report["options"]["quick"]:
        fail("the report is of --quick, whose frames are too small for tables")
    kept = {key: report[key] for key in ("machine", "options", "peers", "missing")}
    return kept | {"pictures": len(SCENES) * len(report["textures"]), "filters": list(small_filters(report)),
                   "fronts": small_fronts(report)}


def write_json(path, value):
    """One line an entry, so that a new run is a readable difference."""
    parts = []
    for key, inner in value.items():
        if isinstance(inner, dict):
            lines = [f"  {json.dumps(name)}: {json.dumps(entry)}" for name, entry in inner.items()]
            parts.append(f" {json.dumps(key)}: {{\n" + ",\n".join(lines) + "\n }")
        elif isinstance(inner, list) and inner:
            parts.append(f" {json.dumps(key)}: [\n" + ",\n".join(f"  {json.dumps(entry)}" for entry in inner) + "\n ]")
        else:
            parts.append(f" {json.dumps(key)}: {json.dumps(inner)}")
    path.write_text("{\n" + ",\n".join(parts) + "\n}\n", encoding="utf-8")


def write_csv(source, path):
    """The columns of people, four digits each."""
    with source.open(encoding="utf-8") as given, path.open("w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(CSV_COLUMNS)
        for row in csv.DictReader(given):
            writer.writerow([short(row[column]) for column in CSV_COLUMNS])


def short(text):
    try:
        return f"{float(text):.4g}"
    except ValueError:
        return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--shootout", type=pathlib.Path, help="folder of a finished report")
    parser.add_argument("--bench", type=pathlib.Path, help="finished JSON of shd-bench")
    parser.add_argument("--processor", help="folder for the figures of another machine")
    parser.add_argument("--min-time", default="0.1")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "bench/results")
    options = parser.parse_args()
    if options.processor and options.bench is None:
        fail("--processor needs --bench, a run on that machine")
    folder = options.out / (options.processor or slug_of_machine())
    with tempfile.TemporaryDirectory() as scratch:
        bench, report = options.bench, options.shootout
        if bench is None:
            bench = pathlib.Path(scratch) / "bench.json"
            run([options.build / "bench/shd-bench", f"--benchmark_filter={ROWS}",
                 f"--benchmark_min_time={options.min_time}", f"--benchmark_repetitions={options.repetitions}",
                 "--benchmark_enable_random_interleaving=true", f"--benchmark_out={bench}"])
        if report is None and not options.processor:
            report = pathlib.Path(scratch) / "shootout"
            run([options.build / "examples/apps/shootout/shd-shootout", "-o", report])
        folder.mkdir(parents=True, exist_ok=True)
        write_json(folder / "bench.json", small_bench(read_json(bench)))
        if report is not None:
            write_json(folder / "shootout.json", small_shootout(read_json(report / "shootout.json")))
            write_csv(report / "shootout.csv", folder / "shootout.csv")
    print(f"{folder}: {sum(path.stat().st_size for path in folder.iterdir())} bytes")
    print("bench/results_tables.py writes the tables of README.md and docs/ from the folder that their marks name")


if __name__ == "__main__":
    main()
