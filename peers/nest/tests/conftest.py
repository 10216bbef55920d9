"""The real service, started once for all tests, and clients that talk with it over its line protocol."""

import itertools
import os
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

import ncp_pure as ncp
import pytest

ANSWER_S = 600.0
"""How long a test waits for an answer: a deadline for a loaded machine, not an expectation."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--gateway", metavar="PROGRAM", help="the program ncp-gateway, to go through it too")


class Connection:
    """A connection to a service."""

    def __init__(self, address: tuple[str, int]) -> None:
        self._socket = socket.create_connection(address, timeout=ANSWER_S)
        self._lines = self._socket.makefile("rb")

    def ask(self, request: bytes | str) -> bytes:
        """The line that answers a line."""
        self.send(request)
        return self.answer()

    def send(self, request: bytes | str, end: bytes = b"\n") -> None:
        """Sends a line without waiting for its answer."""
        self._socket.sendall((request.encode() if isinstance(request, str) else request) + end)

    def answer(self) -> bytes:
        """The next line, or nothing when the service has closed the connection."""
        return self._lines.readline()

    def end(self) -> None:
        """Says that nothing more is sent."""
        self._socket.shutdown(socket.SHUT_WR)

    def close(self) -> None:
        self._lines.close()
        self._socket.close()


class Service:
    """A running service."""

    def __init__(self, process: subprocess.Popen, address: tuple[str, int]) -> None:
        self.process = process
        self.address = address

    def connect(self) -> Connection:
        return Connection(self.address)


@contextmanager
def running(*options: str) -> Iterator[Service]:
    """A service on a free port, ended at the end."""
    command = [sys.executable, "-m", "ncp_nest", "--listen", "127.0.0.1:0", *options]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env={**os.environ, "PYTHONUNBUFFERED": "1"})
    try:
        host, port = process.stdout.readline().removeprefix("listening on ").rsplit(":", 1)
        yield Service(process, (host, int(port)))
    finally:
        process.terminate()
        process.wait(ANSWER_S)
        process.stdout.close()


@pytest.fixture(scope="session")
def service() -> Iterator[Service]:
    with running() as started:
        yield started


@pytest.fixture
def connection(service: Service) -> Iterator[Connection]:
    opened = service.connect()
    yield opened
    opened.close()


NAMES = (f"s{number}" for number in itertools.count())


@pytest.fixture
def client(connection: Connection) -> Iterator[Callable[[], ncp.Client]]:
    """Makes clients, each of a session of its own, which are closed at the end."""
    with clients(lambda _, frame: connection.ask(frame)) as make:
        yield make


@contextmanager
def clients(ask: Callable[[str, bytes], bytes]) -> Iterator[Callable[[], ncp.Client]]:
    """Makes clients that ask in this way, which are closed at the end."""
    made = []

    def make() -> ncp.Client:
        made.append(ncp.Client(ask, next(NAMES)))
        return made[-1]

    yield make
    for opened in made:
        with suppress(ncp.NcpError):  # the test closed it, or lost it
            opened.close()


def drive(session: ncp.Client, **values: list[float]) -> ncp.StimulusFrame:
    """A stimulus frame of values by port."""
    channels = {port: ncp.ChannelValue(data=data) for port, data in values.items()}
    return ncp.StimulusFrame(session_id=session.session_id, values=channels)


class Samples:
    """The samples of one port over several frames."""

    def __init__(self, frames: list[ncp.ObservationFrame], port: str) -> None:
        records = [frame.records[port] for frame in frames]
        self.times = [time for record in records for time in record.times]
        self.senders = [sender for record in records for sender in record.senders]
        self.values = [value for record in records for value in record.values]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Samples) and vars(self) == vars(other)
