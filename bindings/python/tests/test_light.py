# SPDX-License-Identifier: MIT
"""Environments, shadows, volumes, solid textures, coordinates in polygons, and projections."""
import gc
import threading

import numpy as np

import shd
from support import Allocator, Case

AXES = np.float32([[1, 0, 0], [0, 1, 0], [0, 0, -1]])


class Environments(Case):
    def test_values(self):
        """A sky of radiance 1 has the irradiance pi, and 1 along each direction and lobe."""
        environment = shd.Environment(self.context, np.ones((8, 16, 3), np.float32))
        np.testing.assert_allclose(environment.sample_irradiance(AXES), np.pi, rtol=1e-3)
        np.testing.assert_array_equal(environment.sample_radiance(AXES), 1)
        lobes = environment.sample_radiance(AXES.reshape(3, 1, 3), roughness=np.float32([0.1, 0.5, 1]))
        self.assertEqual(lobes.shape, (3, 1, 3))
        np.testing.assert_allclose(lobes, 1, rtol=1e-3)
        lobes = environment.sample_radiance(list(AXES.T), exponent=np.float32([1, 8, 64]))
        np.testing.assert_allclose(lobes, 1, rtol=1e-3)
        out = np.zeros((3, 4), np.float32)
        self.assertIs(environment.sample_radiance(AXES, out=out[:, :3]).base, out)
        np.testing.assert_array_equal(out, [[1, 1, 1, 0]] * 3)
        self.assertEqual(environment.info["mean"], (1, 1, 1))

    def test_frame(self):
        image = np.zeros((4, 8, 3), np.float32)
        image[..., 1] = 0.5
        environment = shd.Environment(self.context, image, tables="radiance")
        framebuffer = self.framebuffer()
        shd.render(self.context, framebuffer, environment=environment, background="environment",
                   camera=shd.Camera())
        np.testing.assert_allclose(framebuffer.plane("g"), 0.5, rtol=1e-6)
        environment.close()
        self.check_refused(ValueError, "environment is closed|Environment is closed", environment.sample_radiance, AXES)

    def test_refused(self):
        environment = shd.Environment(self.context, np.ones((4, 8), np.float32), tables="radiance")
        for kind, message, call, values in (
                (ValueError, "direction: the last axis has 2", environment.sample_radiance, {"direction": AXES[:, :2]}),
                (ValueError, "different lengths: direction.0. 3", environment.sample_radiance,
                 {"direction": AXES, "roughness": np.zeros(2, np.float32)}),
                (ValueError, "direction: 2 columns, not 3", environment.sample_radiance, {"direction": list(AXES[:2])}),
                (TypeError, "direction: an array .count..components.", environment.sample_radiance, {"direction": 3}),
                (ValueError, "out .channel.: 2 rows, not 3", environment.sample_radiance,
                 {"direction": AXES, "out": np.zeros((2, 3), np.float32)}),
                (shd.Error, "GGX|ggx|roughness", environment.sample_radiance,
                 {"direction": AXES, "roughness": np.zeros(3, np.float32)})):
            with self.subTest(message):
                self.check_refused(kind, message, call, **values)
        self.check_refused(TypeError, "of int64", shd.Environment, self.context, np.ones((4, 8), int))
        self.check_refused(shd.InvalidArgument, "image", shd.Environment, self.context)
        self.check_refused(ValueError, "'sphere' is none of", shd.Environment, self.context,
                           np.ones((4, 8), np.float32), projection="sphere")


