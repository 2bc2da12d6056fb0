# SPDX-License-Identifier: MIT
"""The components: files of models and images, and colours. A test is skipped if its library is absent."""
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile

import numpy as np

import shd
from shd import color, io
from support import Case, require_component

MODELS = pathlib.Path("/usr/share/assimp/models")
DUCK, BOX = MODELS / "Collada/duck.dae", MODELS / "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"


class Scenes(Case):
    @classmethod
    def setUpClass(cls):
        require_component("shd_scene", DUCK, BOX)
        super().setUpClass()
        cls.duck = shd.Scene(cls.context, DUCK)

    def test_parts(self):
        info = self.duck.info
        self.assertEqual((info["mesh_count"], len(self.duck.meshes), len(self.duck.draws)), (1, 1, 1))
        self.assertEqual((self.duck.names("mesh"), self.duck.warnings), (["LOD3spShape-lib"], []))
        self.assertTrue(self.duck.names("texture")[0].endswith("duckCM.tga"))
        mesh = self.duck.meshes[0]
        self.assertEqual(mesh.indices.shape, (info["triangle_count"], 3))
        corners = np.append(mesh.positions, np.ones((len(mesh.positions), 1)), axis=1) @ np.float64(
            self.duck.draws[0].object_to_world).T
        np.testing.assert_allclose(corners[:, :3].min(axis=0), info["bounds_min"], atol=1e-4)
        self.assertEqual(self.duck.light_descs[0].kind, shd.LightKind.DIRECTIONAL)
        self.assertEqual(shd.Light(self.context, self.duck.light_descs[0]).close(), None)

    def test_frame(self):
        """Parts live longer than the scene; a variant of a material keeps its texture."""
        scene = shd.Scene(self.context, BOX)
        draws, materials = scene.draws, scene.material_descs
        scene.close()
        scene.close()
        self.check_refused(ValueError, "the Scene is closed", lambda: scene.draws)
        sun = shd.Light(self.context, kind="ambient")
        pictures = []
        for material in (draws[0].material, shd.Material(self.context, materials[0]),
                         shd.Material(self.context, materials[0].replace(model="unlit"))):
            framebuffer = self.framebuffer(32, 32)
            shd.render(self.context, framebuffer, [draws[0].replace(material=material)], lights=[sun],
                       camera=shd.Camera(eye=(1, 1, 2)))
            pictures.append(framebuffer.read_color("rgba8_srgb"))
        np.testing.assert_array_equal(pictures[0], pictures[1])
        self.assertGreater(len(np.unique(pictures[2].reshape(-1, 4), axis=0)), 20)

    def test_refused(self):
        for kind, message, path, values in (
                (shd.Error, "nothing.glb", "nothing.glb", {}),
                (ValueError, "path: .* has a null character", "a\0b", {}),
                (TypeError, "path: a text, not int", 3, {}),
                (shd.Error, "max_triangles|triangles", DUCK, {"max_triangles": 10}),
                (TypeError, "no field max_triangle; did you mean max_triangles", DUCK, {"max_triangle": 1})):
            with self.subTest(message):
                self.check_refused(kind, message, shd.Scene, self.context, path, **values)
        self.check_refused(ValueError, "'bone' is none of mesh, material", self.duck.names, "bone")
        self.check_refused(TypeError, "cannot be pickled", pickle.dumps, self.duck)


