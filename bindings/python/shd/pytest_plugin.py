# SPDX-License-Identifier: MIT
"""pytest -p shd.pytest_plugin: the plugin of shd_pytest without an installation."""
from shd_pytest import golden, pytest_addoption  # noqa: F401
