# SPDX-License-Identifier: MIT
"""shd-render: what --show, --zoom and --compare draw, by its meaning. Planes of --aovs say what the colours must be.

Usage: check_shd_render_show.py SHD-RENDER FOLDER"""
import os
import re
import shutil
import subprocess
import sys
from collections import Counter

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from exr import Exr  # noqa: E402

RENDER, FOLDER = sys.argv[1:3]
POSITIONS = {1: [(0.5, 0.5)], 4: [(0.375, 0.125), (0.875, 0.375), (0.125, 0.625), (0.625, 0.875)]}


def run(*args):
    return subprocess.run([RENDER, *args], capture_output=True, check=False, text=True)


def draw(*args):
    """A picture and what was said on standard error."""
    result = run(*args, "-o", "picture.exr")
    assert result.returncode == 0, (args, result.stderr)
    return Exr("picture.exr"), result.stderr


def refused(text, *args, code=2):
    result = run(*args)
    assert result.returncode == code and text in result.stderr, (args, code, text, result)


def rgb(exr, x, y):
    return tuple(exr.channels[c][y][x] for c in "RGB")


def pixels(exr):
    """(x, y) of all pixels that show the model."""
    return [(x, y) for y in range(exr.height) for x in range(exr.width) if exr.channels["A"][y][x] > 0]


def near(a, b, tolerance=2e-3):
    return all(abs(p - q) <= tolerance for p, q in zip(a, b))


