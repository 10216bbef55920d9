"""Controls: questions whose answers are known, asked of the engine before it is believed.

Each is asked as the properties are, through the same exploration, writer and solvers. What comes out otherwise is a
fault of the engine, and its word on the kernel means nothing.
"""

import struct

import claripy

import solver
from properties import RNE, Property, alive, fp, iff, number, positive


def control(name, conclusion, assume=lambda i: []):
    """A property of `within_deadline`, which is a small function with forks and sums of doubles."""
    return Property(f"control/{name}", "control", "within_deadline", (), name, "", conclusion, assume)


def _is_due(i):
    """Of age 100 ms as computed, with a ttl of 100 ms: alive, since the end counts."""
    return [i["now_s"] == _bits(0.1), i["received_s"] == 0, i["ttl_ms"] == _bits(100.0)]


def _bits(value):
    return int.from_bytes(struct.pack("<d", value), "little")


TRUE = (
    control("what holds is proved", lambda i, o: iff(o["answer"] == 1, alive(i["now_s"], i["received_s"], i["ttl_ms"]))),
    control("what is assumed counts", lambda i, o: o["answer"] == 0, lambda i: [claripy.Not(positive(i["ttl_ms"]))]),
    control("the end of a ttl counts", lambda i, o: o["answer"] == 1, _is_due),
)
FALSE = (
    control("what is wrong of most inputs is refuted", lambda i, o: o["answer"] == 1),
    control("what is wrong of few inputs is refuted", lambda i, o: o["answer"] == 0),
    control("what is wrong of one input is refuted", lambda i, o: o["answer"] == 0, _is_due),
)

X, Y = claripy.BVS("control_x", 64), claripy.BVS("control_y", 64)
A, B = fp(X), fp(Y)


def _with(a, b, formula):
    return [X == _bits(a), Y == _bits(b), formula]


# Formulas over two doubles, and whether they can be satisfied.
WRITTEN = {
    "1 ≤ 1": (_with(1.0, 1.0, claripy.fpLEQ(A, B)), True),
    "1 < 1": (_with(1.0, 1.0, claripy.fpLT(A, B)), False),
    "1 ≥ 1": (_with(1.0, 1.0, claripy.fpGEQ(A, B)), True),
    "1 > 1": (_with(1.0, 1.0, claripy.fpGT(A, B)), False),
    "0 = -0": (_with(0.0, -0.0, claripy.fpEQ(A, B)), True),
    "NaN = NaN": (_with(float("nan"), float("nan"), claripy.fpEQ(A, B)), False),
    "0.1 + 0.2 = 0.3": (_with(0.1, 0.2, claripy.fpEQ(claripy.fpAdd(RNE, A, B), number(0.3))), False),
    "0.1 + 0.2 > 0.3": (_with(0.1, 0.2, claripy.fpGT(claripy.fpAdd(RNE, A, B), number(0.3))), True),
    "0.3 - 0.1 < 0.2": (_with(0.3, 0.1, claripy.fpLT(claripy.fpSub(RNE, A, B), number(0.2))), True),
    "3 · 0.1 > 0.3": (_with(3.0, 0.1, claripy.fpGT(claripy.fpMul(RNE, A, B), number(0.3))), True),
    "1 / 3 = 0.333…": (_with(1.0, 3.0, claripy.fpEQ(claripy.fpDiv(RNE, A, B), number(1.0 / 3.0))), True),
    "√2 = 1.414…": (_with(2.0, 0.0, claripy.fpEQ(claripy.fpSqrt(RNE, A), number(2.0**0.5))), True),
}
# √x·√x is never 2: it takes longer than a solver may take here.
LONG = [claripy.fpEQ(claripy.fpMul(RNE, claripy.fpSqrt(RNE, A), claripy.fpSqrt(RNE, A)), number(2.0))]
SHORT_CALLS, SHORT_RESOURCES = 50, 1_000


def faults(prove):
    """What is wrong with the engine, in words; `prove` shows a property."""
    found = []
    for wanted in TRUE:
        verdict = prove(wanted)["verdict"]
        if verdict != "proved":
            found.append(f"{wanted.id}: it is true, and was {verdict}")
    for wanted in FALSE:
        result = prove(wanted)
        if result["verdict"] != "refuted" or not result["counterexample"]["inputs"]:
            found.append(f"{wanted.id}: it is false, and was {result['verdict']}")
    for name, (formulas, is_possible) in WRITTEN.items():
        words = {solver.ask_bitwuzla(solver.smt(formulas)), solver.ask_z3(solver.smt(formulas))}
        if words != {"sat" if is_possible else "unsat"}:
            found.append(f"control/writer: {name}: {sorted(words)}")
    text = solver.smt(LONG)
    words = [solver.ask_bitwuzla(text, SHORT_CALLS), solver.ask_z3(text, SHORT_RESOURCES)]
    if solver.together(words) is not solver.Verdict.UNKNOWN:
        found.append(f"control/limits: an answer that takes long: {words}")
    return found
