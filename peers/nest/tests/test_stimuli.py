"""What drives a session and what is recorded of it, beside NEST driven directly."""

import json

import direct
import ncp_pure as ncp
import nest
import pytest
from conftest import Samples, drive

from ncp_nest.simulation import MAX_HISTORY, Simulation


def open_session(client, network, record=(), stimulus=(), **sim):
    session = client()
    session.open(
        network,
        record=ncp.RecordSpec(targets=list(record)),
        stimulus=ncp.StimulusSpec(targets=list(stimulus)),
        sim=ncp.SimConfig(**{"seed": 1, **sim}),
    )
    return session


def neurons(model, size, **params):
    return ncp.NetworkRef(ref=model, population_sizes={"pop": size}, params=params)


def spec(**parts):
    return ncp.NetworkRef(kind="spec", ref=json.dumps(parts))


SPIKES = ncp.RecordTarget(port="out", target="pop", observable="spikes")


def test_a_poisson_rate_is_that_of_a_scheduled_generator_of_nest(client):
    port = ncp.StimulusTarget(port="in", target="pop", kind="rate_hz", params={"weight": 2.0, "delay": 0.5})
    session = open_session(client, neurons("parrot_neuron", 5), [SPIKES], [port])
    frames = [session.step(50.0, drive(session, **{"in": [200.0]}))]
    frames += [session.step(50.0, drive(session, **{"in": [600.0]}))]

    direct.reset()
    parrots = nest.Create("parrot_neuron", 5)
    spikes = nest.Create("spike_recorder")
    nest.Connect(parrots, spikes, syn_spec={"delay": 0.1})
    generator = nest.Create("inhomogeneous_poisson_generator")
    generator.set(rate_times=[0.1, 50.1], rate_values=[200.0, 600.0])
    nest.Connect(generator, parrots, syn_spec={"weight": 2.0, "delay": 0.5})
    nest.Simulate(100.0)
    assert vars(Samples(frames, "out")) == direct.events(spikes)
    assert len(frames[0].records["out"].times) * 2 < len(frames[1].records["out"].times)


def test_spikes_come_at_their_times_and_those_ahead_stay(client):
    port = ncp.StimulusTarget(port="in", target="pop", kind="spike_times", ids=[2])
    session = open_session(client, neurons("parrot_neuron", 3), [SPIKES], [port])
    frames = [session.step(10.0, drive(session, **{"in": [1.0, 25.0]}))]
    frames += [session.step(10.0, drive(session, **{"in": [12.5]}))]
    frames += [session.step(10.0)]
    out = Samples(frames, "out")
    assert [round(time, 6) for time in out.times] == [1.1, 12.6, 25.1]  # the delay of a device is one step
    assert out.senders == [2, 2, 2]


def test_a_current_reaches_the_neurons_that_a_port_names_and_no_others(client):
    port = ncp.StimulusTarget(port="in", target="pop", ids=[3, 1])
    session = open_session(client, neurons("iaf_psc_alpha", 4), [SPIKES], [port])
    frame = session.run(100.0, drive(session, **{"in": [0.0, 900.0]}))
    assert set(frame.records["out"].senders) == {1}
    frame = session.run(100.0, drive(session, **{"in": [900.0]}))
    assert set(frame.records["out"].senders) == {1, 3}


def test_rate_neurons_take_an_input_and_tell_their_rate(client):
    record = ncp.RecordTarget(port="out", target="pop", observable="rate", cadence_ms=1.0)
    port = ncp.StimulusTarget(port="in", target="pop", kind="rate_inject")
    network = neurons("lin_rate_ipn", 2, sigma=0.0, tau=10.0)
    session = open_session(client, network, [record], [port])
    frames = [session.step(100.0, drive(session, **{"in": [50.0]})), session.step(100.0)]
    observed = frames[1].records["out"]
    assert observed.unit == "Hz" and observed.recordable == "rate"
    assert observed.values[-1] == pytest.approx(50.0, rel=1e-6)
    assert observed.senders[:4] == [1, 2, 1, 2]


def test_the_rate_of_spiking_neurons_counts_their_spikes_by_cadence(client):
    rate = ncp.RecordTarget(port="rate", target="pop", observable="rate", cadence_ms=20.0)
    port = ncp.StimulusTarget(port="in", target="pop", kind="spike_times")
    session = open_session(client, neurons("parrot_neuron", 4), [rate, SPIKES], [port])
    frames = [session.step(30.0, drive(session, **{"in": [1.0, 2.0, 19.9, 20.0, 35.0]})), session.step(30.0)]
    out = Samples(frames, "rate")
    assert out.times == [20.0, 40.0, 60.0] and out.senders == []
    assert out.values == pytest.approx([150.0, 100.0, 0.0])  # a spike at 20.0 ms belongs to what ends there
    assert [frame.records["rate"].unit for frame in frames] == ["Hz", "Hz"]


