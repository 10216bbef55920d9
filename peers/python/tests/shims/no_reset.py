"""Someone's module whose watchdog has no reset."""

import ncp


class CommandWatchdog:
    def __init__(self):
        self._watchdog = ncp.CommandWatchdog()

    def on_command(self, now_s, ttl_ms, seq):
        return self._watchdog.on_command(now_s, ttl_ms, seq)

    def should_hold(self, now_s):
        return self._watchdog.should_hold(now_s)
