"""Frames as bytes: reading and writing them (chapter 1 of the text)."""

import json

from .errors import DecodeError, EncodeError, VersionError
from .jsontext import read_object
from .messages import FRAMES, CommandFrame, ErrorFrame, ObservationFrame
from .version import check_version

MAX_FRAME = 1 << 20
"""The most bytes of a frame that is no `observation_frame`."""

MAX_OBSERVATION_FRAME = 64 << 20
"""The most bytes of an `observation_frame`."""


def decode(kind, frame, *, strict=False):
    """The frame of the expected kind that the bytes hold, or a `DecodeError`.

    A `strict` receiver also wants a compatible version, and of a command a seq of at least 1.
    """
    if kind not in FRAMES:
        raise DecodeError("kind", f"{kind!r} is not a kind")
    _check_length(kind, frame)
    return read_frame(kind, read_object(bytes(frame)), strict=strict)


def decode_object(frame):
    """The JSON object of a frame of any kind, for who has to look at the kind first."""
    _check_length(ObservationFrame.KIND, frame)
    value = read_object(bytes(frame))
    _check_length(value.get("kind"), frame)
    return value


def read_frame(kind, value, *, strict=False):
    """The frame of a kind that a JSON object holds, or a `DecodeError`."""
    message = FRAMES[kind].read(value)
    if strict:
        check_strict(message, value)
    return message


def check_strict(message, value):
    """What a strict receiver asks of a decoded frame besides (section 12.1)."""
    if isinstance(message, ErrorFrame):
        return
    if "ncp_version" not in value:
        raise DecodeError("version", "a strict receiver needs it").within("ncp_version")  # [NCP-STRICT-002]
    try:
        check_version(message.ncp_version, strict=True)  # [NCP-STRICT-003]
    except VersionError as error:
        raise DecodeError("version", str(error)).within("ncp_version") from None
    if isinstance(message, CommandFrame) and message.seq < 1:
        raise DecodeError("value", "a strict receiver needs at least 1").within("seq")  # [NCP-STRICT-004]


def encode(message):
    """The bytes of a frame, or an `EncodeError`."""
    frame = to_text(message).encode("utf-8")  # [NCP-WIRE-092]
    if len(frame) > _limit(message.KIND):
        raise EncodeError("limit", f"{len(frame)} bytes are more than a frame may have")  # [NCP-WIRE-091]
    return frame


def to_text(message):
    """The text of a frame, however long, or an `EncodeError`."""
    # json writes a double by repr(), the shortest text that reads back as it [NCP-WIRE-084].
    text = json.dumps(
        message.write(), ensure_ascii=False, allow_nan=False, check_circular=False, separators=(",", ":")
    )
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        raise EncodeError("value", "a surrogate without its partner has no UTF-8 form") from None
    return text


def _limit(kind):
    return MAX_OBSERVATION_FRAME if kind == ObservationFrame.KIND else MAX_FRAME


def _check_length(kind, frame):
    # [NCP-WIRE-060] [NCP-WIRE-062]
    if len(frame) > _limit(kind):
        raise DecodeError("limit", f"{len(frame)} bytes are more than a frame may have")
