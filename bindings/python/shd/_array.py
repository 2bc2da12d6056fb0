# SPDX-License-Identifier: MIT
"""Objects that hold numbers as NumPy arrays: lists, objects with the array interface or DLPack, buffers, images of
Pillow. Numbers of another type are converted once; numbers that already fit stay where they are."""
import numpy as np

HOST = (1, 3, 11, 13)  # devices of DLPack whose memory the CPU reads: kDLCPU, kDLCUDAHost, kDLROCMHost, kDLCUDAManaged


def array_of(value, name):
    """The array of an object. Its numbers are not copied if the object shares them."""
    if isinstance(value, np.ndarray):
        return value
    has_array = any(hasattr(value, text) for text in ("__array__", "__array_interface__"))
    is_shared = hasattr(value, "__dlpack__") and not has_array
    if is_shared and value.__dlpack_device__()[0] not in HOST:
        raise TypeError(f"{name}: an array in the memory of the CPU, not of device {value.__dlpack_device__()}")
    try:
        made = np.from_dlpack(value) if is_shared else np.asarray(value)
    except (AttributeError, BufferError, RuntimeError, TypeError, ValueError) as problem:
        raise TypeError(f"{name}: an array of numbers, not {type(value).__name__}: {problem}") from None
    if made.dtype.kind not in "fiub":
        raise TypeError(f"{name}: an array of numbers, not {type(value).__name__}")
    return made


def converted(value, dtype, name):
    """The array of an object with numbers of a type. Integers must be in the range of the type."""
    array = array_of(value, name)
    if array.dtype == dtype:
        return array
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name}: the array is of {array.dtype}, not of numbers")
    if dtype.kind == "f":
        return array.astype(dtype)
    if not array.size:
        return np.empty(array.shape, dtype)
    if array.dtype.kind == "f":
        raise TypeError(f"{name}: integers, not {array.dtype}")
    check_range(array, np.iinfo(dtype).max, name)
    return array.astype(dtype)


def check_range(array, highest, name):
    """Refuses integers that are not in 0..highest, and names the first of them. Without vertices `highest` is -1."""
    if array.size and (array.min() < 0 or array.max() > highest):
        flat = array.reshape(-1)
        first = int(np.argmax((flat < 0) | (flat > highest)))
        raise ValueError(f"{name}[{first}]: {flat[first]} is not in 0..{highest}" if highest >= 0 else
                         f"{name}[{first}]: {flat[first]}, but there are no vertices")


def batch(value, name):
    """An array [..., components], or a list of columns. Lists of rows, such as [(0, 0, 1), (1, 0, 0)], are arrays."""
    if isinstance(value, np.ndarray):
        return value
    if isinstance(value, (list, tuple)) and not (len(value) and isinstance(value[0], (list, tuple))):
        return value
    return array_of(value, name)


def pixels_of(image, name):
    """The array of an image. Images of Pillow with palettes, bits or other colours become RGBA."""
    if hasattr(image, "convert") and hasattr(image, "mode"):
        if image.mode.startswith("I"):  # 16 bits a pixel, which convert() would clamp to 8
            return np.asarray(image).astype(np.int64).clip(0, 65535).astype(np.uint16)
        return np.asarray(image if image.mode in ("L", "RGB", "RGBA", "F") else image.convert("RGBA"))
    return array_of(image, name)
