"""What a session records: a recorder a port, each read by what is new since it was last read.

NEST gives a recorder's whole history, and forgets it only between `Cleanup` and `Prepare`. A recorder here
remembers how much it has read; `history` says how much NEST holds, and `forget` clears it.
"""

from abc import ABC, abstractmethod
from collections import Counter
from typing import Any

import nest
import numpy
from ncp_pure import Observation, RecordTarget, SimulationError

from .grid import check_multiple, ms, positive_tics, tics
from .targets import Neurons

MAX_SAMPLES = 1_000_000
"""The most samples that one request may ask for, so that its reply is a frame."""

UNITS = {
    **dict.fromkeys(("V_m", "U_m", "V_th", "theta", "E_sfa"), "mV"),
    **dict.fromkeys(("g_ex", "g_in", "g_ahp", "g_sfa", "g_rr"), "nS"),
    **dict.fromkeys(("I_syn_ex", "I_syn_in", "I_syn", "w", "I_stc"), "pA"),
    **dict.fromkeys(("rate", "noise"), "Hz"),
}
"""The units of NEST's recordables, where they are the same in every model."""

RECORDABLES = {"V_m": "V_m", "rate": "rate", "binary_state": "S"}
"""What is recorded of an observable when a target names no recordable."""


class Recorder(ABC):
    """Records one port."""

    cadence: int | None = None
    """The tics at whose multiples a run has to stop for this recorder; none: it needs no stop."""

    history = 0
    """The samples that NEST holds of it."""

    @abstractmethod
    def expected(self, duration: int) -> int:
        """The most samples of a run of so many tics, as far as can be told before."""

    @abstractmethod
    def read(self, now: int) -> Observation:
        """What was recorded since the last call."""

    def sample(self, now: int) -> None:  # noqa: B027 most have no need of it
        """Called at each multiple of the cadence."""

    def forget(self) -> None:  # noqa: B027 most hold nothing
        """Clears what NEST holds. The kernel is not prepared then."""


def recorder(target: RecordTarget, neurons: Neurons, resolution: int, delay: float) -> Recorder:
    """The recorder of a target, connected, or a `SimulationError`."""
    if target.observable == "spikes":
        if target.recordables:
            raise SimulationError(f"port {target.port[:80]!r}: spikes have no recordable")
        return SpikeRecorder(target, neurons, delay)
    cadence = positive_tics(target.cadence_ms, "cadence_ms")
    check_multiple(cadence, resolution, "cadence_ms", "dt_ms")
    if target.observable == "weight":
        return WeightRecorder(target, neurons, cadence)
    known = neurons.default("recordables") or ()
    if target.observable == "rate" and not target.recordables and "rate" not in known:
        return RateRecorder(target, neurons, cadence, delay)
    name = _recordable(target)
    if name not in known:
        raise SimulationError(
            f"port {target.port[:80]!r}: {neurons.nodes[0].model} offers {', '.join(known) or 'nothing'}"
            f", not {name[:80]!r}"
        )
    return Multimeter(target, neurons, cadence, name, delay)


def _recordable(target: RecordTarget) -> str:
    if len(target.recordables) > 1:
        # [NCP-SESS-038] A port has one observation, and that has one recordable.
        raise SimulationError(f"port {target.port[:80]!r} names several recordables: give each its own port")
    if target.recordables:
        return target.recordables[0]
    if target.observable not in RECORDABLES:
        raise SimulationError(f"port {target.port[:80]!r}: there is no observable {target.observable[:40]!r}")
    return RECORDABLES[target.observable]


class _DeviceRecorder(Recorder):
    """Records with a recording device of NEST."""

    def __init__(self, target: RecordTarget, neurons: Neurons, device: Any) -> None:
        self._target = target
        self._first = neurons.first
        self._device = device

    def _new(self, value: str | None = None) -> tuple[Any, Any, Any]:
        """The times in ms, senders and values since the last call, by time and then sender."""
        events = self._device.get("events")
        seen, self.history = self.history, len(events["times"])
        if self.history - seen > MAX_SAMPLES:
            raise SimulationError(f"port {self._target.port[:80]!r} has more than {MAX_SAMPLES} samples")
        times, senders = events["times"][seen:], events["senders"][seen:].astype(numpy.int64) - self._first + 1
        order = numpy.lexsort((senders, times))
        values = events[value][seen:][order] if value else numpy.empty(0)
        return times[order], senders[order], values

    def forget(self) -> None:
        self._device.n_events = 0
        self.history = 0


