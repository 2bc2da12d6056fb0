#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks finish_site.py and pages.py on a small site: check_site.py FOLDER."""
import pathlib
import shutil
import subprocess
import sys

import pages

DOCS = pathlib.Path(__file__).resolve().parent
FILTERS = ("bilinear", "nearest_mip")


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def make(folder):
    """A source tree with a playground of two filters, and the pages of three."""
    shutil.rmtree(folder, ignore_errors=True)
    root, html = folder / "root", folder / "html"
    write(root / "bindings/js/playground/state.js", 'const FILTERS = ["bilinear",\n "nearest_mip"];\n')
    for name in ("api.js", "index.js"):
        write(root / "bindings/js/lib" / name, "")
    for name in (*FILTERS, "exact"):
        write(html / f"md_docs_filter_{name}.html",
              f'<body><h1><a class="anchor" id="filter-{name.replace("_", "-")}-error"></a>Error</h1></body>')
    write(html / "md_docs_shootout.html", '<h1><a class="anchor" id="shootout-how-to-read-the-page"></a>How</h1>')
    return root, html


def finish(root, html, *options):
    command = [sys.executable, DOCS / "finish_site.py", html, "--root", root, *options]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def read(html):
    return {path.name: path.read_text(encoding="utf-8") for path in html.rglob("*") if path.is_file()}


def check_none(folder):
    root, html = make(folder)
    before = read(html)
    run = finish(root, html)
    assert run.returncode == 0 and read(html) == before and run.stdout.count("none;") == 2, run


def check_all(folder):
    root, html = make(folder)
    write(root / "build/wasm/bindings/js/shd.wasm", "default module")
    write(root / "out/shootout/shootout.html", "default report")
    for _ in range(2):  # a second run changes nothing
        run = finish(root, html)
        pages = read(html)
        assert run.returncode == 0, run
        assert pages["shd.wasm"] == "default module" and pages["shootout.html"] == "default report"
        assert pages["md_docs_shootout.html"].count("shootout.html") == 1
        for name in FILTERS:
            page = pages[f"md_docs_filter_{name}.html"]
            assert page.count("<iframe") == 1 and page.index("<iframe") < page.index("<h1>"), page
            assert f"#texture=checker&amp;a.filter={name}&amp;b.filter=anisotropic" in page, page
        assert "playground" not in pages["md_docs_filter_exact.html"]


def check_options(folder):
    root, html = make(folder)
    write(root / "out/shootout/shootout.html", "default report")
    write(folder / "mine.html", "mine")
    assert finish(root, html, "--report", folder / "mine.html").returncode == 0
    assert read(html)["shootout.html"] == "mine"
    for option in ("--report", "--module"):
        run = finish(root, html, option, folder / "absent")
        assert run.returncode and run.stderr == f"finish_site.py: {folder / 'absent'} is not there\n", run


def check_faults(folder):
    root, html = make(folder)
    write(folder / "shd.wasm", "")
    (html / "md_docs_filter_nearest_mip.html").write_text("", encoding="utf-8")
    run = finish(root, html, "--module", folder / "shd.wasm")
    assert run.returncode and "no place" in run.stderr and "Traceback" not in run.stderr, run
    (root / "bindings/js/lib/api.js").unlink()
    run = finish(root, html, "--module", folder / "shd.wasm")
    assert run.returncode and "cmake --build --preset wasm" in run.stderr, run
    (html / "md_docs_filter_bilinear.html").unlink()
    write(root / "bindings/js/lib/api.js", "")
    run = finish(root, html, "--module", folder / "shd.wasm")
    assert run.returncode and "md_docs_filter_bilinear.html" in run.stderr and "Traceback" not in run.stderr, run


def check_pages():
    text = "# A\n## Use it, `now`\n[x](other_page.md#files) [y](#use-it-now) [z](page.md)\n```\n## code\n```"
    assert list(pages.convert("build", text)) == [
        "# A", "## Use it, `now` {#build-use-it-now}",
        "[x](#other-page-files) [y](#build-use-it-now) [z](page.md)", "```", "## code", "```"]
    assert list(pages.convert("a", "![P: a](../x/y-z.png) ![Q](q.svg) [z](../x/z.png)")) == [
        "![P: a](y-z.png) ![Q](q.svg) [z](../x/z.png)"]
    text = "[A page](a-page.md), [E](filter-ewa.md), [again](a-page.md), [part](a-page.md#part)"
    assert list(pages.convert("index", text)) == [
        '@subpage md_docs_a_page "A page", [E](filter-ewa.md), [again](a-page.md), [part](#a-page-part)']
    assert list(pages.convert("filters", "[A](a.md) [E](filter-ewa.md)")) == [
        '[A](a.md) @subpage md_docs_filter_ewa "E"']


def main():
    folder = pathlib.Path(sys.argv[1])
    for check in (check_none, check_all, check_options, check_faults):
        check(folder / check.__name__)
    check_pages()
    print("docs.site: 5 checks")


main()
