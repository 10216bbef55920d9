"""Runs an exported function as it is, on the bits that a solver found."""

import ctypes
import struct

from properties import GATE_STEP, STEP

MASK = (1 << 64) - 1


def load(file):
    """A library, ready to call."""
    return ctypes.CDLL(str(file))


def run(library, symbol, function, signature, inputs):
    """What the function leaves, as 64-bit words by name."""
    memory = (ctypes.c_uint64 * 32)()
    call = getattr(library, symbol)
    call.restype = ctypes.c_uint8 if signature.returns else None
    arguments = [ctypes.byref(memory)] if signature.writes else []
    arguments += [ctypes.c_uint64(inputs[name]) for name in signature.words]
    arguments += [ctypes.c_double(double(inputs[name])) for name in signature.doubles]
    answer = call(*arguments)
    if not signature.returns:
        names = GATE_STEP if function.startswith("gates_") else STEP
        return dict(zip(names, memory, strict=False))
    left = {"answer": answer}
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


def shown_outputs(function, left):
    """Outputs likewise."""
    doubles = ("received_s", "ttl_ms", "received_s_after", "ttl_ms_after", "out", "out_y", "out_z")
    return {
        name: repr(double(word)) if name in doubles else signed(word)
        for name, word in left.items()
    }
