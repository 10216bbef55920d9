"""The plant's deadline and its watchdog (section 8.1 of the text)."""

from math import isfinite

MAX_TTL_MS = 60_000.0
"""The longest time for which a plant acts upon one command, ms."""


def enforced_ttl_ms(ttl_ms):
    """The ttl that a plant enforces, or None for a ttl that is no time [NCP-RES-004] [NCP-RES-005]."""
    return min(ttl_ms, MAX_TTL_MS) if isfinite(ttl_ms) and ttl_ms > 0 else None


class Deadline:
    """Until when a command may be acted upon, on the plant's own clock [NCP-RES-001]."""

    def __init__(self):
        self._ttl_ms = None  # [NCP-RES-006]
        self._received_s = 0.0

    def start(self, now_s, ttl_ms):
        """A command that advances was received at `now_s`."""
        self._received_s = now_s
        self._ttl_ms = enforced_ttl_ms(ttl_ms) if isfinite(now_s) else None  # [NCP-RES-007]

    def stop(self):
        """Holds until the next start."""
        self._ttl_ms = None

    def age_s(self, now_s):
        """The age of the command, or None when the plant must hold, from then on [NCP-RES-010]."""
        if self._ttl_ms is None:
            return None
        age = now_s - self._received_s
        # [NCP-RES-002] [NCP-RES-003] [NCP-RES-007] [NCP-RES-008]
        if not isfinite(now_s) or age < 0 or age * 1000.0 > self._ttl_ms:
            self.stop()
            return None
        return age


class CommandWatchdog:
    """Tells a plant when to hold. It holds from the start on."""

    def __init__(self):
        self._deadline = Deadline()
        self._last_seq = None

    def on_command(self, now_s, ttl_ms, seq):
        """A command arrived; the deadline begins anew if it advances [NCP-RES-009]."""
        if self._last_seq is None or seq > self._last_seq:
            self._last_seq = seq
            self._deadline.start(now_s, ttl_ms)

    def should_hold(self, now_s):
        """Whether the plant must hold. Once it must, it must until a command advances."""
        return self._deadline.age_s(now_s) is None

    def reset(self):
        """Holds until a new command comes, whatever its seq [NCP-RES-011] [NCP-RES-012]."""
        self._deadline.stop()
        self._last_seq = None
