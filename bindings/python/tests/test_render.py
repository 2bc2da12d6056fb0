# SPDX-License-Identifier: MIT
"""Frames: pictures, programs and other callbacks in NumPy, on several workers."""
import contextlib
import hashlib
import io
import pathlib
import struct
import tempfile
import threading
import zlib

import numpy as np

import shd
import shd.__main__
from support import Case, threaded_executor


class Frames(Case):
    def test_texture(self):
        material = shd.Material(self.context, model="unlit", diffuse=(1, 1, 1), slots=[
            shd.slot("diffuse", self.checker(), shd.Sampler(self.context, filter="nearest"))])
        framebuffer = self.framebuffer(aovs="uv|draw")
        stats = shd.render(self.context, framebuffer, [shd.Draw(mesh=self.square(), material=material)])
        self.assertEqual((stats["triangle_count"], stats["rasterized_triangle_count"]), (2, 2))
        color = framebuffer.read_color()
        expected = np.zeros((8, 16), np.float32)
        expected[:4, 8:] = expected[4:, :8] = 1
        np.testing.assert_array_equal(color[..., 0], expected)
        np.testing.assert_array_equal(color[..., 0], framebuffer.plane("r"))
        np.testing.assert_array_equal(framebuffer.plane("draw"), 0)
        self.assertEqual(framebuffer.plane("draw").dtype, np.uint32)
        self.assertEqual(framebuffer.read_color("rgba8_srgb")[0, 15].tolist(), [255, 0, 0, 255])
        self.check_refused(shd.Error, "plane", framebuffer.plane, "lod")

    def test_interleaved(self):
        framebuffer = self.framebuffer(color_format="rgba8")
        shd.render(self.context, framebuffer, clear_color=(1, 0, 0, 1))
        self.assertEqual(framebuffer.view_color()[7, 15].tolist(), [255, 0, 0, 255])
        np.testing.assert_array_equal(framebuffer.view_color(), framebuffer.read_color("rgba8"))

    def test_matrices(self):
        """Matrices are [row][column]; a translation moves the square."""
        move = np.eye(4, dtype=np.float32)
        move[0, 3] = 1
        framebuffer = self.framebuffer(aovs="draw")
        for draw in (shd.Draw(mesh=self.square(), object_to_world=move),
                     shd.Draw(mesh=self.square(), instances=move[np.newaxis]),
                     shd.Draw(mesh=self.square(), instances=move.T.reshape(1, 16).copy())):
            shd.render(self.context, framebuffer, [draw])
            np.testing.assert_array_equal(framebuffer.plane("depth") < 1, [[False] * 8 + [True] * 8] * 8)

    def test_lights(self):
        framebuffer = self.framebuffer()
        light = shd.Light(self.context, kind="directional", direction=(0, 0, -1), intensity=(0.5, 1, 1))
        material = shd.Material(self.context, diffuse=(1, 1, 1), ambient=(0, 0, 0))
        shd.render(self.context, framebuffer, [shd.Draw(mesh=self.square(), material=material)], lights=[light])
        np.testing.assert_allclose(framebuffer.plane("r"), 0.5, atol=1e-6)

    def test_module(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "picture.png"
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(shd.__main__.main([str(path), "--size", "32", "24"]), 0)
            data = path.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", data[16:24]), (32, 24))
        begin = data.index(b"IDAT")
        size = struct.unpack(">I", data[begin - 4:begin])[0]
        rows = np.frombuffer(zlib.decompress(data[begin + 4:begin + 4 + size]), np.uint8).reshape(24, 1 + 32 * 4)
        np.testing.assert_array_equal(rows[:, 1:].reshape(24, 32, 4), shd.__main__.picture(32, 24))
        self.assertGreater(len(np.unique(rows)), 50)
        with contextlib.redirect_stderr(io.StringIO()) as text:
            self.assertEqual(shd.__main__.main(["/nonexistent/picture.png"]), 1)
        self.assertIn("nonexistent", text.getvalue())


class Programs(Case):
    def draw(self, context, program, width=256, height=128, **values):
        """Frame of a square with a program, as an array."""
        material = shd.Material(context, model="program", program=program, **values)
        with shd.Framebuffer(context, width, height) as framebuffer:
            shd.render(context, framebuffer, [shd.Draw(mesh=self.square(context), material=material)])
            return framebuffer.read_color()

    @staticmethod
    def shade(fragments, out):
        out.r[:] = fragments.u
        out.g[:] = fragments.v
        out.b[:] = np.sin(10 * fragments.x)

    def test_fragment(self):
        color = self.draw(self.context, {"fragment": self.shade}, 16, 8)
        np.testing.assert_allclose(color[3, :, 0], (np.arange(16) + 0.5) / 16, atol=1e-6)
        np.testing.assert_allclose(color[:, 5, 1], (np.arange(8) + 0.5) / 8, atol=1e-6)

    def test_kept_arrays(self):
        """Arrays that a program keeps do not refer to memory of the library."""
        kept = []

        def keep(fragments, out):
            out.r[:] = fragments.u
            for array in kept:
                array[:] = 9
            kept.append(out.r)

        with shd.Context(worker_count=1) as context:
            for _ in range(3):
                color = self.draw(context, {"fragment": keep}, 16, 8)
                np.testing.assert_allclose(color[3, :, 0], (np.arange(16) + 0.5) / 16, atol=1e-6)
                kept[-1][:] = 9
        self.assertTrue(all(array.flags.owndata for array in kept))

    def test_workers(self):
        """Four workers in the program have the bits of one, and none waits for the caller."""
        hashes, lock, four = set(), threading.Lock(), threading.Event()
        inside = [0]

        def meet(fragments, out):
            """Holds the first callbacks until four of them run."""
            with lock:
                inside[0] += 1
                if inside[0] == 4:
                    four.set()
            four.wait(10)
            with lock:
                inside[0] -= 1
            self.shade(fragments, out)

        for options, program in (({"worker_count": 1}, self.shade), ({"worker_count": 4}, self.shade),
                                 ({"executor": threaded_executor(4)}, meet)):
            with shd.Context(**options) as context:
                for _ in range(3):
                    color = self.draw(context, {"fragment": program})
                    hashes.add(hashlib.sha256(color.tobytes()).hexdigest())
        self.assertEqual(len(hashes), 1)
        self.assertTrue(four.is_set())

    def test_frames_in_threads(self):
        """Four threads render concurrently, each with programs of its own."""
        colors = {}

        def run(i):
            colors[i] = self.draw(self.context, {"fragment": self.shade}, 64, 64)

        threads = [threading.Thread(target=run, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(30)
        self.assertEqual(len(colors), 4)
        for color in colors.values():
            np.testing.assert_array_equal(color, colors[0])

    def test_vertex(self):
        def squeeze(vertices, out):
            self.assertEqual(vertices.object_to_world.shape, (4, 4))
            out.x[:] = vertices.px / 2
            out.varying[0][:] = vertices.u

        color = self.draw(self.context, {
            "vertex": squeeze, "fragment": lambda fragments, out: np.copyto(out.r, fragments.varying[0])}, 16, 8,
            varying_count=1)
        self.assertEqual(color[:, :4].max(), 0)
        np.testing.assert_allclose(color[3, 4:12, 0], (np.arange(8) + 0.5) / 8, atol=1e-6)

    def test_procedure(self):
        def stripes(fragments, channels):
            channels[0][:] = fragments.u > 0.5

        material = shd.Material(self.context, model="unlit", diffuse=(1, 1, 1),
                                slots=[shd.slot("diffuse", procedure=stripes)])
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, [shd.Draw(mesh=self.square(), material=material)])
        np.testing.assert_array_equal(framebuffer.plane("r"), [[0] * 8 + [1] * 8] * 8)

    def test_lookup_in_program(self):
        texture, sampler = self.checker(), shd.Sampler(self.context, filter="nearest")
        color = self.draw(self.context, {"fragment": lambda fragments, out: texture.sample(
            sampler, fragments.u, fragments.v, out=[out.r, None, out.b])}, 16, 8)
        self.assertEqual((color[0, 0, 0], color[0, 15, 0], color[0, 15, 1]), (0, 1, 0))

    def test_exceptions(self):
        calls = []

        def fail(fragments, out):
            calls.append(1)
            raise KeyError("from the program")

        with shd.Context(executor=threaded_executor(4)) as context:
            self.check_refused(KeyError, "from the program", self.draw, context, {"fragment": fail})
            self.check_refused(AttributeError, "no column w; there are", self.draw, context,
                               {"fragment": lambda fragments, out: fragments.w})
            self.check_refused(ValueError, "read-only", self.draw, context,
                               {"fragment": lambda fragments, out: fragments.u.fill(0)})
            self.draw(context, {"fragment": self.shade})
        self.assertLessEqual(len(calls), 4)
        self.check_refused(TypeError, "int is not callable", self.draw, self.context, {"fragment": 3})

    def test_late_access(self):
        kept = []
        self.draw(self.context, {"fragment": lambda fragments, out: kept.append(fragments)}, 16, 8)
        self.check_refused(AttributeError, "no column u", lambda: kept[0].u)

    def test_tiles(self):
        image, lock = np.zeros((128, 256), np.float32), threading.Lock()

        def present(tile):
            a = tile.area
            with lock:
                image[a.y:a.y + a.height, a.x:a.x + a.width] = tile.channel[0]

        with shd.Context(executor=threaded_executor(2)) as context, shd.Framebuffer(context, 256, 128) as framebuffer:
            material = shd.Material(context, model="program", program={"fragment": self.shade})
            shd.render(context, framebuffer, [shd.Draw(mesh=self.square(context), material=material)],
                       present={"tile": present})
            np.testing.assert_array_equal(image, framebuffer.plane("r"))
            self.check_refused(ZeroDivisionError, "division", shd.render, context, framebuffer,
                               present={"tile": lambda tile: 1 // 0})

    def test_progress(self):
        fractions = []
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, progress={"report": fractions.append})
        self.assertEqual(fractions[-1], 1)
        for answer in (None, True, 0, shd.Result.OK):
            shd.render(self.context, framebuffer, progress={"report": lambda fraction: answer})
        for answer, result in ((False, shd.Result.ERROR_CANCELLED), (shd.Result.ERROR_LIMIT, shd.Result.ERROR_LIMIT)):
            with self.assertRaises(shd.Error) as caught:
                shd.render(self.context, framebuffer, progress={"report": lambda fraction: answer})
            self.assertEqual(caught.exception.result, result)
        self.check_refused(ZeroDivisionError, "", shd.render, self.context, framebuffer,
                           progress={"report": lambda fraction: 1 // 0})

    def test_executor_fails(self):
        def broken(count, task, task_data):
            raise RuntimeError("no threads")

        with shd.Context(executor={"parallel_for": broken, "worker_count": 2}) as context:
            self.check_refused(RuntimeError, "no threads", self.draw, context, {"fragment": self.shade})
