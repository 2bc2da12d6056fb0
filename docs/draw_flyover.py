#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/pictures/flyover-memory.svg from the CSV file of examples/apps/flyover: memory, and tiles that were loaded.

    draw_flyover.py FLYOVER.csv [PICTURE.svg]
"""
import csv
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 720, 320, 64, 70, 36, 44
MIB = 1 << 20
LINES = [("rss_bytes", "#1f6f8b", "resident set of the process"), ("resident_bytes", "#3a9d5d", "tiles in memory")]


def step_for(limit):
    """A step of 1, 2 or 5 times a power of ten that divides an axis into at most six parts."""
    step = 1
    while True:
        for factor in (1, 2, 5):
            if limit / (step * factor) <= 6:
                return step * factor
        step *= 10


def text(x, y, words, anchor="middle", fill="#333"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{fill}">{words}</text>'


def polyline(points, color):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>'


def draw(rows):
    frames = [float(row["frame"]) for row in rows]
    budget = float(rows[0]["budget_bytes"]) / MIB
    loaded = [float(row["loaded_tiles"]) for row in rows]
    top = 1.1 * max([budget] + [float(row["rss_bytes"]) / MIB for row in rows])
    top_loaded = 1.1 * max(loaded)

    def x_of(frame):
        return LEFT + (WIDTH - LEFT - RIGHT) * frame / max(frames[-1], 1)

    def y_of(value, limit):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * value / limit

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
           'font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    step = step_for(top)
    for value in range(0, int(top) + 1, step):
        y = y_of(value, top)
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>')
        out.append(text(LEFT - 6, y + 4, value, "end"))
    for value in range(0, int(top_loaded) + 1, step_for(top_loaded)):
        out.append(text(WIDTH - RIGHT + 6, y_of(value, top_loaded) + 4, value, "start", "#b4572b"))
    for frame in range(0, int(frames[-1]) + 1, step_for(max(frames[-1], 1))):
        out.append(text(x_of(frame), HEIGHT - BOTTOM + 18, frame))
    out.append(f'<path d="M{LEFT} {y_of(budget, top):.1f}H{WIDTH - RIGHT}" stroke="#c0392b" stroke-dasharray="6 4"/>')
    for name, color, _ in LINES:
        points = [(x_of(f), y_of(float(row[name]) / MIB, top)) for f, row in zip(frames, rows)]
        out.append(polyline(points, color))
    out.append(polyline([(x_of(f), y_of(n, top_loaded)) for f, n in zip(frames, loaded)], "#b4572b"))
    out.append(text(WIDTH / 2, HEIGHT - 8, "frame"))
    out.append(text(LEFT - 6, 16, "MiB", "end"))
    x = LEFT + 10
    for color, words in [(line[1], line[2]) for line in LINES] + [("#c0392b", "budget"),
                                                                  ("#b4572b", "tiles loaded so far (right axis)")]:
        out.append(f'<rect x="{x}" y="8" width="10" height="10" fill="{color}"/>')
        out.append(text(x + 14, 17, words, "start"))
        x += 30 + 6.6 * len(words)
    return "\n".join(out + ["</svg>", ""])


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    picture = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs/pictures/flyover-memory.svg"
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        sys.exit(f"draw_flyover.py: {sys.argv[1]} has no frames")
    picture.write_text(draw(rows), encoding="utf-8")
    print(f"{picture}: {picture.stat().st_size} bytes")


if __name__ == "__main__":
    main()
