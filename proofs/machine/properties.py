"""What has to hold of each function, said from the sentences of the text.

A property is a precondition and a conclusion over the bits that go in and the bits that come out.
"""

from dataclasses import dataclass

import claripy

RNE = claripy.fp.RM.RM_NearestTiesEven
EXPONENT = 0x7FF0_0000_0000_0000

FIRST, SECOND, STOPPED, TIMED, NO_VELOCITY, NO_POSITION, PLACED = 1, 2, 4, 8, 16, 32, 64
INIT, ACTIVE, HOLD, ESTOP = 0, 1, 2, 3
ACCEPTED, HELD, ANSWERED_STOP, DROPPED = 0, 1, 2, 3
GATE_HELD, GATE_STOPPED = 2, 3
DISABLED, ENABLED, FAULTY = 0, 1, 2


@dataclass(frozen=True)
class Signature:
    """The arguments of a function: words and doubles by name, and whether the first is a pointer; and whether
    its paths depend on doubles that are computed by more than a sum."""

    words: tuple
    doubles: tuple
    writes: bool = False
    returns: bool = True
    computes: bool = False


SIGNATURES = {
    "within_deadline": Signature((), ("now_s", "received_s", "ttl_ms")),
    "is_fresh": Signature((), ("now_s", "last_s", "timeout_ms")),
    "enforced_ttl": Signature((), ("ttl_ms",), writes=True),
    "advances": Signature(("flags", "last", "seq"), ()),
    "hold_takes_effect": Signature(("flags", "last", "seq"), ()),
    "inside": Signature((), ("x", "y", "z", "radius"), computes=True),
    "limit": Signature(("flags",), ("value",), writes=True),
    "clamp": Signature((), ("x", "y", "z", "max"), writes=True, computes=True),
    "projection": Signature(
        (), ("x", "y", "z", "radius", "u", "v", "w", "ttl_ms"), computes=True
    ),
    "watchdog_command": Signature(
        ("flags", "last", "seq"), ("received_s", "ttl_ms", "now_s", "new_ttl_ms"), True, False
    ),
    "watchdog_on_hold": Signature(("flags", "last", "seq"), ("received_s", "ttl_ms"), True, False),
    "watchdog_should_hold": Signature(
        ("flags", "last"), ("received_s", "ttl_ms", "now_s"), True, False
    ),
    "watchdog_reset": Signature(("flags", "last"), ("received_s", "ttl_ms"), True, False),
    "plant_command": Signature(
        ("flags", "last", "mode", "seq"),
        ("received_s", "ttl_ms", "now_s", "new_ttl_ms"),
        True,
        False,
    ),
    "plant_active": Signature(
        ("flags", "last", "steps"), ("received_s", "ttl_ms", "now_s", "dt_ms"), True, False
    ),
    "plant_reset": Signature(("flags", "last"), ("received_s", "ttl_ms"), True, False),
    "gates_govern": Signature(
        ("flags", "mode"),
        (
            *("speed_mps", "radius_m", "timeout_ms", "now_s", "last_s"),
            *("x", "y", "z", "u", "v", "w", "ttl_ms"),
        ),
        True,
        False,
    ),
    "gates_note_link": Signature(
        ("flags", "burst"), ("speed_mps", "radius_m", "timeout_ms"), True, False
    ),
    "gates_reset": Signature(("flags",), ("speed_mps", "radius_m", "timeout_ms"), True, False),
}

STEP = (
    *("has_last", "last", "has_deadline", "received_s", "ttl_ms", "stopped"),
    *("has_last_after", "last_after", "has_deadline_after", "received_s_after"),
    *("ttl_ms_after", "stopped_after", "answer"),
)
GATE_STEP = ("stopped", "fault", "stopped_after", "fault_after", "answer")


def outputs(function, answer, memory):
    """What a function leaves, by name."""
    if function.startswith("gates_"):
        return dict(zip(GATE_STEP, memory, strict=False))
    if function.startswith(("watchdog_", "plant_")):
        return dict(zip(STEP, memory, strict=False))
    # Of a function that answers a byte, the rest of the register says nothing.
    named = {"answer": answer[7:0].zero_extend(56)}
    if SIGNATURES[function].writes:
        named |= {"out": memory[0], "out_y": memory[1], "out_z": memory[2]}
    return named


