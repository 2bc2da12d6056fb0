# SPDX-License-Identifier: MIT
"""Differences and tolerances, hashes, the store of references and the commands."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import numpy as np

import shd.__main__
from shd import golden


def grey(value=100, shape=(8, 10, 3), dtype=np.uint8):
    return np.full(shape, value, dtype)


def changed(picture, value, where=(2, 3, 1)):
    out = picture.copy()
    out[where] = value
    return out


class Differences(unittest.TestCase):
    def test_numbers(self):
        difference = golden.compare(grey(), changed(changed(grey(), 104), 97, (0, 0, 0)))
        self.assertEqual((difference.max_abs, difference.pixels), (4, 2))
        self.assertAlmostEqual(difference.rms, ((16 + 9) / 240) ** 0.5)
        self.assertGreater(difference.max_flip, difference.mean_flip)
        self.assertEqual(difference.flip.shape, (8, 10))

    def test_tolerances(self):
        difference = golden.compare(grey(), changed(grey(), 104))
        for name, value in (("max_abs", 4), ("max_rms", difference.rms), ("max_pixels", 1),
                            ("max_flip", difference.max_flip), ("max_mean_flip", difference.mean_flip)):
            with self.subTest(name):
                self.assertEqual(difference.exceeded(**{name: value}), [])
                problem, = difference.exceeded(**{name: value * 0.99})
                self.assertRegex(problem, rf"more than .* \({name}\)")
        self.assertEqual(len(difference.exceeded()), 1)
        self.assertEqual(len(difference.exceeded(max_abs=1, max_pixels=0, max_rms=9)), 2)
        self.assertEqual(golden.compare(grey(), grey()).exceeded(), [])

    def test_wrong_tolerances(self):
        difference = golden.compare(grey(), grey())
        for wrong in (-1, float("nan")):
            with self.assertRaisesRegex(ValueError, "max_flip: .* is not a number of at least 0"):
                difference.exceeded(max_flip=wrong)
        with self.assertRaisesRegex(TypeError, "max_colour is not a tolerance: max_abs"):
            difference.exceeded(max_colour=1)

    def test_shapes_and_types_must_agree(self):
        for other, text in ((grey(shape=(8, 9, 3)), "shape is .8, 9, 3."), (grey(shape=(8, 10, 4)), "shape"),
                            (grey(dtype=np.uint16), "type is uint16")):
            difference = golden.compare(grey(), other)
            self.assertRegex(difference.exceeded(max_abs=255)[0], text)
            self.assertEqual(golden.side_by_side(difference).ndim, 3)
            with self.assertRaisesRegex(ValueError, text):
                difference.flip

    def test_all_kinds_of_pictures(self):
        for channels in (1, 2, 3, 4):
            for dtype, top in ((np.uint8, 255), (np.uint16, 65535), (np.float16, 1), (np.float32, 1), (float, 1)):
                first = grey(0, (5, 6, channels), dtype)
                if channels in (2, 4):
                    first[..., -1] = top
                same, other = golden.compare(first, first), golden.compare(first, changed(first, top, (1, 1, 0)))
                self.assertEqual((same.max_flip, same.max_abs), (0, 0))
                self.assertEqual(golden.side_by_side(other).shape[0], 5)
                self.assertEqual(other.max_abs, top)
                self.assertGreater(other.max_flip, 0.3)
        self.assertEqual(golden.compare(np.zeros((3, 4)), np.zeros((3, 4))).flip.shape, (3, 4))

    def test_alpha_counts(self):
        black = grey(0, (8, 8, 4))
        black[..., 3] = 255
        self.assertGreater(golden.compare(black, changed(black, 0, (4, 4, 3))).max_flip, 0.5)

    def test_large_integers_do_not_wrap(self):
        self.assertEqual(golden.compare(grey(0, dtype=np.uint16), grey(65535, dtype=np.uint16)).max_abs, 65535)

    def test_refused_pictures(self):
        nan = changed(grey(0.5, dtype=np.float32), np.nan)
        for wrong, text in ((nan, r"picture: 1 values are NaN or infinite, the first at \[2, 3, 1\]"),
                            (changed(grey(0.5, dtype=float), np.inf), "infinite"), (grey(dtype=np.int32), "int32, not"),
                            (np.zeros(4), "shape is .4,."), (np.zeros((0, 4, 3)), "shape"),
                            (np.zeros((2, 2, 5)), "shape"),
                            ([["a"]], "type is"), (None, "type is object")):
            with self.assertRaisesRegex(golden.PictureError, text):
                golden.compare(grey(0.5, dtype=np.float32), wrong)
        with self.assertRaisesRegex(ValueError, "values are 0..2, not in 0..1; linear pictures need hdr=True"):
            golden.compare(np.zeros((2, 2, 3)), changed(np.zeros((2, 2, 3)), 2, (0, 0, 0))).flip
        with self.assertRaisesRegex(ValueError, "hdr: needs pictures"):
            golden.compare(grey(), grey(), hdr=True).flip


class Hashes(unittest.TestCase):
    def test_bits_shape_and_type_count(self):
        pictures = [grey(), grey(101), grey(shape=(10, 8, 3)), grey(dtype=np.uint16), grey(0.0, dtype=np.float32),
                    grey(-0.0, dtype=np.float32), changed(grey(), 0)]
        self.assertEqual(len({golden.picture_hash(p) for p in pictures}), len(pictures))

    def test_layout_and_byte_order_do_not_count(self):
        picture = np.random.default_rng(1).random((5, 6, 3)).astype(np.float32)
        want = golden.picture_hash(picture)
        for other in (np.asfortranarray(picture), picture.astype(">f4"), picture[::-1][::-1]):
            self.assertEqual(golden.picture_hash(other), want)

    def test_known_value(self):
        # printf '1x2x1 uint8\n\001\002' | sha256sum
        self.assertEqual(golden.picture_hash(np.uint8([[[1], [2]]])),
                         "28c9fa57eccf11b3019a5b15c3edf331f8e034d889e9ae2c1a13a1d5186d6dc5")


class StoreCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.store = golden.Store(self.folder)

    def files(self):
        return sorted(str(p.relative_to(self.folder)) for p in self.folder.rglob("*") if p.is_file())

    def write(self, picture, name="a/b"):
        golden.Store(self.folder, update=True).check(picture, name)


class Stores(StoreCase):
    def test_equal_pictures_pass_and_leave_nothing(self):
        self.write(grey())
        self.assertEqual(self.store.check(grey(), "a/b").max_abs, 0)
        self.assertEqual(self.files(), ["a/b.png"])

    def test_different_pictures_leave_result_and_difference(self):
        self.write(grey())
        with self.assertRaisesRegex(golden.GoldenError, "number of pixels that differ is 1, more than 0"):
            self.store.check(changed(grey(), 0), "a/b")
        self.assertEqual(self.files(), ["a/b.png", "failed/a/b.difference.png", "failed/a/b.result.png"])
        np.testing.assert_array_equal(golden.load(self.folder / "failed/a/b.result.png"), changed(grey(), 0))
        shown = golden.load(self.folder / "failed/a/b.difference.png")
        self.assertEqual(shown.shape, (8, 3 * 10 + 2 * 4, 3))
        self.assertEqual(shown[0, 0].tolist(), [100] * 3)
        self.assertGreater(shown[2, 28 + 3].max(), shown[7, 28 + 9].max())  # the map is bright at the changed pixel
        self.assertEqual(self.store.check(changed(grey(), 0), "a/b", max_flip=1).pixels, 1)
        self.assertEqual(self.files(), ["a/b.png"])

    def test_a_missing_reference_fails_and_is_not_written(self):
        with self.assertRaisesRegex(golden.GoldenError, "there is no reference .*a/b.png"):
            self.store.check(grey(), "a/b")
        self.assertEqual(self.files(), ["failed/a/b.result.png"])

    def test_waiting_results_are_accepted(self):
        for name in ("a/b", "c"):
            self.assertRaises(golden.GoldenError, self.store.check, grey(), name)
        self.assertRaises(golden.GoldenError, self.store.check_hash, grey(), "h")
        self.assertEqual(self.store.waiting(), (["a/b", "c"], ["h"]))
        self.assertEqual(self.store.accept(), ["a/b", "c", "h"])
        self.assertEqual(self.files(), ["a/b.png", "c.png", "hashes.txt"])
        self.store.check(grey(), "c")
        self.store.check_hash(grey(), "h")
        self.assertEqual(self.store.accept(), [])

    def test_hashes(self):
        golden.Store(self.folder, update=True).check_hash(grey(), "h")
        self.assertEqual(self.store.check_hash(grey(), "h"), golden.picture_hash(grey()))
        with self.assertRaisesRegex(golden.GoldenError, "the hash is [0-9a-f]{64}, and that of the reference is"):
            self.store.check_hash(grey(1), "h")
        self.assertEqual(self.files(), ["failed/hashes.txt", "hashes.txt"])
        self.store.check_hash(grey(), "h")
        self.assertEqual(self.files(), ["hashes.txt"])
        (self.folder / "hashes.txt").write_text("no hash\n")
        with self.assertRaisesRegex(ValueError, "hashes.txt:1: not a SHA-256"):
            self.store.check_hash(grey(), "h")

    def test_numbers_are_stored_with_16_bits(self):
        picture = np.random.default_rng(2).random((4, 5, 3))
        self.write(picture)
        self.assertEqual(golden.load(self.folder / "a/b.png").dtype, np.uint16)
        self.assertEqual(self.store.check(picture, "a/b").max_abs, 0)
        difference = self.store.check(np.clip(picture + 0.01, 0, 1), "a/b", max_abs=0.011)
        self.assertAlmostEqual(difference.max_abs, 0.01, places=4)
        with self.assertRaisesRegex(ValueError, "not in 0..1"):
            self.store.check(picture * 3, "a/b")

    def test_names(self):
        for wrong in ("", "../a", "/a", "a//b", "a b", "a/../b", ".a", "a.result", 3, None):
            with self.assertRaisesRegex(ValueError, "name: "):
                self.store.check(grey(), wrong)
            with self.assertRaisesRegex(ValueError, "name: "):
                self.store.check_hash(grey(), wrong)

    def test_a_malformed_reference(self):
        (self.folder / "c.png").write_bytes(b"no picture")
        with self.assertRaisesRegex(golden.PictureError, "c.png: not a PNG file"):
            self.store.check(grey(), "c")


class Commands(StoreCase):
    def run_command(self, *arguments):
        """(exit code, printed text)."""
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = shd.__main__.main([str(a) for a in arguments])
        return code, out.getvalue()

    def test_compare(self):
        a, b, c, bad = (self.folder / f"{n}.png" for n in ("a", "b", "c", "bad"))
        for path, picture in ((a, grey()), (b, changed(grey(), 104)), (c, grey(shape=(4, 4, 3)))):
            golden.save(path, picture)
        bad.write_bytes(a.read_bytes()[:50])
        self.assertEqual(self.run_command("compare", a, a)[0], 0)
        code, text = self.run_command("compare", a, b)
        self.assertEqual(code, 1)
        self.assertRegex(text, "largest difference 4, RMS .*, 1 of 80 pixels differ, FLIP largest 0.")
        self.assertEqual(self.run_command("compare", a, b, "--max-abs", 4, "--max-flip", 0.5)[0], 0)
        self.assertEqual(self.run_command("compare", a, b, "--max-flip", 0.0001)[0], 1)
        self.assertEqual(self.run_command("compare", a, b, "-o", self.folder / "map.png")[0], 1)
        self.assertEqual(golden.load(self.folder / "map.png").shape, (8, 38, 3))
        self.assertEqual(self.run_command("compare", a, c)[0], 1)
        for arguments, text in (((a, bad), "bad.png: the file ends"), ((a, self.folder / "none.png"), "No such file"),
                                ((a, b, "--max-abs", -1), "max_abs: -1.0 is not"),
                                ((a, b, "--max-flip", 1, "--pixels-per-degree", 0), "pixels_per_degree")):
            code, printed = self.run_command("compare", *arguments)
            self.assertEqual(code, 2)
            self.assertRegex(printed, text)

    def test_golden(self):
        self.assertRaises(golden.GoldenError, self.store.check, grey(), "c")
        code, text = self.run_command("golden", self.folder)
        self.assertEqual((code, text), (1, "c: differs from the reference, or has none\n"))
        self.assertEqual(self.run_command("golden", self.folder, "--update"), (0, "c: updated\n"))
        self.assertEqual(self.run_command("golden", self.folder), (0, ""))
        self.assertEqual(self.files(), ["c.png"])
        self.assertEqual(self.run_command("golden", self.folder / "none")[0], 2)

    def test_render(self):
        for arguments in (("render",), ()):
            path = self.folder / "torus.png"
            self.assertEqual(self.run_command(*arguments, path, "--size", 32, 24)[0], 0)
            self.assertEqual(golden.load(path).shape, (24, 32, 4))


if __name__ == "__main__":
    unittest.main()
