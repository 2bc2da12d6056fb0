# SPDX-License-Identifier: MIT
"""Models in memory, their files, warnings and poses, and what shd.Renderer and shd.pyrender show of them."""
import gc
import json
import pathlib
import pickle
import tempfile
import weakref

import numpy as np

import shd
from shd import _png, io, pyrender
from support import Case, require_component

SQUARE = np.float32([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])  # seen from +z
TIMES, MOVES = np.float32([0, 2]), np.float32([[0, 0, 0], [4, 0, 0]])


def gltf(matrix=None, uri="a.bin", **material):
    """A glTF 2.0 model of the square, and its buffer: a texture that no file has, and an animation to x = 4 in 2 s."""
    parts = [SQUARE.tobytes(), np.uint16([0, 1, 2, 0, 2, 3]).tobytes(), TIMES.tobytes(), MOVES.tobytes()]
    offsets = np.cumsum([0, *map(len, parts)])
    kinds = ((5126, 4, "VEC3"), (5123, 6, "SCALAR"), (5126, 2, "SCALAR"), (5126, 2, "VEC3"))
    root = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, **({"matrix": matrix} if matrix else {})}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "paint", **material}],
        "buffers": [{"uri": uri, "byteLength": int(offsets[-1])}],
        "bufferViews": [{"buffer": 0, "byteOffset": int(o), "byteLength": len(p)} for o, p in zip(offsets, parts)],
        "accessors": [{"bufferView": i, "componentType": c, "count": n, "type": t}
                      for i, (c, n, t) in enumerate(kinds)]}
    root["accessors"][0].update(min=[-1, -1, 0], max=[1, 1, 0])
    root["accessors"][2].update(min=[0], max=[2])
    if not matrix:
        root["animations"] = [{"name": "Move", "samplers": [{"input": 2, "output": 3}],
                               "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]
    return json.dumps(root).encode(), b"".join(parts)


TEXTURED = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
RED = {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0}}
MIRRORED = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]  # x of the square to -x
TURNED = [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]  # half a turn around y: its back to +z


def textured():
    model, buffer = gltf(**TEXTURED)
    root = json.loads(model)
    return json.dumps({**root, "textures": [{"source": 0}], "images": [{"uri": "paint.png"}]}).encode(), buffer


def png(color):
    """A PNG of 2 x 2 pixels of one colour r, g, b."""
    return _png.encode(np.full((2, 2, 3), color, np.uint8))


