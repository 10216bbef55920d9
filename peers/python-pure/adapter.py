"""The adapter of `ncp_pure`: answers the calls of peers/PROTOCOL.md through the package's public API."""

import base64
import json
import math
import sys
import traceback

import ncp_pure as ncp
from ncp_pure import fields as types

ROLES = ["commander", "body", "server", "observer"]


def main():
    """Reads requests from standard input until its end, and answers each in its turn."""
    for line in sys.stdin.buffer:
        if line.strip():
            sys.stdout.buffer.write(answer(line))
            sys.stdout.buffer.write(b"\n")
            sys.stdout.buffer.flush()


def answer(line):
    """The answer to one request, as bytes."""
    request = json.loads(line)
    reply = {"id": request["id"]}
    call = CALLS.get(request["call"])
    if call is None:
        reply["unsupported"] = True
    else:
        reply.update(outcome(call, request.get("args") or {}))
    return json.dumps(reply, allow_nan=False, separators=(",", ":")).encode("ascii")


def outcome(call, args):
    """The result of a call, or the error with which it was refused."""
    try:
        return {"result": call(args)}
    except ncp.NcpError as error:
        return {"error": {"code": error.code, "message": str(error)[:500]}}
    except Exception as error:  # the API documents no other exception, so this is a crash
        traceback.print_exc()
        return {"error": {"code": "internal", "message": repr(error)[:500]}}


# --- values (PROTOCOL.md, section 2) -------------------------------------------------------------


def double_in(value):
    """A double of a request."""
    return float(value) if value in ("NaN", "Infinity", "-Infinity", "-0") else value


def double_out(value):
    """A double of an answer."""
    if math.isfinite(value):
        return value
    return "NaN" if math.isnan(value) else "Infinity" if value > 0 else "-Infinity"


def doubles_in(values):
    return [double_in(value) for value in values]


def bytes_in(args):
    """A frame, exactly as it would have arrived."""
    if args.get("base64") is not None:
        return base64.b64decode(args["base64"])
    return args["text"].encode("utf-8", "surrogatepass")


def block_in(args):
    return base64.b64decode(args["block"])


def block_out(block):
    return {"block": base64.b64encode(block).decode("ascii")}


def message_in(message, fields):
    """The message that a program would build from these fields, or None for none."""
    if fields is None:
        return None
    table = message.FIELDS
    given = {name: value for name, value in fields.items() if name in table}
    return message(**{name: value_in(table[name].type, value) for name, value in given.items()})


def value_in(type_, value):
    """A field's value, as a program would give it to the builder."""
    if isinstance(type_, types.Optional):
        return None if value is None else value_in(type_.item, value)
    if isinstance(type_, types.Nested) and isinstance(value, dict):
        return message_in(type_.message, value)
    if isinstance(type_, types.Map) and isinstance(value, dict):
        return {name: value_in(type_.item, item) for name, item in value.items()}
    if isinstance(type_, types.Each) and isinstance(value, list):
        return [value_in(type_.item, item) for item in value]
    if isinstance(type_, types.Numbers) and isinstance(value, list):
        return doubles_in(value)
    if isinstance(type_, types.Number):
        return double_in(value)
    return value


def value_out(value):
    """Whatever a message holds, as JSON."""
    if isinstance(value, ncp.fields.Message):
        return {name: value_out(item) for name, item in vars(value).items()}
    if isinstance(value, dict):
        return {name: value_out(item) for name, item in value.items()}
    if isinstance(value, list):
        return [value_out(item) for item in value]
    return double_out(value) if isinstance(value, float) else value


# --- wire (section 3) ----------------------------------------------------------------------------


def describe(_args):
    return {
        "name": "ncp_pure",
        "version": ncp.__version__,
        "language": "Python",
        "wire_version": ncp.WIRE_VERSION,
        "contract_hash": ncp.CONTRACT_HASH,
        "roles": ROLES,
        "reference_networks": True,
    }


def decode(args):
    message = ncp.decode(args["kind"], bytes_in(args), strict=args.get("strict") or False)
    try:
        return {"text": ncp.to_text(message)}
    except ncp.EncodeError:
        return {}


def encode(args):
    message = message_in(ncp.FRAMES[args["kind"]], args["fields"])
    return {"text": ncp.encode(message).decode("utf-8")}


