"""A module that prints where answers go, and crashes in every way."""

import os
import subprocess
import sys

from ncp import CONTRACT_HASH, NCP_VERSION, validate

print("imported")
print("to the original", file=sys.__stdout__, flush=True)
os.write(1, b"to the descriptor\n")


class PanicException(BaseException):
    """What PyO3 raises for a panic of Rust."""


def check_version(version, strict=False):
    subprocess.run(["echo", "from a child"], check=True)
    print(version)
    crash = {
        "panic": lambda: PanicException("boom"),
        "exit": lambda: SystemExit(3),
        "type": lambda: TypeError("no"),
        "deep": lambda: RecursionError("deep"),
        "value": lambda: ValueError("bad"),
    }.get(version)
    if crash:
        raise crash()
    return True
