"""A process with one NEST kernel, for one session: requests come through a pipe, and replies go back."""

import logging
import signal
from multiprocessing.connection import Connection
from time import monotonic

from ncp_pure import (
    CloseSession,
    EncodeError,
    NcpError,
    ObservationFrame,
    OpenSession,
    RunRequest,
    SessionClosed,
    SessionOpened,
    StepRequest,
    encode,
)

from .frames import BACKEND, Reply, Request, error_frame, refusal
from .simulation import Lost, Simulation


def serve(connection: Connection, threads: int) -> None:
    """Serves one session until it is closed, or until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the service decides when a session ends
    session = Session(threads)
    try:
        while True:
            reply = session.handle(connection.recv())
            connection.send(reply)
            if not reply.open:
                return
    except (EOFError, OSError):
        return
    finally:
        session.close()


class Session:
    """One session: opened first, then stepped and run, then closed."""

    def __init__(self, threads: int) -> None:
        self._threads = threads
        self._simulation: Simulation | None = None
        self._seq = 0

    def handle(self, request: Request) -> Reply:
        """Answers a request [NCP-SESS-020]."""
        if isinstance(request, OpenSession):
            return self._open(request)
        if isinstance(request, CloseSession):
            return Reply(encode(SessionClosed(session_id=request.session_id)), False)  # [NCP-SESS-028]
        try:
            return Reply(self._advance(request), True)
        except Lost as error:
            return Reply(error_frame(error, request.session_id), False)
        except NcpError as error:
            return Reply(error_frame(error, request.session_id), True)  # [NCP-SESS-037]
        except Exception as error:  # [NCP-SESS-037] whatever it was, it costs this request only
            logging.getLogger(__name__).exception("a request failed")
            return Reply(error_frame(error, request.session_id), True)

    def close(self) -> None:
        """Ends the simulation, if there is one."""
        if self._simulation is not None:
            self._simulation.close()

    def _open(self, request: OpenSession) -> Reply:
        try:
            simulation = Simulation(request, self._threads)
            opened = SessionOpened(
                session_id=request.session_id,
                backend=BACKEND,
                resolved=simulation.network.resolved,
                provenance=simulation.provenance,  # [NCP-SESS-039]
            )
            frame = encode(opened)
        except Exception as error:
            if not isinstance(error, NcpError):
                logging.getLogger(__name__).exception("a network could not be built")
            return Reply(refusal(error, request.session_id), False)
        self._simulation = simulation
        return Reply(frame, True)

    def _advance(self, request: StepRequest | RunRequest) -> bytes:
        simulation = self._simulation
        if isinstance(request, RunRequest):  # [NCP-SESS-031]
            duration_ms = request.duration_ms
        else:
            duration_ms = simulation.chunk_ms if request.advance_ms is None else request.advance_ms
        values = {} if request.stimulus is None else request.stimulus.values
        observed = ObservationFrame(  # [NCP-SESS-027] [NCP-PROV-007]
            session_id=request.session_id,
            seq=self._seq + 1,  # [NCP-SESS-034]
            t=monotonic(),
            records=simulation.advance(duration_ms, values),
            sim_time_ms=simulation.time_ms,
        )
        try:
            frame = encode(observed)
        except EncodeError as error:  # a number that is not finite, or more than fits into a frame
            simulation.undo_last(error)
            raise
        self._seq += 1
        return frame