# --- The words of the text, as formulas over the bits of doubles -------------------------------


def number(value):
    return claripy.FPV(value, claripy.FSORT_DOUBLE)


def fp(bits):
    return bits.raw_to_fp()


def finite(bits):
    return (bits & EXPONENT) != EXPONENT


def positive(bits):
    """A finite number above 0."""
    return claripy.And(finite(bits), claripy.fpGT(fp(bits), number(0.0)))


def age_ms(now_s, then_s):
    return claripy.fpMul(RNE, claripy.fpSub(RNE, fp(now_s), fp(then_s)), number(1000.0))


def in_order(now_s, then_s):
    return claripy.And(finite(now_s), finite(then_s), claripy.fpLEQ(fp(then_s), fp(now_s)))


def alive(now_s, received_s, ttl_ms):
    """The liveness rule of 8.1 for one command."""
    age = age_ms(now_s, received_s)
    return claripy.And(
        in_order(now_s, received_s),
        positive(ttl_ms),
        claripy.fpLEQ(age, fp(ttl_ms)),
        claripy.fpLEQ(age, number(60_000.0)),
    )


def fresh(now_s, last_s, timeout_ms):
    """Section 7.4."""
    return claripy.And(
        in_order(now_s, last_s),
        positive(timeout_ms),
        claripy.fpLEQ(age_ms(now_s, last_s), fp(timeout_ms)),
    )


def squares(vector):
    """Σ xᵢ² of doubles."""
    parts = [claripy.fpMul(RNE, x, x) for x in vector]
    return claripy.fpAdd(RNE, claripy.fpAdd(RNE, parts[0], parts[1]), parts[2])


def within(vector, bound):
    """√(Σ xᵢ²) of doubles is not above a bound, both at a scale at which no square leaves the doubles."""

    def at(scale):
        root = claripy.fpSqrt(RNE, squares([claripy.fpMul(RNE, x, number(scale)) for x in vector]))
        return claripy.fpLEQ(root, claripy.fpMul(RNE, bound, number(scale)))

    total = squares(vector)
    is_small = claripy.fpLT(total, number(2.0**-900))
    is_below = claripy.fpLT(total, number(2.0**1000))
    return claripy.Or(
        claripy.And(is_small, at(2.0**600)),
        claripy.And(claripy.Not(is_small), is_below, at(1.0)),
        claripy.And(claripy.Not(is_small), claripy.Not(is_below), at(2.0**-600)),
    )


def in_ball(x, y, z, radius):
    """Section 7.5: the closed ball."""
    return claripy.And(
        finite(x),
        finite(y),
        finite(z),
        positive(radius),
        within([fp(x), fp(y), fp(z)], fp(radius)),
    )


def enforced(ttl_ms):
    """The ttl that is enforced, as a double, in each case: 0 for one that is no time, and min(ttl, 60 s)."""
    is_time, is_short = positive(ttl_ms), claripy.fpLT(fp(ttl_ms), number(60_000.0))
    return [
        ("no-ttl", claripy.Not(is_time), number(0.0)),
        ("short-ttl", claripy.And(is_time, is_short), fp(ttl_ms)),
        ("long-ttl", claripy.And(is_time, claripy.Not(is_short)), number(60_000.0)),
    ]


def moved(place, velocity, time_ms):
    """Where a plant is after some time; all of them doubles."""
    time_s = claripy.fpDiv(RNE, time_ms, number(1000.0))
    return [
        claripy.fpAdd(RNE, x, claripy.fpMul(RNE, v, time_s))
        for x, v in zip(place, velocity, strict=True)
    ]


def ends_in_ball(place, radius):
    """Section 7.5, of a place that was computed."""
    is_number = [claripy.Not(claripy.Or(claripy.fpIsNaN(x), claripy.fpIsInf(x))) for x in place]
    return claripy.And(
        *is_number, positive(radius), within(place, fp(radius))
    )


def has(flags, flag):
    return (flags & flag) != 0


def iff(a, b):
    return claripy.Or(claripy.And(a, b), claripy.And(claripy.Not(a), claripy.Not(b)))


def implies(a, b):
    return claripy.Or(claripy.Not(a), b)


def is_newer(has_last, last, seq):
    return claripy.Or(claripy.Not(has_last), seq.SGT(last))


