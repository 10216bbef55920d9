#!/usr/bin/env python3
"""Puts an importable Python module that speaks NCP under test (peers/PROTOCOL.md).

    adapter.py [--module NAME] [--path FOLDER] [--roles ROLE,…]

Any module with the published API will do: `check_version`, `validate`, `Keys`, `govern`, `decode_command`
and their like. What a module has beyond it under the names of our own (README.md) is used too, and what
it lacks is `unsupported`. The adapter needs the standard library only.
"""

import argparse
import array
import base64
import importlib
import json
import math
import os
import re
import sys

ROLES = ("commander", "body", "server", "observer")
CODES = frozenset(
    "malformed type kind missing value provenance limit version contract key block non_finite reply".split()
)


class Refused(Exception):
    """The implementation refused, for the reason that the code names (PROTOCOL.md, section 5)."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


class Unsupported(Exception):
    """The module has no such function, or one that cannot be asked this."""


# --- values (PROTOCOL.md, section 2) -------------------------------------------------------------

_NAMED = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf, "-0": -0.0}
#: The fields that hold doubles: elsewhere "NaN" is a text.
_DOUBLES = frozenset(
    "advance_ms cadence_ms chunk_ms command_timeout_ms control_rate_hz data dt_ms duration_ms geofence_radius_m "
    "horizon_dt_ms loop_latency_ms loss_rate max_speed_mps max_tilt_rad params sim_time_ms t times ttl_ms "
    "values".split()
)


def double_in(value):
    """A double of a request: a number, or one of the four strings."""
    return _NAMED[value] if isinstance(value, str) else float(value)


def optional_double_in(value):
    return None if value is None else double_in(value)


def fields_in(value, name=""):
    """The fields of a message, with floats for the four strings that stand for numbers."""
    if isinstance(value, dict) and name != "meta":
        # In `params` the names are the simulator's; all of it is doubles, as all of `meta` is text.
        return {key: fields_in(item, name if name == "params" else key) for key, item in value.items()}
    if isinstance(value, list):
        return [fields_in(item, name) for item in value]
    if isinstance(value, str) and name in _DOUBLES:
        return _NAMED.get(value, value)
    return value


def out(value):
    """An answer, with the four strings for the doubles that need them."""
    if isinstance(value, dict):
        return {key: out(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [out(item) for item in value]
    if isinstance(value, float):
        if math.isnan(value):
            return "NaN"
        if math.isinf(value):
            return "Infinity" if value > 0 else "-Infinity"
        if value == 0 and math.copysign(1, value) < 0:
            return "-0"
    return value


def written(value, **how):
    """JSON as a module's users write it: escapes would make a long frame longer than a frame may be.

    A string that no UTF-8 can hold stays escaped, for the module to refuse.
    """
    text = json.dumps(value, ensure_ascii=False, **how)
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return json.dumps(value, **how)
    return text


def json_of(fields):
    """JSON for a function that takes JSON, which holds finite numbers only."""
    try:
        return written(fields, allow_nan=False)
    except ValueError:
        raise Unsupported from None


def json_in(answer):
    """What a function that gives JSON gave, if it gave it as a text."""
    return json.loads(answer) if isinstance(answer, (str, bytes)) else answer


# --- the calls -----------------------------------------------------------------------------------


class Peer:
    """The calls, by the functions of one module. `_` stands for the dot of a call's name."""

    def __init__(self, module, roles=None, reference_networks=False):
        self.module = module
        self.roles = roles
        self.reference_networks = reference_networks

    def has(self, name):
        return callable(getattr(self.module, name, None))

    def function(self, *names):
        """The first of these that the module has."""
        for name in names:
            if self.has(name):
                return getattr(self.module, name)
        raise Unsupported

    # --- section 3

    def describe(self, _args):
        module = self.module
        return {
            "name": module.__name__,
            "version": str(getattr(module, "__version__", "unknown")),
            "language": "Python",
            "wire_version": str(getattr(module, "NCP_VERSION", "unknown")),
            "contract_hash": str(getattr(module, "CONTRACT_HASH", "unknown")),
            "roles": list(self.roles or self.roles_by_functions()),
            "reference_networks": self.reference_networks,
        }

    def roles_by_functions(self):
        """What only this role needs tells that the module is meant for it."""
        marks = {
            "commander": ("govern", "SafetyGovernor", "decode_command"),
            "body": ("validate",),
            "server": ("SessionService", "bulk_encode"),
            "observer": ("key_matches", "bulk_decode"),
        }
        found = [role for role in ROLES if any(map(self.has, marks[role]))]
        return found or ["body"]

    def decode(self, args):
        validate = self.function("validate")
        text = given(lambda frame: validate(args["kind"], frame), frame_in(args))
        return {"text": text if isinstance(text, str) else json_of(text)}

    def encode(self, args):
        kind, fields = args["kind"], fields_in(args["fields"])
        if self.has("encode"):
            return {"text": self.module.encode(kind, fields)}
        # A function from JSON to JSON is given what its users write: the frame, with the two
        # fields by which a program's defaults differ from what a receiver reads.
        frame = {"kind": kind, "ncp_version": self.module.NCP_VERSION}
        if kind == "command_frame":
            frame["mode"] = "active"
        if kind in ("open_session", "session_opened", "capabilities"):
            frame["contract_hash"] = self.module.CONTRACT_HASH
        # Not `json_of`: what Python writes for a NaN is for the module to refuse.
        text = self.function("validate")(kind, written({**frame, **fields}))
        return {"text": text if isinstance(text, str) else json_of(text)}

    def version_check(self, args):
        check = self.function("check_version")
        return {"compatible": bool(check(args["version"], args["strict"]))}

    def contract_status(self, args):
        status = self.function("contract_status")(args.get("peer_hash"))
        return {"status": status_name(status)}

    def contract_verify(self, args):
        self.function("verify_contract")(args.get("peer_hash"))
        return {}

    def negotiate(self, args):
        version, contract_hash = args["version"], args.get("contract_hash")
        if self.has("negotiate"):
            return {"contract": status_name(self.module.negotiate(version, contract_hash))}
        # By its definition: the version guard, strict, and then the status.
        self.function("check_version")(version, True)
        return {"contract": status_name(self.function("contract_status")(contract_hash))}

    def key_build(self, args):
        build = self.function("Keys")
        key, session, name = args["key"], args.get("session"), args.get("name")
        method = key + "_named" if name is not None else key
        if not hasattr(build, method):
            raise Unsupported
        realm = args.get("realm")
        keys = build() if realm is None else build(realm)
        parts = [part for part in (session, name) if part is not None]
        return {"key": getattr(keys, method)(*parts)}

    def key_match(self, args):
        return {"matches": self.function("key_matches")(args["pattern"], args["key"])}

    def plane_qos(self, args):
        qos = self.function("plane_qos")(args["plane"])
        return {"congestion": qos.congestion, "priority": qos.priority, "express": qos.express}

    def bulk_decode(self, args):
        return {"columns": self.columns(base64.b64decode(args["block"]))}

    def columns(self, block):
        if self.has("bulk_decode") and importable("numpy"):
            found = self.module.bulk_decode(block)
            found = [(name, NUMPY_NAMES[str(data.dtype)], data) for name, data in found.items()]
        else:
            found = self.function("bulk_views")(block)
            found = [(name, column.dtype, column.values) for name, column in found.items()]
        return [column_out(*column) for column in found]

    def bulk_encode(self, args):
        encode = self.function("bulk_encode")
        columns = [
            (column["name"], values_in(column["dtype"], column["data"]))
            for column in args["columns"]
        ]
        return {"block": base64.b64encode(encode(columns)).decode("ascii")}

    def observation_pack(self, args):
        block = self.function("observation_pack")(
            values_in("f64", args["times"]),
            values_in("f64", args["values"]),
            values_in("i64", args["senders"]),
        )
        return {"block": base64.b64encode(block).decode("ascii")}

    def observation_unpack(self, args):
        names = ["observation_unpack"] if importable("numpy") else []
        unpack = self.function(*names, "observation_views")
        times, values, senders = unpack(base64.b64decode(args["block"]))
        return {
            "times": times.tolist(),
            "values": values.tolist(),
            "senders": list(map(str, senders.tolist())),
        }

    def reply_check(self, args):
        self.function("check_reply")(args["request"], args["reply"])
        return {}

    # --- section 4

    def governor_run(self, args):
        if self.has("SafetyGovernor"):
            return self.governor_with_state(args)
        govern = self.function("govern")
        steps = args["steps"]
        # A function without state and without negotiated channels can be asked for one decision.
        if args.get("capabilities") or len(steps) != 1 or steps[0]["op"] != "govern":
            raise Unsupported
        step = steps[0]
        limits = json_of(fields_in(args["limits"]))
        command = self.frame("command_frame", {"mode": "active", **fields_in(step["command"])})
        sensor = step.get("sensor")
        if sensor is not None:
            sensor = self.frame("sensor_frame", fields_in(sensor))

        def once(_step):
            last_sensor_s = optional_double_in(step.get("last_sensor_s"))
            frame = govern(limits, command, double_in(step["now_s"]), sensor, last_sensor_s)
            return {"frame": json_in(frame)}

        return run(steps, {"govern": once})

    def governor_with_state(self, args):
        limits, capabilities = fields_in(args["limits"]), args.get("capabilities")
        if capabilities is None:
            governor = self.module.SafetyGovernor(limits)
        else:
            governor = self.module.SafetyGovernor(
                limits,
                fields_in(capabilities["sensor_channels"]),
                fields_in(capabilities["command_channels"]),
            )

        def govern(step):
            frame = governor.govern(
                fields_in(step["command"]),
                double_in(step["now_s"]),
                fields_in(step.get("sensor")),
                optional_double_in(step.get("last_sensor_s")),
            )
            return {"frame": frame}

        return run(
            args["steps"],
            {
                "govern": govern,
                "note_link": lambda step: method(governor, "note_link")(step["burst"]),
                "reset": lambda _step: method(governor, "reset")(),
            },
        )

    def watchdog_run(self, args):
        watchdog = self.function("CommandWatchdog")()

        def command(step):
            watchdog.on_command(double_in(step["now_s"]), double_in(step["ttl_ms"]), step["seq"])

        return run(
            args["steps"],
            {
                "command": command,
                "should_hold": lambda step: {"hold": watchdog.should_hold(double_in(step["now_s"]))},
                "reset": lambda _step: method(watchdog, "reset")(),
            },
        )

    def buffer_run(self, args):
        buffer = self.function("ActionBuffer")()

        def command(step):
            now_s = double_in(step["now_s"])
            given(lambda frame: buffer.on_frame(frame, now_s), frame_in(step))

        return run(
            args["steps"],
            {
                "command": command,
                "active": lambda step: {"channels": buffer.active(double_in(step["now_s"]))},
                "reset": lambda _step: method(buffer, "reset")(),
            },
        )

    def horizon_max_len(self, args):
        length = self.function("max_horizon_len")
        return {"len": length(double_in(args["ttl_ms"]), double_in(args["dt_ms"]))}

    def link_run(self, args):
        named = {name: args[name] for name in ("ref_loss", "threshold") if args.get(name) is not None}
        link = self.function("LinkMonitor")(**{name: double_in(value) for name, value in named.items()})

        def frame(step):
            link.on_frame(step["seq"])
            report = link.report()
            members = ("last_seq", "received", "lost", "loss_rate", "burst")
            return {member: getattr(report, member) for member in members}

        return run(args["steps"], {"frame": frame})

    def codec_encode(self, args):
        sensor = fields_in(args.get("sensor"))
        if self.has("RateCodec"):
            return {"rates": self.codec(args["codec"]).encode(sensor)}
        encode = self.function("encode_rates")
        if sensor is None:
            raise Unsupported
        codec = json_of(published(args["codec"]))
        sensor = self.frame("sensor_frame", sensor)
        return {"rates": json_in(encode(codec, sensor))}

    def codec_decode(self, args):
        rates = {name: double_in(rate) for name, rate in args["rates"].items()}
        rest = (double_in(args["t"]), args["seq"], args["frame_id"], args["mode"])
        if self.has("RateCodec"):
            return {"command": self.codec(args["codec"]).decode(rates, *rest)}
        decode = self.function("decode_command")
        codec, rates = json_of(published(args["codec"])), json_of(rates)
        if not math.isfinite(rest[0]):
            raise Unsupported
        return {"command": json_in(decode(codec, rates, *rest))}

    def codec(self, codec):
        if codec == "uav":
            return self.module.RateCodec.uav()
        codec = codec_in(codec)
        mappings = ([self.module.RateMapping(**mapping) for mapping in codec[side]] for side in codec)
        return self.module.RateCodec(*mappings)

    def reflex_step(self, args):
        controller = self.reflex(args["config"])
        return {"command": controller.step(fields_in(args.get("sensor")))}

    def reflex(self, config):
        given = {name: value for name, value in config.items() if value is not None}
        for name, value in given.items():
            given[name] = list(map(double_in, value)) if name == "target" else double_in(value)
        return self.function("ReflexController")(**given)

    def loop_run(self, args):
        loop = self.function("ControlLoop")
        reflex = self.reflex(args["config"])
        control = loop(double_in(args["period_ms"]), fields_in(args["limits"]), reflex)

        def sensor(step):
            control.on_sensor(fields_in(step["sensor"]), double_in(step["now_s"]))

        def tick(step):
            done = control.tick(double_in(step["now_s"]))
            return {"command": done.command, "status": done.status}

        return run(
            args["steps"],
            {"sensor": sensor, "tick": tick, "reset": lambda _step: method(control, "reset")()},
        )

    def session_run(self, args):
        service = self.function("SessionService")()
        return {"replies": [service.serve(request) for request in args["requests"]]}

    def frame(self, kind, fields):
        """A frame as JSON, for a function that takes JSON."""
        return json_of({"kind": kind, "ncp_version": self.module.NCP_VERSION, **fields})


