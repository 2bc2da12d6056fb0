# SPDX-License-Identifier: MIT
"""audit.py and the reader of ELF files, with small libraries that break one rule each. CC is the C compiler."""
import argparse
import ctypes
import os
import pathlib
import platform
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(PACKAGE), str(PACKAGE / "wheel")]
import audit  # noqa: E402
import component  # noqa: E402
from elf import Elf  # noqa: E402

CC = os.environ.get("CC", "cc")


@unittest.skipUnless(shutil.which(CC), f"no C compiler {CC} (Debian: gcc)")
@unittest.skipUnless(platform.machine() in ("x86_64", "aarch64"), "the reader is for x86_64 and aarch64")
class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def library(self, name, *flags, code="int f(void) { return 7; }", versions=None):
        """A library without the C library; `versions` is the version of its symbols."""
        source, out = self.folder / "source.c", self.folder / name
        source.write_text(code + "\n")
        if versions:
            script = self.folder / "versions"
            script.write_text(f"{versions} {{ global: *; }};\n")
            flags = (*flags, f"-Wl,--version-script={script}")
        subprocess.run([CC, "-shared", "-fPIC", "-nostdlib", "-o", out, source, *flags], check=True)
        return out

    def user_of(self, soname, version=None):
        """A library that needs another one, with one symbol of it."""
        other = self.library("other.so", f"-Wl,-soname,{soname}", versions=version)
        return self.library("user.so", other, code="int f(void); int g(void) { return f(); }")

    def wheel(self, *paths, tag="manylinux_2_28", more=()):
        out = self.folder / f"x-1-py3-none-{tag}_{platform.machine()}.whl"
        with zipfile.ZipFile(out, "w") as wheel:
            for path in paths:
                wheel.write(path, f"shd/{path.name}")
            for name, data in more:
                wheel.writestr(name, data)
        return out

    def audit(self, *paths, tag="manylinux_2_28", libstdcxx=False, more=()):
        options = argparse.Namespace(libstdcxx=libstdcxx, beside=[])
        return audit.audit(self.wheel(*paths, tag=tag, more=more), options)[0]

    def check(self, pattern, *arguments, **values):
        found = self.audit(*arguments, **values)
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], pattern)


class Rules(Case):
    def test_good_libraries(self):
        self.assertEqual(self.audit(self.library("a.so")), [])
        self.assertEqual(self.audit(self.user_of("libc.so.6", "GLIBC_2.28")), [])
        self.assertEqual(self.audit(self.library("a.so", "-Wl,-rpath,$ORIGIN:$ORIGIN/../x.libs")), [])

    def test_a_library_of_the_system(self):
        library = self.user_of("libfoo.so.1")
        self.check("needs libfoo.so.1, which is neither of glibc nor in the wheel", library)

    def test_a_bundled_library_has_its_own_name(self):
        user, other = self.user_of("libfoo.so.1"), self.folder / "other.so"
        self.check("has the name libfoo.so.1, which a library of the system may have", user, other)
        user, other = self.user_of("libfoo-12345"), self.folder / "other.so"
        self.assertEqual(self.audit(user, other), [])

    def test_versions_of_glibc(self):
        library = self.user_of("libc.so.6", "GLIBC_2.34")
        self.check("needs GLIBC_2.34 of libc.so.6, newer than glibc 2.28", library)
        self.assertEqual(self.audit(library, tag="manylinux_2_34"), [])
        self.assertEqual(audit.tag([library]), f"manylinux_2_34_{platform.machine()}")
        self.assertEqual(audit.tag([self.library("a.so")]), f"manylinux_2_28_{platform.machine()}")
        self.check("GLIBC_PRIVATE of libc.so.6, which is private", self.user_of("libc.so.6", "GLIBC_PRIVATE"))

    def test_versions_of_libstdcxx(self):
        library = self.user_of("libstdc++.so.6", "GLIBCXX_3.4.29")
        self.assertEqual(len(self.audit(library)), 2)
        self.check(r"GLIBCXX_3.4.29 of libstdc\+\+.so.6, newer than GLIBCXX_3.4.25", library, libstdcxx=True)
        self.assertEqual(self.audit(library, tag="manylinux_2_34", libstdcxx=True), [])
        self.assertEqual(audit.tag([library]), f"manylinux_2_34_{platform.machine()}")

    def test_folders_outside_the_wheel(self):
        for folder in ("/usr/lib", "lib", "$ORIGIN/../..", "$ORIGINAL", ""):
            with self.subTest(folder=folder):
                self.check("searches .*, which is not a folder of the wheel",
                           self.library("a.so", f"-Wl,-rpath,$ORIGIN:{folder}"))

    def test_flags_and_machines(self):
        self.check("the stack is executable", self.library("a.so", "-Wl,-z,execstack"))
        data = bytearray(self.library("a.so").read_bytes())
        data[18:20] = b"\x28\0"  # 32-bit ARM
        (self.folder / "b.so").write_bytes(data)
        self.check("is for machine 40, and the tag names", self.folder / "b.so")

    def test_wheels(self):
        self.check("the wheel has no library", more=[("shd/a.py", b"")])
        options = argparse.Namespace(libstdcxx=False, beside=[])
        self.assertRegex(audit.audit(pathlib.Path("x-1-py3-none-any.whl"), options)[0][0], "has no tag manylinux_2_N")

    def test_the_program(self):
        run = [sys.executable, str(PACKAGE / "audit.py")]
        good, bad = self.wheel(self.library("a.so")), self.folder / "bad-1-py3-none-linux_x86_64.whl"
        self.assertEqual(subprocess.run([*run, good], stdout=subprocess.DEVNULL).returncode, 0)
        wrong = self.wheel(self.user_of("libfoo.so.1"))
        self.assertEqual(subprocess.run([*run, wrong], stdout=subprocess.DEVNULL).returncode, 1)
        bad.write_bytes(b"no archive")
        self.assertEqual(subprocess.run([*run, bad], stderr=subprocess.DEVNULL).returncode, 2)


