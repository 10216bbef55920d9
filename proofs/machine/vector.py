"""A counterexample as a case of the vectors, where a call of peers/PROTOCOL.md shows it."""

import math
import struct

from native import double, signed
from properties import ACTIVE, ENABLED, FAULTY, FIRST

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
    if not (found["has_deadline"] and found["has_last"]):
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
    """Where the ticks answer nothing that a command does not show: not active, held before them, or with no limit at
    all, no horizon, and a velocity."""
    kinds = (found["speed_kind"], found["fence_kind"])
    is_plain = found["mode"] != ACTIVE or right["answer"] > 1 or kinds == (0, 0)
    built = found["fault"] == (FAULTY in kinds)
    if found["steps"] or found["says0"] or not found["has0"] or not is_plain or not built:
        return None
    limits = {"command_timeout_ms": number(found["timeout_ms"])}
    names = (("speed", "speed_mps", "max_speed_mps"), ("fence", "radius_m", "geofence_radius_m"))
    for kind, bound, name in names:
        if found[f"{kind}_kind"]:
            limits[name] = number(found[bound]) if found[f"{kind}_kind"] == ENABLED else -1.0
            if found[f"{kind}_kind"] == ENABLED and not 0.0 < double(found[bound]) < float("inf"):
                return None
    steps, expected = [], []
    if found["stopped"]:
        steps.append({"op": "note_link", "burst": True})
        expected.append({})
    last_s = number(found["last_s"]) if found["has_time"] & FIRST else None
    place = [number(found[name]) for name in "xyz"]
    sensor = _position(*place) if found["has_place"] & FIRST else {"channels": {}}
    velocity = [number(found[f"{name}0"]) for name in "uvw"]
    if not all(isinstance(value, float) for value in velocity):
        return None
    step = _govern(MODES[found["mode"]], velocity, number(found["now_s"]), last_s, number(found["ttl_ms"]))
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
