"""The safety governor at the end of the commander's control loop (chapter 7 of the text)."""

from math import frexp, hypot, isfinite, ldexp, nextafter

from .messages import ChannelSpec, ChannelValue, CommandFrame
from .watchdog import enforced_ttl_ms

POSITION = "pose_position"
"""The sensor channel on which the geofence acts [NCP-SAFE-010]."""

VELOCITY = "velocity_setpoint"
"""The command channel on which the speed limit acts [NCP-SAFE-011]."""

TINY = 2.0**-500
"""Far above the subnormal doubles, and far below what moves."""

POSITION_UNIT = "m"
VELOCITY_UNIT = "m/s"
WIDTH = 3

CANONICAL_SENSORS = (ChannelSpec(name=POSITION, kind="vec3", unit=POSITION_UNIT),)
CANONICAL_COMMANDS = (ChannelSpec(name=VELOCITY, kind="vec3", unit=VELOCITY_UNIT),)


class SafetyGovernor:
    """Lets a command pass only when it is safe by all that is known.

    It is built from `SafetyLimits` and the channels that were negotiated, by default the canonical
    ones. `estopped` tells whether ESTOP is latched, `failed_closed` whether the limits are such
    that it holds for ever [NCP-SAFE-018].
    """

    def __init__(self, limits, sensor_channels=CANONICAL_SENSORS, command_channels=CANONICAL_COMMANDS):
        self._timeout_ms = limits.command_timeout_ms
        self._commands = {spec.name: spec for spec in reversed(command_channels)}
        self._sensors = {spec.name: spec for spec in reversed(sensor_channels)}
        # `max_tilt_rad` is the plant's matter [NCP-SAFE-019].
        self._max_speed = limits.max_speed_mps or None  # [NCP-SAFE-012]
        self._radius = limits.geofence_radius_m or None
        self.estopped = False
        self.failed_closed = _is_bad(
            self._max_speed, VELOCITY, VELOCITY_UNIT, command_channels
        ) or _is_bad(self._radius, POSITION, POSITION_UNIT, sensor_channels)

    def note_link(self, burst):
        """Latches ESTOP on a burst [NCP-SAFE-006], and does nothing otherwise [NCP-SAFE-007]."""
        self.estopped = self.estopped or burst

    def reset(self):
        """Clears the latch [NCP-SAFE-008], and nothing else [NCP-SAFE-009]."""
        self.estopped = False

    def govern(self, command, now_s, sensor=None, last_sensor_s=None):
        """The frame to send for a command: itself, clamped and truncated, or a HOLD or an ESTOP.

        `now_s` and `last_sensor_s`, the time at which `sensor` was received, are on one clock.
        """
        # The order of the gates is that of section 7.3 [NCP-SAFE-020].
        if self.estopped or command.mode == "estop":  # [NCP-SAFE-003] [NCP-SAFE-005]
            return self._estop(command)
        if self.failed_closed:  # [NCP-SAFE-017]
            return self._stopped(command, "hold")
        if self._is_stale(now_s, last_sensor_s):
            return self._stopped(command, "hold")
        position = None
        if self._radius is not None:
            position = self._position(sensor)
            if position is None:
                return self._stopped(command, "hold")
            if not _within(position, self._radius):  # [NCP-SAFE-043] [NCP-SAFE-044] [NCP-SAFE-045]
                return self._estop(command)
        if command.mode != "active":  # [NCP-SAFE-002]
            return self._stopped(command, "hold")
        governed = self._clamped(command)
        if governed is not None and position is not None:
            governed = self._fenced(governed, position)
        return self._stopped(command, "hold") if governed is None else governed

    def _estop(self, command):
        self.estopped = True  # [NCP-SAFE-004]
        return self._stopped(command, "estop")

    def _stopped(self, command, mode):
        """The HOLD or ESTOP frame of section 7.7 that stands for a command."""
        channels = {
            name: ChannelValue(data=[0.0] * len(value.data), unit=value.unit)  # [NCP-SAFE-072]
            for name, value in command.channels.items()
        }
        for name in self._commands:  # [NCP-SAFE-071] [NCP-SAFE-073]
            if name not in channels and name == VELOCITY:
                channels[name] = ChannelValue(data=[0.0] * WIDTH, unit=VELOCITY_UNIT)
            elif name not in channels:
                channels[name] = ChannelValue(data=[0.0])
        return CommandFrame(  # [NCP-SAFE-070] [NCP-SAFE-074]
            t=command.t,
            seq=command.seq,
            frame_id=command.frame_id,
            ttl_ms=command.ttl_ms,
            mode=mode,
            channels=channels,
        )

    def _is_stale(self, now_s, last_s):
        if last_s is None or not isfinite(now_s) or not isfinite(last_s):
            return True  # [NCP-SAFE-030] [NCP-SAFE-031]
        if not isfinite(self._timeout_ms) or self._timeout_ms <= 0:
            return True  # [NCP-SAFE-032]
        # [NCP-SAFE-033] [NCP-SAFE-034] [NCP-SAFE-035]
        return now_s < last_s or (now_s - last_s) * 1000.0 > self._timeout_ms

    def _position(self, sensor):
        """The position of a sensor frame, or None when it is missing [NCP-SAFE-040] [NCP-SAFE-041]."""
        value = None if sensor is None else sensor.channels.get(POSITION)
        if value is None or len(value.data) != WIDTH:
            return None
        return value.data if _unit(POSITION, value, self._sensors) == POSITION_UNIT else None

    def _velocity(self, channels):
        """The velocity of a tick, or None when there is no usable one [NCP-SAFE-052] [NCP-SAFE-063]."""
        value = channels.get(VELOCITY)
        if value is None or len(value.data) != WIDTH or not all(map(isfinite, value.data)):
            return None
        return value.data if _unit(VELOCITY, value, self._commands) == VELOCITY_UNIT else None

    def _clamped(self, command):
        """The command within the speed limit, its horizon cut off where it must be; None for a HOLD."""
        channels = self._clamp_tick(command.channels)
        if channels is None:  # [NCP-SAFE-063] [NCP-SAFE-064]
            return None
        dt_ms = command.horizon_dt_ms
        if command.horizon and (dt_ms is None or not isfinite(dt_ms) or dt_ms <= 0):
            return None  # [NCP-SAFE-068]
        horizon = []
        for tick in command.horizon:  # [NCP-SAFE-066]
            tick = self._clamp_tick(tick)
            if tick is None:
                break  # [NCP-SAFE-067]
            horizon.append(tick)
        return command.replace(channels=channels, horizon=horizon)

    def _clamp_tick(self, channels):
        """The channels of a tick within the speed limit; None when that cannot be."""
        if not all(isfinite(x) for value in channels.values() for x in value.data):
            return None
        if self._max_speed is None:
            return channels
        if self._velocity(channels) is None:
            return None
        return {
            name: ChannelValue(data=_scaled(value.data, self._max_speed), unit=value.unit)
            if _unit(name, value, self._commands) == VELOCITY_UNIT  # [NCP-SAFE-065]
            else value
            for name, value in channels.items()
        }

    def _fenced(self, command, position):
        """The command with its horizon truncated so that its path stays within the fence; None for a HOLD."""
        ttl_ms = enforced_ttl_ms(command.ttl_ms)
        ttl = 0.0 if ttl_ms is None else ttl_ms / 1000.0
        velocity = self._velocity(command.channels)
        if velocity is None:
            return None  # [NCP-SAFE-052]
        horizon = self._horizon_within(command, position, velocity, ttl)
        if horizon is None:
            return None
        if not horizon and not _within(_moved(position, velocity, ttl), self._radius):
            return None  # [NCP-SAFE-051] [NCP-SAFE-053]
        return command.replace(horizon=horizon)

    def _horizon_within(self, command, position, velocity, ttl):
        """The steps of the horizon before the first that ends outside [NCP-SAFE-050].

        None when tick 0 of a command with a horizon ends outside [NCP-SAFE-051].
        """
        horizon = []
        if not command.horizon:
            return horizon
        dt = command.horizon_dt_ms / 1000.0
        reached = position
        for k, tick in enumerate([command.channels, *command.horizon]):
            velocity = self._velocity(tick)
            if velocity is None:
                break  # [NCP-SAFE-055]
            reached = _moved(reached, velocity, max(0.0, min((k + 1) * dt, ttl) - k * dt))
            if not _within(reached, self._radius):
                if k == 0:
                    return None
                break
            if k > 0:
                horizon.append(tick)
        return horizon


