# SPDX-License-Identifier: MIT
"""Bakes and ambient occlusion: values, tracers of Python and of Embree, misuse."""
import numpy as np

import shd
from shd import embree
from support import Case, require_component


class Bakes(Case):
    def test_program(self):
        """The texture coordinates of a square, as colours of its texels."""
        def uv(fragments, out):
            out.r[:], out.g[:] = fragments.u, fragments.v

        framebuffer, states = self.framebuffer(8, 4), np.full((4, 8), 9, np.uint32)
        material = shd.Material(self.context, model="program", program={"fragment": uv})
        stats = shd.bake(self.context, framebuffer, [shd.Draw(mesh=self.square(), material=material)], states=states)
        np.testing.assert_allclose(framebuffer.plane("r")[0], (np.arange(8) + 0.5) / 8, atol=1e-6)
        np.testing.assert_allclose(framebuffer.plane("g")[:, 0], (np.arange(4) + 0.5) / 4, atol=1e-6)
        self.assertEqual((stats["center_texel_count"], np.unique(states).tolist()), (32, [shd.TexelState.CENTER]))

    def test_refused(self):
        framebuffer, draws = self.framebuffer(8, 4), [shd.Draw(mesh=self.square())]
        bake = lambda **values: shd.bake(self.context, framebuffer, draws, **values)
        self.check_refused(shd.Error, "material", bake)
        self.check_refused(ValueError, "states: 16 rows, not 32", bake, states=np.zeros(16, np.uint32))
        self.check_refused(TypeError, "states: the array is of float32", bake, states=np.zeros(32, np.float32))
        self.check_refused(shd.InvalidArgument, "dilation", bake, dilation=5000)

        def fail(fragments, out):
            raise KeyError("from the program")

        draws[0].material = shd.Material(self.context, model="program", program={"fragment": fail})
        self.check_refused(KeyError, "from the program", bake)


class Occlusion(Case):
    """A floor at y = 0, and a roof at y = 0.5 over a half of it."""

    def setUp(self):
        quad = np.float32([[-1, 0, 1], [1, 0, 1], [-1, 0, -1], [1, 0, -1]])
        uv = np.float32([[0, 0], [1, 0], [0, 1], [1, 1]])
        self.floor = shd.Draw(mesh=shd.Mesh(self.context, quad, uv=uv, topology="strip"))
        roof = quad * np.float32([2, 0, 2]) + np.float32([2, 0.5, 0])
        self.draws = [self.floor, shd.Draw(mesh=shd.Mesh(self.context, roof, topology="strip"))]
        self.points = np.float32([[-9, 0, 0], [2, 0, 0]])
        self.up = np.float32([[0, 1, 0]] * 2)

    def test_points(self):
        values = shd.occlusion(self.context, self.points, self.up, draws=self.draws, ray_count=64)
        np.testing.assert_allclose(values, [1, 0], atol=0.1)
        self.assertEqual(shd.occlusion(self.context, self.points.reshape(2, 1, 3), self.up.reshape(2, 1, 3)).shape,
                         (2, 1))
        column = shd.vertex_occlusion(self.context, self.floor, draws=self.draws)
        self.assertEqual(column.shape, (4,))
        shd.Mesh(self.context, np.zeros((4, 3), np.float32), topology="strip", attributes=[column])

    def test_tracer_of_python(self):
        def trace(rays, blocked):
            blocked[:] = rays.ox > 0

        values = shd.occlusion(self.context, self.points, self.up, tracer={"trace": trace})
        np.testing.assert_array_equal(values, [1, 0])

        def fail(rays, blocked):
            raise KeyError("from the tracer")

        self.check_refused(KeyError, "from the tracer", shd.occlusion, self.context, self.points, self.up,
                           tracer={"trace": fail})

    def test_embree(self):
        require_component("shd_embree")
        with embree.Tree(self.context, self.draws) as tree:
            tracer = tree.tracer
            values = shd.occlusion(self.context, self.points, self.up, tracer=tracer, ray_count=256)
        np.testing.assert_allclose(values, [1, 0], atol=0.1)
        self.check_refused(ValueError, "tracer: the Tree is closed", shd.occlusion, self.context, self.points, self.up,
                           tracer=tracer)
        self.check_refused(TypeError, "draws.0.: int, not Draw", embree.Tree, self.context, [3])

    def test_atlas(self):
        image, stats = shd.bake_occlusion(self.context, 8, 4, [self.floor], draws=self.draws, ray_count=16)
        self.assertEqual((image.shape, stats["center_texel_count"]), ((4, 8), 32))
        self.assertGreater(image[:, 0].mean(), image[:, 7].mean() + 0.3)
        open_sky, _ = shd.bake_occlusion(self.context, 8, 4, [self.floor], ray_count=16)
        np.testing.assert_allclose(open_sky, 1, atol=0.01)
        self.check_refused(ValueError, "out: 9 rows, not 32", shd.bake_occlusion, self.context, 8, 4, [self.floor],
                           out=np.zeros(9, np.float32))
        self.check_refused(shd.InvalidArgument, "ray_count", shd.occlusion, self.context, self.points, self.up,
                           ray_count=0)
        self.check_refused(ValueError, "different lengths", shd.occlusion, self.context, self.points, self.up[:1])
