"""The Python peer of this project with the defects that are named: as somebody else would have made them.

It is a peer in another language than the one in which the fault dictionary was made, with the same defects.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "peers" / "python-pure"))

import adapter
from ncp_pure import governor, jsontext
from ncp_pure.governor import SafetyGovernor

INBOUND = SafetyGovernor.govern


def estop_not_latched():
    """An ESTOP that comes in is passed on, but not latched; a breach of the fence still is."""

    def govern(self, command, now_s, sensor=None, last_sensor_s=None):
        if command.mode == "estop" and not self.estopped:
            return self._stopped(command, "estop")
        return INBOUND(self, command, now_s, sensor, last_sensor_s)

    SafetyGovernor.govern = govern


def governor_reset_ignored():
    """`reset` does not clear the latch: hidden wherever the latch is not set in the first place."""
    SafetyGovernor.reset = lambda self: None


def repeated_member_anywhere():
    """Of two members of one name the last counts, wherever they stand."""
    jsontext._object = dict


def half_speed():
    """The speed is limited to half of the limit, which is no defect of the dictionary."""
    scaled = governor._scaled
    governor._scaled = lambda velocity, limit: scaled(velocity, limit / 2)


for defect in sys.argv[1:]:
    globals()[defect.replace("-", "_")]()
adapter.main()
