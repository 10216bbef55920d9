"""What the service and its workers say to each other, and the replies that both write."""

from importlib.metadata import version
from typing import NamedTuple

from ncp_pure import CloseSession, ErrorFrame, OpenSession, RunRequest, SessionOpened, StepRequest, encode

BACKEND = f"NEST {version('nest-simulator')}"
"""The simulator and its version."""

Request = OpenSession | StepRequest | RunRequest | CloseSession


class Reply(NamedTuple):
    """The frame that answers a request, and whether the session is open after it."""

    frame: bytes
    open: bool


def refusal(error: Exception, session_id: str) -> bytes:
    """The reply to an `open_session` after which nothing is open [NCP-SESS-024]."""
    return encode(SessionOpened(session_id=session_id, ok=False, backend=BACKEND, error=_said(error)))


def error_frame(error: Exception, session_id: str | None = None) -> bytes:
    """The reply to a request that cannot be served [NCP-WIRE-102]."""
    return encode(ErrorFrame(error=_said(error), session_id=session_id))


def _said(error: Exception) -> str:
    """What an error says, short enough for a frame: it may quote the request."""
    return (str(error) or type(error).__name__)[:1000]
