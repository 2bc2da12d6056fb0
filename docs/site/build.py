#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the manual: OUTPUT/html has the site. It needs no configured build of shd.

    build.py [OUTPUT] [--report shootout.html] [--module shd.wasm] [--root DIR]

OUTPUT is build/docs by default. Doxygen makes the reference of the headers, and MkDocs with the theme Material the pages
(Debian: doxygen doxygen-awesome-css mkdocs-material libjs-katex). Warnings of both are errors. The report of
examples/shootout.sh and shd.wasm of the preset `wasm`, with shd-figures.wasm beside it, are taken if they are there; a
file that an option names must be there. Exits with 77, as CTest skips tests, if a program or package is absent.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import extras
import languages
import pages
import reference

HERE = pathlib.Path(__file__).resolve().parent
AWESOME = pathlib.Path("/usr/share/doxygen-awesome-css")
KATEX = pathlib.Path("/usr/share/javascript/katex")
PROGRAMS = ("doxygen", "mkdocs")
# Folders of packages; mkdocs-material has the first one in Debian 12 and the second one in Debian 13.
FOLDERS = {"mkdocs-material": ["/usr/share/mkdocs/themes/material", "/usr/lib/python3/dist-packages/material"],
           "doxygen-awesome-css": [AWESOME], "libjs-katex": [KATEX]}
TOGGLE = "doxygen-awesome-darkmode-toggle.js"
HEAD = f"""<link rel="icon" href="$relpath^../icon.svg">
<script src="$relpath^reference.js"></script>
<script src="$relpath^{TOGGLE}"></script>
<script>DoxygenAwesomeDarkModeToggle.init()</script>
"""
SEARCH = """</tr><tr><td id="projectsearch"><div id="MSearchBox"><form action="$relpath^../index.html">
<input id="MSearchField" name="q" type="search" placeholder="Search the manual" autocomplete="off"></form></div></td>"""
ABSENT = 77


def absent_packages():
    absent = [program for program in PROGRAMS if not shutil.which(program)]
    return absent + [package for package, folders in FOLDERS.items() if not any(map(os.path.isdir, folders))]


