# SPDX-License-Identifier: MIT
"""Attributes whose values are checked when they are set, and the checks of the classes of shd.pyrender."""
import math

import numpy as np

from .._array import check_range


class Checked:
    """An attribute. `check` is a function (object, value, name) -> the value that is stored.

    An object with the attribute `version` counts its changes there.
    """

    def __init__(self, check, doc=""):
        self._check, self.__doc__ = check, doc

    def __set_name__(self, owner, name):
        self._name = name

    def __get__(self, instance, owner=None):
        if instance is None:
            return self
        try:
            return instance.__dict__["_" + self._name]
        except KeyError:
            raise AttributeError(f"{type(instance).__name__} has no {self._name} yet") from None

    def __set__(self, instance, value):
        instance.__dict__["_" + self._name] = self._check(instance, value, self._name)
        instance.__dict__["version"] = instance.__dict__.get("version", 0) + 1


class Shown:
    """Objects whose texts have their numbers and names."""

    def _texts(self):
        return [f"{name[1:]}={value:g}" if isinstance(value, float) else f"{name[1:]}={value!r}"
                for name, value in self.__dict__.items() if name[0] == "_" and isinstance(value, (float, str))]

    def __repr__(self):
        return f"<{' '.join([f'shd.pyrender.{type(self).__name__}', *self._texts()])}>"


def anything(_, value, name):
    return value


def text(_, value, name):
    return None if value is None else str(value)


def number(low, high=math.inf, optional=False, or_equal=True):
    """Numbers from `low`, or above it, to `high`."""
    def check(_, value, name):
        if value is None and optional:
            return None
        try:
            made = float(value)
        except (OverflowError, TypeError, ValueError):
            raise TypeError(f"{name}: a number, not {value!r}") from None
        if not (low <= made if or_equal else low < made) or not made <= high:
            least = f"{low:g}.." if or_equal else f"above {low:g}, at most "
            raise ValueError(f"{name}: {made:g} is not {'in ' if or_equal else ''}{least}{high:g}")
        return made
    return check


def whole(low, high):
    """Whole numbers from `low` to `high`."""
    def check(_, value, name):
        made = number(-math.inf)(_, value, name)
        if not low <= made <= high or made != int(made):
            raise ValueError(f"{name}: {made:g} is not a whole number in {low}..{high}")
        return int(made)
    return check


def finite(array, name):
    """An array whose numbers are finite."""
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise ValueError(f"{name}: a number is not finite")
    return array


def codes(value, name):
    """Numbers 0..255 as uint8."""
    check_range(finite(value, name), 255, name)
    return value.astype(np.uint8)


def instance_of(kind, noun):
    """Objects of a class, or None."""
    def check(_, value, name):
        if value is not None and not isinstance(value, kind):
            raise TypeError(f"{name}: {noun}, not {type(value).__name__}")
        return value
    return check


def color(count, default=None):
    """Colours of `count` numbers: one number for all, integers 0..255, floats, an absent opacity is 1."""
    def check(_, value, name):
        if value is None:
            if default is None:
                raise ValueError(f"{name}: {count} numbers, not None")
            value = np.full(count, float(default))
        array = np.asarray(value)
        if array.dtype.kind not in "fiu" or array.squeeze().ndim > 1 or not array.size:
            raise ValueError(f"{name}: {count} numbers, not {value!r}")
        made = array.reshape(-1) / (255 if array.dtype.kind in "iu" else 1)
        made = np.full(count, made[0]) if not array.ndim else made[:count]
        return np.append(made, np.ones(count - made.size)).astype(np.float32)
    return check


def vector(count, unit=False):
    """Arrays of `count` numbers."""
    def check(_, value, name):
        array = np.array(value, np.float64)
        if array.shape != (count,):
            raise ValueError(f"{name}: {count} numbers, not an array of shape {array.shape}")
        if unit and abs(np.linalg.norm(array) - 1) > 1e-3:
            raise ValueError(f"{name}: its length is {np.linalg.norm(array):g}, not 1")
        return array
    return check


class Boxed:
    """Measures of objects with `bounds`, the lowest and the highest x, y, z."""

    @property
    def centroid(self):
        """Centre of the bounds."""
        return self.bounds.mean(axis=0)

    @property
    def extents(self):
        """Lengths of the sides of the bounds."""
        return np.diff(self.bounds, axis=0).reshape(-1)

    @property
    def scale(self):
        """Length of the diagonal of the bounds."""
        return float(np.linalg.norm(self.extents))


def bounds_of(points):
    """Lowest and highest coordinates of points [n][3]; zeros without points."""
    return np.array([points.min(axis=0), points.max(axis=0)]) if len(points) else np.zeros((2, 3))


def unit(vectors):
    """Vectors [n][3] as those of length 1; zeros stay zeros."""
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-30)


def face_normals(corners):
    """Unit normals of triangles [n][3][3], zeros for those without area."""
    return unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
