# SPDX-License-Identifier: MIT
"""Small scenes, an executor of Python threads, and a counting allocator for the tests."""
import ctypes
import pathlib
import threading
import unittest

import numpy as np

import shd
from shd import _api


class Case(unittest.TestCase):
    """A context, and a square that fills the view: clip space equals object space."""

    @classmethod
    def setUpClass(cls):
        cls.context = shd.Context(worker_count=1)

    def square(self, context=None):
        position = np.float32([[-1, 1, 0.5], [-1, -1, 0.5], [1, 1, 0.5], [1, -1, 0.5]])
        uv = np.float32([[0, 0], [0, 1], [1, 0], [1, 1]])
        return shd.Mesh(context or self.context, position, uv=uv, topology="strip")

    def checker(self, context=None):
        return shd.Texture(context or self.context, np.float32([[0, 1], [1, 0]]))

    def framebuffer(self, width=16, height=8, **values):
        return shd.Framebuffer(self.context, width, height, **values)

    def check_refused(self, kind, pattern, call, *arguments, **values):
        with self.assertRaisesRegex(kind, pattern):
            call(*arguments, **values)


def threaded_executor(workers):
    """Options of a context whose tasks run on threads of Python."""

    def parallel_for(count, task, task_data):
        indices = iter(range(count))
        lock = threading.Lock()

        def run(worker):
            while True:
                with lock:
                    index = next(indices, None)
                if index is None:
                    return
                task(index, worker, task_data)

        threads = [threading.Thread(target=run, args=(w,)) for w in range(workers)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    return {"parallel_for": parallel_for, "worker_count": workers}


class Allocator:
    """Memory of libc, with the number of blocks that are alive."""

    def __init__(self):
        libc = ctypes.CDLL(None)
        libc.aligned_alloc.restype = ctypes.c_void_p
        libc.aligned_alloc.argtypes = [ctypes.c_size_t, ctypes.c_size_t]
        libc.free.argtypes = [ctypes.c_void_p]
        self.libc, self.lock, self.live, self.total = libc, threading.Lock(), 0, 0

    def allocate(self, size, alignment):
        with self.lock:
            self.live, self.total = self.live + 1, self.total + 1
        return self.libc.aligned_alloc(alignment, -(-size // alignment) * alignment)

    def free(self, memory, size, alignment):
        with self.lock:
            self.live -= 1
        self.libc.free(memory)

    def options(self):
        return {"allocate": self.allocate, "free": self.free}


def require_component(name, *paths):
    """Skips a test without a component, or without a file of the package assimp-testmodels."""
    try:
        _api.lib.load(name)
    except ImportError as problem:
        raise unittest.SkipTest(f"lib{name} is absent: {problem}") from None
    for path in paths:
        if not pathlib.Path(path).exists():
            raise unittest.SkipTest(f"{path} is absent (Debian: assimp-testmodels)")
