#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""House rules that a compiler does not see, over the tracked sources of the tree.

    check_style.py includes|third_party|files|contracts|mutants|arithmetic|spdx|prose|abi_names|abi_structs [--root DIR]

Each check prints file:line and what is wrong, and exits 1 if anything is.
"""
import argparse
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import mutants
import prose

CONTRIBUTING = ".github/CONTRIBUTING.md"
SOURCE_SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".inc", ".py", ".sh", ".cmake"}
SOURCE_FOLDERS = ["include", "src", "tests", "bench", "docs", "examples", "bindings"]
DATA_FOLDERS = {"golden", "corpus"}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]')
THIRD_PARTY = {
    "OpenColorIO/": {"src/color/ocio_transform.h"},
    "OpenImageIO/": {"src/io/oiio/oiio.cpp", "src/io/oiio/encode.cpp", "src/io/oiio/handle.h", "src/io/oiio/tiles.cpp",
                     "src/io/maketx/decoder.cpp", "src/io/maketx/main.cpp", "src/io/maketx/pyramid.cpp", "src/io/maketx/source.h", "src/io/maketx/stats.cpp",
                     "src/io/maketx/stats.h", "src/io/maketx/target.cpp",
                     "src/io/maketx/target.h"},
    "png.h": {"src/io/small/png.cpp"},
    "jpeglib.h": {"src/io/small/jpeg.cpp"},
    "openvdb/": {"src/io/vdb/vdb.cpp"},
    "zstd": {"src/io/container/inflate.cpp"},
    "zlib.h": {"src/io/container/inflate.cpp"},
    "astcenc.h": {"src/io/container/astc.cpp"},
    "Eigen/": {"src/polygon/sparse_solver.cpp"},
    "embree3/": {"src/embree/tree.cpp"},
    "embree4/": {"src/embree/tree.cpp"},
    "CLI/": {"src/command/parse.cpp"},
    "nlohmann/": {"src/scene/read/gltf_part.h"},
    "draco/": {"src/scene/read/gltf_draco.cpp"},
    "meshoptimizer.h": {"src/scene/read/gltf_meshopt.cpp"},
    "assimp/": {"src/scene/read/assimp_files.cpp", "src/scene/read/assimp_import.cpp", "src/scene/read/assimp_light.cpp",
                "src/scene/read/assimp_parts.h", "src/scene/read/assimp_sanitize.cpp", "src/scene/read/assimp_surface.cpp"},
}
# Calls that open files by a path, and the files that may have them. core/regular_file.h opens all files that are read,
# write_file.cpp opens its temporary files, the worker reads /proc, and decoders that need a path get an anonymous file
# (memory_file.h) or a file system of shd (assimp_files.cpp). maketx/ has files of its own.
OPENERS = {
    r"(?<![\w>])::(?:open|openat|creat)\s*\(|(?<![\w.>:])open(?:at)?\s*\([^;{]*\bO_(?:RDONLY|WRONLY|RDWR)\b":
        {"src/core/regular_file.h", "src/io/file/write_file.cpp"},
    r"\bf(?:re)?open\s*\(": {"src/io/server/confine.cpp", "src/io/server/main.cpp", "src/tool/check/report_file.cpp"},
    r"\b(?:basic_)?(?:[io]?fstream|filebuf)\b": set(),
    r"\bImage(?:Input|Output|Buf|Cache)::open\s*\(|\bImageBuf\s+\w+\s*\(": {"src/io/oiio/oiio.cpp", "src/io/oiio/tiles.cpp"},
    r"\bio::(?:File|Archive)\b": {"src/io/vdb/vdb.cpp"},
    r"\bReadFile\s*\(": {"src/scene/read/assimp_import.cpp"},
    r"\bCreateFrom(?:File|Env)\s*\(": set(),
    r"\bdlopen\s*\(": {"src/io/file/module.cpp", "src/io/oiio/silence.cpp", "src/io/server/module.cpp",
                         "src/scene/reading.cpp"},
}
OPENERS_OF_THEIR_OWN = "src/io/maketx/"
FORBIDDEN_CALLS = re.compile(
    r"\b(MulAdd|MulSub|NegMulAdd|NegMulSub|MulAddSub|ApproximateReciprocal\w*|fma|fmaf|ffast-math)\b")
UNSIGNED_ZEROS = re.compile(r"\bhn::(?:Floor|Ceil|Round|Trunc)\s*\(")


def sources(root, folders, suffixes):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            relative = path.relative_to(root)
            if path.is_file() and path.suffix in suffixes and not DATA_FOLDERS & set(relative.parts):
                yield relative


def numbered_lines(root, path):
    return enumerate((root / path).read_text(encoding="utf-8").splitlines(), start=1)


def stages_of(root):
    """The stages in the order of the data flow: the first lines of backticked names in CONTRIBUTING.md."""
    text = (root / CONTRIBUTING).read_text(encoding="utf-8")
    return re.search(r"^`((?:\w+\s+)+\w+)`$", text, re.MULTILINE).group(1).split(), text


def rooms_of(root, stage):
    """The rooms of a stage in their order: the line after "Rooms," in the contract of the stage. Empty if it has none."""
    contract = root / "src" / stage / f"{stage}.h"
    match = contract.exists() and re.search(r"^/// Rooms,.*\n/// ([a-z ]+)$", contract.read_text(encoding="utf-8"), re.MULTILINE)
    return match.group(1).split() if match else []


def check_rooms(root, stage, rooms):
    """Files of a stage with rooms include their own room, earlier rooms and the files beside the contract."""
    for path in sources(root, [f"src/{stage}"], {".cpp", ".h"}):
        room = path.parts[2] if len(path.parts) > 3 else None
        if room is not None and room not in rooms:
            yield f"{path}: {room} is not a room of src/{stage}/{stage}.h"
            continue
        own = rooms.index(room) if room else -1
        for number, line in numbered_lines(root, path):
            match = INCLUDE.match(line)
            parts = match.group(2).split("/") if match and match.group(1) == '"' else []
            if len(parts) < 3 or parts[0] != stage:
                continue
            if parts[1] not in rooms or rooms.index(parts[1]) > own:
                yield f"{path}:{number}: {room or stage} includes {parts[1]}, a later room"
    for room in rooms:
        if not (root / "src" / stage / room).is_dir():
            yield f"src/{stage}/{stage}.h: no folder {room}"


def check_includes(root):
    """Includes in src/ name a stage, and point to the same stage or to an earlier one. Every folder is a stage with a
    row in the table of the tree, and every stage is a folder."""
    stages, text = stages_of(root)
    for stage in stages:
        if not (root / "src" / stage).is_dir():
            yield f"{CONTRIBUTING}: no folder src/{stage}"
        if f"`src/{stage}/`" not in text:
            yield f"{CONTRIBUTING}: no row of src/{stage}/ in the table of the tree"
    for stage in stages:
        yield from check_rooms(root, stage, rooms) if (rooms := rooms_of(root, stage)) else ()
    for path in sources(root, ["src"], {".cpp", ".h"}):
        if path.parts[1] not in stages:
            yield f"{path}: folder is not a stage of {CONTRIBUTING}"
            continue
        own = stages.index(path.parts[1])
        for number, line in numbered_lines(root, path):
            match = INCLUDE.match(line)
            if not match or match.group(1) == "<":
                continue
            stage = match.group(2).split("/")[0]
            if stage not in stages:
                yield f"{path}:{number}: \"{match.group(2)}\" does not begin with a stage"
            elif stages.index(stage) > own:
                yield f"{path}:{number}: {path.parts[1]} includes {stage}, a later stage"


def check_third_party(root):
    """Headers of other libraries stay in the files that are named. Peers of the benchmarks have their own folder."""
    for path in sources(root, ["src", "include"], {".cpp", ".h"}):
        for number, line in numbered_lines(root, path):
            match = INCLUDE.match(line)
            if not match:
                continue
            for prefix, allowed in THIRD_PARTY.items():
                if match.group(2).startswith(prefix) and str(path) not in allowed:
                    yield f"{path}:{number}: {match.group(2)} belongs in {', '.join(sorted(allowed))}"


def check_files(root):
    """Files are opened in one place, which refuses everything except regular files."""
    used = set()
    for path in sources(root, ["src"], {".c", ".cpp", ".h"}):
        if str(path).startswith(OPENERS_OF_THEIR_OWN):
            continue
        code = re.sub(r"//[^\n]*", "", (root / path).read_text(encoding="utf-8"))
        for pattern, allowed in OPENERS.items():
            for match in re.finditer(pattern, code):
                used.add((pattern, str(path)))
                if str(path) not in allowed:
                    number = code.count("\n", 0, match.start()) + 1
                    call = " ".join(match.group(0).split())
                    yield f"{path}:{number}: {call}: files are opened by core/regular_file.h"
    for pattern, allowed in OPENERS.items():
        for path in sorted(allowed):
            if (pattern, path) not in used:
                yield f"{path}: is listed in OPENERS for {pattern}, which it does not use"


CONTRACT_ROW = re.compile(r"^/// \| ([^|]*?) +\|", re.M)


def check_contracts(root):
    """The tables of a contract name files that exist, and every header beside the contract."""
    for path in sources(root, ["src"], {".h"}):
        head = (root / path).read_text(encoding="utf-8").split("#pragma once")[0]
        if "Stage contract" not in head:
            continue
        folder, found = (root / path).parent, {root / path}
        for name in (name for row in CONTRACT_ROW.findall(head) for name in row.split(", ")):
            if "." not in name and not name.endswith("/"):
                continue
            files = list(folder.glob(re.sub("<.*?>", "*", name)))
            found.update(files)
            if not files:
                yield f"{path}: {name} does not exist"
        for header in sorted(set(folder.glob("*.h")) - found):
            yield f"{path}: {header.name} is in no row"


def check_arithmetic(root):
    """No fused or approximate operation and no rounding of Highway in src/: the bits differ between targets."""
    for path in sources(root, ["src"], {".cpp", ".h"}):
        for number, line in numbered_lines(root, path):
            code = line.split("//")[0]
            match = FORBIDDEN_CALLS.search(code)
            if match:
                yield f"{path}:{number}: {match.group(1)} rounds differently on different targets"
            if path.as_posix() != "src/simd/round-inl.h" and UNSIGNED_ZEROS.search(code):
                yield f"{path}:{number}: loses the sign of a zero on some targets; use simd/round-inl.h"


def check_spdx(root):
    """Every source says its licence in the first three lines."""
    folders = [p for p in root.iterdir() if p.is_dir() and not p.name.startswith("build")]
    lists = [p.relative_to(root) for p in [root / "CMakeLists.txt", *(q for f in folders for q in f.rglob("CMakeLists.txt"))]]
    for path in [*sources(root, SOURCE_FOLDERS, SOURCE_SUFFIXES), *sorted(lists)]:
        head = [line for _, line in numbered_lines(root, path)][:3]
        if not any("SPDX-License-Identifier: MIT" in line for line in head):
            yield f"{path}: no SPDX-License-Identifier in the first three lines"


C_COMMENT = re.compile(r"/\*.*?\*/", re.S)
ENUM = re.compile(r"\benum\s*(\w*)\s*\{([^}]*)\}\s*(\w*)\s*;", re.S)
PUBLIC_STRUCT = re.compile(r"(/\*\*(?:(?!\*/).)*\*/\s*)typedef struct (\w+) \{(.*?)\n\} \2;", re.S)
# Results are the words that every program writes: SHD_OK and SHD_ERROR_<VALUE>.
RESULT = "shd_result"
FLAG_SUFFIXES = ("_flag", "_target")


def public_headers(root):
    for path in sources(root, ["include"], {".h"}):
        yield path, (root / path).read_text(encoding="utf-8")


def check_enum(path, name, body, text):
    """Constants of one enum: SHD_<NOUN>_<VALUE> with explicit values, and a MAX_ENUM at the end."""
    noun = next((name[:-len(s)] for s in FLAG_SUFFIXES if name.endswith(s)), name)
    constants = [c.strip() for c in body.split(",") if c.strip()]
    names = [c.split("=")[0].strip() for c in constants]
    for constant in names:
        is_result = name == RESULT and (constant == "SHD_OK" or constant.startswith("SHD_ERROR_"))
        if not constant.startswith(f"{noun.upper()}_") and not is_result:
            yield f"{path}: {constant} of {name} does not begin with {noun.upper()}_"
    for constant in constants:
        if "=" not in constant:
            yield f"{path}: {constant} of {name} has no value"
    if names[-1] != f"{name.upper()}_MAX_ENUM":
        yield f"{path}: {name} does not end with {name.upper()}_MAX_ENUM"
    if name.endswith("_flag") and f"typedef uint32_t {name}s;" not in text:
        yield f"{path}: no typedef uint32_t {name}s"


NAMES_OF = re.compile(r"#define SHD_NAMES_OF_(\w+)\(NAME\)((?:[^\n]*\\\n)+[^\n]*)")


def check_enum_names(root):
    """The table of names has every constant of its enums, each with its name in lower case."""
    table = (root / "src/core/enum_names.h").read_text(encoding="utf-8")
    enums = {name: body for _, text in public_headers(root) for _, body, name in ENUM.findall(C_COMMENT.sub("", text))}
    for noun, rows in NAMES_OF.findall(table):
        name = f"shd_{noun.lower()}"
        prefix = next((name[:-len(s)] for s in FLAG_SUFFIXES if name.endswith(s)), name).upper() + "_"
        constants = re.findall(r"\bSHD_\w+(?=\s*=)", enums.get(name, ""))
        wanted = [(c, c.removeprefix(prefix).lower()) for c in constants if not c.endswith("_MAX_ENUM")]
        if re.findall(r'NAME\((\w+), "(\w+)"\)', rows) != wanted:
            yield f"src/core/enum_names.h: SHD_NAMES_OF_{noun} does not have the constants of {name} in their order"


def check_abi_names(root):
    """Constants of the public headers bear the names of their enums, words of flags have a type of their own, and the
    table of names is complete."""
    owners = {}
    yield from check_enum_names(root)
    for path, text in public_headers(root):
        code = C_COMMENT.sub("", text)
        for tag, body, name in ENUM.findall(code):
            if not name or tag != name:
                yield f"{path}: an enum without a name"
                continue
            yield from check_enum(path, name, body, code)
            for constant in re.findall(r"\bSHD_\w+(?=\s*=)", body):
                if owners.setdefault(constant, name) != name:
                    yield f"{path}: {constant} belongs to {owners[constant]} and {name}"
        for number, line in numbered_lines(root, path):
            if re.search(r"^\s+uint32_t \w+;.*\bshd_\w+ bits", line):
                yield f"{path}:{number}: a word of flags that is not of a type shd_<noun>_flags"


ROW = re.compile(r"^ +ROW\((\w+), (shd_\w+), (\w+), (\w+), (\d+)\)", re.M)
END_OF_FIRST = "/* ---- end of 0.1; append below ---- */"
LAST_FIELD = re.compile(r"(?:\(\*(\w+)\)\([^;]*\)|(\w+)(?:\[\w+\])*);\s*$")


def check_row(path, name, body, rows):
    """The row of a sized struct in the table: its kind is its name, and its last field the last before the marker."""
    if name not in rows:
        yield f"{path}: {name} has no row in src/core/sized_structs.h"
        return
    kind, last = rows[name]
    fields = C_COMMENT.sub("", body.split(END_OF_FIRST)[0])
    match = LAST_FIELD.search(fields)
    if last != (match.group(1) or match.group(2)):
        yield f"{path}: the last field of {name} in 0.1 is {match.group(1) or match.group(2)}, in its row {last}"
    if kind != name.removeprefix("shd_").upper():
        yield f"{path}: the kind of {name} is SHD_DESC_KIND_{kind}"


def check_kinds(root, rows):
    """The kinds are those of the rows, in order, and leave out no number."""
    text = (root / "include/shd/desc.h").read_text(encoding="utf-8")
    kinds = re.findall(r"SHD_DESC_KIND_(\w+) = (\d+),", text)
    wanted = [("NONE", "0"), *((kind, str(i)) for i, (kind, _) in enumerate(rows.values(), start=1))]
    for kind in sorted(set(kinds) ^ set(wanted)):
        yield f"SHD_DESC_KIND_{kind[0]} = {kind[1]} is in " + ("desc.h alone" if kind in kinds else "the table alone")


def check_struct(path, comment, name, body, text, rows):
    """One public struct: sized with defaults and a row in the table, or frozen and says so."""
    fields = [" ".join(f.split()) for f in C_COMMENT.sub("", body).split(";") if f.strip()]
    is_sized = fields[0] == "uint32_t struct_size"
    says_so = re.search(r"\b(Frozen|Grows with)\b", comment)
    if is_sized == bool(says_so):
        fault = "struct_size, but is called frozen" if is_sized else "no struct_size, but is not called frozen"
        yield f"{path}: {name} has {fault}"
    if is_sized and END_OF_FIRST not in body:
        yield f"{path}: {name} does not mark where fields are appended"
    is_callback = "size of the library's struct" in body
    if is_sized and not is_callback and f"static inline {name} {name}_default(" not in text:
        yield f"{path}: no {name}_default()"
    if is_sized and not is_callback:
        yield from check_row(path, name, body, rows)
    elif name in rows:
        yield f"{path}: {name} has a row in src/core/sized_structs.h"
    for field in fields:
        if re.search(r"\breserved\w*$", field):
            yield f"{path}: {name}.{field.split()[-1]}"


def check_abi_structs(root):
    """Public structs grow or are frozen, none keeps a place free, and none goes by value but out of inline functions."""
    table = (root / "src/core/sized_structs.h").read_text(encoding="utf-8")
    rows = {name: (kind, last) for kind, name, _, last, _ in ROW.findall(table)}
    yield from check_kinds(root, rows)
    texts = list(public_headers(root))
    structs = {m.group(2) for _, text in texts for m in PUBLIC_STRUCT.finditer(text)}
    for path, text in texts:
        code = C_COMMENT.sub("", text)
        for match in re.finditer(r"typedef struct (\w+) \{", code):
            if match.group(1) not in structs:
                yield f"{path}: {match.group(1)} has no comment"
        for match in PUBLIC_STRUCT.finditer(text):
            yield from check_struct(path, *match.groups(), text, rows)
        for declaration in re.findall(r"SHD_API\b([^;]*);", code):
            for name in re.findall(r"\b(shd_\w+)\b(?! *\*| *const *\*)", declaration):
                if name in structs:
                    yield f"{path}: {name} by value: {' '.join(declaration.split())}"


def check_mutants(root):
    """The text that a planted bug replaces occurs once in its file."""
    for name, mutant in mutants.MUTANTS.items():
        path = root / mutant.path
        times = path.read_text().count(mutant.text) if path.is_file() else 0
        if times != 1:
            yield f"tests/support/mutants.py: {name}: {mutant.path} has the text {times} times, not once"


CHECKS = {
    "abi_names": check_abi_names,
    "abi_structs": check_abi_structs,
    "includes": check_includes,
    "third_party": check_third_party,
    "arithmetic": check_arithmetic,
    "files": check_files,
    "contracts": check_contracts,
    "mutants": check_mutants,
    "spdx": check_spdx,
    "prose": prose.check,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("check", choices=sorted(CHECKS))
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    arguments = parser.parse_args()
    problems = list(CHECKS[arguments.check](arguments.root))
    for problem in problems:
        print(problem)
    print(f"style.{arguments.check}: {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