class Models(Case):
    @classmethod
    def setUpClass(cls):
        require_component("shd_scene")
        super().setUpClass()

    def scene(self, source, **values):
        return shd.Scene(self.context, source, **values)

    def test_memory(self):
        """A model in memory, whose files a dict or a function gives, by the worker and in this process."""
        model, buffer = textured()
        files = {"a.bin": buffer, "paint.png": png((255, 0, 0))}
        asked = []

        def find(name):
            asked.append(name)
            return memoryview(files[name])

        for source, values in ((model, {"find": files}), (bytearray(model), {"find": find}),
                               (np.frombuffer(model, np.uint8), {"find": find, "flags": "in_process"}),
                               (memoryview(model), {"desc": shd.SceneDesc(find=find)})):
            with self.subTest(type=type(source), values=list(values)):
                scene = self.scene(source, **values)
                self.assertEqual(scene.info["triangle_count"], 2)
                corners = np.unique(scene.meshes[0].positions, axis=0)  # faces without normals share none
                np.testing.assert_array_equal(corners, np.unique(SQUARE, axis=0))
                self.assertEqual(scene.textures[0].read_level()[1, 1, :3].tolist(), [255, 0, 0])
        self.assertEqual(set(asked), set(files))
        obj = b"mtllib sub/a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        scene = self.scene(obj, name="a.obj", find={"sub/a.mtl": b"newmtl red\nKd 1 0 0\n"})
        self.assertEqual((scene.names("material"), scene.material_descs[0].diffuse), (["red"], (1, 0, 0)))

    def test_disk(self):
        """`find` replaces the folder of a model on disk; without it, only `any_folder` leaves the folder."""
        model, buffer = gltf(uri="../a.bin", **RED)
        with tempfile.TemporaryDirectory() as folder:
            inside = pathlib.Path(folder) / "models"
            inside.mkdir()
            (inside / "a.gltf").write_bytes(model)
            (inside.parent / "a.bin").write_bytes(buffer)
            path = inside / "a.gltf"
            self.check_refused(shd.Error, "a.bin", self.scene, path)
            for values in ({"flags": "any_folder"}, {"flags": "any_folder|in_process"},
                           {"find": {"../a.bin": buffer}}):
                with self.subTest(values=list(values)):
                    self.assertEqual(self.scene(path, **values).info["triangle_count"], 2)

    def test_warnings(self):
        model, buffer = textured()
        scene = self.scene(model, find={"a.bin": buffer})
        self.assertEqual(len(scene.warnings), scene.info["warning_count"])
        self.assertTrue(any("paint.png" in text for text in scene.warnings), scene.warnings)
        self.check_refused(shd.Error, "paint.png", self.scene, model, find={"a.bin": buffer}, flags="require_textures")

    def test_filters(self):
        """The filters of the file, or with host_filters those of the desc."""
        model, buffer = textured()
        root = json.loads(model)
        root["samplers"], root["textures"] = [{"magFilter": 9728, "minFilter": 9728}], [{"source": 0, "sampler": 0}]
        root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 0
        files = {"a.bin": buffer, "paint.png": png((255, 0, 0))}
        desc = {"find": files, "sampler": {"filter": "bilinear"}}
        for flags, expected in (("none", True), ("host_filters", False)):
            slots = self.scene(json.dumps(root).encode(), flags=flags, **desc).material_descs[0].slots
            pixel = shd.Texture(self.context, np.float32([[0, 1]]))
            seen = pixel.sample(slots[0].sampler, np.float32([0.6]), np.float32([0.5]), lod=np.float32([0]), channels=1)
            self.assertEqual(seen[0, 0] == 1, expected, (flags, seen))

    def test_poses(self):
        model, buffer = gltf(**RED)
        scene = self.scene(model, find={"a.bin": buffer})
        self.assertEqual((scene.names("animation"), scene.animation_times(0)), (["Move"], (0, 2)))
        for animation in (0, "Move"):
            posed = scene.pose(animation, 1)
            self.assertEqual(posed.instances[0].object_to_world[0, 3], 2)
        self.assertEqual(scene.instances[0].object_to_world[0, 3], 0)
        self.check_refused(ValueError, "animation: .Run. is not one of", scene.pose, "Run", 1)
        self.check_refused(shd.Error, "animation: 1, but the scene has 1", scene.pose, 1, 1)
        self.check_refused(shd.Error, "", scene.pose, 0, float("nan"))
        with shd.Renderer(16, 16, sample_count=1, context=self.context) as renderer:
            renderer.add(scene.pose("Move", 2))
            renderer.look_at(eye=(4, 0, 4), target=(4, 0, 0))
            self.assertGreater(renderer.render(flat=True)[0][8, 8, 0], 250)

    def test_callbacks(self):
        """The load raises what the function raises, and forgets the function and its answers at its end."""
        model, buffer = gltf(**RED)

        def missing(name):
            raise KeyError(name)

        for flags in ("none", "in_process"):
            self.check_refused(KeyError, "a.bin", self.scene, model, find=missing, flags=flags)
            self.check_refused(TypeError, "scene.find: bytes or None for 'a.bin', not str", self.scene, model,
                               find=lambda name: "text", flags=flags)
        picture = dict(zip(("model", "buffer"), textured()))
        find = {"a.bin": picture["buffer"]}.__getitem__  # the texture raises
        self.check_refused(KeyError, "paint.png", self.scene, picture["model"], find=find)
        self.check_refused(TypeError, "scene.find: a function or a dict, not int", self.scene, model, find=3)
        self.check_refused(TypeError, "name: only models in memory", self.scene, "a.obj", name="a.obj")
        self.check_refused(shd.Error, "a.bin", self.scene, model)
        self.check_refused(shd.Error, "", self.scene, b"no model")

        class Answer(dict):
            pass

        held = Answer({"a.bin": buffer})
        alive, scene = weakref.ref(held), self.scene(model, find=held)
        del held
        gc.collect()
        self.assertIsNone(alive())
        self.assertEqual(scene.info["triangle_count"], 2)


