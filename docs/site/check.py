#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the manual and its scripts: check.py FOLDER. Exits with 77, as CTest skips tests, without the packages."""
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

import build
import extras
import languages
import pages
import reference

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
FILTERS = ("bilinear", "nearest_mip")
# A declaration in the reference of each language.
DECLARATIONS = {
    "cpp": "[`shd::shadow_create`](c/shadow_8h.html#",
    "python": "### shd.Shadow\n",
    "javascript": "  trim(): void;",
    "lua": "[`shadow:sample(...)`](c/shadow_8h.html#",
    "rust": "`fn at(mut self, object_to_world: [f32; 16]) -> Self`",
    "csharp": "`static Mesh FromShape(Context context, ShapeDesc desc, MeshFlags flags",
}


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def refused(function, *arguments):
    """The text of the error of a call."""
    try:
        function(*arguments)
    except extras.SiteError as error:
        return str(error)
    raise AssertionError("no error")


def make_playground(folder):
    """The files of a playground of two filters, and the pages of three."""
    shutil.rmtree(folder, ignore_errors=True)
    stage, source = folder / "stage", folder / "js"
    write(source / "playground/state.js", 'const FILTERS = ["bilinear",\n "nearest_mip"];\n')
    for name in ("api.js", "index.js"):
        write(source / "lib" / name, "")
    write(source / "shd.wasm", "module")
    for name in (*FILTERS, "exact"):
        write(stage / f"filter-{name.replace('_', '-')}.md", "# A filter\n\n## Error\n\nNone.\n")
    write(stage / "shootout.md", "# Shoot-out\n\n## How to read the page\n")
    return stage, source


def check_extras(folder):
    stage, source = make_playground(folder)
    extras.add_playground(stage, source, source / "shd.wasm")
    assert (stage / "lib/shd.wasm").read_text(encoding="utf-8") == "module"
    for name in FILTERS:
        page = (stage / f"filter-{name.replace('_', '-')}.md").read_text(encoding="utf-8")
        assert page.count("<iframe") == 1 and page.index("<iframe") < page.index("## Error"), page
        assert f"#texture=checker&amp;a.filter={name}&amp;b.filter=anisotropic" in page, page
    assert "playground" not in (stage / "filter-exact.md").read_text(encoding="utf-8")
    write(folder / "report.html", "report")
    extras.add_report(stage, folder / "report.html")
    assert (stage / extras.REPORT).read_text(encoding="utf-8") == "report"
    assert f"({extras.REPORT})" in (stage / "shootout.md").read_text(encoding="utf-8")
    assert extras.choose(None, folder / "report.html") == folder / "report.html"
    assert extras.choose(None, folder / "absent") is None
    assert refused(extras.choose, folder / "absent", folder / "report.html") == f"{folder / 'absent'} is not there"


def make_figures(folder):
    """The files of a figure, and pages with and without it."""
    stage, source = make_playground(folder)
    write(source / "figures/shd-figure.js", 'import { load } from "../lib/index.js";\nimport {\n  a,\n} from "./stage.js";\n')
    write(source / "figures/stage.js", 'import { load } from "../lib/index.js";\n')
    write(source / "lib/index.js", 'export { b } from "./api.js";\n')
    write(source / "figures/texels.js", "")
    write(source / "shd-figures.wasm", "figures")
    write(stage / "course-a.md", '# A\n\n<shd-figure name="texels">Text</shd-figure>\n')
    write(stage / "course-b.md", "# B\n")
    extras.add_playground(stage, source, source / "shd.wasm")
    return stage, source


