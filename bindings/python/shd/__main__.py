# SPDX-License-Identifier: MIT
"""Commands of the package.

    python -m shd [render] [picture.png] [--size W H]   renders a torus with a checkered texture
    python -m shd compare A.png B.png [-o map.png]      compares two pictures
    python -m shd golden [FOLDER] [--update]            lists results of failed golden tests, or accepts them
"""
import argparse
import pathlib
import sys

import numpy as np

import shd
from shd import _commands, _png


def picture(width, height, sample_count=4):
    """A torus with a checkered texture, as sRGB pixels [height][width][4]."""
    with shd.Context() as context:
        cells = (np.indices((64, 64)) // 8).sum(axis=0) % 2
        texels = np.where(cells[..., np.newaxis], np.uint8([230, 220, 200, 255]), np.uint8([40, 90, 150, 255]))
        texture = shd.Texture(context, texels, srgb=True, tables="mipmap")
        sampler = shd.Sampler(context, filter="anisotropic", wrap_u="repeat", wrap_v="repeat")
        material = shd.Material(context, model="blinn_phong", ambient_share=0.2, slots=[
            shd.slot("diffuse", texture, sampler, uv_transform=(8, 0, 0, 0, 4, 0))])
        torus = shd.Mesh.shape(context, kind="torus")
        sun = shd.Light(context, kind="directional", direction=(-0.4, -0.7, -0.6))
        framebuffer = shd.Framebuffer(context, width, height, sample_count=sample_count)
        camera = shd.Camera(eye=(0, 2.2, 2.6), target=(0, 0, 0), fov_y=0.7)
        shd.render(context, framebuffer, [shd.Draw(mesh=torus, material=material, cull="back")], camera=camera,
                   lights=[sun], clear_color=(0.05, 0.06, 0.08, 1))
        return framebuffer.read_color("rgba8_srgb")


def render(arguments):
    parser = argparse.ArgumentParser(prog="python -m shd", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("picture", nargs="?", default="shd.png", type=pathlib.Path)
    parser.add_argument("--size", nargs=2, type=int, default=(320, 240), metavar=("WIDTH", "HEIGHT"))
    options = parser.parse_args(arguments)
    try:
        options.picture.write_bytes(_png.encode(picture(*options.size)))
    except (shd.Error, OSError) as problem:
        print(f"shd: {problem}", file=sys.stderr)
        return 1
    print(f"{options.picture}: {options.size[0]} x {options.size[1]} pixels")
    return 0


COMMANDS = {"render": render, "compare": _commands.compare, "golden": _commands.golden}


def main(arguments=None):
    arguments = sys.argv[1:] if arguments is None else list(arguments)
    if arguments and arguments[0] in COMMANDS:
        return COMMANDS[arguments[0]](arguments[1:])
    return render(arguments)


if __name__ == "__main__":
    sys.exit(main())
