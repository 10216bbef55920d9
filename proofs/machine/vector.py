"""A counterexample as a case of the vectors, where a call of peers/PROTOCOL.md shows it."""

import math
import struct

from native import double, signed
from properties import ENABLED, FIRST, NO_POSITION, NO_VELOCITY, PLACED, SECOND, STOPPED, TIMED

TOLERANCE = 1e-9
CLAMPED = ("out", "out_y", "out_z")
MODES = ("init", "active", "hold", "estop")


def case(name, wanted, found, right, wrong):
    """The case, or None when no call shows what went wrong, or by less than a peer may round.

    What it expects is what the kernel answered natively, which the property says is right.
    """
    if wanted.function == "clamp" and _are_close(right, wrong):
        return None
    make = MAKERS.get(wanted.function)
    made = make(found, right) if make else None
    if made is None:
        return None
    call, roles, args, expected = made
    # A peer may round a clamped velocity in its own way.
    tolerance = {"tolerance": TOLERANCE} if wanted.function == "clamp" else {}
    return {
        "id": f"proofs/machine/{name}",
        "title": wanted.sentence,
        "requirements": list(wanted.rules),
        "roles": roles,
        "call": call,
        "args": args,
        "expect": {"relation": "pattern", "value": expected} | tolerance,
        "why": wanted.formal,
    }


def _are_close(right, wrong):
    """Whether two clamped vectors differ by less than a thousand times of what a case tolerates."""
    pairs = [(double(right[name]), double(wrong[name])) for name in CLAMPED]
    near = [math.isclose(a, b, rel_tol=1e3 * TOLERANCE) for a, b in pairs]
    return right["answer"] == wrong["answer"] and all(near)


def number(bits):
    """A double as the vectors write it."""
    value = double(bits)
    if value != value:
        return "NaN"
    if value in (float("inf"), float("-inf")):
        return "Infinity" if value > 0 else "-Infinity"
    return "-0" if value == 0 and bits else value


def _watch(steps, expected):
    return "watchdog.run", ["body"], {"steps": steps}, {"steps": expected}


def _command(now_s, ttl_ms, seq):
    return {"op": "command", "now_s": number(now_s), "ttl_ms": number(ttl_ms), "seq": seq}


def _asked(now_s):
    return {"op": "should_hold", "now_s": number(now_s)}


def _within_deadline(found, right):
    steps = [_command(found["received_s"], found["ttl_ms"], 1), _asked(found["now_s"])]
    return _watch(steps, [{}, {"hold": not right["answer"]}])


def _advances(found, right):
    """A first command that is long past, a second one, and whether the plant moves by it."""
    if not found["flags"] & FIRST:
        return None
    past, now, ttl = 0, _bits(100.0), _bits(1000.0)
    steps = [
        _command(past, ttl, signed(found["last"])),
        _command(now, ttl, signed(found["seq"])),
        _asked(now),
    ]
    return _watch(steps, [{}, {}, {"hold": not right["answer"]}])


def _should_hold(found, right):
    if not right["has_deadline"]:
        return None
    command = _command(found["received_s"], found["ttl_ms"], signed(found["last"]))
    # The second question shows whether the hold persists.
    steps = [command, _asked(found["now_s"]), _asked(found["received_s"])]
    held = bool(right["answer"])
    again = {"hold": True} if held else {}
    return _watch(steps, [{}, {"hold": held}, again])


def _governor(limits, sensor, steps, expected):
    args = {"limits": limits, "capabilities": None, "steps": steps}
    for step in steps:
        if step["op"] == "govern":
            step["sensor"] = sensor
    return "governor.run", ["commander"], args, {"steps": expected}


def _govern(mode="active", velocity=(0.0, 0.0, 0.0), now_s=0.0, last_s=0.0, ttl_ms=100.0):
    channel = {"data": list(velocity), "unit": "m/s"}
    command = {"seq": 1, "mode": mode, "ttl_ms": ttl_ms, "channels": {"velocity_setpoint": channel}}
    return {"op": "govern", "command": command, "now_s": now_s, "last_sensor_s": last_s}


def _position(x, y, z):
    return {"channels": {"pose_position": {"data": [x, y, z], "unit": "m"}}}


