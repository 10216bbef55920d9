"""Faults of the engine itself, one at a time, which its own checks have to notice.

`explore.py --sabotage NAME` sets one, for tests only; without it nothing here is ever true.
"""

import os

SABOTAGES = {
    "drop-path": "the exploration loses its last path",
    "one-branch": "of each fork only the first branch is followed",
    "sat-as-unsat": "the answer sat counts as a proof",
    "ignore-unknown": "no answer counts as a proof",
    "lose-assumption": "what a property assumes is left out",
    "false-assumption": "what a property assumes is a contradiction",
    "contradiction": "each question is asked together with its negation",
    "skip-conclusion": "what a property says is left out",
    "wrong-operator": "the writer says < for ≤ of doubles",
    "wrong-equality": "without arithmetic, all operations are the same one",
    "no-replay": "a counterexample counts without a run of the code",
    "short-limit": "the solvers are given no resources",
}
CHOSEN = os.environ.get("NCP_MACHINE_SABOTAGE", "")
if CHOSEN and CHOSEN not in SABOTAGES:
    raise SystemExit(f"there is no sabotage {CHOSEN}")


def sabotaged(name):
    """Whether this fault is set."""
    assert name in SABOTAGES
    return name == CHOSEN
