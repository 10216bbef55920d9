"""The BulkBlock (section 5.1 of the text)."""

import struct
import sys
from array import array
from collections import namedtuple
from math import isinf

from .errors import BulkError

MAX_BLOCK = 64 << 20
"""The most bytes of a block."""

MAX_COLUMNS = 4096
"""The most columns of a block."""

Column = namedtuple("Column", "name dtype data")
"""A column: its name, its dtype (`f32`, `f64`, `i32`, `i64`), and its values."""


def decode(block):
    """The columns of a block, in the order of its directory [NCP-BULK-021], or a `BulkError`.

    `data` is an `array` of the column's own type, so that all columns together take no more room
    than the block [NCP-BULK-024].
    """
    block = memoryview(block)
    if len(block) > MAX_BLOCK:
        raise BulkError(f"{len(block)} bytes are more than a block may have")  # [NCP-BULK-015]
    if len(block) < _HEADER.size:
        raise BulkError(f"{len(block)} bytes are no header")  # [NCP-BULK-001]
    magic, version, flags, n_cols, total_len = _HEADER.unpack_from(block)
    directory_end = _HEADER.size + n_cols * _ENTRY.size
    for wrong, what in (
        (magic != _MAGIC, "the magic is not NCPB"),  # [NCP-BULK-002]
        (version != _VERSION, f"version {version} is not known"),  # [NCP-BULK-003]
        (flags != 0, "the flags are not 0"),  # [NCP-BULK-004]
        (total_len != len(block), "total_len is not the length of the block"),  # [NCP-BULK-005]
        (n_cols > MAX_COLUMNS, f"more than {MAX_COLUMNS} columns"),  # [NCP-BULK-016]
        (directory_end > len(block), "the directory does not fit"),  # [NCP-BULK-006]
    ):
        if wrong:
            raise BulkError(what)

    entries = [_entry(entry) for entry in _ENTRY.iter_unpack(block[_HEADER.size : directory_end])]
    regions = [(0, directory_end)]
    regions += [region for entry in entries for region in (entry.name, entry.data)]
    _check_regions(regions, len(block))

    columns = [_column(block, entry) for entry in entries]
    if len({column.name for column in columns}) != len(columns):
        raise BulkError("two columns have the same name")  # [NCP-BULK-013]
    return columns


def encode(columns):
    """The block of the columns, or a `BulkError`: nothing is truncated [NCP-BULK-031].

    `data` is any sequence of numbers; an `f32` takes the nearest value of its type.
    """
    columns = [Column(*column) for column in columns]
    if len(columns) > MAX_COLUMNS:
        raise BulkError(f"more than {MAX_COLUMNS} columns")
    if len({column.name for column in columns}) != len(columns):
        raise BulkError("two columns have the same name")  # [NCP-BULK-034]

    names = [_name_bytes(column.name) for column in columns]
    data = [_data_bytes(column) for column in columns]
    name_off = _HEADER.size + len(columns) * _ENTRY.size
    data_off = name_off + sum(map(len, names))
    directory, body = bytearray(), bytearray()
    for column, name, values in zip(columns, names, data):
        padding = -(data_off + len(body)) % 8  # [NCP-BULK-033]
        body += bytes(padding)
        if data_off + len(body) + len(values) > MAX_BLOCK:
            raise BulkError(f"a block may not have more than {MAX_BLOCK} bytes")
        code = _CODES[column.dtype]
        rows = len(values) // _DTYPES[code].size
        directory += _ENTRY.pack(name_off, len(name), code, 0, rows, data_off + len(body))
        name_off += len(name)
        body += values
    # [NCP-BULK-032]
    block = bytes(directory) + b"".join(names) + bytes(body)
    return _HEADER.pack(_MAGIC, _VERSION, 0, len(columns), _HEADER.size + len(block)) + block


_MAGIC = b"NCPB"
_VERSION = 1
_HEADER = struct.Struct("<4sBBHI")
_ENTRY = struct.Struct("<IHBBII")

_Dtype = namedtuple("_Dtype", "name typecode size")
_DTYPES = {
    1: _Dtype("f32", "f", 4),
    2: _Dtype("f64", "d", 8),
    3: _Dtype("i32", "i", 4),
    4: _Dtype("i64", "q", 8),
}
_CODES = {dtype.name: code for code, dtype in _DTYPES.items()}

_Entry = namedtuple("_Entry", "name data dtype")


def _entry(fields):
    """The regions that an entry of the directory names, as (begin, end), and its dtype."""
    name_off, name_len, code, pad, rows, data_off = fields
    if code not in _DTYPES:
        raise BulkError(f"dtype {code} is not known")  # [NCP-BULK-007]
    if pad != 0:
        raise BulkError("a pad byte is not 0")  # [NCP-BULK-008]
    dtype = _DTYPES[code]
    return _Entry((name_off, name_off + name_len), (data_off, data_off + rows * dtype.size), dtype)


def _check_regions(regions, length):
    for begin, end in regions:
        if end > length or begin > length:
            raise BulkError("a region lies beyond the block")  # [NCP-BULK-009] [NCP-BULK-011] [NCP-BULK-014]
    last = 0
    for begin, end in sorted(region for region in regions if region[0] < region[1]):
        if begin < last:
            raise BulkError("two regions share a byte")  # [NCP-BULK-012]
        last = end


def _column(block, entry):
    try:
        name = str(block[slice(*entry.name)], "utf-8")
    except UnicodeDecodeError:
        raise BulkError("a name is not UTF-8") from None  # [NCP-BULK-010]
    data = array(entry.dtype.typecode)
    data.frombytes(block[slice(*entry.data)])  # at any offset [NCP-BULK-018]
    if sys.byteorder == "big":
        data.byteswap()  # [NCP-BULK-022]
    return Column(name, entry.dtype.name, data)


def _name_bytes(name):
    try:
        encoded = name.encode("utf-8")
    except (AttributeError, UnicodeEncodeError):
        raise BulkError("a name has no UTF-8 form") from None
    if len(encoded) > 0xFFFF:
        raise BulkError("a name does not fit its length field")
    return encoded


def _data_bytes(column):
    if column.dtype not in _CODES:
        raise BulkError(f"dtype {column.dtype!r} is not known")
    try:
        data = array(_DTYPES[_CODES[column.dtype]].typecode, column.data)
    except (OverflowError, TypeError):
        raise BulkError(f"a value does not fit {column.dtype}") from None
    if column.dtype == "f32" and sum(map(isinf, data)) > sum(map(isinf, column.data)):
        raise BulkError("a value does not fit f32")
    if sys.byteorder == "big":
        data.byteswap()
    return data.tobytes()
