# SPDX-License-Identifier: MIT
"""Python values to fields of structs. Arrays that fit are not copied; other arrays of numbers are converted once."""
import ctypes
import os
import re

import numpy as np

from . import _api
from ._array import array_of, batch, converted
from ._callback import Callback, hook

COLUMNS = {f"shd_{kind}_{way}": (np.dtype(dtype), way == "out") for kind, dtype in
           (("f32", "f4"), ("u32", "u4"), ("u16", "u2")) for way in ("in", "out")}
ELEMENTS = {"float": "f4", "double": "f8", "uint8_t": "u1", "uint16_t": "u2", "uint32_t": "u4", "int32_t": "i4"}


def text_bytes(value, name):
    """A text, a path or None as the bytes of a string of C."""
    if value is None:
        return None
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{name}: a text, not {type(value).__name__}")
    raw = value if isinstance(value, bytes) else os.fsencode(value)
    if b"\0" in raw:
        raise ValueError(f"{name}: {value!r} has a null character")
    return raw


def is_bytes(value):
    """Whether a value is the contents of a file, not its path."""
    return isinstance(value, (bytes, bytearray, memoryview, np.ndarray))


def address(array):
    return array.__array_interface__["data"][0]


def column(array, dtype, writable, name, keep, in_place=False):
    """Address, stride and length of a column, as an array has them. Columns that the library only reads are converted,
    unless they must be read in place."""
    if not isinstance(array, np.ndarray) or array.dtype != dtype or array.ndim != 1 or writable:
        array = flat(array, dtype, writable, name, in_place)
    stride, where, size = array.strides[0], address(array), array.size
    if (size > 1 and (stride <= 0 or stride % dtype.itemsize)) or where % dtype.itemsize:
        if writable or in_place:
            check_place(stride, where, dtype, name)
        array = array.copy()
        stride, where = array.strides[0], address(array)
    keep.append(array)
    return where, stride if size > 1 else 0, size


def flat(array, dtype, writable, name, in_place):
    """An array of one axis with numbers of a type. It has the memory of the given one if it must be used in place."""
    if writable and not isinstance(array, np.ndarray):
        raise TypeError(f"{name}: a NumPy array of {dtype}, not {type(array).__name__}")
    if not (writable or in_place):
        return np.ascontiguousarray(converted(array, dtype, name)).reshape(-1)
    array = shared(array, name)
    if array.dtype != dtype:
        raise TypeError(f"{name}: the array is of {array.dtype}, not {dtype}; .astype(numpy.{dtype}) converts it")
    if writable and not array.flags.writeable:
        raise ValueError(f"{name}: the array is read-only")
    if array.ndim != 1 and not array.flags.c_contiguous:
        raise ValueError(f"{name}: an array of {array.ndim} axes must be contiguous to be a column")
    return array if array.ndim == 1 else array.reshape(-1)


def shared(value, name):
    """The array of an object that has one array for all callers, not a new one for each, as lists have."""
    array = array_of(value, name)
    if array is not value and array.size and address(array) != address(array_of(value, name)):
        raise TypeError(f"{name}: an array that is read in place, not {type(value).__name__}, whose array is a copy")
    return array


def check_place(stride, where, dtype, name):
    """Refuses an array whose memory the library cannot use as it is."""
    if where % dtype.itemsize:
        raise ValueError(f"{name}: the array is not aligned to {dtype.itemsize} bytes")
    raise ValueError(f"{name}: its stride is {stride} bytes, not a positive multiple of {dtype.itemsize}")


def columns(value, count, name, writable=False):
    """Arrays of several columns: a sequence of them, or an array whose last axis has them."""
    value = batch(value, name)
    if isinstance(value, np.ndarray) and value.ndim > 1:
        if value.shape[-1] != count:
            raise ValueError(f"{name}: the last axis has {value.shape[-1]} elements, not {count}")
        if value.ndim > 2:
            if writable and not value.flags.c_contiguous:
                raise ValueError(f"{name}: an array of {value.ndim} axes must be contiguous")
            value = value.reshape(-1, count)
        return [value[:, i] for i in range(count)]
    if isinstance(value, np.ndarray) and not value.ndim:
        raise TypeError(f"{name}: an array [count][{count}] or a list of columns, not a number")
    value = list(value)
    if value and np.ndim(value[0]) == 0 and value[0] is not None:  # a single row
        if len(value) != count:
            raise ValueError(f"{name}: the last axis has {len(value)} elements, not {count}")
        return [np.atleast_1d(v) if isinstance(v, np.generic) else [v] for v in value]
    if len(value) > count:
        raise ValueError(f"{name}: {len(value)} columns, not {count}")
    return value


