#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what shd-bench prints about itself: --help, --list, a filter without a row, and the context of its JSON.

    check_usage.py shd-bench README.md
"""
import json
import pathlib
import re
import subprocess
import sys

NAME = re.compile(r"[a-z]+(/[a-zA-Z0-9_.:+-]+)+")


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=100)


def groups_of(text):
    """The indented names between the line of the groups and the next empty line."""
    block = text.partition("\nGroups")[2].partition("\n")[2].partition("\n\n")[0]
    return {line.split()[0] for line in block.splitlines()}


def check_help(program, readme):
    problems = []
    helped = run(program, "--help")
    for text in ("--benchmark_filter", "--benchmark_out=", "SHD_BENCH_WRITE", "Groups"):
        if text not in helped.stdout:
            problems.append(f"--help: {text} is missing")
    if helped.returncode != 0 or run(program, "-h").stdout != helped.stdout:
        problems.append("--help and -h are not the same, or do not end with status 0")
    groups = groups_of(helped.stdout)
    for group in sorted(groups):
        if not re.search(rf"^\| .*`{group}/", readme, re.MULTILINE):
            problems.append(f"README.md has no row `{group}/...`")
    return groups, problems


def check_list(program, groups):
    problems = []
    listed = run(program, "--list")
    names = listed.stdout.split("\n")[:-1]
    if listed.returncode != 0 or listed.stdout != run(program, "--benchmark_list_tests").stdout:
        problems.append("--list and --benchmark_list_tests are not the same")
    problems += [f"--list: {name} is not GROUP/WHAT/..." for name in names if not NAME.fullmatch(name)]
    if len(names) != len(set(names)):
        problems.append("--list: a name appears twice")
    found = {name.partition("/")[0] for name in names}
    problems += [f"--help has no group {group}" for group in sorted(found - groups)]
    problems += [f"no row belongs to the group {group} of --help" for group in sorted(groups - found)]
    return problems


def check_filters(program):
    problems = []
    for filter_text in ("^no_such_group/", "texture/("):
        wrong = run(program, f"--benchmark_filter={filter_text}")
        if wrong.returncode != 1 or filter_text not in wrong.stderr or "--list" not in wrong.stderr:
            problems.append(f"the filter {filter_text} gives status {wrong.returncode}, {wrong.stderr!r}")
    if run(program, "--no_such_option").returncode != 1:
        problems.append("an unknown option does not give status 1")
    right = run(program, "--benchmark_filter=^call/bilinear/.*count:1$", "--benchmark_format=json",
                "--benchmark_min_time=0.001")
    context = json.loads(right.stdout)["context"] if right.returncode == 0 else {}
    problems += [f"the context of the JSON has no {key}" for key in ("cpu", "shd", "simd", "compiler")
                 if not context.get(key)]
    return problems


def main():
    program, readme = sys.argv[1], pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
    groups, problems = check_help(program, readme)
    problems += check_list(program, groups)
    problems += check_filters(program)
    print("\n".join(problems + [f"bench.usage: {len(groups)} groups, {len(problems)} problems"]))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
