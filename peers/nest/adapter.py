"""The adapter of the NEST service: the session calls of peers/PROTOCOL.md go to it, the others to `ncp_pure`.

It answers as a server, which the service is. Frames are read and written by `ncp_pure` in the service, too.
"""

import importlib.util
import os
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import ncp_pure as ncp

from ncp_nest.frames import BACKEND
from ncp_nest.service import SessionService


def main() -> None:
    """Reads requests from standard input until its end, and answers each in its turn."""
    pure = _adapter_of_ncp_pure()
    pure.CALLS.update({"describe": describe, "session.run": session_run})
    with os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what a simulator prints goes to the log
        for line in sys.stdin.buffer:
            if line.strip():
                answers.write(pure.answer(line) + b"\n")
                answers.flush()


def describe(_: dict[str, Any]) -> dict[str, Any]:
    """Who answers. The reference networks are opened, and not claimed: README.md says why."""
    return {
        "name": "nest",
        "version": BACKEND,
        "language": "Python",
        "wire_version": ncp.WIRE_VERSION,
        "contract_hash": ncp.CONTRACT_HASH,
        "roles": ["server"],
    }


def session_run(args: dict[str, Any]) -> dict[str, list[str]]:
    """The replies of a service that was just started."""
    service = SessionService()
    try:
        requests = [request.encode("utf-8", "surrogatepass") for request in args["requests"]]
        return {"replies": [service.handle(request).decode("utf-8") for request in requests]}
    finally:
        service.close()


def _adapter_of_ncp_pure() -> ModuleType:
    path = Path(ncp.__file__).parents[1] / "adapter.py"
    spec = importlib.util.spec_from_file_location("adapter_of_ncp_pure", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


if __name__ == "__main__":
    main()
