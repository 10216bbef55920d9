"""Random values for the tests, from a `random.Random` with a fixed seed."""

import struct
from math import isfinite

from ncp_pure import fields as types
from ncp_pure.messages import Base64

LETTERS = ["a", "Z", "0", '"', "\\", "/", "\n", "\x00", "\x7f", "é", "～", "😀", "{", "[", ",", ":"]


def text(random):
    return "".join(random.choices(LETTERS, k=random.randrange(6)))


def double(random):
    """Any finite double, by its bits, so that subnormals and both zeros come too."""
    if random.random() < 0.2:
        return random.choice([0.0, -0.0, 5e-324, -5e-324, 1.7976931348623157e308, 1e22, 0.1])
    while True:
        value = struct.unpack("<d", random.getrandbits(64).to_bytes(8, "little"))[0]
        if isfinite(value):
            return value


def integer(random):
    return random.choice([0, 1, -1, types.MAX_INTEGER, -types.MAX_INTEGER, random.getrandbits(50)])


def message(random, kind, **fixed):
    """A message of a class of the tables, with random values in all fields but those that are given."""
    values = {name: value(random, field.type) for name, field in kind.FIELDS.items()}
    if "stimulus" in values and values["stimulus"] is not None and hasattr(values["stimulus"], "session_id"):
        values["stimulus"].ncp_version = values["ncp_version"]
        values["stimulus"].session_id = values["session_id"]
    return kind(**{**values, **fixed})


def value(random, type_):
    """A random value of a type of the tables."""
    few = range(random.randrange(4))
    if isinstance(type_, types.Optional):
        return None if random.random() < 0.5 else value(random, type_.item)
    if isinstance(type_, types.Nested):
        return message(random, type_.message)
    if isinstance(type_, types.Map):
        return {name: value(random, type_.item) for name in sorted(text(random) for _ in few)}
    if isinstance(type_, types.Each):
        return [value(random, type_.item) for _ in few]
    if isinstance(type_, types.Numbers):
        return [double(random) for _ in few]
    if isinstance(type_, types.Integers):
        return [integer(random) for _ in few]
    if isinstance(type_, types.Number):
        return double(random)
    if isinstance(type_, types.Integer):
        return integer(random)
    if isinstance(type_, types.Pin):
        return type_.pinned
    if isinstance(type_, types.Choice):
        return random.choice(type_.values)
    if isinstance(type_, types.SessionId):
        return random.choice(["a", "é.1", "x" * 256])
    if isinstance(type_, Base64):
        return random.randbytes(3) if hasattr(random, "randbytes") else b"abc"
    return random.random() < 0.5 if type_.python_type is bool else text(random)
