#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures and inputs of pictures for the pages of the course (course.md).

    course_pictures.py SUBJECT [ARGUMENT...] [-o FILE]

| subject | file |
|---|---|
| magnify FILTER... | a texture of 8 x 8 texels, enlarged by each filter; bicubic kernels as bicubic:b-spline |
| wrap | a texture between -0.5 and 1.5, by each of five wraps |
| triangle | the three coordinates of a triangle, and their lines |
| noise KIND... | squares of noise: the keys of NOISES |
| heights, normals | a height map of bricks, and its normal map |
| sky | an environment in latitude and longitude (.hdr) |
| cloud | 48 x 48 x 48 densities of 8 bits (.raw) |
"""
import argparse
import ctypes

import numpy as np

import shd
from shd import _api, _image

TILE, GAP = 150, 6


def codes(linear):
    """sRGB codes of linear light (IEC 61966-2-1)."""
    linear = np.clip(linear, 0, 1)
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.floor(255 * encoded + 0.5).astype(np.uint8)


def grey(values):
    return np.floor(255 * np.clip(values, 0, 1) + 0.5).astype(np.uint8)


def row_of(tiles):
    """Pictures side by side, with white between them."""
    gap = np.full((*tiles[0].shape[:1], GAP, *tiles[0].shape[2:]), 255, np.uint8)
    return np.concatenate([part for tile in tiles for part in (gap, tile)][1:], axis=1)


def centres(count, low=0.0, high=1.0):
    at = (low + (np.arange(count) + 0.5) / count * (high - low)).astype(np.float32)
    return np.meshgrid(at, at)


def magnify(context, names):
    """A small face, as texels of sRGB."""
    rows = ("..BBBB..", ".BYYYYB.", "BYKYYKYB", "BYYYYYYB", "BYKYYKYB", "BYYKKYYB", ".BYYYYB.", "..BBBB..")
    palette = {".": (235, 240, 245), "B": (30, 80, 150), "Y": (250, 205, 60), "K": (20, 20, 30)}
    texture = shd.Texture(context, np.uint8([[palette[c] for c in row] for row in rows]), srgb=True)
    u, v = centres(TILE)
    tiles = []
    for name in names or ["nearest", "bilinear", "bicubic"]:
        kind, _, cubic = name.partition(":")
        more = {"cubic": cubic.replace("-", "_")} if cubic else {}
        sampler = shd.Sampler(context, filter=kind.replace("-", "_"), wrap_u="clamp", wrap_v="clamp", **more)
        tiles.append(codes(texture.sample(sampler, u, v, channels=3)))
    return row_of(tiles)


def wrap(context, _):
    y, x = np.indices((32, 32))
    texels = np.stack([64 + 6 * x, 64 + 4 * y, 90 + 120 * ((x // 4 + y // 4) % 2)], axis=-1).astype(np.uint8)
    texture = shd.Texture(context, texels, srgb=True)
    u, v = centres(TILE, -0.5, 1.5)
    samplers = [shd.Sampler(context, filter="bilinear", wrap_u=name, wrap_v=name, border=(0.8, 0.8, 0.8, 1))
                for name in ("repeat", "mirror", "clamp", "border")]
    return row_of([codes(texture.sample(sampler, u, v, channels=3)) for sampler in samplers])


def triangle(context, _):
    """Each coordinate from blue at 0 to yellow at 1, with a line at each tenth; white outside."""
    x, y = centres(TILE)
    corners = [(0.08, 0.9), (0.92, 0.78), (0.42, 0.08)]
    weights = shd.evaluate_polygon(context, corners, np.stack([x, y], axis=-1), kind="wachspress")
    points = weights @ np.float32(corners)
    inside = np.abs(points - np.stack([x, y], axis=-1)).max(axis=-1) < 1e-4
    tiles = []
    for k in range(3):
        w = weights[..., k]
        tenth = np.floor(10 * w + 0.5)
        line = (tenth != np.roll(tenth, 1, 0)) | (tenth != np.roll(tenth, 1, 1))
        ramp = np.float32([20, 40, 130]) + w[..., None] * np.float32([225, 160, -100])
        ramp[line | ~inside] = 255
        tiles.append(np.floor(ramp + 0.5).astype(np.uint8))
    return row_of(tiles)


def bricks(size):
    """Heights 0..1: rounded bricks, each row shifted by half a brick."""
    y, x = (np.indices((size, size)) + 0.5) / size
    row = np.floor(4 * y)
    edge = np.minimum(np.abs((2 * x + 0.5 * row) % 1 - 0.5), 1) * 2, np.abs((4 * y) % 1 - 0.5) * 2
    rise = [np.clip((1 - e) * s, 0, 1) for e, s in zip(edge, (8, 4))]
    return (rise[0] * (2 - rise[0])) * (rise[1] * (2 - rise[1]))


def heights(_context, _):
    return grey(bricks(128))


def normals(context, _):
    """The normal map of the bricks, by shd_mip_build_normals()."""
    keep, out = [], np.empty((128, 128, 3), np.uint8)
    images = [_image.image(image, keep) for image in (bricks(128).astype(np.float32), out)]
    desc = shd.NormalsDesc(scale=5).build(keep)
    _api.check(_api.lib.shd_mip_build_normals(context.handle("shd_context", keep), ctypes.addressof(images[0]),
                                              ctypes.addressof(desc), ctypes.addressof(images[1])))
    return out


NOISES = {
    "value": {"kind": "value"},
    "perlin": {"kind": "perlin"},
    "perlin-linear": {"kind": "perlin", "fade": "linear"},
    "perlin-cubic": {"kind": "perlin", "fade": "cubic", "gradients": "table"},
    "simplex": {"kind": "simplex"},
    "fbm": {"kind": "perlin", "octaves": 6},
    "turbulence": {"kind": "perlin", "octaves": 6, "sum": "turbulence"},
    "marble": {"kind": "marble", "octaves": 6, "distortion": 4.0},
}


def noise(context, names):
    """6 x 6 cells of each kind, from black to white over -0.7..0.7, or 0..1 for kinds of that range."""
    x, y = centres(TILE, 0.0, 6.0)
    tiles = []
    for name in names or ["value", "perlin", "fbm", "turbulence"]:
        value = shd.evaluate_solid(context, np.stack([x, y, np.full_like(x, 0.37)], axis=-1), **NOISES[name])
        tiles.append(grey(value * 1.4 if name == "turbulence" else value if name == "marble" else 0.5 + value / 1.4))
    return row_of(tiles)


def sky(_context, _):
    """Radiance: a blue sky, a dark ground, clouds of noise, and a sun."""
    height, width = 128, 256
    v, u = (np.indices((height, width)) + 0.5) / np.array([height, width])[:, None, None]
    up, around = np.cos(np.pi * v), 2 * np.pi * u
    direction = np.stack([np.sin(np.pi * v) * np.cos(around), up, np.sin(np.pi * v) * np.sin(around)], axis=-1)
    clouds = np.clip(np.sin(9 * direction[..., 0] + 4 * np.sin(7 * direction[..., 2])) - 0.4, 0, 1) * np.clip(3 * up, 0, 1)
    above = np.float64([0.35, 0.55, 1.0]) * (0.4 + 0.6 * (1 - np.abs(up[..., None])))
    radiance = np.where(up[..., None] > 0, above + clouds[..., None] * 0.8, [0.16, 0.13, 0.1])
    sun = np.float64([-0.5, 0.6, 0.62])
    radiance[direction @ (sun / np.linalg.norm(sun)) > 0.985] = [25, 23, 19]
    return radiance


def cloud(context, _):
    """A ball of turbulence."""
    size = 48
    z, y, x = (np.indices((size, size, size)) + 0.5) / size * 2 - 1
    position = np.stack([x, y, z], axis=-1).astype(np.float32)
    turbulence = shd.evaluate_solid(context, position, kind="perlin", octaves=4, size=0.6)
    return grey(np.clip(1.05 - np.sqrt(x * x + y * y + z * z), 0, 1) * np.clip(0.35 + 1.6 * turbulence, 0, 1))


def write_hdr(path, radiance):
    """Radiance RGBE without run lengths (Ward, "Real Pixels", 1991)."""
    mantissa, exponent = np.frexp(np.maximum(radiance.max(axis=-1), 1e-30))
    scaled = np.floor(radiance * (mantissa * 256 / radiance.max(axis=-1))[..., None])
    pixels = np.concatenate([scaled, (exponent + 128)[..., None]], axis=-1).astype(np.uint8)
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % pixels.shape[:2] + pixels.tobytes())


SUBJECTS = {f.__name__: f for f in (magnify, wrap, triangle, noise, heights, normals, sky, cloud)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("subject", choices=SUBJECTS)
    parser.add_argument("arguments", nargs="*")
    parser.add_argument("-o", "--output", default="out.png")
    options = parser.parse_args()
    made = SUBJECTS[options.subject](shd.Context(), options.arguments)
    if options.output.endswith(".hdr"):
        write_hdr(options.output, made)
    elif options.output.endswith(".raw"):
        made.tofile(options.output)
    else:
        shd.save_png(options.output, made)


if __name__ == "__main__":
    main()
