"""The messages of NCP: the tables of sections 1.4, 1.8 and 5.3 of the text."""

import base64
import binascii

from .errors import DecodeError, EncodeError
from .fields import (
    Choice,
    Each,
    Field,
    Integer,
    Integers,
    Map,
    Message,
    Nested,
    Number,
    Numbers,
    Optional,
    Pin,
    Plain,
    SessionId,
    Type,
)
from .identity import CONTRACT_HASH, WIRE_VERSION

MODES = ("init", "active", "hold", "estop")
"""The modes of a command; only `active` moves a plant."""

TEXT = Plain(str, "string")
BOOLEAN = Plain(bool, "boolean")
INTEGER = Integer()
NUMBER = Number()
MODE = Choice(MODES, unknown="hold")
SIM_MODE = Choice(("stream", "batch"))

# The descriptive enums (Observable, StimulusKind, NetworkRefKind, EntityRole, ChannelKind, Role)
# keep every string as it is [NCP-WIRE-042] [NCP-WIRE-043], so to the wire they are strings.
DESCRIPTIVE = TEXT


class Base64(Type):
    """Bytes, in base64 by RFC 4648 section 4, padded."""

    def read(self, value):
        try:
            return base64.b64decode(TEXT.read(value), validate=True)
        except (binascii.Error, ValueError) as error:
            if isinstance(error, DecodeError):
                raise
            raise DecodeError("value", f"not base64: {error}") from None

    def write(self, value):
        if not isinstance(value, (bytes, bytearray, memoryview)):
            raise EncodeError("type", "not bytes")
        return base64.b64encode(value).decode("ascii")


def text(default=""):
    return Field(TEXT, default)


def enum(default):
    return Field(DESCRIPTIVE, default)


def boolean(default):
    return Field(BOOLEAN, default)


def integer(default=0):
    return Field(INTEGER, default)


def number(default=0.0):
    return Field(NUMBER, default)


def optional(item):
    return Field(Optional(item), None)


def several(item):
    return Field(Each(item), list)


def mapped(item):
    return Field(Map(item), dict)


def nested(message):
    return Field(Nested(message), message)


def contract_hash():
    """Absent stays absent when it is read [NCP-WIRE-025]; who builds gets his own [NCP-WIRE-089]."""
    return Field(Optional(TEXT), None, built=CONTRACT_HASH)


# --- messages inside others ----------------------------------------------------------------------


class ChannelValue(Message):
    """One sample of one channel."""

    FIELDS = {"data": Field(Numbers(), list), "unit": optional(TEXT)}


CHANNELS = Map(Nested(ChannelValue))


class EntityRef(Message):
    """A thing of the simulated or the physical world, by its path."""

    FIELDS = {"path": text(), "role": enum("sensor"), "meta": mapped(TEXT)}


class EntityBinding(Message):
    """Ties an entity to a port of the session."""

    FIELDS = {"entity": nested(EntityRef), "port": text(), "direction": text("stimulus")}


class NetworkRef(Message):
    """Which network a session runs."""

    FIELDS = {
        "kind": enum("builtin"),
        "ref": text(),
        "model_name": optional(TEXT),
        "population_sizes": mapped(INTEGER),
        "params": mapped(NUMBER),
    }


class RecordTarget(Message):
    """What to record."""

    FIELDS = {
        "port": text(),
        "target": text(),
        "observable": enum("V_m"),
        "ids": Field(Integers(), list),
        "cadence_ms": number(1.0),
        "recordables": several(TEXT),
    }


class RecordSpec(Message):
    """What a session records."""

    FIELDS = {"targets": several(Nested(RecordTarget))}


class StimulusTarget(Message):
    """Where a stimulus goes."""

    FIELDS = {
        "port": text(),
        "target": text(),
        "kind": enum("current_pA"),
        "ids": Field(Integers(), list),
        "params": mapped(NUMBER),
    }


class StimulusSpec(Message):
    """What a session can be driven by."""

    FIELDS = {"targets": several(Nested(StimulusTarget))}


class SimConfig(Message):
    """How the simulation runs."""

    FIELDS = {
        "dt_ms": number(0.1),
        "chunk_ms": number(10.0),
        "seed": optional(INTEGER),
        "mode": Field(SIM_MODE, "stream"),
        "duration_ms": optional(NUMBER),
    }


