# SPDX-License-Identifier: MIT
"""The names, attributes and checks that the documentation of pyrender has, for programs that come from it."""
import copy
import math
import pickle

import numpy as np

import shd.pyrender as pyrender
from shd.pyrender import GLTF, RenderFlags, constants
from support import Case, require_component
from test_pyrender import DUCK, Cases, at
from trimesh_like import UV, ColorVisuals, PBRMaterial, SimpleMaterial, TextureVisuals, Trimesh, square

# The names of the API documentation of pyrender 0.1.45.
NAMES = """Camera PerspectiveCamera OrthographicCamera IntrinsicsCamera Light PointLight DirectionalLight SpotLight
Sampler Texture Material MetallicRoughnessMaterial Primitive Mesh Node Scene Renderer Viewer
OffscreenRenderer __version__ RenderFlags TextAlign GLTF""".split()


def box(size=1.0):
    """A cube around the origin, whose faces share no vertices."""
    corners, faces = [], []
    for axis in range(3):
        for side in (-1, 1):
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corners.append(np.roll([side, a, b], axis))
            first = len(corners) - 4
            faces += [[first, first + 1, first + 2], [first, first + 2, first + 3]][::1 if side > 0 else -1]
    return Trimesh(np.array(corners) * size / 2, faces)


class Attributes(Case):
    def check_attributes(self, make, defaults, good, bad):
        """Attributes have their defaults; setting them gives or refuses values."""
        made = make()
        for name, value in defaults.items():
            with self.subTest(name):
                np.testing.assert_array_equal(getattr(made, name), value)
        for name, value in good:
            setattr(made, name, value)
            np.testing.assert_allclose(getattr(made, name), value)
        for kind, name, value in bad:
            with self.subTest(f"{name} = {value}"):
                before = getattr(made, name)
                self.check_refused(kind, f"^{name}: ", setattr, made, name, value)
                self.assertIs(getattr(made, name), before)

    def test_names(self):
        self.assertEqual(set(NAMES) - set(pyrender.__all__), set())
        for name in pyrender.__all__:
            getattr(pyrender, name)
        self.assertIs(constants.RenderFlags, RenderFlags)
        self.assertEqual((constants.SHADOW_TEX_SZ, constants.DEFAULT_Z_FAR, GLTF.REPEAT), (2048, 100, 10497))

    def test_windows(self):
        """What needs a window may be imported, and says what to use instead."""
        self.check_refused(NotImplementedError, r"Viewer: .*OffscreenRenderer\(640, 480\).render", pyrender.Viewer,
                           pyrender.Scene(), use_raymond_lighting=True)
        self.check_refused(NotImplementedError, "Renderer: .*OffscreenRenderer", pyrender.Renderer, 640, 480)

    def test_perspective(self):
        common = [(ValueError, "zfar", 0.05), (ValueError, "zfar", -1), (ValueError, "znear", -0.5)]
        self.check_attributes(
            lambda: pyrender.PerspectiveCamera(yfov=1.0),
            {"yfov": 1.0, "znear": 0.05, "zfar": None, "aspectRatio": None, "name": None},
            [("znear", 0.0), ("znear", 0.05), ("zfar", 20.0), ("aspectRatio", 1.5)],
            [*common, (ValueError, "yfov", 0), (ValueError, "yfov", 4), (ValueError, "aspectRatio", 0),
             (TypeError, "yfov", None)])
        self.check_attributes(
            lambda: pyrender.OrthographicCamera(1.0, 2.0), {"xmag": 1, "ymag": 2, "znear": 0.05, "zfar": 100},
            [("xmag", 3.0)], [*common, (ValueError, "znear", 0), (ValueError, "xmag", 0), (TypeError, "ymag", None),
                              (TypeError, "zfar", None), (ValueError, "znear", 100), (ValueError, "znear", 200)])
        self.check_attributes(
            lambda: pyrender.IntrinsicsCamera(100, 110, 32, 24), {"fx": 100, "cy": 24, "zfar": 100},
            [("cx", -3.0)], [*common, (ValueError, "fx", 0), (ValueError, "znear", 100), (TypeError, "cx", "left")])
        self.check_refused(TypeError, "^zfar: a number, not None$", pyrender.OrthographicCamera, 1.0, 1.0, zfar=None)
        for kind, values in ((pyrender.PerspectiveCamera, {}), (pyrender.OrthographicCamera, {"xmag": 1})):
            self.check_refused(TypeError, "required positional argument", kind, **values)

    def test_projections(self):
        """The matrices of OpenGL move points of the near and far plane to depths -1 and 1."""
        for camera, size in ((pyrender.PerspectiveCamera(1.0, 0.5, 8.0), (80, 40)),
                             (pyrender.PerspectiveCamera(1.0, 0.5, 8.0, aspectRatio=2.0), ()),
                             (pyrender.OrthographicCamera(4.0, 2.0, 0.5, 8.0), ()),
                             (pyrender.OrthographicCamera(1.0, 2.0, 0.5, 8.0), (80, 40)),
                             (pyrender.IntrinsicsCamera(40 / math.tan(1.0), 20 / math.tan(0.5), 40, 20, 0.5, 8.0),
                              (80, 40))):
            matrix = camera.get_projection_matrix(*size)
            for distance, depth in ((0.5, -1), (8.0, 1)):
                point = matrix @ (0, 0, -distance, 1)
                np.testing.assert_allclose(point / point[3], (0, 0, depth, 1), atol=1e-12)
        half, matrix = math.tan(0.5), pyrender.PerspectiveCamera(1.0).get_projection_matrix(80, 40)
        np.testing.assert_allclose(matrix @ (2 * half, half, -1, 1), (1, 1, 1 - 2 * 0.05, 1))
        self.check_refused(ValueError, "aspectRatio: None", pyrender.PerspectiveCamera(1.0).get_projection_matrix)
        for camera in (pyrender.PerspectiveCamera(1.0), pyrender.OrthographicCamera(1.0, 1.0),
                       pyrender.IntrinsicsCamera(8, 8, 4, 4)):
            self.check_refused(ValueError, "^width: 0 is not above 0", camera.get_projection_matrix, 0, 0)
            self.check_refused(ValueError, "^height: -2 is not above 0", camera.get_projection_matrix, 4, -2)

    def test_lights(self):
        common = [(ValueError, "color", None), (ValueError, "color", "red"), (TypeError, "intensity", None)]
        ranged = [*common, (ValueError, "range", 0), (ValueError, "range", -1)]
        defaults = {"color": np.ones(3), "intensity": 1.0, "name": None}
        self.check_attributes(pyrender.DirectionalLight, defaults, [("intensity", 3.0)], common)
        self.check_attributes(pyrender.PointLight, {**defaults, "range": None}, [("range", 5.0)], ranged)
        self.check_attributes(
            pyrender.SpotLight, {**defaults, "innerConeAngle": 0, "outerConeAngle": math.pi / 4, "range": None},
            [("outerConeAngle", 1.5), ("innerConeAngle", 1.0)],
            [*ranged, (ValueError, "innerConeAngle", -1), (ValueError, "innerConeAngle", 1.55),
             (ValueError, "outerConeAngle", math.pi)])
        light = pyrender.PointLight(color=[255, 0, 51])
        np.testing.assert_allclose(light.color, (1, 0, 0.2))
        np.testing.assert_allclose(pyrender.PointLight(color=0.5).color, (0.5, 0.5, 0.5))

    def test_samplers(self):
        sampler = pyrender.Sampler(minFilter=GLTF.NEAREST_MIPMAP_LINEAR, wrapS=GLTF.MIRRORED_REPEAT)
        self.assertEqual(sampler.options(), {"filter": "nearest_mip_linear", "magnification": "default",
                                             "max_anisotropy": 8, "wrap_u": "mirror", "wrap_v": "repeat"})
        self.check_refused(ValueError, "wrapS: 3 is none of 10497", setattr, sampler, "wrapS", 3)
        self.check_refused(ValueError, "minFilter: 'linear' is none of", pyrender.Sampler, minFilter="linear")

    def test_textures(self):
        """Sources become uint8 with the channels that are asked for."""
        grey, rgb = np.full((2, 3), 0.5), np.uint8([[[10, 20, 30]]])
        for source, channels, want in (
                (grey, "RGB", [128] * 3), (grey, "RGBA", [128] * 3 + [255]), (rgb, "RGBA", [10, 20, 30, 255]),
                (rgb, "R", [10]), (rgb, "RG", [10, 20]), (rgb, "GB", [20, 30]), (rgb, None, [10, 20, 30]),
                (np.uint16([[257]]), "R", [1]), (rgb[..., :2], "GB", [10, 20])):
            texture = pyrender.Texture(source=source, source_channels=channels)
            self.assertEqual((texture.source.dtype, texture.source[0, 0].tolist()), (np.uint8, want))
        self.check_refused(ValueError, "source: 2 channels, not RGB", pyrender.Texture, source=rgb[..., :2],
                           source_channels="RGB")
        self.check_refused(ValueError, "source_channels: 'BGR' is none of", pyrender.Texture, source_channels="BGR")
        self.check_refused(TypeError, "source: an array of numbers, not str", pyrender.Texture, source="wood.png")
        self.check_refused(TypeError, "sampler: a Sampler, not int", pyrender.Texture, sampler=3)
        for source, text in ((np.int64([[300]]), "source.0.: 300 is not in 0..255"), (np.int8([[-1]]), "source.0.: -1"),
                             (np.array([[0, np.nan]]), "source: a number is not finite"),
                             (np.array([[np.inf]]), "source: a number is not finite")):
            self.check_refused(ValueError, text, pyrender.Texture, source=source)
        self.assertEqual(pyrender.Texture(source=np.int64([[255, 7]])).source[0].tolist(), [[255], [7]])
        self.assertTrue(pyrender.Texture(source=np.uint8([[[1, 2, 3, 254]]]), source_channels="RGBA").is_transparent())

    def test_texts(self):
        """Texts say what an object is."""
        texture = pyrender.Texture(source=np.zeros((2, 3, 3), np.uint8), source_channels="RGB", name="wood")
        mesh = pyrender.Mesh.from_trimesh(square(), poses=[np.eye(4)] * 2)
        for made, text in (
                (pyrender.PerspectiveCamera(1.0), "PerspectiveCamera znear=0.05 yfov=1"),
                (pyrender.PointLight(intensity=3, name="lamp"), "PointLight intensity=3 name='lamp'"),
                (texture, "Texture 3x2 name='wood' source_channels='RGB'"), (mesh, "Mesh 1 primitives"),
                (mesh.primitives[0], "Primitive TRIANGLES 4 vertices 2 poses"),
                (pyrender.Node("n", mesh=mesh), "Node 'n' mesh=Mesh 0 children"),
                (pyrender.Scene(), "Scene 0 meshes 0 lights 0 cameras"),
                (pyrender.OffscreenRenderer(8, 4), "OffscreenRenderer 8x4")):
            self.assertEqual(repr(made), f"<shd.pyrender.{text}>")

    def test_materials(self):
        self.check_attributes(
            pyrender.MetallicRoughnessMaterial,
            {"baseColorFactor": np.ones(4), "metallicFactor": 1, "roughnessFactor": 1, "alphaMode": "OPAQUE",
             "emissiveFactor": np.zeros(3), "doubleSided": False, "wireframe": False, "baseColorTexture": None},
            [("metallicFactor", 0.5), ("baseColorFactor", (0.5, 0.25, 1, 0.5))],
            [(ValueError, "metallicFactor", 2), (ValueError, "roughnessFactor", -1), (ValueError, "alphaMode", "ADD"),
             (ValueError, "alphaCutoff", 3)])
        for mode, opacity, want in (("BLEND", 0.5, True), ("OPAQUE", 0.5, False), ("MASK", 0.6, False),
                                    ("MASK", 0.4, True), ("BLEND", 1, False)):
            made = pyrender.MetallicRoughnessMaterial(alphaMode=mode, baseColorFactor=(1.0, 1, 1, opacity))
            self.assertEqual(made.is_transparent, want)
        made = pyrender.MetallicRoughnessMaterial(baseColorTexture=np.zeros((2, 2, 3), np.uint8))
        self.assertIsInstance(made.baseColorTexture, pyrender.Texture)

    def test_channels(self):
        """Roughness and metalness are the channels G and B of a source, in whatever order it has them."""
        pixels = np.uint8([[[10, 20, 30, 40]]])
        for source, channels, want in ((pixels, "GB", (0, 1)), (pixels, "RGB", (1, 2)), (pixels, "RGBA", (1, 2)),
                                       (pixels, None, (1, 2)), (pixels[..., :3], None, (1, 2)),
                                       (pixels[..., :2], None, (0, 1))):
            texture = pyrender.Texture(source=source, source_channels=channels)
            maps = pyrender.MetallicRoughnessMaterial(metallicRoughnessTexture=texture).options()["maps"]
            self.assertEqual([(target, channel) for target, _, _, channel in maps],
                             [("roughness", want[0]), ("metallic", want[1])])
        red = pyrender.MetallicRoughnessMaterial(
            metallicRoughnessTexture=pyrender.Texture(source=pixels, source_channels="R"))
        self.check_refused(ValueError, "metallicRoughnessTexture: the channels R of the source have no G, roughness",
                           red.options)
        empty = pyrender.Texture(width=4, height=4)
        names = ("baseColor", "normal", "occlusion", "emissive", "metallicRoughness")
        made = pyrender.MetallicRoughnessMaterial(**{f"{name}Texture": empty for name in names}).options()
        self.assertEqual((made["maps"], made["texture"]), ([], None))


