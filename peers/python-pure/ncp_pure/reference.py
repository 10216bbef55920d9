"""The reference backend: two small networks that are integrated exactly (section 4.4 of the text)."""

from math import exp, expm1, floor, inf, isfinite

from .errors import SimulationError
from .messages import Observation

MAX_NEURONS = 100_000
"""The most neurons of a network."""

MAX_NEURON_STEPS = 20_000_000
"""The most steps, summed over the neurons, that one request may ask for."""

MAX_SAMPLES = 1_000_000
"""The most samples that one request may ask for."""


def whole_steps(time_ms, dt):
    """A time as the nearest number of steps, the greater of two that are equally near [NCP-SESS-058]."""
    steps = time_ms / dt
    if not isfinite(steps):
        return inf
    below = floor(steps)
    return below + (steps - below >= 0.5)


class LifModel:
    """`ncp.reference.lif`: leaky integrate-and-fire neurons [NCP-SESS-050]."""

    PARAMS = {
        "C_m": 250.0,
        "tau_m": 10.0,
        "E_L": -70.0,
        "V_th": -55.0,
        "V_reset": -70.0,
        "t_ref": 2.0,
        "I_e": 0.0,
    }
    INPUT = "current_pA"
    OBSERVABLES = {"V_m": "mV", "spikes": None}

    def __init__(self, params, dt):
        if params["C_m"] <= 0 or params["tau_m"] <= 0 or params["t_ref"] < 0:
            raise SimulationError("C_m and tau_m must be positive, t_ref not negative")
        self._rest = params["E_L"]
        self._threshold = params["V_th"]
        self._reset = params["V_reset"]
        self._decay = exp(-dt / params["tau_m"])
        self._gain = params["tau_m"] / params["C_m"] * -expm1(-dt / params["tau_m"])
        self._bias = params["I_e"]
        self._refractory_steps = whole_steps(params["t_ref"], dt)

    def initial(self):
        """The state of a neuron: its potential, and the steps for which it stays refractory."""
        return (self._rest, 0)

    def step(self, state, current):
        """The next state, and whether the neuron spikes."""
        v, refractory = state
        if refractory:
            return (self._reset, refractory - 1), False
        v = self._rest + (v - self._rest) * self._decay + (self._bias + current) * self._gain
        if v >= self._threshold and isfinite(v):  # what left the doubles is no spike [NCP-SESS-057]
            return (self._reset, self._refractory_steps), True
        return (v, 0), False

    def value(self, state):
        return state[0]


class RateModel:
    """`ncp.reference.rate`: linear rate neurons [NCP-SESS-051]."""

    PARAMS = {"tau": 10.0, "mu": 0.0}
    INPUT = "rate_inject"
    OBSERVABLES = {"rate": "Hz"}

    def __init__(self, params, dt):
        if params["tau"] <= 0:
            raise SimulationError("tau must be positive")
        self._decay = exp(-dt / params["tau"])
        self._rise = -expm1(-dt / params["tau"])  # 1 - P loses the digits of a small step
        self._mu = params["mu"]

    def initial(self):
        return 0.0

    def step(self, rate, x):
        return rate * self._decay + (self._mu + x) * self._rise, False

    def value(self, rate):
        return rate


MODELS = {"ncp.reference.lif": LifModel, "ncp.reference.rate": RateModel}
"""The networks by their names."""