class Shadows(Case):
    def setUp(self):
        self.sun = shd.Light(self.context, kind="directional", direction=(0, 0, -1))
        square = self.square()
        self.caster = [shd.Draw(mesh=square)]
        self.points = np.float32([[0, 0, 0], [0, 0, 0.9], [5, 0, 0]])

    def test_values(self):
        """The square at z = 0.5 hides the first point."""
        shadow = shd.Shadow(self.context, size=64)
        shadow.render(self.context, self.sun, self.caster)
        np.testing.assert_array_equal(shadow.sample(self.points), [0, 1, 1])
        normals, out = np.float32([[0, 0, 1]] * 3), np.zeros(3, np.float32)
        self.assertIs(shadow.sample(self.points, normals, out), out)
        np.testing.assert_array_equal(out, [0, 1, 1])

    def test_map(self):
        """The square is half a unit nearer to the light than the origin."""
        shadow = shd.Shadow(self.context, size=64)
        self.assertEqual(shadow.info["face_count"], 0)
        self.check_refused(shd.InvalidArgument, "not rendered", shadow.read_map)
        shadow.render(self.context, self.sun, self.caster)
        depths, info = shadow.read_map(), shadow.info
        self.assertEqual((depths.shape, info["filter"]), ((64, 64), shd.ShadowFilter.HARD))
        np.testing.assert_allclose(depths[np.isfinite(depths)], -0.5, atol=1e-5)
        self.assertTrue(np.isinf(depths[0, 0]) and np.isfinite(depths[32, 32]))
        self.assertTrue(info["near_plane"] < -0.5 < info["far_plane"])
        self.check_refused(shd.InvalidArgument, "face: 1", shadow.read_map, 1)
        moments = shd.Shadow(self.context, size=64, filter="variance")
        moments.render(self.context, self.sun, self.caster)
        np.testing.assert_allclose(moments.read_map()[32, 32], [-0.5, 0], atol=1e-5)

    def test_threads(self):
        """A map is rendered by one call; later calls work."""
        shadow, entered, leave = shd.Shadow(self.context, size=16), threading.Event(), threading.Event()

        def wait(vertices, out):
            entered.set()
            leave.wait(10)

        material = shd.Material(self.context, program={"vertex": wait})
        draws = [self.caster[0].replace(material=material)]
        thread = threading.Thread(target=shadow.render, args=(self.context, self.sun, draws))
        thread.start()
        self.assertTrue(entered.wait(10))
        self.check_refused(ValueError, "shadow: another call renders it", shadow.render, self.context, self.sun)
        leave.set()
        thread.join(10)
        shadow.render(self.context, self.sun, self.caster)

    def test_refused(self):
        shadow = shd.Shadow(self.context, size=16)
        self.check_refused(shd.Error, "map|rendered", shadow.sample, self.points)
        self.check_refused(shd.InvalidArgument, "light", shadow.render, self.context)
        self.check_refused(shd.InvalidArgument, "size", shd.Shadow, self.context, size=3)

        def fail(vertices, out):
            raise KeyError("from the program")

        draws = [self.caster[0].replace(material=shd.Material(self.context, program={"vertex": fail}))]
        self.check_refused(KeyError, "from the program", shadow.render, self.context, self.sun, draws)
        shadow.render(self.context, self.sun, self.caster)
        self.check_refused(ValueError, "out .visibility.: 2 rows, not 3", shadow.sample, self.points,
                           out=np.zeros(2, np.float32))
        shadow.close()
        self.check_refused(ValueError, "the Shadow is closed", shadow.sample, self.points)


class Volumes(Case):
    def volume(self, **values):
        texture = shd.Texture(self.context, np.ones((2, 2, 2), np.float32), depth=2)
        return shd.Volume(self.context, texture, **{"density": [0, 1], "extinction": [0, 2], **values})

    def test_frame(self):
        """Light through a box of depth 1 is exp(-2); columns of the transfer function are copied."""
        framebuffer = self.framebuffer()
        volume = self.volume(color=np.float32([[0, 0, 0], [0, 0, 1]]), bounds_min=(-9, -9, 0), bounds_max=(9, 9, 1))
        shd.render(self.context, framebuffer, volumes=[shd.VolumeDraw(volume=volume)],
                   camera=shd.Camera(eye=(0, 0, 3), fov_y=0.01))
        np.testing.assert_allclose(framebuffer.plane("b"), 1 - np.exp(-2), rtol=1e-3)

    def test_refused(self):
        for kind, message, values in (
                (ValueError, "different lengths: density 2, extinction 3", {"extinction": [0, 1, 2]}),
                (ValueError, "point_count 7, density 2", {"point_count": 7}),
                (ValueError, "color.0. 3", {"color": np.zeros((3, 3), np.float32)}),
                (shd.InvalidArgument, "density", {"density": [1, 0]}),
                (shd.InvalidArgument, "step", {"step": 0})):
            with self.subTest(message):
                self.check_refused(kind, message, self.volume, **values)
        self.check_refused(TypeError, "texture: Sampler, not Texture", shd.Volume, self.context,
                           shd.Sampler(self.context), density=[0], extinction=[1])


