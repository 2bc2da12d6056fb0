# SPDX-License-Identifier: MIT
"""The examples run, and their pictures are plausible. CTest compares the hashes of programs.py."""
import contextlib
import importlib.util
import io
import pathlib
import tempfile

from support import Case, require_component

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "examples"
DUCK = "/usr/share/assimp/models/Collada/duck.dae"


def load(name):
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Examples(Case):
    def test_offscreen(self):
        require_component("shd_io")
        require_component("shd_scene", DUCK)
        from shd import io as files
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
            load("offscreen").main(DUCK, f"{folder}/picture.png")
            pixels = files.load(self.context, f"{folder}/picture.png").pixels
        self.assertIn("400 x 400 pixels, depths 2.", printed.getvalue())
        self.assertEqual(pixels.shape, (400, 800, 4))
        color, depth = pixels[:, :400, :3].astype(int), pixels[:, 400:, :3]
        yellow = (color[..., 0] > 120) & (color[..., 1] > 100) & (color[..., 2] < 60)
        self.assertGreater(yellow.mean(), 0.15)
        self.assertEqual((color[0, 0].tolist(), depth[0, 0].tolist(), int(depth.min())), ([255] * 3, [255] * 3, 0))