def check_version(args):
    return {"compatible": ncp.check_version(args["version"], args["strict"])}


def contract_status(args):
    return {"status": ncp.contract_status(args.get("peer_hash"))}


def verify_contract(args):
    ncp.verify_contract(args.get("peer_hash"))
    return {}


def negotiate(args):
    return {"contract": ncp.negotiate(args["version"], args.get("contract_hash"))}


def build_key(args):
    keys = ncp.Keys(args.get("realm"))
    key = args["key"]
    if key == "rpc" and args.get("verb") is not None:
        return {"key": keys.rpc_of(args["verb"])}
    if key in ("rpc", "fleet_glob"):
        return {"key": getattr(keys, key)()}
    if key in ("sensor", "command"):
        return {"key": getattr(keys, key)(args["session"], args.get("name"))}
    return {"key": getattr(keys, key)(args["session"])}


def match_key(args):
    return {"matches": ncp.matches(args["pattern"], args["key"])}


def plane_qos(args):
    return ncp.PLANES[args["plane"]]._asdict()


def bulk_decode(args):
    return {
        "columns": [
            {"name": column.name, "dtype": column.dtype, "data": column_out(column)}
            for column in ncp.bulk.decode(block_in(args))
        ]
    }


def column_out(column):
    if column.dtype == "i64":
        return list(map(str, column.data))
    return list(map(double_out, column.data)) if column.dtype in ("f32", "f64") else list(column.data)


def bulk_encode(args):
    columns = [
        ncp.bulk.Column(
            column["name"],
            column["dtype"],
            list(map(int, column["data"])) if column["dtype"] == "i64" else doubles_in(column["data"]),
        )
        for column in args["columns"]
    ]
    return block_out(ncp.bulk.encode(columns))


def pack(args):
    senders = list(map(int, args["senders"]))
    return block_out(ncp.observation.pack(doubles_in(args["times"]), doubles_in(args["values"]), senders))


def unpack(args):
    times, values, senders = ncp.observation.unpack(block_in(args))
    return {
        "times": list(map(double_out, times)),
        "values": list(map(double_out, values)),
        "senders": list(map(str, senders)),
    }


def check_reply(args):
    text = args["request"].encode("utf-8", "surrogatepass")
    kind = json.loads(text)["kind"]
    reply = args["reply"].encode("utf-8", "surrogatepass")
    ncp.check_reply(ncp.decode(kind, text), reply, strict=args.get("strict") or False)
    return {}


# --- traces (section 4) --------------------------------------------------------------------------


def trace(args, **operations):
    """Does the steps of a trace, each by the operation of its name."""
    steps = []
    for step in args["steps"]:
        done = outcome(operations[step["op"]], step)
        steps.append((done.get("result") or {}) if "error" not in done else done)
    return {"steps": steps}


def nothing(operation):
    """The operation as one without a result."""

    def run(step):
        operation(step)
        return {}

    return run


def limits_in(args):
    return message_in(ncp.SafetyLimits, args.get("limits") or {})


def governor_run(args):
    channels = args.get("capabilities")
    if channels is None:
        governor = ncp.SafetyGovernor(limits_in(args))
    else:
        sensors, commands = (
            [message_in(ncp.ChannelSpec, spec) for spec in channels.get(name) or []]
            for name in ("sensor_channels", "command_channels")
        )
        governor = ncp.SafetyGovernor(limits_in(args), sensors, commands)

    def govern(step):
        last = step.get("last_sensor_s")
        frame = governor.govern(
            message_in(ncp.CommandFrame, step["command"]),
            double_in(step["now_s"]),
            message_in(ncp.SensorFrame, step.get("sensor")),
            None if last is None else double_in(last),
        )
        return {"frame": value_out(frame)}

    return trace(
        args,
        govern=govern,
        note_link=nothing(lambda step: governor.note_link(step["burst"])),
        reset=nothing(lambda step: governor.reset()),
    )


def watchdog_run(args):
    watchdog = ncp.CommandWatchdog()
    return trace(
        args,
        command=nothing(
            lambda step: watchdog.on_command(
                double_in(step["now_s"]), double_in(step["ttl_ms"]), step["seq"]
            )
        ),
        should_hold=lambda step: {"hold": watchdog.should_hold(double_in(step["now_s"]))},
        reset=nothing(lambda step: watchdog.reset()),
    )


