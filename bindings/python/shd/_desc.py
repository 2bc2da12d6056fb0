# SPDX-License-Identifier: MIT
"""Descs: options of a call as keyword arguments. A desc holds Python values and becomes a struct of C at the call."""
import ctypes
import enum

import numpy as np

from . import _api
from ._convert import convert


class Desc:
    """Base of the descs. Fields that are not given have the library's defaults. Descs can be compared and pickled."""

    _struct = ""
    _fields = {}

    def __init__(self, **values):
        self.__dict__["_values"] = {}
        for name, value in values.items():
            setattr(self, name, value)

    def __setattr__(self, name, value):
        if name not in self._fields or name == "struct_size":
            import difflib  # slow to import, and seldom used
            close = difflib.get_close_matches(name, self._fields, 1)
            hint = f"; did you mean {close[0]}?" if close else ""
            raise TypeError(f"{type(self).__name__} has no field {name}{hint}")
        self._values[name] = value

    def __getattr__(self, name):
        if name in self._values:
            return self._values[name]
        if name not in self._fields:
            raise AttributeError(f"{type(self).__name__} has no field {name}")
        return read_field(self._fields[name], getattr(_api.new(self._struct), name))

    def __dir__(self):
        return [*super().__dir__(), *self._fields]

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{k}={value_text(v)}' for k, v in self._values.items())})"

    def __str__(self):
        """All fields, one a line, with the library's defaults."""
        rows = [(n, getattr(self, n)) for n, f in self._fields.items() if n != "struct_size"
                and (n in self._values or not ("*" in f["type"] or f["type"] in _api.callbacks))]
        return "\n".join([type(self).__name__, *(f"    {name} = {value_text(value)}" for name, value in rows)])

    def __eq__(self, other):
        if type(self) is not type(other) or self._values.keys() != other._values.keys():
            return False
        return all(np.array_equal(v, other._values[k]) if isinstance(v, np.ndarray) else v == other._values[k]
                   for k, v in self._values.items())

    __hash__ = None

    def __reduce__(self):
        return _make, (self._struct, self._values)

    def replace(self, **values):
        """A copy with other values."""
        return type(self)(**{**self._values, **values})

    def build(self, keep):
        """The struct of C. `keep` gets everything that must live as long as the struct is used."""
        made, given = _api.new(self._struct), {}
        for name in sorted(self._values, key=lambda n: "*" in self._fields[n]["type"]):  # lengths before lists
            convert(made, self._fields[name], self._values[name], keep,
                    f"{self._struct.removeprefix('shd_').removesuffix('_desc')}.{name}", given)
        keep.append(made)
        return made


def value_text(value):
    """A value in one line: constants by name, arrays by type and shape."""
    if isinstance(value, np.ndarray) and value.size > 16:
        return f"<{value.dtype} {'x'.join(map(str, value.shape))}>"
    if isinstance(value, enum.Enum):
        return str(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(value_text, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{k}: {value_text(v)}' for k, v in value.items())}}}"
    if isinstance(value, float):
        return f"{value:.9g}"
    return " ".join(repr(value).split())


def _make(struct, values):
    return desc_type(struct)(**values)


def read_field(field, value):
    """A field of a struct as a Python value."""
    if isinstance(value, ctypes.Array):
        return tuple(read_field(field, v) for v in value)
    bits = _api.typedefs.get(field["type"], {}).get("bits_of")
    if bits or field["type"] in _api.enums:
        return _api.enum_type(bits or field["type"])(value)
    if isinstance(value, ctypes.Structure):
        return {f["name"]: read_field(f, getattr(value, f["name"])) for f in _api.structs[field["type"]]["fields"]}
    return value


def read_struct(name, struct):
    """A struct that the library wrote, as a dict without its size."""
    return {f["name"]: read_field(f, getattr(struct, f["name"])) for f in _api.structs[name]["fields"]
            if f["name"] != "struct_size"}


_types = {}


def desc_type(struct):
    """The class of a desc: shd_render_desc -> RenderDesc, shd_draw -> Draw."""
    if struct not in _types:
        entry = _api.structs[struct]
        fields = {f["name"]: f for f in entry["fields"]}
        text = _api.words.python("\n".join(f"    {f['name']}: {' '.join(f.get('doc', '').split())}"
                                           for f in entry["fields"] if f["name"] != "struct_size"))
        _types[struct] = type(_api.camel(struct), (Desc,), {
            "__doc__": f"{_api.words.python(entry['doc'])}\n\nFields:\n{text}", "__module__": __package__, "_struct": struct,
            "_fields": fields})
    return _types[struct]
