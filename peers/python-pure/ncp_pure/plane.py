"""The quality of service of the four planes (section 3.1 of the text)."""

from collections import namedtuple

Qos = namedtuple("Qos", "congestion priority express")
"""`congestion` is `block` or `drop`, `priority` a Zenoh priority, `express` whether batching is off."""

PLANES = {
    "control": Qos("block", "Data", False),  # [NCP-PLANE-001]
    "perception": Qos("drop", "DataHigh", False),  # [NCP-PLANE-002]
    "action": Qos("drop", "RealTime", True),  # [NCP-PLANE-003]
    "observation": Qos("block", "Data", False),  # [NCP-PLANE-004]
}
"""The quality of service with which each plane is published on."""