def frame_in(args):
    """The frame, as it would have arrived."""
    if args.get("base64") is not None:
        return base64.b64decode(args["base64"])
    return args["text"]


def given(function, frame):
    """The function, given a frame. To one that takes a `str` only, bytes come as the text that they are."""
    if isinstance(frame, str):
        return function(frame)
    try:
        return function(frame)
    except TypeError:
        pass
    try:
        text = frame.decode("utf-8")
    except UnicodeDecodeError as error:
        # Python's own step before such a function can be called at all.
        raise Refused("malformed", str(error)) from None
    return function(text)


def run(steps, done):
    """Does the steps of a trace, by their `op`."""
    entries = []
    for step in steps:
        entry = reply(lambda step=step: done[step["op"]](step) or {})
        entries.append(entry.get("result", entry))
    return {"steps": entries}


def method(thing, name):
    """A method of an object of the module. A step that needs one which is not there is unsupported."""
    found = getattr(thing, name, None)
    if found is None:
        raise Unsupported
    return found


def status_name(status):
    """A contract status, whether the module spells it as a text or as an enum's member."""
    name = str(getattr(status, "name", status)).rpartition(".")[2]
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


NUMPY_NAMES = {"float32": "f32", "float64": "f64", "int32": "i32", "int64": "i64"}
_LETTERS = {"f32": "f", "f64": "d", "i32": "i", "i64": "q"}


