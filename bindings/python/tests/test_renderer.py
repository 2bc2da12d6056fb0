# SPDX-License-Identifier: MIT
"""The renderer: meshes of trimesh (stand-ins), arrays and files; cameras, depths, misuse."""
import pathlib
import threading
import unittest

import numpy as np

import shd
from shd import _camera
from shd._material import options_of
from shd._trimesh import surface_of
from shd.pyrender.material import material_of
from support import Case, require_component
from trimesh_like import (UV, ColorVisuals, Image, PBRMaterial, Scene, SimpleMaterial, TextureVisuals, Trimesh, square)

QUARTERS = np.uint8([[[255, 0, 0, 255], [0, 255, 0, 255]], [[0, 0, 255, 255], [255, 255, 255, 255]]])
IMAGE = QUARTERS.repeat(8, axis=0).repeat(8, axis=1)
BOX = "/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb"


class Renderers(Case):
    def renderer(self, size=32, **values):
        """A renderer whose picture is the square from -1 to 1 at z = 0."""
        made = shd.Renderer(size, size, context=self.context, **values)
        made.look_from(_camera.look_at((0, 0, 2)), yfov=2 * np.arctan(0.5))
        self.addCleanup(made.close)
        return made

    def corners(self, color):
        """The colours in the quarters of a picture."""
        quarter = color.shape[0] // 4
        return color[quarter::2 * quarter, quarter::2 * quarter, :3]

    def check_quarters(self, renderer):
        np.testing.assert_array_equal(self.corners(renderer.render(flat=True)[0]), QUARTERS[..., :3])


