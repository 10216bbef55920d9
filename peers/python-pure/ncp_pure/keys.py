"""Keys and key expressions (sections 3.2 to 3.4 and 12.1 of the text)."""

import re

from .errors import KeyExpressionError

DEFAULT_REALM = "ncp"
"""The realm of who names none [NCP-KEY-006]."""

MAX_SEGMENT = 256
"""The most bytes of UTF-8 of a segment."""

REQUEST_KINDS = ("open_session", "step_request", "run_request", "close_session")
"""The kinds that have a strict control key of their own."""


class Keys:
    """Builds the keys of a realm. Each builder raises `KeyExpressionError` [NCP-KEY-019]."""

    def __init__(self, realm=None):
        self.realm = DEFAULT_REALM if realm is None else validate_realm(realm)

    def rpc(self):
        """The control key [NCP-KEY-001]."""
        return f"{self.realm}/rpc"

    def rpc_of(self, kind):
        """The strict control key of a kind of request [NCP-STRICT-001] [NCP-STRICT-006]."""
        if kind not in REQUEST_KINDS:
            raise KeyExpressionError(f"{kind!r} is not the kind of a request")
        return f"{self.realm}/rpc/{kind}"

    def sensor(self, session, name=None):
        """The perception key of a session, or of one of its named streams [NCP-KEY-002]."""
        return self._session(session, "sensor") + _named(name)

    def command(self, session, name=None):
        """The action key of a session, or of one of its named streams [NCP-KEY-003]."""
        return self._session(session, "command") + _named(name)

    def observation(self, session):
        """The observation key of a session [NCP-KEY-004]."""
        return self._session(session, "observation")

    def sensor_glob(self, session):
        """All perception streams of a session [NCP-KEY-005]."""
        return self._session(session, "sensor/**")

    def command_glob(self, session):
        """All action streams of a session."""
        return self._session(session, "command/**")

    def session_glob(self, session):
        """All of a session."""
        return self._session(session, "**")

    def fleet_glob(self):
        """All sessions of the realm."""
        return f"{self.realm}/session/**"

    def _session(self, session, rest):
        return f"{self.realm}/session/{validate_segment(session)}/{rest}"


def validate_segment(segment):
    """The segment, unchanged [NCP-KEY-007], or a `KeyExpressionError`."""
    if not segment:
        raise KeyExpressionError("a segment is empty")  # [NCP-KEY-010]
    forbidden = _FORBIDDEN.search(segment)
    if forbidden:
        raise KeyExpressionError(f"a segment holds {forbidden.group()!r}")
    if segment.startswith("@"):
        raise KeyExpressionError("a segment begins with '@'")  # [NCP-KEY-013]
    if segment in (".", ".."):
        raise KeyExpressionError(f"a segment is {segment!r}")  # [NCP-KEY-014]
    try:
        length = len(segment.encode("utf-8"))
    except UnicodeEncodeError:
        raise KeyExpressionError("a segment has no UTF-8 form") from None
    if length > MAX_SEGMENT:
        raise KeyExpressionError(f"a segment has {length} bytes, more than {MAX_SEGMENT}")  # [NCP-KEY-017]
    return segment


def validate_realm(realm):
    """The realm, unchanged, or a `KeyExpressionError` for one of its segments [NCP-KEY-018]."""
    for segment in realm.split("/"):
        validate_segment(segment)
    return realm


def matches(pattern, key):
    """Whether a key expression covers a key, which has no wildcards."""
    chunks = [_pattern_chunk(chunk) for chunk in _chunks(pattern)]
    # reached[i]: the chunks of the key before i can be covered by the pattern's chunks so far.
    parts = _chunks(key)
    for part in parts:
        if "*" in part or "$" in part:
            raise KeyExpressionError(f"the key {key[:60]!r} has wildcards")
    reached = [True] + [False] * len(parts)
    for chunk in chunks:
        if chunk == "**":  # [NCP-KEY-032]
            for i, part in enumerate(parts):
                reached[i + 1] |= reached[i] and not part.startswith("@")  # [NCP-KEY-034]
        else:
            covered = [before and _covers(chunk, part) for before, part in zip(reached, parts)]
            reached = [False] + covered
    return reached[-1]


# [NCP-KEY-011] [NCP-KEY-012] [NCP-KEY-015] [NCP-KEY-016]
_FORBIDDEN = re.compile("[/*$#?\x00-\x20\x7f-\x9f]")


def _named(name):
    return "" if name is None else f"/{validate_segment(name)}"


def _chunks(expression):
    """The chunks of a key expression [NCP-KEY-036]."""
    chunks = expression.split("/")
    for chunk in chunks:
        if not chunk:
            raise KeyExpressionError(f"{expression[:60]!r} has an empty chunk")
        if "#" in chunk or "?" in chunk:
            raise KeyExpressionError(f"{expression[:60]!r} holds '#' or '?'")
    return chunks


def _pattern_chunk(chunk):
    if chunk not in ("*", "**"):
        rest = chunk.replace("$*", "")
        if "*" in rest or "$" in rest:
            raise KeyExpressionError(f"{chunk[:60]!r} holds a '*' or '$' that is no wildcard")
    return chunk


def _covers(chunk, part):
    """Whether a chunk of a pattern, other than `**`, covers a chunk of a key."""
    if chunk.startswith("@") or part.startswith("@"):
        return chunk == part  # [NCP-KEY-034] [NCP-KEY-035]
    if chunk == "*":
        return True  # [NCP-KEY-031]
    first, *runs = chunk.split("$*")
    if not runs:
        return chunk == part  # [NCP-KEY-030]
    # [NCP-KEY-033] The shortest prefix for each run leaves the most for those behind it.
    *middle, last = runs
    if len(first) + len(last) > len(part) or not (part.startswith(first) and part.endswith(last)):
        return False
    start, end = len(first), len(part) - len(last)
    for run in middle:
        found = part.find(run, start, end)
        if found < 0:
            return False
        start = found + len(run)
    return True