def column_out(name, dtype, values):
    data = values.tolist()
    return {"name": name, "dtype": dtype, "data": list(map(str, data)) if dtype == "i64" else data}


def values_in(dtype, data):
    number = int if dtype.startswith("i") else double_in
    values = [number(value) for value in data]
    if importable("numpy"):
        import numpy

        return numpy.array(values, dtype=dtype[0] + str(int(dtype[1:]) // 8))
    return array.array(_LETTERS[dtype], values)


def importable(name):
    try:
        importlib.import_module(name)
    except ImportError:
        return False
    return True


#: The default UAV codec, as NCP-CODEC-020 has it.
_UAV = {
    "encoders": [
        {"channel": "pose_error", "component": axis, "population": f"err_{'xyz'[axis]}", "value_range": [-2.0, 2.0]}
        for axis in range(3)
    ],
    "decoders": [
        {
            "channel": "velocity_setpoint",
            "component": axis,
            "population": f"vel_{'xyz'[axis]}",
            "value_range": [-1.5, 1.5],
            "unit": "m/s",
        }
        for axis in range(3)
    ],
}


def codec_in(codec):
    """A codec, with the defaults of its mappings."""
    if codec == "uav":
        codec = _UAV
    defaults = {"value_range": [-1.0, 1.0], "rate_range": [0.0, 200.0]}

    def mapping(given):
        filled = {**defaults, **{name: value for name, value in given.items() if value is not None}}
        for name in defaults:
            filled[name] = [double_in(end) for end in filled[name]]
        return filled

    return {side: [mapping(given) for given in codec.get(side) or []] for side in ("encoders", "decoders")}


def published(codec):
    """A codec in the form that every published build reads, with what was given and no more."""
    codec = _UAV if codec == "uav" else codec

    def mapping(given, channel):
        names = {"channel": channel, "rate_range": "rate_range_hz"}
        given = {names.get(name, name): value for name, value in given.items() if value is not None}
        for name in {"value_range", "rate_range_hz"} & given.keys():
            given[name] = list(map(double_in, given[name]))
        return given

    return {
        "codec_id": "ncp.codec.rate.v0",
        "encoder": [mapping(given, "channel") for given in codec.get("encoders") or []],
        "decoder": [mapping(given, "command_channel") for given in codec.get("decoders") or []],
    }


# --- the conversation ----------------------------------------------------------------------------


def reply(call):
    """What a call gives, or why it gives nothing."""
    try:
        return {"result": out(call())}
    except Unsupported:
        return {"unsupported": True}
    except Refused as error:
        return {"error": {"code": error.code, "message": str(error)}}
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # a panic of Rust is no Exception
        message = f"{type(error).__name__}: {error}"
        return {"error": {"code": code_of(error), "message": message}}


def code_of(error):
    """A ValueError, a RuntimeError and an exception of the module's own refuse; all else is a crash."""
    if isinstance(error, (RecursionError, NotImplementedError)) or not isinstance(error, Exception):
        return "internal"
    own = type(error).__module__.partition(".")[0] == Peer.own
    if not own and not isinstance(error, (ValueError, RuntimeError)):
        return "internal"
    code = getattr(error, "code", None)
    return code if isinstance(code, str) and code in CODES else "invalid"


Peer.own = "ncp"


def answer(peer, line):
    request = json.loads(line)
    name = request["call"].replace(".", "_")
    function = getattr(peer, name, None) if request["call"] in CALLS else None
    if function is None:
        return {"id": request["id"], "unsupported": True}
    return {"id": request["id"], **reply(lambda: function(request.get("args") or {}))}


CALLS = frozenset(
    "describe decode encode version.check contract.status contract.verify negotiate key.build key.match "
    "plane.qos bulk.decode bulk.encode observation.pack observation.unpack reply.check governor.run "
    "watchdog.run buffer.run horizon.max_len link.run codec.encode codec.decode reflex.step loop.run "
    "session.run".split()
)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--module", default="ncp", help="the module to import (default: ncp)")
    parser.add_argument("--path", help="a folder to find it in, before all others")
    parser.add_argument("--roles", help="the roles that it claims, with commas (default: by its functions)")
    parser.add_argument(
        "--reference-networks", action="store_true", help="it claims the networks of section 4.4 of the text"
    )
    options = parser.parse_args()
    roles = options.roles.split(",") if options.roles else None
    if roles and not set(roles) <= set(ROLES):
        parser.error("a role is one of " + ", ".join(ROLES))

    # Whatever the module prints, by Python or not, goes to the log.
    answers = os.fdopen(os.dup(1), "wb")
    requests = os.fdopen(os.dup(0), "rb")
    os.dup2(2, 1)
    with open(os.devnull, "rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    sys.stdout = sys.stderr
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    # The folder of this program is no place to find the module by accident.
    sys.path[0:1] = [options.path] if options.path else []

    peer = Peer(importlib.import_module(options.module), roles, options.reference_networks)
    Peer.own = options.module.partition(".")[0]
    for line in requests:
        answers.write(json.dumps(answer(peer, line), allow_nan=False).encode("ascii") + b"\n")
        answers.flush()


if __name__ == "__main__":
    main()
