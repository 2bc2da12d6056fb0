# SPDX-License-Identifier: MIT
"""Draws the picture of the playground's test with libshd of this machine, and compares the hash of the pixels.

    playground_native.py SCENE.json     SHD_LIBRARY is the path of libshd
"""
import base64
import json
import pathlib
import re
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import shd


def snake(values):
    """Fields of a desc with the names of C."""
    return {re.sub(r"[A-Z]", lambda m: "_" + m[0].lower(), key): value for key, value in values.items()}


def fnv(data):
    value = 0xcbf29ce484222325
    for byte in data:
        value = ((value ^ byte) * 0x100000001b3) & 0xffffffffffffffff
    return f"{value:016x}"


def draw(scene, texels):
    context = shd.Context(worker_count=1)
    side = int(len(texels) / 4) ** 0.5
    pixels = np.frombuffer(texels, np.uint8).reshape(int(side), int(side), 4)
    texture = shd.Texture(context, pixels, srgb=True, tables="mipmap")
    lights = [shd.Light(context, **light) for light in scene["lights"]]
    framebuffer = shd.Framebuffer(context, scene["width"], scene["height"], sample_count=scene["samples"],
                                  color_format="rgba8_srgb")
    edges = [0, scene["splitAt"], scene["width"]]
    picture = np.empty((scene["height"], scene["width"], 4), np.uint8)
    for left, right, options in zip(edges, edges[1:], scene["samplers"]):
        sampler = shd.Sampler(context, **snake(options))
        draws = []
        for one in scene["draws"]:
            material = dict(one["material"])
            slot = shd.slot("diffuse", texture, sampler, uv_transform=material.pop("uvTransform"))
            draws.append(shd.Draw(mesh=shd.Mesh.shape(context, **snake(one["mesh"])),
                                  material=shd.Material(context, slots=[slot], **snake(material)),
                                  object_to_world=one["objectToWorld"]))
        shd.render(context, framebuffer, draws, lights=lights, camera=snake(scene["camera"]),
                   clear_color=scene["clearColor"])
        picture[:, left:right] = framebuffer.read_color("rgba8_srgb")[:, left:right]
    return picture


def main(path):
    stored = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    got = fnv(draw(stored["scene"], base64.b64decode(stored["texels"])).tobytes())
    print(f"browser {stored['hash']}, library {got}")
    return int(got != stored["hash"])


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
