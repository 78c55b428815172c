"""Numbers for the library: of lists, tuples or NumPy arrays, checked and copied.

The library is never handed the memory of somebody else's array, so its type, its order
and how long it lives do not matter.
"""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Sequence, Union

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Vector = Union[Sequence[float], NDArray[Any]]
    Matrix = Union[Sequence[Vector], NDArray[Any]]
    Flags = Union[Sequence[bool], NDArray[Any]]
    Doubles = ctypes.Array[ctypes.c_double]


def _is_array(values: object) -> bool:
    return numpy is not None and isinstance(values, numpy.ndarray)


def _of_array(array: Any, shape: str, fits: bool, what: str) -> Doubles:
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{what}: an array of numbers, not of {array.dtype}")
    if not fits:
        raise ValueError(f"{what}: an array of shape {array.shape}, where {shape} is wanted")
    doubles = numpy.ascontiguousarray(array, dtype=numpy.float64)
    return (ctypes.c_double * doubles.size).from_buffer_copy(doubles.tobytes())


def vector(values: Vector, length: int, what: str) -> Doubles:
    """So many numbers."""
    if _is_array(values):
        array: Any = values
        return _of_array(array, f"({length},)", array.shape == (length,), what)
    if isinstance(values, (str, bytes)) or not hasattr(values, "__len__"):
        raise TypeError(f"{what}: a list of {length} numbers, not {values!r}")
    if len(values) != length:
        raise ValueError(f"{what}: {len(values)} numbers, where {length} are wanted")
    try:
        return (ctypes.c_double * length)(*values)
    except TypeError as wrong:
        raise TypeError(f"{what}: {wrong}") from None


def matrix(rows: Matrix, width: int, what: str) -> tuple[Doubles, int]:
    """Rows of so many numbers, one behind the other; and how many rows there are."""
    if _is_array(rows):
        array: Any = rows
        fits = array.ndim == 2 and array.shape[1] == width
        return _of_array(array, f"(n, {width})", fits, what), len(array)
    if isinstance(rows, (str, bytes)) or not hasattr(rows, "__len__"):
        raise TypeError(f"{what}: a list of lists of {width} numbers, not {rows!r}")
    flat: list[float] = []
    for index, row in enumerate(rows):
        flat.extend(vector(row, width, f"{what}[{index}]"))
    return (ctypes.c_double * len(flat))(*flat), len(rows)


def rows_of(numbers: Doubles, width: int, count: int) -> Matrix:
    """So many rows: an array of NumPy, or lists if there is none."""
    if numpy is not None:
        array: NDArray[Any] = numpy.array(numbers, dtype=numpy.float64)
        return array.reshape(count, width)
    flat = list(numbers)
    return [flat[at : at + width] for at in range(0, width * count, width)] if width else [
        [] for _ in range(count)
    ]


def flags_of(flags: list[bool]) -> Flags:
    """Truth values, one a row: an array of NumPy, or a list if there is none."""
    return numpy.array(flags, dtype=bool) if numpy is not None else flags


def outcome_of(value: Any) -> int:
    """An outcome as the library takes it: of a bool or of a whole number."""
    if getattr(getattr(value, "dtype", None), "kind", "") == "b":
        value = bool(value)
    if isinstance(value, float) or not hasattr(value, "__index__"):
        raise TypeError(
            f"an outcome is a bool (whether it worked), UNKNOWN or -k if step k failed, not {value!r}"
        )
    number = value.__index__()
    if not -(2**31) <= number < 2**31:
        raise ValueError(f"{number} is no outcome: 1 worked, 0 failed, -k step k failed, 2 unknown")
    return int(number)
