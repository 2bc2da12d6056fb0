# SPDX-License-Identifier: MIT
"""What two pictures differ in, and tolerances."""
import functools

import numpy as np

from . import flip as _flip
from .picture import as_picture, coded

# tolerance: (attribute of Difference, description)
TOLERANCES = {
    "max_abs": ("max_abs", "largest difference of a value"),
    "max_rms": ("rms", "RMS of the differences"),
    "max_pixels": ("pixels", "number of pixels that differ"),
    "max_flip": ("max_flip", "largest FLIP of a pixel"),
    "max_mean_flip": ("mean_flip", "mean FLIP"),
}


def _opaque(picture, backdrop):
    """[height][width][3] of coded numbers: grey levels three times, and colours with alpha over a grey backdrop."""
    channels = picture.shape[2]
    colour = picture if channels >= 3 else np.repeat(picture[..., :1], 3, axis=2)
    if channels in (1, 3):
        return colour
    alpha = picture[..., -1:]
    return colour[..., :3] * alpha + backdrop * (1 - alpha)


class Difference:
    """Differences of a picture from a reference of the same shape and type.

    max_abs and rms have the unit of the values: 0..255 for uint8. FLIP is computed when it is first read; its
    values lie in [0, 1]. Pictures with alpha are compared over black and over white, and the larger FLIP counts.
    """

    def __init__(self, reference, picture, pixels_per_degree=_flip.PIXELS_PER_DEGREE, hdr=False):
        self.reference, self.picture = as_picture(reference, "reference"), as_picture(picture, "picture")
        self.pixels_per_degree, self.hdr = pixels_per_degree, hdr
        self.mismatch = self._mismatch()
        if not self.mismatch:
            wide = np.float64 if self.picture.dtype.kind == "f" else np.int64
            delta = self.picture.astype(wide) - self.reference.astype(wide)
            self.max_abs = float(np.abs(delta).max())
            self.rms = float(np.sqrt(np.mean(np.square(delta, dtype=np.float64))))
            self.pixels = int(np.count_nonzero(delta.any(axis=2)))

    def _mismatch(self):
        """Why the pictures cannot be compared, or an empty text."""
        for what, got, want in (("shape", self.picture.shape, self.reference.shape),
                                ("type", self.picture.dtype, self.reference.dtype)):
            if got != want:
                return f"the {what} is {got}, and that of the reference is {want}"
        return ""

    @functools.cached_property
    def flip(self):
        """The FLIP map [height][width]."""
        if self.mismatch:
            raise ValueError(self.mismatch)
        if self.hdr:
            if self.picture.dtype.kind != "f" or self.picture.shape[2] != 3:
                raise ValueError("hdr: needs pictures [height][width][3] of linear floating-point numbers")
            return _flip.flip_hdr(self.reference.astype(np.float64), self.picture.astype(np.float64),
                                  self.pixels_per_degree)
        both = coded(self.reference, "reference"), coded(self.picture, "picture")
        backdrops = (0, 1) if self.picture.shape[2] in (2, 4) and any(p[..., -1].min() < 1 for p in both) else (0,)
        return np.max([_flip.flip(*(_opaque(p, backdrop) for p in both), self.pixels_per_degree)
                       for backdrop in backdrops], axis=0)

    @property
    def max_flip(self):
        return float(self.flip.max())

    @property
    def mean_flip(self):
        return float(self.flip.mean())

    def exceeded(self, **tolerances):
        """Texts about the tolerances (see TOLERANCES) that are exceeded. Without one, pictures must be equal."""
        given = {name: limit for name, limit in tolerances.items() if limit is not None}
        for name, limit in given.items():
            if name not in TOLERANCES:
                raise TypeError(f"{name} is not a tolerance: {', '.join(TOLERANCES)}")
            if not limit >= 0:
                raise ValueError(f"{name}: {limit} is not a number of at least 0")
        if self.mismatch:
            return [self.mismatch]
        found = []
        for name, limit in (given or {"max_pixels": 0}).items():
            attribute, text = TOLERANCES[name]
            value = getattr(self, attribute)
            if not value <= limit:
                found.append(f"{text} is {value:.6g}, more than {limit:g} ({name})")
        return found

    def __str__(self):
        if self.mismatch:
            return self.mismatch
        total = self.picture.shape[0] * self.picture.shape[1]
        return (f"largest difference {self.max_abs:.6g}, RMS {self.rms:.6g}, {self.pixels} of {total} pixels differ, "
                f"FLIP largest {self.max_flip:.6f}, mean {self.mean_flip:.6f}")


def compare(reference, picture, pixels_per_degree=_flip.PIXELS_PER_DEGREE, hdr=False):
    """The Difference of two pictures: arrays [height][width][channels], or paths of PNG files."""
    return Difference(reference, picture, pixels_per_degree, hdr)