def run(command, **options):
    """Runs a program quietly; its output is the text of the error if it fails."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, **options)
    if result.returncode:
        raise extras.SiteError(f"{command[0]} failed\n{result.stdout}")
    return result.stdout


def make_reference(root, output, stage):
    """The reference by Doxygen, with a header that joins it to the manual, and the places of all names."""
    texts = {page.stem: page.read_text(encoding="utf-8") for page in sorted((root / "docs").glob("*.md"))}
    (output / "manual.json").write_text(json.dumps(reference.pages_of_headers(texts)), encoding="utf-8")
    environment = {**os.environ, "SHD_DOCS_OUTPUT": str(stage), "SHD_DOCS_MANUAL": str(output / "manual.json")}
    header = output / "header.html"
    doxyfile = HERE / "Doxyfile"
    run(["doxygen", "-w", "html", header, output / "footer.html", output / "style.css", doxyfile], cwd=root, env=environment)
    text = re.sub(r"<!--BEGIN DISABLE_INDEX-->\s*<!--BEGIN SEARCHENGINE-->.*?<!--END DISABLE_INDEX-->", SEARCH,
                  header.read_text(encoding="utf-8"), flags=re.S).replace("</head>", f"{HEAD}</head>")
    header.write_text(text, encoding="utf-8")
    sheets = [AWESOME / "doxygen-awesome.css", AWESOME / "doxygen-awesome-sidebar-only.css",
              AWESOME / "doxygen-awesome-sidebar-only-darkmode-toggle.css", HERE / "reference.css"]
    configuration = "\n".join([
        f"@INCLUDE = {doxyfile}", f"HTML_HEADER = {header}", f"GENERATE_TAGFILE = {output / 'tags.xml'}",
        f"HTML_EXTRA_FILES = {HERE / 'reference.js'} {AWESOME / TOGGLE}",
        f"HTML_EXTRA_STYLESHEET = {' '.join(map(str, sheets))}"])
    run(["doxygen", "-"], input=configuration, cwd=root, env=environment)
    return reference.read_places(output / "tags.xml")


def stage_pages(root, stage, description, places):
    """The pages, pictures and scripts of the site, as MkDocs takes them."""
    for page in sorted((root / "docs").glob("*.md")):
        text = page.read_text(encoding="utf-8")
        (stage / page.name).write_text(pages.convert(text, places), encoding="utf-8")
    for old, new in pages.OTHER.items():
        text = (root / "docs" / old).read_text(encoding="utf-8")
        (stage / new).write_text(pages.convert(text, places, "../../"), encoding="utf-8")
    (stage / "c.md").write_text("\n".join(reference.page(description, places)) + "\n", encoding="utf-8")
    languages.make(root, stage, description, places)
    shutil.copytree(root / "docs/pictures", stage / "pictures")
    for picture in sorted((root / "examples").glob("*.png")):
        (stage / "examples").mkdir(exist_ok=True)
        shutil.copyfile(picture, stage / "examples" / picture.name)
    shutil.copyfile(root / "docs/cheatsheet.html", stage / "cheatsheet.html")
    shutil.copyfile(root / "bindings/js/playground/icon.svg", stage / "icon.svg")
    for name in ("style.css", "site.js", "site-file.js"):
        shutil.copyfile(HERE / name, stage / name)
    shutil.copytree(KATEX / "fonts", stage / "katex/fonts", ignore=shutil.ignore_patterns("*.ttf", "*.woff"))
    for name in ("katex.min.css", "katex.min.js", "contrib/auto-render.js"):
        shutil.copyfile(KATEX / name, stage / "katex" / pathlib.Path(name).name)


def add_to_search(html, description, places):
    """Names of the interface join the index of the search, in place of the lists of their page.

    As a script, the index serves pages that are opened as files, too.
    """
    path = html / "search/search_index.json"
    index = json.loads(path.read_text(encoding="utf-8"))
    index["docs"] = [page for page in index["docs"] if not page["location"].startswith("c.html#")]
    index["docs"] += reference.search_entries(description, places)
    text = json.dumps(index, separators=(",", ":"))
    path.write_text(text, encoding="utf-8")
    (html / "search/search_index.js").write_text(f"var __index = {text};\n", encoding="utf-8")


def build(options, output):
    root, stage, html = options.root, output / "stage", output / "html"
    report = extras.choose(options.report, root / "out/shootout/shootout.html")
    module = extras.choose(options.module, root / "build/wasm/bindings/js/shd.wasm")
    for folder in (stage, html):
        shutil.rmtree(folder, ignore_errors=True)
    stage.mkdir(parents=True)
    description = reference.read_description(root / "bindings/shd.json")
    places = make_reference(root, output, stage)
    stage_pages(root, stage, description, places)
    if report:
        extras.add_report(stage, report)
    if module:
        extras.add_playground(stage, root / "bindings/js", module)
        figures = module.with_name("shd-figures.wasm")
        if figures.is_file():
            extras.add_figures(stage, root / "bindings/js", figures)
    (output / "mkdocs.yml").write_text(
        f"INHERIT: {HERE / 'mkdocs.yml'}\ndocs_dir: {stage}\nsite_dir: {html}\ntheme: {{custom_dir: {HERE / 'theme'}}}\n",
        encoding="utf-8")
    run(["mkdocs", "build", "--quiet", "--strict", "--config-file", output / "mkdocs.yml"])
    (html / "404.html").unlink()  # it would need the address of the site
    add_to_search(html, description, places)
    print(f"Filter shoot-out: {report or 'none; examples/shootout.sh makes a report'}")
    print(f"Playground and figures: {module or 'none; cmake --preset wasm and its build make shd.wasm'}")
    print(f"Manual: {html / 'index.html'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", nargs="?", type=pathlib.Path)
    parser.add_argument("--report", type=pathlib.Path)
    parser.add_argument("--module", type=pathlib.Path)
    parser.add_argument("--root", type=pathlib.Path, default=HERE.parents[1])
    options = parser.parse_args()
    if absent := absent_packages():
        print(f"build.py: the manual needs {' '.join(absent)}, packages of Debian", file=sys.stderr)
        sys.exit(ABSENT)
    try:
        build(options, (options.output or options.root / "build/docs").resolve())
    except (extras.SiteError, OSError) as error:
        sys.exit(f"build.py: {error}")


if __name__ == "__main__":
    main()
