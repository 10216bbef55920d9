"""Packing the samples of an observation as a BulkBlock (section 5.2 of the text)."""

from . import bulk
from .errors import BulkError

_DTYPES = {"times": "f64", "values": "f64", "senders": "i64"}


def pack(times, values, senders):
    """The block of an observation's arrays, or a `BulkError` if they do not agree."""
    arrays = {"times": times, "values": values, "senders": senders}
    _check_lengths(arrays)  # [NCP-OBS-003]
    # [NCP-OBS-001] [NCP-OBS-002]
    return bulk.encode((name, _DTYPES[name], data) for name, data in arrays.items() if len(data))


def unpack(block):
    """The lists `(times, values, senders)` of a block, or a `BulkError`.

    A column that is not there is empty [NCP-OBS-005], and others do not count [NCP-OBS-007].
    """
    arrays = {name: [] for name in _DTYPES}
    for column in bulk.decode(block):  # in any order [NCP-OBS-008]
        if column.name not in arrays:
            continue
        if column.dtype != _DTYPES[column.name]:
            raise BulkError(f"{column.name} is {column.dtype}, not {_DTYPES[column.name]}")  # [NCP-OBS-006]
        arrays[column.name] = column.data.tolist()
    _check_lengths(arrays)  # [NCP-OBS-004]
    return arrays["times"], arrays["values"], arrays["senders"]


def _check_lengths(arrays):
    if len({len(data) for data in arrays.values() if len(data)}) > 1:
        raise BulkError("times, values and senders differ in length")
