"""Runs an exported function as it is, on the bits that a solver found."""

import ctypes
import struct

from properties import is_double

MASK = (1 << 64) - 1
OUT_WORDS = 32


def load(file):
    """A library, ready to call."""
    return ctypes.CDLL(str(file))


def run(library, symbol, function, signature, inputs):
    """What the function leaves, as 64-bit words by name."""
    memory = (ctypes.c_uint64 * OUT_WORDS)()
    call = getattr(library, symbol)
    call.restype = ctypes.c_uint8 if signature.returns else None
    arguments = [ctypes.byref(memory)] if signature.writes else []
    if signature.block is not None:
        block = (ctypes.c_uint64 * max(1, len(signature.block)))(*[inputs[name] for name in signature.block])
        call(*arguments, ctypes.byref(block))
        return dict(zip(signature.leaves, memory, strict=False))
    arguments += [ctypes.c_uint64(inputs[name]) for name in signature.words]
    arguments += [ctypes.c_double(double(inputs[name])) for name in signature.doubles]
    left = {"answer": call(*arguments)}
    if signature.writes:
        left |= dict(zip(("out", "out_y", "out_z"), memory, strict=False))
    return left


def bits(value):
    """The bits of a double, or of an integer."""
    return struct.unpack("<Q", struct.pack("<d", value))[0] if isinstance(value, float) else value


def double(bits):
    """The double of some bits."""
    return struct.unpack("<d", struct.pack("<Q", bits & MASK))[0]


def signed(bits):
    """The signed integer of some bits."""
    return struct.unpack("<q", struct.pack("<Q", bits & MASK))[0]


def shown(signature, inputs):
    """Inputs as a person reads them: doubles with their bits."""
    words = {name: signed(inputs[name]) for name in signature.words}
    return words | {
        name: f"{double(inputs[name])!r} ({inputs[name]:#018x})" for name in signature.doubles
    }


def shown_outputs(left):
    """Outputs likewise."""
    return {
        name: repr(double(word)) if is_double(name) else signed(word)
        for name, word in left.items()
    }