class SpikeRecorder(_DeviceRecorder):
    """Each spike, when it occurs, whatever the cadence."""

    def __init__(self, target: RecordTarget, neurons: Neurons, delay: float) -> None:
        super().__init__(target, neurons, _spike_recorder(neurons, delay))

    def expected(self, duration: int) -> int:
        return 0  # that is known when they are read

    def read(self, now: int) -> Observation:
        times, senders, _ = self._new()
        return _observation(self._target, times=times.tolist(), senders=senders.tolist())


class Multimeter(_DeviceRecorder):
    """A recordable of each neuron, at each multiple of the cadence.

    NEST hands a sample over one min_delay after its time, so the last ones come with the next frame.
    """

    def __init__(self, target: RecordTarget, neurons: Neurons, cadence: int, name: str, delay: float) -> None:
        device = nest.Create("multimeter", params={"record_from": [name], "interval": ms(cadence)})
        nest.Connect(device, neurons.in_order, syn_spec={"delay": delay})
        super().__init__(target, neurons, device)
        self._name = name
        self._size = len(neurons.ids)
        self._interval = cadence

    def expected(self, duration: int) -> int:
        return self._size * (duration // self._interval + 1)

    def read(self, now: int) -> Observation:
        times, senders, values = self._new(self._name)
        return _observation(
            self._target,
            times=times.tolist(),
            senders=senders.tolist(),
            values=values.tolist(),
            unit=UNITS.get(self._name),  # [NCP-SESS-056]
            recordable=self._name,
        )


class RateRecorder(_DeviceRecorder):
    """The mean rate of spiking neurons over each cadence: one sample for all of them, without a sender."""

    def __init__(self, target: RecordTarget, neurons: Neurons, cadence: int, delay: float) -> None:
        super().__init__(target, neurons, _spike_recorder(neurons, delay))
        self._interval = cadence
        self._per_spike = 1.0 / (len(neurons.ids) * ms(cadence) / 1000.0)
        self._next = 1
        self._spikes: Counter[int] = Counter()

    def expected(self, duration: int) -> int:
        return duration // self._interval + 1

    def read(self, now: int) -> Observation:
        times, _, _ = self._new()
        # A spike at the end of an interval belongs to it.
        self._spikes.update(-(-tics(time, "a spike's time") // self._interval) for time in times.tolist())
        intervals = range(self._next, now // self._interval + 1)
        self._next = intervals.stop
        return _observation(
            self._target,
            times=[ms(interval * self._interval) for interval in intervals],
            values=[self._spikes.pop(interval, 0) * self._per_spike for interval in intervals],
            unit="Hz",
        )


class WeightRecorder(Recorder):
    """The weight of each synapse that a neuron of the target has onto others, at each multiple of the cadence."""

    def __init__(self, target: RecordTarget, neurons: Neurons, cadence: int) -> None:
        self._target = target
        self._neurons = neurons
        self.cadence = cadence
        self._synapses: Any = None
        self._senders: list[int] = []
        self._read = _observation(target, recordable="weight")

    def find(self, all_neurons: Any) -> None:
        """Finds the synapses. Preparing the kernel sorts them, so it is prepared by then."""
        self._synapses = nest.GetConnections(self._neurons.in_order, all_neurons)
        sources = numpy.atleast_1d(self._synapses.get("source")) if len(self._synapses) else numpy.empty(0)
        self._senders = (sources.astype(numpy.int64) - self._neurons.first + 1).tolist()

    def expected(self, duration: int) -> int:
        return len(self._senders) * (duration // self.cadence + 1)

    def sample(self, now: int) -> None:
        if not self._senders:
            return
        self._read.times += [ms(now)] * len(self._senders)
        self._read.senders += self._senders
        self._read.values += numpy.atleast_1d(self._synapses.get("weight")).tolist()

    def read(self, now: int) -> Observation:
        observed, self._read = self._read, _observation(self._target, recordable="weight")
        return observed


def _spike_recorder(neurons: Neurons, delay: float) -> Any:
    device = nest.Create("spike_recorder")
    nest.Connect(neurons.in_order, device, syn_spec={"delay": delay})
    return device


def _observation(target: RecordTarget, **samples: Any) -> Observation:
    return Observation(port=target.port, target=target.target, observable=target.observable, **samples)
