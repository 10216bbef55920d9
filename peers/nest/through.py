"""The ways through the gateway to a service, for tests and measurements: clients that are not the project's own."""

import json
import os
import signal
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import zenoh
from websockets.sync.client import connect

Ask = Callable[[str, bytes], bytes]
"""What a client asks by: the key and the request's bytes, for the reply's bytes."""


@contextmanager
def gateway(program: str, service: tuple[str, int], patience_s: float) -> Iterator[tuple[str, str]]:
    """A gateway before a service, which is the Zenoh router as well; where it answers Zenoh, and WebSocket."""
    bus, websocket, http = (_free_address() for _ in range(3))
    listens = {"mode": "router", "listen": {"endpoints": [f"tcp/{bus}"]}, "scouting": {"multicast": {"enabled": False}}}
    with tempfile.TemporaryDirectory() as folder:
        config = Path(folder) / "zenoh.json5"
        config.write_text(json.dumps(listens))
        settings = {
            "NCP_BRIDGE_ADDR": "{}:{}".format(*service),
            "NCP_ZENOH_CONFIG": str(config),
            "NCP_WS_ADDR": websocket,
            "NCP_HTTP_ADDR": http,
            "NCP_BRIDGE_TIMEOUT_MS": str(int(patience_s * 1000)),
            "NCP_QUERY_TIMEOUT_MS": str(int(patience_s * 1000) + 1),
        }
        process = subprocess.Popen([program], env={**os.environ, **settings})
        try:
            _wait_until_healthy(process, f"http://{http}/healthz", patience_s)
            yield bus, websocket
        finally:
            process.send_signal(signal.SIGTERM)
            code = process.wait(patience_s)
    if code:
        raise RuntimeError(f"the gateway ended with {code}")


@contextmanager
def over_zenoh(address: str, patience_s: float) -> Iterator[Ask]:
    """Asks as a Zenoh client, with the quality of service of the control plane [NCP-PLANE-001]."""
    connects = {
        "mode": "client",
        "connect": {"endpoints": [f"tcp/{address}"]},
        "scouting": {"multicast": {"enabled": False}},
    }
    with zenoh.open(zenoh.Config.from_json5(json.dumps(connects))) as session:

        def ask(key: str, frame: bytes) -> bytes:
            qos = {"congestion_control": zenoh.CongestionControl.BLOCK, "priority": zenoh.Priority.DATA}
            [reply] = session.get(key, payload=frame, timeout=patience_s, **qos)
            return reply.ok.payload.to_bytes()

        yield ask


@contextmanager
def over_websocket(address: str, patience_s: float) -> Iterator[Ask]:
    """Asks as a WebSocket client."""
    with connect(f"ws://{address}", max_size=None) as connection:

        def ask(_: str, frame: bytes) -> bytes:
            connection.send(frame)
            return connection.recv(patience_s, decode=False)

        yield ask


def _free_address() -> str:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return "{}:{}".format(*free.getsockname())


def _wait_until_healthy(process: subprocess.Popen, url: str, patience_s: float) -> None:
    begin = time.monotonic()
    while time.monotonic() - begin < patience_s:
        if process.poll() is not None:
            raise RuntimeError(f"the gateway ended with {process.returncode} at its start")
        try:
            urllib.request.urlopen(url).close()
            return
        except (urllib.error.URLError, ConnectionError):
            time.sleep(0.05)
    raise TimeoutError(f"{url} does not answer")
