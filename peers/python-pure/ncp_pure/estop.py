"""Finding an ESTOP in the bytes of a frame, whatever else is wrong with it (NCP-RES-022)."""

import json
import re

from .messages import CommandFrame


def is_estop(frame):
    """Whether a JSON object of kind `command_frame` has a member `mode` with the value `estop`.

    Only the object's own members count, each one of those that repeat. Nothing recurses, and the
    grammar is not checked: on bytes that are no JSON the answer may be either, and errs on true.
    """
    frame = bytes(frame)
    if b"estop" not in frame and b"\\" not in frame:
        return False
    found = {"kind": set(), "mode": set()}
    for name, value in _members(frame):
        if name in found:
            found[name].add(value)
    return CommandFrame.KIND in found["kind"] and "estop" in found["mode"]


# A string that breaks off is one to the end: to look for its end from each of its quotation marks takes for ever.
_TOKEN = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*(?:"|\\?\Z)|[{}\[\]:,]', re.DOTALL)
_STEPS = {b"{": 1, b"[": 1, b"}": -1, b"]": -1}


def _members(frame):
    """The members of the first object whose value is a string, as pairs."""
    depth = 0
    name = None
    follows_colon = False
    for match in _TOKEN.finditer(frame):
        token = match.group()
        step = _STEPS.get(token, 0)
        depth += step
        if depth <= 0:
            return
        if depth > 1 or step:
            continue
        if token == b":":
            follows_colon = True
        elif token == b",":
            name, follows_colon = None, False
        elif follows_colon:
            yield name, _string(token)
        else:
            name = _string(token)


def _string(token):
    """The string that a token stands for, or None if it is none."""
    try:
        return json.loads(token.decode("utf-8"), strict=False)
    except ValueError:
        return None
