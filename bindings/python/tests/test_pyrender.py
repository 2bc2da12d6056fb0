# SPDX-License-Identifier: MIT
"""The interface of pyrender: its example's calls, lights, flags, nodes and misuse, with stand-ins for trimesh."""
import numpy as np

import shd.pyrender as pyrender
from shd._srgb import decode
from support import Case, require_component
from trimesh_like import UV, ColorVisuals, PBRMaterial, Scene, SimpleMaterial, TextureVisuals, Trimesh, square

Flags = pyrender.RenderFlags
DUCK = "/usr/share/assimp/models/Collada/duck.dae"
WHITE = np.uint8([[255, 255, 255, 255]])


def at(z):
    pose = np.eye(4)
    pose[2, 3] = z
    return pose


class Cases(Case):
    def scene(self, *meshes, **values):
        """Meshes that a camera at z = 2 sees from -1 to 1 at z = 0."""
        made = pyrender.Scene(**values)
        for mesh in meshes:
            made.add(mesh)
        made.add(pyrender.PerspectiveCamera(yfov=2 * np.arctan(0.5)), pose=at(2))
        return made

    def render(self, scene, flags=Flags.NONE, size=16, **values):
        renderer = pyrender.OffscreenRenderer(size, size)
        self.addCleanup(renderer.delete)
        return renderer.render(scene, flags, **values)

    def mesh(self, visual=None, **values):
        return pyrender.Mesh.from_trimesh(square(visual), **values)