def hold_counts(has_last, last, seq):
    return claripy.Or(claripy.Not(has_last), seq.SGE(last), seq == 0)


def is_bad(is_given, value):
    """A limit that cannot be enforced: negative or not finite."""
    is_negative = claripy.fpLT(fp(value), number(0.0))
    return claripy.And(is_given, claripy.Or(claripy.Not(finite(value)), is_negative))


# --- The properties ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Property:
    """One property of one function."""

    id: str
    family: str
    function: str
    rules: tuple
    sentence: str
    formal: str
    conclusion: object
    assume: object = lambda i: []
    # What is asked of each by itself, as a solver sees more in it: a name, when it is so, and what is so then.
    cases: object = lambda i: [("", claripy.true(), {})]
    bounds: str = "none: every double, every 64-bit integer, every flag"
    assumptions: tuple = ()


PROPERTIES = []


def prove(id, family, function, rules, sentence, formal, **more):
    """Adds a property whose conclusion is the decorated function of inputs and outputs."""

    def add(parts):
        def conclusion(inputs, left):
            said = parts(inputs, left)
            return claripy.And(claripy.true(), *(said if isinstance(said, tuple) else (said,)))

        ids = tuple(f"NCP-{rule}" for rule in rules.split())
        PROPERTIES.append(
            Property(f"machine/{id}", family, function, ids, sentence, formal, conclusion, **more)
        )
        return parts

    return add


@prove(
    "within-deadline",
    "watchdog",
    "within_deadline",
    "RES-002 RES-003 RES-004 RES-005 RES-007 RES-008",
    "A command may be acted upon exactly while the liveness rule of 8.1 holds for it.",
    "answer = 1 ⟺ finite(now, received) ∧ received ≤ now ∧ finite(ttl) ∧ ttl > 0 ∧ (now − received)·1000 ≤ min(ttl, 60000)",
)
def _(i, o):
    lives = alive(i["now_s"], i["received_s"], i["ttl_ms"])
    return _bit(o["answer"]), iff(o["answer"] == 1, lives)


@prove(
    "enforced-ttl",
    "watchdog",
    "enforced_ttl",
    "RES-004 RES-005",
    "The enforced ttl is min(ttl, 60 s), and none for a ttl that is not finite or not positive.",
    "(answer = 1 ⟺ finite(ttl) ∧ ttl > 0) ∧ (answer = 1 ⟹ out = min(ttl, 60000) ∧ 0 < out ≤ 60000)",
)
def _(i, o):
    ttl, out = fp(i["ttl_ms"]), fp(o["out"])
    most = number(60_000.0)
    least = claripy.If(claripy.fpLT(ttl, most), ttl, most)
    in_bounds = claripy.And(claripy.fpGT(out, number(0.0)), claripy.fpLEQ(out, most))
    return (
        _bit(o["answer"]),
        iff(o["answer"] == 1, positive(i["ttl_ms"])),
        implies(o["answer"] == 1, claripy.And(claripy.fpEQ(out, least), in_bounds)),
    )


@prove(
    "is-fresh",
    "watchdog",
    "is_fresh",
    "SAFE-031 SAFE-032 SAFE-033 SAFE-034 SAFE-035",
    "A sensor frame is fresh exactly as section 7.4 says.",
    "answer = 1 ⟺ finite(now, last) ∧ last ≤ now ∧ finite(timeout) ∧ timeout > 0 ∧ (now − last)·1000 ≤ timeout",
)
def _(i, o):
    return _bit(o["answer"]), iff(
        o["answer"] == 1, fresh(i["now_s"], i["last_s"], i["timeout_ms"])
    )


@prove(
    "advances",
    "order",
    "advances",
    "RES-009 RES-012",
    "A command advances exactly when its seq is above the last one's, or there is none.",
    "answer = 1 ⟺ ¬has_last ∨ last < seq (signed)",
)
def _(i, o):
    newer = is_newer(has(i["flags"], FIRST), i["last"], i["seq"])
    return _bit(o["answer"]), iff(o["answer"] == 1, newer)


@prove(
    "hold-takes-effect",
    "order",
    "hold_takes_effect",
    "RES-023",
    "A HOLD takes effect when its seq is not below the last accepted one's, or is 0, or there is none.",
    "answer = 1 ⟺ ¬has_last ∨ seq ≥ last ∨ seq = 0",
)
def _(i, o):
    counts = hold_counts(has(i["flags"], FIRST), i["last"], i["seq"])
    return _bit(o["answer"]), iff(o["answer"] == 1, counts)


