#!/usr/bin/env python3
"""A peer to copy: replace the functions under CALLS by calls of your implementation.

Run it with:  ncp-verify run --peer-cmd 'python3 peers/PROTOCOL-starter.py'
It answers a few calls of an observer with the standard library, so that you see a run; the report
names what is still to be filled in, and the calls that are `unsupported`. The page PROTOCOL.md
explains each call.
"""

import base64
import json
import math
import sys


class Refused(Exception):
    """The implementation refused, for the reason that the code names (PROTOCOL.md, section 5)."""

    def __init__(self, code, message):
        super().__init__(message)
        self.code = code


class Unsupported(Exception):
    """The implementation has no such function."""


# --- values that JSON lacks (PROTOCOL.md, section 2) ---------------------------------------------


def double_in(value):
    """A double of a request: a number, or "NaN", "Infinity", "-Infinity", "-0"."""
    return float(value)


def double_out(value):
    """A double of an answer."""
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "Infinity" if value > 0 else "-Infinity"
    if value == 0 and math.copysign(1, value) < 0:
        return "-0"
    return value


def frame_in(args):
    """The bytes of the frame, exactly as they would have arrived."""
    if "base64" in args:
        return base64.b64decode(args["base64"])
    return args["text"].encode("utf-8", "surrogatepass")


# --- the calls: put your implementation here -----------------------------------------------------


def describe(_args):
    return {
        "name": "starter",
        "version": "0",
        "language": "Python",
        # as the implementation states them: my_ncp.WIRE_VERSION, my_ncp.CONTRACT_HASH
        "wire_version": "?",
        "contract_hash": "?",
        "roles": ["observer"],
    }


def contract_status(args):
    # my_ncp.contract_status(args["peer_hash"])
    peer_hash = args["peer_hash"]
    if peer_hash is None:
        return {"status": "not_advertised"}
    return {"status": "match" if peer_hash == describe({})["contract_hash"] else "mismatch"}


def decode(args):
    # try:    return {"text": my_ncp.validate(args["kind"], frame_in(args))}
    # except my_ncp.FrameError as error:    raise Refused("invalid", str(error))
    frame_in(args)
    raise Unsupported


CALLS = {
    "describe": describe,
    "contract.status": contract_status,
    "decode": decode,
}


# --- the conversation (PROTOCOL.md, section 1): nothing to change below --------------------------


def answer(request):
    call = CALLS.get(request["call"])
    if call is None:
        return {"unsupported": True}
    try:
        return {"result": call(request["args"])}
    except Unsupported:
        return {"unsupported": True}
    except Refused as refused:
        return {"error": {"code": refused.code, "message": str(refused)}}
    except Exception as crash:  # an exception that the API does not document is a crash
        return {"error": {"code": "internal", "message": repr(crash)}}


def main():
    for line in sys.stdin.buffer:
        request = json.loads(line)
        reply = {"id": request["id"], **answer(request)}
        sys.stdout.write(json.dumps(reply, allow_nan=False) + "\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
