# SPDX-License-Identifier: MIT
"""Objects and descs: lifetimes, misuse, pickling, and memory that is given back."""
import ast
import enum
import gc
import pathlib
import pickle
import threading

import numpy as np

import shd
from shd import _api
from support import Allocator, Case


class Lifetimes(Case):
    def test_close(self):
        with shd.Sampler(self.context) as sampler:
            sampler.close()
            sampler.close()
        texture, half = self.checker(), np.float32([0.5])
        self.check_refused(ValueError, "sampler: the Sampler is closed", texture.sample, sampler, half, half)
        texture.close()
        self.check_refused(ValueError, "the Texture is closed", lambda: texture.info)
        context = shd.Context()
        sampler = shd.Sampler(context)
        context.close()
        self.check_refused(ValueError, "the Context is closed", shd.Sampler, context)
        texture = self.checker()
        texture.sample(sampler, half, half)  # objects keep what they need

    def test_views_outlive(self):
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, clear_color=(0.25, 0, 0, 1))
        red, depth = framebuffer.plane("r"), framebuffer.plane(shd.Plane.DEPTH)
        framebuffer.close()
        del framebuffer
        gc.collect()
        others = [self.framebuffer() for _ in range(8)]
        self.assertEqual((red.shape, float(red.min()), float(depth.max())), ((8, 16), 0.25, 1.0))
        self.check_refused(ValueError, "read-only", red.fill, 0)
        del others

    def test_memory(self):
        allocator = Allocator()
        context = shd.Context(worker_count=1, allocator=allocator.options())
        framebuffer = shd.Framebuffer(context, 16, 8)
        material = shd.Material(context, model="unlit", slots=[shd.slot("diffuse", self.checker(context))])
        shd.render(context, framebuffer, [shd.Draw(mesh=self.square(context), material=material)])
        with self.assertRaises(shd.InvalidArgument):
            shd.Sampler(context, max_anisotropy=-1)
        view = framebuffer.plane("r")
        del context, material, framebuffer
        gc.collect()
        self.assertGreater(allocator.live, 0)
        del view
        gc.collect()
        self.assertGreater(allocator.total, 0)
        self.assertEqual(allocator.live, 0)

    def test_repr(self):
        texture = shd.Texture(self.context, np.zeros((3, 2, 4), np.uint8), srgb=True)
        stack = shd.Texture(self.context, np.zeros((2, 8, 8), np.uint8), layer_count=2, tables="mipmap")
        for made, text in (
                (texture, "Texture 2x3 RGBA8_SRGB 1 level"), (stack, "Texture 8x8 R8 2 layers 4 levels"),
                (self.framebuffer(sample_count=4), "Framebuffer 16x8 RGBA32F 4 samples"),
                (shd.Sampler(self.context), "Sampler"),
                (shd.Sampler(self.context, filter=shd.Filter.EWA, lod_bias=2), "Sampler filter=ewa lod_bias=2"),
                (shd.Material(self.context, model="unlit", diffuse=(1, 0, 0)), "Material model=unlit"),
                (shd.Light(self.context, shd.LightDesc(kind="point")), "Light kind=point"),
                (self.square(), "Mesh 4 vertices 2 triangles"),
                (self.context, f"Context 1 worker {self.context.simd_target}")):
            self.assertEqual(repr(made), f"<shd.{text}>")
        texture.close()
        self.assertEqual(repr(texture), "<shd.Texture closed>")

    def test_texts(self):
        """Constants are names in every text, and numbers still work as numbers."""
        ewa = shd.Filter.EWA
        self.assertEqual((str(ewa), f"{ewa}", f"{ewa:>12}", f"{ewa:d}", f"{ewa:03d}"),
                         ("Filter.EWA", "Filter.EWA", "  Filter.EWA", "9", "009"))
        self.assertIn(str(shd.Aov.UV | shd.Aov.NORMAL), ("Aov.UV|NORMAL", "Aov.NORMAL|UV"))
        self.assertEqual(repr(shd.SamplerDesc(filter=shd.Filter.EWA, wrap_u="repeat")),
                         "SamplerDesc(filter=Filter.EWA, wrap_u='repeat')")
        self.assertEqual(repr(shd.Draw(instances=np.zeros((9, 16), np.float32))), "Draw(instances=<float32 9x16>)")
        text = str(shd.SamplerDesc(max_anisotropy=2))
        self.assertIn("\n    filter = Filter.TRILINEAR\n", text)
        self.assertIn("\n    max_anisotropy = 2", text)
        self.assertEqual(str(shd.Result.OK), "Result.OK")

    def test_docs(self):
        """Texts of the headers have the words of Python."""
        for text, words in ((shd.SamplerDesc.__doc__, ("    filter: default \"trilinear\"\n", "(Magnification)")),
                            (shd.FramebufferDesc.__doc__, ('"rgba32f", four planes', '"rgba16f", "rgba8_srgb"')),
                            (shd.Filter.__doc__, ("\nNames:\n    trilinear: Bilinear on the two",)),
                            (shd.Texture.__doc__, ('kind: default "2d"',))):
            for word in words:
                self.assertIn(word, text)
            self.assertNotRegex(text, r"SHD_FILTER|SHD_FORMAT|\bNULL\b")
        python = _api.words.python
        self.assertEqual(python("shd_texture_create() of a shd_texture; NULL; SHD_ERROR_IO; shd_version()"),
                         "Texture() of a Texture; None; Result.ERROR_IO; shd_version()")

    def test_module(self):
        """The names of the module are those of the library alone."""
        self.assertEqual([n for n in dir(shd) if not n.startswith("__")], shd.__all__)
        self.assertFalse({"importlib", "renderer", "desc_type", "ctypes"} & set(dir(shd)))
        for name in shd.__all__:
            getattr(shd, name)
        self.assertEqual(shd.__version__, ".".join(map(str, shd.version())))

    def test_out_of_memory(self):
        """An allocator that serves small blocks only."""
        allocator = Allocator()
        allocate = lambda size, alignment: allocator.allocate(size, alignment) if size < 1 << 20 else None
        context = shd.Context(worker_count=1, allocator={"allocate": allocate, "free": allocator.free})
        self.check_refused(MemoryError, "memory", shd.Framebuffer, context, 4096, 4096)
        del context
        gc.collect()
        self.assertEqual(allocator.live, 0)

    def test_threads(self):
        """A framebuffer serves one render; other objects are shared."""
        framebuffer, entered, leave = self.framebuffer(), threading.Event(), threading.Event()

        def wait(fraction):
            entered.set()
            leave.wait(10)

        values = {"progress": {"report": wait}}
        thread = threading.Thread(target=shd.render, args=(self.context, framebuffer), kwargs=values)
        thread.start()
        self.assertTrue(entered.wait(10))
        self.check_refused(ValueError, "another call renders to it", shd.render, self.context, framebuffer)
        framebuffer.close()  # the call keeps it
        leave.set()
        thread.join()


