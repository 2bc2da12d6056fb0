# SPDX-License-Identifier: MIT
"""FLIP against the oracle, closed forms and properties of the paper."""
import unittest

import numpy as np
import oracle

from shd import _srgb, golden
from shd.golden import flip

RANDOM = np.random.default_rng(20)


def flat(colour, height=6, width=5):
    return np.broadcast_to(np.float64(colour), (height, width, 3))


def scene(height, width):
    """Colours with edges, points and noise."""
    y, x = np.mgrid[:height, :width]
    picture = np.stack([x / width, y / height, ((x // 3 + y // 2) % 2) * 0.8], axis=-1)
    picture[height // 2, width // 2] = 1
    return np.clip(picture + RANDOM.normal(0, 0.03, picture.shape), 0, 1)


class Constants(unittest.TestCase):
    def test_pixels_per_degree(self):
        self.assertAlmostEqual(golden.PIXELS_PER_DEGREE, 67.0206, places=4)

    def test_matrix(self):
        self.assertLess(np.abs(flip.RGB_TO_XYZ * np.float64(oracle.WHITE)[:, np.newaxis] - oracle.M).max(), 1e-7)

    def test_largest_distance(self):
        self.assertAlmostEqual(flip.LARGEST, oracle.c_max(), places=4)
        self.assertAlmostEqual(flip.LARGEST, 41.2761, places=3)

    def test_no_pair_of_corners_is_farther_than_green_and_blue(self):
        corners = flip.hunt_lab(np.float64([[r, g, b] for r in (0, 1) for g in (0, 1) for b in (0, 1)]))
        distances = flip.hyab(corners[:, np.newaxis], corners)
        self.assertAlmostEqual(distances.max() ** 0.7, flip.LARGEST, places=12)

    def test_redistribution_has_its_knee_and_ends(self):
        distances = np.float64([0, 0.2 * flip.LARGEST, 0.4 * flip.LARGEST, 0.7 * flip.LARGEST, flip.LARGEST])
        np.testing.assert_allclose(flip.redistribute(distances ** (1 / 0.7)), [0, 0.475, 0.95, 0.975, 1], atol=1e-12)


class Oracle(unittest.TestCase):
    def compare(self, first, second, ppd):
        want = np.float64(oracle.flip(first.tolist(), second.tolist(), ppd))
        got = flip.flip(first, second, ppd)
        self.assertLess(np.abs(got - want).max(), 2e-6)  # of the white point, which has five digits here

    def test_pictures_at_several_distances(self):
        for height, width, ppd in ((9, 11, 12), (7, 8, 20.5), (5, 4, flip.PIXELS_PER_DEGREE), (1, 1, 15), (1, 6, 9)):
            with self.subTest(size=(height, width), ppd=ppd):
                self.compare(scene(height, width), scene(height, width), ppd)

    def test_edges_that_appear_and_disappear(self):
        edge = np.zeros((8, 8, 3))
        edge[:, 4:] = 1
        self.compare(edge, flat((0.5, 0.5, 0.5), 8, 8), 14)
        self.compare(edge, edge[:, ::-1], 14)

    def test_the_oracle_notices_a_changed_constant(self):
        first, second = scene(6, 6), scene(6, 6)
        want = np.float64(oracle.flip(first.tolist(), second.tolist(), 12))
        self.assertGreater(np.abs(flip.flip(first, second, 12.5) - want).max(), 1e-3)


class ClosedForms(unittest.TestCase):
    """Filters leave flat pictures as they are, and there is no feature: FLIP is the redistributed distance."""

    def test_black_and_white(self):
        knee = 0.4 * oracle.c_max()
        want = 0.95 + 0.05 * (100 ** 0.7 - knee) / (oracle.c_max() - knee)  # lightness 0 and 100
        np.testing.assert_allclose(flip.flip(flat((0, 0, 0)), flat((1, 1, 1))), want, atol=1e-7)

    def test_green_and_blue_are_one(self):
        np.testing.assert_allclose(flip.flip(flat((0, 1, 0)), flat((0, 0, 1))), 1, atol=1e-7)

    def test_random_colours(self):
        for first, second in RANDOM.random((20, 2, 3)):
            distance = oracle.distance(*(oracle.hunt([oracle.linear(v) for v in c]) for c in (first, second)))
            np.testing.assert_allclose(flip.flip(flat(first), flat(second)), flip.redistribute(np.float64(distance)),
                                       atol=1e-5)


class Properties(unittest.TestCase):
    def test_identical_pictures_are_zero(self):
        picture = scene(20, 30)
        self.assertEqual(flip.flip(picture, picture.copy()).max(), 0)

    def test_range_and_symmetry(self):
        for _ in range(5):
            first, second = RANDOM.random((2, 17, 23, 3))
            there, back = flip.flip(first, second), flip.flip(second, first)
            self.assertTrue((there >= 0).all() and (there <= 1).all())
            np.testing.assert_array_equal(there, back)

    def test_mirrored_pictures_have_mirrored_maps(self):
        first, second = scene(12, 15), scene(12, 15)
        for mirror in (np.s_[::-1], np.s_[:, ::-1]):
            np.testing.assert_allclose(flip.flip(first[mirror], second[mirror]), flip.flip(first, second)[mirror],
                                       atol=1e-6)
        turned = flip.flip(first.swapaxes(0, 1), second.swapaxes(0, 1))
        np.testing.assert_allclose(turned.T, flip.flip(first, second), atol=1e-6)

    def test_fine_patterns_vanish_at_a_distance(self):
        checks = (np.indices((40, 40)).sum(axis=0) % 2)[..., np.newaxis] * np.ones(3)
        mean = flat(_srgb.encode(np.float64(0.5)), 40, 40)
        near, far = (flip.flip(checks, mean, ppd)[20, 20] for ppd in (8, 80))
        self.assertLess(far, 0.05)
        self.assertGreater(near, 0.3)

    def test_pixels_per_degree_out_of_range(self):
        for wrong in (0, -1, float("nan"), 1e9):
            with self.assertRaisesRegex(ValueError, "pixels_per_degree.* is not in 0.1..1000"):
                flip.flip(flat((0, 0, 0)), flat((0, 0, 0)), wrong)


class HighDynamicRange(unittest.TestCase):
    def test_exposures_end_where_the_tone_curve_shows_085(self):
        picture = RANDOM.random((9, 9, 3)) * 50
        stops = flip.exposures(picture)
        luminance = picture @ np.float64([0.2126, 0.7152, 0.0722])
        for value, exposure in ((luminance.max(), stops[0]), (np.median(luminance), stops[-1])):
            self.assertAlmostEqual(float(flip.tone_map(np.float64(value * 2.0 ** exposure))), 0.85, places=9)

    def test_differences_in_highlights_count(self):
        first = np.full((16, 16, 3), 0.2)
        first[:4] = 300
        second = first.copy()
        second[:4] = 100
        difference = golden.compare(first, second, hdr=True)
        self.assertGreater(difference.flip[:2].min(), 0.3)
        self.assertLess(difference.flip[-1].max(), 1e-3)
        self.assertEqual(golden.compare(first, first, hdr=True).max_flip, 0)
        shown = golden.side_by_side(difference)
        self.assertEqual(shown.shape, (16, 3 * 16 + 8, 3))
        self.assertGreater(int(shown[0, 0, 0]), int(shown[15, 0, 0]))

    def test_black_references(self):
        black = np.zeros((4, 4, 3))
        self.assertEqual(golden.compare(black, black, hdr=True).max_flip, 0)
        dim = black.copy()
        dim[0, 0] = 0.1
        self.assertTrue(np.isfinite(golden.compare(dim, black, hdr=True).flip).all())


if __name__ == "__main__":
    unittest.main()