def _is_fresh(found, right):
    limits = {"command_timeout_ms": number(found["timeout_ms"])}
    step = _govern(now_s=number(found["now_s"]), last_s=number(found["last_s"]))
    mode = "active" if right["answer"] else "hold"
    return _governor(limits, {"channels": {}}, [step], [{"frame": {"mode": mode}}])


def _inside(found, right):
    limits = {"geofence_radius_m": number(found["radius"]), "command_timeout_ms": 1000.0}
    sensor = _position(*(number(found[name]) for name in "xyz"))
    enabled = 0.0 < double(found["radius"]) < float("inf")
    if not enabled:
        return None
    mode = "active" if right["answer"] else "estop"
    return _governor(limits, sensor, [_govern()], [{"frame": {"mode": mode}}])


def _limit(found, right):
    if not found["flags"] & FIRST or right["answer"] == ENABLED:
        return None
    limits = {"max_speed_mps": number(found["value"]), "command_timeout_ms": 1000.0}
    mode = "active" if right["answer"] == 0 else "hold"
    return _governor(limits, {"channels": {}}, [_govern()], [{"frame": {"mode": mode}}])


def _clamp(found, right):
    limits = {"max_speed_mps": number(found["max"]), "command_timeout_ms": 1000.0}
    velocity = [number(found[name]) for name in "xyz"]
    if not double(found["max"]) > 0.0 or double(found["max"]) == float("inf"):
        return None
    step = _govern(velocity=velocity)
    frame = {"mode": "hold"}
    if right["answer"]:
        data = [number(right[name]) for name in CLAMPED]
        frame = {"mode": "active", "channels": {"velocity_setpoint": {"data": data}}}
    return _governor(limits, {"channels": {}}, [step], [{"frame": frame}])


def _projection(found, right):
    radius = double(found["radius"])
    place = [double(found[name]) for name in "xyz"]
    if not 0.0 < radius < float("inf") or not math.hypot(*place) <= radius:
        return None
    limits = {"geofence_radius_m": radius, "command_timeout_ms": 1000.0}
    velocity = [number(found[name]) for name in "uvw"]
    step = _govern(velocity=velocity, ttl_ms=number(found["ttl_ms"]))
    mode = "active" if right["answer"] else "hold"
    return _governor(limits, _position(*place), [step], [{"frame": {"mode": mode}}])


def _gates(found, right):
    flags = found["flags"]
    if flags & (NO_VELOCITY | NO_POSITION) and flags & (FIRST | SECOND):
        return None
    limits = {"command_timeout_ms": number(found["timeout_ms"])}
    if flags & FIRST:
        limits["max_speed_mps"] = number(found["speed_mps"])
    if flags & SECOND:
        limits["geofence_radius_m"] = number(found["radius_m"])
    steps, expected = [], []
    if flags & STOPPED:
        steps.append({"op": "note_link", "burst": True})
        expected.append({})
    last_s = number(found["last_s"]) if flags & TIMED else None
    place = [number(found[name]) for name in "xyz"]
    sensor = _position(*place) if flags & PLACED else {"channels": {}}
    velocity = [number(found[name]) for name in "uvw"]
    mode = MODES[found["mode"]] if found["mode"] < len(MODES) else "init"
    step = _govern(mode, velocity, number(found["now_s"]), last_s, number(found["ttl_ms"]))
    # The second one shows whether the governor is latched.
    answer = {0: "active", 1: "active", 2: "hold", 3: "estop"}[right["answer"]]
    after = {"frame": {"mode": "estop"}} if right["stopped_after"] else {}
    return _governor(limits, sensor, [*steps, step, dict(step)], [*expected, {"frame": {"mode": answer}}, after])


def _bits(value):
    return struct.unpack("<Q", struct.pack("<d", value))[0]


MAKERS = {
    "within_deadline": _within_deadline,
    "is_fresh": _is_fresh,
    "advances": _advances,
    "watchdog_should_hold": _should_hold,
    "inside": _inside,
    "limit": _limit,
    "clamp": _clamp,
    "projection": _projection,
    "gates_govern": _gates,
}
