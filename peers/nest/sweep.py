#!/usr/bin/env python3
"""How fast NEST runs a balanced random network here, and what the service costs beside it.

The network is `brunel`: 400 excitatory and 100 inhibitory inputs a neuron, g = 5, `iaf_psc_alpha`, spikes recorded
of at most 1,000 neurons. Building is not timed, one run warms up, and the fastest of three counts.

The real-time factor is biological time over wall time of `nest.Run`; beside it stands the processor time of all
threads, which tells more when the machine is not idle. Then, for the smallest network and several chunks, what the
fastest chunk costs: `run` (`nest.Run`), `read` (what is new of the recorders, as messages), and `lines` (frames,
processes and TCP) and, with `--gateway`, `zenoh` (what the gateway and a Zenoh client add to that).

It writes sweep.csv, cost.csv and sweep.svg into .tools/nest-sweep, and prints both tables.
"""

import argparse
import csv
import itertools
import multiprocessing
import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple, TypeVar

import ncp_pure as ncp
import through
from through import Ask

OUT = Path(__file__).resolve().parents[2] / ".tools" / "nest-sweep"
RECORDED = 1000
REPEATS = 3
CHUNKS = 200
PORT = "spk"
PATIENCE_S = 60.0
SESSIONS = (f"sweep{number}" for number in itertools.count())

Result = TypeVar("Result")
Row = TypeVar("Row", bound=NamedTuple)


class Speed(NamedTuple):
    """One size of the network, with one number of threads."""

    neurons: int
    threads: int
    biological_ms: float
    wall_ms: float
    processor_ms: float
    real_time_factor: float
    rate_hz: float


class Cost(NamedTuple):
    """What the fastest chunk of many costs, ms."""

    neurons: int
    chunk_ms: float
    run_ms: float
    read_ms: float
    lines_ms: float
    zenoh_ms: float = 0.0


def main() -> None:
    """Runs the sweep."""
    options = _options()
    OUT.mkdir(parents=True, exist_ok=True)
    load = os.getloadavg()[0]
    print(f"{os.cpu_count()} cores, load {load:.1f} before the first run")
    sizes = [(neurons, threads) for threads in options.threads for neurons in options.neurons]
    speeds = _table(OUT / "sweep.csv", Speed, (_apart(measure_speed, *size, options.duration) for size in sizes))
    smallest = min(options.neurons)
    costs = _table(OUT / "cost.csv", Cost, (measure_cost(smallest, chunk, options.gateway) for chunk in options.chunks))
    plot(speeds, costs, load)
    print(f"written to {OUT}")


def opening(neurons: int, chunk_ms: float) -> ncp.OpenSession:
    """The request that opens the network."""
    excitatory = neurons * 4 // 5
    ids = list(range(1, min(RECORDED, excitatory) + 1))
    spikes = ncp.RecordTarget(port=PORT, target="ex", observable="spikes", ids=ids)
    return ncp.OpenSession(
        session_id="sweep",
        network=ncp.NetworkRef(ref="brunel", population_sizes={"ex": excitatory, "in": neurons - excitatory}),
        record=ncp.RecordSpec(targets=[spikes]),
        sim=ncp.SimConfig(seed=1, chunk_ms=chunk_ms),
    )


def measure_speed(neurons: int, threads: int, duration_ms: float) -> Speed:
    """Biological time over wall time, in a process of its own: NEST has one kernel a process."""
    from ncp_nest.simulation import Simulation

    timed = _TimedNest()
    request = opening(neurons, duration_ms)
    simulation = Simulation(request, threads)
    simulation.advance(duration_ms, {})
    runs, spikes = [], 0
    for _ in range(REPEATS):
        observed = simulation.advance(duration_ms, {})
        runs.append((timed.wall_ms, timed.processor_ms))
        spikes += len(observed[PORT].times)
    recorded = len(request.record.targets[0].ids)
    rate_hz = spikes / recorded / (REPEATS * duration_ms / 1000.0)
    wall_ms, processor_ms = map(min, zip(*runs, strict=True))
    return Speed(
        neurons,
        threads,
        duration_ms,
        round(wall_ms, 1),
        round(processor_ms, 1),
        round(duration_ms / wall_ms, 3),
        round(rate_hz, 1),
    )


def measure_cost(neurons: int, chunk_ms: float, gateway: str | None) -> Cost:
    """What a chunk costs within the process, and what the ways through the service and the gateway add."""
    run_ms, advance_ms = _apart(measure_advance, neurons, chunk_ms)
    with service() as address:
        with over_lines(address) as ask:
            lines_ms = measure_steps(ask, neurons, chunk_ms)
        parts = [run_ms, advance_ms - run_ms, lines_ms - advance_ms]
        if gateway:
            with through.gateway(gateway, address, PATIENCE_S) as (bus, _), through.over_zenoh(bus, PATIENCE_S) as ask:
                parts.append(measure_steps(ask, neurons, chunk_ms) - lines_ms)
    return Cost(neurons, chunk_ms, *(round(part, 3) for part in parts))