def numbers(text):
    return [float(n) for n in re.findall(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?", text)]


ONE = ("--samples", "1", "--size", "64x48")


def check_depth():
    scene = (*ONE, "--shape", "torus", "--orbit", "30,20")
    planes, _ = draw(*scene)
    shown, said = draw(*scene, "--show", "depth")
    places = pixels(shown)
    assert places == pixels(planes) and len(places) > 400
    z = {at: planes.channels["Z"][at[1]][at[0]] for at in places}
    low, high = min(z.values()), max(z.values())
    assert near(numbers(said), (low, high), 0.01), said
    for at in places:
        wanted = (1 - 0.9 * (z[at] - low) / (high - low)) ** 2.2
        assert near(rgb(shown, *at), [wanted] * 3, 0.01), (at, rgb(shown, *at), wanted)
    behind, _ = draw(*scene, "--show", "depth", "--background", "0.1,0.2,0.6")
    assert near(rgb(behind, 0, 0), (0.1, 0.2, 0.6)) and rgb(behind, *places[0]) == rgb(shown, *places[0])


def check_position():
    scene = (*ONE, "--shape", "sphere", "--orbit", "30,20")
    planes, _ = draw(*scene, "--aovs", "position")
    shown, _ = draw(*scene, "--show", "position")
    for x, y in pixels(shown):  # a ball of radius 1
        wanted = [(planes.channels[c][y][x] + 1) / 2 for c in ("P.x", "P.y", "P.z")]
        assert near(rgb(shown, x, y), wanted), (x, y, rgb(shown, x, y), wanted)


def check_overdraw():
    """A closed convex body covers each of its pixels twice; the triangles of the cycle lie alone or in pairs."""
    shown, said = draw(*ONE, "--shape", "box", "--show", "overdraw")
    assert "up to 2 fragments of a pixel, 2.00 where" in said, said
    assert len({rgb(shown, *at) for at in pixels(shown)}) == 1
    first = None
    for visibility in ("depth", "painter"):  # hidden fragments count
        shown, said = draw(*ONE, "--shape", "cycle", "--show", "overdraw", "--visibility", visibility)
        colors = Counter(rgb(shown, *at) for at in pixels(shown))
        (_, single), (_, double) = colors.most_common()
        mean = numbers(said.split("pixel,")[1])[0]
        assert single > double and abs(mean - (single + 2 * double) / (single + double)) < 0.006, (colors, said)
        first = first or colors
        assert colors == first
    shown, _ = draw("--size", "64x48", "--shape", "cycle", "--show", "overdraw")
    assert len({rgb(shown, *at) for at in pixels(shown)}) > 4, "samples are not averaged"


def check_levels():
    scene = (*ONE, "--shape", "plane", "--texture", "checker", "--uv-scale", "3", "--orbit", "20,12")
    planes, _ = draw(*scene, "--aovs", "level")
    nearest, _ = draw(*scene, "--show", "level-nearest")
    smooth, said = draw(*scene, "--show", "level")
    color = {}
    for x, y in pixels(nearest):
        level, lod = planes.channels["level"][y][x], planes.channels["lod"][y][x]
        assert abs(level - lod) <= 0.501
        assert color.setdefault(level, rgb(nearest, x, y)) == rgb(nearest, x, y), "a level has two colours"
    assert len(set(color.values())) == len(color) >= 3, color
    lods = []
    for x, y in pixels(smooth):
        lod = planes.channels["lod"][y][x]
        lods.append(lod)
        low, part = int(lod), lod - int(lod)
        if low in color and low + 1 in color:
            wanted = [(1 - part) * a + part * b for a, b in zip(color[low], color[low + 1])]
            assert near(rgb(smooth, x, y), wanted, 4e-3), (lod, rgb(smooth, x, y), wanted)
    assert near(numbers(said), (min(lods), max(lods)), 0.01), said


def is_hue(color, channel):
    return all(color[channel] > 1.5 * color[c] + 0.05 for c in range(3) if c != channel)


def check_tangents():
    """A wall that is seen from the front and a little from the left: u is to the right, v falls upwards."""
    scene = ("--size", "96x96", "--shape", "plane", "--orbit", "0,89", "--model", "unlit", "--diffuse", "1")
    shown, _ = draw(*scene, "--show", "tangents", "--show-step", "32")
    plain, _ = draw(*scene)
    assert is_hue(rgb(shown, 48 + 10, 48), 0), "u is not to the right"
    assert is_hue(rgb(shown, 48, 48 - 10), 1), "v does not fall upwards"
    assert sum(rgb(shown, *at) != rgb(plain, *at) for at in pixels(plain)) > 300
    assert rgb(shown, 32, 32) == rgb(plain, 32, 32), "there are axes between those of the grid"
    refused("--show-step is for --show tangents and footprint", "--show-step", "8")
    refused("4..4096 pixels", "--show", "tangents", "--show-step", "2")


def check_footprints():
    above = (*ONE, "--shape", "plane", "--texture", "checker", "--orbit", "0,90")
    planes, _ = draw(*above, "--aovs", "derivatives")
    texels = 256 * planes.channels["uv.dudx"][24][32]
    _, said = draw(*above, "--show", "footprint", "--show-step", "8")
    major = numbers(said.split("major")[1])
    assert near(major, (texels, texels, texels, texels, 1, 1), 1e-2), (said, texels)
    low = (*ONE, "--shape", "plane", "--texture", "checker", "--orbit", "0,12")
    shown, said = draw(*low, "--show", "footprint", "--show-step", "4", "--uv-scale", "2")
    ratios = numbers(said.split("ratios")[1])
    assert 3 < ratios[0] <= ratios[1] < 20, said
    plain, _ = draw(*low, "--uv-scale", "2")
    assert any(rgb(shown, *at) != rgb(plain, *at) for at in pixels(plain))
    refused("no place of the grid shows a texture", "--show", "footprint", code=3)
    refused("not of --uv triplanar", "--show", "footprint", "--texture", "checker", "--uv", "triplanar")
    refused("needs a texture, not a --solid", "--show", "footprint", "--solid", "wood")


def check_layout():
    """Four squares of two triangles over the texture: their corners and edges are orange, the rest is the texture."""
    shown, _ = draw("--size", "200x200", "--shape", "plane", "--tessellation", "2", "--texture", "checker", "--show",
                    "uv-layout")
    orange = rgb(shown, 100, 100)
    assert orange[0] > 0.9 and orange[2] < 0.1, orange
    for at in ((100, 60), (60, 100), (53, 53)):  # two sides and the diagonal, but not the texture beside them
        assert rgb(shown, *at)[0] > 2 * rgb(shown, *at)[2], (at, rgb(shown, *at))
        assert rgb(shown, at[0] + 5, at[1] - 5)[0] < 2 * rgb(shown, at[0] + 5, at[1] - 5)[2]
    place = lambda u, v: rgb(shown, int(6 + 188 * u), int(6 + 188 * v))  # 94 percent of the picture
    assert is_hue(place(0.15, 0.05), 0) and is_hue(place(0.94, 0.04), 2), "the texture is not under the triangles"
    assert shown.channels["A"][2][2] == 0
    outside, _ = draw("--size", "200x200", "--shape", "plane", "--tessellation", "2", "--texture", "checker", "--show",
                      "uv-layout", "--uv-scale", "0.5")
    quarter = rgb(outside, 40, 10), rgb(outside, 160, 130)
    assert outside.channels["A"][130][160] == 1 and max(quarter[1]) < 0.4, "texels without triangles are not darker"


def check_terms():
    for model in ("blinn-phong", "phong", "lambert", "blinn-phong-normalized", "combined"):
        scene = (*ONE, "--model", model, "--texture", "checker")
        plain, _ = draw(*scene)
        shown, _ = draw(*scene, "--show", "terms")
        assert shown.width == 4 * 64 + 3 * 4, shown.width
        sums = [0.0, 0.0, 0.0]
        for x, y in pixels(plain):
            panels = [rgb(shown, x + 68 * k, y) for k in range(4)]
            for k in range(3):
                sums[k] += sum(panels[k])
            total = rgb(plain, x, y)
            assert near(panels[3], total, 1e-3 * max(*total, 1)), (model, x, y)
            assert near([sum(p[c] for p in panels[:3]) for c in range(3)], total, 4e-3 * max(*total, 1)), (model, panels)
        assert sums[0] > 0 and sums[1] > 0 and (sums[2] > 0) == (model != "lambert"), (model, sums)
    refused("the model has no terms that add up", "--show", "terms", "--model", "gooch")
    refused("not of an --environment", "--show", "terms", "--environment", "sky.exr")


def check_cycle():
    """The painter's algorithm fails at one corner; with cuts, it is right."""
    def differing(a, b):
        shown, _ = draw(*ONE, "--shape", "cycle", "--compare", f"visibility={a}:visibility={b}", "--difference")
        return sum(max(rgb(shown, x, y)) > 0.05 for y in range(48) for x in range(136, 200))

    assert differing("painter", "depth") > 20
    assert differing("newell", "depth") <= 4


def check_zoom():
    """The corner of a triangle: pixels keep their colours, and a dot is filled where its sample is covered."""
    for samples in (1, 4):
        scene = ("--samples", str(samples), "--size", "640x480", "--shape", "cycle")
        whole, _ = draw(*scene, "--background", "0.8")
        cover, _ = draw(*scene)
        zoom, _ = draw(*scene, "--background", "0.8", "--zoom", "224,76,8")
        assert zoom.width == zoom.height == 480, (zoom.width, zoom.height)
        partly = 0
        for y in range(8):
            for x in range(8):
                at = 220 + x, 72 + y
                block = Counter(rgb(zoom, 60 * x + i, 60 * y + j) for j in range(1, 60) for i in range(1, 60))
                assert block.most_common(1)[0][0] == rgb(whole, *at), (at, block.most_common(2), rgb(whole, *at))
                filled = sum(max(rgb(zoom, int(60 * (x + px)), int(60 * (y + py)))) < 0.01
                             for px, py in POSITIONS[samples])
                alpha = cover.channels["A"][at[1]][at[0]]
                assert abs(filled / samples - alpha) < 1e-3, (at, filled, alpha)
                partly += 0 < filled
        assert 0 < partly < 64, partly
    refused("outside of the picture", "--zoom", "960,1,8")
    refused("outside of the picture", "--zoom", "1,1,641")
    refused("X,Y,N", "--zoom", "1,1")
    refused("X,Y,N", "--zoom", "1,1,0")
    refused("enlarges pixels of one view", "--zoom", "1,1,8", "--show", "terms")


def check_compare():
    scene = (*ONE, "--shape", "plane", "--texture", "checker", "--uv-scale", "4", "--background", "0.3")
    a, _ = draw(*scene, "--filter", "nearest")
    b, _ = draw(*scene, "--filter", "ewa", "--orbit", "10,15", "--floor")
    both, said = draw(*scene, "--compare", "filter=nearest:filter=ewa,orbit=10,15,floor", "--difference")
    assert (both.width, both.height) == (3 * 64 + 2 * 4, 48)
    most, factor = numbers(said)
    assert most > 0.1, said
    for y in range(48):
        for x in range(64):
            assert rgb(both, x, y) == rgb(a, x, y) and rgb(both, x + 68, y) == rgb(b, x, y), (x, y)
            wanted = [factor * abs(p - q) for p, q in zip(rgb(a, x, y), rgb(b, x, y))]
            assert near(rgb(both, x + 136, y), wanted, 3e-3 * factor), (x, y)
    none, said = draw(*scene, "--compare", ":samples=1", "--difference")
    assert "largest difference 0, " in said, said
    assert all(rgb(none, x, y) == (0, 0, 0) for y in range(48) for x in range(136, 200))
    three, _ = draw(*scene, "--compare", "--filter=nearest:show=depth:light=1,2,3:8,8,8:samples=4")
    assert three.width == 4 * 64 + 3 * 4
    assert all(rgb(three, x, y) == rgb(a, x, y) for y in range(48) for x in range(64))
    lit, _ = draw(*scene, "--light", "1,2,3:8,8,8")
    assert all(rgb(three, x + 136, y) == rgb(lit, x, y) for y in range(48) for x in range(64))
    zoomed, _ = draw(*scene, "--compare", "filter=nearest:filter=ewa", "--zoom", "32,24,4")
    assert (zoomed.width, zoomed.height) == (2 * 48 + 4, 48)
    for text, *options in (
            ("is one setting", "filter=ewa"), ("--difference is of two settings", "samples=1:samples=2:samples=4", "--difference"),
            ("did you mean filter?", "filtre=ewa:samples=1"), ("one of trilinear", "filter=ewe:filter=ewa"),
            ("--compare: --size is the same for all pictures", "size=1x1:samples=1"),
            ("--compare: --floor takes no value", "floor=yes:samples=1"),
            ("--compare: --samples needs a value", "samples:samples=1"),
            ("takes one view", "orbit=1,1,orbit=2,2:samples=1"), ("not from standard input", ":samples=1", "-"),
            ("planes of a frame", ":samples=1", "--aov", "-o", "a.exr"),
            ("wider than 16000", ":samples=1", "--size", "9000x10")):
        refused(text, "--compare", *options)
    refused("--difference needs --compare", "--difference")


def check_others():
    plain, _ = draw(*ONE)
    none, _ = draw(*ONE, "--show", "none")
    assert plain.channels == none.channels
    for view in ("depth", "overdraw", "tangents", "uv-layout", "terms"):
        refused("--show shows surfaces, not a --volume", "--show", view, "--volume", "a.vdb")
    refused("planes of a frame", "--show", "depth", "--aovs", "uv", "-o", "a.exr")
    refused("more than 16384", "--show", "level", "--size", "8192x8", "--supersampling", "4")
    large, _ = draw(*ONE, "--shape", "cycle", "--show", "overdraw", "--supersampling", "2")
    assert len({rgb(large, *at) for at in pixels(large)}) > 2, "parts of pixels are not averaged"
    for text, *options in (("change a --solid", "--solid-octaves", "2"),
                           ("has no noise", "--solid", "checker", "--solid-octaves", "2"),
                           ("not for worley", "--solid", "worley", "--solid-turbulence"),
                           ("not for value", "--solid", "value", "--solid-table"),
                           ("not for simplex", "--solid", "simplex", "--solid-fade", "cubic"),
                           ("1..32", "--solid", "perlin", "--solid-octaves", "33"),
                           ("one of quintic", "--solid", "perlin", "--solid-fade", "round")):
        refused(text, *options)
    hashes = {run(*ONE, "--show", "footprint", "--texture", "checker", "--hash", "--threads", threads).stdout
              for threads in "14"}
    assert len(hashes) == 1, hashes


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    os.chdir(FOLDER)
    for check in (check_depth, check_position, check_overdraw, check_levels, check_tangents, check_footprints,
                  check_layout, check_terms, check_cycle, check_zoom, check_compare, check_others):
        check()
        print(check.__name__)
    print("shd-render: all checks of views passed")


main()
