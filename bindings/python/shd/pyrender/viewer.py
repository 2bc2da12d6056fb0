# SPDX-License-Identifier: MIT
"""Classes of pyrender that need a window or OpenGL. Programs may import them; their use raises an error with advice."""


class Viewer:
    """pyrender's window, which shd does not have."""

    advice = ("shd opens no window. OffscreenRenderer(640, 480).render(scene) gives the picture; notebooks show a "
              "shd.Renderer")

    def __init__(self, *arguments, **values):
        raise NotImplementedError(f"{type(self).__name__}: {self.advice}")


class Renderer(Viewer):
    """pyrender's renderer of OpenGL, which shd does not have."""

    advice = "shd has no OpenGL: OffscreenRenderer has the same render(scene, flags)"
