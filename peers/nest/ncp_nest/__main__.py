"""Serves NCP sessions over NEST to a line bridge.

The address is that of --listen, of NCP_BRIDGE_ADDR, or 127.0.0.1:28474, and on loopback. A port of 0 takes a free
one. The first line of standard output says where it listens. SIGTERM and SIGINT end it, with its sessions.
"""

import argparse
import logging
import os
import signal
import sys

from .frames import BACKEND
from .lines import LineServer, parse_address
from .service import MAX_SESSIONS, SessionService


def main() -> int:
    """Runs the program; its exit code."""
    options = _options()
    logging.basicConfig(level=logging.INFO, format="%(levelname)s %(name)s: %(message)s", stream=sys.stderr)
    try:
        host, port = parse_address(options.listen)
        service = SessionService(options.threads, options.sessions)
        server = LineServer(host, port, service.handle)
    except (OSError, ValueError) as error:
        print(f"cannot listen: {error}", file=sys.stderr)
        return 2
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: server.stop())
    print("listening on {}:{}".format(*server.address), flush=True)
    try:
        server.serve()
    finally:
        server.close()
        service.close()
    return 0


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m ncp_nest",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=BACKEND)
    address = os.environ.get("NCP_BRIDGE_ADDR", "127.0.0.1:28474")
    parser.add_argument("--listen", metavar="HOST:PORT", default=address, help="where to listen")
    parser.add_argument("--threads", type=_positive, default=1, help="threads of each NEST kernel (1)")
    parser.add_argument("--sessions", type=_positive, default=MAX_SESSIONS, help=f"sessions at a time ({MAX_SESSIONS})")
    return parser.parse_args()


def _positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return number


if __name__ == "__main__":
    sys.exit(main())
