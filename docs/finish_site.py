#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Adds to the pages of Doxygen what other programs make: the report of the filter shoot-out, and the playground.

    finish_site.py HTML [--report shootout.html] [--module shd.wasm] [--root DIR]

The report is linked from its page. The playground needs shd.wasm and the files that its build generates; each page of a
filter that it has then shows that filter. Without options the files of examples/shootout.sh and of the preset `wasm` are
taken, if they are there. A file that an option names must be there.
"""
import argparse
import pathlib
import re
import shutil
import sys

COMPARED = {"anisotropic": "trilinear", "ewa": "anisotropic"}  # with the first of these filters; others with anisotropic
EMBED = """<div class="playground">
<p>The playground: {title} left of the divider, {other} right of it. <a href="{address}">Open it in a page of its own</a>.</p>
<iframe src="{address}" title="Playground: {title}" loading="lazy"></iframe>
</div>
"""
LINK = '<p><a href="shootout.html">The page of this site</a> has pictures under a wipe and every figure.</p>\n'


class SiteError(Exception):
    pass


def choose(option, default):
    """The file that is there: that of an option, or the default; else None."""
    if option and not option.is_file():
        raise SiteError(f"{option} is not there")
    return option or (default if default.is_file() else None)


def insert_before(page, pattern, text):
    """Writes `text` before the first match; a page that was changed before stays as it is."""
    old = page.read_text(encoding="utf-8")
    if text in old:
        return
    place = re.search(pattern, old)
    if not place:
        raise SiteError(f"{page}: no place that matches {pattern}")
    page.write_text(old[:place.start()] + text + old[place.start():], encoding="utf-8")


def title(name):
    return "EWA" if name == "ewa" else name.replace("_", " ")


def add_report(html, report):
    shutil.copyfile(report, html / "shootout.html")
    insert_before(html / "md_docs_shootout.html", r'<h1><a class="anchor" id="shootout-how-to-read-the-page">', LINK)


def playground_filters(state):
    """The names of filters in the playground's list of settings."""
    names = re.search(r"^const FILTERS = \[(.*?)\];", state, re.S | re.M)
    if not names:
        raise SiteError("state.js has no list FILTERS")
    return re.findall(r'"(\w+)"', names[1])


def add_playground(html, source, module):
    for name in ("api.js", "index.js"):
        if not (source / "lib" / name).is_file():
            raise SiteError(f"{source / 'lib' / name} is not there; cmake --build --preset wasm makes it")
    shutil.copytree(source / "playground", html / "playground", dirs_exist_ok=True)
    shutil.copytree(source / "lib", html / "lib", dirs_exist_ok=True)
    shutil.copyfile(module, html / "lib/shd.wasm")
    for name in playground_filters((source / "playground/state.js").read_text(encoding="utf-8")):
        other = COMPARED.get(name, "anisotropic")
        address = f"playground/index.html#texture=checker&amp;a.filter={name}&amp;b.filter={other}"
        text = EMBED.format(title=title(name), other=title(other), address=address)
        label = f"filter-{name.replace('_', '-')}-error"
        insert_before(html / f"md_docs_filter_{name}.html", f'<h1><a class="anchor" id="{label}">', text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("html", type=pathlib.Path)
    parser.add_argument("--report", type=pathlib.Path)
    parser.add_argument("--module", type=pathlib.Path)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1])
    options = parser.parse_args()
    try:
        report = choose(options.report, options.root / "out/shootout/shootout.html")
        module = choose(options.module, options.root / "build/wasm/bindings/js/shd.wasm")
        if report:
            add_report(options.html, report)
        if module:
            add_playground(options.html, options.root / "bindings/js", module)
    except (SiteError, OSError) as error:
        sys.exit(f"finish_site.py: {error}")
    print(f"Filter shoot-out: {report or 'none; examples/shootout.sh makes a report'}")
    print(f"Playground: {module or 'none; cmake --preset wasm and its build make shd.wasm'}")


if __name__ == "__main__":
    main()