def measure_advance(neurons: int, chunk_ms: float) -> tuple[float, float]:
    """The wall time of the fastest `nest.Run`, and of the fastest chunk with its reading, ms."""
    from ncp_nest.simulation import Simulation

    timed = _TimedNest()
    simulation = Simulation(opening(neurons, chunk_ms))
    runs, chunks = [], []
    for _ in range(CHUNKS):
        begin = time.perf_counter()
        simulation.advance(chunk_ms, {})
        chunks.append((time.perf_counter() - begin) * 1000.0)
        runs.append(timed.wall_ms)
    return min(runs), min(chunks)


def measure_steps(ask: Ask, neurons: int, chunk_ms: float) -> float:
    """The wall time of the fastest step of a client that asks so, ms."""
    client = ncp.Client(ask, next(SESSIONS))
    request = opening(neurons, chunk_ms)
    client.open(request.network, record=request.record, sim=request.sim)
    trips = []
    for _ in range(CHUNKS):
        begin = time.perf_counter()
        client.step()
        trips.append((time.perf_counter() - begin) * 1000.0)
    client.close()
    return min(trips)


@contextmanager
def service() -> Iterator[tuple[str, int]]:
    """The service, and where it listens."""
    command = [sys.executable, "-m", "ncp_nest", "--listen", "127.0.0.1:0"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        host, port = process.stdout.readline().removeprefix("listening on ").rsplit(":", 1)
        yield host, int(port)
    finally:
        process.terminate()
        process.wait()


@contextmanager
def over_lines(address: tuple[str, int]) -> Iterator[Ask]:
    """Asks over the line protocol."""
    with socket.create_connection(address) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        lines = connection.makefile("rwb")

        def ask(_: str, frame: bytes) -> bytes:
            lines.write(frame + b"\n")
            lines.flush()
            return lines.readline()

        yield ask


def plot(speeds: list[Speed], costs: list[Cost], load: float) -> None:
    """Draws both tables."""
    import matplotlib

    matplotlib.use("svg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
    for threads in sorted({speed.threads for speed in speeds}):
        own = [speed for speed in speeds if speed.threads == threads]
        label = f"{threads} thread{'s' * (threads > 1)}"
        left.plot([s.neurons for s in own], [s.real_time_factor for s in own], "o-", label=label)
    left.axhline(1.0, color="grey", linestyle=":", label="real time")
    left.set(xscale="log", yscale="log", xlabel="neurons", ylabel="real-time factor")
    left.set_title(f"nest.Run, {os.cpu_count()} cores, load {load:.1f}")
    left.legend()
    names, bottom = [f"{cost.chunk_ms:g} ms" for cost in costs], [0.0] * len(costs)
    for part in ("run_ms", "read_ms", "lines_ms", "zenoh_ms"):
        heights = [max(0.0, getattr(cost, part)) for cost in costs]
        right.bar(names, heights, bottom=bottom, label=part.removesuffix("_ms"))
        bottom = [below + height for below, height in zip(bottom, heights, strict=True)]
    right.set(xlabel="chunk", ylabel="wall time a chunk, ms", yscale="log")
    right.set_title(f"what a chunk of {costs[0].neurons} neurons costs")
    right.legend()
    figure.savefig(OUT / "sweep.svg")


class _TimedNest:
    """NEST with clocks on `Run`, in the place of the module that the simulation uses."""

    def __init__(self) -> None:
        from ncp_nest import simulation

        self._nest = simulation.nest
        self.wall_ms = self.processor_ms = 0.0
        simulation.nest = self

    def __getattr__(self, name: str) -> object:
        return getattr(self._nest, name)

    def Run(self, duration_ms: float) -> None:  # noqa: N802 NEST's name
        begin, used = time.perf_counter(), time.process_time()
        self._nest.Run(duration_ms)
        self.wall_ms = (time.perf_counter() - begin) * 1000.0
        self.processor_ms = (time.process_time() - used) * 1000.0


def _apart(function: Callable[..., Result], *args: float) -> Result:
    """Calls a function in a process of its own."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(function, args)


def _table(path: Path, kind: type[Row], rows: Iterable[Row]) -> list[Row]:
    """Writes a table, and prints each row when it is there."""
    told = []
    print("\n" + ",".join(kind._fields), flush=True)
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(kind._fields)
        for row in rows:
            writer.writerow(row)
            print(",".join(map(str, row)), flush=True)
            told.append(row)
    return told


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    sizes = [1000, 2000, 5000, 10000, 20000]
    parser.add_argument("--neurons", type=int, nargs="+", default=sizes, help="sizes of the network")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], help="threads of NEST")
    parser.add_argument("--chunks", type=float, nargs="+", default=[1.0, 10.0, 100.0], help="chunks, ms")
    parser.add_argument("--duration", type=float, default=1000.0, help="biological time of a run, ms")
    parser.add_argument("--gateway", metavar="PROGRAM", help="the program ncp-gateway, to go through it too")
    return parser.parse_args()


if __name__ == "__main__":
    main()