class SimProvenance(Message):
    """Where the numbers of a session come from."""

    FIELDS = {
        "network_ref": text(),
        "backend": text(),
        "seed": optional(INTEGER),
        "calibrated_posterior": Field(Pin(False), False),
        "is_simulation_output": Field(Pin(True), True),
        "advisory_only": boolean(True),
        "note": optional(TEXT),
    }


class Observation(Message):
    """The recorded samples of one port."""

    FIELDS = {
        "port": text(),
        "target": text(),
        "observable": enum("V_m"),
        "times": Field(Numbers(), list),
        "values": Field(Numbers(), list),
        "senders": Field(Integers(), list),
        "unit": optional(TEXT),
        "recordable": optional(TEXT),
    }


class ChannelSpec(Message):
    """A channel that a peer offers or takes."""

    FIELDS = {
        "name": text(),
        "kind": enum("scalar"),
        "unit": optional(TEXT),
        "size": optional(INTEGER),
        "optional": boolean(True),
        "description": optional(TEXT),
    }


class SafetyLimits(Message):
    """What the governor enforces."""

    FIELDS = {
        "max_speed_mps": optional(NUMBER),
        "max_tilt_rad": optional(NUMBER),
        "geofence_radius_m": optional(NUMBER),
        "command_timeout_ms": number(500.0),
    }


# --- frames --------------------------------------------------------------------------------------


class Frame(Message):
    """A message that travels by itself. `KIND` is its name on the wire."""

    KIND = ""

    @classmethod
    def read(cls, value):
        if isinstance(value, dict):
            check_kind(cls.KIND, value)
        return super().read(value)

    def write(self):
        value = super().write()
        return {"ncp_version": value.pop("ncp_version"), "kind": self.KIND, **value}


def check_kind(expected, value):
    """[NCP-WIRE-028] [NCP-WIRE-029] [NCP-WIRE-030] The object is of the expected kind."""
    kind = value.get("kind")
    if kind != expected:
        said = "missing" if "kind" not in value else repr(kind)[:60]
        raise DecodeError("kind", f"{said} where {expected} is expected").within("kind")


def version():
    return text(WIRE_VERSION)  # [NCP-WIRE-032] [NCP-WIRE-033]


class OpenSession(Frame):
    """Control RPC: open a session."""

    KIND = "open_session"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "network": Field(Nested(NetworkRef)),
        "record": nested(RecordSpec),
        "stimulus": nested(StimulusSpec),
        "sim": nested(SimConfig),
        "bindings": several(Nested(EntityBinding)),
        "contract_hash": contract_hash(),
    }


class SessionOpened(Frame):
    """The reply to `open_session`."""

    KIND = "session_opened"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "ok": boolean(True),
        "backend": text("mock"),
        "resolved": mapped(INTEGER),
        "provenance": optional(Nested(SimProvenance)),
        "error": optional(TEXT),
        "contract_hash": contract_hash(),
    }


class StimulusFrame(Frame):
    """Values for the stimulus ports."""

    KIND = "stimulus_frame"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "t": number(),
        "values": Field(CHANNELS, dict),
    }


class _Advance(Frame):
    """A request that may carry a stimulus frame, whose kind, version and session are the request's."""

    @classmethod
    def read(cls, value):
        if isinstance(value, dict) and isinstance(value.get("stimulus"), dict):
            stimulus = {**cls._implied(value), **value["stimulus"]}  # [NCP-WIRE-035]
            cls._check(stimulus, value, DecodeError)
            value = {**value, "stimulus": stimulus}
        return super().read(value)

    def write(self):
        value = super().write()
        if value["stimulus"] is not None:
            self._check(value["stimulus"], value, EncodeError)
        return value

    @staticmethod
    def _implied(request):
        return {
            "kind": StimulusFrame.KIND,
            "ncp_version": request.get("ncp_version", WIRE_VERSION),
            "session_id": request.get("session_id"),
        }

    @classmethod
    def _check(cls, stimulus, request, error):
        # [NCP-WIRE-036] [NCP-WIRE-037] [NCP-WIRE-038]
        for name, wanted in cls._implied(request).items():
            if stimulus[name] != wanted:
                raise error("value", "not the request's").within(name).within("stimulus")


class StepRequest(_Advance):
    """Control RPC: advance a session."""

    KIND = "step_request"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "advance_ms": optional(NUMBER),
        "stimulus": optional(Nested(StimulusFrame)),
    }


class RunRequest(_Advance):
    """Control RPC: run a session for a stated time."""

    KIND = "run_request"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "duration_ms": Field(NUMBER),
        "stimulus": optional(Nested(StimulusFrame)),
    }