@pytest.mark.parametrize(
    "model, recordable, unit",
    [("aeif_cond_alpha", "w", "pA"), ("aeif_cond_alpha", "g_ex", "nS"), ("izhikevich", "U_m", "mV")],
)
def test_what_a_multimeter_offers_is_recorded_by_its_name(client, model, recordable, unit):
    record = ncp.RecordTarget(port="out", target="pop", recordables=[recordable], ids=[2], cadence_ms=0.5)
    port = ncp.StimulusTarget(port="in", target="pop", kind="rate_hz", params={"weight": 5.0})
    session = open_session(client, neurons(model, 2), [record], [port])
    frame = session.run(20.0, drive(session, **{"in": [3000.0]}))

    direct.reset()
    nodes = nest.Create(model, 2)
    meter = nest.Create("multimeter", params={"record_from": [recordable], "interval": 0.5})
    nest.Connect(meter, nodes[1], syn_spec={"delay": 0.1})
    generator = nest.Create("inhomogeneous_poisson_generator")
    generator.set(rate_times=[0.1], rate_values=[3000.0])
    nest.Connect(generator, nodes, syn_spec={"weight": 5.0, "delay": 0.1})
    nest.Simulate(20.0)
    assert vars(Samples([frame], "out")) == direct.events(meter, recordable)
    observed = frame.records["out"]
    assert (observed.unit, observed.recordable) == (unit, recordable)
    assert len(set(observed.values)) > 1


def test_binary_neurons_tell_their_state(client):
    record = ncp.RecordTarget(port="out", target="pop", observable="binary_state")
    session = open_session(client, neurons("ginzburg_neuron", 20, theta=0.0), [record])
    states = session.run(50.0).records["out"].values
    assert set(states) == {0.0, 1.0}


FEED = {
    "populations": {
        "a": {"model": "parrot_neuron", "size": 2},
        "pop": {"model": "iaf_psc_alpha", "size": 3, "params": {"tau_m": 15.0}},
    },
    "projections": [{"source": "a", "target": "pop", "synapse": {"weight": 100.0, "delay": 2.0}}],
}


def test_a_spec_is_built_as_it_says_and_a_weight_is_set_and_read(client):
    record = [
        ncp.RecordTarget(port="w", target="a", observable="weight", cadence_ms=10.0),
        ncp.RecordTarget(port="v", target="pop", cadence_ms=2.0),
    ]
    stimulus = [
        ncp.StimulusTarget(port="spikes", target="a", kind="spike_times"),
        ncp.StimulusTarget(port="weight", target="a", kind="weight_set"),
    ]
    session = open_session(client, spec(**FEED), record, stimulus)
    frames = [session.step(20.0, drive(session, spikes=[2.0, 22.0]))]
    frames += [session.step(20.0, drive(session, weight=[700.0]))]

    weights = Samples(frames, "w")
    assert weights.times == [10.0] * 6 + [20.0] * 6 + [30.0] * 6 + [40.0] * 6
    assert weights.values == [100.0] * 12 + [700.0] * 12
    assert sorted(weights.senders[:6]) == [1, 1, 1, 2, 2, 2]

    direct.reset()
    neurons_ = nest.Create("iaf_psc_alpha", 3, params={"tau_m": 15.0})
    parrots = nest.Create("parrot_neuron", 2)
    nest.Connect(parrots, neurons_, syn_spec={"weight": 100.0, "delay": 2.0})
    meter = nest.Create("multimeter", params={"record_from": ["V_m"], "interval": 2.0})
    nest.Connect(meter, neurons_, syn_spec={"delay": 2.0})
    generator = nest.Create("spike_generator", params={"spike_times": [2.0, 22.0]})
    nest.Connect(generator, parrots, syn_spec={"delay": 2.0})
    nest.Simulate(20.0)
    nest.GetConnections(parrots, neurons_).set(weight=700.0)
    nest.Simulate(20.0)
    assert vars(Samples(frames, "v")) == direct.events(meter, "V_m")


def test_a_population_may_have_another_size_than_its_spec_says(client):
    session = client()
    network = spec(**FEED)
    network.population_sizes = {"pop": 7}
    assert session.open(network).resolved == {"a": 2, "pop": 7}


def test_a_value_stays_over_long_silence_and_many_read_samples(client):
    record = [SPIKES, ncp.RecordTarget(port="v", target="pop", cadence_ms=0.1)]
    port = ncp.StimulusTarget(port="in", target="pop")
    session = open_session(client, neurons("iaf_psc_alpha", 1), record, [port], chunk_ms=250.0)
    frames = [session.step(stimulus=drive(session, **{"in": [600.0]}))]
    frames += [session.step() for _ in range(11)]
    wanted = direct.family("iaf_psc_alpha", 1, {0.1: 600.0}, 3000.0)
    assert vars(Samples(frames, "out")) == wanted["spk"]
    assert vars(Samples(frames, "v")) == wanted["v"]


def test_what_nest_holds_of_a_recorder_stays_small_over_a_long_session():
    session = ncp.OpenSession(
        session_id="s",
        network=neurons("iaf_psc_alpha", 2),
        record=ncp.RecordSpec(targets=[ncp.RecordTarget(port="v", target="pop", cadence_ms=0.1)]),
    )
    simulation = Simulation(session)
    held = []
    for _ in range(100):
        simulation.advance(10.0, {})
        held.append(nest.GetNodes({"element_type": "recorder"}).get("n_events"))
    simulation.close()
    assert max(held) <= MAX_HISTORY
    assert held.count(0) == 9, "it is cleared after each eleventh step"
