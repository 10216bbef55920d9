"""Nothing that is given raises anything but ValueError and TypeError; a panic least of all."""

import decimal
import inspect
import itertools
import math
import random
import unittest

import ncp
import numpy
from ncp import _ncp

KINDS = (
    "open_session session_opened stimulus_frame step_request run_request observation_frame bulk_observation "
    "close_session session_closed capabilities sensor_frame command_frame control_status link_status error"
).split()


#: What a program does not make.
NOT_MADE = ("NcpError", "Column", "LinkReport", "Qos", "Tick")


class Endless:
    """Says that it has two items, and has no end."""

    def __len__(self):
        return 2

    def __iter__(self):
        return itertools.repeat(1.0)


class Liar(dict):
    """A dict whose methods are not to be trusted."""

    def __getitem__(self, key):
        raise KeyError(key)

    def items(self):
        return 5

    def __len__(self):
        return 10**6


class Text(str):
    def encode(self, *args):
        return 5


def deep(depth):
    value = {}
    for _ in range(depth):
        value = {"channels": value}
    return value


HOSTILE = [
    None,
    True,
    0,
    -1,
    2**31,
    2**63,
    -(2**63) - 1,
    10**400,
    0.0,
    -0.0,
    5e-324,
    1.8e308,
    math.nan,
    math.inf,
    -math.inf,
    1j,
    "",
    "a",
    "\ud800",
    "\x00",
    "NaN",
    "ä" * 300,
    Text("x"),
    "{}",
    "[" * 5000,
    '{"kind":"command_frame","mode":"estop"}',
    '{"encoders":[],"decoders":[]}',
    b"",
    b"\xff",
    b"{}",
    b"NCPB",
    bytes(64),
    bytearray(b"NCPB\x01\x00\xff\xff\x0c\x00\x00\x00"),
    memoryview(b"{}"),
    [],
    [1.0, 2.0],
    [[], {}],
    (1, 2, 3),
    {},
    {1: 2},
    {"seq": None},
    {"channels": {"a": {"data": 5}}},
    {"kind": "error"},
    Liar(a=1),
    Endless(),
    deep(500),
    set(),
    range(3),
    iter([]),
    object(),
    int,
    len,
    decimal.Decimal("NaN"),
    numpy.float32(1.5),
    numpy.int64(-5),
    numpy.zeros(3),
    numpy.zeros((2, 2), ">i8"),
]


def callables():
    """Everything that can be called: functions, constructors, methods of objects that were made."""
    objects = {
        "Keys": ncp.Keys(),
        "SafetyGovernor": ncp.SafetyGovernor({"max_speed_mps": 1.0, "geofence_radius_m": 1.0}),
        "CommandWatchdog": ncp.CommandWatchdog(),
        "ActionBuffer": ncp.ActionBuffer(),
        "LinkMonitor": ncp.LinkMonitor(),
        "RateCodec": ncp.RateCodec.uav(),
        "ReflexController": ncp.ReflexController(),
        "ControlLoop": ncp.ControlLoop(10.0, {}),
        "SessionService": ncp.SessionService(),
    }
    for module in (ncp, _ncp):
        for name, thing in vars(module).items():
            if name.startswith("_") or not callable(thing) or name in NOT_MADE:
                continue
            yield f"{module.__name__}.{name}", thing
    for name, made in objects.items():
        for method in dir(made):
            if not method.startswith("_") and callable(getattr(made, method)):
                yield f"{name}().{method}", getattr(made, method)


def arity(function):
    try:
        parameters = inspect.signature(function).parameters.values()
    except ValueError:  # Python 3.9 does not see the signature of a constructor
        return 3, 1
    return len(parameters), sum(parameter.default is parameter.empty for parameter in parameters)


class Hostile(unittest.TestCase):
    def refuses_well(self, name, function, *args):
        try:
            function(*args)
        except (ValueError, TypeError):
            return
        except BaseException as error:
            shown = ", ".join(repr(arg)[:60] for arg in args)
            self.fail(f"{name}({shown}) raised {type(error).__name__}: {error}")

    def test_no_argument_whatsoever_makes_a_function_crash(self):
        draw = random.Random(7)
        called = 0
        for name, function in callables():
            most, least = arity(function)
            for value in HOSTILE:
                self.refuses_well(name, function, *[value] * max(least, 1))
                called += 1
            for _ in range(300 if most > 1 else 0):
                args = [draw.choice(HOSTILE) for _ in range(draw.randint(least, most))]
                self.refuses_well(name, function, *args)
        self.assertGreater(called, 60 * len(HOSTILE))

    def test_no_frame_whatsoever_makes_a_decoder_crash(self):
        draw = random.Random(11)
        frames = [ncp.encode("command_frame", {"seq": 1, "horizon": [{"a": {"data": [1.5]}}]}).encode()]
        frames.append(ncp.encode("sensor_frame", {"seq": 1, "channels": {"a": {"data": [1e300]}}}).encode())
        frames += [b'{"kind":"%s"}' % kind.encode() for kind in KINDS]
        buffer, service = ncp.ActionBuffer(), ncp.SessionService()
        for _ in range(4000):
            frame = bytearray(draw.choice(frames))
            for _ in range(draw.randint(1, 5)):
                at = draw.randrange(len(frame) + 1)
                piece = draw.choice((b'"', b"}", b"{", b"[", b"\\u", b"\xff", b"1e999", b"-0", b"null", b",", b"\x00", b""))
                frame[at : at + draw.randint(0, 3)] = piece
            frame = bytes(frame)
            kind = draw.choice(KINDS)
            self.refuses_well("validate", ncp.validate, kind, frame)
            self.refuses_well("decode", ncp.decode, kind, frame)
            self.refuses_well("on_frame", buffer.on_frame, frame, draw.random())
            self.assertIsInstance(service.serve(frame), str)

    def test_no_block_whatsoever_makes_a_decoder_crash(self):
        draw = random.Random(13)
        good = ncp.bulk_encode({"times": numpy.zeros(4), "b": numpy.zeros(3, "i4"), "senders": numpy.zeros(4, "i8")})
        accepted = 0
        for _ in range(6000):
            block = bytearray(good)
            for _ in range(draw.randint(1, 3)):
                block[draw.randrange(76)] = draw.choice((0, 1, 2, 4, 8, 0x4C, 0x7F, 0xFF, draw.randrange(256)))
            try:
                found = ncp.bulk_decode(bytes(block))
            except ncp.NcpError:
                continue
            accepted += 1
            self.assertLessEqual(sum(values.nbytes for values in found.values()), len(block))
        self.assertGreater(accepted, 0)

    def test_a_dict_that_changes_while_it_is_read_does_no_harm(self):
        fields = {"t": None, "seq": 1, "ttl_ms": 5.0}

        class Clears:
            def __float__(self):
                fields.clear()
                return 1.0

        fields["t"] = Clears()
        self.refuses_well("encode", ncp.encode, "command_frame", fields)

    def test_an_object_that_calls_back_does_not_lock_the_governor(self):
        governor = ncp.SafetyGovernor({})

        class CallsBack:
            def __float__(self):
                governor.reset()
                governor.govern({}, 1.0)
                return 1.0

        self.assertEqual(governor.govern({"t": CallsBack()}, CallsBack(), None, 1.0)["t"], 1.0)


if __name__ == "__main__":
    unittest.main()