class Meshes(Case):
    def test_bounds(self):
        mesh = pyrender.Mesh.from_trimesh([box(), square(z=2.0)])
        self.assertEqual((len(mesh.primitives), mesh.bounds.tolist(), mesh.extents.tolist(), mesh.name, mesh.weights),
                         (2, [[-1, -1, -0.5], [1, 1, 2]], [2, 2, 2.5], None, None))
        np.testing.assert_allclose((mesh.scale, *mesh.centroid), (np.sqrt(14.25), 0, 0, 0.75))
        poses = np.tile(np.eye(4), (5, 1, 1))
        poses[:, 0, 3] = np.arange(5)
        self.assertEqual(pyrender.Mesh.from_trimesh(box(), poses=poses).bounds.tolist(), [[-0.5] * 3, [4.5, 0.5, 0.5]])
        self.assertEqual(pyrender.Mesh.from_trimesh(box(), poses=np.eye(4)).extents.tolist(), [1, 1, 1])
        self.check_refused(ValueError, "poses", pyrender.Mesh.from_trimesh, box(), poses=np.eye(3))
        nowhere = pyrender.Mesh.from_trimesh(box(), poses=np.zeros((0, 4, 4)))
        self.assertEqual((nowhere.bounds.tolist(), nowhere.parts), (np.zeros((2, 3)).tolist(), []))
        self.assertEqual(pyrender.Mesh([]).bounds.tolist(), np.zeros((2, 3)).tolist())

    def test_primitives(self):
        made = pyrender.Mesh.from_trimesh(square()).primitives[0]
        self.assertEqual((made.positions.shape, made.indices.shape, made.mode, made.targets), ((4, 3), (2, 3), 4, None))
        for name in ("normals", "tangents", "texcoord_0", "texcoord_1", "color_0"):
            for value in (np.zeros(10), np.zeros((3, 9))):
                self.check_refused(ValueError, name, setattr, made, name, value)
        self.check_refused(TypeError, "material: a Material, not ndarray", setattr, made, "material", np.zeros(10))
        self.check_refused(ValueError, "indices.1.: 4 is not in 0..3", setattr, made, "indices", [0, 4, 1])
        self.check_refused(ValueError, "^indices.0.: 2, but there are no vertices$", pyrender.Primitive,
                           np.zeros((0, 3)), indices=[2, 0, 1])
        given = np.float32(square().vertices)
        made = pyrender.Primitive(given, given)
        given[:] = 9
        self.assertEqual((made.positions.tolist(), made.normals.tolist()), (square().vertices.tolist(),) * 2)
        self.check_refused(ValueError, "mode", pyrender.Primitive, [], mode=10)
        for kind in (pyrender.Mesh, pyrender.Primitive):
            self.check_refused(TypeError, "required positional argument", kind)
        self.assertEqual(pyrender.Primitive(np.zeros((2, 3)), color_0=[255, 0, 0]).color_0.tolist(), [[1, 0, 0, 1]] * 2)

    def test_surfaces(self):
        """Materials and colours of meshes of trimesh."""
        pixels = np.uint8([[[0, 255, 0]]])
        pbr = PBRMaterial(baseColorTexture=pixels, emissiveTexture=pixels, metallicRoughnessTexture=pixels)
        material = pyrender.Mesh.from_trimesh(square(TextureVisuals(UV, pbr))).primitives[0].material
        self.assertEqual((material.baseColorTexture.source.shape, material.metallicRoughnessTexture.source.shape,
                          material.emissiveTexture.source.shape), ((1, 1, 4), (1, 1, 2), (1, 1, 3)))
        simple = SimpleMaterial(pixels, diffuse=(51, 102, 153, 255), glossiness=0.0)
        material = pyrender.Mesh.from_trimesh(square(TextureVisuals(UV, simple))).primitives[0].material
        np.testing.assert_allclose(material.baseColorFactor, (0.2, 0.4, 0.6, 1))
        self.assertEqual((material.roughnessFactor, material.alphaMode), (1, "BLEND"))
        faces = ColorVisuals(face_colors=np.uint8([[255, 0, 0, 255]] * 2))
        self.check_refused(ValueError, "smooth", pyrender.Mesh.from_trimesh, square(faces))
        self.assertEqual(pyrender.Mesh.from_trimesh(square(faces), smooth=False).primitives[0].color_0.shape, (6, 4))
        half = pyrender.Mesh.from_trimesh(square(ColorVisuals(np.uint8([[255, 0, 0, 128]] * 4))))
        self.assertTrue(half.is_transparent)
        grey = pyrender.Mesh.from_trimesh(square())
        self.assertFalse(grey.is_transparent)
        grey.primitives[0].material.baseColorFactor = np.zeros(4)
        self.assertTrue(grey.is_transparent)
        for wrong in (None, 3, "a.obj"):
            self.check_refused(TypeError, "from_trimesh: vertices and faces", pyrender.Mesh.from_trimesh, wrong)


