# SPDX-License-Identifier: MIT
class PkgConfigDeps:
    """The requirements are libraries of the system, which have files of their own."""

    def __init__(self, conanfile):
        self.conanfile = conanfile

    def generate(self):
        pass
