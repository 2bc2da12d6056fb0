# SPDX-License-Identifier: MIT
"""The C API from shd.json: types, constants and functions, each made when it is first used.

`lib.shd_render(...)` calls C without checks; all pointers are c_void_p. `check()` raises the errors of the library.
"""
import ctypes
import enum
import errno
import json
import os
import pathlib

from ._words import Words, attribute, camel, members

HERE = pathlib.Path(__file__).resolve().parent
NUMBERS = {"float": ctypes.c_float, "double": ctypes.c_double, "size_t": ctypes.c_size_t, "int": ctypes.c_int,
           "char": ctypes.c_char, **{f"{sign}int{bits}_t": getattr(ctypes, f"c_{sign}int{bits}")
                                     for sign in ("", "u") for bits in (8, 16, 32, 64)}}


def _load_description():
    for path in (HERE / "shd.json", HERE.parent.parent / "shd.json"):
        if path.exists():
            return json.loads(path.read_bytes())
    raise ImportError("shd.json is not beside the package")


_table = _load_description()
structs = {e["name"]: e for e in _table["structs"]}
enums = {e["name"]: e for e in _table["enums"]}
typedefs = {e["name"]: e for e in _table["typedefs"]}
handles = {e["name"]: e for e in _table["handles"]}
callbacks = {e["name"]: e for e in _table["callbacks"]}
functions = {e["name"]: e for e in _table["functions"]}
constants = {e["name"]: e["value"] for e in _table["constants"]}


words = Words(enums, {name: camel(name) for name in (*structs, *enums, *handles)})


def value_type(text):
    """The ctypes type of a type of C; every pointer is a c_void_p."""
    text = text.removeprefix("const ")
    if "*" in text or text in callbacks:
        return ctypes.c_void_p
    if text in structs:
        return struct_type(text)
    if text in enums:
        return ctypes.c_int32
    if text in typedefs:
        return value_type(typedefs[text]["type"])
    return None if text == "void" else NUMBERS[text]


_struct_types = {}


def struct_type(name):
    """The ctypes structure of a struct."""
    if name not in _struct_types:
        fields = []
        for field in structs[name]["fields"]:
            kind = value_type(field["type"])
            for length in reversed(field.get("array", [])):
                kind *= length
            fields.append((field["name"], kind))
        _struct_types[name] = type(name, (ctypes.Structure,), {"_fields_": fields})
    return _struct_types[name]


_defaults = {}


def new(name):
    """A struct with the defaults of the library."""
    kind = struct_type(name)
    if name not in _defaults:
        made = kind()
        if "desc_kind" in structs[name]:
            check(lib.shd_desc_init(constant(structs[name]["desc_kind"]), ctypes.addressof(made), ctypes.sizeof(made)))
        _defaults[name] = bytes(made)
    return kind.from_buffer_copy(_defaults[name])


NUMBER_CODES = ("b", "c", "d", "e", "E", "f", "F", "g", "G", "n", "o", "x", "X", "%")  # last characters of formats


class Constant(enum.IntEnum):
    """Base of the enums. Texts of constants are names: str(Filter.EWA) is "Filter.EWA"."""

    def __str__(self):
        return f"{type(self).__name__}.{self.name}"

    def __format__(self, spec):
        return int.__format__(self, spec) if spec[-1:] in NUMBER_CODES else format(str(self), spec)


class Flags(enum.IntFlag):
    """Base of the enums of flags: str(Aov.UV | Aov.NORMAL) is "Aov.UV|NORMAL"."""

    def __str__(self):
        names = [m.name for m in type(self).__members__.values() if m.value and m.value & self.value == m.value]
        return f"{type(self).__name__}.{'|'.join(names) or self.value}"

    __format__ = Constant.__format__


_enum_types = {}


def enum_type(name):
    """The IntEnum of an enum, or the IntFlag of flags: SHD_FILTER_EWA is Filter.EWA."""
    if name not in _enum_types:
        entry = enums[name]
        is_flags = any(t.get("bits_of") == name for t in typedefs.values())
        found = members(entry)
        made = (Flags if is_flags else Constant)(
            camel(name), [(attribute(short), c["value"]) for short, c in found.items()], module=__package__)
        made.__doc__ = "\n".join([words.python(entry.get("doc", "")), "\nNames:", *(
            f"    {short.lower()}: {words.python(' '.join(c.get('doc', '').split()))}".rstrip(": ")
            for short, c in found.items())])
        _enum_types[name] = made
    return _enum_types[name]


