"""What does not fit is refused by a frame that says why, and costs nothing else."""

import json

import ncp_pure as ncp
import pytest
from conftest import drive


def request(session, **changes):
    """A request that opens a session, with other members."""
    value = {
        "kind": "open_session",
        "ncp_version": ncp.WIRE_VERSION,
        "session_id": session.session_id,
        "network": {"kind": "builtin", "ref": "iaf_psc_alpha", "population_sizes": {"pop": 2}},
    }
    return json.dumps({**value, **changes})


def network(**members):
    return {"network": {"ref": "iaf_psc_alpha", "population_sizes": {"pop": 2}, **members}}


def record(**members):
    return {"record": {"targets": [{"port": "p", "target": "pop", **members}]}}


def stimulus(**members):
    return {"stimulus": {"targets": [{"port": "p", "target": "pop", **members}]}}


def sim(**members):
    return {"sim": members}


def spec(**parts):
    return network(kind="spec", ref=json.dumps(parts), population_sizes={})


A = {"model": "iaf_psc_alpha", "size": 2}
BRUNEL = {"ref": "brunel", "population_sizes": {"ex": 80, "in": 20}, "params": {"delay": 1.5}}

OPENS = {
    "an unknown model": (network(ref="iaf_psc_omega"), "neuron model 'iaf_psc_omega'"),
    "a device for a model": (network(ref="poisson_generator"), "neuron model 'poisson_generator'"),
    "another model's name": (network(model_name="izhikevich"), "no neurons of 'izhikevich'"),
    "a handle": (network(kind="handle"), "kind 'handle'"),
    "a model of a registry": (network(kind="model_id"), "kind 'model_id'"),
    "an unknown kind of network": (network(kind="dream"), "kind 'dream'"),
    "an unknown parameter": (network(params={"tau_q": 1.0}), "tau_q"),
    "a parameter that NEST refuses": (network(params={"tau_m": -1.0}), "NEST: "),
    "a population of no neuron": (network(population_sizes={"pop": 0}), "has no neuron"),
    "a population of too many": (network(population_sizes={"pop": 10**9}), "more than 200000 neurons"),
    "an unknown parameter of brunel": (network(**{**BRUNEL, "params": {"h": 1.0}}), "no 'h'"),
    "an unknown population of brunel": (network(ref="brunel"), "no 'pop'"),
    "an indegree of a part": (network(**{**BRUNEL, "params": {"C_E": 0.5}}), "C_E must be a whole number"),
    "a brunel without a weight": (network(**{**BRUNEL, "params": {"weight": 0.0}}), "must be positive"),
    "too many synapses": (network(ref="brunel", population_sizes={"ex": 60_000}), "more than 20000000 synapses"),
    "a spec that is no JSON": (network(kind="spec", ref="nest.Create()", population_sizes={}), "spec is not JSON"),
    "a spec with an unknown member": (spec(neurons={}), "no member 'neurons'"),
    "a spec with a wrong type": (spec(populations=[]), "populations is not of type dict"),
    "a spec with an unknown model": (spec(populations={"a": {"model": "x", "size": 1}}), "neuron model 'x'"),
    "a spec with a nested parameter": (spec(populations={"a": {**A, "params": {"C_m": [1]}}}), "'C_m' is no number"),
    "a spec with an unknown end": (spec(populations={"a": A}, projections=[{"source": "a", "target": "b"}]), "'b'"),
    "a spec with an unknown rule": (
        spec(populations={"a": A}, projections=[{"source": "a", "target": "a", "rule": {"rule": "x"}}]),
        "rule has no 'x'",
    ),
    "a rule without its number": (
        spec(populations={"a": A}, projections=[{"source": "a", "target": "a", "rule": {"rule": "fixed_indegree"}}]),
        "rule has no 'indegree'",
    ),
    "an unknown synapse": (
        spec(populations={"a": A}, projections=[{"source": "a", "target": "a", "synapse": {"synapse_model": "x"}}]),
        "NEST: ",
    ),
    "a delay that is no number": (
        spec(populations={"a": A}, projections=[{"source": "a", "target": "a", "synapse": {"delay": "1"}}]),
        "delay is no number",
    ),
    "the size of no population": (network(kind="spec", ref="{}"), "no population 'pop'"),
    "params beside a spec": (network(kind="spec", ref="{}", params={"C_m": 1.0}), "stand with its populations"),
    "a record of no population": (record(target="other"), "no population 'other'"),
    "a record of no neuron": (record(ids=[3]), "neurons 1 to 2"),
    "a neuron twice": (record(ids=[1, 1]), "names a neuron twice"),
    "an unknown observable": (record(observable="mood"), "no observable 'mood'"),
    "a recordable that the model lacks": (record(recordables=["g_ex"]), "not 'g_ex'"),
    "a state that the model lacks": (record(observable="binary_state"), "not 'S'"),
    "two recordables of a port": (record(recordables=["V_m", "I_syn_ex"]), "give each its own port"),
    "a recordable of spikes": (record(observable="spikes", recordables=["V_m"]), "spikes have no recordable"),
    "a cadence of 0": (record(cadence_ms=0), "cadence_ms must be positive"),
    "a cadence between two steps": (record(cadence_ms=0.25), "no multiple of dt_ms"),
    "two records of a port": ({"record": {"targets": [{"port": "p", "target": "pop"}] * 2}}, "two targets"),
    "a stimulus of no population": (stimulus(target="other"), "no population 'other'"),
    "an unknown stimulus": (stimulus(kind="smell"), "no stimulus 'smell'"),
    "an unknown param of a stimulus": (stimulus(params={"color": 1.0}), "no 'color'"),
    "a delay between two steps": (stimulus(params={"delay": 0.15}), "no multiple of dt_ms"),
    "a delay of nothing": (stimulus(params={"delay": 0.0}), "NEST: "),
    "a receptor in part": (stimulus(params={"receptor_type": 0.5}), "receptor_type must be a whole number"),
    "a receptor that the model lacks": (stimulus(params={"receptor_type": 7.0}), "NEST: "),
    "a rate into spiking neurons": (stimulus(kind="rate_inject"), "NEST: "),
    "a weight without a synapse": (stimulus(kind="weight_set"), "no synapse"),
    "a step of nothing": (sim(dt_ms=0), "dt_ms must be positive"),
    "a negative step": (sim(dt_ms=-0.1), "dt_ms must be finite and not negative"),
    "a step finer than NEST's": (sim(dt_ms=0.00015), "no multiple of 0.001 ms"),
    "a chunk of nothing": (sim(chunk_ms=0), "chunk_ms must be positive"),
    "a chunk between two steps": (sim(dt_ms=0.1, chunk_ms=0.25), "no multiple of dt_ms, 0.1 ms"),
    "a chunk below the step": (sim(dt_ms=1.0, chunk_ms=0.5), "no multiple of dt_ms, 1.0 ms"),
    "a chunk that splits min_delay": ({**network(**BRUNEL), **sim(chunk_ms=10.0)}, "min_delay, 1.5 ms"),
    "a seed that NEST has not": (sim(seed=0), "seed must be"),
    "another version": ({"ncp_version": "0.4"}, "0.4"),
}