def set_column(target, kind, value, keep, name):
    if value is not None:
        dtype, writable = COLUMNS[kind]
        target.data, target.stride, _ = column(value, dtype, writable, name, keep)


def enum_value(kind, value, name):
    """A constant of an enum from its name, such as "ewa", or from a number."""
    if not isinstance(value, str):
        return int(value)
    members = _api.enum_type(kind).__members__
    total = 0
    for part in value.split("|"):
        key = part.strip().upper().replace("-", "_")
        key = f"N{key}" if key[:1].isdigit() else key  # as in the names of members
        if key not in members:
            known = ", ".join(re.sub(r"^n(?=\d)", "", m.lower()) for m in members)
            raise ValueError(f"{name}: {part.strip()!r} is none of {known}")
        total |= members[key]
    return total


def numbers(value, field, name):
    """Numbers of an array field. Matrices given as [row][column] become columns first."""
    flat = np.asarray(value)
    if flat.ndim == 2 and flat.shape in ((4, 4), (3, 3)) and len(field["array"]) == 1:
        flat = flat.T
    flat = flat.reshape(-1)
    length = int(np.prod(field["array"]))
    if flat.size != length:
        raise ValueError(f"{name}: {flat.size} numbers, not {length}")
    return flat.tolist()


def set_rows(struct, field, value, name, given):
    """Sets the first rows of an array [rows][columns], and their number if the struct has a field for it."""
    rows, (capacity, width), target = np.asarray(value, np.float64), field["array"], getattr(struct, field["name"])
    if rows.ndim != 2 or rows.shape[1] != width or len(rows) > capacity:
        raise ValueError(f"{name}: an array of shape {rows.shape}, not [1..{capacity}][{width}]")
    set_length(struct, field, len(rows), name, given)
    for i, row in enumerate(rows.tolist()):
        target[i][:] = row


def data(value, kind, name, keep):
    """Address of the data of an array or of bytes, for a pointer of a type."""
    base = kind.replace("const", "").replace("*", "").strip()
    if isinstance(value, (bytes, bytearray)):
        value = np.frombuffer(value, np.uint8)
    if kind.startswith("const"):
        array = array_of(value, name) if base == "void" else converted(value, np.dtype(ELEMENTS[base]), name)
        if not array.ndim:
            raise TypeError(f"{name}: an array of numbers or bytes, not {type(value).__name__}")
        value = np.ascontiguousarray(array)
    elif not isinstance(value, np.ndarray):
        raise TypeError(f"{name}: a NumPy array, not {type(value).__name__}")
    elif base in ELEMENTS and value.dtype != ELEMENTS[base]:
        raise TypeError(f"{name}: the array is of {value.dtype}, not {np.dtype(ELEMENTS[base])}")
    elif not value.flags.c_contiguous:
        raise ValueError(f"{name}: the array must be contiguous")
    keep.append(value)
    return address(value)