class Solids(Case):
    def test_values(self):
        place = np.float32([[0.5, 0.5, 0.5], [1.5, 0.5, 0.5]])
        np.testing.assert_array_equal(shd.evaluate_solid(self.context, place, kind="checker"), [0, 1])
        colors = [(1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 0.5)]
        value, color = shd.evaluate_solid(self.context, place, kind="checker", colors=colors, want=("value", "channel"))
        np.testing.assert_array_equal(color, [colors[0], colors[2]])
        grid = np.float32(np.random.default_rng(5).uniform(-9, 9, (4, 5, 3)))
        noise = shd.evaluate_solid(self.context, grid, kind="perlin", octaves=6)
        self.assertEqual(noise.shape, (4, 5))
        self.assertTrue(0.1 < np.ptp(noise) < 2)
        step = np.float32([1 / 1024, 0, 0])
        slope = shd.evaluate_solid(self.context, grid, kind="perlin", want="gradient")
        around = [shd.evaluate_solid(self.context, grid + s, kind="perlin") for s in (step, -step)]
        np.testing.assert_allclose((around[0] - around[1]) * 512, slope[..., 0], atol=2e-3)
        blurred = shd.evaluate_solid(self.context, grid, kind="checker", width=np.full((4, 5), 64, np.float32))
        np.testing.assert_allclose(blurred, 0.5, atol=0.05)

    def test_refused(self):
        place = np.zeros((2, 3), np.float32)
        for kind, message, values in (
                (ValueError, "outputs: 'height' is none of value, gradient, channel", {"want": "height"}),
                (ValueError, "color_count: 2, but the list has 3", {"colors": [(0, 0, 0, 1)] * 3, "color_count": 2}),
                (ValueError, "an array of shape .9, 4., not .1..8..4.", {"colors": np.zeros((9, 4))}),
                (shd.InvalidArgument, "octaves", {"octaves": 99}),
                (ValueError, "1 arrays for 2 outputs", {"want": ("value", "channel"), "out": [place]}),
                (TypeError, "no field octave; did you mean octaves", {"octave": 2})):
            with self.subTest(message):
                self.check_refused(kind, message, shd.evaluate_solid, self.context, place, **values)


class Polygons(Case):
    """Coordinates in polygons and polyhedra: their sums, and the points that they reproduce."""

    SQUARE = np.float32([[0, 0], [2, 0], [2, 1], [0, 1]])
    OCTAHEDRON = np.float32([[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]])
    FACES = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]]

    def test_polygon(self):
        points = np.float32(np.random.default_rng(2).uniform(0.01, 0.99, (3, 5, 2))) * (2, 1)
        for kind in ("wachspress", "mean_value", "discrete_harmonic"):
            weights = shd.evaluate_polygon(self.context, self.SQUARE, points, kind=kind)
            self.assertEqual((weights.shape, weights.dtype), ((3, 5, 4), np.float32))
            np.testing.assert_allclose(weights.sum(axis=-1), 1, atol=1e-6)
            np.testing.assert_allclose(weights @ self.SQUARE, points, atol=1e-6)
        np.testing.assert_allclose(shd.evaluate_polygon(self.context, self.SQUARE, [[1, 0.5]]), [[0.25] * 4], atol=1e-6)
        out = np.zeros((15, 4), np.float32)
        self.assertIs(shd.evaluate_polygon(self.context, self.SQUARE, points.reshape(-1, 2), out=out), out)
        np.testing.assert_array_equal(out.reshape(3, 5, 4), shd.evaluate_polygon(self.context, self.SQUARE, points))
        self.check_refused(shd.InvalidArgument, "polygon.vertex_count: 2", shd.evaluate_polygon, self.context,
                           self.SQUARE[:2], points)
        self.check_refused(ValueError, "out: columns of .15, 15, 15, 15. rows, not 2", shd.evaluate_polygon, self.context,
                           self.SQUARE, points[0, :2], out=out)
        self.check_refused(TypeError, "no field kin", shd.evaluate_polygon, self.context, self.SQUARE, points, kin=1)

    def test_polyhedron(self):
        points = np.random.default_rng(3).uniform(-0.3, 0.3, (4, 6, 3))
        moved = self.OCTAHEDRON @ [[0, 2, 0], [1, 0, 1], [0, 0, 3]] + (1, 2, 3)
        for kind in ("mean_value", "wachspress"):
            with shd.Polyhedron(self.context, self.OCTAHEDRON, self.FACES, kind=kind) as cage:
                weights = cage.evaluate(points)
                self.assertEqual((weights.shape, weights.dtype), ((4, 6, 6), np.float32))
                np.testing.assert_allclose(weights.sum(axis=-1), 1, atol=1e-6)
                np.testing.assert_allclose(weights @ self.OCTAHEDRON, points, atol=1e-6)
                np.testing.assert_allclose(cage.interpolate(points, moved), weights @ moved, atol=2e-6)
                np.testing.assert_allclose(cage.evaluate(self.OCTAHEDRON), np.eye(6), atol=1e-6)
                out = np.zeros((24, 1), np.float32)
                self.assertIs(cage.interpolate(points.reshape(-1, 3), np.ones((6, 1)), out=out), out)
                np.testing.assert_allclose(out, 1, atol=1e-6)
                self.assertEqual(cage.evaluate(np.zeros((0, 3))).shape, (0, 6))
                self.check_refused(ValueError, "value: an array .6..values., not of shape .5, 3.", cage.interpolate,
                                   points, moved[:5])
            self.check_refused(ValueError, "closed", cage.evaluate, points)
        make = shd.Polyhedron
        self.check_refused(shd.InvalidArgument, "polyhedron", make, self.context, self.OCTAHEDRON, self.FACES[:-1])
        self.check_refused(ValueError, "polyhedron.indices", make, self.context, self.OCTAHEDRON, -np.int64(self.FACES))
        self.check_refused(TypeError, "no field kid; did you mean kind", make, self.context, self.OCTAHEDRON, self.FACES,
                           kid="wachspress")