class ObservationFrame(Frame):
    """The reply to a step or a run, and the frame of the observation plane."""

    KIND = "observation_frame"
    FIELDS = {
        "ncp_version": version(),
        "session_id": Field(SessionId()),
        "seq": integer(),
        "t": number(),
        "sim_time_ms": number(),
        "records": mapped(Nested(Observation)),
        "calibrated_posterior": Field(Pin(False), False),
        "is_simulation_output": Field(Pin(True), True),
    }


class CloseSession(Frame):
    """Control RPC: close a session."""

    KIND = "close_session"
    FIELDS = {"ncp_version": version(), "session_id": Field(SessionId())}


class SessionClosed(Frame):
    """The reply to `close_session`."""

    KIND = "session_closed"
    FIELDS = {"ncp_version": version(), "session_id": Field(SessionId()), "ok": boolean(True)}


class Capabilities(Frame):
    """What a controller or a plant offers, and within which limits."""

    KIND = "capabilities"
    FIELDS = {
        "ncp_version": version(),
        "controller_id": Field(TEXT),
        "role": enum("controller"),
        "control_rate_hz": number(20.0),
        "sensor_channels": several(Nested(ChannelSpec)),
        "command_channels": several(Nested(ChannelSpec)),
        "codec_id": optional(TEXT),
        "safety": nested(SafetyLimits),
    }


class SensorFrame(Frame):
    """Perception: what the body senses."""

    KIND = "sensor_frame"
    FIELDS = {
        "ncp_version": version(),
        "seq": integer(),
        "t": number(),
        "frame_id": text("world"),
        "channels": Field(CHANNELS, dict),
    }


class CommandFrame(Frame):
    """Action: what the body is to do.

    Without a mode a frame reads as `hold` [NCP-WIRE-024]; a program that builds one means `active`
    [NCP-WIRE-088]. The horizon is an array of plain channel maps [NCP-WIRE-051].
    """

    KIND = "command_frame"
    FIELDS = {
        "ncp_version": version(),
        "seq": integer(),
        "t": number(),
        "frame_id": text("world"),
        "mode": Field(MODE, "hold", built="active"),
        "ttl_ms": number(200.0),
        "channels": Field(CHANNELS, dict),
        "horizon": several(CHANNELS),
        "horizon_dt_ms": optional(NUMBER),
    }


class ControlStatus(Frame):
    """Observation: how the control loop is doing."""

    KIND = "control_status"
    FIELDS = {
        "ncp_version": version(),
        "seq": integer(),
        "t": number(),
        "mode": Field(MODE, "init"),
        "sim_time_ms": number(),
        "loop_latency_ms": number(),
        "safety_ok": boolean(True),
        "note": optional(TEXT),
    }


class LinkStatus(Frame):
    """Observation: how a stream arrives."""

    KIND = "link_status"
    FIELDS = {
        "ncp_version": version(),
        "session_id": text(),
        "t": number(),
        "last_seq": integer(-1),
        "received": integer(),
        "lost": integer(),
        "loss_rate": number(),
        "burst": boolean(False),
    }


class BulkObservation(Frame):
    """The samples of one port as a BulkBlock [NCP-OBS-011]; `block` is bytes."""

    KIND = "bulk_observation"
    FIELDS = {
        "ncp_version": version(),
        "port": text(),
        "target": text(),
        "observable": enum("V_m"),
        "unit": optional(TEXT),
        "recordable": optional(TEXT),
        "block": Field(Base64(), b""),
    }


class ErrorFrame(Frame):
    """The reply to a request that cannot be served. It has no version."""

    KIND = "error"
    FIELDS = {"error": Field(TEXT), "session_id": optional(TEXT)}  # [NCP-WIRE-101]

    def write(self):
        value = {"kind": self.KIND, **Message.write(self)}  # [NCP-WIRE-102]
        if value["session_id"] is None:
            del value["session_id"]
        return value


FRAMES = {
    frame.KIND: frame
    for frame in (
        OpenSession,
        SessionOpened,
        StimulusFrame,
        StepRequest,
        RunRequest,
        ObservationFrame,
        CloseSession,
        SessionClosed,
        Capabilities,
        SensorFrame,
        CommandFrame,
        ControlStatus,
        LinkStatus,
        BulkObservation,
        ErrorFrame,
    )
}
"""Every kind that a frame can have."""
