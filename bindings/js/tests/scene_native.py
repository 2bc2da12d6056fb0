# SPDX-License-Identifier: MIT
"""Draws the models of scene_files.mjs with libshd_scene of this machine, and prints the hashes of the pictures.

SHD_LIBRARY is the path of libshd, NODE the program node.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "python"))
import shd

MODELS = ["model.glb", "external.gltf", "moving.gltf", "square.obj"]


def fnv(data):
    value = 0xcbf29ce484222325
    for byte in data:
        value = ((value ^ byte) * 0x100000001b3) & 0xffffffffffffffff
    return f"{value:016x}"


def hash_of(context, scene):
    """As hashOf() of scene_files.mjs."""
    framebuffer = shd.Framebuffer(context, 96, 64, sample_count=4)
    center = (np.array(scene.info["bounds_min"]) + np.array(scene.info["bounds_max"])) / 2
    camera = scene.cameras[0] if scene.cameras else {"eye": [1, 1.5, 3], "target": center}
    sun = shd.Light(context, kind="directional", direction=[-0.5, -1, -2], intensity=[2, 2, 2])
    shd.render(context, framebuffer, scene.draws, lights=scene.lights or [sun], camera=camera,
               clear_color=[0.1, 0.2, 0.3, 1])
    return fnv(framebuffer.read_color("rgba8_srgb").tobytes())


def main():
    context = shd.Context(worker_count=1)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([os.environ.get("NODE", "node"), HERE / "scene_files.mjs", folder], check=True)
        for model in MODELS:
            print(model, hash_of(context, shd.Scene(context, str(folder / model))))
        print("pose", hash_of(context, shd.Scene(context, str(folder / "moving.gltf")).pose("slide", 1.5)))


if __name__ == "__main__":
    main()
