# SPDX-License-Identifier: MIT
"""Cameras of shd.pyrender, which look along the -z axis of their node."""
import math

import numpy as np

from .. import _camera
from ._checked import Checked, Shown, number, text
from .constants import DEFAULT_Z_FAR, DEFAULT_Z_NEAR


def _near(or_equal):
    """Distances of the near plane from 0, or above it, to the far plane."""
    def check(camera, value, name):
        made, far = number(0, or_equal=or_equal)(camera, value, name), getattr(camera, "_zfar", None)
        if far is not None and made >= far:
            raise ValueError(f"znear: {made:g} is not below zfar, {far:g}")
        return made
    return check


def _far(optional):
    """Distances of the far plane, beyond the near plane."""
    def check(camera, value, name):
        made = number(0, optional=optional, or_equal=False)(camera, value, name)
        if made is not None and made <= camera.znear:
            raise ValueError(f"zfar: {made:g} is not above znear, {camera.znear:g}")
        return made
    return check


class Camera(Shown):
    """Base of the cameras."""

    name = Checked(text)
    znear = Checked(_near(or_equal=True), "Distance of the near plane.")
    zfar = Checked(_far(optional=True), "Distance of the far plane; None for none.")

    def __init__(self, znear=DEFAULT_Z_NEAR, zfar=DEFAULT_Z_FAR, name=None):
        self.znear, self.zfar, self.name = znear, zfar, name

    def lens(self):
        """The projection for the renderer of shd."""
        raise NotImplementedError("Camera: PerspectiveCamera, OrthographicCamera or IntrinsicsCamera")

    def get_projection_matrix(self, width=None, height=None):
        """The projection matrix of OpenGL, whose depths are -1..1, for a picture of a size [pixels]."""
        for size, which in ((width, "width"), (height, "height")):
            number(0, optional=True, or_equal=False)(self, size, which)
        lens, near, far = self.lens(), self.znear, self.zfar
        made = np.zeros((4, 4))
        made[:2] = lens.rows(width, height)
        if not lens.is_perspective:
            made[2, 2:], made[3, 3] = (2 / (near - far), (far + near) / (near - far)), 1
        elif far is None:
            made[2, 2:], made[3, 2] = (-1, -2 * near), -1
        else:
            made[2, 2:], made[3, 2] = ((far + near) / (near - far), 2 * far * near / (near - far)), -1
        return made


class PerspectiveCamera(Camera):
    """A camera with a vertical field of view [rad]; without zfar it has no far plane."""

    yfov = Checked(number(0, math.pi, or_equal=False), "Vertical field of view [rad].")
    aspectRatio = Checked(number(0, or_equal=False, optional=True), "Width by height; None for that of the picture.")

    def __init__(self, yfov, znear=DEFAULT_Z_NEAR, zfar=None, aspectRatio=None, name=None):
        super().__init__(znear, zfar, name)
        self.yfov, self.aspectRatio = yfov, aspectRatio

    def lens(self):
        return _camera.perspective(self.yfov, self.aspectRatio, self.znear or None, self.zfar)

    def get_projection_matrix(self, width=None, height=None):
        if self.aspectRatio is None and (width is None or height is None):
            raise ValueError("aspectRatio: None, and no width and height of a picture are given")
        return super().get_projection_matrix(width, height)


class OrthographicCamera(Camera):
    """A parallel projection; ymag is half of the height of the picture, whose aspect decides the width."""

    xmag = Checked(number(0, or_equal=False), "Half of the width of the view, without a picture.")
    ymag = Checked(number(0, or_equal=False), "Half of the height of the view.")
    znear = Checked(_near(or_equal=False), "Distance of the near plane.")
    zfar = Checked(_far(optional=False), "Distance of the far plane.")

    def __init__(self, xmag, ymag, znear=DEFAULT_Z_NEAR, zfar=DEFAULT_Z_FAR, name=None):
        super().__init__(znear, zfar, name)
        self.xmag, self.ymag = xmag, ymag

    def lens(self):
        return _camera.orthographic(self.ymag, self.znear, self.zfar)

    def get_projection_matrix(self, width=None, height=None):
        if width is None or height is None:
            width, height = self.xmag, self.ymag
        return super().get_projection_matrix(width, height)


class IntrinsicsCamera(Camera):
    """A pinhole camera by focal lengths and principal point [pixels]."""

    fx = Checked(number(0, or_equal=False), "Focal length in x [pixels].")
    fy = Checked(number(0, or_equal=False), "Focal length in y [pixels].")
    cx = Checked(number(-math.inf), "Principal point, x [pixels].")
    cy = Checked(number(-math.inf), "Principal point, y from the top [pixels].")

    def __init__(self, fx, fy, cx, cy, znear=DEFAULT_Z_NEAR, zfar=DEFAULT_Z_FAR, name=None):
        super().__init__(znear, zfar, name)
        self.fx, self.fy, self.cx, self.cy = fx, fy, cx, cy

    def lens(self):
        return _camera.intrinsics(self.fx, self.fy, self.cx, self.cy, self.znear or None, self.zfar)

    def get_projection_matrix(self, width, height):
        return super().get_projection_matrix(width, height)
