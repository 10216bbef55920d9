#!/usr/bin/env python3
"""How fast NEST runs a balanced random network here, and what the service costs beside it.

The network is `brunel`: 400 excitatory and 100 inhibitory inputs a neuron, g = 5, `iaf_psc_alpha`, spikes recorded
of at most 1,000 neurons. Building is not timed, one run warms up, and the fastest of three counts.

`real-time factor` is biological time over wall time of `nest.Run`. Then, for a small network and several chunks:
`run` (`nest.Run`), `read` (what is new of the recorders, as messages) and `lines` (frames, processes and TCP).

It writes sweep.csv, cost.csv and sweep.svg into .tools/nest-sweep, and prints both tables.
"""

import argparse
import csv
import multiprocessing
import os
import socket
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import ncp_pure as ncp

OUT = Path(__file__).resolve().parents[2] / ".tools" / "nest-sweep"
RECORDED = 1000
REPEATS = 3
PORT = "spk"


class Speed(NamedTuple):
    """One size of the network, with one number of threads."""

    neurons: int
    threads: int
    biological_ms: float
    wall_ms: float
    real_time_factor: float
    rate_hz: float


class Cost(NamedTuple):
    """What a chunk costs, ms, each the mean of a run of many."""

    neurons: int
    chunk_ms: float
    run_ms: float
    read_ms: float
    lines_ms: float


def main() -> None:
    """Runs the sweep."""
    options = _options()
    OUT.mkdir(parents=True, exist_ok=True)
    load = os.getloadavg()[0]
    print(f"{os.cpu_count()} cores, load {load:.1f} before the first run")
    speeds = [
        _apart(measure_speed, neurons, threads, options.duration)
        for threads in options.threads
        for neurons in options.neurons
    ]
    _tell(OUT / "sweep.csv", speeds)
    costs = [measure_cost(options.neurons[0], chunk, options.duration) for chunk in options.chunks]
    _tell(OUT / "cost.csv", costs)
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
    walls, spikes = [], 0
    for _ in range(REPEATS):
        timed.run_ms = 0.0
        observed = simulation.advance(duration_ms, {})
        walls.append(timed.run_ms)
        spikes += len(observed[PORT].times)
    recorded = len(request.record.targets[0].ids)
    rate_hz = spikes / recorded / (REPEATS * duration_ms / 1000.0)
    wall_ms = min(walls)
    return Speed(neurons, threads, duration_ms, round(wall_ms, 1), round(duration_ms / wall_ms, 3), round(rate_hz, 1))


def measure_cost(neurons: int, chunk_ms: float, duration_ms: float) -> Cost:
    """What a chunk costs within the process, and what the way through the service adds."""
    chunks = max(1, round(duration_ms / chunk_ms))
    run_ms, advance_ms = _apart(measure_advance, neurons, chunk_ms, chunks)
    round_trip_ms = measure_round_trip(neurons, chunk_ms, chunks)
    parts = (run_ms, advance_ms - run_ms, round_trip_ms - advance_ms)
    return Cost(neurons, chunk_ms, *(round(part, 4) for part in parts))


def measure_advance(neurons: int, chunk_ms: float, chunks: int) -> tuple[float, float]:
    """The mean wall time of `nest.Run`, and of a chunk with its reading, ms: the fastest of three."""
    from ncp_nest.simulation import Simulation

    timed = _TimedNest()
    simulation = Simulation(opening(neurons, chunk_ms))
    results = []
    for _ in range(REPEATS + 1):
        timed.run_ms, begin = 0.0, time.perf_counter()
        for _ in range(chunks):
            simulation.advance(chunk_ms, {})
        results.append(((time.perf_counter() - begin) * 1000.0 / chunks, timed.run_ms / chunks))
    advance_ms, run_ms = min(results[1:])
    return run_ms, advance_ms


def measure_round_trip(neurons: int, chunk_ms: float, chunks: int) -> float:
    """The mean wall time of a step over the line protocol, ms: the fastest of three."""
    command = [sys.executable, "-m", "ncp_nest", "--listen", "127.0.0.1:0"]
    service = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        host, port = service.stdout.readline().removeprefix("listening on ").rsplit(":", 1)
        with socket.create_connection((host, int(port))) as connection:
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            lines = connection.makefile("rwb")
            ask = _asker(lines)
            request = opening(neurons, chunk_ms)
            ncp.check_reply(request, ask(request))
            step = ncp.StepRequest(session_id=request.session_id)
            walls = []
            for _ in range(REPEATS + 1):
                begin = time.perf_counter()
                replies = [ask(step) for _ in range(chunks)]
                walls.append((time.perf_counter() - begin) * 1000.0 / chunks)
                ncp.check_reply(step, replies[-1])
            return min(walls[1:])
    finally:
        service.terminate()
        service.wait()


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
    for part in ("run_ms", "read_ms", "lines_ms"):
        heights = [max(0.0, getattr(cost, part)) for cost in costs]
        right.bar(names, heights, bottom=bottom, label=part.removesuffix("_ms"))
        bottom = [below + height for below, height in zip(bottom, heights, strict=True)]
    right.set(xlabel="chunk", ylabel="wall time a chunk, ms", yscale="log")
    right.set_title(f"what a chunk of {costs[0].neurons} neurons costs")
    right.legend()
    figure.savefig(OUT / "sweep.svg")


class _TimedNest:
    """NEST with a clock on `Run`, in the place of the module that the simulation uses."""

    def __init__(self) -> None:
        from ncp_nest import simulation

        self._nest = simulation.nest
        self.run_ms = 0.0
        simulation.nest = self

    def __getattr__(self, name: str) -> object:
        return getattr(self._nest, name)

    def Run(self, duration_ms: float) -> None:  # noqa: N802 NEST's name
        begin = time.perf_counter()
        self._nest.Run(duration_ms)
        self.run_ms += (time.perf_counter() - begin) * 1000.0


def _apart(function: object, *args: object) -> object:
    """Calls a function in a process of its own."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(function, args)


def _asker(lines: object) -> object:
    def ask(request: object) -> bytes:
        lines.write(ncp.encode(request) + b"\n")
        lines.flush()
        return lines.readline()

    return ask


def _tell(path: Path, rows: Iterable[NamedTuple]) -> None:
    """Writes a table, and prints it."""
    rows = list(rows)
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(rows[0]._fields)
        writer.writerows(rows)
    print("\n" + path.read_text())


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    sizes = [1000, 2000, 5000, 10000, 20000]
    parser.add_argument("--neurons", type=int, nargs="+", default=sizes, help="sizes of the network")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], help="threads of NEST")
    parser.add_argument("--chunks", type=float, nargs="+", default=[1.0, 10.0, 100.0], help="chunks, ms")
    parser.add_argument("--duration", type=float, default=1000.0, help="biological time of a run, ms")
    return parser.parse_args()


if __name__ == "__main__":
    main()
