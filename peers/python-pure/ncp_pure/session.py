"""The session service: what a server does with requests (sections 4.2 and 12.1 of the text)."""

import logging
import threading
from time import monotonic

from .errors import DecodeError, NcpError
from .keys import REQUEST_KINDS
from .messages import (
    CloseSession,
    ErrorFrame,
    ObservationFrame,
    OpenSession,
    SessionClosed,
    SessionOpened,
    SimProvenance,
    StepRequest,
)
from .reference import Simulation
from .version import check_version
from .wire import check_strict, decode_object, encode, read_frame

BACKEND = "ncp-pure reference backend 0.1.0"


class SessionService:
    """Answers requests. `simulate` builds a simulation from the parts of an `OpenSession`.

    Threads may call `handle` side by side: the requests of one session wait for each other
    [NCP-SESS-036], those of different sessions do not [NCP-TRANS-007].
    """

    def __init__(self, simulate=Simulation, *, strict=False):
        self._simulate = simulate
        self._strict = strict
        self._sessions = {}
        self._lock = threading.Lock()

    def handle(self, request, verb=None):
        """The bytes of the one reply to the bytes of a request [NCP-SESS-020].

        `verb` is the kind in the strict control key at which the request came, if it came at one.
        """
        try:
            return encode(self._reply(request, verb))
        except NcpError as error:  # [NCP-SESS-021] [NCP-SESS-022]
            return encode(_error_frame(error, request))
        except Exception as error:  # [NCP-SESS-037] whatever it was, it costs this request only
            logging.getLogger(__name__).exception("a request failed")
            return encode(_error_frame(error, request))

    def _reply(self, frame, verb):
        value = decode_object(frame)
        kind = value.get("kind")
        if kind not in REQUEST_KINDS:
            raise DecodeError("kind", f"{str(kind)[:40]} is not a request")
        if self._strict and verb is not None and verb != kind:
            raise DecodeError("kind", f"{kind} does not come at this control key")  # [NCP-STRICT-007]
        request = read_frame(kind, value)
        if isinstance(request, OpenSession):
            return self._open(request, value)
        if self._strict:
            check_strict(request, value)  # [NCP-STRICT-009]
        if isinstance(request, CloseSession):
            return self._close(request)
        return self._advance(request)

    def _open(self, request, value):
        try:
            if self._strict:
                check_strict(request, value)  # [NCP-STRICT-008]
            check_version(request.ncp_version, strict=True)  # [NCP-SESS-023]
            simulation = self._simulate(request.network, request.record, request.stimulus, request.sim)
            session = _Session(simulation, request.sim.chunk_ms)
            with self._lock:
                if request.session_id in self._sessions:
                    raise NcpError("the session is already open")  # [NCP-SESS-030]
                self._sessions[request.session_id] = session
        except NcpError as error:
            # [NCP-SESS-024] Nothing was opened.
            return SessionOpened(
                session_id=request.session_id, ok=False, backend=BACKEND, error=_said(error)
            )
        # The contract hash decides nothing [NCP-SESS-025].
        return SessionOpened(
            session_id=request.session_id,
            backend=BACKEND,
            resolved=simulation.resolved,
            provenance=SimProvenance(  # [NCP-SESS-039]
                network_ref=request.network.ref, backend=BACKEND, seed=request.sim.seed
            ),
        )

    def _advance(self, request):
        session = self._sessions.get(request.session_id)
        if session is None:
            raise NcpError("the session is not open")  # [NCP-SESS-026]
        if isinstance(request, StepRequest):  # [NCP-SESS-031]
            duration = session.chunk_ms if request.advance_ms is None else request.advance_ms
        else:
            duration = request.duration_ms
        values = {} if request.stimulus is None else request.stimulus.values
        with session.lock:
            records = session.simulation.advance(duration, values)
            session.seq += 1  # [NCP-SESS-034]
            return ObservationFrame(  # [NCP-SESS-027] [NCP-SESS-038]
                session_id=request.session_id,
                seq=session.seq,
                t=monotonic(),
                sim_time_ms=session.simulation.time_ms,
                records=records,
            )

    def _close(self, request):
        with self._lock:
            session = self._sessions.pop(request.session_id, None)
        # [NCP-SESS-028] [NCP-SESS-029]
        return SessionClosed(session_id=request.session_id, ok=session is not None)


class _Session:
    """The state of one open session, which no other shares [NCP-SESS-035]."""

    def __init__(self, simulation, chunk_ms):
        self.simulation = simulation
        self.chunk_ms = chunk_ms
        self.seq = 0
        self.lock = threading.Lock()


def _error_frame(error, frame):
    return ErrorFrame(error=_said(error), session_id=_session_of(frame))


def _said(error):
    """What an error says, short enough for a frame: it may quote the request."""
    return str(error)[:1000]


def _session_of(frame):
    """The session that a request names, if it names one at all."""
    try:
        session = decode_object(frame).get("session_id")
    except DecodeError:
        return None
    return session if type(session) is str and len(session) <= 256 else None