def buffer_run(args):
    buffer = ncp.ActionBuffer(strict=args.get("strict") or False)
    return trace(
        args,
        command=nothing(lambda step: buffer.on_frame(bytes_in(step), double_in(step["now_s"]))),
        active=lambda step: {"channels": value_out(buffer.active(double_in(step["now_s"])))},
        reset=nothing(lambda step: buffer.reset()),
    )


def horizon_max_len(args):
    return {"len": ncp.max_horizon_len(double_in(args["ttl_ms"]), double_in(args["dt_ms"]))}


def link_run(args):
    settings = {
        name: double_in(args[name]) for name in ("ref_loss", "threshold") if args.get(name) is not None
    }
    monitor = ncp.LinkMonitor(**settings)

    def frame(step):
        monitor.on_frame(step["seq"])
        return monitor.state()._asdict()

    return trace(args, frame=frame)


def codec_in(codec):
    if codec == "uav":
        return ncp.default_uav()
    return ncp.RateCodec(
        *([mapping_in(mapping) for mapping in codec.get(name) or []] for name in ("encoders", "decoders"))
    )


def mapping_in(mapping):
    given = {name: mapping[name] for name in ncp.Mapping._fields if mapping.get(name) is not None}
    for name in ("value_range", "rate_range"):
        if name in given:
            given[name] = tuple(doubles_in(given[name]))
    return ncp.Mapping(**given)


def codec_encode(args):
    rates = codec_in(args["codec"]).encode(message_in(ncp.SensorFrame, args.get("sensor")))
    return {"rates": value_out(rates)}


def codec_decode(args):
    rates = {name: double_in(rate) for name, rate in args["rates"].items()}
    command = codec_in(args["codec"]).decode(
        rates, double_in(args["t"]), args["seq"], args["frame_id"], args["mode"]
    )
    return {"command": value_out(command)}


def controller_in(args):
    config = {name: value for name, value in (args.get("config") or {}).items() if value is not None}
    return ncp.ReflexController(
        **{name: doubles_in(v) if isinstance(v, list) else double_in(v) for name, v in config.items()}
    )


def reflex_step(args):
    sensor = message_in(ncp.SensorFrame, args.get("sensor"))
    return {"command": value_out(controller_in(args).step(sensor))}


def loop_run(args):
    loop = ncp.ControlLoop(
        double_in(args["period_ms"]),
        controller_in(args),
        ncp.SafetyGovernor(limits_in(args)),
        ncp.LinkMonitor(),
    )

    def tick(step):
        command, status = loop.tick(double_in(step["now_s"]))
        return {"command": value_out(command), "status": value_out(status)}

    return trace(
        args,
        sensor=nothing(
            lambda step: loop.on_sensor(
                message_in(ncp.SensorFrame, step["sensor"]), double_in(step["now_s"])
            )
        ),
        tick=tick,
        reset=nothing(lambda step: loop.reset()),
    )


def session_run(args):
    service = ncp.SessionService(strict=args.get("strict") or False)
    requests = args["requests"]
    verbs = args.get("verbs") or [None] * len(requests)
    replies = [
        service.handle(request.encode("utf-8", "surrogatepass"), verb).decode("utf-8")
        for request, verb in zip(requests, verbs)
    ]
    return {"replies": replies}


CALLS = {
    "describe": describe,
    "decode": decode,
    "encode": encode,
    "version.check": check_version,
    "contract.status": contract_status,
    "contract.verify": verify_contract,
    "negotiate": negotiate,
    "key.build": build_key,
    "key.match": match_key,
    "plane.qos": plane_qos,
    "bulk.decode": bulk_decode,
    "bulk.encode": bulk_encode,
    "observation.pack": pack,
    "observation.unpack": unpack,
    "reply.check": check_reply,
    "governor.run": governor_run,
    "watchdog.run": watchdog_run,
    "buffer.run": buffer_run,
    "horizon.max_len": horizon_max_len,
    "link.run": link_run,
    "codec.encode": codec_encode,
    "codec.decode": codec_decode,
    "reflex.step": reflex_step,
    "loop.run": loop_run,
    "session.run": session_run,
}


if __name__ == "__main__":
    main()
