# SPDX-License-Identifier: MIT
"""Batches: structs with a count and columns of that length, from arrays whose last axis has the components."""
import numpy as np

from . import _api
from ._array import batch
from ._convert import COLUMNS, column, columns

_layouts = {}


def layout(struct):
    """The columns of a struct: name -> (type of C, number of components or 0 for a single column)."""
    if struct not in _layouts:
        _layouts[struct] = {f["name"]: (f["type"], f.get("array", [0])[0]) for f in _api.structs[struct]["fields"]
                            if f["type"] in COLUMNS}
    return _layouts[struct]


def shape_of(value, name):
    """The shape of a batch of points with several components, such as positions: the axes before the last one."""
    made = batch(value, name)
    if isinstance(made, np.ndarray) and made.ndim > 1:
        return made.shape[:-1]
    if (isinstance(made, np.ndarray) and not made.ndim) or not len(made):
        raise TypeError(f"{name}: an array [count][components] or a list of columns, not {type(value).__name__}")
    return np.shape(made[0]) or (1,)


def _parts(value, width, name, writable=False):
    """The columns of a value with their names."""
    if not width:
        return [(name, value)]
    parts = columns(value, width, name, writable)
    if len(parts) != width:
        raise ValueError(f"{name}: {len(parts)} columns, not {width}")
    return [(f"{name}[{i}]", part) for i, part in enumerate(parts)]


def _targets(made, name, width):
    return list(getattr(made, name)) if width else [getattr(made, name)]


def same_length(sizes, what):
    """The length that all columns have."""
    if len(set(sizes.values())) > 1:
        raise ValueError(f"{what}: the columns have different lengths: " +
                         ", ".join(f"{k} {n}" for k, n in sizes.items()))
    return next(iter(sizes.values()), 0)


def inputs(struct, values, keep):
    """A struct of input columns of one length. Values that are None are absent."""
    made, sizes, known = _api.new(struct), {}, layout(struct)
    what = struct.removeprefix("shd_")
    for name, value in values.items():
        if name not in known:
            raise TypeError(f"{what} has no column {name}; there are {', '.join(known)}")
        if value is not None:
            kind, width = known[name]
            for target, (label, part) in zip(_targets(made, name, width), _parts(value, width, name)):
                target.data, target.stride, sizes[label] = column(part, *COLUMNS[kind], label, keep)
    made.count = same_length(sizes, what)
    return made


def _allocate(dtype, width, shape):
    """An array and its columns. Each column is packed, because kernels write packed columns fastest."""
    if not width:
        array = np.empty(shape, dtype)
        return array, [array.reshape(-1)]
    planes = np.empty((width, *shape), dtype)
    return np.moveaxis(planes, 0, -1), list(planes.reshape(width, -1))


def outputs(struct, names, shape, keep, out=None):
    """A struct of output columns, and the arrays behind them: those of `out`, or new ones of the shape of the batch."""
    made, arrays, known = _api.new(struct), [], layout(struct)
    count = int(np.prod(shape, dtype=np.int64))
    given = (out,) if isinstance(names, str) else (None,) * len(names) if out is None else tuple(out)
    names = (names,) if isinstance(names, str) else tuple(names)
    if len(given) != len(names):
        raise ValueError(f"out: {len(given)} arrays for {len(names)} outputs")
    for name, array in zip(names, given):
        if name not in known:
            raise ValueError(f"outputs: {name!r} is none of {', '.join(known)}")
        kind, width = known[name]
        if array is None:
            array, parts = _allocate(COLUMNS[kind][0], width, shape)
        else:
            parts = [part for _, part in _parts(array, width, "out", True)]
        for target, part in zip(_targets(made, name, width), parts):
            if part is not None:
                target.data, target.stride, size = column(part, *COLUMNS[kind], f"out ({name})", keep)
                if size != count:
                    raise ValueError(f"out ({name}): {size} rows, not {count}")
        arrays.append(array)
    return made, arrays


def answer(names, arrays):
    """The result of a function with outputs: an array for one name, else a tuple."""
    return arrays[0] if isinstance(names, str) else tuple(arrays)