class Memory(Case):
    def test_given_back(self):
        allocator = Allocator()
        context = shd.Context(worker_count=1, allocator=allocator.options())
        environment = shd.Environment(context, np.ones((4, 8), np.float32))
        shadow = shd.Shadow(context, size=16)
        shadow.render(context, shd.Light(context, kind="directional"), [shd.Draw(mesh=self.square(context))])
        texture = shd.Texture(context, np.ones((2, 2, 2), np.float32), depth=2)
        volume = shd.Volume(context, texture, density=[0, 1], extinction=[0, 1])
        for values in ({"density": [1, 0]}, {"step": -1}):
            with self.assertRaises(shd.InvalidArgument):
                shd.Volume(context, texture, **{"density": [0, 1], "extinction": [0, 1], **values})
        with shd.Renderer(8, 8, context=context) as renderer:
            renderer.add(position=np.eye(3), color=(1.0, 0, 0))
            renderer.render(shadows=True)
        for made in (environment, shadow, volume):
            made.close()
            made.close()
        del context, environment, shadow, volume, texture, renderer
        gc.collect()
        self.assertGreater(allocator.total, 0)
        self.assertEqual(allocator.live, 0)


class Projections(Case):
    def test_round_trip(self):
        rng = np.random.default_rng(3)
        direction = rng.normal(size=(6, 7, 3)).astype(np.float32)
        direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
        for projection in ("lat_long", "mirror_ball", "angular", "octahedral", "cube"):
            u, v, face = shd.project(self.context, direction, projection, want=("u", "v", "face"))
            back = shd.unproject(self.context, u, v, projection, face=face)
            np.testing.assert_allclose(back, direction, atol=2e-5)
        self.assertEqual(shd.unproject(self.context, [0.5], [0.5], want="solid_angle").shape, (1,))

    def test_convert(self):
        sky = np.zeros((8, 16, 3), np.float32)
        sky[:4] = 1
        faces = [np.zeros((4, 4, 3), np.float32) for _ in range(6)]
        shd.convert_projection(self.context, sky, faces)
        self.assertEqual((faces[2].min(), faces[3].max()), (1, 0))
        for kind, message, target, values in (
                (ValueError, "target: 5 images, not 6", faces[:5], {}),
                (ValueError, "target: 6 images, not 1", faces, {"target_projection": "lat_long"}),
                (ValueError, "target.0.: a writable", [[0]], {"target_projection": "lat_long"}),
                (TypeError, "of float64", np.zeros((8, 8, 3)), {"target_projection": "octahedral"})):
            with self.subTest(message):
                self.check_refused(kind, message, shd.convert_projection, self.context, sky, target, **values)
