"""The reflex controller (section 10.1 of the text)."""

from fractions import Fraction
from math import isfinite

from .errors import ConfigError
from .messages import ChannelValue, CommandFrame

POSITION = "pose_position"
VELOCITY = "pose_velocity"
OUTPUT = "velocity_setpoint"
UNIT = "m/s"


class ReflexController:
    """A proportional controller with damping [NCP-CTRL-002]."""

    def __init__(self, target=(0.0, 0.0, 0.0), kp=1.0, kd=0.3, max_speed=1.5):
        # [NCP-CTRL-005]
        if len(target) != 3 or not all(map(isfinite, target)):
            raise ConfigError("the target is not three finite numbers")
        for name, value in (("kp", kp), ("kd", kd), ("max_speed", max_speed)):
            if not isfinite(value) or value < 0:
                raise ConfigError(f"{name} is negative or not finite")
        self._target = tuple(target)
        self._kp = kp
        self._kd = kd
        self._max_speed = max_speed

    def step(self, sensor):
        """The command for a sensor frame, or for None."""
        position = _vector(sensor, POSITION)
        if position is None:
            mode, data = "hold", [0.0] * 3  # [NCP-CTRL-003]
        else:
            velocity = _vector(sensor, VELOCITY) or [0.0] * 3  # [NCP-CTRL-004]
            mode, data = "active", list(map(self._axis, position, self._target, velocity))
        command = CommandFrame(mode=mode, channels={OUTPUT: ChannelValue(data=data, unit=UNIT)})
        if sensor is not None:
            command.seq = sensor.seq
            command.frame_id = sensor.frame_id
        return command

    def _axis(self, p, target, v):
        """[NCP-CTRL-001] One axis, also where a part of the sum is beyond a double."""
        u = -self._kp * (p - target) - self._kd * v
        if not isfinite(u):
            u = -Fraction(self._kp) * (Fraction(p) - Fraction(target)) - Fraction(self._kd) * Fraction(v)
        return float(min(max(u, -self._max_speed), self._max_speed))


def _vector(sensor, name):
    """A channel that is 3 wide and finite, or None."""
    value = None if sensor is None else sensor.channels.get(name)
    usable = value is not None and len(value.data) == 3 and all(map(isfinite, value.data))
    return value.data if usable else None