class Simulation:
    """One session's network. What cannot be built [NCP-SESS-060] or done is a `SimulationError`."""

    def __init__(self, network, record, stimulus, sim):
        if network.kind != "builtin" or network.ref not in MODELS:
            raise SimulationError(f"there is no network {network.ref[:80]!r} of kind {network.kind[:40]!r}")
        if not sim.dt_ms > 0:
            raise SimulationError("dt_ms must be positive")
        model = MODELS[network.ref]
        params = {name: network.params.get(name, default) for name, default in model.PARAMS.items()}
        self._model = model(params, sim.dt_ms)
        self._dt = sim.dt_ms
        self._steps = 0
        self.resolved = dict(network.population_sizes)
        if any(size < 0 for size in self.resolved.values()):
            raise SimulationError("a population has less than no neurons")
        if sum(self.resolved.values()) > MAX_NEURONS:
            raise SimulationError(f"more than {MAX_NEURONS} neurons")
        self._recorders = self._ports(record.targets, self._recorder)
        self._inputs = self._ports(stimulus.targets, self._input)
        self._states = {
            name: [self._model.initial()] * size for name, size in self.resolved.items()
        }
        self._drive = {name: [0.0] * size for name, size in self.resolved.items()}

    @property
    def time_ms(self):
        """The simulation time since the start [NCP-SESS-033]."""
        return self._steps * self._dt

    def advance(self, duration_ms, values):
        """Applies the values of the ports and runs for a time; the observation of each recorded port.

        A request that is refused changes neither the network nor the time [NCP-SESS-037].
        """
        if not isfinite(duration_ms) or duration_ms < 0:
            raise SimulationError("a time must be finite and not negative")  # [NCP-SESS-032]
        steps = self._step_count(duration_ms)
        applied = [(self._inputs.get(port), port, value.data) for port, value in values.items()]
        for known, port, data in applied:
            if known is None:
                raise SimulationError(f"there is no stimulus port {port[:80]!r}")
            known.check(data)
        for known, _, data in applied:
            known.set(data)  # [NCP-SESS-054]
        if applied:
            self._sum_inputs()
        observations = {port: recorder.begin() for port, recorder in self._recorders.items()}
        before = {name: list(states) for name, states in self._states.items()}, self._steps
        for _ in range(steps):
            self._step(observations)
            if not self._is_within_doubles():
                self._states, self._steps = before  # [NCP-SESS-057]
                raise SimulationError("a number of the network leaves the doubles")
        return observations

    def _is_within_doubles(self):
        value = self._model.value
        return all(isfinite(value(state)) for states in self._states.values() for state in states)

    def _step_count(self, duration_ms):
        neurons = sum(self.resolved.values())
        steps = whole_steps(duration_ms, self._dt)
        if steps * max(1, neurons) > MAX_NEURON_STEPS:
            raise SimulationError("this would take too long in one request")
        if not isfinite((self._steps + steps) * self._dt):
            raise SimulationError("the time would leave the doubles")  # [NCP-SESS-057]
        samples = sum(
            len(recorder.ids) * (1 if recorder.is_spikes else steps // recorder.every)
            for recorder in self._recorders.values()
        )
        if samples > MAX_SAMPLES:
            raise SimulationError("this would take too many samples in one request")
        return steps

    def _step(self, observations):
        self._steps += 1
        spiked = {}
        for name, states in self._states.items():
            spikes = spiked[name] = set()
            for i, (state, x) in enumerate(zip(states, self._drive[name])):
                states[i], spikes_now = self._model.step(state, x)
                if spikes_now:
                    spikes.add(i + 1)
        for port, recorder in self._recorders.items():
            states = self._states[recorder.population]
            recorder.sample(
                observations[port], self._steps, self.time_ms, states, spiked[recorder.population]
            )

    def _sum_inputs(self):
        for drive in self._drive.values():
            drive[:] = [0.0] * len(drive)
        for port in self._inputs.values():
            drive = self._drive[port.population]
            for neuron, value in zip(port.ids, port.values):
                drive[neuron - 1] += value

    def _ports(self, targets, build):
        ports = {}
        for target in targets:
            if target.port in ports:
                raise SimulationError(f"two targets have the port {target.port[:80]!r}")
            ports[target.port] = build(target, self._neurons(target))
        return ports

    def _neurons(self, target):
        """The ids of a target: positions in the population, from 1 [NCP-SESS-052]."""
        if target.target not in self.resolved:
            raise SimulationError(f"there is no population {target.target[:80]!r}")
        size = self.resolved[target.target]
        if not all(1 <= neuron <= size for neuron in target.ids):
            raise SimulationError(f"population {target.target[:80]!r} has the neurons 1 to {size}")
        return list(target.ids) or list(range(1, size + 1))

    def _recorder(self, target, ids):
        if target.observable not in self._model.OBSERVABLES:
            raise SimulationError(f"this network has no {target.observable[:40]!r}")
        if not target.cadence_ms > 0:
            raise SimulationError("cadence_ms must be positive")
        every = max(1, whole_steps(target.cadence_ms, self._dt))
        return _Recorder(target, ids, every, self._model)

    def _input(self, target, ids):
        if target.kind != self._model.INPUT:
            raise SimulationError(f"this network is driven by {self._model.INPUT} only")
        return _Input(target.target, ids)


class _Recorder:
    """Records one port."""

    def __init__(self, target, ids, every, model):
        self.population = target.target
        self.ids = ids
        self.every = every
        self.is_spikes = target.observable == "spikes"
        self._target = target
        self._model = model

    def begin(self):
        """An empty observation of the port, with its unit [NCP-SESS-056]."""
        observable = self._target.observable
        return Observation(
            port=self._target.port,
            target=self.population,
            observable=observable,
            unit=self._model.OBSERVABLES[observable],
            recordable=None if self.is_spikes else observable,
        )

    def sample(self, observation, step, time_ms, states, spiked):
        """Adds what the end of a step has for this port [NCP-SESS-053]."""
        if self.is_spikes:
            senders = [neuron for neuron in self.ids if neuron in spiked] if spiked else []
        elif step % self.every == 0:
            senders = self.ids
            observation.values += [self._model.value(states[neuron - 1]) for neuron in senders]
        else:
            return
        observation.times += [time_ms] * len(senders)
        observation.senders += senders


class _Input:
    """Drives the neurons of one port [NCP-SESS-055]."""

    def __init__(self, population, ids):
        self.population = population
        self.ids = ids
        self.values = [0.0] * len(ids)

    def check(self, data):
        if len(data) not in (1, len(self.ids)):
            raise SimulationError("a stimulus has one value, or one for each neuron")

    def set(self, data):
        self.values = list(data) if len(data) == len(self.ids) else list(data) * len(self.ids)