class Descs(Case):
    def test_fields(self):
        desc = shd.SamplerDesc(filter="ewa", max_anisotropy=8)
        self.assertEqual(desc.filter, "ewa")
        self.assertEqual(shd.SamplerDesc().filter, shd.Filter.TRILINEAR)
        self.assertEqual(shd.Camera().up, (0, 1, 0))
        desc.lod_bias = -0.5
        self.assertEqual(desc, shd.SamplerDesc(filter="ewa", max_anisotropy=8, lod_bias=-0.5))
        self.assertNotEqual(desc, desc.replace(lod_bias=0))
        self.assertIn("max_anisotropy=8", repr(desc))
        shd.Sampler(self.context, desc, filter=shd.Filter.ANISOTROPIC)
        self.check_refused(TypeError, "SamplerDesc has no field fliter; did you mean filter?", shd.SamplerDesc,
                           fliter=1)
        self.check_refused(AttributeError, "no field nothing", lambda: desc.nothing)
        self.check_refused(ValueError, "sampler.filter: 'best' is none of trilinear, nearest", shd.Sampler,
                           self.context, filter="best")
        self.check_refused(shd.InvalidArgument, "sampler.max_anisotropy|max_anisotropy", shd.Sampler, self.context,
                           max_anisotropy=-1)
        self.check_refused(TypeError, "max_anisotropy", shd.Sampler, self.context, max_anisotropy="large")
        self.check_refused(ValueError, "border_color|3 numbers, not 4", shd.Sampler, self.context, border=(1, 2, 3))

    def test_lengths(self):
        """A length that is not that of its list is refused before C reads beyond the list."""
        draw, light = shd.Draw(mesh=self.square()), shd.Light(self.context)
        render = lambda **values: shd.render(self.context, self.framebuffer(), **values)
        for kind, message, values in (
                (ValueError, "render.draws: 1 elements, not draw_count = 3", {"draws": [draw], "draw_count": 3}),
                (ValueError, "not light_count = [12]", {"lights": [light, light], "shadows": [None]}),
                (ValueError, r"shape \(1, 15\), not", {"draws": [draw.replace(instances=np.zeros((1, 15), "f4"))]}),
                (ValueError, "instance_count = 2", {"draws": [draw.replace(instances=np.zeros((1, 16), "f4"),
                                                                           instance_count=2)]}),
                (TypeError, "draw.mesh: Light, not Mesh", {"draws": [shd.Draw(mesh=light)]}),
                (TypeError, "draw.mesh: int, not Mesh", {"draws": [shd.Draw(mesh=5)]}),
                (TypeError, r"draws\[0\]: Camera, not Draw", {"draws": [shd.Camera()]}),
                (TypeError, "lights: a list, not Light", {"lights": light}),
                (TypeError, "uniforms: an array of numbers or bytes, not int", {"draws": [draw.replace(uniforms=5)]})):
            with self.subTest(message):
                self.check_refused(kind, message, render, **values)
        render(draws=[draw], draw_count=1, lights=[light], shadows=[None])

    def test_pickle(self):
        for desc in (shd.SamplerDesc(filter="ewa", border=(0, 0, 0, 1)),
                     shd.MeshDesc(position=np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]])),
                     shd.RenderDesc(camera=shd.Camera(eye=(0, 0, 5)), clear_color=(1, 0, 0, 1))):
            self.assertEqual(pickle.loads(pickle.dumps(desc)), desc)
        self.check_refused(TypeError, "a Texture cannot be pickled", pickle.dumps, shd.Slot(texture=self.checker()))
        error = shd.InvalidArgument(1, "text")
        self.assertEqual((str(pickle.loads(pickle.dumps(error))), error.result), ("text", shd.Result(1)))

    def test_docs(self):
        self.assertIn("anisotropy", shd.SamplerDesc.__doc__)
        self.assertIn("Required: format", shd.Texture.__doc__)
        self.assertIn("max_anisotropy", dir(shd.SamplerDesc()))
        self.assertIn("RenderDesc", dir(shd))
        self.assertIn("EWA", shd.Filter.__members__)
        self.check_refused(AttributeError, "no attribute nothing", lambda: shd.nothing)
        self.assertEqual(shd.__version__, ".".join(str(part) for part in shd.version()))
        self.assertNotIn("importlib", dir(shd))