def check_figures(folder):
    stage, source = make_figures(folder)
    extras.add_figures(stage, source, source / "shd-figures.wasm")
    assert (stage / "figures/shd-figures.wasm").read_text(encoding="utf-8") == "figures"
    page = (stage / "course-a.md").read_text(encoding="utf-8")
    assert page.count('<script type="module" async src="figures/shd-figure.js">') == 1, page
    loaded = re.findall('<link rel="modulepreload" href="([^"]*)">', page)
    assert loaded == ["figures/shd-figure.js", "figures/texels.js", "lib/index.js", "figures/stage.js", "lib/api.js"], loaded
    assert all((stage / path).is_file() for path in loaded) and "Text</shd-figure>" in page, page
    assert (stage / "course-b.md").read_text(encoding="utf-8") == "# B\n"
    stage, source = make_figures(folder)
    write(stage / "course-b.md", '<shd-figure name="texel">Text</shd-figure>')
    assert refused(extras.add_figures, stage, source, source / "shd-figures.wasm") == "course-b.md: no figure texel"
    for page in (ROOT / "docs").glob("*.md"):
        extras.figures_of(page, ROOT / "bindings/js")


def check_faults(folder):
    stage, source = make_playground(folder)
    write(stage / "filter-nearest-mip.md", "# No errors\n")
    assert refused(extras.add_playground, stage, source, source / "shd.wasm") == "filter-nearest-mip.md: no heading ## Error"
    (source / "lib/api.js").unlink()
    assert "cmake --build --preset wasm" in refused(extras.add_playground, stage, source, source / "shd.wasm")
    write(folder / "stage/bindings.md", "# Other languages\n\n## C++\n\nText.\n")
    assert refused(languages.make, ROOT, folder / "stage", {"functions": []}, {}).startswith("bindings.md: no heading C++")
    assert "FILTERS" in refused(extras.playground_filters, "const FILTER = [];")
    command = [sys.executable, "-B", HERE / "build.py", folder / "site"]
    run = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "PATH": str(folder)})
    assert run.returncode == build.ABSENT and "doxygen" in run.stderr and "Traceback" not in run.stderr, run


def check_pages(_):
    places = {"shd_a": "c/a_8h.html#1", "shd/a.h": "c/a_8h.html", "SHD_B": "c/b.html#2"}
    for text, expected in (
            ("shd_a() and `shd_a`, SHD_B.", "[shd_a()](c/a_8h.html#1) and [`shd_a`](c/a_8h.html#1), [SHD_B](c/b.html#2)."),
            ("(shd/a.h); include/shd/a.h", "([shd/a.h](c/a_8h.html)); include/shd/a.h"),
            ("# shd_a\n```c\nshd_a();\n```", "# shd_a\n```c\nshd_a();\n```"),
            ("$$\nshd_a\n$$\n$shd_a$ [shd_a](x.md) `shd_a(b)` shd_unknown", None),
            ("text\n\n    shd_a\n\nshd_a", "text\n\n    shd_a\n\n[shd_a](c/a_8h.html#1)"),
            ("- item\n  shd_a", "- item\n  [shd_a](c/a_8h.html#1)"),
            ("[c](../examples/course/README.md) ![g](../examples/g.png)", "[c](course-programs.md) ![g](examples/g.png)")):
        assert pages.convert(text, places) == (text if expected is None else expected) + "\n", pages.convert(text, places)
    assert pages.convert("[b](../../docs/build.md#x)", places, "../../") == "[b](build.md#x)\n"
    assert pages.slug("Use it, `now`") == "use-it-now"
    found = reference.pages_of_headers({"b": "# B\nshd/x.h, shd/y.h", "a": "# A\nshd/x.h"})
    assert found == {"x.h": [["A", "../a.html"], ["B", "../b.html"]], "y.h": [["B", "../b.html"]]}, found


class Page(html.parser.HTMLParser):
    """Ids, links, sources and formulas of a page."""

    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.formulas, self.is_formula = set(), [], [], False
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.ids |= {attributes.get("id"), attributes.get("name")}
        if attributes.get("class") == "arithmatex":
            self.formulas.append("")
            self.is_formula = True
        self.links += [(tag, attributes[name]) for name in ("href", "src", "data") if attributes.get(name)]

    def handle_endtag(self, _):
        self.is_formula = False

    def handle_data(self, data):
        if self.is_formula:
            self.formulas[-1] += data


