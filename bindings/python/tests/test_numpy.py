# SPDX-License-Identifier: MIT
"""Arrays of other types and objects that hold numbers: the results are those of arrays that fit."""
import contextlib
import io
import logging
import pathlib
import pickle
import struct
import sys
import tempfile
import zlib
from unittest import mock

import numpy as np

import shd
from shd import golden
from support import Case, require_component

POSITION = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])


class Interface:
    """An object with the array interface alone, as images of Pillow have it."""

    def __init__(self, array):
        self._array, self.__array_interface__ = array, array.__array_interface__


class Exported:
    """An object with DLPack alone, as tensors of other libraries have it."""

    def __init__(self, array, device=(1, 0)):
        self._array, self._device = array, device

    def __dlpack__(self, **_):
        return self._array.__dlpack__()

    def __dlpack_device__(self):
        return self._device


class Converting:
    """An object with __array__ alone."""

    def __init__(self, array):
        self._array = array

    def __array__(self, dtype=None, copy=None):
        return self._array


class Copying(Converting):
    """An object whose __array__ makes a new array each time."""

    def __array__(self, dtype=None, copy=None):
        return self._array.copy()


def forms(array):
    """Objects with the numbers of an array, which NumPy would have to copy or to convert."""
    padded = np.zeros((*array.shape[:-1], 2 * array.shape[-1]), array.dtype)
    padded[..., ::2] = array
    unaligned = np.frombuffer(b"\0" + array.tobytes(), np.uint8)[1:].view(array.dtype).reshape(array.shape)
    return {"float64": array.astype(np.float64), "float16": array.astype(np.float16), "list": array.tolist(),
            "tuples": tuple(map(tuple, array.tolist())) if array.ndim == 2 else tuple(array.tolist()),
            "big endian": array.astype(">f4"), "reversed": array[::-1].copy()[::-1], "strided": padded[..., ::2],
            "unaligned": unaligned, "memoryview": memoryview(np.ascontiguousarray(array)),
            "interface": Interface(array), "dlpack": Exported(array.copy()), "__array__": Converting(array)}