def _is_bad(limit, name, unit, channels):
    """Whether a limit that is not 0 puts the governor into config fail-closed."""
    if limit is None:
        return False
    if not isfinite(limit) or limit < 0:
        return True  # [NCP-SAFE-013]
    declared = [spec for spec in channels if spec.name == name]
    # [NCP-SAFE-014] [NCP-SAFE-015] [NCP-SAFE-016]
    return not declared or any(spec.unit != unit or not _is_wide(spec) for spec in declared)


def _is_wide(spec):
    """Whether a channel is declared with three components [NCP-SAFE-016]."""
    return (spec.kind, spec.size) in (("vec3", None), ("vec3", WIDTH), ("array", WIDTH))


def _unit(name, value, negotiated):
    """The unit of a channel, the negotiated one where it says none [NCP-SAFE-042]."""
    if value.unit is None and name in negotiated:
        return negotiated[name].unit
    return value.unit


def _within(point, radius):
    """Whether a point lies in the closed ball. NaN and overflow do not [NCP-SAFE-043] [NCP-SAFE-045]."""
    if radius < TINY:  # a power of two changes no digit, and gives the norm those that it lacks down here
        point, radius = [x / TINY for x in point], radius / TINY
    return hypot(*point) <= radius and all(map(isfinite, point))


def _moved(point, velocity, seconds):
    return [x + v * seconds for x, v in zip(point, velocity)]


def _scaled(velocity, limit):
    """A finite velocity, scaled to the limit if it is above [NCP-SAFE-060] [NCP-SAFE-061] [NCP-SAFE-062]."""
    if hypot(*velocity) <= limit:
        return velocity
    if not limit > 0:  # nothing is within such a limit but standing still
        return [0.0] * len(velocity)
    largest = max(map(abs, velocity))
    direction = [x / largest for x in velocity]  # so that no norm overflows
    length = hypot(*direction)
    scale = limit / length
    scaled = _times(velocity, scale, largest)
    while hypot(*scaled) > limit:  # by a rounding
        scale = nextafter(scale, 0.0)
        scaled = _times(velocity, scale, largest)
    return scaled


def _times(velocity, scale, largest):
    """Each component times scale / largest, a quotient that itself may leave the doubles."""
    (over, up), (under, down) = frexp(scale), frexp(largest)
    parts = map(frexp, velocity)
    return [ldexp(digits * over / under, exponent + up - down) for digits, exponent in parts]
