"""Sessions: their life, their failures, and that each has a simulator of its own."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import ncp_pure as ncp
import pytest
from conftest import ANSWER_S, Connection, Samples, drive, running

from ncp_nest import recorders, simulation
from ncp_nest.worker import Session

POP = ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 2})
V = ncp.RecordSpec(targets=[ncp.RecordTarget(port="v", target="pop", cadence_ms=0.5)])
CURRENT = ncp.StimulusSpec(targets=[ncp.StimulusTarget(port="in", target="pop")])


def children(process):
    """The processes below one, by id."""
    found, todo = set(), [process.pid]
    while todo:
        for task in Path(f"/proc/{todo.pop()}/task").glob("*/children"):
            below = {int(pid) for pid in task.read_text().split()}
            todo += below - found
            found |= below
    return found


def is_gone(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "Z"
    except (FileNotFoundError, ProcessLookupError):
        return True


def eventually(condition):
    deadline = time.monotonic() + ANSWER_S
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


def test_a_session_is_opened_stepped_run_and_closed(client):
    session = client()
    opened = session.open(POP, record=V, sim=ncp.SimConfig(seed=42, chunk_ms=5.0))
    assert (opened.backend, opened.resolved) == ("NEST 3.10.0", {"pop": 2})
    assert opened.contract_hash == ncp.CONTRACT_HASH

    frames = [session.step(), session.step(20.0), session.run(7.5), session.step(0.0), session.step()]
    assert [frame.seq for frame in frames] == [1, 2, 3, 4, 5]
    assert [frame.sim_time_ms for frame in frames] == [5.0, 25.0, 32.5, 32.5, 37.5]
    times = [frame.t for frame in frames]
    assert times == sorted(times)
    assert all(frame.records.keys() == {"v"} for frame in frames)
    assert session.close()
    with pytest.raises(ncp.ReplyError, match="not open"):
        session.step()


def test_what_was_simulated_says_where_it_comes_from(client, connection):
    def provenance(**sim):
        session = client()
        return session.open(POP, record=V, sim=ncp.SimConfig(**sim)).provenance

    first, second = provenance(seed=42), provenance()
    assert first.backend == "NEST 3.10.0" and first.seed == 42
    assert second.seed is not None, "the server says which seed it chose"
    name, digest = first.network_ref.split(" sha256:")
    assert name == "iaf_psc_alpha" and len(digest) == 64
    assert second.network_ref == first.network_ref
    for part in ("dt_ms=0.1", "min_delay_ms=0.1", "chunk_ms=10.0", "threads=1", "rng="):
        assert part in first.note

    session = client()
    session.open(ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 3}), record=V)
    step = ncp.encode(ncp.StepRequest(session_id=session.session_id))
    frame = json.loads(connection.ask(step))
    assert frame["is_simulation_output"] is True and frame["calibrated_posterior"] is False


def test_a_session_that_is_open_is_not_opened_again_and_stays_as_it_is(client, connection):
    session = client()
    session.open(POP)
    session.step(10.0)
    again = ncp.Client(lambda _, frame: connection.ask(frame), session.session_id)
    with pytest.raises(ncp.ReplyError, match="already open"):
        again.open(POP)
    assert session.step(10.0).sim_time_ms == 20.0


def test_a_close_of_a_session_that_is_not_open_says_so(connection):
    reply = json.loads(connection.ask('{"kind":"close_session","session_id":"nobody"}'))
    assert (reply["kind"], reply["ok"]) == ("session_closed", False)


def test_an_open_with_another_contract_hash_is_served(client):
    session = client()
    assert session.open(POP, contract_hash="0000000000000000").ok


def test_the_session_goes_on_as_if_a_step_that_failed_in_nest_had_not_been(client):
    def values(failing):
        session = client()
        network = ncp.NetworkRef(ref="aeif_cond_alpha", population_sizes={"pop": 2})
        targets = [*CURRENT.targets, ncp.StimulusTarget(port="noise", target="pop", kind="rate_hz")]
        session.open(network, record=V, stimulus=ncp.StimulusSpec(targets=targets), sim=ncp.SimConfig(seed=3))
        frames = [session.step(30.0, drive(session, **{"in": [700.0], "noise": [5000.0]})), session.step(15.0)]
        if failing:
            for _ in range(2):
                with pytest.raises(ncp.ReplyError, match="numerical instability"):
                    session.step(10.0, drive(session, **{"in": [1e300]}))
        frames += [session.step(20.0), session.step(10.0, drive(session, **{"in": [0.0]}))]
        return [frame.seq for frame in frames], frames[-1].sim_time_ms, vars(Samples(frames, "v"))

    assert values(failing=True) == values(failing=False)


def test_a_session_that_cannot_be_brought_back_is_over(monkeypatch):
    monkeypatch.setattr(simulation, "MAX_REQUESTS", 0)
    session = Session(threads=1)
    network = ncp.NetworkRef(ref="aeif_cond_alpha", population_sizes={"pop": 1})
    assert session.handle(ncp.OpenSession(session_id="s", network=network, stimulus=CURRENT)).open
    step = ncp.StepRequest(session_id="s")
    assert session.handle(step).open
    value = ncp.ChannelValue(data=[1e300])
    failing = step.replace(stimulus=ncp.StimulusFrame(session_id="s", values={"in": value}))
    reply = session.handle(failing)
    session.close()
    assert not reply.open
    assert "too old to be brought back" in json.loads(reply.frame)["error"]


def test_a_run_of_more_spikes_than_a_frame_holds_is_an_error_and_undone(monkeypatch):
    monkeypatch.setattr(recorders, "MAX_SAMPLES", 100)
    session = Session(threads=1)
    record = ncp.RecordSpec(targets=[ncp.RecordTarget(port="spk", target="pop", observable="spikes")])
    network = ncp.NetworkRef(ref="parrot_neuron", population_sizes={"pop": 1})
    stimulus = ncp.StimulusSpec(targets=[ncp.StimulusTarget(port="in", target="pop", kind="spike_times")])
    opening = ncp.OpenSession(session_id="s", network=network, record=record, stimulus=stimulus)
    assert session.handle(opening).open

    def step(spikes):
        value = ncp.ChannelValue(data=[1.0] * spikes)
        stimulus = ncp.StimulusFrame(session_id="s", values={"in": value})
        return json.loads(session.handle(ncp.StepRequest(session_id="s", stimulus=stimulus)).frame)

    assert "more than 100 samples" in step(101)["error"]
    told = step(100)
    session.close()
    assert told["sim_time_ms"] == 10.0
    assert len(told["records"]["spk"]["times"]) == 100


def test_a_number_that_json_lacks_is_an_error_and_undone(client):
    def values(failing):
        session = client()
        network = ncp.NetworkRef(ref="hh_psc_alpha", population_sizes={"pop": 1})
        session.open(network, record=V, stimulus=CURRENT, sim=ncp.SimConfig(seed=3))
        frames = [session.step(10.0, drive(session, **{"in": [700.0]}))]
        if failing:
            with pytest.raises(ncp.ReplyError, match="no JSON form"):
                session.step(10.0, drive(session, **{"in": [1e300]}))
        frames += [session.step(10.0)]
        return [frame.seq for frame in frames], vars(Samples(frames, "v"))

    assert values(failing=True) == values(failing=False)


def test_sessions_with_different_steps_are_open_at_once_and_apart(client):
    first, second = client(), client()
    first.open(POP, record=V, stimulus=CURRENT, sim=ncp.SimConfig(seed=1, dt_ms=0.1))
    second.open(POP, record=V, stimulus=CURRENT, sim=ncp.SimConfig(seed=1, dt_ms=0.5))
    first.step(10.0, drive(first, **{"in": [1000.0]}))
    quiet = second.step(30.0)
    assert set(quiet.records["v"].values) == {-70.0}
    assert quiet.sim_time_ms == 30.0
    first.close()
    assert second.step(10.0).sim_time_ms == 40.0


def test_a_long_run_of_one_session_does_not_hold_up_another(service):
    connections = [service.connect() for _ in range(2)]
    slow, quick = (
        ncp.Client(lambda _, frame, to=to: to.ask(frame), name)
        for to, name in zip(connections, ("slow", "quick"), strict=True)
    )
    slow.open(ncp.NetworkRef(ref="hh_psc_alpha", population_sizes={"pop": 100}))
    quick.open(POP)
    quick.step(1.0)
    ended = []
    runner = threading.Thread(target=lambda: ended.append(slow.run(1000.0)))
    runner.start()
    quick.step(1.0)  # a thousandth of the work of the other
    assert not ended
    runner.join(ANSWER_S)
    assert ended[0].sim_time_ms == 1000.0
    slow.close()
    quick.close()
    for opened in connections:
        opened.close()


def test_requests_of_one_session_on_two_connections_each_get_their_own_answer(service, client):
    session = client()
    session.open(POP)
    step = ncp.encode(ncp.StepRequest(session_id=session.session_id, advance_ms=1.0))
    connections = [service.connect() for _ in range(2)]
    for _ in range(50):
        for other in connections:
            other.send(step)
    seqs = [[json.loads(other.answer())["seq"] for _ in range(50)] for other in connections]
    assert sorted(seqs[0] + seqs[1]) == list(range(1, 101))
    assert all(own == sorted(own) for own in seqs)
    for other in connections:
        other.close()


def test_a_simulator_that_dies_costs_its_session_and_no_other():
    with running("--sessions", "2") as service:
        connection = service.connect()
        one, two, three = (ncp.Client(lambda _, frame: connection.ask(frame), name) for name in ("one", "two", "three"))
        one.open(POP)
        before = children(service.process)
        two.open(POP)
        (worker,) = children(service.process) - before
        with pytest.raises(ncp.ReplyError, match="2 sessions are open"):
            three.open(POP)

        os.kill(worker, signal.SIGKILL)
        with pytest.raises(ncp.ReplyError, match="the simulator has ended"):
            two.step()
        with pytest.raises(ncp.ReplyError, match="not open"):
            two.step()
        assert one.step().sim_time_ms == 10.0
        assert three.open(POP).ok
        connection.close()


def test_the_simulator_of_a_closed_session_ends(service, client):
    before = children(service.process)
    session = client()
    session.open(POP)
    started = children(service.process) - before
    assert len(started) == 1
    session.close()
    eventually(lambda: all(map(is_gone, started)))


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_the_service_ends_with_its_simulators_when_it_is_told_to(number):
    with running() as service:
        connection = service.connect()
        ncp.Client(lambda _, frame: connection.ask(frame), "s").open(POP)
        started = children(service.process)
        service.process.send_signal(number)
        assert service.process.wait(ANSWER_S) == 0
        eventually(lambda: all(map(is_gone, started)))
        with pytest.raises(OSError):
            Connection(service.address)
        connection.close()


@pytest.mark.parametrize(
    "address, said",
    [("0.0.0.0:0", "no loopback address"), ("localhost", "no address"), ("127.0.0.1:70000", "no address")],
)
def test_an_address_that_is_not_on_loopback_is_refused(address, said):
    environment = {**os.environ, "NCP_BRIDGE_ADDR": address}
    command = [sys.executable, "-m", "ncp_nest"]
    ended = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=ANSWER_S)
    assert ended.returncode == 2
    assert said in ended.stderr
