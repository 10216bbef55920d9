"""Simulation time as NEST counts it: in whole tics, a thousand a millisecond."""

from math import isclose, isfinite

from ncp_pure import SimulationError

TICS_PER_MS = 1000
"""NEST's own, of which a resolution is a multiple."""

MAX_TICS = 10**15
"""The longest time that is counted: 10^12 ms."""


def tics(time_ms: float, name: str) -> int:
    """A time in tics. `name` says in the error what it is."""
    if not isfinite(time_ms) or time_ms < 0:
        raise SimulationError(f"{name} must be finite and not negative")  # [NCP-SESS-032]
    exact = time_ms * TICS_PER_MS
    if exact > MAX_TICS:
        raise SimulationError(f"{name} of {time_ms} ms is too long")
    whole = round(exact)
    if not isclose(exact, whole, rel_tol=1e-14, abs_tol=1e-6):
        raise SimulationError(f"{name} of {time_ms} ms is no multiple of {1 / TICS_PER_MS} ms")
    return whole


def positive_tics(time_ms: float, name: str) -> int:
    """A time in tics that is not 0."""
    time = tics(time_ms, name)
    if time == 0:
        raise SimulationError(f"{name} must be positive")
    return time


def check_multiple(time: int, of: int, name: str, of_name: str) -> None:
    """Refuses a time in tics that is no multiple of another."""
    if time % of:
        raise SimulationError(f"{name} of {ms(time)} ms is no multiple of {of_name}, {ms(of)} ms")


def ms(time: int) -> float:
    """A time in tics, in milliseconds."""
    return time / TICS_PER_MS