def constant(name):
    return next(m["value"] for e in enums.values() for m in e["constants"] if m["name"] == name)


def callback_type(name):
    """The ctypes prototype of a callback. It takes the GIL."""
    entry = callbacks[name]
    return ctypes.CFUNCTYPE(value_type(entry["result"]), *(value_type(p["type"]) for p in entry["parameters"]))


def _candidates(name):
    """Paths and names under which a library may be, best first."""
    given = os.environ.get("SHD_LIBRARY", "")
    recorded = HERE / "_library.txt"
    version = f"{constants['SHD_VERSION_MAJOR']}.{constants['SHD_VERSION_MINOR']}"
    for place in (given, str(HERE), recorded.read_text("utf-8").strip() if recorded.exists() else ""):
        path = pathlib.Path(place)
        folder = path if path.is_dir() else path.parent
        if place and path.is_file() and name == "shd":
            yield str(path)
        if place:
            yield from (str(folder / f) for f in (f"lib{name}.so", f"lib{name}.so.{version}") if (folder / f).exists())
    yield f"lib{name}.so.{version}"
    import ctypes.util  # slow to import, and seldom used
    yield from filter(None, [ctypes.util.find_library(name)])


class Library:
    """The functions of libshd and its components as attributes."""

    def __init__(self):
        self._loaded = {}

    def load(self, name):
        if name not in self._loaded:
            problems = []
            if name == "shd_scene":
                self.load("shd_io")  # which it needs, and which has a name of its own in a wheel
            if not self._loaded and not os.environ.get("SHD_LIBRARY"):
                for needed in sorted(set(HERE.glob("lib*.so.*")) - set(HERE.glob("libshd*"))):  # of a wheel
                    ctypes.CDLL(str(needed))
            for candidate in _candidates(name):
                try:
                    self._loaded[name] = ctypes.CDLL(candidate)
                    break
                except OSError as problem:
                    problems.append(str(problem))
            else:
                place = "its path" if name == "shd" else "the path of libshd; components lie beside it"
                wheel = "Install the wheel shd-color, or set" if name == "shd_color" else "Set"
                raise ImportError(f"lib{name} was not found. {wheel} SHD_LIBRARY to {place}. " + "; ".join(problems))
        return self._loaded[name]

    def __getattr__(self, name):
        entry = functions.get(name)
        if entry is None or "library" not in entry:
            raise AttributeError(f"libshd has no function {name}")
        function = getattr(self.load(entry["library"]), name)
        function.restype = value_type(entry["result"])
        if entry["result"] == "const char *":
            function.restype = ctypes.c_char_p
        function.argtypes = [value_type(p["type"]) for p in entry.get("parameters", [])]
        setattr(self, name, function)
        return function


lib = Library()


class Error(Exception):
    """A call of the library failed. `result` is a Result; the text is that of the library."""

    def __init__(self, result, message):
        super().__init__(message)
        self.result = enum_type("shd_result")(result)

    def __reduce__(self):
        return type(self), (int(self.result), str(self))


class InvalidArgument(Error, ValueError):
    """An argument is out of range: the text names desc, field, value and range."""


class OutOfMemory(Error, MemoryError):
    """An allocation failed."""


class MissingFile(Error, FileNotFoundError):
    """A file does not exist; `filename` is the path of the call."""

    def __init__(self, result, message, path):
        super().__init__(result, message)
        self.errno, self.strerror, self.filename = errno.ENOENT, message, path

    def __str__(self):
        return self.strerror

    def __reduce__(self):
        return type(self), (int(self.result), str(self), self.filename)


NOT_FOUND = constant("SHD_ERROR_NOT_FOUND")


def check(result, path=None):
    """Raises unless the result is SHD_OK. `path` is that of the file which the call reads."""
    if result:
        text = lib.shd_last_error().decode("utf-8", "replace")
        if result == NOT_FOUND and path is not None:
            raise MissingFile(result, text, os.fspath(path))
        raise {1: InvalidArgument, 2: OutOfMemory}.get(result, Error)(result, text)


def _check_version():
    version = lib.shd_version()
    major, minor = version >> 16, version >> 8 & 255
    if (major, minor) != (constants["SHD_VERSION_MAJOR"], constants["SHD_VERSION_MINOR"]):
        raise ImportError(f"libshd is version {major}.{minor}, not {constants['SHD_VERSION_MAJOR']}."
                          f"{constants['SHD_VERSION_MINOR']}")


_check_version()