class Files(Case):
    def test_names_of_equal_length_are_replaced(self):
        user, other = self.user_of("libfoo.so.1", "FOO_1"), self.folder / "other.so"
        name = component.own_name("libfoo.so.1", other.read_bytes())
        self.assertRegex(name, "libfoo-[0-9a-f]{4}$")
        names = {"libfoo.so.1": name}
        (self.folder / name).write_bytes(Elf(other.read_bytes()).renamed(names))
        user.write_bytes(Elf(user.read_bytes()).renamed(names))
        self.assertEqual(Elf((self.folder / name).read_bytes()).soname, name)
        self.assertEqual(Elf(user.read_bytes()).versions, {(name, "FOO_1")})
        ctypes.CDLL(str(self.folder / name))
        self.assertEqual(ctypes.CDLL(str(user)).g(), 7)  # the loader finds the library under its new name
        with self.assertRaisesRegex(ValueError, "not of equal length"):
            Elf(user.read_bytes()).renamed({"libfoo.so.1": "libfoo"})

    def test_malformed_files(self):
        for data in (b"", b"\x7fELF", b"\x7fELF\2\1" + bytes(10), b"MZ" + bytes(100)):
            self.assertRaises(ValueError, Elf, data)
        seed, choose, refused = self.user_of("libfoo.so.1", "FOO_1").read_bytes(), random.Random(5), 0
        for _ in range(3000):
            data = bytearray(seed[:choose.randrange(1, len(seed))] if choose.random() < 0.2 else seed)
            for _ in range(choose.randrange(1, 20)):
                end = min(len(data), 1024) if choose.random() < 0.5 else len(data)
                data[choose.randrange(end)] = choose.randrange(256)
            try:
                Elf(data)
            except ValueError:
                refused += 1
        self.assertGreater(refused, 500)


class Components(Case):
    def test_wheels_have_their_files_and_records(self):
        out = self.folder / "shd_x-1-py3-none-linux_x86_64.whl"
        files = {"libshd_x.so": b"a", "libx-1f2e": b"b"}
        component.write_wheel(out, "shd_x", files, {"libx": b"licence"}, "1", "summary", "text", "linux_x86_64")
        first = out.read_bytes()
        component.write_wheel(out, "shd_x", files, {"libx": b"licence"}, "1", "summary", "text", "linux_x86_64")
        self.assertEqual(out.read_bytes(), first)
        with zipfile.ZipFile(out) as wheel:
            self.assertIsNone(wheel.testzip())
            self.assertLess({"shd/libshd_x.so", "shd/libx-1f2e"}, set(wheel.namelist()))
            self.assertEqual({entry.external_attr >> 16 for entry in wheel.infolist()}, {0o100644})
            self.assertEqual(wheel.read("shd_x-1.dist-info/licenses/libx.txt"), b"licence")
            record = wheel.read("shd_x-1.dist-info/RECORD").decode()
            self.assertEqual(len(record.splitlines()), len(wheel.namelist()))
            self.assertIn("Requires-Dist: shd (==1)", wheel.read("shd_x-1.dist-info/METADATA").decode())


if __name__ == "__main__":
    unittest.main()
