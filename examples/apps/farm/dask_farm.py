#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lookups over arrays in chunks, and a picture, on the workers of Dask (python3-distributed, python3-numpy).

    dask_farm.py [--scheduler ADDRESS] [--size N] [--kill]

Without an address two local processes start. --kill ends one of them with SIGKILL while the picture is rendered.
Dask starts another one and repeats the windows of the first. Prints the hashes of one process and of the workers,
and exits 1 if they differ. PYTHONPATH holds bindings/python, SHD_LIBRARY names libshd.so.
"""
import argparse
import functools
import hashlib
import os
import signal
import sys
import time
from typing import Any, Tuple

import numpy as np
import numpy.typing as npt

import shd

Array = npt.NDArray[Any]

WINDOW, LOOKUPS, CHUNK = 128, 1 << 20, 1 << 17


@functools.lru_cache(maxsize=1)
def stage() -> Tuple[shd.Context, shd.Texture, shd.Sampler, shd.Draw, shd.Light]:
    """The objects of a process: made by its first task, then kept. Handles do not travel between processes."""
    context = shd.Context(worker_count=1)
    y, x = np.indices((256, 256))
    texels = np.stack([x, y, (x ^ y), np.full_like(x, 255)], axis=-1).astype(np.uint8)
    texture = shd.Texture(context, texels, srgb=True, tables="mipmap")
    sampler = shd.Sampler(context, filter="ewa", max_anisotropy=16)
    material = shd.Material(context, model="blinn_phong", slots=[shd.slot("diffuse", texture, sampler)])
    draw = shd.Draw(mesh=shd.Mesh.shape(context, kind="torus"), material=material)
    sun = shd.Light(context, kind="directional", direction=(-0.5, -1, -0.25))
    return context, texture, sampler, draw, sun


def look_up(first: int, count: int) -> Array:
    """Colours of lookups [first, first + count) of a batch."""
    _, texture, sampler, _, _ = stage()
    i = np.arange(first, first + count)
    u, v = (i % 1024 / 1024).astype(np.float32), (i // 1024 / 1024).astype(np.float32)
    step = np.full(count, 1 / 512, np.float32)
    return texture.sample(sampler, u=u, v=v, dudx=step, dvdx=step / 3, dudy=step / -5, dvdy=step * 2)


def window(size: int, x: int, y: int) -> Array:
    """The window of the picture that begins at (x, y): the bits of the whole picture."""
    context, _, _, draw, sun = stage()
    edge_x, edge_y = min(WINDOW, size - x), min(WINDOW, size - y)
    framebuffer = shd.Framebuffer(context, edge_x, edge_y, sample_count=8)
    shd.render(context, framebuffer, [draw], camera=shd.Camera(eye=(0.5, 1.5, 2)), lights=[sun], picture_width=size,
               picture_height=size, crop_x=x, crop_y=y, supersampling=4)
    return framebuffer.read_color("rgba16f")


def whole(size: int) -> Array:
    context, _, _, draw, sun = stage()
    framebuffer = shd.Framebuffer(context, size, size, sample_count=8)
    shd.render(context, framebuffer, [draw], camera=shd.Camera(eye=(0.5, 1.5, 2)), lights=[sun], supersampling=4)
    return framebuffer.read_color("rgba16f")


def digest(array: Array) -> str:
    return hashlib.sha256(array.tobytes()).hexdigest()[:16]


def lookups_on(client: Any) -> Array:
    starts = range(0, LOOKUPS, CHUNK)
    return np.concatenate(client.gather(client.map(look_up, starts, [CHUNK] * len(starts))))


def picture_on(client: Any, size: int, kill: bool) -> Array:
    """Places windows as they come; a worker that dies loses only its own windows, which Dask computes again."""
    from distributed import as_completed
    starts = [(x, y) for y in range(0, size, WINDOW) for x in range(0, size, WINDOW)]
    futures = {client.submit(window, size, x, y, pure=False): (x, y) for x, y in starts}
    picture = np.zeros((size, size, 4), np.float16)
    victim = next(iter(client.run(os.getpid).values())) if kill else None
    for count, (future, pixels) in enumerate(as_completed(list(futures), with_results=True), start=1):
        x, y = futures[future]
        picture[y:y + pixels.shape[0], x:x + pixels.shape[1]] = pixels
        if victim and count == len(starts) // 4:
            os.kill(victim, signal.SIGKILL)
            print(f"worker with process {victim} killed after {count} of {len(starts)} windows")
            victim = None
    return picture


def compare(name: str, alone: Array, farmed: Array) -> bool:
    equal = digest(alone) == digest(farmed)
    print(f"{name}: one process {digest(alone)}, workers {digest(farmed)}: {'equal' if equal else 'NOT equal'}")
    return equal


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--scheduler", help="address of a running cluster; default two local processes")
    parser.add_argument("--size", type=int, default=1024, help="pixels of a side of the picture, 128..16384")
    parser.add_argument("--kill", action="store_true", help="end a local worker half-way")
    options = parser.parse_args()
    if not 128 <= options.size <= 16384 or options.kill and options.scheduler:
        parser.error("--size is in 128..16384; --kill needs local workers")
    from distributed import Client, LocalCluster
    cluster = None if options.scheduler else LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None,
                                                          silence_logs=50)
    with Client(options.scheduler or cluster) as client:
        good = compare("lookups", look_up(0, LOOKUPS), lookups_on(client))
        begin = time.perf_counter()
        farmed = picture_on(client, options.size, options.kill)
        print(f"picture of {options.size} x {options.size} on workers: {time.perf_counter() - begin:.1f} s")
        good = compare("picture", whole(options.size), farmed) and good
    if cluster:
        cluster.close()
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
