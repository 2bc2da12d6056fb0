#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes libshd as one source and one header: shd.cpp and shd_all.h.

    amalgamate.py FOLDER     writes both files into the folder
    amalgamate.py --check    says how many names of different sources clash and are replaced, and writes nothing

README.md of this folder has the commands that compile the files. How shd.cpp keeps the choice of the instruction set
at run time: Highway's foreach_target.h includes it once more for each instruction set. Kernels and the headers of
kernels are therefore one part of the file, which is compiled each time. Plain headers come before it and plain sources
after it; both are compiled once.
"""
import functools
import pathlib
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import cpp_names

ROOT = pathlib.Path(__file__).resolve().parents[2]
SRC = ROOT / "src"
LOCAL = re.compile(r'^[ \t]*#[ \t]*include[ \t]+(?:"([^"]+)"|<(shd/[^>]+)>).*\n', re.M)
SYSTEM = re.compile(r"^#[ \t]*include[ \t]+(<(?!shd/)[^>]+>).*\n", re.M)
HIGHWAY = re.compile(r"^#undef HWY_TARGET_INCLUDE\n|^#define HWY_TARGET_INCLUDE .*\n|^#define SHD_FORMAT_KERNELS\n"
                     r"|^#include <hwy/foreach_target.h>.*\n", re.M)
ONCE = re.compile(r"^#if HWY_ONCE\b[^\n]*\n(.*)^#endif\b[^\n]*\n\Z", re.S | re.M)


@functools.lru_cache(maxsize=None)
def read(path):
    return path.read_text(encoding="utf-8")


def cmake_globs(name):
    """The patterns of a file(GLOB) of src/CMakeLists.txt, so that both builds have the same sources."""
    text = read(SRC / "CMakeLists.txt")
    match = re.search(rf"file\(GLOB {name} CONFIGURE_DEPENDS\s+([^)]*)\)", text)
    return match[1].replace("${include_dir}", str(ROOT / "include")).split()


def library_sources():
    return [path.relative_to(SRC).as_posix() for glob in cmake_globs("shd_sources") for path in sorted(SRC.glob(glob))]


def find(name):
    """The file of an include: a path from include/ or from src/."""
    return ROOT / "include" / name if name.startswith("shd/") else SRC / name


@functools.lru_cache(maxsize=None)
def includes(path):
    return [a or b for a, b in LOCAL.findall(read(path))]


@functools.lru_cache(maxsize=None)
def earlier():
    """For a header, those that must come before it. A list of includes between the marks of clang-format has an order:
    templates of the later ones call overloads of functions that the earlier ones declare."""
    result = {}
    for path in sorted(SRC.rglob("*.h")):
        for part in re.findall(r"// clang-format off\n(.*?)// clang-format on\n", read(path), re.S):
            names = [a or b for a, b in LOCAL.findall(part)]
            for i, name in enumerate(names):
                result.setdefault(name, []).extend(names[:i])
    return result


def closure(names, seen):
    """The headers that are included, each after those that it includes."""
    for name in names:
        if name not in seen:
            seen[name] = None  # first, against cycles; put in its place below
            closure(earlier().get(name, []) + includes(find(name)), seen)
            del seen[name]
            seen[name] = None
    return list(seen)


class Writer:
    """Joins texts. Includes of system headers that were written before are left out."""

    def __init__(self):
        self.parts, self.system = [], set()

    def drop_known(self, match):
        known = match[1] in self.system
        self.system.add(match[1])
        return "" if known else match[0]

    def file(self, name, text):
        text = re.sub(r"^(//|/\*) SPDX-License-Identifier: MIT( \*/)?\n", "", text)
        text = LOCAL.sub("", text.replace("#pragma once\n", ""))
        # Only includes outside #if are known to be there for every build.
        head, mark, rest = text.partition("\n#if")
        text = SYSTEM.sub(self.drop_known, head) + mark + rest
        text = re.sub(r"\n{3,}", "\n\n", text).strip("\n")
        self.parts.append(f"\n/* {name} */\n{text}\n" if text else "")

    def line(self, text):
        self.parts.append(text)

    def text(self):
        return "".join(self.parts)


def notice(comment):
    license_text = "\n".join(f" * {line}".rstrip() for line in read(ROOT / "LICENSE").splitlines())
    version = re.search(r"project\(shd VERSION ([\d.]+)", read(ROOT / "CMakeLists.txt"))[1]
    return f"/* SPDX-License-Identifier: MIT\n *\n * shd {version}. {comment}\n *\n{license_text}\n */\n"


def header():
    """shd_all.h: the C headers of libshd."""
    writer = Writer()
    writer.line(notice("The C headers of libshd in one file, written by src/packaging/amalgamate.py."))
    writer.line("#ifndef SHD_ALL_H\n#define SHD_ALL_H\n")
    for name in public_headers():
        writer.file(name, read(find(name)))
    writer.line("\n#endif /* SHD_ALL_H */\n")
    return writer.text()


def public_headers():
    return [name for name in closure(["shd/shd.h", "shd/extension.h"], {})]


def related(a, b):
    """Whether unqualified names of one namespace can be found from the other one."""
    a, b = ([part for part in path if part != "HWY_NAMESPACE"] for path in (a, b))
    return a[:len(b)] == b[:len(a)]


def clashes(sources, headers):
    """For each source, its own names that another source or header also declares, and their replacements."""
    declared = {name: list(cpp_names.declarations(read(find(name)))) for name in [*sources, *headers]}
    where = {}
    for file, rows in declared.items():
        for namespace, _, name in rows:
            where.setdefault(name, set()).add((file, namespace))
    result = {}
    for file in sources:
        own_headers = set(closure(includes(find(file)), {}))
        public = {name for header_name in own_headers for _, _, name in declared.get(header_name, [])}
        public |= {name for _, internal, name in declared[file] if not internal and name in where
                   and any(other in own_headers for other, _ in where[name])}
        new = {}
        for namespace, _, name in declared[file]:
            others = [other for other, path in where[name] if other != file and related(path, namespace)]
            if others and name not in public:
                new[name] = f"{name}_in_{re.sub('[^0-9A-Za-z]', '_', file[:-len('.cpp')])}"
        result[file] = new
    return result


def split_kernel(text):
    """The part of a kernel file for every instruction set, and the part that is compiled once."""
    match = ONCE.search(text)
    if match:
        return text[:match.start()], match[1]
    if "#if HWY_ONCE" in text:
        raise SystemExit("amalgamate.py: #if HWY_ONCE is not the last part of a file")
    return text, ""


TOP = """
/*
 * Compile with:  g++ -std=c++17 -O2 -ffp-contract=off -fno-math-errno -fvisibility=hidden -I. -c shd.cpp
 *
 * -I names this folder, because <hwy/foreach_target.h> includes this file by name for each instruction set.
 * -ffp-contract=off gives the bits of every other build. Highway's headers are needed (Debian: libhwy-dev), and its
 * library for the link: -lhwy -pthread. The choice of the instruction set at run time is that of libshd:
 *
 *   (nothing)                   the baseline, SSE4, AVX2 and AVX-512; chosen at run time
 *   -DSHD_SIMD_FEW              the baseline and AVX2; chosen at run time
 *   -DHWY_COMPILE_ONLY_STATIC   the best of them that -march=... allows; no choice at run time, and no -lhwy
 *
 * -DSHD_WITH_TBB adds the executor of oneTBB (-ltbb), -DSHD_WITH_EIGEN harmonic coordinates (-isystem of Eigen).
 */