class Inputs(Case):
    def test_columns(self):
        texture, sampler = self.checker(), shd.Sampler(self.context, filter="bilinear")
        u, v = np.float32([0.25, 0.5, 0.75, 1]), np.float32([0.5, 0.25, 0.125, 0])
        want = texture.sample(sampler, u, v)
        for name, made in forms(u).items():
            with self.subTest(name):
                np.testing.assert_array_equal(texture.sample(sampler, made, v), want)
        constant = texture.sample(sampler, np.broadcast_to(np.float32(0.25), 4), v)
        np.testing.assert_array_equal(constant, texture.sample(sampler, np.full(4, 0.25, np.float32), v))
        layers = [texture.sample(sampler, u, v, layer=np.zeros(4, kind)) for kind in (np.int64, np.int8, np.uint16)]
        np.testing.assert_array_equal(layers, [want] * 3)

    def test_lookups_stay_in_place(self):
        """A prepared batch reads its arrays at each call, so an array that would be copied is refused."""
        u, out = np.float32([0.25]), np.zeros((1, 4), np.float32)
        lookup = self.checker().lookup(shd.Sampler(self.context, filter="nearest"), memoryview(u), u, out)
        lookup()
        first, u[:] = out.copy(), 0.75
        lookup()
        np.testing.assert_array_equal((first[0, 0], out[0, 0]), (0, 0))
        for kind, message, values in ((TypeError, "u: the array is of float64, not float32", u.astype(float)),
                                      (ValueError, "u: its stride is -4 bytes", np.zeros(4, np.float32)[::-1])):
            self.check_refused(kind, message, self.checker().lookup, shd.Sampler(self.context), values, values, out)

    def test_lookups_of_objects(self):
        """Objects that share their numbers are read in place, in all forms; a copy of numbers is refused."""
        texture, sampler = self.checker(), shd.Sampler(self.context, filter="nearest")
        for hold in (Interface, Exported, Converting, memoryview):
            u, v, out = np.float32([0.25]), np.float32([0.25]), np.zeros((1, 1), np.float32)
            lookup = texture.lookup(sampler, hold(u), v, out)
            seen = []
            for u[0] in (0.25, 0.75):
                lookup()
                seen.append(float(out[0, 0]))
            self.assertEqual(seen, [0, 1], hold)
        for kind, message, made in (
                (TypeError, "u: the array is of float64, not float32", Converting(np.zeros(1))),
                (TypeError, "u: the array is of float64, not float32", memoryview(np.zeros(1))),
                (ValueError, "u: its stride is -4 bytes", Converting(np.zeros(2, np.float32)[::-1])),
                (TypeError, "u: an array that is read in place, not list, whose array is a copy", [0.5]),
                (TypeError, "u: an array that is read in place, not Copying", Copying(np.zeros(1, np.float32)))):
            out = np.zeros((1, 1), np.float32)
            self.check_refused(kind, message, texture.lookup, sampler, made, np.float32([0.5]), out)

    def test_positions(self):
        for name, made in forms(POSITION).items():
            with self.subTest(name):
                mesh = shd.Mesh(self.context, made, uv=POSITION[:, :2], topology="strip")
                np.testing.assert_array_equal(mesh.positions, POSITION)
        rows = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]  # three rows, which are no columns
        np.testing.assert_array_equal(shd.Mesh(self.context, rows).positions, rows)

    def test_projection(self):
        """Coordinates from positions, through a matrix."""
        mesh = shd.Mesh(self.context, POSITION, topology="strip", uv_projection="planar")
        expected = np.stack([(1 + POSITION[:, 0]) / 2, (1 - POSITION[:, 1]) / 2], axis=1)
        np.testing.assert_allclose(mesh.uv, expected, atol=1e-6)
        half = np.diag(np.float32([0.5, 0.5, 0.5, 1])).ravel()
        mesh = shd.Mesh(self.context, POSITION, topology="strip", uv_projection="planar", object_to_projection=half)
        np.testing.assert_allclose(mesh.uv, (expected + 0.5) / 2, atol=1e-6)
        self.check_refused(shd.InvalidArgument, r"mesh.uv_projection: 4, but mesh.uv is set too", shd.Mesh,
                           self.context, POSITION, uv=POSITION[:, :2], uv_projection="box")

    def test_indices(self):
        faces = [[0, 1, 2], [1, 3, 2]]
        for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4"):
            mesh = shd.Mesh(self.context, POSITION, np.array(faces, kind))
            np.testing.assert_array_equal(mesh.indices, faces)
        for made in (faces, Exported(np.array(faces)), memoryview(np.array(faces)), np.array(faces)[::-1][::-1]):
            np.testing.assert_array_equal(shd.Mesh(self.context, POSITION, made).indices, faces)
        self.check_refused(ValueError, r"^mesh.position: the last axis has 2 elements, not 3", shd.Mesh,
                           self.context, POSITION[:, :2])
        self.check_refused(TypeError, r"^mesh.position: .*device", shd.Mesh, self.context,
                           Exported(POSITION, (2, 0)))
        self.check_refused(shd.InvalidArgument, r"mesh.indices\[2\]: 4 is not below vertex_count 4", shd.Mesh,
                           self.context, POSITION, np.int64([0, 1, 4]))

    def test_texels(self):
        """The type of texels is kept where a format has it; float64 becomes float32."""
        codes = np.arange(24, dtype=np.uint8).reshape(2, 4, 3) * 10
        bgr = np.ascontiguousarray(codes[..., ::-1])
        for made in (codes, bgr[..., ::-1], codes[::-1].copy()[::-1], memoryview(codes),
                     Interface(codes), Exported(codes), np.moveaxis(codes.transpose(2, 0, 1).copy(), 0, -1)):
            texture = shd.Texture(self.context, made, srgb=True)
            self.assertEqual(texture.info["format"], shd.Format.RGBA8_SRGB)  # three numbers are stored as four
            np.testing.assert_array_equal(texture.read_level()[..., :3], codes)
        for kind, texel_format in (("f8", "R32F"), (">f4", "R32F"), (">u2", "R16"), ("f2", "R16F")):
            texture = shd.Texture(self.context, np.array([[0, 1], [1, 0]], kind))
            self.assertEqual(texture.info["format"].name, texel_format)
            np.testing.assert_array_equal(texture.read_level()[..., 0], [[0, 1], [1, 0]])
        self.assertEqual(shd.Texture(self.context, [[0.0, 0.5]]).info["format"], shd.Format.R32F)
        texture.update(np.float16([[3]]))
        self.assertEqual(float(texture.read_level()[0, 0, 0]), 3)

    def test_directions(self):
        sky = shd.Environment(self.context, np.ones((4, 8)), tables="all")
        for direction in ([(0, 0, 1), (0, 1, 0)], np.eye(3)[:2], Exported(np.eye(3, dtype=np.float32))):
            np.testing.assert_allclose(sky.sample_irradiance(direction), np.pi, rtol=0.02)

    def test_renderer(self):
        """Pictures of models from objects that share their numbers."""
        with shd.Renderer(16, 16, context=self.context) as renderer:
            for hold in (np.asarray, Exported, Interface, Converting):
                item = renderer.add(position=hold(2 * POSITION - 1), indices=hold(np.array([[0, 1, 2], [1, 3, 2]])),
                                    uv=hold(POSITION[:, :2].copy()), texture=hold(np.full((2, 2, 3), 255, np.uint8)))
                self.assertEqual(renderer.render(flat=True)[0][8, 8].tolist(), [255] * 3)
                renderer.remove(item)
        made = shd.pyrender.Primitive(Exported(POSITION), indices=Exported(np.array([0, 1, 2])))
        self.assertEqual(made.bounds.tolist(), [[0, 0, 0], [1, 1, 0]])

    def test_devices(self):
        """Memory of another device is refused in one line."""
        self.check_refused(TypeError, "mesh.position: an array in the memory of the CPU, not of device .2", shd.Mesh,
                           self.context, Exported(POSITION, (2, 0)), topology="strip")

    def test_pillow(self):
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is absent (Debian: python3-pil)")
        codes = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
        picture = Image.fromarray(codes)
        np.testing.assert_array_equal(shd.Texture(self.context, picture, srgb=True).read_level()[..., :3], codes)
        palette = shd.Texture(self.context, picture.quantize(64), srgb=True)
        self.assertEqual((palette.info["format"], palette.info["width"]), (shd.Format.RGBA8_SRGB, 4))
        self.assertEqual(shd.Texture(self.context, picture.convert("1")).info["format"], shd.Format.RGBA8)