class Shown(Case):
    """Colours of vertices and culled faces, through shd.Renderer and shd.pyrender."""

    @classmethod
    def setUpClass(cls):
        require_component("shd_scene")
        super().setUpClass()

    def rendered(self, source, **values):
        with shd.Renderer(16, 16, sample_count=1, background=(0, 0, 1), context=self.context) as renderer:
            renderer.add(source, **values)
            renderer.look_at(eye=(0, 0, 3))
            return renderer.render(flat=True)[0][8, 8].tolist()

    @staticmethod
    def pyrendered(source, **values):
        scene = pyrender.Scene(ambient_light=[1.0, 1.0, 1.0], bg_color=(0.0, 0.0, 1.0, 1.0))
        scene.add(pyrender.Mesh.from_trimesh(pyrender.load(source, **values)))
        pose = np.eye(4)
        pose[2, 3] = 3
        scene.add(pyrender.PerspectiveCamera(0.8), pose=pose)
        with pyrender.OffscreenRenderer(16, 16) as renderer:
            return renderer.render(scene, pyrender.RenderFlags.FLAT)[0][8, 8].tolist()

    def check_shown(self, source, expected, **values):
        for draw in (self.rendered, self.pyrendered):
            with self.subTest(draw=draw.__name__):
                np.testing.assert_allclose(draw(source, **values), expected, atol=1)

    def test_vertex_colors(self):
        """PLY: colours of vertices are sRGB codes here as in the file."""
        head = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n")
        rows = "".join(f"{x} {y} {z} 255 0 0\n" for x, y, z in SQUARE)
        ply = (head + rows + "4 0 1 2 3\n").encode()
        self.check_shown(ply, (255, 0, 0))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "model.ply"
            path.write_bytes(ply)
            self.check_shown(path, (255, 0, 0))

    def test_culled_faces(self):
        """glTF 2.0, 3.9.5: backs are culled unless a material is double-sided; 3.7.4: mirrors turn the front around."""
        back, red = (0, 0, 255), (255, 0, 0)
        for name, matrix, double, expected in (
                ("front", None, False, red), ("behind", TURNED, False, back), ("double behind", TURNED, True, red),
                ("mirrored", MIRRORED, False, red), ("mirrored double", MIRRORED, True, red)):
            with self.subTest(name):
                model, buffer = gltf(matrix, doubleSided=double, **RED)
                self.check_shown(model, expected, find={"a.bin": buffer})