class Stubs(Case):
    def test_names(self):
        """Classes and members of the stubs are those of the module."""
        tree = ast.parse((pathlib.Path(shd.__file__).parent / "__init__.pyi").read_text(encoding="utf-8"))
        classes = [node for node in tree.body if isinstance(node, ast.ClassDef) and node.name in shd._names]
        self.assertGreater(len(classes), 100)
        for node in classes:
            made = getattr(shd, node.name)
            members = made.__members__ if isinstance(made, enum.EnumMeta) else made._fields
            declared = {t.id for n in node.body if isinstance(n, ast.Assign) for t in n.targets}
            declared |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            self.assertEqual(declared, set(members) - {"struct_size"}, node.name)
        names = {node.name for node in classes}
        self.assertEqual({n for n in shd.__dir__() if n in shd._names}, names)
        declared = {n.name for n in tree.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        declared |= {alias.asname for n in tree.body if isinstance(n, ast.ImportFrom) and n.level for alias in n.names}
        self.assertEqual({n for n in declared if not n.startswith("_")}, set(shd.__all__))


class Meshes(Case):
    def test_round_trip(self):
        position = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
        for dtype in (np.uint16, np.uint32):
            mesh = shd.Mesh(self.context, position, np.array([[0, 1, 2], [1, 3, 2]], dtype), uv=position[:, :2])
            np.testing.assert_array_equal(mesh.positions, position)
            np.testing.assert_array_equal(mesh.uv, position[:, :2])
            np.testing.assert_array_equal(mesh.indices, [[0, 1, 2], [1, 3, 2]])
            np.testing.assert_array_equal(mesh.normals, [[0, 0, 1]] * 4)
        columns = shd.Mesh(self.context, [position[:, 0], position[:, 1], position[:, 2]], [0, 1, 2])
        self.assertEqual(columns.info["triangle_count"], 1)
        self.assertEqual(shd.Mesh.shape(self.context, kind="box").info["triangle_count"], 12)

    def test_refused(self):
        position = np.zeros((3, 3), np.float32)
        make = lambda *arguments, **values: shd.Mesh(self.context, *arguments, **values)
        self.check_refused(ValueError, "position.*2 elements, not 3", make, position[:, :2].copy())
        self.check_refused(ValueError, r"different lengths: position\[0\] 3.*uv\[0\] 2", make, position,
                           uv=np.zeros((2, 2), np.float32))
        self.check_refused(TypeError, "mesh.indices: integers, not float64", make, position, [0.0, 1.0, 2.0])
        self.check_refused(ValueError, r"mesh.indices\[1\]: 4294967296 is not in 0..4294967295", make, position,
                           np.array([0, 1 << 32, -1]))
        self.check_refused(ValueError, r"mesh.indices\[2\]: -1 is not in", make, position, np.int8([0, 1, -1]))
        self.check_refused(TypeError, "mesh.*position: an array .count..3. or a list of columns, not a number", make, 3)
        self.check_refused(shd.InvalidArgument, "indices", make, position, np.uint32([0, 1, 7]))
        self.check_refused(ValueError, "vertex_count 9", make, position, vertex_count=9)
        self.check_refused(ValueError, "index_count: 6, but indices has 3", make, position, [0, 1, 2], index_count=6)
        self.check_refused(ValueError, "5 columns|4 columns, not 3", make, [position[:, 0]] * 4)
