"""The control loop (section 10.2 of the text)."""

from math import isfinite
from time import perf_counter

from .errors import ConfigError
from .messages import ControlStatus


class ControlLoop:
    """Ties a controller to the governor and the link monitor.

    `controller` has `step(sensor)`. The loop has no clock of its own: who drives it says the time,
    in seconds. A transport sends what `tick` gives, in its order [NCP-CTRL-020].
    """

    def __init__(self, period_ms, controller, governor, monitor):
        if not isfinite(period_ms) or period_ms <= 0:
            raise ConfigError("the period is not finite and positive")  # [NCP-CTRL-010]
        self._period_ms = period_ms
        self._controller = controller
        self._governor = governor
        self._monitor = monitor
        self._sensor = None
        self._sensor_s = None
        self._ticks = 0

    def on_sensor(self, sensor, now_s):
        """A sensor frame arrived."""
        self._monitor.on_frame(sensor.seq)  # [NCP-RES-053]
        if self._sensor is None or _is_newer(sensor, self._sensor):
            self._sensor = sensor  # [NCP-CTRL-011]
            self._sensor_s = now_s  # [NCP-CTRL-012]

    def tick(self, now_s):
        """One tick: the command to send and the status of it."""
        started = perf_counter()
        wish = self._controller.step(self._sensor)
        wish.t = now_s
        wish.seq = 0 if self._sensor is None else self._sensor.seq  # [NCP-CTRL-013]
        wish.ttl_ms = max(wish.ttl_ms, 2.0 * self._period_ms)  # [NCP-CTRL-014]
        self._governor.note_link(self._monitor.state().burst)  # [NCP-CTRL-016]
        command = self._governor.govern(wish, now_s, self._sensor, self._sensor_s)  # [NCP-CTRL-015]
        self._ticks += 1
        latency_ms = (perf_counter() - started) * 1000.0
        status = ControlStatus(  # [NCP-CTRL-017]
            seq=self._ticks,
            t=now_s,
            mode=command.mode,
            loop_latency_ms=latency_ms,
            safety_ok=command.mode == "active" or wish.mode != "active",  # [NCP-CTRL-018] [NCP-CTRL-021]
            note="the tick overran its period" if latency_ms > self._period_ms else None,  # [NCP-CTRL-019]
        )
        return command, status

    def reset(self):
        """Resets the governor."""
        self._governor.reset()


def _is_newer(sensor, held):
    """Newer by `seq`, or by `t` while neither is stamped."""
    if sensor.seq == 0 and held.seq == 0:
        return sensor.t > held.t
    return sensor.seq > held.seq
