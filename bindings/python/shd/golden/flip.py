# SPDX-License-Identifier: MIT
"""The FLIP map of two pictures.

Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild, "FLIP: A Difference Evaluator for Alternating
Images" (2020); for linear pictures without a largest value: Andersson, Nilsson, Shirley, Akenine-Moeller, "Visualizing
Errors in Rendered High Dynamic Range Images" (2021). Numbers of sections and equations are those of the first paper.
"""
import math

import numpy as np

from .._srgb import decode, encode
from .filters import feature_length, gaussian_sum

# A display of 3840 pixels on 0.7 m, seen from 0.7 m (section 3).
PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * math.pi / 180
COLOUR_EXPONENT, FEATURE_EXPONENT = 0.7, 0.5  # q_c and q_f
KNEE_AT, KNEE = 0.4, 0.95  # p_c and p_t: a colour difference of p_c * c_max becomes p_t
# Contrast sensitivity: Gaussians of weight a and width b for Y, Cx and Cz (table 1).
SENSITIVITY = (((1, 0.0047),), ((1, 0.0053),), ((34.1, 0.04), (13.5, 0.025)))


def _rgb_to_xyz():
    """Linear sRGB to XYZ over the white point: (1, 1, 1) becomes (1, 1, 1). White is D65 of CIE 15 (2004)."""
    xy = np.array([(0.64, 0.33), (0.30, 0.60), (0.15, 0.06), (0.31271, 0.32902)])
    xyz = np.column_stack([xy[:, 0], xy[:, 1], 1 - xy.sum(axis=1)]).T / xy[:, 1]
    primaries, white = xyz[:, :3], xyz[:, 3]
    return primaries * np.linalg.solve(primaries, white) / white[:, np.newaxis]


RGB_TO_XYZ = _rgb_to_xyz()
# XYZ to YCxCz, and with the cube root in between to L*a*b*; both subtract 16 from the first component.
OPPONENT = np.array([(0.0, 116, 0), (500, -500, 0), (0, 200, -200)])
OFFSET = np.array([16.0, 0, 0])
TO_YCXCZ = OPPONENT @ RGB_TO_XYZ
FROM_YCXCZ = np.linalg.inv(TO_YCXCZ)


def hunt_lab(linear):
    """L*a*b* of linear sRGB, with a* and b* scaled by lightness (Hunt effect, section 4.1.2)."""
    delta = 6 / 29
    xyz = linear @ RGB_TO_XYZ.T
    root = np.where(xyz > delta ** 3, np.cbrt(xyz), xyz / (3 * delta * delta) + 4 / 29)
    lab = root @ OPPONENT.T - OFFSET
    lab[..., 1:] *= 0.01 * lab[..., :1]
    return lab


def hyab(first, second):
    """HyAB distance: of lightness by its absolute value, of chroma by its length (section 4.1.2)."""
    difference = first - second
    return np.abs(difference[..., 0]) + np.hypot(difference[..., 1], difference[..., 2])


# c_max: green and blue have the largest distance of all colours of sRGB.
LARGEST = float(hyab(*hunt_lab(np.array([(0.0, 1, 0), (0.0, 0, 1)])))) ** COLOUR_EXPONENT


def redistribute(distance):
    """Distances as numbers in [0, 1]: large ones are compressed (section 4.1.3)."""
    power, knee = distance ** COLOUR_EXPONENT, KNEE_AT * LARGEST
    return np.where(power < knee, power * (KNEE / knee), KNEE + (power - knee) / (LARGEST - knee) * (1 - KNEE))


def _perceived(ycxcz, pixels_per_degree):
    """What is left of a picture at this distance, as Hunt-adjusted L*a*b* (section 4.1.1)."""
    radius = math.ceil(3 * math.sqrt(SENSITIVITY[2][0][1] / (2 * math.pi ** 2)) * pixels_per_degree)
    scaled = [[(a * math.sqrt(math.pi / b), b / (2 * math.pi ** 2) * pixels_per_degree ** 2) for a, b in channel]
              for channel in SENSITIVITY]
    filtered = np.stack([gaussian_sum(ycxcz[..., c], scaled[c], radius) for c in range(3)], axis=-1)
    return hunt_lab(np.clip((filtered + OFFSET) @ FROM_YCXCZ.T, 0, 1))


def _feature_difference(first, second, pixels_per_degree):
    """Difference of edges and points in luminance (section 4.2)."""
    first, second = (first + 16) / 116, (second + 16) / 116
    differences = [np.abs(feature_length(first, pixels_per_degree, kind) -
                          feature_length(second, pixels_per_degree, kind)) for kind in ("edge", "point")]
    return (np.maximum(*differences) / math.sqrt(2)) ** FEATURE_EXPONENT


def flip(reference, picture, pixels_per_degree=PIXELS_PER_DEGREE):
    """The FLIP map [height][width] in [0, 1] of two pictures [height][width][3] of sRGB-coded numbers in [0, 1]."""
    if not (0.1 <= pixels_per_degree <= 1000):
        raise ValueError(f"pixels_per_degree: {pixels_per_degree} is not in 0.1..1000")
    both = [decode(p) @ TO_YCXCZ.T - OFFSET for p in (reference, picture)]
    colour = redistribute(hyab(*(_perceived(p, pixels_per_degree) for p in both)))
    feature = _feature_difference(both[0][..., 0], both[1][..., 0], pixels_per_degree)
    return np.clip(colour, 0, 1) ** (1 - np.clip(feature, 0, 1))  # rounding may leave [0, 1] by the last bit


# Narkowicz, "ACES Filmic Tone Mapping Curve" (2016), with its exposure of 0.6 taken out:
# (a x^2 + b x) / (c x^2 + d x + e)
TONE = (0.36 * 2.51, 0.6 * 0.03, 0.36 * 2.43, 0.6 * 0.59, 0.14)
DISPLAYED = 0.85  # tone-mapped luminance of the brightest, and of the median pixel, at the ends of the exposures


def tone_map(linear):
    a, b, c, d, e = TONE
    return np.clip((a * linear * linear + b * linear) / (c * linear * linear + d * linear + e), 0, 1)


def exposures(reference):
    """Exposures [stops] in which a linear picture is compared, after section 3 of the paper of 2021."""
    luminance = reference @ np.array([0.2126, 0.7152, 0.0722])
    positive = luminance[luminance > 0]
    if not positive.size:
        return np.zeros(1)
    a, b, c, d, e = TONE
    p, q = (b - d * DISPLAYED) / (a - c * DISPLAYED), -e * DISPLAYED / (a - c * DISPLAYED)
    shown = -p / 2 + math.sqrt(p * p / 4 - q)  # tone_map(shown) = DISPLAYED
    median = np.median(luminance) or np.median(positive)
    start, stop = math.log2(shown / luminance.max()), math.log2(shown / median)
    return np.linspace(start, stop, max(2, math.ceil(stop - start)))


def flip_hdr(reference, picture, pixels_per_degree=PIXELS_PER_DEGREE):
    """The largest FLIP over several exposures of two pictures [height][width][3] of linear numbers; negative ones are
    black."""
    reference, picture = np.maximum(reference, 0), np.maximum(picture, 0)
    return np.max([flip(encode(tone_map(reference * 2.0 ** stops)),
                        encode(tone_map(picture * 2.0 ** stops)), pixels_per_degree)
                   for stops in exposures(reference)], axis=0)
