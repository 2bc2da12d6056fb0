# SPDX-License-Identifier: MIT
"""Pictures of differences."""
import numpy as np

from .._srgb import encode
from . import flip as _flip
from .picture import coded

# Colours of FLIP values 0, 1/5, ..., 1: black, blue, violet, red, orange, light yellow; lightness grows.
HEAT = np.array([(0, 0, 0), (40, 30, 130), (135, 40, 150), (215, 65, 70), (250, 165, 40), (255, 255, 215)]) / 255
GAP = 4  # grey columns between the pictures


def heat(values):
    """Colours [height][width][3] of uint8 for numbers [height][width] in [0, 1]."""
    places = np.linspace(0, 1, len(HEAT))
    colours = np.stack([np.interp(values, places, HEAT[:, c]) for c in range(3)], axis=-1)
    return np.rint(colours * 255).astype(np.uint8)


def _shown(picture, hdr, scale):
    """A picture as [height][width][3] of uint8; alpha is shown over a grey."""
    if hdr:
        picture = encode(_flip.tone_map(np.maximum(picture.astype(np.float64), 0) * scale))
    picture = coded(picture)
    colour = picture[..., :3] if picture.shape[2] >= 3 else np.repeat(picture[..., :1], 3, axis=2)
    if picture.shape[2] in (2, 4):
        colour = colour * picture[..., -1:] + 0.5 * (1 - picture[..., -1:])
    return np.rint(colour * 255).astype(np.uint8)


def side_by_side(difference):
    """Reference, picture and FLIP map side by side. Without a map, as for pictures of other shapes, the first two."""
    scale = 1.0
    if difference.hdr:
        linear = np.maximum(difference.reference[..., :3].astype(np.float64), 0)
        scale = 2.0 ** float(np.median(_flip.exposures(linear)))
    parts = [_shown(p, difference.hdr, scale) for p in (difference.reference, difference.picture)]
    if not difference.mismatch:
        parts.append(heat(difference.flip))
    height, gap = max(p.shape[0] for p in parts), np.full((1, GAP, 3), 128, np.uint8)
    columns = []
    for part in parts:
        column = np.full((height, part.shape[1], 3), 128, np.uint8)
        column[:part.shape[0]] = part
        columns += [np.repeat(gap, height, axis=0), column]
    return np.concatenate(columns[1:], axis=1)
