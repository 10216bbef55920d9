"""NEST driven directly, in the process of the tests: what the service has to be equal to, bit for bit."""

from typing import Any

import nest
import numpy

nest.verbosity = nest.VerbosityLevel.ERROR


def reset(seed: int = 1, dt_ms: float = 0.1) -> None:
    nest.ResetKernel()
    nest.set(resolution=dt_ms, rng_seed=seed, local_num_threads=1)


def family(model: str, size: int, schedule: dict[float, float], duration_ms: float) -> dict[str, Any]:
    """Spikes and V_m of unconnected neurons under a current that steps at stated times."""
    reset()
    neurons = nest.Create(model, size)
    spikes = nest.Create("spike_recorder")
    nest.Connect(neurons, spikes, syn_spec={"delay": 0.1})
    meter = nest.Create("multimeter", params={"record_from": ["V_m"], "interval": 0.1})
    nest.Connect(meter, neurons, syn_spec={"delay": 0.1})
    current = nest.Create("step_current_generator")
    current.set(amplitude_times=list(schedule), amplitude_values=list(schedule.values()))
    nest.Connect(current, neurons, syn_spec={"delay": 0.1})
    nest.Simulate(duration_ms)
    return {"spk": events(spikes), "v": events(meter, "V_m")}


def events(device: Any, value: str | None = None) -> dict[str, list]:
    """A device's events, by time and then sender. The first nodes are the neurons, so a sender is an id."""
    recorded = device.events
    order = numpy.lexsort((recorded["senders"], recorded["times"]))
    return {
        "times": recorded["times"][order].tolist(),
        "senders": recorded["senders"][order].astype(int).tolist(),
        "values": recorded[value][order].tolist() if value else [],
    }
