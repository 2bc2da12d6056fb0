# SPDX-License-Identifier: MIT
"""The pytest plugin, run by pytest with -p pytester. Because of its name, nothing else collects the file."""
import numpy as np

from shd import golden

TEST = """
import numpy as np
def test_picture(golden):
    picture = np.full((6, 7, 3), 100, np.uint8)
    {change}
    golden.check(picture, "grey"{tolerance})
"""


def run(pytester, *options, change="", tolerance="", text=TEST):
    pytester.makepyfile(test_golden=text.format(change=change, tolerance=tolerance))
    return pytester.runpytest_subprocess("-p", "shd.pytest_plugin", "-p", "no:cacheprovider", *options)


def reference(pytester, value=100):
    golden.save(pytester.path / "golden/grey.png", np.full((6, 7, 3), value, np.uint8))


def test_pass(pytester):
    reference(pytester)
    run(pytester).assert_outcomes(passed=1)
    assert not (pytester.path / "golden/failed").exists()


def test_fail(pytester):
    reference(pytester)
    result = run(pytester, change="picture[2, 3] = 0")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*GoldenError: grey: number of pixels that differ is 1, more than 0 (max_pixels)*",
                                 "*largest difference 100*FLIP*", "*pytest --shd-update*"])
    result.stdout.no_fnmatch_line("*store.py*raise GoldenError*")  # the traceback ends in the test
    assert golden.load(pytester.path / "golden/failed/grey.difference.png").shape == (6, 7 * 3 + 8, 3)
    assert golden.load(pytester.path / "golden/grey.png").min() == 100


def test_tolerance(pytester):
    reference(pytester)
    run(pytester, change="picture[2, 3] = 0", tolerance=", max_flip=0.9").assert_outcomes(passed=1)
    run(pytester, change="picture[2, 3] = 0", tolerance=", max_flip=0.01").assert_outcomes(failed=1)


def test_missing_reference(pytester):
    result = run(pytester)
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*there is no reference *golden/grey.png*"])
    assert not (pytester.path / "golden/grey.png").exists()


def test_update(pytester):
    reference(pytester, 7)
    run(pytester).assert_outcomes(failed=1)
    run(pytester, "--shd-update").assert_outcomes(passed=1)
    assert golden.load(pytester.path / "golden/grey.png").max() == 100
    assert not (pytester.path / "golden/failed/grey.result.png").exists()
    run(pytester).assert_outcomes(passed=1)


def test_wrong_shape(pytester):
    reference(pytester)
    result = run(pytester, change="picture = picture[:5]", tolerance=", max_flip=1")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*GoldenError: grey: the shape is (5, 7, 3), and that of the reference is (6, 7, 3)*"])


def test_not_a_number(pytester):
    reference(pytester)
    result = run(pytester, "--shd-update", change="picture = np.full((6, 7, 3), np.nan)")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*PictureError: picture: 126 values are NaN or infinite, the first at *0, 0, 0*"])
    assert golden.load(pytester.path / "golden/grey.png").max() == 100


def test_hash(pytester):
    text = TEST.replace('golden.check(picture, "grey"{tolerance})', 'golden.check_hash(picture, "grey")')
    run(pytester, text=text).assert_outcomes(failed=1)
    run(pytester, "--shd-update", text=text).assert_outcomes(passed=1)
    run(pytester, text=text).assert_outcomes(passed=1)
    run(pytester, text=text, change="picture[0, 0, 0] = 1").assert_outcomes(failed=1)


def test_folders(pytester):
    pytester.makeini("[pytest]\nshd_golden = pictures/here\n")
    run(pytester, "--shd-update").assert_outcomes(passed=1)
    assert (pytester.path / "pictures/here/grey.png").exists()
    run(pytester, "--shd-failed", "results", change="picture[0] = 0").assert_outcomes(failed=1)
    assert (pytester.path / "results/grey.difference.png").exists()


def test_libshd_is_loaded_by_the_fixture_only(pytester):
    pytester.makepyfile(test_other="import sys\ndef test_other():\n    assert 'shd' not in sys.modules\n")
    pytester.runpytest_subprocess("-p", "shd_pytest", "-p", "no:cacheprovider").assert_outcomes(passed=1)
