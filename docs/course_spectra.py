#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Filters and their spectra: pictures of the course (course-spectra.md).

    course_spectra.py PATTERN FILTER [-o FILE.png]

A texture of 512 x 512 texels is minified to 128 x 128 pixels. The picture is on the left. On the right is the logarithm
of a spectrum, from -60 dB (black) to 0 dB (white), with frequency 0 in the middle.

- `grating`: stripes of one frequency; the spectrum is that of the pixels, up to half a cycle per pixel.
- `zone`: a zone plate, which has every frequency; the spectrum is that of the filter, up to half a cycle per texel. The
  square is half a cycle per pixel: what is brighter than black outside of it turns into other frequencies.

FILTER is a filter of the library; `texture` is no filter at all; `supersample-2` and `supersample-4` are means of points;
`kernel-box`, `kernel-triangle`, `kernel-kaiser` and `kernel-lanczos` are mip levels made with a kernel.
"""
import argparse
import ctypes

import numpy as np

import shd
from shd import _api, _image

TEXELS, PIXELS, FLOOR_DB, SCALE, GAP = 512, 128, -60.0, 2, 8
STEP = TEXELS // PIXELS  # texels per pixel
GRATING = (150, 40)      # cycles across the texture, along u and v


def zone():
    """exp(i pi r^2 / TEXELS): the frequency grows with the distance r from the middle, and its spectrum is constant."""
    x = np.arange(TEXELS) - TEXELS // 2
    phase = np.pi * (x[None, :] ** 2 + x[:, None] ** 2) / TEXELS
    return np.stack([np.cos(phase), np.sin(phase)], axis=-1).astype(np.float32)


def grating():
    x = np.arange(TEXELS) - TEXELS // 2
    phase = 2 * np.pi * (GRATING[0] * x[None, :] + GRATING[1] * x[:, None]) / TEXELS
    return np.stack([np.cos(phase), np.sin(phase)], axis=-1).astype(np.float32)


def look_up(context, texels, name, step):
    """The texture through a filter whose pixels are STEP texels wide, at each `step`-th texel."""
    texture = shd.Texture(context, texels, tables="mipmap|ripmap|summed_area")
    sampler = shd.Sampler(context, filter=name)
    at = ((np.arange(0, TEXELS, step) + STEP / 2) / TEXELS).astype(np.float32)  # the middles of pixels
    u, v = np.meshgrid(at, at)
    width = np.full(u.shape, STEP / TEXELS, np.float32)
    return texture.sample(sampler, u, v, channels=2, dudx=width, dvdy=width)


def supersample(texels, count, step):
    """The mean of count x count texels in each pixel."""
    rolled = [np.roll(texels, (-(y * STEP // count), -(x * STEP // count)), (0, 1))
              for y in range(count) for x in range(count)]
    return np.mean(rolled, axis=0, dtype=np.float64)[::step, ::step].astype(np.float32)


def build_level(context, texels, kernel):
    """The mip level of PIXELS x PIXELS texels, made from the base."""
    keep, desc = [], shd.MipDesc(kernel=kernel, content="data").build([])
    levels = [np.empty((TEXELS >> i, TEXELS >> i, 2), np.float32) for i in (1, 2)]
    images = (_api.struct_type("shd_image") * len(levels))(*(_image.image(level, keep) for level in levels))
    base = _image.image(texels, keep)
    _api.check(_api.lib.shd_mip_build(context.handle("shd_context", keep), ctypes.addressof(base),
                                      ctypes.addressof(desc), len(levels), ctypes.addressof(images)))
    return levels[-1]


def kernel_of(context, texels, name, step):
    """A level, or with step 1 the levels of all shifts of the texture by texels, woven together."""
    if step == STEP:
        return build_level(context, texels, name)
    out = np.empty_like(texels)
    for y in range(STEP):
        for x in range(STEP):
            out[y::STEP, x::STEP] = build_level(context, np.roll(texels, (-y, -x), (0, 1)), name)
    return out


def filtered(context, texels, name, step):
    kind, _, rest = name.partition("-")
    if kind == "texture":
        return texels
    if kind == "supersample":
        return supersample(texels, int(rest), step)
    if kind == "kernel":
        return kernel_of(context, texels, rest, step)
    return look_up(context, texels, name.replace("-", "_"), step)


def spectrum(values):
    """Decibels of an array [n][n][2] of cosines and sines; frequency 0 in the middle, 0 dB for unit amplitude."""
    transform = np.fft.fftshift(np.fft.fft2(values[..., 0] + 1j * values[..., 1]))
    return 20 * np.log10(np.maximum(np.abs(transform), 1e-30)), len(values)


def grey(values):
    """Codes 0..255 of numbers 0..1."""
    return np.floor(np.clip(values, 0, 1) * 255 + 0.5).astype(np.uint8)


def zone_spectrum(context, texels, name):
    """The response of the filter: every frequency of a zone plate has the magnitude TEXELS."""
    decibels, size = spectrum(filtered(context, texels, name, 1))
    shades = grey(1 - (decibels - 20 * np.log10(size)) / FLOOR_DB)
    shades = shades.reshape(PIXELS, STEP, PIXELS, STEP).max(axis=(1, 3))
    edge = [PIXELS // 2 - PIXELS // (2 * STEP), PIXELS // 2 + PIXELS // (2 * STEP)]
    for k in edge:
        shades[k, edge[0]:edge[1] + 1] = shades[edge[0]:edge[1] + 1, k] = 160
    return shades


def grating_spectrum(values):
    """Both peaks of the cosine as squares of 5 x 5."""
    values = np.stack([values[..., 0], np.zeros_like(values[..., 0])], axis=-1)
    decibels, size = spectrum(values)
    shades = grey(1 - (decibels - 20 * np.log10(size * size / 2)) / FLOOR_DB)
    if size > PIXELS:
        shades = shades.reshape(PIXELS, size // PIXELS, PIXELS, size // PIXELS).max(axis=(1, 3))
    grown = [np.roll(shades, (y, x), (0, 1)) for y in range(-2, 3) for x in range(-2, 3)]
    return np.max(grown, axis=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pattern", choices=("zone", "grating"))
    parser.add_argument("filter")
    parser.add_argument("-o", "--output", default="out.png")
    options = parser.parse_args()
    context = shd.Context()
    texels = zone() if options.pattern == "zone" else grating()
    values = filtered(context, texels, options.filter, STEP)
    picture = grey(0.5 + 0.5 * values[..., 0].astype(np.float64))
    middle = (len(picture) - PIXELS) // 2
    right = zone_spectrum(context, texels, options.filter) if options.pattern == "zone" else grating_spectrum(values)
    picture = picture[middle:middle + PIXELS, middle:middle + PIXELS]
    both = np.hstack([np.kron(part, np.ones((SCALE, SCALE), np.uint8)) for part in (picture, right)])
    both = np.insert(both, [SCALE * PIXELS] * GAP, 255, axis=1)
    shd.save_png(options.output, both)


if __name__ == "__main__":
    main()