@prove(
    "watchdog-command",
    "order",
    "watchdog_command",
    "RES-001 RES-009 RES-012",
    "Whatever the watchdog's state: a command that advances becomes the deadline, and any other changes nothing.",
    "answer = 1 ⟺ advances; advances ⟹ state' = (seq, now, ttl); ¬advances ⟹ state' = state",
)
def _(i, o):
    newer = is_newer(o["has_last"] == 1, o["last"], i["seq"])
    taken = claripy.And(
        o["has_last_after"] == 1,
        o["last_after"] == i["seq"],
        o["has_deadline_after"] == 1,
        o["received_s_after"] == i["now_s"],
        o["ttl_ms_after"] == i["new_ttl_ms"],
    )
    return (
        _built(i, o),
        _bit(o["answer"]),
        iff(o["answer"] == 1, newer),
        claripy.If(newer, taken, _same_state(o)),
        _reachable(o),
    )


@prove(
    "watchdog-on-hold",
    "order",
    "watchdog_on_hold",
    "RES-010 RES-023 RES-024",
    "Whatever the watchdog's state: a HOLD that takes effect ends the deadline and never sets one; any other changes nothing; the last seq never falls.",
    "answer = 1 ⟺ hold counts; counts ⟹ no deadline'; ¬counts ⟹ state' = state; has_last ⟹ last' ≥ last",
)
def _(i, o):
    counts = hold_counts(o["has_last"] == 1, o["last"], i["seq"])
    never_back = implies(
        o["has_last"] == 1,
        claripy.And(o["has_last_after"] == 1, o["last_after"].SGE(o["last"])),
    )
    return (
        _built(i, o),
        iff(o["answer"] == 1, counts),
        claripy.If(counts, o["has_deadline_after"] == 0, _same_state(o)),
        never_back,
        _reachable(o),
    )


@prove(
    "watchdog-should-hold",
    "watchdog",
    "watchdog_should_hold",
    "RES-002 RES-003 RES-004 RES-005 RES-006 RES-007 RES-008 RES-010",
    "Whatever the watchdog's state: it holds exactly when there is no deadline or the liveness rule fails, and a hold leaves no deadline, so it persists.",
    "answer = 1 ⟺ ¬(has_deadline ∧ alive); has_deadline' = ¬answer; deadline' = deadline where there is one; last' = last",
)
def _(i, o):
    moves = claripy.And(o["has_deadline"] == 1, alive(i["now_s"], o["received_s"], o["ttl_ms"]))
    kept = claripy.And(
        o["received_s_after"] == o["received_s"], o["ttl_ms_after"] == o["ttl_ms"]
    )
    return (
        _built(i, o),
        _bit(o["answer"]),
        iff(o["answer"] == 0, moves),
        iff(o["has_deadline_after"] == 1, moves),
        implies(moves, kept),
        claripy.And(o["has_last_after"] == o["has_last"], o["last_after"] == o["last"]),
        _reachable(o),
    )


@prove(
    "watchdog-reset",
    "order",
    "watchdog_reset",
    "RES-011 RES-012",
    "Whatever the watchdog's state: a reset leaves neither a deadline nor a last seq.",
    "has_deadline' = 0 ∧ has_last' = 0",
)
def _(i, o):
    return o["has_deadline_after"] == 0, o["has_last_after"] == 0


