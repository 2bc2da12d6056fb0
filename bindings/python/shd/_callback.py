# SPDX-License-Identifier: MIT
"""Python functions that the library calls: programs, procedures of slots, tiles, progress and log.

A callback runs on a thread of the library and takes the GIL. The caller's thread does not have the GIL during a call of
the library, so workers cannot wait for it. An exception ends no thread: the call that ran the callback raises it.

Arrays of a callback are copies. What the function has written into them goes to the library when it returns, so that
arrays which it keeps never refer to memory of the library. For 64 to 4096 rows, the copy adds 0.3 to 0.5 microseconds to
a column that is read and 0.4 to 0.8 to one that is written.
"""
import ctypes
import threading

import numpy as np

from . import _api
from ._report import Bar, log_writer, reporter

local = threading.local()
VIEWS = {"float": (ctypes.c_float, np.float32), "uint32_t": (ctypes.c_uint32, np.uint32)}
ERROR_CANCELLED, ERROR_CALLBACK = 8, 9
# They have no result: after an exception the rest of the frame is not worth its time.
PROGRAMS = {"shd_fragment_fn", "shd_vertex_fn", "shd_slot_fn"}


def taken(where, kind, count, written):
    """A copy of a column; read-only for types that are const, else `written` gets the column and the copy."""
    if not where:
        return None
    ctype, dtype = VIEWS[kind.replace("const", "").replace("*", "").strip()]
    column = np.frombuffer((ctype * count).from_address(where), dtype) if count else np.empty(0, dtype)
    array = column.copy()
    if kind.startswith("const"):
        array.flags.writeable = False
    else:
        written.append((column, array))
    return array


def pointers(where, count):
    return (ctypes.c_void_p * count).from_address(where) if where and count else ()


class Record:
    """A struct of the library inside a callback, until the callback ends. `written` gets columns that may change."""

    def __init__(self, name, where, written, count=None):
        self._entry = {f["name"]: f for f in _api.structs[name]["fields"]}
        self._struct, self._written = _api.struct_type(name).from_address(where), written
        self._rows = getattr(self._struct, "count", count)

    def __dir__(self):
        return list(self._entry)

    def __getattr__(self, name):
        if name.startswith("_") or name not in self._entry:
            raise AttributeError(f"no column {name}; there are {', '.join(self._entry)}")
        value = self._read(self._entry[name], getattr(self._struct, name))
        self.__dict__[name] = value
        return value

    def _read(self, field, value):
        kind, length = field["type"], field.get("length", [])
        if "*" not in kind or kind.startswith("const void"):
            return value
        if kind.endswith("(*)[4]"):
            rows = pointers(value, 4 * getattr(self._struct, length[0]))
            return [[self._taken(p, "float *") for p in rows[i:i + 4]] for i in range(0, len(rows), 4)]
        if kind.count("*") == 2:
            return [self._taken(p, kind) for p in pointers(value, getattr(self._struct, length[0]))]
        if "array" in field:  # channels of a tile
            return [self._plane(p) for p in value]
        if length and length[0].isdigit():
            array = taken(value, kind, int(length[0]), self._written)
            return array.reshape(4, 4).T if array is not None and array.size == 16 else array
        return self._taken(value, kind)

    def _taken(self, where, kind):
        return taken(where, kind, self._rows, self._written)

    def close(self):
        """Ends the access to the memory of the library."""
        self.__dict__.clear()
        self._entry = {}

    def _plane(self, where):
        stride = self._struct.row_stride // 4
        area = self._struct.area
        rows = taken(where, "const float *", area.height * stride - stride + area.width, None)
        shape = (area.height, area.width)
        return np.lib.stride_tricks.as_strided(rows, shape, (4 * stride, 4), writeable=False)


def record_of(text, where, earlier, written):
    """An argument of a callback as a Python value."""
    base = text.replace("const", "").replace("*", "").strip()
    if base in _api.structs and base != "shd_tile" and text.count("*") == 1 and where:
        return Record(base, where, written, next((r._rows for r in earlier if isinstance(r, Record)), None))
    if text == "float *const *" and where:
        rows = next(r._rows for r in earlier if isinstance(r, Record))
        return [taken(p, "float *", rows, written) for p in pointers(where, 4)]
    if base in VIEWS and text.count("*") == 1:
        return taken(where, text, next(r._rows for r in earlier if isinstance(r, Record)), written)
    if text == "const char *":
        return ctypes.string_at(where).decode("utf-8", "replace") if where else ""
    if text in _api.callbacks:
        return _api.callback_type(text)(where)
    return where


def result_of(returned, result):
    """The number for what a function returned. Functions with a shd_result may return True or None, which go on, False,
    which cancels, or a Result."""
    if result != "shd_result":
        return int(returned or 0)
    if returned is False:
        return ERROR_CANCELLED
    return 0 if returned is None or returned is True else int(returned)


class Callback:
    """A function of Python with the address that the library calls. `failure` is its first exception."""

    def __init__(self, name, function):
        self._function, self._entry, self.failure = function, _api.callbacks[name], None
        self._prototype = _api.callback_type(name)(self._run)
        self.address = ctypes.cast(self._prototype, ctypes.c_void_p).value

    @staticmethod
    def of(name, function, keep):
        """The callback of a function, kept in `keep`."""
        if not callable(function):
            raise TypeError(f"{name}: {type(function).__name__} is not callable")
        made = Callback(name, function)
        keep.append(made)
        return made

    def end(self, failures):
        """Moves the failure of a call to a list, and ends the line of a bar."""
        if isinstance(self._function, Bar):
            self._function.close()
        if self.failure is not None:
            failures.append(self.failure)
            self.failure = None

    def _run(self, *arguments):
        result = self._entry["result"]
        failed = None if result == "void" else ERROR_CALLBACK
        if self.failure is not None and result == "void" and self._entry["name"] in PROGRAMS:
            return failed
        local.depth = getattr(local, "depth", 0) + 1
        values, written = [], []
        try:
            for parameter, argument in zip(self._entry["parameters"], arguments):
                if parameter["name"] != "user_data":
                    values.append(record_of(parameter["type"], argument, values, written))
            returned = self._function(*values)
            for column, array in written:
                column[:] = array
            return None if result == "void" else result_of(returned, result)
        except BaseException as problem:  # the call that ran this raises it
            self.failure = self.failure or problem
            if result == "shd_result":
                _api.lib.shd_report_error(ERROR_CALLBACK, str(problem).encode()[:1000])
            return failed
        finally:
            local.depth -= 1
            for value in values:
                if isinstance(value, Record):
                    value.close()


# Structs with one function, which a value may be itself: (name of the field, its function from a value).
HOOKS = {"shd_log": ("write", log_writer), "shd_progress": ("report", reporter)}


def hook(struct, value, name):
    """The fields of a struct with one function, from a logger, a function or True."""
    if struct not in HOOKS or isinstance(value, dict):
        return value
    field, make = HOOKS[struct]
    return {field: make(value, name)}


def raise_failures(keep):
    """Raises the first exception of a callback among what a call kept, and clears all of them. Ends bars."""
    failures, seen, open_items = [], set(), list(keep)
    while open_items:
        item = open_items.pop()
        if isinstance(item, Callback):
            item.end(failures)
        elif hasattr(item, "keep") and id(item) not in seen:
            seen.add(id(item))
            open_items += item.keep
    if failures:
        raise failures[0]
