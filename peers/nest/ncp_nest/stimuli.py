"""What drives a session: a stimulus a port.

Values come between runs. They go to generators with scheduled times, at the earliest time that NEST takes,
one step from now; what a generator was told before stays in force until then. Changing the amplitude of a
running generator would not be exact.
"""

from abc import ABC, abstractmethod
from math import isfinite
from typing import Any

import nest
from ncp_pure import ChannelValue, SimulationError, StimulusTarget

from .grid import check_multiple, ms, tics
from .targets import Neurons

PARAMS = {"weight", "delay", "receptor_type"}
"""The params of a stimulus: of the synapses between its generator and the neurons."""


class Stimulus(ABC):
    """Drives one port."""

    unit: str | None = None
    """The unit of its values; none: it is the model's affair."""

    def __init__(self, target: StimulusTarget) -> None:
        self.port = target.port

    def check(self, value: ChannelValue, now: int) -> None:
        """Refuses a value that cannot be applied at a time in tics; changes nothing."""
        if self.unit and value.unit not in (None, self.unit):
            raise SimulationError(f"port {self.port[:80]!r} is in {self.unit}, not {value.unit[:40]!r}")
        if not all(map(isfinite, value.data)):
            raise SimulationError(f"a value of port {self.port[:80]!r} is not finite")
        self.check_data(value.data, now)

    @abstractmethod
    def check_data(self, data: list[float], now: int) -> None:
        """Refuses values."""

    @abstractmethod
    def apply(self, data: list[float], now: int) -> None:
        """Applies values that were checked."""


def stimulus(target: StimulusTarget, neurons: Neurons, resolution: int, delay: float) -> Stimulus:
    """The stimulus of a target, connected, or a `SimulationError`."""
    if target.kind == "weight_set":
        return WeightSet(target, neurons)
    synapse = _synapse(target, resolution, delay)
    if target.kind == "spike_times":
        return SpikeTimes(target, neurons, resolution, synapse)
    if target.kind not in _SCHEDULED:
        raise SimulationError(f"port {target.port[:80]!r}: there is no stimulus {target.kind[:40]!r}")
    return _SCHEDULED[target.kind](target, neurons, resolution, synapse)


def _synapse(target: StimulusTarget, resolution: int, delay: float) -> dict[str, Any]:
    """How the generator of a target reaches its neurons."""
    if unknown := target.params.keys() - PARAMS:
        raise SimulationError(f"port {target.port[:80]!r}: a stimulus has no {min(unknown)[:80]!r}")
    synapse: dict[str, Any] = {"delay": delay, **target.params}
    check_multiple(tics(synapse["delay"], "delay"), resolution, "delay", "dt_ms")
    if "receptor_type" in synapse:
        if not synapse["receptor_type"].is_integer():
            raise SimulationError("receptor_type must be a whole number")
        synapse["receptor_type"] = int(synapse["receptor_type"])
    return synapse


class Scheduled(Stimulus):
    """A generator that follows a schedule: one for all, or, when the target names ids, one a neuron."""

    model: str
    times: str
    values: str
    synapse_model = "static_synapse"

    def __init__(self, target: StimulusTarget, neurons: Neurons, resolution: int, synapse: dict[str, Any]) -> None:
        super().__init__(target)
        self._step = resolution
        self._generators = nest.Create(self.model, len(target.ids) or 1)
        spec = {"synapse_model": self.synapse_model, **synapse}
        if target.ids:
            for generator, neuron in zip(self._generators, neurons.ids, strict=True):
                nest.Connect(generator, neurons.node(neuron), syn_spec=spec)
        else:
            nest.Connect(self._generators, neurons.in_order, syn_spec=spec)

    def check_data(self, data: list[float], now: int) -> None:
        if len(data) not in (1, len(self._generators)):
            each = f", or one for each of its {len(self._generators)} ids" if len(self._generators) > 1 else ""
            raise SimulationError(f"port {self.port[:80]!r} takes one value{each}, not {len(data)}")

    def apply(self, data: list[float], now: int) -> None:
        # [NCP-SESS-054] The value stays until another comes.
        time = [ms(now + self._step)]
        if len(data) == 1:
            self._generators.set({self.times: time, self.values: data})
        else:
            self._generators.set([{self.times: time, self.values: [value]} for value in data])


class Current(Scheduled):
    """A direct current into each neuron."""

    unit = "pA"
    model, times, values = "step_current_generator", "amplitude_times", "amplitude_values"


class PoissonRate(Scheduled):
    """Poisson spikes into each neuron, independent of each other."""

    unit = "Hz"
    model, times, values = "inhomogeneous_poisson_generator", "rate_times", "rate_values"

    def check_data(self, data: list[float], now: int) -> None:
        super().check_data(data, now)
        if min(data) < 0:
            raise SimulationError(f"a rate of port {self.port[:80]!r} is negative")


class RateInject(Scheduled):
    """An input to rate neurons."""

    model, times, values = "step_rate_generator", "amplitude_times", "amplitude_values"
    synapse_model = "rate_connection_delayed"


_SCHEDULED: dict[str, type[Scheduled]] = {
    "current_pA": Current,
    "rate_hz": PoissonRate,
    "rate_inject": RateInject,
}


class SpikeTimes(Stimulus):
    """Spikes at stated times, into each neuron. Times that lie ahead stay when others come."""

    unit = "ms"

    def __init__(self, target: StimulusTarget, neurons: Neurons, resolution: int, synapse: dict[str, Any]) -> None:
        super().__init__(target)
        self._resolution = resolution
        self._ahead: list[int] = []
        self._generator = nest.Create("spike_generator")
        nest.Connect(self._generator, neurons.in_order, syn_spec=synapse)

    def check_data(self, data: list[float], now: int) -> None:
        for time in data:
            spike = tics(time, f"a spike time of port {self.port[:80]!r}")
            check_multiple(spike, self._resolution, "a spike time", "dt_ms")
            if spike <= now:
                raise SimulationError(f"a spike at {time} ms is not ahead: it is {ms(now)} ms")

    def apply(self, data: list[float], now: int) -> None:
        spikes = [tics(time, "a spike time") for time in data]
        self._ahead = sorted([*(time for time in self._ahead if time > now), *spikes])
        self._generator.set(spike_times=[ms(time) for time in self._ahead])


class WeightSet(Stimulus):
    """A new weight for the synapses that the neurons of the target have onto others."""

    def __init__(self, target: StimulusTarget, neurons: Neurons) -> None:
        super().__init__(target)
        if target.params:
            raise SimulationError(f"port {self.port[:80]!r}: a weight_set has no params")
        self._neurons = neurons
        self._synapses: Any = None

    def find(self, all_neurons: Any) -> None:
        """Finds the synapses. Preparing the kernel sorts them, so it is prepared by then."""
        self._synapses = nest.GetConnections(self._neurons.in_order, all_neurons)
        if len(self._synapses) == 0:
            raise SimulationError(f"port {self.port[:80]!r}: its neurons have no synapse onto others")

    def check_data(self, data: list[float], now: int) -> None:
        if len(data) != 1:
            raise SimulationError(f"port {self.port[:80]!r} takes one value, not {len(data)}")

    def apply(self, data: list[float], now: int) -> None:
        self._synapses.set(weight=data[0])