@prove(
    "plant-command",
    "latch",
    "plant_command",
    "RES-009 RES-020 RES-021 RES-023 RES-024 SAFE-001",
    "Whatever the plant's state: an ESTOP latches whatever its seq; a latch stays; only an advancing active command on an unlatched plant is accepted; no other sets a deadline.",
    "mode = estop ⟹ stopped' ∧ answer = stopped; stopped ⟹ stopped'; stopped' ⟹ stopped ∨ mode = estop; answer = accepted ⟺ mode = active ∧ ¬stopped ∧ advances; has_deadline' ⟹ deadline' = deadline ∨ (mode = active ∧ advances ∧ deadline' = (now, ttl)); last' ≥ last",
    assume=lambda i: [i["mode"] <= ESTOP],
    bounds="the four modes; else none",
)
def _(i, o):
    newer = is_newer(o["has_last"] == 1, o["last"], i["seq"])
    counts = hold_counts(o["has_last"] == 1, o["last"], i["seq"])
    is_estop, is_active = i["mode"] == ESTOP, i["mode"] == ACTIVE
    is_hold = claripy.Or(i["mode"] == HOLD, i["mode"] == INIT)
    stopped = o["stopped"] == 1
    refreshed = claripy.And(
        is_active,
        newer,
        o["received_s_after"] == i["now_s"],
        o["ttl_ms_after"] == i["new_ttl_ms"],
        o["last_after"] == i["seq"],
    )
    return (
        _built(i, o),
        iff(o["stopped_after"] == 1, claripy.Or(stopped, is_estop)),
        implies(is_estop, o["answer"] == ANSWERED_STOP),
        iff(o["answer"] == ACCEPTED, claripy.And(is_active, claripy.Not(stopped), newer)),
        implies(
            o["has_deadline_after"] == 1,
            claripy.Or(
                refreshed,
                claripy.And(
                    o["has_deadline"] == 1,
                    o["received_s_after"] == o["received_s"],
                    o["ttl_ms_after"] == o["ttl_ms"],
                ),
            ),
        ),
        implies(claripy.And(is_active, newer), claripy.And(o["has_deadline_after"] == 1, refreshed)),
        implies(claripy.And(is_active, claripy.Not(newer)), _same_state(o)),
        implies(claripy.And(is_hold, counts), o["has_deadline_after"] == 0),
        implies(
            o["has_last"] == 1,
            claripy.And(o["has_last_after"] == 1, o["last_after"].SGE(o["last"])),
        ),
        _reachable(o),
    )


def _plain(i):
    return claripy.Or(i["steps"] == 0, claripy.Not(has(i["flags"], TIMED)))


@prove(
    "plant-active",
    "latch",
    "plant_active",
    "RES-002 RES-005 RES-006 RES-007 RES-008 RES-010 RES-025 RES-026",
    "Whatever the state of a plant without a horizon: it moves, by tick 0, exactly while it is unlatched and alive by the liveness rule; asking it neither sets a deadline nor clears a latch.",
    "steps = 0 ∨ no dt ⟹ (answer = 1 ⟺ has_deadline ∧ alive ∧ ¬stopped) ∧ answer ≤ 1; (has_deadline' ⟺ has_deadline ∧ alive) ∧ deadline' = deadline; stopped' = stopped; last' = last",
    assume=lambda i: [_plain(i)],
    bounds="no horizon, or one without a dt; else none",
)
def _(i, o):
    lives = claripy.And(o["has_deadline"] == 1, alive(i["now_s"], o["received_s"], o["ttl_ms"]))
    moves = claripy.And(lives, o["stopped"] == 0)
    kept = claripy.And(
        o["received_s_after"] == o["received_s"], o["ttl_ms_after"] == o["ttl_ms"]
    )
    return (
        _built(i, o),
        _bit(o["answer"]),
        iff(o["answer"] == 1, moves),
        iff(o["has_deadline_after"] == 1, lives),
        implies(lives, kept),
        o["stopped_after"] == o["stopped"],
        claripy.And(o["has_last_after"] == o["has_last"], o["last_after"] == o["last"]),
        _reachable(o),
    )


@prove(
    "plant-horizon-holds",
    "latch",
    "plant_active",
    "RES-005 RES-006 RES-007 RES-008 RES-010 RES-025",
    "Whatever the horizon: a plant that is latched, or has no deadline, or whose clock or ttl is none, or whose clock went back, does not move, and stays so.",
    "stopped ∨ ¬has_deadline ∨ ¬finite(now, received) ∨ now < received ∨ ¬finite(ttl) ∨ ttl ≤ 0 ⟹ answer = 0 ∧ stopped' = stopped ∧ (¬alive ⟹ ¬has_deadline')",
    assume=lambda i: [
        claripy.Or(
            has(i["flags"], STOPPED),
            claripy.Not(has(i["flags"], FIRST)),
            claripy.Not(has(i["flags"], SECOND)),
            claripy.Not(in_order(i["now_s"], i["received_s"])),
            claripy.Not(positive(i["ttl_ms"])),
        )
    ],
    bounds="the age itself is left to watchdog-should-hold; else none",
)
def _(i, o):
    lives = claripy.And(o["has_deadline"] == 1, alive(i["now_s"], o["received_s"], o["ttl_ms"]))
    return (
        o["answer"] == 0,
        o["stopped_after"] == o["stopped"],
        implies(claripy.Not(lives), o["has_deadline_after"] == 0),
        claripy.And(o["has_last_after"] == o["has_last"], o["last_after"] == o["last"]),
        _reachable(o),
    )