class Outputs(Case):
    def render(self, **values):
        framebuffer = self.framebuffer(2, 1, **values)
        shd.render(self.context, framebuffer, clear_color=(0.25, 0.5, 1, 1))
        return framebuffer

    def test_array(self):
        for texel_format, dtype in (("rgba32f", np.float32), ("rgba8_srgb", np.uint8), ("rgba16f", np.float16)):
            framebuffer = self.render(color_format=texel_format)
            made = np.asarray(framebuffer)
            self.assertEqual((made.dtype, made.shape), (dtype, (1, 2, 4)))
            np.testing.assert_array_equal(made, framebuffer.read_color(texel_format))
            shared = np.from_dlpack(framebuffer)
            np.testing.assert_array_equal(shared, made)
            self.assertEqual(shared.dtype, dtype)
        np.testing.assert_array_equal(np.asarray(self.render(), np.float64)[0, 0], (0.25, 0.5, 1, 1))
        self.check_refused(ValueError, "its array is a copy", framebuffer.__array__, copy=False)
        self.check_refused(ValueError, "stream 2", framebuffer.__dlpack__, stream=2)

    def test_textures(self):
        texels = np.arange(24, dtype=np.uint8).reshape(2, 3, 4)
        np.testing.assert_array_equal(np.asarray(shd.Texture(self.context, texels, srgb=True)), texels)
        layers = np.stack([texels, texels + 1])
        np.testing.assert_array_equal(shd.Texture(self.context, layers, layer_count=2), layers)
        np.testing.assert_array_equal(shd.Texture(self.context, layers, depth=2), layers)
        self.check_refused(ValueError, "its array is a copy", shd.Texture(self.context, texels).__array__, copy=False)

    def test_notebook(self):
        """Pictures of notebooks have straight sRGB codes."""
        png = self.render()._repr_png_()
        self.assertEqual(struct.unpack(">II", png[16:24]), (2, 1))
        begin = png.index(b"IDAT")
        body = png[begin + 4:begin + 4 + struct.unpack(">I", png[begin - 4:begin])[0]]
        self.assertEqual(list(zlib.decompress(body)), [0, *(137, 188, 255, 255) * 2])
        with shd.Renderer(4, 2, background=(1, 0, 0)) as renderer:
            self.assertEqual(renderer._repr_png_()[1:4], b"PNG")
        self.assertIsNone(renderer._repr_png_())
        self.assertEqual(repr(renderer), "<shd.Renderer closed>")
        self.assertEqual(repr(shd.Renderer(4, 2)), "<shd.Renderer 4x2 0 models 0 lights>")