# Renders the formulas of a JSON list by the KaTeX of the site.
RENDER = """
const katex = require(process.argv[1]);
for (const formula of JSON.parse(require("fs").readFileSync(0))) {
  try {
    katex.renderToString(formula, { displayMode: true });
  } catch (error) {
    console.error(`${formula}: ${error.message}`);
    process.exitCode = 1;
  }
}
"""


def check_formulas(site):
    formulas = {page: Page(page).formulas for page in sorted(site.glob("*.html"))}
    assert len(formulas[site / "coordinates.html"]) > 9 and len(formulas[site / "solid.html"]) > 9, formulas
    if not shutil.which("node"):
        print("docs.site: no node, so no formula was rendered")
        return
    everything = json.dumps([formula.strip()[2:-2] for found in formulas.values() for formula in found])
    run = subprocess.run(["node", "-e", RENDER, site / "katex/katex.min.js"], input=everything, capture_output=True, text=True,
                         check=False)
    assert run.returncode == 0, run.stderr


def broken_links(site):
    """Links of the pages to files or places that are not there, and whatever a browser would load from elsewhere."""
    parsed = {path: Page(path) for path in site.rglob("*.html") if "playground" not in path.parts}
    for path, page in parsed.items():
        for tag, link in page.links:
            if urllib.parse.urlsplit(link).scheme:
                if tag != "a" and not link.startswith(("data:", "javascript:")):
                    yield f"{path}: loads {link}"
                continue
            name, _, part = urllib.parse.unquote(link).partition("#")
            target = (path.parent / name.partition("?")[0]).resolve() if name else path
            target = target / "index.html" if target.is_dir() else target
            if not target.exists() or part and target in parsed and part not in parsed[target].ids:
                yield f"{path}: no {link}"


def check_site(folder):
    """The whole site."""
    shutil.rmtree(folder, ignore_errors=True)
    write(folder / "report.html", "<p>report</p>")
    command = [sys.executable, "-B", HERE / "build.py", folder, "--report", folder / "report.html"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode == build.ABSENT:
        print(run.stderr)
        sys.exit(build.ABSENT)
    assert run.returncode == 0, run
    site = folder / "html"
    problems = list(broken_links(site))
    assert not problems, "\n".join(problems[:20])
    for page in (ROOT / "docs").glob("*.md"):
        assert (site / f"{page.stem}.html").is_file(), page
    for name, declaration in DECLARATIONS.items():
        text = (folder / f"stage/{name}.md").read_text(encoding="utf-8").partition("\n## Reference\n")[2]
        assert text.count("\n### ") > 9 and declaration in text, name
    assert DECLARATIONS.keys() == {name for name, _, _ in languages.LANGUAGES}
    assert (site / extras.REPORT).is_file() and (site / "katex/fonts/KaTeX_Main-Regular.woff2").is_file()
    check_formulas(site)
    check_search(site)


def check_search(site):
    """Every function is in the search, and its address leads to its place in the reference."""
    text = (site / "search/search_index.json").read_text(encoding="utf-8")
    assert (site / "search/search_index.js").read_text(encoding="utf-8") == f"var __index = {text};\n"
    found = {entry["title"]: entry["location"] for entry in json.loads(text)["docs"]}
    description = reference.read_description(ROOT / "bindings/shd.json")
    for function in description["functions"]:
        page, _, name = found[function["name"]].partition("?")
        assert name == function["name"] and f"{name}()</h2>" in (site / page).read_text(encoding="utf-8"), name
    assert 'fetch("search/search_index.json")' in (site / "index.html").read_text(encoding="utf-8")
    assert found["shd_shadow_create"] == "c/shadow_8h.html?shd_shadow_create"
    assert '<a href="../shadows.html">Shadows</a>' in (site / "c/shadow_8h.html").read_text(encoding="utf-8")
    assert "c/shadow_8h.html#" in (site / "shadows.html").read_text(encoding="utf-8")


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    checks = (check_extras, check_figures, check_faults, check_pages, check_site)
    for check in checks:
        check(folder / check.__name__)
    print(f"docs.site: {len(checks)} checks")


main()
