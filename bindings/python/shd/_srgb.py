# SPDX-License-Identifier: MIT
"""Codes of sRGB, 0..1, and linear light (IEC 61966-2-1)."""
import numpy as np


def decode(codes):
    """Codes to linear light."""
    codes = np.asarray(codes, np.float64)
    return np.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)


def encode(linear):
    """Linear light to codes."""
    linear = np.asarray(linear, np.float64)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
