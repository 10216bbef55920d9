"""The BulkBlock: columns of numbers for the observation plane, as arrays.

`bulk_views` and `bulk_encode` need the standard library only. `bulk_decode` gives numpy arrays.

Columns of a block that is `bytes` are views: nothing is copied, and none can be written to.
Another buffer could change after it was checked, so it is copied, once.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Literal, NamedTuple, Union

from . import _ncp

if TYPE_CHECKING:
    import numpy

__all__ = [
    "Buffer",
    "Column",
    "Values",
    "bulk_decode",
    "bulk_encode",
    "bulk_views",
    "observation_pack",
    "observation_unpack",
    "observation_views",
]

#: The values of a column: a one-dimensional buffer of 32 or 64 bit floats or signed integers, such as a
#: numpy array or an array.array.
Values = Union["numpy.ndarray", "array[float]", "array[int]", memoryview]
#: What may hold a block.
Buffer = Union[bytes, bytearray, memoryview]

#: The dtypes of a block, by the letter of the native type that has their values.
_LETTERS: dict[str, Literal["f", "d", "i", "q"]] = {"f32": "f", "f64": "d", "i32": "i", "i64": "q"}
_DTYPES = {("f", 4): "f32", ("d", 8): "f64"}
_DTYPES.update({(letter, 4): "i32" for letter in "il"})
_DTYPES.update({(letter, 8): "i64" for letter in "lq"})


class Column(NamedTuple):
    """A column of a block, as a view of it."""

    #: `f32`, `f64`, `i32` or `i64`.
    dtype: str
    #: Its values, read-only.
    values: memoryview[float] | memoryview[int]


def bulk_views(block: Buffer) -> dict[str, Column]:
    """The columns of a block by name, in its order, as typed memoryviews.

    Raises NcpError if the block breaks a rule of the format.
    """
    block = _as_bytes(block)
    whole = memoryview(block)
    columns = {}
    for name, dtype, rows, offset in _ncp.bulk_directory(block):
        letter = _LETTERS[dtype]
        size = array(letter).itemsize
        values = whole[offset : offset + rows * size]
        if sys.byteorder == "big":
            swapped = array(letter, values.tobytes())
            swapped.byteswap()
            values = memoryview(swapped.tobytes())
        columns[name] = Column(dtype, values.cast(letter))
    return columns


def bulk_decode(block: Buffer) -> dict[str, numpy.ndarray]:
    """The columns of a block by name, in its order, as read-only numpy arrays.

    An array is a view of the block, unless the column does not lie at a multiple of its values' size;
    then it is copied, since numpy computes slowly on such. Our encoder never writes such a block.
    Raises NcpError if the block breaks a rule of the format, ImportError without numpy.
    """
    import numpy

    block = _as_bytes(block)
    columns = {}
    for name, dtype, rows, offset in _ncp.bulk_directory(block):
        if rows:
            values = numpy.frombuffer(block, _numpy_dtype(dtype), rows, offset)
        else:
            values = numpy.empty(0, _numpy_dtype(dtype))
        if not values.flags.aligned:
            values = values.copy()
        values.flags.writeable = False
        columns[name] = values
    return columns


def bulk_encode(columns: Mapping[str, Values] | Iterable[tuple[str, Values]]) -> bytes:
    """Writes columns, in their order, as one block.

    The type of an array decides on the column's: float32, float64, int32 or int64. Nothing is
    converted, and no count is cut short. Raises NcpError for two equal names and for what is over the
    limits of the format, TypeError for any other array.
    """
    pairs = columns.items() if isinstance(columns, Mapping) else columns
    return _ncp.bulk_encode([(name, *_raw(name, values)) for name, values in pairs])


def observation_pack(times: Values, values: Values, senders: Values) -> bytes:
    """Writes the arrays of an observation as a block: `times` in ms and `values` as float64, `senders` as int64.

    An empty array makes no column. Raises NcpError for two others that differ in length.
    """
    return _ncp.observation_pack(
        _raw_of("times", times, "f64"),
        _raw_of("values", values, "f64"),
        _raw_of("senders", senders, "i64"),
    )


def observation_views(
    block: Buffer,
) -> tuple[memoryview[float], memoryview[float], memoryview[int]]:
    """The arrays of an observation as `observation_unpack` gives them, as typed memoryviews."""
    block = _as_bytes(block)
    _ncp.observation_check(block)
    found = bulk_views(block)
    empty = memoryview(b"")
    return (
        found["times"].values if "times" in found else empty.cast("d"),
        found["values"].values if "values" in found else empty.cast("d"),
        found["senders"].values if "senders" in found else empty.cast("q"),
    )  # type: ignore[return-value]  # their types are among what was checked


def observation_unpack(block: Buffer) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
    """The arrays of an observation, `times`, `values` and `senders`, as `bulk_decode` gives them.

    An absent column is an empty array, other columns are left alone. Raises NcpError if the block is
    none, a column has another type, or two that are not empty differ in length.
    """
    import numpy

    block = _as_bytes(block)
    _ncp.observation_check(block)
    found = bulk_decode(block)
    return (
        found.get("times", numpy.empty(0, _numpy_dtype("f64"))),
        found.get("values", numpy.empty(0, _numpy_dtype("f64"))),
        found.get("senders", numpy.empty(0, _numpy_dtype("i64"))),
    )


def _as_bytes(block: Buffer) -> bytes:
    if type(block) is bytes:
        return block
    if not isinstance(block, (bytes, bytearray, memoryview)):
        raise TypeError(f"a block is bytes, not {type(block).__name__}")
    return bytes(block)


def _numpy_dtype(dtype: str) -> str:
    return "<" + dtype[0] + str(int(dtype[1:]) // 8)


def _raw(name: str, values: Values) -> tuple[str, bytes]:
    """The dtype of an array, and its bytes as they lie in memory."""
    try:
        view = memoryview(values)  # type: ignore[arg-type]
    except (TypeError, ValueError, BufferError) as error:
        raise TypeError(f"{name}: a column is a buffer of numbers: {error}") from None
    native = view.format[1:] if view.format[:1] in _NATIVE else view.format
    dtype = _DTYPES.get((native, view.itemsize))
    if dtype is None or view.ndim != 1:
        raise TypeError(
            f"{name}: a column is one-dimensional, float32, float64, int32 or int64; "
            f"found {view.ndim} dimensions of format {view.format!r}"
        )
    return dtype, view.tobytes()


def _raw_of(name: str, values: Values, dtype: str) -> bytes:
    found, raw = _raw(name, values)
    if raw and found != dtype:
        raise TypeError(f"{name}: expected {dtype}, found {found}")
    return raw


#: What stands before the letter of a native type, or nothing.
_NATIVE = ("@", "=", "<" if sys.byteorder == "little" else ">")
