# SPDX-License-Identifier: MIT
"""Separable filters of pictures [height][width]; beyond the border lie copies of the border."""
import numpy as np

BLOCK = 1 << 14  # numbers that are filtered together: all that is read and written then fits in a cache
FEATURE_WIDTH = 0.082  # of the edge detector of human vision, peak to trough [degrees]


def _along(picture, weights, axis):
    """Correlation with an odd number of weights along one axis."""
    radius, (height, width) = len(weights) // 2, picture.shape
    padded = np.pad(picture, [(radius, radius) if a == axis else (0, 0) for a in (0, 1)], mode="edge")
    total = np.zeros_like(picture)
    rows = max(1, BLOCK // width)
    term = np.empty((min(rows, height), width))
    for top in range(0, height, rows):
        out = total[top:top + rows]
        for i, weight in enumerate(weights):
            down, across = (i, 0) if axis == 0 else (0, i)
            source = padded[top + down:top + down + len(out), across:across + width]
            out += np.multiply(source, weight, out=term[:len(out)])
    return total


def separable(picture, down, across):
    """Correlation with the matrix down[y] * across[x]."""
    return _along(_along(picture, across, 1), down, 0)


def gaussian_sum(picture, terms, radius):
    """Correlation with a sum of Gaussians weight * exp(-r^2 / (2 variance)), cut to a square and normalised to 1."""
    offsets = np.arange(-radius, radius + 1.0)
    total, sum_of_weights = 0, 0
    for weight, variance in terms:
        bell = np.exp(-offsets ** 2 / (2 * variance))
        weight *= bell.sum() ** 2
        bell /= bell.sum()
        total = total + weight * separable(picture, bell, bell)
        sum_of_weights += weight
    return total / sum_of_weights


def feature_length(luminance, pixels_per_degree, kind):
    """Length of the first (edge) or second (point) derivatives along x and y of the smoothed picture. Positive weights
    have the sum 1, and negative ones the sum -1."""
    deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree
    radius = int(np.ceil(3 * deviation))
    offsets = np.arange(-radius, radius + 1.0)
    bell = np.exp(-offsets ** 2 / (2 * deviation ** 2))
    derivative = bell * (-offsets if kind == "edge" else (offsets / deviation) ** 2 - 1)
    positive = derivative > 0
    derivative[positive] /= derivative[positive].sum()
    derivative[~positive] /= -derivative[~positive].sum()
    bell /= bell.sum()
    return np.hypot(separable(luminance, bell, derivative), separable(luminance, derivative, bell))
