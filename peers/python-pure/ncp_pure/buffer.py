"""The plant's action buffer (sections 8.2 and 12.1 of the text)."""

from math import floor, isfinite

from .errors import DecodeError
from .estop import is_estop
from .messages import CommandFrame
from .watchdog import Deadline
from .wire import decode

MAX_HORIZON = 4096
"""The most items that a frame may have."""


def max_horizon_len(ttl_ms, dt_ms):
    """How many ticks of `dt_ms` a command of `ttl_ms` can use [NCP-RES-033] [NCP-RES-034]."""
    if not (isfinite(ttl_ms) and ttl_ms > 0 and isfinite(dt_ms) and dt_ms > 0):
        return 0
    ticks = ttl_ms / dt_ms
    return floor(ticks) if ticks < MAX_HORIZON else MAX_HORIZON


class ActionBuffer:
    """Keeps the newest command and replays its horizon.

    `estopped` tells whether ESTOP is latched. A `strict` plant keeps section 12.1 too.
    """

    def __init__(self, *, strict=False):
        self._strict = strict
        self.reset()

    def reset(self):
        """Clears the latch, the held command and the last seq; nothing moves [NCP-RES-030] [NCP-RES-031]."""
        self.estopped = False
        self._command = None
        self._last_seq = None
        self._deadline = Deadline()

    def on_frame(self, frame, now_s):
        """A command frame arrived as bytes. Whether it was obeyed; a `DecodeError` if it is none.

        An ESTOP latches before anything else is looked at [NCP-RES-022] [NCP-STRICT-010].
        """
        if is_estop(frame):
            self.estopped = True
        return self.on_command(decode(CommandFrame.KIND, frame, strict=self._strict), now_s)

    def on_command(self, command, now_s):
        """A decoded command arrived. Whether it was obeyed."""
        if command.mode == "estop":  # [NCP-RES-021]
            self.estopped = True
            return True
        advances = self._last_seq is None or command.seq > self._last_seq
        if self._strict and command.seq < 1:  # [NCP-STRICT-004]
            raise DecodeError("value", "a strict plant needs at least 1").within("seq")
        if command.mode == "active":
            if not advances:
                return False  # [NCP-RES-020] [NCP-RES-032]
            self._last_seq = command.seq
            self._command = command
            self._deadline.start(now_s, command.ttl_ms)
            return True
        # A HOLD, which refreshes no deadline [NCP-RES-024].
        if not advances and (self._strict or command.seq not in (0, self._last_seq)):
            return False  # [NCP-STRICT-005]
        self._command = None  # [NCP-RES-023]
        if advances and command.seq != 0:
            self._last_seq = command.seq
        return True

    def active(self, now_s):
        """The channels to act upon at `now_s`, or None when the plant holds [NCP-RES-025]."""
        if self.estopped or self._command is None:
            return None
        age = self._deadline.age_s(now_s)
        if age is None:
            return None
        tick = self._tick(age)
        if tick == 0:
            return self._command.channels  # [NCP-RES-026]
        if tick > len(self._command.horizon):
            self._deadline.stop()  # [NCP-RES-029] [NCP-RES-010]
            return None
        return self._command.horizon[tick - 1]

    def _tick(self, age_s):
        """The tick of the held command at an age [NCP-RES-027] [NCP-RES-028]."""
        dt_ms = self._command.horizon_dt_ms
        if not self._command.horizon or dt_ms is None or not isfinite(dt_ms) or dt_ms <= 0:
            return 0
        ticks = age_s * 1000.0 / dt_ms
        return floor(ticks) if ticks < MAX_HORIZON + 1 else MAX_HORIZON + 1
