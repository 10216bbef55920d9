"""One network on the NEST kernel of this process: built, run by chunk, read by what is new.

The kernel is reset when the network is built and prepared once, at the end of that. A run is `Run` alone.
`Cleanup` comes at the close, and when a recorder's history has grown long: NEST clears a recorder only while
it is not prepared, and to prepare it again changes no result.
"""

import logging
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

import nest
from ncp_pure import ChannelValue, Observation, OpenSession, SimProvenance, SimulationError

from .frames import BACKEND
from .grid import check_multiple, ms, positive_tics, tics
from .network import Network, Population, resolve
from .recorders import MAX_SAMPLES, Recorder, WeightRecorder, recorder
from .stimuli import WeightSet, stimulus
from .targets import by_port, neurons_of

MAX_NEURON_STEPS = 200_000_000
"""The most steps, summed over the neurons, that one request may ask for."""

MAX_HISTORY = 2_000
"""The samples of a recorder, once read, that NEST may hold on to."""

MAX_REQUESTS = 100_000
"""The requests after which a session can no more be brought back from a failure."""

Data = dict[str, list[float]]
"""The values of stimulus ports."""

nest.verbosity = nest.VerbosityLevel.ERROR


class Lost(SimulationError):
    """A failure from which the session could not be brought back: it is over."""


class Simulation:
    """The network of one session. What it refuses or fails at is a `SimulationError`."""

    def __init__(self, request: OpenSession, threads: int = 1) -> None:
        self.network = resolve(request.network)
        self.chunk_ms = request.sim.chunk_ms
        self.seed = _seed(request.sim.seed)
        self._request = request
        self._threads = threads
        self._resolution = positive_tics(request.sim.dt_ms, "dt_ms")
        positive_tics(self.chunk_ms, "chunk_ms")
        self._past: list[tuple[int, Data]] | None = []
        self._build()

    @property
    def time_ms(self) -> float:
        """The simulation time since the session was opened [NCP-SESS-033]."""
        return ms(self._now)

    @property
    def provenance(self) -> SimProvenance:
        """What runs here and from where [NCP-SESS-039]."""
        return SimProvenance(
            network_ref=f"{self.network.name} sha256:{self.network.digest}",
            backend=BACKEND,
            seed=self.seed,
            note=f"dt_ms={ms(self._resolution)} min_delay_ms={ms(self._min_delay)} chunk_ms={self.chunk_ms}"
            f" threads={self._threads} rng={nest.rng_type}; raw output of a model",
        )

    def advance(self, duration_ms: float, values: dict[str, ChannelValue]) -> dict[str, Observation]:
        """Applies the values of the ports and runs for a time; what is new of each recorded port.

        A request that is refused changes nothing. One that fails in NEST is undone [NCP-SESS-037].
        """
        duration = self._duration(duration_ms)
        for port, value in values.items():
            if port not in self._stimuli:
                raise SimulationError(f"there is no stimulus port {port[:80]!r}")
            self._stimuli[port].check(value, self._now)
        data = {port: value.data for port, value in values.items()}
        try:
            observed = self._run(duration, data)
        except Exception as error:
            self._undo(error)
            raise
        self._remember(duration, data)
        return observed

    def undo_last(self, error: Exception) -> None:
        """Undoes the last `advance`, whose observations could not be told."""
        if self._past:
            self._past.pop()
        self._undo(error)

    def close(self) -> None:
        """Ends the simulation."""
        with suppress(nest.NESTError):  # a network that could not be brought back is not prepared
            nest.Cleanup()

    def _remember(self, duration: int, data: Data) -> None:
        if self._past is not None:
            self._past.append((duration, data))
            if len(self._past) > MAX_REQUESTS:
                self._past = None

    def _undo(self, error: Exception) -> None:
        """Brings the network back to where the last request left it: NEST does not go on after a failure.

        A network is what its requests made of it, so they are run again.
        """
        if self._past is None:
            raise Lost(f"{error}; the session is too old to be brought back") from error
        logging.getLogger(__name__).info("going back over %d requests", len(self._past))
        try:
            self._build()
            for duration, data in self._past:
                self._run(duration, data)
        except Exception as again:
            raise Lost(f"{error}; the session could not be brought back: {again}") from error

    def _build(self) -> None:
        self._now = 0
        with refusals():
            nest.ResetKernel()
            nest.set(resolution=ms(self._resolution), rng_seed=self.seed, local_num_threads=self._threads)
            delay = _device_delay(self.network, ms(self._resolution))
            populations = _create(self.network, delay)
            neurons = sum(populations.values(), start=nest.NodeCollection())
            self._recorders = by_port(
                self._request.record.targets,
                lambda t: recorder(t, neurons_of(t, populations), self._resolution, delay),
            )
            self._stimuli = by_port(
                self._request.stimulus.targets,
                lambda t: stimulus(t, neurons_of(t, populations), self._resolution, delay),
            )
            self._min_delay = tics(nest.min_delay, "min_delay")
            self._check_times()
            nest.Prepare()
            for part in (*self._recorders.values(), *self._stimuli.values()):
                if isinstance(part, WeightRecorder | WeightSet):
                    part.find(neurons)

    def _check_times(self) -> None:
        # A run that is no multiple of min_delay need not be the same as its parts.
        self._check_time(self.chunk_ms, "chunk_ms")
        for part in self._recorders.values():
            if part.cadence:
                check_multiple(part.cadence, self._min_delay, "cadence_ms", "min_delay")

    def _check_time(self, time_ms: float, name: str) -> int:
        time = tics(time_ms, name)
        check_multiple(time, self._resolution, name, "dt_ms")
        check_multiple(time, self._min_delay, name, "the network's min_delay")
        return time

    def _duration(self, duration_ms: float) -> int:
        """The tics of a run [NCP-SESS-032]."""
        duration = self._check_time(duration_ms, "the time to run")
        if duration // self._resolution * max(1, self.network.neurons) > MAX_NEURON_STEPS:
            raise SimulationError("this would take too long in one request")
        if sum(part.expected(duration) for part in self._recorders.values()) > MAX_SAMPLES:
            raise SimulationError("this would take too many samples in one request")
        return duration

    def _run(self, duration: int, data: Data) -> dict[str, Observation]:
        with refusals():
            for port, values in data.items():
                self._stimuli[port].apply(values, self._now)
            end = self._now + duration
            while self._now < end:
                stop = min([end, *(_next(self._now, part.cadence) for part in self._pausing)])
                nest.Run(ms(stop - self._now))
                self._now = stop
                for part in self._pausing:
                    if stop % part.cadence == 0:
                        part.sample(stop)
            observed = {port: part.read(end) for port, part in self._recorders.items()}  # [NCP-SESS-038]
            self._forget()
        return observed

    @property
    def _pausing(self) -> list[Recorder]:
        return [part for part in self._recorders.values() if part.cadence]

    def _forget(self) -> None:
        if any(part.history > MAX_HISTORY for part in self._recorders.values()):
            nest.Cleanup()
            for part in self._recorders.values():
                part.forget()
            nest.Prepare()


