#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program for pyrender that runs with shd: a picture of a model, and its depths. README.md has the changed lines.

    offscreen.py [model] [picture.png]
"""
import sys

import numpy as np
import numpy.typing as npt

import shd.pyrender as pyrender
from shd import save_png

PATH = "/usr/share/assimp/models/Collada/duck.dae"  # Debian: assimp-testmodels
PICTURE = "offscreen.png"


def pose_towards(eye: npt.NDArray[np.float64], target: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Camera to world: z away from the target, y up."""
    z = np.subtract(eye, target) / np.linalg.norm(np.subtract(eye, target))
    x = np.cross([0, 1, 0], z)
    x /= np.linalg.norm(x)
    pose = np.eye(4)
    pose[:3] = np.stack([x, np.cross(z, x), z, eye], axis=1)
    return pose


def main(path: str = PATH, picture: str = PICTURE) -> None:
    model = pyrender.load(path)
    mesh = pyrender.Mesh.from_trimesh(model)
    scene = pyrender.Scene(ambient_light=[0.1, 0.1, 0.1])
    scene.add(mesh)

    eye = mesh.centroid + mesh.scale * np.array([0.7, 0.3, 0.8])
    pose = pose_towards(eye, mesh.centroid)
    scene.add(pyrender.PerspectiveCamera(yfov=np.pi / 4, aspectRatio=1.0), pose=pose)
    lamp = pyrender.SpotLight(color=np.ones(3), intensity=12 * mesh.scale ** 2, innerConeAngle=np.pi / 12,
                              outerConeAngle=np.pi / 5)
    scene.add(lamp, pose=pose)

    renderer = pyrender.OffscreenRenderer(400, 400)
    color, depth = renderer.render(scene)
    renderer.delete()

    seen = depth[depth > 0]
    print(f"{picture}: {color.shape[1]} x {color.shape[0]} pixels, depths {seen.min():.2f} to {seen.max():.2f}")
    shades = np.where(depth > 0, 255 * (depth - seen.min()) / np.ptp(seen), 255)  # near ones are dark
    grey = np.repeat(shades.astype(np.uint8)[..., np.newaxis], 3, axis=2)
    save_png(picture, np.concatenate([color, grey], axis=1))


if __name__ == "__main__":
    main(*sys.argv[1:])
