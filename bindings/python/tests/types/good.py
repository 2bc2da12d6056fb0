# SPDX-License-Identifier: MIT
"""A program that `mypy --strict` accepts: the calls of README.md and of docs/bindings.md with their types."""
import logging
import pathlib
from typing import Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

import shd
import shd.pyrender as pyrender
from shd import golden


def look_up(context: shd.Context) -> npt.NDArray[np.float32]:
    texture = shd.Texture(context, np.zeros((4, 4, 3)), srgb=False, tables="mipmap")
    same = shd.Texture(context, [[0.0, 0.5], [1.0, 0.0]], swizzle=("r", "r", "r", "fill"))
    sampler = shd.Sampler(context, filter="anisotropic", max_anisotropy=8, wrap_u=shd.Wrap.REPEAT)
    u, v = np.zeros(4), [0.0, 0.25, 0.5, 1]
    out = np.zeros((4, 4), np.float32)
    lookup = texture.lookup(sampler, u.astype(np.float32), np.zeros(4, np.float32), out, layer=np.zeros(4, np.uint32))
    lookup()
    width: int = texture.info["width"] + lookup.nonfinite_count
    texel_format: shd.Format = same.info["format"]
    print(width, texel_format, texture.read_level(1).shape)
    return texture.sample(sampler, u, v, channels=3, dudx=u, lod=None)


def draw(context: shd.Context, position: npt.NDArray[np.float64], faces: npt.NDArray[np.int64]) -> Tuple[int, bytes]:
    mesh = shd.Mesh(context, position, faces, uv=position[:, :2], flags="tangents")
    torus = shd.Mesh.shape(context, kind="torus")
    material = shd.Material(context, model="blinn_phong", diffuse=(1, 0.5, 0), slots=[
        shd.slot("diffuse", shd.Texture(context, np.zeros((2, 2), np.uint8)), shd.Sampler(context)),
        shd.Slot(target="opacity", attribute=0)])
    sun = shd.Light(context, kind="directional", direction=(0, -1, -1))
    shadow = shd.Shadow(context, filter="pcf", size=1024)
    shadow.render(context, sun, [shd.Draw(mesh=mesh)])
    desc = shd.RenderDesc(clear_color=(0, 0, 0, 1)).replace(clear_depth=1.0)
    with shd.Framebuffer(context, 640, 480, sample_count=4, aovs="uv|normal", color_format="rgba8_srgb") as framebuffer:
        stats = shd.render(context, framebuffer, [shd.Draw(mesh=torus, material=material, cull="back")], desc,
                           camera=shd.Camera(eye=(0, 1, 3)), lights=[sun], shadows=[shadow],
                           progress=lambda fraction: fraction < 2)
        shd.save_png(pathlib.Path("a.png"), framebuffer.read_color("rgba8_srgb"))
        pixels: npt.NDArray[np.uint8] = np.asarray(framebuffer)
        depth = framebuffer.plane("depth").min()
    print(depth, np.from_dlpack(framebuffer))
    return stats["fragment_count"], pixels.tobytes()


def components(context: shd.Context, framebuffer: shd.Framebuffer, files: Dict[str, bytes]) -> List[str]:
    scene = shd.Scene(context, "model.glb", flags="any_folder", find=files.get)
    posed = scene.pose("Walk", 0.5)
    bitmap = shd.io.load(context, pathlib.Path("a.png"))
    texture, info = shd.io.open_texture(context, "earth.tx", shd.TileCache(context, budget_bytes=1 << 29))
    color = shd.Color(context)
    shd.io.save(framebuffer, "frame.png", dither="ordered", display=color.view("sRGB"))
    shd.io.save(texture, "earth.ktx2", supercompression="zstd")
    shown, stats = color.render(framebuffer, posed.draws, "sRGB", camera=posed.cameras[0], lights=posed.lights)
    tracer = shd.embree.Tree(context, scene.draws).tracer
    open_sky = shd.occlusion(context, np.zeros((2, 3)), [(0, 0, 1), (0, 1, 0)], tracer=tracer, ray_count=64)
    noise, slope = shd.evaluate_solid(context, np.zeros((2, 3)), want=("value", "gradient"), kind="perlin")
    cage = shd.Polyhedron(context, np.zeros((4, 3)), [[0, 1, 2]], kind="mean_value")
    weights: npt.NDArray[np.float32] = cage.evaluate(np.zeros((2, 3)))
    u, v = shd.project(context, np.eye(3), "octahedral")
    print(bitmap.pixels.shape, shown.shape, stats["fragment_count"], open_sky + noise, slope + u + v, info["tile_width"])
    return scene.warnings


def pictures(poses: List[npt.NDArray[np.float64]], log: logging.Logger) -> Optional[npt.NDArray[np.uint8]]:
    context = shd.Context(worker_count=4, log=log)
    color: Optional[npt.NDArray[np.uint8]] = None
    with shd.Renderer(640, 480, context=context, background=(1, 1, 1, 0)) as renderer:
        renderer.add("model.glb", lights=True)
        item = renderer.add(position=np.zeros((3, 3)), indices=[[0, 1, 2]], color=(255, 0, 0), roughness=0.5)
        renderer.add_light("point", intensity=3.0, position=(0, 1, 0))
        renderer.look_at(eye=(1, 1, 2), near=0.1)
        for item.pose in poses:
            color, depth = renderer.render(alpha=True, shadows=["directional"], fill="wireframe", progress=True)
            print(depth.max(), renderer.render_ids().max())
    if color is not None:
        difference = golden.compare(color, "reference.png")
        print(difference.max_flip, golden.Store("golden").check(color, "torus", max_flip=0.1))
    return color


def ported(path: str) -> Tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32]]:
    model = pyrender.load(path)
    scene = pyrender.Scene(bg_color=[1.0, 1.0, 1.0], ambient_light=(0.1, 0.1, 0.1))
    node = scene.add(pyrender.Mesh.from_trimesh(model, smooth=False), pose=np.eye(4))
    node.translation = [0, 0, -np.min(model.vertices[:, 2])]
    camera = pyrender.PerspectiveCamera(yfov=np.pi / 3.0, aspectRatio=1.0)
    camera.zfar = 20.0
    scene.add(camera, pose=np.eye(4))
    light = pyrender.SpotLight(color=np.ones(3), intensity=3.0, outerConeAngle=0.5)
    light.color = (1.0, 0.5, 0.25)
    scene.add(light, parent_node=node)
    material = pyrender.MetallicRoughnessMaterial(alphaMode="BLEND", baseColorFactor=[0.3, 0.3, 0.3, 1.0])
    material.baseColorTexture = np.zeros((2, 2, 3), np.uint8)
    print(material.baseColorFactor[3] + scene.scale, material.baseColorTexture)
    with pyrender.OffscreenRenderer(640, 480) as renderer:
        return renderer.render(scene, pyrender.RenderFlags.RGBA | pyrender.RenderFlags.SHADOWS_ALL)
