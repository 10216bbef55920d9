"""The session service: the bytes of a request in, the bytes of its one reply out.

It judges frames and versions by `ncp_pure`, and knows which sessions are open. What a session does is done by
its worker, a process of its own: NEST has one kernel a process.
"""

import importlib
import logging
import multiprocessing
import multiprocessing.forkserver
import threading
from multiprocessing.connection import Connection

from ncp_pure import (
    CloseSession,
    DecodeError,
    NcpError,
    OpenSession,
    SessionClosed,
    check_version,
    contract_status,
    encode,
)
from ncp_pure.keys import REQUEST_KINDS
from ncp_pure.wire import decode_object, read_frame

from .frames import Reply, Request, error_frame, refusal

WORKER = "ncp_nest.worker"
"""What a worker runs. The service itself imports no NEST."""

MAX_SESSIONS = 16
"""The most sessions that are open at a time."""

END_S = 5.0
"""How long a worker may take to end, s."""


class SessionService:
    """Answers requests. Threads may call `handle` side by side: the requests of one session wait for each
    other [NCP-SESS-036], those of different sessions do not [NCP-TRANS-007].
    """

    def __init__(self, threads: int = 1, max_sessions: int = MAX_SESSIONS) -> None:
        # Workers are forked from a process that has imported NEST and done nothing with it.
        self._processes = multiprocessing.get_context("forkserver")
        self._processes.set_forkserver_preload([WORKER])
        multiprocessing.forkserver.ensure_running()
        self._threads = threads
        self._max_sessions = max_sessions
        self._workers: dict[str, _Worker] = {}
        self._lock = threading.Lock()

    def handle(self, frame: bytes) -> bytes:
        """The reply to a request [NCP-SESS-020]."""
        session_id = None
        try:
            value = decode_object(frame)
            session_id = _session_of(value)
            kind = value.get("kind")
            if kind not in REQUEST_KINDS:
                raise DecodeError("kind", f"{str(kind)[:40]} is not a request")
            return self._reply(read_frame(kind, value))
        except NcpError as error:  # [NCP-SESS-021] [NCP-SESS-022]
            return error_frame(error, session_id)
        except Exception as error:  # [NCP-SESS-037] whatever it was, it costs this request only
            logging.getLogger(__name__).exception("a request failed")
            return error_frame(error, session_id)

    def close(self) -> None:
        """Ends all sessions, each after the request that it is serving, if that ends soon."""
        with self._lock:
            workers, self._workers = self._workers, {}
            self._max_sessions = 0
        for worker in workers.values():
            if worker.lock.acquire(timeout=END_S):
                worker.end()
                worker.lock.release()
            else:
                worker.kill()

    def _reply(self, request: Request) -> bytes:
        if isinstance(request, OpenSession):
            return self._open(request)
        worker = self._workers.get(request.session_id)
        if worker is None:
            return self._not_open(request)
        with worker.lock:
            if not worker.open:  # it was closed, or refused, while this request waited
                return self._not_open(request)
            return self._ask(worker, request)

    def _not_open(self, request: Request) -> bytes:
        if isinstance(request, CloseSession):
            return encode(SessionClosed(session_id=request.session_id, ok=False))  # [NCP-SESS-029]
        return error_frame(NcpError("the session is not open"), request.session_id)  # [NCP-SESS-026]

    def _open(self, request: OpenSession) -> bytes:
        if contract_status(request.contract_hash) == "mismatch":  # which decides nothing [NCP-SESS-025]
            logging.getLogger(__name__).warning("session %s: another contract", request.session_id)
        try:
            check_version(request.ncp_version, strict=True)  # [NCP-SESS-023]
            worker = self._start(request.session_id)
        except NcpError as error:
            return refusal(error, request.session_id)  # [NCP-SESS-024]
        try:
            return self._ask(worker, request)
        finally:
            worker.lock.release()

    def _start(self, session_id: str) -> "_Worker":
        """A new worker, which the caller holds: requests of the session wait until it is open, or refused."""
        with self._lock:
            if session_id in self._workers:
                raise NcpError("the session is already open")  # [NCP-SESS-030]
            if len(self._workers) >= self._max_sessions:
                raise NcpError(f"{len(self._workers)} sessions are open")  # [NCP-SESS-041]
            worker = self._workers[session_id] = _Worker()
            worker.lock.acquire()
        try:
            worker.start(self._processes, self._threads)
        except BaseException:
            self._drop(session_id, worker)
            worker.lock.release()
            raise
        return worker

    def _ask(self, worker: "_Worker", request: Request) -> bytes:
        try:
            reply = worker.ask(request)
        except (EOFError, OSError):
            reply = Reply(error_frame(NcpError("the simulator has ended"), request.session_id), False)
        if not reply.open:
            self._drop(request.session_id, worker)
        return reply.frame

    def _drop(self, session_id: str, worker: "_Worker") -> None:
        worker.open = False
        with self._lock:
            if self._workers.get(session_id) is worker:
                del self._workers[session_id]
        worker.end()


class _Worker:
    """The process of one session, which no other shares [NCP-SESS-035]. Who asks it holds its lock."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.open = True
        self._process: multiprocessing.process.BaseProcess | None = None

    def start(self, processes: multiprocessing.context.BaseContext, threads: int) -> None:
        """Starts the process."""
        self._pipe, theirs = processes.Pipe()
        self._process = processes.Process(target=_work, args=(theirs, threads), daemon=True)
        self._process.start()
        theirs.close()

    def ask(self, request: Request) -> Reply:
        """Has a request served; an `EOFError` or `OSError` when the process is gone."""
        self._pipe.send(request)
        return self._pipe.recv()

    def end(self) -> None:
        """Ends the process. Its end of the pipe tells it that nobody asks any more."""
        self.open = False
        if self._process is None:
            return
        self._pipe.close()
        self._process.join(END_S)
        self.kill()

    def kill(self) -> None:
        """Ends the process at once; who waits for its reply gets an `EOFError`."""
        self._process.kill()
        self._process.join()


def _work(pipe: Connection, threads: int) -> None:
    """Runs in the worker's process."""
    importlib.import_module(WORKER).serve(pipe, threads)


def _session_of(value: dict[str, object]) -> str | None:
    """The session that a request names, if it names one at all."""
    session = value.get("session_id")
    return session if isinstance(session, str) and len(session) <= 256 else None