class Colors(Case):
    @classmethod
    def setUpClass(cls):
        require_component("shd_color")
        super().setUpClass()
        cls.color = shd.Color(cls.context)

    def test_names(self):
        self.assertEqual((self.color.displays, self.color.working_space), (["sRGB", "Rec.709"], "Linear Rec.709"))
        self.assertEqual(self.color.views("sRGB"), ["ACES 1.0 SDR-video", "Plain", "Raw"])
        self.assertEqual((self.color.default_display, self.color.default_view()), ("sRGB", "ACES 1.0 SDR-video"))
        self.assertIn("ACEScg", self.color.spaces)
        self.assertIn("ocio_profile_version", color.default_config())
        self.assertEqual((self.color.views("none"), self.color.default_view("none")), ([], None))

    def test_display(self):
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, clear_color=(0.25, 0.5, 1, 1))
        plain = self.color.apply(framebuffer, "sRGB", "Plain")
        np.testing.assert_allclose(plain[0, 0], framebuffer.read_color("rgba8_srgb")[0, 0], atol=1)
        out = np.zeros((8, 16, 4), np.uint8)
        both, stats = self.color.render(framebuffer, clear_color=(0.25, 0.5, 1, 1), view="Plain", out=out)
        self.assertIs(both, out)
        np.testing.assert_array_equal(both, plain)
        self.assertEqual(stats["triangle_count"], 0)
        pixels = framebuffer.read_color()
        np.testing.assert_array_equal(self.color.apply_image(pixels, view="Plain"), plain)
        self.assertIs(self.color.convert(pixels, "Linear Rec.709", "ACEScg"), pixels)
        np.testing.assert_allclose(self.color.convert(pixels, "ACEScg")[0, 0], [0.25, 0.5, 1, 1], rtol=1e-4)

    def test_refused(self):
        framebuffer = self.framebuffer()
        self.check_refused(shd.Error, "ACES 1.0 SDR-video", self.color.apply, framebuffer, "sRGB", "Film")
        self.check_refused(TypeError, "out: an array .8..16..4. of uint8", self.color.apply, framebuffer,
                           out=np.zeros((8, 16, 3), np.uint8))
        self.check_refused(TypeError, "framebuffer: Color, not Framebuffer|has no attribute", self.color.apply,
                           self.color)
        self.check_refused(shd.Error, "nothing.ocio", shd.Color, self.context, config_path="nothing.ocio")
        with self.assertRaisesRegex(FileNotFoundError, "nothing.ocio") as raised:
            shd.Color(self.context, shd.ColorDesc(config_path="nothing.ocio"))
        self.assertEqual(raised.exception.filename, "nothing.ocio")
        read_only = np.zeros((2, 2, 4), np.float32)
        read_only.flags.writeable = False
        self.check_refused(ValueError, "pixels: the array is read-only", self.color.convert, read_only, "ACEScg")
        closed = shd.Color(self.context)
        closed.close()
        self.check_refused(ValueError, "the Color is closed", closed.apply, framebuffer)