class Pieces(Case):
    """The parts of a file as shd.pyrender has them: their names, places and materials."""

    @classmethod
    def setUpClass(cls):
        require_component("shd_scene")
        super().setUpClass()

    @staticmethod
    def loaded(change, images=(), **material):
        """A model of the square, whose root `change` may change."""
        model, buffer = gltf(**material)
        root = json.loads(model)
        root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 0
        root["images"] = [{"uri": f"{i}.png"} for i in range(len(images))]
        root["textures"] = [{"source": i, "sampler": i} for i in range(len(images))]
        change(root)
        files = {"a.bin": buffer, **{f"{i}.png": _png.encode(image) for i, image in enumerate(images)}}
        return pyrender.load(json.dumps({k: v for k, v in root.items() if v}).encode(), find=files)

    def test_names(self):
        """Each primitive of each mesh is drawn at its own nodes, also where names are those of others."""
        def primitives(root):
            root["meshes"][0]["name"] = "m"
            root["materials"].append({"name": "other"})
            first = root["meshes"][0]["primitives"][0]
            root["meshes"][0]["primitives"].append({**first, "material": 1, "indices": len(root["accessors"])})
            root["accessors"].append({**root["accessors"][1], "count": 3})  # one triangle

        def meshes(root):
            primitives(root)
            first, second = root["meshes"][0]["primitives"]
            root["meshes"] = [{"name": "m", "primitives": [first]}, {"name": "m", "primitives": [second]}]
            root["nodes"].append({"mesh": 1, "translation": [5, 0, 0]})
            root["scenes"][0]["nodes"] = [0, 1]

        for change, width in ((primitives, 2), (meshes, 7)):
            with self.subTest(change.__name__):
                model = self.loaded(change)
                graph, geometry = model.graph, model.geometry
                self.assertEqual([graph[node][1] for node in graph.nodes_geometry], ["m", "m_1"])
                self.assertEqual({name: len(piece.faces) for name, piece in geometry.items()}, {"m": 2, "m_1": 1})
                scene = pyrender.Scene.from_trimesh_scene(model)
                self.assertEqual([len(node.mesh.primitives[0].indices) for node, _ in scene.placed("mesh")], [6, 3])
                np.testing.assert_allclose(scene.bounds, model.bounds)
                self.assertEqual(scene.extents[0], width)

        def twice(root):
            root["nodes"].append({"mesh": 0, "translation": [5, 0, 0]})
            root["scenes"][0]["nodes"] = [0, 1]

        model = self.loaded(twice)  # two places of one mesh
        self.assertEqual((len(model.geometry), len(model.graph.nodes_geometry)), (1, 2))
        np.testing.assert_array_equal(model.face_normals, [[0, 0, 1]] * 4)
        self.assertEqual(len(pyrender.Scene.from_trimesh_scene(model).meshes), 1)

    def test_materials(self):
        """All textures with their channels, wraps and filters, and the mode of the file."""
        rng = np.random.default_rng(3)
        images = [rng.integers(0, 256, (2, 4, 4)).astype(np.uint8) for _ in range(5)]
        nearest, linear = pyrender.GLTF.NEAREST, pyrender.GLTF.LINEAR
        wraps = ((10497, 33071), (33071, 33648), (33648, 10497), (10497, 10497), (33071, 33071))
        filters = ((nearest, 9984), (linear, 9985), (nearest, 9986), (linear, 9987), (linear, linear))

        def samplers(root):
            root["samplers"] = [{"wrapS": s, "wrapT": t, "magFilter": large, "minFilter": small}
                                for (s, t), (large, small) in zip(wraps, filters)]

        textures = {"pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}, "metallicFactor": 0.5,
            "roughnessFactor": 0.25, "baseColorFactor": [0.5, 1, 0.25, 0.75]},
            "normalTexture": {"index": 2}, "occlusionTexture": {"index": 3}, "emissiveTexture": {"index": 4},
            "emissiveFactor": [1, 0.5, 0.25]}
        images[0][..., 3] |= 128
        blended = pyrender.Mesh.from_trimesh(self.loaded(samplers, images, alphaMode="BLEND", **textures))
        np.testing.assert_allclose(blended.primitives[0].material.baseColorTexture.source.astype(int), images[0], atol=2)
        primitive = pyrender.Mesh.from_trimesh(self.loaded(samplers, images, **textures)).primitives[0]
        made = primitive.material
        names = ("baseColor", "metallicRoughness", "normal", "occlusion", "emissive")
        for i, (name, channels) in enumerate(zip(names, (slice(4), slice(1, 3), slice(3), slice(1), slice(3)))):
            with self.subTest(name):
                texture = getattr(made, f"{name}Texture")
                self.assertIsNone(texture._source)  # nothing is read before it is asked for
                np.testing.assert_array_equal(texture.source, images[i][..., channels])
                sampler = texture.sampler
                self.assertEqual(((sampler.wrapS, sampler.wrapT), (sampler.magFilter, sampler.minFilter)),
                                 (wraps[i], filters[i]))
        self.assertEqual((made.metallicFactor, made.roughnessFactor, made.baseColorFactor.tolist(),
                          made.emissiveFactor.tolist()), (0.5, 0.25, [0.5, 1, 0.25, 0.75], [1, 0.5, 0.25]))
        copied = pickle.loads(pickle.dumps(primitive)).material
        np.testing.assert_array_equal(copied.normalTexture.source, images[2][..., :3])
        made.normalTexture.source = images[0]
        np.testing.assert_array_equal(made.normalTexture.source, images[0][..., :3])
        for values, mode, cutoff in (({"alphaMode": "OPAQUE"}, "OPAQUE", 0.5), ({"alphaMode": "BLEND"}, "BLEND", 0.5),
                                     ({}, "OPAQUE", 0.5), ({"alphaMode": "MASK", "alphaCutoff": 0.25}, "MASK", 0.25)):
            factors = {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.5]}}
            made = pyrender.Mesh.from_trimesh(self.loaded(lambda root: None, **factors, **values)).primitives[0].material
            self.assertEqual((made.alphaMode, made.alphaCutoff), (mode, cutoff))

    def test_changed(self):
        """A file's material that a program changes is drawn as before, but for the change."""
        rng = np.random.default_rng(4)
        images = [rng.integers(60, 200, (8, 8, 3)).astype(np.uint8) for _ in range(4)]
        images[2][..., 2] = 255
        textures = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.5,
                                             "metallicRoughnessTexture": {"index": 1}},
                    "normalTexture": {"index": 2}, "occlusionTexture": {"index": 3}}

        def samplers(root):
            root["samplers"] = [{}] * 4

        mesh = pyrender.Mesh.from_trimesh(self.loaded(samplers, images, doubleSided=True, **textures))
        scene = pyrender.Scene(ambient_light=[0.2] * 3)
        scene.add(mesh)
        pose = np.eye(4)
        pose[2, 3] = 3
        for thing in (pyrender.PerspectiveCamera(0.8), pyrender.DirectionalLight(intensity=3.0)):
            scene.add(thing, pose=pose)
        with pyrender.OffscreenRenderer(32, 32) as renderer:
            before = renderer.render(scene)[0].astype(int)
            mesh.primitives[0].material.name = "changed"
            after = renderer.render(scene)[0].astype(int)
            self.assertLessEqual(np.abs(after - before).max(), 2)
            self.assertGreater(before.std(), 5)
            mesh.primitives[0].material.normalTexture = None
            self.assertGreater(np.abs(renderer.render(scene)[0].astype(int) - before).max(), 10)

    def test_separate_maps(self):
        """Maps of opacity, and textures of one channel and of 16 bits: an OBJ file."""
        obj = (b"mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
               b"f 1/1 2/2 3/3\n")
        files = {"a.mtl": b"newmtl m\nmap_Kd color.png\nmap_d opacity.png\n",
                 "color.png": _png.encode(np.uint8([[[10, 20, 30], [40, 50, 60]]])),
                 "opacity.png": _png.encode(np.uint8([[[0]], [[255]], [[51]], [[102]]]))}
        made = pyrender.Mesh.from_trimesh(pyrender.load(obj, name="a.obj", find=files)).primitives[0].material
        self.assertEqual(made.alphaMode, "BLEND")
        np.testing.assert_array_equal(made.baseColorTexture.source[..., 3], [[0] * 2, [255] * 2, [51] * 2, [102] * 2])
        np.testing.assert_array_equal(made.baseColorTexture.source[..., :3], [[[10, 20, 30], [40, 50, 60]]] * 4)
        files["color.png"] = _png.encode(np.uint16([[[10, 20, 30], [40, 50, 60]]]) * 257)
        made = pyrender.Mesh.from_trimesh(pyrender.load(obj, name="a.obj", find=files)).primitives[0].material
        np.testing.assert_array_equal(made.baseColorTexture.source[..., :3], [[[10, 20, 30], [40, 50, 60]]] * 4)