@contextmanager
def refusals() -> Iterator[None]:
    """Turns what NEST raises into a `SimulationError`."""
    try:
        yield
    except nest.NESTError as error:
        raise SimulationError(f"NEST: {' '.join(str(error).split())}") from error


def _seed(seed: int | None) -> int:
    """NEST's range of seeds; without one the server chooses."""
    if seed is None:
        return 1 + secrets.randbelow(2**32 - 2)
    if not 1 <= seed <= 2**32 - 2:
        raise SimulationError(f"seed must be 1 to {2**32 - 2}")
    return seed


def _device_delay(network: Network, resolution_ms: float) -> float:
    """The delay of devices, ms: the shortest of the network's, so that they do not shorten its min_delay."""
    synapses = [{"synapse_model": "static_synapse", **each.synapse} for each in network.projections]
    models = [{**nest.GetDefaults(synapse["synapse_model"]), **synapse} for synapse in synapses]
    return min((model["delay"] for model in models if model["has_delay"]), default=resolution_ms)


def _create(network: Network, delay: float) -> dict[str, Any]:
    """The nodes of each population, with all of the network's synapses."""
    for population in network.populations.values():
        _check_model(population)
    nodes = {
        name: nest.Create(population.model, population.size, params=population.params)
        for name, population in network.populations.items()
    }
    for projection in network.projections:
        ends = nodes[projection.source], nodes[projection.target]
        nest.Connect(*ends, conn_spec=projection.rule, syn_spec=projection.synapse)
    for background in network.background:
        generator = nest.Create("poisson_generator", params={"rate": background.rate_hz})
        synapse = {"weight": background.weight, "delay": delay}
        nest.Connect(generator, nodes[background.target], syn_spec=synapse)
    return nodes


def _check_model(population: Population) -> None:
    model = population.model
    if model not in nest.node_models or nest.GetDefaults(model)["element_type"] != "neuron":
        raise SimulationError(f"there is no network and no neuron model {model[:80]!r}")


def _next(now: int, cadence: int) -> int:
    """The next multiple of a cadence."""
    return (now // cadence + 1) * cadence
