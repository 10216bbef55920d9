"""A module with the published API and one defect: beyond the fence it holds, where it should stop."""

import json

from published_only import *  # noqa: F403
from published_only import govern as _govern


def govern(*args):
    frame = json.loads(_govern(*args))
    if frame["mode"] == "estop" and json.loads(args[1])["mode"] != "estop":
        frame["mode"] = "hold"
    return json.dumps(frame)