class Files(Case):
    def test_missing(self):
        """Missing files are errors of the library and of Python."""
        problem = shd.MissingFile(shd.Result.ERROR_NOT_FOUND, "cannot open it", "a.png")
        self.assertTrue(isinstance(problem, shd.Error) and isinstance(problem, FileNotFoundError))
        copied = pickle.loads(pickle.dumps(problem))
        self.assertEqual((str(copied), copied.filename, copied.result, copied.errno), (
            "cannot open it", "a.png", shd.Result.ERROR_NOT_FOUND, 2))
        with self.assertRaises(shd.Error) as caught:
            self.framebuffer().plane("lod")
        self.assertNotIsInstance(caught.exception, OSError)

    def test_components(self):
        for library in ("shd_io", "shd_scene", "shd_color"):
            require_component(library)
        path = pathlib.Path("nothing.glb")
        for call in (lambda: shd.io.load(self.context, path), lambda: shd.io.load_texture(self.context, path),
                     lambda: shd.io.open_texture(self.context, path, shd.TileCache(self.context)),
                     lambda: shd.Scene(self.context, path), lambda: shd.Renderer(4, 4).add(path),
                     lambda: shd.Color(self.context, config_path=path)):
            with self.assertRaises(FileNotFoundError) as caught:
                call()
            self.assertEqual((type(caught.exception), caught.exception.filename), (shd.MissingFile, "nothing.glb"))
            self.assertIn('"nothing.glb"', str(caught.exception))

    def test_paths(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.png"
            shd.save_png(path, np.zeros((2, 2, 3), np.uint8))
            self.assertEqual(path.read_bytes()[1:4], b"PNG")
            framebuffer = self.framebuffer(2, 1)
            shd.render(self.context, framebuffer, clear_color=(0.125, 0, 0, 0.5))
            for picture, want in ((framebuffer, [[[137, 0, 0, 128]] * 2]), ([[1, 2]], None),
                                  (np.uint8([[1, 2]]), [[[1], [2]]]), (np.uint16([[[300, 1, 2]]]), [[[300, 1, 2]]])):
                if want is None:
                    self.check_refused(TypeError, "of int64", shd.save_png, path, picture)
                    continue
                shd.save_png(path, picture)
                np.testing.assert_array_equal(golden.load(path), want)
            self.check_refused(ValueError, "^pixels: the array is empty$", shd.save_png, path,
                               np.zeros((0, 2), np.uint8))


class Reports(Case):
    def log(self, log):
        """Renders a draw without a material, of which the log gets a line."""
        context = shd.Context(worker_count=1, log=log)
        shd.render(context, shd.Framebuffer(context, 8, 8), [shd.Draw(mesh=self.square(context))])

    def test_log(self):
        """A function and a Logger get the lines of a context with their levels."""
        lines, logger = [], logging.getLogger("shd.test")
        logger.setLevel(logging.DEBUG)
        self.log(lambda level, message: lines.append((level, message)))
        with self.assertLogs(logger, logging.DEBUG) as records:
            self.log(logger)
        self.assertTrue(lines)
        self.assertIsInstance(lines[0][0], shd.LogLevel)
        self.assertEqual([(r.levelno, r.getMessage()) for r in records.records],
                         [(10 * (int(level) + 1), message) for level, message in lines])
        self.check_refused(TypeError, "context.log: a logging.Logger, a function or a dict", shd.Context, log=3)

    def test_progress(self):
        """A function gets the fractions of a frame, and a bar appears in long frames alone."""
        fractions = []
        shd.render(self.context, self.framebuffer(), progress=fractions.append)
        self.assertEqual(fractions[-1], 1)
        with shd.Renderer(8, 8, context=self.context) as renderer:
            renderer.render(progress=fractions.append)
            with self.assertRaises(shd.Error) as caught:
                renderer.render(progress=lambda fraction: False)
        self.assertEqual((fractions[-1], caught.exception.result), (1, shd.Result.ERROR_CANCELLED))
        self.check_refused(TypeError, "render.progress: True, a function", shd.render, self.context,
                           self.framebuffer(), progress=3)
        for delay, tqdm, pattern in ((10, None, r"^$"), (0, None, r"render \[#{30}\] 100 %\n$"),
                                     (0, Tqdm, r"^start \d+ % end$")):
            with self.subTest(pattern), contextlib.redirect_stderr(io.StringIO()) as printed, \
                    mock.patch("shd._report.DELAY", delay), mock.patch.dict("sys.modules", {"tqdm": tqdm}):
                shd.render(self.context, self.framebuffer(), progress=True)
                self.assertRegex(printed.getvalue(), pattern)


class Tqdm:
    """The parts of the module tqdm that are used, which print the sum of the parts."""

    @staticmethod
    def tqdm(total, desc, bar_format):
        assert (total, desc) == (1.0, "render")
        sys.stderr.write("start")
        return Tqdm()

    def __init__(self):
        self.n = 0

    def update(self, part):
        self.n += part

    def close(self):
        sys.stderr.write(f" {100 * self.n:.0f} % end")
