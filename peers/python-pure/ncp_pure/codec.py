"""The rate codec `ncp.codec.rate.v0` (chapter 9 of the text)."""

from collections import namedtuple
from math import isfinite

from .messages import ChannelValue, CommandFrame

MAX_COMPONENT = 4096
"""Mappings of this component or a later one do not count [NCP-CODEC-008]."""

Mapping = namedtuple(
    "Mapping",
    "channel component population value_range rate_range unit",
    defaults=((-1.0, 1.0), (0.0, 200.0), None),
)
"""Ties a component of a channel to a population. `unit` is for decoders."""


class RateCodec:
    """Turns sensor channels into rates, and rates into command channels."""

    def __init__(self, encoders=(), decoders=()):
        self._encoders = [mapping for mapping in encoders if 0 <= mapping.component < MAX_COMPONENT]
        self._decoders = [mapping for mapping in decoders if 0 <= mapping.component < MAX_COMPONENT]

    def encode(self, sensor):
        """The rate of each population, Hz: that of its last mapping [NCP-CODEC-014]."""
        return {
            mapping.population: _mapped(  # [NCP-CODEC-001] [NCP-CODEC-002]
                _sample(sensor, mapping), mapping.value_range, mapping.rate_range
            )
            for mapping in self._encoders
        }

    def decode(self, rates, t=0.0, seq=0, frame_id="world", mode="active"):
        """The command that the rates stand for [NCP-CODEC-009]."""
        channels = {}
        for mapping in self._decoders:
            value = channels.setdefault(mapping.channel, ChannelValue())
            value.data += [0.0] * (mapping.component + 1 - len(value.data))  # [NCP-CODEC-010]
            value.data[mapping.component] = _mapped(  # [NCP-CODEC-003] [NCP-CODEC-004]
                rates.get(mapping.population), mapping.rate_range, mapping.value_range
            )
            value.unit = mapping.unit if value.unit is None else value.unit  # [NCP-CODEC-011]
        return CommandFrame(t=t, seq=seq, frame_id=frame_id, mode=mode, channels=channels)


def default_uav():
    """The default UAV codec [NCP-CODEC-020]."""
    axes = list(enumerate("xyz"))
    return RateCodec(
        [Mapping("pose_error", i, f"err_{axis}", (-2.0, 2.0)) for i, axis in axes],
        [
            Mapping("velocity_setpoint", i, f"vel_{axis}", (-1.5, 1.5), unit="m/s")
            for i, axis in axes
        ],
    )


def _sample(sensor, mapping):
    """The component that a mapping names, or None when it is not there."""
    value = None if sensor is None else sensor.channels.get(mapping.channel)
    if value is None or mapping.component >= len(value.data):
        return None
    return value.data[mapping.component]


def _mapped(x, source, target):
    """`x` of the source range in the target range; its middle where nothing better is known."""
    low, high = source
    begin, end = target
    length = high - low
    if x is None or not isfinite(x) or length == 0 or not isfinite(length):
        # [NCP-CODEC-005] [NCP-CODEC-006] [NCP-CODEC-007] Halves of subnormals would round.
        both = begin + end
        return both / 2 if isfinite(both) else begin / 2 + end / 2
    part = min(max((x - low) / length, 0.0), 1.0)
    span = end - begin
    # A span that overflows is not multiplied: 0 times infinity is no number, and no clamp mends it.
    value = begin + part * span if isfinite(span) else begin * (1.0 - part) + end * part
    return min(max(value, min(target)), max(target))