class Pictures(Cases):
    def test_units_of_lights(self):
        """A white surface in the irradiance E has E / pi, plus little gloss."""
        material = pyrender.MetallicRoughnessMaterial(metallicFactor=0.0, roughnessFactor=1.0)
        for light, pose, irradiance in (
                (pyrender.DirectionalLight(intensity=1.0), at(3), 1.0),
                (pyrender.PointLight(intensity=4.0), at(2), 1.0),
                (pyrender.SpotLight(color=np.ones(3), intensity=4.0, innerConeAngle=0.3, outerConeAngle=0.5), at(2),
                 1.0)):
            scene = self.scene(self.mesh(material=material))
            scene.add(light, pose=pose)
            color = self.render(scene, size=17)[0][8, 8]
            linear = ((color[0] / 255 + 0.055) / 1.055) ** 2.4
            self.assertAlmostEqual(linear, irradiance / np.pi, delta=0.03)
            self.assertEqual(len(set(color.tolist())), 1)

    def test_falloff(self):
        """The light of a spot falls off with t^2, t linear in the cosine between the inner and the outer cone."""
        material = pyrender.MetallicRoughnessMaterial(metallicFactor=0.0, roughnessFactor=1.0)
        inner, outer, size = 0.1, 0.4, 65
        scene, plain = (self.scene(self.mesh(material=material), bg_color=[0.0, 0.0, 0.0]) for _ in range(2))
        scene.add(pyrender.SpotLight(intensity=4.0, innerConeAngle=inner, outerConeAngle=outer), pose=at(2))
        plain.add(pyrender.PointLight(intensity=4.0), pose=at(2))
        spot, point = (decode(self.render(s, size=size)[0][size // 2, :, 0] / 255) for s in (scene, plain))
        cosine = 1 / np.sqrt(1 + (((2 * np.arange(size) + 1) / size - 1) / 2) ** 2)
        t = np.clip((cosine - np.cos(outer)) / (np.cos(inner) - np.cos(outer)), 0, 1)
        np.testing.assert_allclose(spot / point, t ** 2, atol=0.02)
        self.assertGreater(np.abs(spot / point - t ** 2 * (3 - 2 * t)).max(), 0.1)

    def test_background_and_ambient(self):
        color, depth = self.render(self.scene(bg_color=[0.5, 0.5, 0.5]))
        self.assertEqual((color.shape, np.unique(color).tolist(), depth.max()), ((16, 16, 3), [128], 0))
        color = self.render(self.scene(bg_color=[0, 0, 255, 0]), Flags.RGBA)[0]
        self.assertEqual(color[0, 0].tolist(), [0, 0, 0, 0])
        visual = ColorVisuals(vertex_colors=WHITE.repeat(4, 0))
        lit = self.render(self.scene(self.mesh(visual), ambient_light=[0.5, 0.5, 0.5, 1.0]))[0][8, 8, 0]
        self.assertAlmostEqual(int(lit), 188, delta=12)
        self.assertEqual(self.render(self.scene(self.mesh(visual)))[0].max(), 0)  # no light

    def test_visuals(self):
        image = np.uint8([[[0, 255, 0]]])
        codes = np.uint8([[0, 128, 0, 255]])
        for visual, smooth, green in (
                (TextureVisuals(UV, SimpleMaterial(image, diffuse=(255, 255, 255, 255))), True, 255),
                (TextureVisuals(UV, PBRMaterial(baseColorTexture=image, doubleSided=True)), False, 255),
                (ColorVisuals(vertex_colors=codes.repeat(4, 0)), True, 128),  # numbers as they are, as in pyrender
                (ColorVisuals(face_colors=codes.repeat(2, 0)), False, 128),
                (None, True, 77)):
            color = self.render(self.scene(self.mesh(visual, smooth=smooth)), Flags.FLAT)[0]
            self.assertAlmostEqual(int(color[8, 8, 1]), green, delta=1)

    def test_culling(self):
        turned = Trimesh(square().vertices, square().faces[:, ::-1])
        for mesh, flags, count in ((square(), 0, 256), (turned, 0, 0), (turned, Flags.SKIP_CULL_FACES, 256)):
            depth = self.render(self.scene(pyrender.Mesh.from_trimesh(mesh)), Flags.DEPTH_ONLY | flags)
            self.assertEqual((depth > 0).sum(), count)
            np.testing.assert_allclose(depth[depth > 0], 2, rtol=1e-5)

    def test_wireframe_and_points(self):
        scene = self.scene(self.mesh())
        self.assertEqual((self.render(scene)[1] > 0).sum(), 256)
        lines = (self.render(scene, Flags.ALL_WIREFRAME)[1] > 0).sum()
        self.assertEqual((self.render(scene, Flags.FLIP_WIREFRAME)[1] > 0).sum(), lines)
        self.assertTrue(0 < lines < 128)
        wired = self.scene(self.mesh(wireframe=True))
        self.assertEqual((self.render(wired)[1] > 0).sum(), lines)
        self.assertEqual((self.render(wired, Flags.ALL_SOLID)[1] > 0).sum(), 256)
        points = pyrender.Mesh.from_points([[0, 0, 0], [0.5, 0.5, 0]], colors=[[1.0, 0, 0], [0, 0, 1.0]])
        renderer = pyrender.OffscreenRenderer(16, 16, point_size=4.0)
        color, depth = renderer.render(self.scene(points), Flags.FLAT)
        self.assertEqual(((depth > 0).sum(), color[8, 8].tolist(), color[4, 12].tolist()),
                         (32, [255, 0, 0], [0, 0, 255]))

    def test_segments(self):
        scene = self.scene()
        near = scene.add(self.mesh(), pose=np.diag([0.5, 0.5, 1, 1]))
        far = scene.add(self.mesh(), pose=at(-0.5))
        scene.add(self.mesh(), pose=at(0.5))  # without a colour
        color, depth = self.render(scene, Flags.SEG, seg_node_map={near: (10, 20, 30), far: 7})
        self.assertEqual((color[8, 8].tolist(), color[3, 8].tolist(), color[0, 0].tolist()), ([10, 20, 30], [7] * 3,
                                                                                          [0] * 3))
        self.assertEqual(float(depth[8, 8]), 2.0)
        for value, text in ((300, "^seg_node_map.0.: 300 is not in 0..255$"),
                            ((0, -1, 0), "seg_node_map.1.: -1 is not"),
                            ([np.nan] * 3, "seg_node_map: a number is not finite"),
                            ((1, 2), "seg_node_map: r, g, b or one number, not an array of shape")):
            self.check_refused(ValueError, text, self.render, scene, Flags.SEG, seg_node_map={near: value})

    def test_instances_and_shadows(self):
        mesh = self.mesh(poses=[np.diag([0.25, 0.25, 1, 1]) + x for x in (np.eye(4, k=3) * 0.5, np.eye(4, k=3) * -0.5)])
        self.assertEqual((self.render(self.scene(mesh))[1] > 0).sum(), 32)
        instanced = self.scene()
        nodes = [instanced.add(mesh), instanced.add(self.mesh(), pose=at(-1))]
        color = self.render(instanced, Flags.SEG, seg_node_map={nodes[0]: 1, nodes[1]: 2})[0]
        self.assertEqual([int((color == n).all(axis=2).sum()) for n in (1, 2)], [32, 100 - 24])
        for flip, count in ((1, 256), (-1, 256)):  # a mirror keeps the front of a surface
            many = self.mesh(poses=np.array([at(-0.5), np.diag([flip, 1.0, 1, 1])]))
            self.assertEqual((self.render(self.scene(many))[1] > 0).sum(), count)
            np.testing.assert_allclose(self.render(self.scene(many))[1][8, 8], 2, rtol=1e-5)
        scene = self.scene(mesh)
        scene.add(self.mesh(ColorVisuals(vertex_colors=WHITE.repeat(4, 0))), pose=np.diag([9.0, 9, 1, 1]) @ at(-1))
        pose = np.eye(4)
        pose[:3, :3] = [[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]]
        scene.add(pyrender.DirectionalLight(intensity=2.0), pose=pose)
        lit, shaded = (self.render(scene, flags, 64)[0].astype(int).sum() for flags in (0, Flags.SHADOWS_DIRECTIONAL))
        self.assertLess(shaded, lit)

    def test_file(self):
        require_component("shd_scene", DUCK)
        model = pyrender.load(DUCK)
        scene = pyrender.Scene()
        scene.add(pyrender.Mesh.from_trimesh(model))
        np.testing.assert_allclose(scene.bounds, model.bounds)
        pose = at(model.bounds[1, 2] + model.scale)
        pose[:2, 3] = model.centroid[:2]
        scene.add(pyrender.PerspectiveCamera(yfov=1.0, aspectRatio=1.0), pose=pose)
        scene.add(pyrender.DirectionalLight(intensity=6.0), pose=pose)
        color, depth = self.render(scene, size=64)
        self.assertGreater((depth > 0).mean(), 0.1)
        red, green, blue = color[depth > 0].mean(axis=0)
        self.assertTrue(red > 100 > blue and green > blue)  # a yellow duck


class Nodes(Cases):
    def test_tree(self):
        scene = pyrender.Scene()
        parent = pyrender.Node(name="parent", translation=[1, 0, 0], rotation=[0, 0, np.sqrt(0.5), np.sqrt(0.5)])
        scene.add_node(parent)
        child = scene.add(self.mesh(), name="child", pose=at(3), parent_name="parent")
        np.testing.assert_allclose(scene.get_pose(child), [[0, -1, 0, 1], [1, 0, 0, 0], [0, 0, 1, 3], [0, 0, 0, 1]],
                                   atol=1e-12)
        scene.set_pose(child, at(5))
        np.testing.assert_allclose(scene.bounds, [[0, -1, 5], [2, 1, 5]], atol=1e-6)
        self.assertEqual(scene.get_nodes(name="child"), {child})
        self.assertEqual(scene.get_nodes(obj=child.mesh), {child})
        scene.remove_node(parent)
        self.assertEqual(scene.nodes, set())
        self.check_refused(ValueError, "not in the scene", scene.get_pose, child)
        whole = pyrender.Scene(nodes=[pyrender.Node(children=[pyrender.Node(mesh=self.mesh())])])
        self.assertEqual(len(whole.mesh_nodes), 1)

    def test_from_trimesh_scene(self):
        made = pyrender.Scene.from_trimesh_scene(Scene({"a": square()}, {"n": (at(1), "a"), "m": (at(2), "a")}))
        self.assertEqual((len(made.mesh_nodes), len(made.meshes), made.extents.tolist()), (2, 1, [2, 2, 1]))

    def test_cameras(self):
        scene = self.scene(self.mesh())
        first = scene.main_camera_node
        wide = scene.add(pyrender.OrthographicCamera(xmag=2.0, ymag=2.0), pose=at(2))
        scene.main_camera_node = wide
        self.assertEqual((self.render(scene)[1] > 0).sum(), 64)
        scene.remove_node(wide)
        self.assertIs(scene.main_camera_node, first)
        pinhole = scene.add(pyrender.IntrinsicsCamera(fx=8, fy=8, cx=8, cy=8), pose=at(2))
        scene.main_camera_node = pinhole
        self.assertEqual((self.render(scene)[1] > 0).sum(), 64)

    def test_misuse(self):
        renderer, scene = pyrender.OffscreenRenderer(8, 8), pyrender.Scene()
        self.check_refused(ValueError, "it has no camera", renderer.render, scene)
        self.check_refused(TypeError, "a Mesh, Light or Camera, not int", scene.add, 3)
        self.check_refused(TypeError, "vertices and faces, or a Model, not str", pyrender.Mesh.from_trimesh, "a.obj")
        self.check_refused(ValueError, "faces.2.: 9 is not in 0..3", pyrender.Mesh.from_trimesh,
                           Trimesh(square().vertices, [[0, 1, 9]]))
        self.check_refused(ValueError, "pose|matrix", scene.add, self.mesh(), pose=np.eye(3))
        self.check_refused(ValueError, "0 nodes have the name", scene.add, self.mesh(), parent_name="none")
        self.check_refused(ValueError, "innerConeAngle", pyrender.SpotLight, innerConeAngle=1.0, outerConeAngle=0.5)
        self.check_refused(ValueError, "yfov: -1", pyrender.PerspectiveCamera, -1)
        self.check_refused(ValueError, "mode: 10 is not in 0..6", pyrender.Primitive, np.zeros((2, 3)), mode=10)
        renderer.viewport_width = 4
        self.assertEqual(renderer.render(self.scene())[0].shape, (8, 4, 3))
        renderer.delete()
        renderer.delete()
        self.check_refused(ValueError, "it was deleted", renderer.render, self.scene())
        for kind, size, text in (
                (ValueError, (0, 8), "^viewport_width: 0 is not a whole number in 1..16384$"),
                (ValueError, (8, -1), "^viewport_height: -1 is not a whole number in 1..16384$"),
                (ValueError, (8, 20000), "^viewport_height: 20000 is not"),
                (ValueError, (8.5, 8), "^viewport_width: 8.5 is not"),
                (TypeError, ("wide", 8), "^viewport_width: a number, not 'wide'$"),
                (TypeError, (None, 8), "^viewport_width: a number, not None$")):
            self.check_refused(kind, text, pyrender.OffscreenRenderer, *size)