@pytest.mark.parametrize("changes, said", OPENS.values(), ids=OPENS.keys())
def test_a_session_that_does_not_fit_is_refused_and_not_open(connection, client, changes, said):
    session = client()
    reply = json.loads(connection.ask(request(session, **changes)))
    assert (reply["kind"], reply["ok"]) == ("session_opened", False)
    assert said in reply["error"] and reply["provenance"] is None
    with pytest.raises(ncp.ReplyError, match="not open"):
        session.step()
    reply = json.loads(connection.ask(request(session)))
    assert reply["ok"], "the same session opens once it fits"
    connection.ask(ncp.encode(ncp.CloseSession(session_id=session.session_id)))


STEPS = {
    "a time between two steps": (lambda s: s.step(0.25), "no multiple of dt_ms"),
    "a negative time": (lambda s: s.step(-1.0), "not negative"),
    "a time without end": (lambda s: s.run(1e300), "too long"),
    "a time that would take too long": (lambda s: s.run(1e9), "too long in one request"),
    "too many samples": (lambda s: s.run(300_000.0), "too many samples"),
    "an unknown port": (lambda s: s.step(stimulus=drive(s, other=[1.0])), "no stimulus port 'other'"),
    "no value": (lambda s: s.step(stimulus=drive(s, current=[])), "takes one value, not 0"),
    "a value too many": (lambda s: s.step(stimulus=drive(s, current=[1.0, 2.0])), "takes one value, not 2"),
    "values that are not one an id": (lambda s: s.step(stimulus=drive(s, each=[1.0] * 3)), "each of its 2 ids"),
    "a negative rate": (lambda s: s.step(stimulus=drive(s, rate=[-1.0])), "negative"),
    "a spike in the past": (lambda s: s.step(stimulus=drive(s, times=[10.0])), "not ahead"),
    "a spike between two steps": (lambda s: s.step(stimulus=drive(s, times=[30.05])), "no multiple of dt_ms"),
    "another unit": (
        lambda s: s.step(
            stimulus=ncp.StimulusFrame(
                session_id=s.session_id, values={"current": ncp.ChannelValue(data=[1.0], unit="nA")}
            )
        ),
        "is in pA, not 'nA'",
    ),
}


@pytest.mark.parametrize("ask, said", STEPS.values(), ids=STEPS.keys())
def test_a_step_that_does_not_fit_changes_nothing(client, ask, said):
    def frames(refused):
        session = client()
        targets = [
            ncp.StimulusTarget(port="current", target="pop"),
            ncp.StimulusTarget(port="each", target="pop", ids=[1, 2]),
            ncp.StimulusTarget(port="rate", target="pop", kind="rate_hz"),
            ncp.StimulusTarget(port="times", target="pop", kind="spike_times"),
        ]
        session.open(
            ncp.NetworkRef(ref="iaf_psc_alpha", population_sizes={"pop": 2}),
            record=ncp.RecordSpec(targets=[ncp.RecordTarget(port="v", target="pop", cadence_ms=0.5)]),
            stimulus=ncp.StimulusSpec(targets=targets),
            sim=ncp.SimConfig(seed=1),
        )
        told = [session.step(10.0, drive(session, current=[700.0], rate=[100.0], times=[15.0]))]
        if refused:
            with pytest.raises(ncp.ReplyError, match=".*".join(map(str, [said.replace("(", r"\(")]))):
                ask(session)
        told.append(session.step(10.0))
        return [(frame.seq, frame.sim_time_ms, frame.records["v"].values) for frame in told]

    assert frames(refused=True) == frames(refused=False)
