"""What a client does with its requests and their replies (section 4.1 of the text)."""

from .errors import ReplyError
from .keys import Keys
from .messages import (
    CloseSession,
    ErrorFrame,
    ObservationFrame,
    OpenSession,
    RunRequest,
    SessionClosed,
    SessionOpened,
    StepRequest,
)
from .version import check_version
from .wire import decode_object, encode, read_frame

REPLIES = {
    OpenSession.KIND: SessionOpened.KIND,
    StepRequest.KIND: ObservationFrame.KIND,
    RunRequest.KIND: ObservationFrame.KIND,
    CloseSession.KIND: SessionClosed.KIND,
}
"""The kind of reply that answers each kind of request."""


def check_reply(request, reply, *, strict=False):
    """The reply message in the bytes `reply`, if it answers `request`; else an `NcpError`.

    An error frame and a reply with `ok` false are a `ReplyError` too.
    """
    if request.KIND not in REPLIES:
        raise ReplyError(f"{request.KIND} is not a request")
    value = decode_object(reply)  # [NCP-SESS-006]
    kind = value.get("kind")
    if kind == ErrorFrame.KIND:
        frame = read_frame(kind, value)  # [NCP-WIRE-100]
        raise ReplyError(f"the server answers: {frame.error}")  # [NCP-SESS-005]
    if kind != REPLIES[request.KIND]:
        raise ReplyError(f"{str(kind)[:40]} does not answer {request.KIND}")  # [NCP-SESS-001]
    message = read_frame(kind, value, strict=strict)
    if message.session_id != request.session_id:
        raise ReplyError("the reply is of another session")  # [NCP-SESS-002]
    check_version(message.ncp_version, strict=True)  # [NCP-SESS-003]
    if getattr(message, "ok", True) is False:
        raise ReplyError(getattr(message, "error", None) or "the server reports a failure")  # [NCP-SESS-004]
    return message  # [NCP-SESS-007]


class Client:
    """A client of one session.

    `send(key, frame)` hands a request's bytes to a transport and gives the bytes of its reply.
    """

    def __init__(self, send, session_id, realm=None, *, strict=False):
        self._send = send
        self._keys = Keys(realm)
        self._strict = strict
        self._owned = False
        self.session_id = session_id

    def open(self, network, **fields):
        """Opens the session, which this client then owns."""
        opened = self._request(OpenSession(session_id=self.session_id, network=network, **fields))
        self._owned = True
        return opened

    def step(self, advance_ms=None, stimulus=None):
        """Advances the session."""
        return self._request(
            StepRequest(session_id=self.session_id, advance_ms=advance_ms, stimulus=stimulus)
        )

    def run(self, duration_ms, stimulus=None):
        """Runs the session for a time."""
        return self._request(
            RunRequest(session_id=self.session_id, duration_ms=duration_ms, stimulus=stimulus)
        )

    def close(self):
        """Closes the session if this client opened it [NCP-SESS-040]; whether it did."""
        if not self._owned:
            return False
        self._request(CloseSession(session_id=self.session_id))
        self._owned = False
        return True

    def _request(self, request):
        key = self._keys.rpc_of(request.KIND) if self._strict else self._keys.rpc()
        return check_reply(request, self._send(key, encode(request)), strict=self._strict)
