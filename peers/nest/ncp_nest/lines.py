"""The line protocol: TCP on loopback, one JSON document a line, one reply a line, in order [NCP-TRANS-003]."""

import ipaddress
import socketserver
import threading
from collections.abc import Callable, Iterator
from typing import BinaryIO

from ncp_pure import DecodeError
from ncp_pure.wire import MAX_FRAME

from .frames import error_frame

Handler = Callable[[bytes], bytes]
"""Gives the reply to a request."""


class LineServer:
    """Listens on a loopback address. Each connection has a thread of its own, and its replies are in order."""

    def __init__(self, host: str, port: int, handle: Handler) -> None:
        self._server = _Server((host, port), _Connection)
        self._server.answer = handle

    @property
    def address(self) -> tuple[str, int]:
        """Where it listens; a port of 0 has become a real one."""
        return self._server.server_address[:2]

    def serve(self) -> None:
        """Serves until `stop` is called."""
        self._server.serve_forever(poll_interval=0.1)

    def stop(self) -> None:
        """Takes no more connections. Safe in a signal handler."""
        threading.Thread(target=self._server.shutdown).start()

    def close(self) -> None:
        """Gives the address back."""
        self._server.server_close()


def parse_address(text: str) -> tuple[str, int]:
    """A loopback address, such as `127.0.0.1:28474`, or a `ValueError` that says what is wrong."""
    host, separator, port = text.rpartition(":")
    if not separator or not port.isascii() or not port.isdecimal() or int(port) > 65535:
        raise ValueError(f"{text!r} is no address HOST:PORT")
    if not ipaddress.ip_address(host).is_loopback:
        raise ValueError(f"{host} is no loopback address: who reaches this service may run anything on it")
    return host, int(port)


class _Server(socketserver.ThreadingTCPServer):
    allow_reuse_address = True
    daemon_threads = True
    block_on_close = False
    request_queue_size = 64
    answer: Handler


class _Connection(socketserver.StreamRequestHandler):
    disable_nagle_algorithm = True

    def handle(self) -> None:
        try:
            for line in _lines(self.rfile):
                reply = error_frame(line) if isinstance(line, Exception) else self.server.answer(line)
                self.wfile.write(reply + b"\n")
        except OSError:
            return  # the other side is gone


def _lines(stream: BinaryIO) -> Iterator[bytes | Exception]:
    """The lines of a stream without their ends; an error stands for one that is too long for any request.

    What the stream ends with, without a line feed, was cut short, and is no line.
    """
    while line := stream.readline(MAX_FRAME + 1):
        if line.endswith(b"\n"):
            yield line[:-1]
        elif len(line) > MAX_FRAME:
            while line and not line.endswith(b"\n"):
                line = stream.readline(MAX_FRAME)
            yield DecodeError("limit", f"a line of more than {MAX_FRAME} bytes")