class Containers(Case):
    """Textures of every container from the bytes of files."""

    @classmethod
    def setUpClass(cls):
        require_component("shd_io")
        super().setUpClass()
        cls.pixels = np.arange(64, dtype=np.uint8).reshape(4, 4, 4)

    def loaded(self, source, **values):
        return io.load_texture(self.context, source, **values)

    def test_memory(self):
        image = self.loaded(png((10, 20, 30)))
        self.assertEqual((image.read_level()[0, 0, :3].tolist(), image.file), ([10, 20, 30], None))
        raw = self.loaded(self.pixels.tobytes(), raw={"width": 4, "height": 4, "depth": 4})
        self.assertEqual((raw.info["depth"], raw.read_level(layer=3)[3, 3, 0]), (4, 63))
        self.check_refused(shd.Error, "stack", self.loaded, png((0, 0, 0)), stack={"paths": ["a.png"]})
        self.check_refused(shd.Error, "vdb|VDB", self.loaded, png((0, 0, 0)), vdb={"grid": "density"})

    def test_ktx2(self):
        texture = shd.Texture(self.context, self.pixels, tables="mipmap")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.ktx2"
            io.save(texture, path)
            for source in (path, path.read_bytes()):
                loaded = self.loaded(source)
                self.assertEqual((loaded.file["kind"], loaded.file["level_count"]), (shd.TextureFileKind.KTX2, 3))
                for level in range(3):
                    np.testing.assert_array_equal(loaded.read_level(level), texture.read_level(level))
            self.check_refused(shd.Error, "effort|built without", io.save, texture, path, supercompression="zstd",
                               effort=99)
            self.check_refused(TypeError, "Ktx2Desc has no field dither", io.save, texture, path, dither="ordered")