class Files(Case):
    @classmethod
    def setUpClass(cls):
        require_component("shd_io")
        super().setUpClass()
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.pixels = np.random.default_rng(1).integers(0, 256, (5, 7, 4)).astype(np.uint8)
        cls.pixels[..., 3] = 255

    def test_images(self):
        path = self.folder / "image.png"
        io.save(self.pixels, path, srgb=True)
        bitmap = io.load(self.context, path)
        kept = bitmap.pixels
        bitmap.close()
        np.testing.assert_array_equal(kept, self.pixels)
        self.check_refused(ValueError, "read-only", kept.fill, 0)
        for kind, name in ((np.float32, "grey.hdr"), (np.float64, "grey.hdr"), (np.float16, "grey.exr")):
            grey, file = np.linspace(0, 1, 6).reshape(2, 3).astype(kind), self.folder / name
            try:
                io.save(grey, file)
            except shd.Error as problem:
                self.assertIn("no OpenImageIO for openexr", str(problem))
                continue
            np.testing.assert_allclose(io.load(self.context, file).pixels[..., :3], grey[..., np.newaxis].repeat(3, 2),
                                       atol=1 / 256)
        from_memory = io.load(self.context, path.read_bytes(), formats="png")
        self.assertEqual((from_memory.color_space, from_memory.info["file_format"]), ("sRGB", shd.FileFormat.PNG))
        for source in (path, str(path), path.read_bytes()):
            texture = io.load_texture(self.context, source)
            np.testing.assert_array_equal(texture.read_level(), self.pixels)
        shd.save_png(self.folder / "own.png", self.pixels)
        np.testing.assert_array_equal(io.load(self.context, self.folder / "own.png").pixels, self.pixels)

    def test_framebuffers(self):
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, clear_color=(0.25, 0.5, 1, 1))
        path = self.folder / "frame.hdr"  # which has these numbers exactly
        io.save(framebuffer, path, bit_depth=32)
        np.testing.assert_array_equal(io.load(self.context, path).pixels, framebuffer.read_color())
        require_component("shd_color")
        view = shd.Color(self.context).view("sRGB", "Plain")
        io.save(framebuffer, self.folder / "view.png", display=view)
        io.save(framebuffer, self.folder / "plain.png")
        first, second = (io.load(self.context, self.folder / f"{n}.png").pixels for n in ("view", "plain"))
        np.testing.assert_allclose(first.astype(int), second, atol=1)

    def check_slices(self, texture, slices):
        self.assertEqual(texture.info["depth"], len(slices))
        for i, expected in enumerate(slices):
            np.testing.assert_array_equal(texture.read_level(layer=i)[..., 0], expected)

    def test_volumes(self):
        voxels = np.arange(24, dtype=">u2").reshape(2, 3, 4)
        path = self.folder / "voxels.raw"
        path.write_bytes(b"head" + voxels.tobytes())
        raw = io.load_texture(self.context, path, raw={"width": 4, "height": 3, "depth": 2, "sample": "u16",
                                                       "byte_order": "big", "header_bytes": 4})
        self.check_slices(raw, voxels)
        paths = [self.folder / f"slice{i}.png" for i in range(3)]
        for i, name in enumerate(paths):
            io.save(self.pixels[..., i].copy(), name)
        for stack in ({"paths": paths}, {"pattern": str(self.folder / "slice%d.png"), "first": 0, "last": 2}):
            stack = io.load_texture(self.context, stack=stack)
            self.check_slices(stack, np.moveaxis(self.pixels[..., :3], 2, 0))
        with self.assertRaises(shd.Error):  # neither a grid, nor a library without OpenVDB
            io.load_texture(self.context, path, vdb={})

    def test_texture_files(self):
        path = self.folder / "texture.dds"
        header = np.zeros(32, "<u4")
        header[[1, 3, 4, 7, 19, 20, 22]] = 124, 4, 4, 1, 32, 0x41, 32
        header[23:27] = 0xff, 0xff00, 0xff0000, 0xff000000
        header[0] = int.from_bytes(b"DDS ", "little")
        path.write_bytes(header.tobytes() + self.pixels[:4, :4].tobytes())
        texture = io.load_texture(self.context, path)
        np.testing.assert_array_equal(texture.read_level(), self.pixels[:4, :4])
        self.assertEqual((texture.file["kind"], texture.file["level_count"]), (shd.TextureFileKind.DDS, 1))
        np.testing.assert_array_equal(io.load(self.context, path.read_bytes()).pixels, self.pixels[:4, :4])

    def test_channels(self):
        """Images of one to four channels, with full opacity where they have none."""
        rgb = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
        for pixels, srgb, want in ((rgb, True, np.dstack([rgb, np.full((2, 4), 255)])),
                                   (rgb[..., :2], True, rgb[..., (0, 0, 0, 1)]),
                                   (rgb[..., ::-1], True, np.dstack([rgb[..., ::-1], np.full((2, 4), 255)])),
                                   (rgb[..., 0], False, np.dstack([rgb[..., (0, 0, 0)], np.full((2, 4), 255)]))):
            path = self.folder / "image.png"
            io.save(pixels, path, srgb=srgb)
            np.testing.assert_array_equal(np.asarray(io.load(self.context, path)), want)

    def test_refused(self):
        path = self.folder / "image.bmp"
        for kind, message, call, arguments, values in (
                (shd.Error, "nothing.png", io.load, (self.context, "nothing.png"), {}),
                (shd.Error, "", io.load, (self.context, b"not an image"), {}),
                (shd.Error, "the file is empty", io.load, (self.context, b""), {}),
                (TypeError, "path: a text, not float", io.load_texture, (self.context, 1.5), {}),
                (ValueError, "has a null character", io.save, (self.pixels, "a\0.png"), {}),
                (TypeError, "picture: the array is of int64, not uint8", io.save, ([[0]], path), {}),
                (shd.Error, "jpeg|jpg|extension|format", io.save, (self.pixels, self.folder / "image.jpg"), {}),
                (shd.Error, "bytes", io.load_texture, (self.context, __file__),
                 {"raw": {"width": 2, "height": 2, "depth": 2}}),
                (ValueError, "2 elements, not path_count = 5|path_count", io.load_texture, (self.context,),
                 {"stack": {"paths": ["a.png", "b.png"], "path_count": 5}})):
            with self.subTest(message):
                self.check_refused(kind, message, call, *arguments, **values)


class Absent(Case):
    def test_lazy(self):
        """The package loads no component before its first use, and names a component that is absent."""
        code = ("import shd, sys; maps = open('/proc/self/maps').read(); "
                "assert 'libshd_' not in maps and 'shd.renderer' not in sys.modules\n"
                "try: shd._api.lib.load('shd_nothing')\n"
                "except ImportError as problem: print(problem)")
        run = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, check=True,
                             env={**os.environ, "PYTHONPATH": str(pathlib.Path(shd.__path__[0]).parent)})
        self.assertRegex(run.stdout, "libshd_nothing was not found. Set SHD_LIBRARY to the path of libshd")