class Nodes(Case):
    def test_attributes(self):
        node, mesh, camera = pyrender.Node(), pyrender.Mesh([]), pyrender.PerspectiveCamera(1.0)
        self.assertEqual([getattr(node, n) for n in ("name", "camera", "mesh", "light", "skin", "weights")], [None] * 6)
        self.assertEqual((node.children, node.rotation.tolist(), node.scale.tolist()), ([], [0, 0, 0, 1], [1, 1, 1]))
        node.mesh, node.camera, node.light = mesh, camera, pyrender.PointLight()
        for name, value in (("mesh", camera), ("camera", mesh), ("light", mesh)):
            self.check_refused(TypeError, f"{name}: a ", setattr, node, name, value)
        for name, value in (("rotation", [1, 0]), ("rotation", [1, 2, 3, 4]), ("translation", np.zeros(4)),
                            ("scale", np.ones(2)), ("matrix", np.eye(5)), ("matrix", 5 * np.eye(4))):
            self.check_refused(ValueError, name, setattr, node, name, value)

    def test_places(self):
        """A matrix gives translation, rotation and scale, and they give the matrix."""
        angles, scale, move = (0.3, 2.0, -1.1), np.array([0.5, 2, 1]), np.array([1.0, 2, 3])
        for axis, angle in enumerate(angles):
            quaternion = np.append(np.sin(angle / 2) * np.eye(3)[axis], np.cos(angle / 2))
            turned = np.eye(4)
            i, j = (axis + 1) % 3, (axis + 2) % 3
            turned[i, i] = turned[j, j] = math.cos(angle)
            turned[i, j], turned[j, i] = -math.sin(angle), math.sin(angle)
            matrix = turned @ np.diag([*scale, 1])
            matrix[:3, 3] = move
            node = pyrender.Node(matrix=matrix)
            for name, want in (("rotation", quaternion), ("scale", scale), ("translation", move), ("matrix", matrix)):
                np.testing.assert_allclose(getattr(node, name), want, atol=1e-12)
            other = pyrender.Node(rotation=quaternion, scale=scale, translation=move)
            np.testing.assert_allclose(other.matrix, matrix, atol=1e-12)
        node.translation = (7, 8, 9)
        self.assertEqual(node.matrix[:3, 3].tolist(), [7, 8, 9])
        copied = node.matrix
        copied[0, 0] = 500
        self.assertNotEqual(node.matrix[0, 0], 500)

    def test_scenes(self):
        scene = pyrender.Scene(bg_color=None, ambient_light=None)
        self.assertEqual((scene.bg_color.tolist(), scene.ambient_light.tolist(), scene.name, scene.scale),
                         ([1] * 4, [0] * 3, None, 0))
        scene.bg_color = [0.0, 1.0, 0.0]
        self.assertEqual(scene.bg_color.tolist(), [0, 1, 0, 1])
        scene.bg_color = None
        self.assertEqual(scene.bg_color.tolist(), [1] * 4)
        kinds = {"point": pyrender.PointLight(), "spot": pyrender.SpotLight(),
                 "directional": pyrender.DirectionalLight()}
        nodes = {kind: scene.add(light, name=kind) for kind, light in kinds.items()}
        for kind, light in kinds.items():
            self.assertEqual((getattr(scene, f"{kind}_lights"), getattr(scene, f"{kind}_light_nodes")),
                             ({light}, {nodes[kind]}))
        self.assertEqual((scene.lights, scene.light_nodes), (set(kinds.values()), set(nodes.values())))
        other = pyrender.Node()
        self.assertEqual((scene.get_nodes(node=other), scene.has_node(other)), (set(), False))
        for value in (None, other):
            self.check_refused(ValueError, "not in the scene", setattr, scene, "main_camera_node", value)
        for call, arguments in ((scene.get_pose, (other,)), (scene.set_pose, (other, np.eye(4))),
                                (scene.remove_node, (other,))):
            self.check_refused(ValueError, "not in the scene", call, *arguments)
        self.check_refused(ValueError, "in the scene", scene.add_node, nodes["spot"])
        self.check_refused(TypeError, "a Mesh, Light or Camera", scene.add, None)

    def test_trees(self):
        first, second, third = (pyrender.Node(mesh=pyrender.Mesh.from_trimesh(box()), translation=[x, 0, 0])
                                for x in range(3))
        first.children.append(second)
        scene = pyrender.Scene(nodes=[first, second, third])
        self.assertEqual(scene.bounds.tolist(), [[-0.5] * 3, [2.5, 0.5, 0.5]])
        scene.remove_node(second)
        self.assertEqual((scene.nodes, first.children), ({first, third}, []))
        scene.add_node(second, parent_node=third)
        self.assertEqual((third.children, scene.get_pose(second)[0, 3]), ([second], 3))
        first.children.append(second)
        self.check_refused(ValueError, "more than one parent", pyrender.Scene, nodes=[first, second, third])


