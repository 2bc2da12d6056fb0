# SPDX-License-Identifier: MIT
"""Programs with mistakes: `mypy --strict` finds each of the lines with a comment, and no others."""
import numpy as np

import shd
import shd.pyrender as pyrender
from shd import golden


def mistakes(context: shd.Context, framebuffer: shd.Framebuffer, texture: shd.Texture, renderer: shd.Renderer) -> None:
    shd.Sampler(context, fliter="ewa")                      # fliter
    shd.Sampler(context, filter="ewwa")                     # Literal
    shd.Sampler(filter="ewa")                               # context
    shd.SamplerDesc(max_anisotropy="large")                 # max_anisotropy
    shd.SamplerDesc(wrap_u="mirrored")                      # Literal
    shd.SamplerDesc().max_anisotropy = "large"              # expression has type "str"
    shd.Texture(context, "wood.png")                        # "Texture" has incompatible type "str"
    shd.Texture(context, np.zeros((2, 2)), table="mipmap")  # table
    shd.Mesh(context, np.zeros((3, 3)), uvs=np.zeros((3, 2)))  # uvs
    shd.Mesh(context, shd.Sampler(context))                 # incompatible type "Sampler"
    shd.Light(context, kind="sun")                          # Literal
    shd.Material(context, model="phongg")                   # Literal
    shd.slot("colour", texture)                             # Literal
    shd.slot("diffuse", shd.Sampler(context))               # incompatible type "Sampler"
    shd.render(context, framebuffer, light=[])              # light
    shd.render(framebuffer, context)                        # incompatible type "Framebuffer"
    shd.Draw(cull="both")                                   # Literal
    texture.sample(shd.Sampler(context), [0.5], [0.5], dx=[0.5])  # No overload variant
    texture.info["widht"]                                   # widht
    texture.info["width"].upper()                           # upper
    framebuffer.plane("distance")                           # Literal
    framebuffer.read_colour()                               # read_colour
    shd.Context(log=3)                                      # incompatible type "int"
    renderer.add("model.glb", light=True)                   # No overload variant
    renderer.render(shadow=True)                            # shadow
    renderer.render(fill="wires")                           # Literal
    renderer.look_at(eye=(0, 0, 1), fov=1)                  # fov
    shd.Scene(context, 3)                                   # incompatible type "int"
    shd.io.load(context, "a.png", flags=1.5)                # incompatible type "float"
    shd.io.save(framebuffer, "a.png", ditter="ordered")     # No overload variant
    shd.Color(context).views(3)                             # incompatible type "int"
    golden.Store("golden").check("a.png", "a", max_flop=1)  # max_flop
    pyrender.PerspectiveCamera()                            # yfov
    pyrender.PerspectiveCamera(1.0, aspect=2.0)             # aspect
    pyrender.Mesh.from_trimesh("model.obj")                 # from_trimesh
    pyrender.MetallicRoughnessMaterial(alphaMode="ADD")     # Literal
    pyrender.Scene().bg_colour = [0.0, 0.0, 0.0]            # bg_colour
    pyrender.Scene().add(context)                           # incompatible type "Context"
