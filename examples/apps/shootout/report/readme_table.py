#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints tables for a README in Markdown from the JSON of a shoot-out.

    readme_table.py shootout.json [--workload NAME] [--texture NAME]
"""
import argparse
import json
import pathlib
import sys


def index_of(items, name, kind):
    names = [item["name"] for item in items]
    if name not in names:
        sys.exit(f"--{kind}: {name} is not one of {', '.join(names)}")
    return names.index(name)


def cell(value, digits):
    return "" if value is None else f"{value:.{digits}f}"


def filters_table(report, workload, texture):
    """One row a filter, the best PSNR first."""
    costs = {(row["w"], row["s"]): row for row in report["costs"]}
    rows = [row for row in report["rows"] if (row["w"], row["t"]) == (workload, texture)]
    yield "| filter | by | PSNR [dB] | SSIM | FLIP | texels | ns a lookup |"
    yield "|---|---|---|---|---|---|---|"
    for row in sorted(rows, key=lambda r: -r["samples"][0]):
        setting, cost = report["settings"][row["s"]], costs[workload, row["s"]]
        texels = ("at least " if setting["estimated"] else "") + cell(cost["texels"], 1)
        yield (f"| {setting['title']} | {setting['who']} | {cell(row['samples'][0], 2)} | {cell(row['samples'][1], 4)} "
               f"| {cell(row['samples'][4], 4)} | {texels} | {cell(cost['whole_ns'], 1)} |")


def fronts_table(report):
    """Cases in which shd is on the front, by peer and budget."""
    budgets = sorted({row["budget"] for row in report["fronts"]})
    yield "| peer | " + " | ".join(f"{budget} texels" for budget in budgets) + " |"
    yield "|---" * (len(budgets) + 1) + "|"
    for peer in sorted({row["peer"] for row in report["fronts"]}):
        counts = []
        for budget in budgets:
            cases = [row for row in report["fronts"] if (row["peer"], row["budget"]) == (peer, budget)]
            counts.append(f"{sum(row['on'] for row in cases)} of {len(cases)}")
        yield f"| {peer} | " + " | ".join(counts) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--workload", default="floor_45")
    parser.add_argument("--texture", default="checker")
    options = parser.parse_args()
    try:
        report = json.loads(options.report.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        sys.exit(f"{options.report}: {error}")
    workload = index_of(report["workloads"], options.workload, "workload")
    texture = index_of(report["textures"], options.texture, "texture")
    machine = report["machine"]
    print(f"{report['workloads'][workload]['title']}, {report['textures'][texture]['title']}:\n")
    print("\n".join(filters_table(report, workload, texture)))
    print("\nWorkloads x textures in which no filter of the peer within the budget has less error than shd's best:\n")
    print("\n".join(fronts_table(report)))
    print(f"\n{machine['cpu']}, {machine['compiler']}, {machine['commit']}, {machine['date']}; {'; '.join(report['peers'])}.")


if __name__ == "__main__":
    main()
