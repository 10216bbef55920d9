"""What a session runs, resolved to populations and projections, before NEST is asked."""

import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

from ncp_pure import DecodeError, NetworkRef, SimulationError
from ncp_pure.jsontext import read_object

MAX_NEURONS = 200_000
"""The most neurons of a network."""

MAX_SYNAPSES = 20_000_000
"""The most synapses of a network, as its projections promise them."""

Scalars = dict[str, Any]
"""Names of NEST with numbers, strings or booleans."""


@dataclass(frozen=True)
class Population:
    """Neurons of one model. `params` are NEST's, by its names and units."""

    model: str
    size: int
    params: Scalars


@dataclass(frozen=True)
class Projection:
    """Synapses from one population to another, in the terms of `nest.Connect`."""

    source: str
    target: str
    rule: Scalars
    synapse: Scalars


@dataclass(frozen=True)
class Background:
    """Poisson spikes of a constant rate into each neuron of a population, independent of each other."""

    target: str
    rate_hz: float
    weight: float


@dataclass(frozen=True)
class Network:
    """A network as it was resolved. `name` is for people; the digest tells two networks apart."""

    name: str
    populations: dict[str, Population]
    projections: tuple[Projection, ...] = ()
    background: tuple[Background, ...] = ()

    @property
    def resolved(self) -> dict[str, int]:
        """The neurons a population."""
        return {name: population.size for name, population in self.populations.items()}

    @property
    def neurons(self) -> int:
        """The neurons of all populations."""
        return sum(self.resolved.values())

    @property
    def digest(self) -> str:
        """SHA-256 over all that NEST is told of the network, as JSON with sorted names."""
        text = json.dumps(asdict(self), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(text.encode()).hexdigest()


def resolve(reference: NetworkRef) -> Network:
    """The network that a request names, or a `SimulationError`."""
    kinds: dict[str, Callable[[NetworkRef], Network]] = {"builtin": _builtin, "spec": _spec}
    if reference.kind not in kinds:
        raise SimulationError(f"this server has no network of kind {reference.kind[:40]!r}")
    network = kinds[reference.kind](reference)
    for name, size in network.resolved.items():
        if size < 1:
            raise SimulationError(f"population {name[:80]!r} has no neuron")
    if network.neurons > MAX_NEURONS:
        raise SimulationError(f"more than {MAX_NEURONS} neurons")
    if sum(_synapses(network, projection) for projection in network.projections) > MAX_SYNAPSES:
        raise SimulationError(f"more than {MAX_SYNAPSES} synapses")
    return network


def _builtin(reference: NetworkRef) -> Network:
    """A network that this server brings along: `brunel`, or neurons of one model without synapses."""
    if reference.ref == "brunel":
        return _brunel(reference)
    model = _ALIASES.get(reference.ref, reference.ref)
    if reference.model_name not in (None, model):
        raise SimulationError(f"the network {reference.ref[:80]!r} has no neurons of {reference.model_name[:80]!r}")
    params = {**_ALIAS_PARAMS.get(reference.ref, {}), **reference.params}
    populations = {name: Population(model, size, params) for name, size in reference.population_sizes.items()}
    return Network(reference.ref, populations)


# The text's reference networks as NEST models of the same equations. NEST's stimuli act some steps later
# than section 4.4 of the text wants it, so this server does not claim to have the reference networks.
_ALIASES = {"ncp.reference.lif": "iaf_psc_delta", "ncp.reference.rate": "lin_rate_ipn"}
_ALIAS_PARAMS = {"ncp.reference.lif": {"t_ref": 2.0}, "ncp.reference.rate": {"sigma": 0.0}}

_BRUNEL_SIZES = {"ex": 8000, "in": 2000}

# After NEST's brunel_alpha_nest.py, with 400 + 100 inputs a neuron. The weight makes a postsynaptic potential
# of 0.1 mV; eta gives about 13 spikes a second and neuron.
_BRUNEL_PARAMS = {
    "C_E": 400.0,
    "C_I": 100.0,
    "g": 5.0,
    "eta": 1.1,
    "weight": 20.68015524367846,
    "delay": 1.0,
    "C_m": 250.0,
    "tau_m": 20.0,
    "tau_syn_ex": 0.5,
    "tau_syn_in": 0.5,
    "t_ref": 2.0,
    "E_L": 0.0,
    "V_reset": 0.0,
    "V_m": 0.0,
    "V_th": 20.0,
}
_BRUNEL_OWN = ("C_E", "C_I", "g", "eta", "weight", "delay")


def _brunel(reference: NetworkRef) -> Network:
    """The balanced random network with fixed indegree."""
    if reference.model_name not in (None, "iaf_psc_alpha"):
        raise SimulationError("the neurons of the network 'brunel' are of iaf_psc_alpha")
    for given, known in ((reference.params, _BRUNEL_PARAMS), (reference.population_sizes, _BRUNEL_SIZES)):
        if unknown := given.keys() - known.keys():
            raise SimulationError(f"the network 'brunel' has no {min(unknown)[:80]!r}")
    params = {**_BRUNEL_PARAMS, **reference.params}
    own = {name: params.pop(name) for name in _BRUNEL_OWN}
    sizes = {**_BRUNEL_SIZES, **reference.population_sizes}
    return Network(
        "brunel",
        {name: Population("iaf_psc_alpha", size, params) for name, size in sizes.items()},
        tuple(
            Projection(
                source,
                target,
                {"rule": "fixed_indegree", "indegree": _count(own[indegree], indegree)},
                {"synapse_model": "static_synapse", "weight": weight, "delay": own["delay"]},
            )
            for source, indegree, weight in (
                ("ex", "C_E", own["weight"]),
                ("in", "C_I", -own["g"] * own["weight"]),
            )
            for target in sizes
        ),
        tuple(Background(target, _brunel_rate(own, params), own["weight"]) for target in sizes),
    )


def _brunel_rate(own: dict[str, float], params: dict[str, float]) -> float:
    """The background's rate, Hz: eta times what brings a neuron's mean potential to its threshold."""
    charge = own["weight"] * 2.718281828459045 * params["tau_syn_ex"]
    threshold = params["V_th"] - params["E_L"]
    if not charge > 0 or not params["tau_m"] > 0:
        raise SimulationError("weight, tau_syn_ex and tau_m must be positive")
    return own["eta"] * threshold * params["C_m"] / (charge * params["tau_m"]) * 1000.0


def _count(value: float, name: str) -> int:
    if not value.is_integer() or not 0 <= value <= MAX_NEURONS:
        raise SimulationError(f"{name} must be a whole number of synapses")
    return int(value)


def _spec(reference: NetworkRef) -> Network:
    """A network that `ref` describes as JSON; README.md has the form."""
    if reference.params:
        raise SimulationError("the params of a spec stand with its populations")
    try:
        spec = read_object(reference.ref.encode())
    except DecodeError as error:
        raise SimulationError(f"the spec is {error}") from None
    parts = _members(spec, "the spec", {"populations": dict, "projections": list, "background": list})
    populations = {
        name: _population(name, value, reference.population_sizes) for name, value in parts["populations"].items()
    }
    for name in reference.population_sizes.keys() - populations.keys():
        raise SimulationError(f"the spec has no population {name[:80]!r}")
    projections = tuple(_projection(value, populations) for value in parts["projections"])
    background = tuple(_background(value, populations) for value in parts["background"])
    return Network("spec", populations, projections, background)


def _population(name: str, value: Any, sizes: dict[str, int]) -> Population:
    what = f"population {name[:80]!r}"
    parts = _members(value, what, {"model": str, "size": int, "params": dict})
    return Population(parts["model"], sizes.get(name, parts["size"]), _scalars(parts["params"], what))


def _projection(value: Any, populations: dict[str, Population]) -> Projection:
    parts = _members(value, "a projection", {"source": str, "target": str, "rule": dict, "synapse": dict})
    for end in ("source", "target"):
        _known(parts[end], populations)
    rule, synapse = (_scalars(parts[name], f"a projection's {name}") for name in ("rule", "synapse"))
    if type(synapse.get("delay", 1.0)) not in (int, float):
        raise SimulationError("a projection's delay is no number")
    return Projection(parts["source"], parts["target"], {"rule": "all_to_all", **rule}, synapse)


def _background(value: Any, populations: dict[str, Population]) -> Background:
    parts = _members(value, "a background", {"target": str, "rate_hz": float, "weight": float})
    return Background(_known(parts["target"], populations), parts["rate_hz"], parts["weight"])


def _known(name: str, populations: dict[str, Population]) -> str:
    if name not in populations:
        raise SimulationError(f"the spec has no population {name[:80]!r}")
    return name


def _members(value: Any, what: str, types: dict[str, type]) -> dict[str, Any]:
    """The members of an object, of their types and no others; an absent one is empty or 0."""
    if type(value) is not dict:
        raise SimulationError(f"{what} is no object")
    if unknown := value.keys() - types.keys():
        raise SimulationError(f"{what} has no member {min(unknown)[:80]!r}")
    members = {}
    for name, wanted in types.items():
        member = value.get(name, wanted())
        if wanted is float and type(member) is int:
            member = float(member)
        if type(member) is not wanted:
            raise SimulationError(f"{what}: {name} is not of type {wanted.__name__}")
        members[name] = member
    return members


def _scalars(value: dict[str, Any], what: str) -> Scalars:
    for name, item in value.items():
        if type(item) not in (int, float, str, bool):
            raise SimulationError(f"{what}: {name[:80]!r} is no number, string or boolean")
    return value


def _synapses(network: Network, projection: Projection) -> float:
    """About how many synapses a projection makes."""
    sources = network.populations[projection.source].size
    targets = network.populations[projection.target].size
    rule = projection.rule
    counts: dict[str, Callable[[], float]] = {
        "all_to_all": lambda: sources * targets,
        "one_to_one": lambda: sources,
        "fixed_indegree": lambda: rule["indegree"] * targets,
        "fixed_outdegree": lambda: rule["outdegree"] * sources,
        "fixed_total_number": lambda: rule["N"],
        "pairwise_bernoulli": lambda: rule["p"] * sources * targets,
    }
    try:
        return float(counts[rule["rule"]]())
    except KeyError as error:
        raise SimulationError(f"a projection's rule has no {error}, or there is no such rule") from None
    except (TypeError, ValueError):
        raise SimulationError("a projection's rule has a member of a wrong type") from None
