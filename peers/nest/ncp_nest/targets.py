"""Which neurons a port records or drives."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, TypeVar

import nest
from ncp_pure import RecordTarget, SimulationError, StimulusTarget

Target = TypeVar("Target", RecordTarget, StimulusTarget)
Built = TypeVar("Built")


@dataclass(frozen=True)
class Neurons:
    """Neurons of one population. An id is a position within the population, from 1 [NCP-SESS-052]."""

    nodes: Any
    first: int
    ids: list[int]

    @property
    def in_order(self) -> Any:
        """NEST's collection of them."""
        if len(self.ids) == len(self.nodes):
            return self.nodes
        return self.nodes[[neuron - 1 for neuron in sorted(self.ids)]]

    def node(self, neuron: int) -> Any:
        """One of them, by its id."""
        return self.nodes[neuron - 1]

    def default(self, name: str) -> Any:
        """A property of their model."""
        return nest.GetDefaults(self.nodes[0].model).get(name)


def neurons_of(target: Target, populations: dict[str, Any]) -> Neurons:
    """The neurons that a target names [NCP-SESS-055], or a `SimulationError`."""
    if target.target not in populations:
        raise SimulationError(f"there is no population {target.target[:80]!r}")
    nodes = populations[target.target]
    if not all(1 <= neuron <= len(nodes) for neuron in target.ids):
        raise SimulationError(f"population {target.target[:80]!r} has the neurons 1 to {len(nodes)}")
    if len(set(target.ids)) != len(target.ids):
        raise SimulationError(f"port {target.port[:80]!r} names a neuron twice")
    return Neurons(nodes, nodes[0].global_id, list(target.ids) or list(range(1, len(nodes) + 1)))


def by_port(targets: Iterable[Target], build: Callable[[Target], Built]) -> dict[str, Built]:
    """What is built of each target, by its port."""
    ports: dict[str, Built] = {}
    for target in targets:
        if target.port in ports:
            raise SimulationError(f"two targets have the port {target.port[:80]!r}")
        ports[target.port] = build(target)
    return ports