@prove(
    "plant-reset",
    "latch",
    "plant_reset",
    "RES-030 RES-031 RES-032",
    "Whatever the plant's state: a reset clears the latch, the deadline and the last seq, so nothing moves until a new command.",
    "stopped' = 0 ∧ has_deadline' = 0 ∧ has_last' = 0",
)
def _(i, o):
    return o["stopped_after"] == 0, o["has_deadline_after"] == 0, o["has_last_after"] == 0


# What the wrapper of the gates asks: its plan is one tick, and of their state only the accessors are read.
GATED = "commands without a horizon, of one velocity with three components; the latch and the fault are read, the limits stay unread; else none"


def _latched(i):
    return claripy.Or(has(i["flags"], STOPPED), i["mode"] == ESTOP)


@prove(
    "gates-latch",
    "latch",
    "gates_govern",
    "SAFE-003 SAFE-004 SAFE-005 SAFE-020",
    "A latched governor, or one that is given an ESTOP, answers ESTOP and is latched after it.",
    "stopped ∨ mode = estop ⟹ answer = stopped ∧ stopped'",
    bounds=GATED,
    assume=lambda i: [_latched(i)],
)
def _(i, o):
    return _gates_built(i, o), o["answer"] == GATE_STOPPED, o["stopped_after"] == 1


@prove(
    "gates-fault",
    "latch",
    "gates_govern",
    "SAFE-009 SAFE-013 SAFE-014 SAFE-017 SAFE-018",
    "A limit that is negative, not finite or without its channel puts the governor into config fail-closed, in which it holds on every command and stays.",
    "¬latched ∧ (bad limit ∨ limit without channel) ⟹ fault ∧ fault' ∧ answer = held ∧ ¬stopped'",
    bounds=GATED,
    assume=lambda i: [claripy.Not(_latched(i)), _is_faulty(i)],
)
def _(i, o):
    return (
        _gates_built(i, o),
        o["answer"] == GATE_HELD,
        o["fault_after"] == 1,
        o["stopped_after"] == 0,
    )


@prove(
    "gates-stale",
    "watchdog",
    "gates_govern",
    "SAFE-030 SAFE-031 SAFE-032 SAFE-035",
    "A governor lets nothing pass when its sensor has no time, when the clock, that time or the timeout is not one, or when the clock went back.",
    "¬latched ∧ (no time ∨ ¬finite(now, last) ∨ now < last ∨ ¬finite(timeout) ∨ timeout ≤ 0) ⟹ answer = held ∧ ¬stopped'",
    bounds="the age itself is left to is-fresh; " + GATED,
    assume=lambda i: [
        claripy.Not(_latched(i)),
        claripy.Or(
            claripy.Not(has(i["flags"], TIMED)),
            claripy.Not(in_order(i["now_s"], i["last_s"])),
            claripy.Not(positive(i["timeout_ms"])),
        ),
    ],
)
def _(i, o):
    return o["answer"] == GATE_HELD, o["stopped_after"] == 0, o["fault_after"] == o["fault"]


@prove(
    "gates-mode",
    "latch",
    "gates_govern",
    "SAFE-001 SAFE-002",
    "With the fence disabled, a command that is not active does not pass.",
    "mode ≠ active ∧ no fence ⟹ answer ∈ {held, stopped}",
    bounds=GATED,
    assume=lambda i: [i["mode"] != ACTIVE, claripy.Not(has(i["flags"], SECOND))],
)
def _(i, o):
    return claripy.Or(o["answer"] == GATE_HELD, o["answer"] == GATE_STOPPED)


