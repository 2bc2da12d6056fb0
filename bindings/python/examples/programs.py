#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The three programs that every binding has: a batch of lookups, a frame, and a fragment program.

    programs.py            prints a hash of each result; bindings/programs.txt has the hashes of all languages
    programs.py --speed    prints the time of a call of one lookup, and of a batch of 2^20
    programs.py FILE       also writes the pixels of the last frame
"""
import pathlib
import sys
import time
from typing import Any, Callable, List

import numpy as np
import numpy.typing as npt

import shd

SIZE, LOOKUPS, WIDTH, HEIGHT, BATCH, CALLS, TRIALS = 64, 16384, 320, 200, 1 << 20, 200000, 7


def print_hash(name: str, array: npt.NDArray[Any]) -> None:
    """FNV-1a of 64 bits (Fowler, Noll and Vo, 1991), byte by byte."""
    value = 0xcbf29ce484222325
    for byte in array.tobytes():
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    print(f"{name} {value:016x}")


def make_texture(context: shd.Context) -> shd.Texture:
    y, x = np.indices((SIZE, SIZE))
    texels = np.stack([x * 4, y * 4, (x ^ y) * 4, np.full_like(x, 255)], axis=-1).astype(np.uint8)
    return shd.Texture(context, texels, srgb=True, tables="mipmap")


def look_up(context: shd.Context) -> None:
    """1. A batch of lookups: footprints of many sizes and directions, filtered with EWA."""
    i = np.arange(LOOKUPS)
    sampler = shd.Sampler(context, filter="ewa", max_anisotropy=16)
    color = make_texture(context).sample(sampler, u=i % 128 / 64, v=i // 128 / 128, dudx=(1 + i % 7) / 256,
                                         dvdx=i % 5 / 512, dudy=i % 3 / -512, dvdy=(1 + i % 11) / 1024)
    print_hash("lookup", color.T)


def draw(context: shd.Context, **material: Any) -> npt.NDArray[np.uint8]:
    """A torus of one material in the light of the sun, as RGBA8 in sRGB."""
    torus = shd.Mesh.shape(context, kind="torus")
    sun = shd.Light(context, kind="directional", direction=(-0.5, -1, -0.25))
    framebuffer = shd.Framebuffer(context, WIDTH, HEIGHT, sample_count=4)
    shd.render(context, framebuffer, [shd.Draw(mesh=torus, material=shd.Material(context, **material))],
               camera=shd.Camera(eye=(0.5, 1.5, 2)), lights=[sun])
    return framebuffer.read_color("rgba8_srgb")


def draw_textured(context: shd.Context) -> None:
    """2. A frame: the material has a texture."""
    sampler = shd.Sampler(context, filter="trilinear", max_anisotropy=16)
    print_hash("frame", draw(context, model="blinn_phong",
                             slots=[shd.slot("diffuse", make_texture(context), sampler)]))


def draw_program(context: shd.Context) -> npt.NDArray[np.uint8]:
    """3. A fragment program: shows the texture coordinates."""
    blue = 0.25

    def uv_as_color(fragments: Any, out: Any) -> None:
        out.r[:] = fragments.u
        out.g[:] = fragments.v
        out.b[:] = blue

    pixels = draw(context, model="program", program={"fragment": uv_as_color})
    print_hash("program", pixels)
    return pixels


def measure(call: Callable[[], None], count: int) -> float:
    """Seconds of `count` calls, the best of seven."""
    best = float("inf")
    for _ in range(TRIALS):
        start = time.perf_counter()
        for _ in range(count):
            call()
        best = min(best, time.perf_counter() - start)
    return best


def print_speed() -> None:
    context = shd.Context(worker_count=1)
    texture = make_texture(context)
    sampler = shd.Sampler(context, filter="trilinear", max_anisotropy=16)
    i = np.arange(BATCH)
    u, v, lod = (column.astype(np.float32) for column in (i % 1024 / 1024, i // 1024 / 1024, i % 16 / 8))
    out = np.zeros((4, BATCH), np.float32)
    one = texture.lookup(sampler, u[:1], v[:1], list(out[:, :1]), lod=lod[:1])
    print(f"call {1e9 * measure(one, CALLS) / CALLS:.2f} ns")
    batch = texture.lookup(sampler, u, v, list(out), lod=lod)
    print(f"batch {1e3 * measure(batch, 3) / 3:.4f} ms")


def main(arguments: List[str]) -> None:
    if arguments[:1] == ["--speed"]:
        return print_speed()
    context = shd.Context()
    look_up(context)
    draw_textured(context)
    pixels = draw_program(context)
    if arguments:
        pathlib.Path(arguments[0]).write_bytes(pixels.tobytes())


if __name__ == "__main__":
    main(sys.argv[1:])
