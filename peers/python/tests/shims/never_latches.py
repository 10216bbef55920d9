"""Our module with one defect: ESTOP does not stay."""

from ncp import *  # noqa: F403
from ncp import SafetyGovernor as _Governor


class SafetyGovernor:
    def __init__(self, *args):
        self._governor = _Governor(*args)

    def govern(self, *args):
        frame = self._governor.govern(*args)
        self._governor.reset()
        return frame

    def note_link(self, burst):
        self._governor.note_link(burst)

    def reset(self):
        self._governor.reset()
