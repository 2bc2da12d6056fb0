# SPDX-License-Identifier: MIT
"""Cameras of the renderer: poses, projections with fitted planes, and distances from depths."""
import ctypes
import math

import numpy as np

from . import _api
from ._array import array_of
from ._convert import address
from ._desc import desc_type

NEAR = 0.05     # near plane without a model to fit it to
NEAREST = 1e-4  # least near plane, as a part of the farthest distance


def matrix(value, name="pose"):
    """A 4 x 4 matrix of finite numbers, whose last row is 0, 0, 0, 1."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.shape != (4, 4):
        raise ValueError(f"{name}: a matrix [4][4], not {array.dtype} of shape {array.shape}")
    array = array.astype(np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: a number is not finite")
    if np.abs(array[3] - (0, 0, 0, 1)).max() > 1e-6:
        raise ValueError(f"{name}: the last row is {array[3].tolist()}, not 0, 0, 0, 1")
    return array


def point(value, name):
    """Three numbers."""
    array = array_of(value, name)
    if array.dtype.kind not in "fiu" or array.size != 3:
        raise ValueError(f"{name}: three numbers, not {array.dtype} of shape {array.shape}")
    return array.astype(np.float64).reshape(3)


def look_at(eye, target=(0, 0, 0), up=(0, 1, 0)):
    """The pose of a camera, from its place and the place that it looks at."""
    eye, target, up = (point(v, f"camera.{name}") for v, name in ((eye, "eye"), (target, "target"), (up, "up")))
    back = eye - target
    right = np.cross(up, back)
    if not (np.isfinite(right).all() and np.linalg.norm(back) > 0 and np.linalg.norm(right) > 0):
        raise ValueError(f"camera: eye {eye.tolist()} and target {target.tolist()} must differ, not along up")
    back /= np.linalg.norm(back)
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :4] = np.stack([right, np.cross(back, right), back, eye], axis=1)
    return pose


def framed(bounds, direction, up, yfov, aspect):
    """Eye and target of a camera whose picture a box fills, seen from a direction."""
    camera = desc_type("shd_camera")(eye=direction, target=(0, 0, 0), up=up, fov_y=yfov, aspect=aspect).build([])
    low, high = np.float32(bounds)
    _api.check(_api.lib.shd_camera_frame_box(ctypes.addressof(camera), address(low), address(high)))
    return np.float64(camera.eye), np.float64(camera.target)


class Lens:
    """A projection. `rows` is a function (width, height) -> the first two rows of its matrix."""

    def __init__(self, rows, perspective=True, near=None, far=None):
        for name, value in (("near", near), ("far", far)):
            if value is not None and not (0 < value < math.inf or (name == "far" and value == math.inf)):
                raise ValueError(f"camera.{name}: {value} is not above 0")
        if near is not None and far is not None and far <= near:
            raise ValueError(f"camera.far: {far} is not above near, {near}")
        self.rows, self.is_perspective, self.near, self.far = rows, perspective, near, far

    def fit(self, distances):
        """Near and far plane around (nearest, farthest) distances along the view, inside the planes of the camera."""
        nearest, farthest = distances
        near = max(self.near or 0.0, 0.99 * nearest, NEAREST * farthest if farthest > 0 else NEAR)
        far = self.far or math.inf
        if not self.is_perspective:
            far = min(far, max(1.01 * farthest, 2 * near))
        return (near, far) if near < far else (near, 2 * near)

    def matrix(self, width, height, near, far):
        """View to clip space, depth 1 near to 0 far: floats are denser near 0, where depths change least."""
        made = np.zeros((4, 4))
        made[:2] = self.rows(width, height)
        if not self.is_perspective:
            made[2, 2:], made[3, 3] = (1 / (far - near), far / (far - near)), 1
        elif far == math.inf:
            made[2, 3], made[3, 2] = near, -1
        else:
            made[2, 2:], made[3, 2] = (near / (far - near), near * far / (far - near)), -1
        return made

    def distances(self, depth, near, far):
        """Distances along the view [world units] from depths; 0 for the background, whose depth is 0."""
        exact = depth.astype(np.float64)
        if not self.is_perspective:
            found = far - exact * (far - near)
        else:
            inverse_far = 1 / far
            found = 1 / np.maximum(exact * (1 / near - inverse_far) + inverse_far, 1e-30)
        return np.where(depth > 0, found, 0).astype(np.float32)


def perspective(yfov, aspect=None, near=None, far=None):
    """A lens with a vertical field of view [rad]; the aspect is that of the picture by default."""
    if not 0 < yfov < math.pi:
        raise ValueError(f"camera.yfov: {yfov} is not in (0, pi)")
    if aspect is not None and not 0 < aspect < math.inf:
        raise ValueError(f"camera.aspect: {aspect} is not above 0")
    scale = 1 / math.tan(yfov / 2)
    return Lens(lambda width, height: [[scale / (aspect or width / height), 0, 0, 0], [0, scale, 0, 0]], True,
                near, far)


def orthographic(half_height, near=None, far=None):
    """A parallel projection; `half_height` is half of the height of the picture [world units]."""
    if not 0 < half_height < math.inf:
        raise ValueError(f"camera.half_height: {half_height} is not above 0")
    return Lens(lambda width, height: [[height / (width * half_height), 0, 0, 0], [0, 1 / half_height, 0, 0]],
                False, near, far)


def intrinsics(fx, fy, cx, cy, near=None, far=None):
    """A pinhole camera from focal lengths and the principal point [pixels], as of calibrations with y downwards."""
    if not (fx > 0 and fy > 0):
        raise ValueError(f"camera: focal lengths {fx} and {fy} are not above 0")
    return Lens(lambda width, height: [[2 * fx / width, 0, 1 - 2 * cx / width, 0],
                                       [0, 2 * fy / height, 2 * cy / height - 1, 0]], True, near, far)
