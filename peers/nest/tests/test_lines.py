"""The line protocol: one document a line, one reply a line, in order, whatever comes."""

import json

import ncp_pure as ncp
import pytest
from ncp_pure.wire import MAX_FRAME

STRAY = json.dumps({"kind": "step_request", "session_id": "nobody", "ncp_version": ncp.WIRE_VERSION})

LINES = {
    "an empty line": "",
    "a line of white space": " \t ",
    "no JSON": "no frame",
    "no object": "[1]",
    "an object that is cut short": '{"kind":"step_request","session_id":',
    "two documents": STRAY + STRAY,
    "two documents with a space between": f"{STRAY} {STRAY}",
    "a repeated member": '{"kind":"step_request","session_id":"a","session_id":"b"}',
    "no kind": '{"session_id":"nobody"}',
    "an unknown kind": '{"kind":"dance","session_id":"nobody"}',
    "a kind that is no request": '{"kind":"sensor_frame","seq":1}',
    "a missing member": '{"kind":"run_request","session_id":"nobody"}',
    "a wrong type": '{"kind":"step_request","session_id":"nobody","advance_ms":"10"}',
    "a number that JSON lacks": '{"kind":"step_request","session_id":"nobody","advance_ms":NaN}',
    "bytes that are no UTF-8": b'{"kind":"step_request","session_id":"\xff"}',
    "too many levels": '{"kind":"step_request","session_id":"nobody","x":' + "[" * 70 + "]" * 70 + "}",
    "a bad session id": '{"kind":"close_session","session_id":"a/b"}',
    "a session that is not open": STRAY,
}


@pytest.mark.parametrize("line", LINES.values(), ids=LINES.keys())
def test_a_line_that_cannot_be_served_is_answered_by_one_error_frame(connection, line):
    reply = json.loads(connection.ask(line))
    assert reply["kind"] == "error" and reply.keys() <= {"kind", "error", "session_id"}
    assert json.loads(connection.ask(STRAY))["error"] == "the session is not open"


def test_a_line_may_end_in_carriage_return_and_line_feed(connection):
    assert json.loads(connection.ask(STRAY + "\r"))["error"] == "the session is not open"


def test_a_frame_of_the_longest_length_is_read_and_one_beyond_is_an_error(connection):
    longest = STRAY[:-1] + ',"x":"' + "x" * (MAX_FRAME - len(STRAY) - 7) + '"}'
    assert len(longest) == MAX_FRAME
    assert json.loads(connection.ask(longest))["error"] == "the session is not open"
    assert "more than" in json.loads(connection.ask(longest + " "))["error"]
    assert json.loads(connection.ask(STRAY))["error"] == "the session is not open"


def test_a_line_without_end_is_answered_once_and_kept_nowhere(service, connection):
    before = resident(service.process.pid)
    for _ in range(64):
        connection.send(b"x" * (1 << 20), end=b"")
    assert "more than" in json.loads(connection.ask(b""))["error"]
    assert json.loads(connection.ask(STRAY))["error"] == "the session is not open"
    assert resident(service.process.pid) - before < 32 << 20


def resident(pid):
    """The memory of a process, bytes."""
    with open(f"/proc/{pid}/status") as status:
        return next(int(line.split()[1]) << 10 for line in status if line.startswith("VmRSS"))


def test_a_request_that_is_cut_short_is_not_carried_out(service, client):
    session = client()
    session.open(ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 1}))
    other = service.connect()
    other.send(ncp.encode(ncp.StepRequest(session_id=session.session_id)), end=b"")
    other.end()
    assert other.answer() == b""
    other.close()
    assert session.step(10.0).sim_time_ms == 10.0


def test_replies_come_in_the_order_of_their_requests(connection, client):
    session = client()
    session.open(ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 1}))
    step = ncp.encode(ncp.StepRequest(session_id=session.session_id, advance_ms=1.0))
    for _ in range(100):
        connection.send(step)
        connection.send("no frame")
    for number in range(1, 101):
        assert json.loads(connection.answer())["seq"] == number
        assert json.loads(connection.answer())["kind"] == "error"


def test_a_client_that_leaves_takes_nobody_along(service, client):
    session = client()
    session.open(ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 1}))
    rude = service.connect()
    for _ in range(20):
        rude.send(ncp.encode(ncp.StepRequest(session_id=session.session_id, advance_ms=1.0)))
    rude.close()
    assert session.step(1.0).sim_time_ms > 0.0