class Models(Renderers):
    def test_textures_of_trimesh(self):
        """The first row of an image is on top, where v is 1."""
        for material in (SimpleMaterial(Image(IMAGE)), PBRMaterial(baseColorTexture=Image(IMAGE)),
                         SimpleMaterial(IMAGE[..., :3])):
            renderer = self.renderer()
            renderer.add(square(TextureVisuals(UV, material)))
            self.check_quarters(renderer)

    def test_materials_of_trimesh(self):
        """Renderer and pyrender read the same numbers: an exponent p is a roughness of (2 / (p + 2)) ^ 1/4."""
        for glossiness, kept, exponent in ((0.0, {}, 0), (14.0, {}, 14), (np.array([14.0]), {}, 14), (14.0, {"Ns": 30}, 30),
                                           (None, {}, 1), (None, {"Ns": [30.0]}, 30), (-5.0, {}, 0), (14.0, None, 14)):
            simple = SimpleMaterial(diffuse=(51, 102, 153, 255), glossiness=glossiness)
            simple.kwargs = kept
            want = (2 / (exponent + 2)) ** 0.25
            self.assertAlmostEqual(options_of(simple)["roughness"], want)
            self.assertAlmostEqual(material_of(simple).roughnessFactor, want)
        self.assertEqual(options_of(simple)["color"].tolist(), [51, 102, 153, 255])  # codes of sRGB
        self.assertIsNone(options_of(SimpleMaterial(IMAGE))["color"])
        pbr = PBRMaterial(baseColorFactor=np.uint8([51, 102, 153, 255]), alphaMode="MASK", metallicRoughnessTexture=IMAGE)
        made = options_of(pbr)
        np.testing.assert_allclose(made["color"], (0.2, 0.4, 0.6, 1))
        self.assertEqual((made["metallic"], made["roughness"], made["blend"], made["alpha_cutoff"]), (1, 1, "opaque", 0.5))
        self.assertEqual([(target, channel) for target, _, _, channel in made["maps"]], [("roughness", 1), ("metallic", 2)])
        self.assertEqual((options_of(PBRMaterial())["metallic"], material_of(PBRMaterial()).metallicFactor), (0, 1))

    def test_unmarked_visuals(self):
        """A visual without a kind is a texture if it has a material, and else has colours of vertices."""
        textured, colored = TextureVisuals(UV, SimpleMaterial(IMAGE)), ColorVisuals(np.uint8([[0, 9, 0, 255]] * 4))
        textured.kind = colored.kind = None
        for visual, names in ((textured, ["uv"]), (colored, ["color"])):
            self.assertEqual(list(surface_of(square(visual))[1]), names)
        self.assertEqual(surface_of(square(TextureVisuals(UV[:0], SimpleMaterial())))[1], {})

    def test_arrays(self):
        """v of arrays is downwards."""
        renderer, model = self.renderer(), square()
        renderer.add(position=model.vertices, indices=model.faces, uv=UV * (1, -1) + (0, 1), texture=IMAGE)
        self.check_quarters(renderer)

    def test_colors(self):
        codes = np.uint8([[200, 100, 50, 255]] * 4)
        for visual in (ColorVisuals(vertex_colors=codes), ColorVisuals(face_colors=codes[:2])):
            renderer = self.renderer()
            renderer.add(square(visual))
            np.testing.assert_allclose(renderer.render(flat=True)[0][16, 16], [200, 100, 50], atol=1)
        renderer = self.renderer()
        renderer.add(position=square().vertices, indices=square().faces, color=(1.0, 0.0, 0.5))
        np.testing.assert_allclose(renderer.render(flat=True)[0][16, 16], [255, 0, 188], atol=1)

    def test_grey_images(self):
        grey = np.uint8([[[80, 255]]])
        for image in (np.uint8([[80]]), Image(grey, "LA")):
            renderer = self.renderer()
            renderer.add(square(TextureVisuals(UV, PBRMaterial(baseColorTexture=image))))
            np.testing.assert_allclose(renderer.render(flat=True)[0][16, 16], [80] * 3, atol=1)

    def test_maps(self):
        """Emission alone is visible in the dark; roughness and metal come from green and blue."""
        renderer = self.renderer()
        renderer.ambient = (0, 0, 0)
        renderer.add(square(TextureVisuals(UV, PBRMaterial(
            baseColorTexture=IMAGE, emissiveTexture=IMAGE, emissiveFactor=np.ones(3), normalTexture=np.full(
                (1, 1, 3), 128, np.uint8), metallicRoughnessTexture=np.full((1, 1, 3), 255, np.uint8),
            occlusionTexture=np.full((1, 1), 255, np.uint8)))))
        np.testing.assert_array_equal(self.corners(renderer.render()[0]), QUARTERS[..., :3])

    def test_smooth(self):
        """A roof: smooth normals shade both sides alike at the ridge, flat ones do not."""
        roof = Trimesh([[-1, -1, -1], [0, -1, 0], [0, 1, 0], [-1, 1, -1], [1, -1, -1], [1, 1, -1]],
                       [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]])
        steps = []
        for smooth in (True, False):
            renderer = self.renderer(64)
            renderer.add(roof, smooth=smooth)
            renderer.add_light(direction=(-1, 0, -1))
            row = renderer.render()[0][32, :, 0].astype(int)
            steps.append(abs(row[33] - row[30]))
        self.assertLess(steps[0], 12)
        self.assertGreater(steps[1], 60)

    def test_scene_of_trimesh(self):
        half, shift = np.diag([0.5, 0.5, 1, 1]), np.eye(4)
        shift[:3, 3] = (0.5, 0.5, 0)
        codes = ColorVisuals(vertex_colors=np.uint8([[0, 255, 0, 255]] * 4))
        renderer = self.renderer()
        renderer.add(Scene({"square": square(codes)}, {"node": (shift @ half, "square")}))
        color, depth = renderer.render(flat=True)
        self.assertEqual(color[8, 24].tolist(), [0, 255, 0])
        self.assertEqual((depth > 0).sum(), 256)

    def test_files(self):
        require_component("shd_scene", BOX)
        renderer = self.renderer()
        item = renderer.add(pathlib.Path(BOX))
        renderer.look_at((0, 0, 3))
        color, depth = renderer.render()
        self.assertGreater(len(np.unique(color.reshape(-1, 3), axis=0)), 20)
        self.assertAlmostEqual(float(depth[16, 16]), 2.5, places=4)
        self.assertEqual(len(item.scene.meshes), 1)
        self.check_refused(shd.Error, "nothing.glb", renderer.add, "nothing.glb")

    def test_translucent(self):
        """Alpha of a texture is blended over what is behind it."""
        renderer = self.renderer()
        renderer.add(square(ColorVisuals(vertex_colors=np.uint8([[255, 255, 255, 255]] * 4))))
        half = np.uint8([[[0, 0, 0, 128]]])
        renderer.add(square(TextureVisuals(UV, PBRMaterial(baseColorTexture=half)), z=0.5))
        self.assertAlmostEqual(int(renderer.render(flat=True)[0][16, 16, 0]), 188, delta=1)