@prove(
    "gates-no-position",
    "geofence",
    "gates_govern",
    "SAFE-040 SAFE-044",
    "With the fence enabled, a missing position holds, and one that is not finite latches ESTOP: no command passes.",
    "fence > 0, ¬(placed ∧ finite(x, y, z)) ⟹ answer ∈ {held, stopped}; ¬fault ∧ fresh ∧ placed ∧ ¬latched ⟹ stopped'",
    bounds=GATED,
    assume=lambda i: [
        has(i["flags"], SECOND),
        positive(i["radius_m"]),
        claripy.Not(claripy.And(has(i["flags"], PLACED), *[finite(i[c]) for c in "xyz"])),
    ],
)
def _(i, o):
    reached = claripy.And(
        o["fault"] == 0,
        has(i["flags"], TIMED),
        fresh(i["now_s"], i["last_s"], i["timeout_ms"]),
    )
    return (
        claripy.Or(o["answer"] == GATE_HELD, o["answer"] == GATE_STOPPED),
        implies(claripy.And(reached, has(i["flags"], PLACED)), o["stopped_after"] == 1),
        iff(o["answer"] == GATE_STOPPED, o["stopped_after"] == 1),
    )


@prove(
    "gates-note-link",
    "latch",
    "gates_note_link",
    "SAFE-006 SAFE-007",
    "A burst latches ESTOP; no burst changes nothing; a latch stays.",
    "stopped' = stopped ∨ burst; fault' = fault",
    bounds=GATED,
)
def _(i, o):
    burst = (i["burst"] & 1) == 1
    return (
        _gates_built(i, o),
        iff(o["stopped_after"] == 1, claripy.Or(o["stopped"] == 1, burst)),
        o["fault_after"] == o["fault"],
    )


@prove(
    "gates-reset",
    "latch",
    "gates_reset",
    "SAFE-008 SAFE-009",
    "The governor's reset clears the latch and not a config fault.",
    "stopped' = 0; fault' = fault",
    bounds=GATED,
)
def _(i, o):
    return _gates_built(i, o), o["stopped_after"] == 0, o["fault_after"] == o["fault"]


@prove(
    "inside",
    "geofence",
    "inside",
    "SAFE-043 SAFE-044 SAFE-045",
    "A position is inside exactly when it and its radius are finite, the radius is positive, and √(x² + y² + z²) as computed is not above it.",
    "answer = 1 ⟺ finite(x, y, z, r) ∧ r > 0 ∧ √(x² + y² + z²) ≤ r",
)
def _(i, o):
    ball = in_ball(i["x"], i["y"], i["z"], i["radius"])
    return _bit(o["answer"]), iff(o["answer"] == 1, ball)


@prove(
    "inside-fail-closed",
    "geofence",
    "inside",
    "SAFE-044",
    "A component or a radius that is not finite, or a radius that is not positive, is never inside.",
    "¬finite(x, y, z, r) ∨ ¬(r > 0) ⟹ answer = 0",
    assume=lambda i: [
        claripy.Or(*[claripy.Not(finite(i[c])) for c in "xyz"], claripy.Not(positive(i["radius"])))
    ],
)
def _(i, o):
    return o["answer"] == 0


@prove(
    "limit",
    "geofence",
    "limit",
    "SAFE-012 SAFE-013",
    "A limit is disabled when absent or 0, enabled as it is when finite and positive, and faulty when negative or not finite.",
    "answer = 2 ⟺ given ∧ (¬finite ∨ value < 0); answer = 1 ⟺ given ∧ finite ∧ value > 0, and then out = value; else answer = 0",
)
def _(i, o):
    given, value = has(i["flags"], FIRST), i["value"]
    return (
        o["answer"] <= FAULTY,
        iff(o["answer"] == FAULTY, is_bad(given, value)),
        iff(o["answer"] == ENABLED, claripy.And(given, positive(value))),
        implies(o["answer"] == ENABLED, o["out"] == value),
    )


@prove(
    "clamp-refuses",
    "clamp",
    "clamp",
    "SAFE-064",
    "No vector with a component that is not finite is clamped, nor any to a bound that is not finite and positive.",
    "¬finite(x, y, z) ∨ ¬finite(max) ∨ ¬(max > 0) ⟹ answer = 0 ∧ out = (x, y, z)",
    assume=lambda i: [
        claripy.Or(*[claripy.Not(finite(i[c])) for c in "xyz"], claripy.Not(positive(i["max"])))
    ],
)
def _(i, o):
    unchanged = claripy.And(o["out"] == i["x"], o["out_y"] == i["y"], o["out_z"] == i["z"])
    return o["answer"] == 0, unchanged


