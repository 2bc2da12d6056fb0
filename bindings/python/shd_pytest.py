# SPDX-License-Identifier: MIT
"""The pytest plugin of shd. pytest imports this module at every start in an environment where shd is installed, so
libshd is loaded by the first test that uses the fixture.

    def test_torus(golden):
        golden.check(picture, "torus", max_flip=0.1)      golden/torus.png beside the test file
        golden.check_hash(picture, "torus")               golden/hashes.txt

--shd-update writes the references. The ini value shd_golden is another name of the folder.
"""
import pytest


def pytest_addoption(parser):
    group = parser.getgroup("shd", "golden tests of pictures")
    group.addoption("--shd-update", action="store_true", help="write the pictures of the tests as their references")
    group.addoption("--shd-failed", metavar="FOLDER", help="folder for results of failed checks (failed/ in the folder "
                                                           "of the references)")
    parser.addini("shd_golden", "folder of the references, beside the test file", default="golden")


@pytest.fixture
def golden(request):
    """The shd.golden.Store of the test file. check() fails with a text; a difference picture lies in failed/."""
    from shd.golden import Store
    folder = request.path.parent / request.config.getini("shd_golden")
    return Store(folder, request.config.getoption("--shd-failed"), request.config.getoption("--shd-update"))
