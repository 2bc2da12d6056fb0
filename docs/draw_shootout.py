#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/pictures/shootout.png from a report of shd-shootout: the top of the page, and one plot with names.

    draw_shootout.py [REPORT.html [PICTURE.png]] [--workload NAME] [--texture NAME]

Needs Chromium (Debian: chromium-headless-shell or chromium).
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT = 900, 880
# Side of the name, and its distance below the point, in units of a plot of 300 x 200.
NAMED = {"nearest_mip": ["right", 5], "bilinear_mip": ["left", -2], "trilinear": ["right", 7], "ripmap": ["right", 2],
         "ewa_16": ["over", -4], "one_level_8": ["left", 0], "one_level_16": ["left", 0], "anisotropic_16": ["left", 0],
         "OpenImageIO_anisotropic_16": ["over", -4], "llvmpipe_anisotropic_16": ["right", 5]}

STYLE = """<style>
  body { zoom: 1; } header { padding-top: 20px; } nav, #missing, #footer, #front-misses, #front-table, main > section,
  #plots > p, #plots .controls label, .stamp { display: none !important; }
  #plots { display: block !important; padding: 6px 0 0; border: 0; } #plots h2 { display: none; }
  .plots { display: block; } .plots svg { width: 100%; } .legend { font-size: 16px; }
  figcaption, figcaption b { font-size: 16px; font-weight: 400; color: var(--soft); }
  .plots svg text { font-size: 5.4px; } .plots svg polyline { stroke-width: 0.9; } .plots svg .axis { stroke-width: 0.4; }
  .plots svg text.name { fill: var(--ink); paint-order: stroke; stroke: #fff; stroke-width: 1.4; }
</style>"""

SCRIPT = """<script>
const shown = SHOWN;
const wait = setInterval(() => {
  if (document.body.dataset.ready !== 'yes') return;
  clearInterval(wait);
  const w = data.workloads.findIndex((item) => item.name === shown.workload);
  const t = data.textures.findIndex((item) => item.name === shown.texture);
  if (w < 0 || t < 0) { document.body.textContent = 'no such workload or texture'; return; }
  document.querySelector('header').append(document.querySelector('#front-verdict'));
  const grid = document.querySelector('#plot-grid');
  grid.replaceChildren();
  plot(w, t, 'texels', measures[0], grid);
  grid.querySelector('figcaption').append(data.textures[t].title + '; PSNR in dB, up and to the left is better');
  const points = pointsOf(w, t, 'texels', measures[0]);
  grid.querySelectorAll('circle').forEach((dot, i) => {
    dot.setAttribute('r', 2.2);
    const [side, below] = shown.named[points[i].setting.name] || [];
    if (!side) return;
    const x = +dot.getAttribute('cx') + { left: -4, over: 0, right: 4 }[side], y = +dot.getAttribute('cy') + below;
    const anchor = { left: 'end', over: 'middle', right: 'start' }[side];
    const name = svg('text', { class: 'name', x, y, 'text-anchor': anchor }, dot.parentNode);
    name.textContent = points[i].setting.title.replace(/, at most (\\d+) texels/, ', $1 texels');
  });
}, 20);
</script>"""


def find_browser():
    browser = shutil.which("chromium-headless-shell") or shutil.which("chromium")
    if not browser:
        sys.exit("draw_shootout.py: Chromium is missing (Debian: chromium-headless-shell)")
    return browser


def draw(report, picture, shown):
    text = report.read_text(encoding="utf-8")
    if "<!-- style -->" in text or "</body>" not in text:
        sys.exit(f"draw_shootout.py: {report} is not a report of shd-shootout")
    page = text.replace("</head>", STYLE + "</head>", 1)
    page = page.replace("</body>", SCRIPT.replace("SHOWN", json.dumps(shown)) + "</body>", 1)
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "report.html"
        source.write_text(page, encoding="utf-8")
        picture.unlink(missing_ok=True)
        subprocess.run([find_browser(), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                        f"--user-data-dir={folder}/profile", f"--window-size={WIDTH},{HEIGHT}",
                        "--virtual-time-budget=30000", f"--screenshot={picture.resolve()}", source.as_uri()],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300, check=False)
    if not picture.exists():
        sys.exit("draw_shootout.py: Chromium made no picture")
    print(f"{picture}: {picture.stat().st_size} bytes")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path, nargs="?", default=ROOT / "out/shootout/shootout.html")
    parser.add_argument("picture", type=pathlib.Path, nargs="?", default=ROOT / "docs/pictures/shootout.png")
    parser.add_argument("--workload", default="floor_45")
    parser.add_argument("--texture", default="checker")
    options = parser.parse_args()
    if not options.report.is_file():
        sys.exit(f"draw_shootout.py: {options.report} is missing; examples/shootout.sh makes it")
    draw(options.report, options.picture, {"workload": options.workload, "texture": options.texture, "named": NAMED})


if __name__ == "__main__":
    main()