class Drawn(Cases):
    def test_changes(self):
        """Assigned attributes of materials, primitives and samplers are seen in the next picture."""
        mesh = self.mesh(TextureVisuals(UV, SimpleMaterial(np.uint8([[[255, 0, 0]]]), diffuse=[255] * 4)))
        scene, primitive = self.scene(mesh), mesh.primitives[0]
        look = lambda: self.render(scene, RenderFlags.FLAT)[0][8, 8].tolist()
        self.assertEqual(look(), [255, 0, 0])
        primitive.material.baseColorTexture.source = np.uint8([[[0, 255, 0]]])
        self.assertEqual(look(), [0, 255, 0])
        primitive.material = pyrender.MetallicRoughnessMaterial(baseColorFactor=[0, 0, 255, 255])
        self.assertEqual(look(), [0, 0, 255])
        primitive.material.baseColorFactor = [255, 255, 255, 255]
        self.assertEqual(look(), [255, 255, 255])
        primitive.positions = primitive.positions - (0, 0, 1)
        self.assertAlmostEqual(float(self.render(scene)[1][8, 8]), 3, places=5)

    def test_lit_colors(self):
        """Colours of vertices are linear in the light: white and grey surfaces in ambient light of 0.5."""
        def shown(value):
            colors = ColorVisuals(np.uint8([[value, value, value, 255]] * 4))
            scene = self.scene(self.mesh(colors), ambient_light=[0.5, 0.5, 0.5])
            return int(self.render(scene)[0][8, 8, 0])
        np.testing.assert_allclose((shown(255), shown(128)), (188, 137), atol=5)  # sRGB of 0.5 and of 0.251

    def test_translucent_depth(self):
        """Translucent surfaces show what is behind them, and have a depth."""
        glass = pyrender.MetallicRoughnessMaterial(alphaMode="BLEND", baseColorFactor=[1.0, 0, 0, 0.5])
        scene = self.scene(self.mesh(material=glass), bg_color=[0.0, 0.0, 1.0])
        color, depth = self.render(scene, RenderFlags.FLAT)
        self.assertEqual((color[8, 8].tolist(), float(depth[8, 8])), ([188, 0, 188], 2.0))

    def test_copies(self):
        """Scenes can be copied and pickled, and the copies are independent."""
        mesh = self.mesh(TextureVisuals(UV, SimpleMaterial(np.uint8([[[255, 0, 0]]]), diffuse=[255] * 4)))
        scene = self.scene(mesh)
        look = lambda shown: self.render(shown, RenderFlags.FLAT)[0][8, 8].tolist()
        self.assertEqual(look(scene), [255, 0, 0])
        for made in (copy.deepcopy(scene), pickle.loads(pickle.dumps(scene))):
            self.assertEqual(look(made), [255, 0, 0])
            next(iter(made.meshes)).primitives[0].material.baseColorFactor = [0, 255, 0, 255]
            self.assertEqual((look(made), look(scene)), ([0, 0, 0], [255, 0, 0]))

    def test_samplers(self):
        """Wraps and filters of a sampler: u from 1 to 2 of a texture of two texels."""
        pixels = np.uint8([[[255, 0, 0], [0, 255, 0]]])
        uv = [[1, 0], [2, 0], [2, 1], [1, 1]]
        for values, left in ((dict(wrapS=GLTF.REPEAT), [255, 0, 0]), (dict(wrapS=GLTF.CLAMP_TO_EDGE), [0, 255, 0]),
                             (dict(wrapS=GLTF.MIRRORED_REPEAT), [0, 255, 0])):
            sampler = pyrender.Sampler(minFilter=GLTF.NEAREST, magFilter=GLTF.NEAREST, **values)
            texture = pyrender.Texture(source=pixels, source_channels="RGB", sampler=sampler)
            material = pyrender.MetallicRoughnessMaterial(baseColorTexture=texture)
            made = pyrender.Primitive(square().vertices, texcoord_0=uv, indices=square().faces, material=material)
            color = self.render(self.scene(pyrender.Mesh([made])), RenderFlags.FLAT)[0]
            self.assertEqual(color[8, 4].tolist(), left)

    def test_modes(self):
        """Each mode of a primitive: pixels of the square, or of lines along its border."""
        corners, white = square().vertices[:, :3], pyrender.MetallicRoughnessMaterial()
        for mode, indices, low, high in (
                (GLTF.TRIANGLES, [0, 1, 2, 0, 2, 3], 256, 256), (GLTF.TRIANGLE_STRIP, [3, 0, 2, 1], 256, 256),
                (GLTF.TRIANGLE_FAN, [0, 1, 2, 3], 256, 256), (GLTF.POINTS, [0, 1, 2, 3], 1, 4),
                (GLTF.LINES, [0, 2], 14, 32), (GLTF.LINE_STRIP, [0, 2, 0], 14, 32), (GLTF.LINE_LOOP, [0, 2], 14, 32)):
            with self.subTest(mode):
                made = pyrender.Primitive(0.999 * corners, indices=indices, material=white, mode=mode)
                depth = self.render(self.scene(pyrender.Mesh([made])))[1]
                self.assertTrue(low <= (depth > 0).sum() <= high, (depth > 0).sum())

    def test_incomplete_modes(self):
        """Corners that complete no point, line or triangle are left out, also where normals are shown."""
        flags = RenderFlags.VERTEX_NORMALS | RenderFlags.FACE_NORMALS
        corners, white = square().vertices[:, :3], pyrender.MetallicRoughnessMaterial()
        for mode, indices, count in (
                (GLTF.TRIANGLES, [0, 1, 2, 0, 2, 3, 1], 256), (GLTF.TRIANGLES, [0, 1], 0), (GLTF.TRIANGLES, [], 0),
                (GLTF.TRIANGLE_STRIP, [0, 1], 0), (GLTF.TRIANGLE_STRIP, [], 0), (GLTF.TRIANGLE_FAN, [0, 1], 0),
                (GLTF.TRIANGLE_FAN, [], 0), (GLTF.LINES, [0], 0), (GLTF.LINE_STRIP, [0], 0), (GLTF.LINE_LOOP, [], 0),
                (GLTF.POINTS, [], 0)):
            with self.subTest(mode=mode, indices=indices):
                made = pyrender.Primitive(corners, indices=indices, material=white, mode=mode)
                color, depth = self.render(self.scene(pyrender.Mesh([made])))
                self.assertEqual((depth > 0).sum(), count)
                self.render(self.scene(pyrender.Mesh([made])), flags)
        whole = pyrender.Primitive(corners, material=white)  # four vertices in order: one triangle
        self.assertEqual(len(whole.parts[0].mesh.indices), 1)

    def test_normals(self):
        """Normals are blue lines of 0.05 of the scale of the primitive."""
        edge = Trimesh(square().vertices[:, (0, 2, 1)], square().faces)  # upright, seen from its edge
        mesh = pyrender.Mesh.from_trimesh(edge)
        for flags, lines in ((RenderFlags.NONE, 0), (RenderFlags.VERTEX_NORMALS, 2), (RenderFlags.FACE_NORMALS, 2)):
            color = self.render(self.scene(mesh), RenderFlags.FLAT | RenderFlags.SKIP_CULL_FACES | flags, size=64)[0]
            blue = (color[..., 2] == 255) & (color[..., 0] < 240)  # the lines are antialiased
            self.assertEqual(bool(blue.any()), lines > 0)
            self.assertLessEqual(int(blue.sum(axis=0).max()), 8)  # 0.05 * sqrt(8) of 32 pixels a unit

    def test_model(self):
        """A loaded model has the attributes of a mesh and of a scene of trimesh."""
        require_component("shd_scene", DUCK)
        model = pyrender.load(DUCK)
        self.assertEqual((model.vertices.shape[1], model.faces.shape[1], model.faces.max()),
                         (3, 3, len(model.vertices) - 1))
        self.assertEqual((len(model.face_normals), len(model.vertex_normals), len(model.dump()), model.is_empty),
                         (len(model.faces), len(model.vertices), 1, False))
        np.testing.assert_allclose(np.linalg.norm(model.vertex_normals, axis=1), 1, rtol=1e-5)
        np.testing.assert_allclose(model.bounds, [model.vertices.min(axis=0), model.vertices.max(axis=0)])
        moved = model.copy().apply_scale(2).apply_translation([1, 0, 0])
        np.testing.assert_allclose(moved.extents, 2 * model.extents)
        np.testing.assert_allclose(moved.bounds[0] - (1, 0, 0), 2 * model.bounds[0])
        scene = pyrender.Scene.from_trimesh_scene(model)
        np.testing.assert_allclose(scene.bounds, model.bounds, rtol=1e-5)
        mesh = pyrender.Mesh.from_trimesh(list(model.geometry.values())[0])
        self.assertIsNotNone(mesh.primitives[0].material.baseColorTexture)
        scene.add(pyrender.PerspectiveCamera(1.0), pose=at(model.bounds[1, 2] + model.scale))
        smooth = self.render(scene, RenderFlags.FLAT, size=32)[0]
        flat = pyrender.Scene()
        flat.add(pyrender.Mesh.from_trimesh(model, smooth=False))
        flat.add(pyrender.PerspectiveCamera(1.0), pose=at(model.bounds[1, 2] + model.scale))
        difference = np.abs(self.render(flat, RenderFlags.FLAT, size=32)[0].astype(int) - smooth)
        self.assertLess((difference > 8).mean(), 0.02)