def _can_be_clamped(i):
    return [*[finite(i[c]) for c in "xyz"], positive(i["max"])]


@prove(
    "clamp-bound",
    "clamp",
    "clamp",
    "SAFE-060 SAFE-069",
    "A finite vector is clamped to any finite positive bound: what comes out is finite, and its norm as computed is not above the bound, for every double.",
    "finite(x, y, z) ∧ finite(max) ∧ max > 0 ⟹ answer = 1 ∧ finite(out) ∧ √(out_x² + out_y² + out_z²) ≤ max",
    bounds="vectors of three components; else none",
    assume=_can_be_clamped,
)
def _(i, o):
    out = (o["out"], o["out_y"], o["out_z"])
    return (
        o["answer"] == 1,
        claripy.And(*[finite(c) for c in out]),
        within([fp(x) for x in out], fp(i["max"])),
    )


@prove(
    "clamp-unchanged",
    "clamp",
    "clamp",
    "SAFE-062",
    "A vector whose norm is not above the bound stays as it is, bit for bit.",
    "finite(x, y, z) ∧ finite(max) ∧ max > 0 ∧ √(x² + y² + z²) ≤ max ⟹ answer = 1 ∧ out = (x, y, z)",
    bounds="vectors of three components; else none",
    assume=lambda i: [
        *_can_be_clamped(i),
        within([fp(i[axis]) for axis in "xyz"], fp(i["max"])),
    ],
)
def _(i, o):
    unchanged = claripy.And(o["out"] == i["x"], o["out_y"] == i["y"], o["out_z"] == i["z"])
    return o["answer"] == 1, unchanged


def _place(i):
    return [fp(i[c]) for c in "xyz"]


def _velocity(i):
    return [fp(i[c]) for c in "uvw"]


def _by_ttl(i):
    return [(name, when, {"time": time}) for name, when, time in enforced(i["ttl_ms"])]


@prove(
    "projection",
    "geofence",
    "projection",
    "SAFE-053",
    "Without a horizon: a velocity is let through exactly when the place to which it leads by the end of the enforced ttl, as computed, lies within the fence.",
    "T = min(ttl, 60000), 0 for no time; answer = 1 ⟺ finite(p + v·T/1000) ∧ finite(r) ∧ r > 0 ∧ |p + v·T/1000| ≤ r",
    cases=_by_ttl,
)
def _(i, o):
    end = moved(_place(i), _velocity(i), i["time"])
    return _bit(o["answer"]), iff(o["answer"] == 1, ends_in_ball(end, i["radius"]))


# --- Parts of conclusions ---------------------------------------------------------------------


def _bit(answer):
    return answer <= 1


def _built(i, o):
    """The state before is the one that was asked for, so that the step is shown from every state."""
    has_last = has(i["flags"], FIRST)
    has_deadline = claripy.And(has_last, has(i["flags"], SECOND))
    parts = [
        iff(o["has_last"] == 1, has_last),
        implies(has_last, o["last"] == i["last"]),
        iff(o["has_deadline"] == 1, has_deadline),
        implies(
            has_deadline,
            claripy.And(o["received_s"] == i["received_s"], o["ttl_ms"] == i["ttl_ms"]),
        ),
    ]
    return claripy.And(*parts)


def _reachable(o):
    """The state after is one from which steps are shown: a deadline has a last seq."""
    return implies(o["has_deadline_after"] == 1, o["has_last_after"] == 1)


def _same_state(o):
    names = ("has_last", "last", "has_deadline", "received_s", "ttl_ms")
    return claripy.And(*[o[f"{name}_after"] == o[name] for name in names])


def _is_faulty(i):
    flags = i["flags"]
    has_speed, has_fence = has(flags, FIRST), has(flags, SECOND)
    speed, radius = i["speed_mps"], i["radius_m"]
    unbound = claripy.Or(
        claripy.And(has_speed, positive(speed), has(flags, NO_VELOCITY)),
        claripy.And(has_fence, positive(radius), has(flags, NO_POSITION)),
    )
    return claripy.Or(is_bad(has_speed, speed), is_bad(has_fence, radius), unbound)


def _gates_built(i, o):
    return claripy.And(
        iff(o["stopped"] == 1, has(i["flags"], STOPPED)), iff(o["fault"] == 1, _is_faulty(i))
    )