def set_length(struct, field, count, name, given):
    """Sets the field that has the length of a list; `given` has the lengths so far, by the names of their fields."""
    names = [n for n in field.get("length", [f"{field['name'].removesuffix('s')}_count"]) if not n.isdigit()]
    if not names or not hasattr(struct, names[-1]):
        if count > 1:
            raise ValueError(f"{name}: {count} elements, not 1")
        return
    rows = max(1, getattr(struct, names[0])) if len(names) > 1 else 1
    if count % rows:
        raise ValueError(f"{name}: {count} elements for {rows} {names[0]}")
    if given.setdefault(names[-1], count // rows) != count // rows:
        raise ValueError(f"{name}: {count} elements, not {names[-1]} = {given[names[-1]]}")
    setattr(struct, names[-1], count // rows)


def pointer(struct, field, value, keep, name, given):
    """The address for a field that is a pointer."""
    base = field["type"].replace("const", "").replace("*", "").strip()
    if field["type"].endswith("*const *") and not isinstance(value, (list, tuple)):
        raise TypeError(f"{name}: a list, not {type(value).__name__}")
    is_list = isinstance(value, (list, tuple))
    if field["type"] == "const char *":
        text = ctypes.c_char_p(text_bytes(value, name))
        keep.append(text)
        return ctypes.cast(text, ctypes.c_void_p).value
    if hasattr(value, "handle"):
        return value.handle(base, keep, name)
    if base in _api.handles and not is_list:
        raise TypeError(f"{name}: {type(value).__name__}, not {_api.camel(base)}")
    if base in _api.structs and not is_list:
        set_length(struct, field, 1, name, given)
        return ctypes.addressof(build(base, value, keep, name))
    if base in ELEMENTS or base == "void":
        return numbers_address(struct, field, value, keep, name, given)
    if not is_list:
        raise TypeError(f"{name}: a list, not {type(value).__name__}")
    set_length(struct, field, len(value), name, given)
    array = elements(base, value, keep, name)
    keep.append(array)
    return ctypes.addressof(array) if value else None


def numbers_address(struct, field, value, keep, name, given):
    """The address of numbers. Rows of 16 are matrices, which may be [row][column]."""
    lengths = field.get("length", [])
    if lengths[1:] == ["16"]:
        value = np.asarray(value)
        if value.ndim == 3 and value.shape[1:] == (4, 4):
            value = np.ascontiguousarray(value.transpose(0, 2, 1))
        if value.ndim < 2 or value.size != 16 * len(value):
            raise ValueError(f"{name}: an array of shape {value.shape}, not [count][4][4]")
        set_length(struct, field, len(value), name, given)
    elif lengths and hasattr(struct, lengths[0]) and len(lengths) == 1:
        set_length(struct, field, len(value), name, given)
    return data(value, field["type"], name, keep)


def elements(base, value, keep, name):
    """An array of C from a list of descs, objects, columns, constants or texts."""
    names = [f"{name}[{i}]" for i in range(len(value))]
    if base in COLUMNS:
        array = (_api.struct_type(base) * len(value))()
        for target, item, label in zip(array, value, names):
            set_column(target, base, item, keep, label)
    elif base in _api.structs:
        array = (_api.struct_type(base) * len(value))(*(build(base, v, keep, n) for v, n in zip(value, names)))
    elif base in _api.enums:
        array = (ctypes.c_int32 * len(value))(*(enum_value(base, v, n) for v, n in zip(value, names)))
    elif base == "char":
        array = (ctypes.c_char_p * len(value))(*(text_bytes(v, n) for v, n in zip(value, names)))
    else:
        array = (ctypes.c_void_p * len(value))(*(None if v is None else v.handle(base, keep, n)
                                                 for v, n in zip(value, names)))
    return array


def build(base, value, keep, name):
    """A struct from a desc, a dict of its fields, or an image."""
    if hasattr(value, "build"):
        if value._struct != base:
            raise TypeError(f"{name}: {type(value).__name__}, not {_api.camel(base)}")
        return value.build(keep)
    from ._desc import desc_type
    if base == "shd_image" and not isinstance(value, dict):
        from ._image import image
        return image(value, keep, name)
    value = hook(base, value, name)
    if not isinstance(value, dict):
        raise TypeError(f"{name}: {type(value).__name__}, not {_api.camel(base)} or a dict of its fields")
    return desc_type(base)(**value).build(keep)


def convert(struct, field, value, keep, name, given):
    """Sets a field of a struct. `given` has the lengths of lists by the names of their fields."""
    kind = field["type"]
    if value is None:
        return
    bits = _api.typedefs.get(kind, {}).get("bits_of")
    if kind in COLUMNS and "array" in field:
        parts = columns(value, field["array"][0], name, COLUMNS[kind][1])
        for target, item in zip(getattr(struct, field["name"]), parts):
            set_column(target, kind, item, keep, name)
    elif kind in COLUMNS:
        set_column(getattr(struct, field["name"]), kind, value, keep, name)
    elif kind in _api.callbacks:
        setattr(struct, field["name"], Callback.of(kind, value, keep).address)
    elif "*" in kind:
        setattr(struct, field["name"], pointer(struct, field, value, keep, name, given))
    elif "array" in field and (bits or kind in _api.enums):
        getattr(struct, field["name"])[:] = [enum_value(bits or kind, v, name) for v in value]
    elif "array" in field and len(field["array"]) == 2:
        set_rows(struct, field, value, name, given)
    elif "array" in field:
        getattr(struct, field["name"])[:] = numbers(value, field, name)
    elif kind in _api.structs:
        setattr(struct, field["name"], build(kind, value, keep, name))
    elif bits or kind in _api.enums:
        setattr(struct, field["name"], enum_value(bits or kind, value, name))
    else:
        if given.setdefault(field["name"], value) != value:
            raise ValueError(f"{name}: {value}, but the list has {given[field['name']]} elements")
        try:
            setattr(struct, field["name"], value)
        except TypeError as problem:
            raise TypeError(f"{name}: {problem}") from None
