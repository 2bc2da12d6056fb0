# SPDX-License-Identifier: MIT
"""What other programs make for the pages: the report of the filter shoot-out, the playground and the figures.

The report is linked from its page. The playground needs shd.wasm, the figures shd-figures.wasm, and both the files that
the build of these modules generates. Each page of a filter that the playground has then shows that filter, and each
<shd-figure name="NAME">text</shd-figure> of a page becomes the figure bindings/js/figures/NAME.js; otherwise its text
stays.
"""
import posixpath
import re
import shutil

COMPARED = {"anisotropic": "trilinear", "ewa": "anisotropic"}  # with the first of these filters; others with anisotropic
EMBED = """<div class="playground" markdown="0">
<p>The playground: {title} left of the divider, {other} right of it. <a href="{address}">Open it in a page of its own</a>.</p>
<iframe src="{address}" title="Playground: {title}" loading="lazy"></iframe>
</div>

"""
REPORT = "shootout-report.html"
LINK = f"[The report]({REPORT}) has pictures under a wipe and every figure.\n\n"
FIGURE = re.compile(r'<shd-figure name="([^"]*)">')
IMPORT = re.compile(r'^(?:import|export) .*?from "(\.[^"]+)";$', re.M | re.S)
MAIN = "figures/shd-figure.js"


class SiteError(Exception):
    pass


def choose(option, default):
    """The file that is there: that of an option, or the default; else None."""
    if option and not option.is_file():
        raise SiteError(f"{option} is not there")
    return option or (default if default.is_file() else None)


def insert_before(page, heading, text):
    """Writes `text` before a heading of a page."""
    old = page.read_text(encoding="utf-8")
    if old.count(f"\n{heading}\n") != 1:
        raise SiteError(f"{page.name}: no heading {heading}")
    page.write_text(old.replace(f"\n{heading}\n", f"\n{text}{heading}\n"), encoding="utf-8")


def title(name):
    return "EWA" if name == "ewa" else name.replace("_", " ")


def add_report(stage, report):
    shutil.copyfile(report, stage / REPORT)
    insert_before(stage / "shootout.md", "## How to read the page", LINK)


def playground_filters(state):
    """The names of filters in the playground's list of settings."""
    names = re.search(r"^const FILTERS = \[(.*?)\];", state, re.S | re.M)
    if not names:
        raise SiteError("state.js has no list FILTERS")
    return re.findall(r'"(\w+)"', names[1])


def add_playground(stage, source, module):
    for name in ("api.js", "index.js"):
        if not (source / "lib" / name).is_file():
            raise SiteError(f"{source / 'lib' / name} is not there; cmake --build --preset wasm makes it")
    shutil.copytree(source / "playground", stage / "playground")
    shutil.copytree(source / "lib", stage / "lib")
    shutil.copyfile(module, stage / "lib/shd.wasm")
    for name in playground_filters((source / "playground/state.js").read_text(encoding="utf-8")):
        other = COMPARED.get(name, "anisotropic")
        address = f"playground/index.html#texture=checker&amp;a.filter={name}&amp;b.filter={other}"
        text = EMBED.format(title=title(name), other=title(other), address=address)
        insert_before(stage / f"filter-{name.replace('_', '-')}.md", "## Error", text)


def modules_of(folder, names):
    """Modules of a folder and all modules that they import, as paths from the folder."""
    found, waiting = [], [*names]
    while waiting:
        name = waiting.pop(0)
        if name in found:
            continue
        found.append(name)
        imports = IMPORT.findall((folder / name).read_text(encoding="utf-8"))
        waiting += [posixpath.normpath(posixpath.join(posixpath.dirname(name), other)) for other in imports]
    return found


def figures_of(page, source):
    """The names of the figures on a page."""
    names = FIGURE.findall(page.read_text(encoding="utf-8"))
    for name in names:
        if not re.fullmatch("[a-z-]+", name) or not (source / f"figures/{name}.js").is_file():
            raise SiteError(f"{page.name}: no figure {name}")
    return names


def add_figures(stage, source, module):
    """The scripts of the figures on all pages that have some; a browser loads them together. After add_playground()."""
    shutil.copytree(source / "figures", stage / "figures")
    shutil.copyfile(module, stage / "figures/shd-figures.wasm")
    for page in sorted(stage.glob("*.md")):
        if names := figures_of(page, source):
            modules = modules_of(stage, [MAIN, *(f"figures/{name}.js" for name in names)])
            scripts = [f'<link rel="modulepreload" href="{name}">' for name in modules]
            scripts.append(f'<script type="module" async src="{MAIN}"></script>')
            with page.open("a", encoding="utf-8") as file:
                file.write("\n" + "\n".join(scripts) + "\n")
