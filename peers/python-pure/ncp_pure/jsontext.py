"""Strict reading of one JSON object (sections 1.1, 1.2 and 1.6 of the text).

The parser is the standard library's; what it lets through and the text does not is caught here.
Numbers come out so that their spelling can be told: an `int` was spelled as an integer, a `float`
was not, and `-0`, which is no integer by the text, is the float -0.0.
"""

import json
import re
from array import array
from itertools import accumulate

from .errors import DecodeError

MAX_LEVELS = 64
"""Levels of nested objects and arrays, the top-level object included."""


def read_object(frame):
    """The JSON object that the bytes `frame` hold, as a `dict`, or a `DecodeError`."""
    try:
        text = frame.decode("utf-8")  # [NCP-WIRE-001]
    except UnicodeDecodeError as error:
        raise DecodeError("malformed", f"not UTF-8: {error}") from None
    _check_levels(frame)

    plain = _is_plain(frame)
    try:
        # [NCP-WIRE-002] [NCP-WIRE-004] [NCP-WIRE-005] [NCP-WIRE-006]
        value = json.loads(
            text,
            object_pairs_hook=_object,
            parse_constant=_no_constant,
            parse_int=None if plain else _integer,
            parse_float=None if plain else _number,
        )
    except json.JSONDecodeError as error:
        raise DecodeError("malformed", f"not JSON: {error}") from None
    if type(value) is not dict:
        raise DecodeError("malformed", "the top-level value is not an object")  # [NCP-WIRE-003]
    if _SURROGATE_ESCAPE.search(frame):
        _check_strings(value)
    return value


# A string that breaks off is one to the end: to look for its end from each of its quotation marks takes for ever.
_STRING = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*(?:"|\\?\Z)', re.DOTALL)
_NOT_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))
_STEPS = bytes.maketrans(b"[{]}", b"\x01\x01\xff\xff")
_AT_ONCE = 1 << 16


def _check_levels(frame):
    """[NCP-WIRE-064] Counts the levels before anything recurses into them."""
    if frame.count(b"{") + frame.count(b"[") <= MAX_LEVELS:
        return
    steps = _STRING.sub(b"", frame).translate(_STEPS, _NOT_BRACKETS)
    level = 0
    for begin in range(0, len(steps), _AT_ONCE):
        levels = list(accumulate(array("b", steps[begin : begin + _AT_ONCE]), initial=level))
        if max(levels) > MAX_LEVELS:
            raise DecodeError("limit", f"more than {MAX_LEVELS} levels")
        level = levels[-1]


_UNPLAIN_NUMBER = re.compile(rb"-0(?![.0-9eE])|[eE]\+?[0-9]{3}")
_DIGITS_TO_0 = bytes(0x30 if 0x30 <= byte <= 0x39 else 0x20 for byte in range(256))


def _is_plain(frame):
    """Whether no number of the frame is `-0` or comes near the largest double.

    Then the parser's own conversion, which is much faster on large frames, says all.
    """
    return (
        _UNPLAIN_NUMBER.search(frame) is None
        and b"0" * 200 not in frame.translate(_DIGITS_TO_0)
    )


def _integer(spelling):
    if spelling == "-0":
        return -0.0  # [NCP-WIRE-010] no integer, but the negative zero of a number field
    if len(spelling) > 310:
        raise _infinite(spelling)
    value = int(spelling)
    try:
        float(value)
    except OverflowError:
        raise _infinite(spelling) from None
    return value


def _number(spelling):
    value = float(spelling)  # [NCP-WIRE-012] the nearest double
    if value in (float("inf"), float("-inf")):
        raise _infinite(spelling)
    return value


def _infinite(spelling):
    # [NCP-WIRE-013] [NCP-WIRE-014]
    return DecodeError("malformed", f"the number {spelling[:24]} is beyond the largest double")


def _no_constant(name):
    raise DecodeError("malformed", f"{name} is not JSON")


def _object(members):
    value = dict(members)
    if len(value) != len(members):
        raise DecodeError("malformed", "a member name repeats")  # [NCP-WIRE-007]
    return value


_SURROGATE_ESCAPE = re.compile(rb"\\u[dD][89a-fA-F]")


def _check_strings(value):
    """[NCP-WIRE-008] No string, also no name, holds a surrogate without its partner."""
    rest = [value]
    while rest:
        item = rest.pop()
        if isinstance(item, dict):
            rest.extend(item)
            rest.extend(item.values())
        elif isinstance(item, list):
            rest.extend(item)
        elif isinstance(item, str):
            try:
                item.encode("utf-8")
            except UnicodeEncodeError:
                raise DecodeError("malformed", "a surrogate without its partner") from None