#ifndef SHD_AMALGAMATED
#define SHD_AMALGAMATED
#define SHD_FORMAT_KERNELS
#if !defined(HWY_COMPILE_ONLY_SCALAR) && !defined(HWY_DISABLED_TARGETS)
#ifdef SHD_SIMD_FEW
#define HWY_DISABLED_TARGETS (~(@FEW@))
#else
#define HWY_DISABLED_TARGETS (~(@AUTO@))
#endif
#endif
"""


def simd_targets(name):
    """The targets of a list of ShdTargets.cmake, as an expression."""
    text = read(SRC / "cmake" / "ShdTargets.cmake")
    words = re.search(rf"^set\(shd_simd_{name} (.*?)\)( +#.*)?$", text, re.M)[1]
    return re.sub(r"\$\{shd_simd_(\w+)\}", lambda m: simd_targets(m[1]), words.replace('"', "")).replace(" ", "|")


def source():
    """shd.cpp."""
    sources = library_sources()
    headers = closure([name for file in sources for name in includes(find(file))], {})
    renamed = clashes(sources, headers)
    known = set(public_headers())  # the others hold the sized structs of the components
    plain = [name for name in headers if "-inl.h" not in name and name not in known]
    kernel_headers = [name for name in headers if "-inl.h" in name]
    late = {name for name in plain if any("-inl.h" in inner for inner in closure(includes(find(name)), {}))}
    texts = {file: cpp_names.rename(read(find(file)), renamed[file]) for file in sources}
    kernels = [file for file in sources if "hwy/foreach_target.h" in texts[file]]

    writer = Writer()
    writer.line(notice("The C++ sources of libshd in one file, written by src/packaging/amalgamate.py."))
    writer.line(TOP.replace("@FEW@", simd_targets("few")).replace("@AUTO@", simd_targets("auto")))
    writer.line('#include "shd_all.h"\n')
    for name in plain:
        if name not in late:
            writer.file(name, read(find(name)))
    writer.line("\n#endif /* SHD_AMALGAMATED */\n\n#undef HWY_TARGET_INCLUDE\n#define HWY_TARGET_INCLUDE \"shd.cpp\"\n"
                "#include <hwy/foreach_target.h>\n#include <hwy/highway.h>\n")
    for name in headers:
        if name in kernel_headers or name in late:
            text = read(find(name))
            guard = re.sub("[^A-Z0-9]", "_", f"SHD_{name.upper()}_ONCE")
            if "#pragma once" in text:
                text = f"#ifndef {guard}\n#define {guard}\n{text}\n#endif\n"
            writer.file(name, text)
    once = []
    for file in kernels:
        every, rest = split_kernel(HIGHWAY.sub("", texts[file]))
        writer.file(file, every)
        once.append((file, rest))
    writer.line("\n#if HWY_ONCE\n")
    for file, text in once + [(file, texts[file]) for file in sources if file not in kernels]:
        writer.file(file, text)
    writer.line("\n#endif /* HWY_ONCE */\n")
    return writer.text(), sum(len(new) for new in renamed.values())


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("--") and arguments[0] != "--check":
        print(__doc__)
        return 2
    text, count = source()
    print(f"shd.cpp: {len(text.encode()) / 1e6:.2f} MB; {count} names of single sources replaced")
    if arguments[0] != "--check":
        folder = pathlib.Path(arguments[0])
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "shd.cpp").write_text(text, encoding="utf-8")
        (folder / "shd_all.h").write_text(header(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