class Frames(Renderers):
    def test_depth(self):
        """Distances along the view, of a plane that leans away; 0 in the background."""
        renderer = shd.Renderer(40, 30, sample_count=1, context=self.context)
        renderer.add(Trimesh([[-9, -1, 0], [9, -1, 0], [9, -1, -40], [-9, -1, -40]], [[0, 1, 2], [0, 2, 3]]))
        renderer.look_from(np.eye(4), yfov=1.0)
        depth = renderer.render()[1]
        rows = np.arange(30)
        expected = 1 / (((rows + 0.5) / 15 - 1) * np.tan(0.5))[20:]
        np.testing.assert_allclose(depth[20:, 20], expected, rtol=3e-4)
        self.assertEqual((depth.dtype, float(depth[:15].max())), (np.dtype("f4"), 0.0))
        np.testing.assert_array_equal(renderer.render_depth(), depth)
        renderer.look_from(np.eye(4), yfov=1.0, near=2.5, far=5)
        np.testing.assert_allclose(renderer.render_depth()[20:, 20], np.where((expected > 2.5) & (expected < 5),
                                                                            expected, 0), rtol=3e-4)

    def test_lenses(self):
        pose = _camera.look_at((0, 0, 5))
        for lens, count in ((_camera.orthographic(2.0), 256), (_camera.orthographic(2.0, 1, 9), 256),
                            (_camera.intrinsics(40, 40, 16, 16), 256)):
            renderer = self.renderer()
            renderer.add(square())
            renderer.look_from(pose, lens=lens)
            depth = renderer.render()[1]
            self.assertEqual((depth > 0).sum(), count)
            np.testing.assert_allclose(depth[depth > 0], 5, rtol=1e-5)
        renderer.look_from(pose, lens=_camera.intrinsics(40, 40, 24, 8))
        depth = renderer.render()[1]
        self.assertEqual([bool(depth[row, column] > 0) for row, column in ((0, 31), (17, 31), (0, 14))],
                         [True, False, False])

    def test_framing(self):
        """Models fill the picture, and none of them lies outside, from any direction and in any shape of picture."""
        box = dict(position=np.float32([[x, y, z] for x in (5, 8) for y in (-1, 0) for z in (2, 2.5)]),
                   indices=np.uint32([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                                      [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]))
        for size in ((160, 160), (400, 130), (120, 400)):
            renderer = shd.Renderer(*size, sample_count=1, context=self.context)
            renderer.add(**box)
            first = renderer.render()[1]  # the camera was not placed
            renderer.frame()
            np.testing.assert_array_equal(renderer.render()[1], first)
            for values in ({}, {"direction": (0, 0, -3)}, {"direction": (1, 9, 0), "up": (0, 0, 1), "yfov": 0.2}):
                renderer.frame(**values)
                seen = renderer.render()[1] > 0
                with self.subTest(size=size, **values):
                    rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
                    self.assertFalse(seen[[0, -1]].any() or seen[:, [0, -1]].any())
                    self.assertGreater(max(len(rows) / size[1], len(columns) / size[0]), 0.7)
            moved = renderer.add(**box, pose=np.array([[1, 0, 0, 40], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
            placed = renderer.render()[1]
            np.testing.assert_array_equal(placed > 0, seen)  # a placed camera stays
            renderer.frame((0, 0, 1))
            self.assertEqual(np.unique(renderer.render_ids()).tolist(), [-1, 0, 1])
            moved.visible = False
            renderer.frame((0, 0, 1))
            self.assertGreater((renderer.render_ids() == 0).any(axis=0).mean(), 0.35)
        renderer.clear()
        renderer.frame()  # nothing, and a point
        self.assertFalse(renderer.render()[1].any())
        renderer.add(position=np.float32([[3, 4, 5]] * 3))
        renderer.frame()
        self.assertFalse(renderer.render()[1].any())

    def test_poses(self):
        renderer = self.renderer()
        item, other = renderer.add(square()), renderer.add(square(z=-1), pose=np.diag([9.0, 9, 1, 1]))
        self.assertEqual(np.unique(renderer.render_ids()).tolist(), [0])
        moved = np.eye(4)
        moved[0, 3] = 1
        item.pose = moved
        self.assertEqual(renderer.render_ids()[16, [8, 24]].tolist(), [1, 0])
        other.visible = False
        self.assertEqual(renderer.render_ids()[16, [8, 24]].tolist(), [-1, 0])
        renderer.remove(item)
        self.assertEqual(renderer.render()[1].max(), 0)

    def test_alpha(self):
        renderer = self.renderer(background=(0.2, 0.4, 0.6, 0))
        renderer.add(position=square().vertices * 0.53, indices=square().faces, color=(1.0, 1, 1))
        color = renderer.render(alpha=True, flat=True)[0]
        self.assertEqual((color.shape, color[0, 0].tolist(), color[16, 16].tolist()), ((32, 32, 4), [0] * 4, [255] * 4))
        edge = color[(color[..., 3] > 0) & (color[..., 3] < 255)]
        self.assertGreater(len(edge), 0)
        self.assertGreaterEqual(edge[:, :3].min(), 250)
        renderer.background = (0.2, 0.4, 0.6)
        self.assertEqual(renderer.render()[0][0, 0].tolist(), [51, 102, 153])

    def test_shadows(self):
        renderer = self.renderer(64)
        renderer.add(square(z=-1), pose=np.diag([4.0, 4, 1, 1]))
        renderer.add(square(), pose=np.diag([0.2, 0.2, 1, 1]))
        renderer.add_light(direction=(-1, 0, -1.5))
        lit, dark = (renderer.render(shadows=shadows)[0][32, 20, 0] for shadows in (False, True))
        self.assertGreater(int(lit) - int(dark), 60)

    def test_environment(self):
        """A white sky of radiance 0.25 is seen in a mirror, and is the background."""
        renderer = self.renderer()
        renderer.add(square(), pose=np.diag([0.5, 0.5, 1, 1]), metallic=1.0, roughness=0.0)
        renderer.environment = shd.Environment(self.context, np.full((4, 8), 0.25, np.float32))
        self.assertEqual(renderer.render()[0][0, 0].tolist(), [0, 0, 0])
        renderer.shows_environment = True
        color = renderer.render()[0]
        np.testing.assert_allclose(color[0, 0], 137, atol=1)
        np.testing.assert_allclose(color[16, 16], 137, atol=2)

    def test_reuse(self):
        """Frames reuse the framebuffer and the texture; results do not share memory with it."""
        renderer = self.renderer()
        texture = shd.Texture(self.context, QUARTERS, srgb=True)
        renderer.add(position=square().vertices, indices=square().faces, uv=UV, texture=texture)
        first = renderer.render(flat=True)
        kept = [array.copy() for array in first]
        renderer.items[0].visible = False
        framebuffer = renderer._framebuffer
        renderer.render()
        self.assertIs(renderer._framebuffer, framebuffer)
        for array, copy in zip(first, kept):
            np.testing.assert_array_equal(array, copy)


class Misuse(Renderers):
    def test_refused(self):
        renderer, model = self.renderer(), square()
        add = lambda **values: renderer.add(**{"position": model.vertices, "indices": model.faces, **values})
        for kind, message, values in (
                (ValueError, "indices.2.: 7 is not in 0..3", {"indices": [[0, 1, 7]]}),
                (ValueError, "indices.2.: -1 is not in 0..3", {"indices": [[0, 1, -1]]}),
                (ValueError, "indices: integers of shape", {"indices": np.zeros((2, 4), int)}),
                (ValueError, "position: numbers of shape .count..3., not float64 of shape", {"position": np.zeros(3)}),
                (TypeError, "position: an array of numbers, not list", {"position": [["a"]]}),
                (ValueError, "uv: 3 rows, not 4", {"uv": np.zeros((3, 2))}),
                (ValueError, "color: 2 rows, not 4", {"color": np.zeros((2, 3))}),
                (ValueError, "color: one colour if there is", {"color": np.zeros((4, 3)), "texture": QUARTERS}),
                (TypeError, "texture: an array of numbers, not str", {"texture": "wood.png"}),
                (TypeError, "the array is of int64", {"texture": np.zeros((2, 2, 3), int)}),
                (TypeError, "no field shininess", {"shininess": 1}),
                (shd.InvalidArgument, "roughness", {"roughness": 2}),
                (shd.InvalidArgument, "position", {"position": np.full((4, 3), np.nan)}),
                (ValueError, "pose: a matrix .4..4.", {"pose": np.eye(3)}),
                (ValueError, "pose: a number is not finite", {"pose": np.full((4, 4), np.inf)}),
                (ValueError, "pose: the last row is", {"pose": np.ones((4, 4))})):
            with self.subTest(message):
                self.check_refused(kind, message, add, **values)
        self.check_refused(TypeError, "add: a mesh or scene of trimesh, .* not int", renderer.add, 3)
        self.assertEqual(renderer.items, [])
        self.check_refused(ValueError, "must differ", renderer.look_at, (0, 0, 0))
        self.check_refused(ValueError, "camera.eye: three numbers, not float64 of shape .2,.", renderer.look_at, (0.0, 1))
        self.check_refused(TypeError, "camera.up: an array of numbers, not str", renderer.look_at, (0, 0, 1), up="y")
        self.check_refused(shd.InvalidArgument, "camera.target: is the eye", renderer.frame, (0, 0, 0))
        self.check_refused(ValueError, "direction: three numbers, not", renderer.frame, (0.0, 1))
        self.check_refused(shd.InvalidArgument, "camera.up: lies along", renderer.frame, (0, 1, 0))
        self.check_refused(shd.InvalidArgument, "camera.fov_y: 4 is not below pi", renderer.frame, yfov=4)
        self.check_refused(ValueError, "yfov: 4 is not in", renderer.look_at, (0, 0, 1), yfov=4)
        self.check_refused(ValueError, "far: 1 is not above near, 2", renderer.look_at, (0, 0, 1), near=2, far=1)
        self.check_refused(ValueError, "background", setattr, renderer, "background", (2, 0, 0))
        self.check_refused(shd.InvalidArgument, "framebuffer.width", shd.Renderer, 0, 8)

    def test_close(self):
        with shd.Renderer(8, 8, context=self.context) as renderer:
            renderer.add(square())
        renderer.close()
        for call in (renderer.render, renderer.render_ids, lambda: renderer.add(square())):
            self.check_refused(ValueError, "the Renderer is closed", call)

    def test_threads(self):
        """A second render while one runs is refused, and the renderer works afterwards."""
        renderer, entered, leave = self.renderer(), threading.Event(), threading.Event()
        renderer.add(square())

        def wait(fraction):
            entered.set()
            leave.wait(10)

        thread = threading.Thread(target=renderer.render, kwargs={"progress": wait})
        thread.start()
        self.assertTrue(entered.wait(10))
        self.check_refused(ValueError, "another thread renders", renderer.render)
        leave.set()
        thread.join(10)
        renderer.render()


if __name__ == "__main__":
    unittest.main()
