"""What has to hold of each function, said from the sentences of the text.

A property is a precondition and a conclusion over the bits that go in and the bits that come out.
"""

import struct
from dataclasses import dataclass

import claripy

RNE = claripy.fp.RM.RM_NearestTiesEven
EXPONENT = 0x7FF0_0000_0000_0000

FIRST = 1
INIT, ACTIVE, HOLD, ESTOP = 0, 1, 2, 3
ACCEPTED, HELD, ANSWERED_STOP, DROPPED = 0, 1, 2, 3
GATE_PASSED, GATE_LIMITED, GATE_HELD, GATE_STOPPED = 0, 1, 2, 3
DISABLED, ENABLED, FAULTY = 0, 1, 2
NO_REASON, BY_ESTOP, BY_FAULT, BY_STALE, BY_NO_POSITION, BY_OUTSIDE = range(6)
BY_MODE, BY_NOT_FINITE, BY_NO_VELOCITY, BY_HORIZON, BY_LEAVING = range(6, 11)
# What a tick answers the speed limit: it stays, it changed, it is not finite, it has no velocity.
SAYS_SAME, SAYS_CHANGED, SAYS_NOT_FINITE, SAYS_NO_VELOCITY = range(4)

STEPS, CHANNELS, WIDTH = 3, 2, 3
TICKS = range(STEPS + 1)

WATCHDOG = ("has_last", "last", "has_deadline", "received_s", "ttl_ms")
PLANT = (*WATCHDOG, "stopped")
GATES = ("speed_kind", "speed_mps", "fence_kind", "radius_m", "timeout_ms", "fault", "stopped")
COMMAND = (
    *("mode", "now_s", "has_time", "last_s", "has_place", "x", "y", "z"),
    *("ttl_ms", "has_dt", "dt_ms", "steps"),
)
TICK = ("says", "had", "u_before", "v_before", "w_before", "has", "u", "v", "w")
ASKED = ("times", "kind", "bound")
CHANNEL = ("width", "is_velocity", "in_mps", "x", "y", "z")
DOUBLES = {
    *("received_s", "ttl_ms", "new_ttl_ms", "now_s", "last_s", "dt_ms", "speed_mps", "radius_m", "timeout_ms"),
    *("x", "y", "z", "u", "v", "w", "u_before", "v_before", "w_before", "out", "out_y", "out_z", "bound", "max"),
}


def is_double(name):
    """Whether a word is shown as a double."""
    return name.rstrip("0123456789").removesuffix("_after") in DOUBLES


def after(names):
    return tuple(f"{name}_after" for name in names)


def each(names, numbers):
    """The names once for each number."""
    return tuple(f"{name}{number}" for number in numbers for name in names)


def anything(inputs):
    return []


@dataclass(frozen=True)
class Signature:
    """The arguments of a function: words and doubles by name, and whether the first is a pointer to what it writes.

    Or it is given two pointers: to what it leaves, by name, and to a block of words that it reads; and the values of
    these that stand for something.
    """

    words: tuple = ()
    doubles: tuple = ()
    writes: bool = False
    returns: bool = True
    block: tuple = None
    leaves: tuple = ()
    domain: object = anything
    # What is explored by itself, as all at once has too many paths: a name, what is so of the inputs, and the bits
    # of those that are fixed.
    slices: tuple = (("", anything, {}),)


def step(block, leaves, domain=anything, slices=Signature.slices):
    """A function that takes a block of words, and leaves one."""
    words = tuple(name for name in block if not is_double(name))
    doubles = tuple(name for name in block if is_double(name))
    return Signature(words, doubles, True, False, block, leaves, domain, slices)


def is_watchdog(i):
    """Each state that a watchdog's fields can have; where there is no value, its word is 0."""
    return [
        i["has_last"] <= 1,
        i["has_deadline"] <= 1,
        implies(i["has_last"] == 0, i["last"] == 0),
        implies(i["has_deadline"] == 0, claripy.And(i["received_s"] == 0, i["ttl_ms"] == 0)),
    ]


def is_plant(i):
    return [*is_watchdog(i), i["stopped"] <= 1]


def is_limit(kind, bound):
    return [kind <= FAULTY, implies(kind != ENABLED, bound == 0)]


def is_gates(i):
    """Each state that the fields of gates can have."""
    limits = [*is_limit(i["speed_kind"], i["speed_mps"]), *is_limit(i["fence_kind"], i["radius_m"])]
    return [*limits, i["fault"] <= 1, i["stopped"] <= 1]


def is_governed(i):
    return [*is_gates(i), i["mode"] <= ESTOP, i["steps"] <= STEPS, *[i[f"says{k}"] <= SAYS_NO_VELOCITY for k in TICKS]]


def has_fence(i):
    return i["fence_kind"] == ENABLED


def is_active(i):
    return claripy.And(has_fence(i), i["mode"] == ACTIVE, i["stopped"] == 0, i["fault"] == 0)


def ticks_of(dt_ms, ttl_ms):
    """A horizon whose ticks have this length, in a command of this ttl, in ms."""
    return {"has_dt": 1, "dt_ms": bits_of(dt_ms), "ttl_ms": bits_of(ttl_ms)}


def bits_of(value):
    return int.from_bytes(struct.pack("<d", value), "little")


# All that the gates can be given, but that with a fence, and a horizon that may move the plant, the times of the
# ticks are two: of two whole ticks, a part and nothing, and of the cap of 60 s.
GOVERNED_SLICES = (
    ("no-fence", lambda i: [claripy.Not(has_fence(i))], {}),
    ("fence-closed", lambda i: [has_fence(i), claripy.Not(is_active(i))], {}),
    ("fence-no-horizon", lambda i: [is_active(i), i["steps"] == 0], {}),
    (
        "fence-no-tick",
        lambda i: [is_active(i), i["steps"] != 0, claripy.Not(claripy.And((i["has_dt"] & 1) == 1, positive(i["dt_ms"])))],
        {},
    ),
    ("fence-part-of-tick", lambda i: [is_active(i), i["steps"] != 0], ticks_of(100.0, 250.0)),
    ("fence-cap", lambda i: [is_active(i), i["steps"] != 0], ticks_of(25_000.0, 100_000.0)),
)


# No channel, one of each width, and two that are three wide: addresses depend on widths.
CHANNEL_SLICES = (
    ("none", anything, {"count": 0}),
    *[(f"one-{width}-wide", anything, {"count": 1, "width0": width}) for width in range(WIDTH + 1)],
    ("two", anything, {"count": 2, "width0": WIDTH, "width1": WIDTH}),
)


def are_channels(i):
    widths = [i[f"width{k}"] <= WIDTH for k in range(CHANNELS)]
    return [*is_limit(i["kind"], i["bound"]), i["count"] <= CHANNELS, *widths]


SIGNATURES = {
    "within_deadline": Signature((), ("now_s", "received_s", "ttl_ms")),
    "is_fresh": Signature((), ("now_s", "last_s", "timeout_ms")),
    "enforced_ttl": Signature((), ("ttl_ms",), writes=True),
    "advances": Signature(("flags", "last", "seq"), ()),
    "hold_takes_effect": Signature(("flags", "last", "seq"), ()),
    "inside": Signature((), ("x", "y", "z", "radius")),
    "limit": Signature(("flags",), ("value",), writes=True),
    "clamp": Signature((), ("x", "y", "z", "max"), writes=True),
    "projection": Signature((), ("x", "y", "z", "radius", "u", "v", "w", "ttl_ms")),
    "watchdog_new": step((), after(WATCHDOG)),
    "watchdog_command": step(
        (*WATCHDOG, "seq", "now_s", "new_ttl_ms"), (*after(WATCHDOG), "answer"), is_watchdog
    ),
    "watchdog_on_hold": step((*WATCHDOG, "seq"), (*after(WATCHDOG), "answer"), is_watchdog),
    "watchdog_should_hold": step((*WATCHDOG, "now_s"), (*after(WATCHDOG), "answer"), is_watchdog),
    "watchdog_hold": step(WATCHDOG, after(WATCHDOG), is_watchdog),
    "watchdog_reset": step(WATCHDOG, after(WATCHDOG), is_watchdog),
    "plant_new": step((), after(PLANT)),
    "plant_command": step(
        (*PLANT, "mode", "seq", "now_s", "new_ttl_ms"),
        (*after(PLANT), "answer"),
        lambda i: [*is_plant(i), i["mode"] <= ESTOP],
    ),
    "plant_active": step(
        (*PLANT, "now_s", "has_dt", "dt_ms", "steps"), (*after(PLANT), "answer"), is_plant
    ),
    "plant_stop": step(PLANT, after(PLANT), is_plant),
    "plant_reset": step(PLANT, after(PLANT), is_plant),
    "gates_new": step(("has_speed", "speed_mps", "has_fence", "radius_m", "timeout_ms"), after(GATES)),
    "gates_bind": step((*GATES, "has_velocity", "has_position"), after(GATES), is_gates),
    "gates_note_link": step((*GATES, "burst"), after(GATES), is_gates),
    "gates_reset": step(GATES, after(GATES), is_gates),
    "gates_govern": step(
        (*GATES, *COMMAND, *each(TICK, TICKS)),
        (*after(GATES), "answer", "reason", "steps_after", "places", "beyond", *each(ASKED, TICKS)),
        is_governed,
        GOVERNED_SLICES,
    ),
    "limit_tick": step(
        ("kind", "bound", "count", *each(CHANNEL, range(CHANNELS))),
        ("answer", *each(("x_after", "y_after", "z_after"), range(CHANNELS))),
        are_channels,
        CHANNEL_SLICES,
    ),
}


def outputs(function, answer, memory):
    """What a function leaves, by name."""
    signature = SIGNATURES[function]
    if signature.block is not None:
        return dict(zip(signature.leaves, memory, strict=False))
    # Of a function that answers a byte, the rest of the register says nothing.
    named = {"answer": answer[7:0].zero_extend(56)}
    if signature.writes:
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


def norm(x, y, z):
    return length([fp(x), fp(y), fp(z)])


def length(vector):
    """√(Σ xᵢ²) of doubles."""
    total, *squares = [claripy.fpMul(RNE, x, x) for x in vector]
    for square in squares:
        total = claripy.fpAdd(RNE, total, square)
    return claripy.fpSqrt(RNE, total)


def in_ball(x, y, z, radius):
    """Section 7.5: the closed ball."""
    return claripy.And(
        finite(x),
        finite(y),
        finite(z),
        positive(radius),
        claripy.fpLEQ(norm(x, y, z), fp(radius)),
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
        *is_number, positive(radius), claripy.fpLEQ(length(place), fp(radius))
    )


def word(value):
    return claripy.BVV(value, 64)


def of_integer(integer):
    """The double of an integer that is one exactly."""
    return integer.val_to_fp(claripy.FSORT_DOUBLE, signed=False, rm=RNE)


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


ZERO, ONE = claripy.BVV(0, 64), claripy.BVV(1, 64)
NO_DEADLINE = {"has_deadline": ZERO, "received_s": ZERO, "ttl_ms": ZERO}

INPUTS = "every double and 64-bit integer that it is given"
WATCHDOG_STATES = f"none: every value of every field of a watchdog, {INPUTS}"
PLANT_STATES = f"none: every value of every field of a plant, {INPUTS}"
GATE_STATES = f"none: every value of every field of the gates, {INPUTS}"
GOVERNED = (
    "every value of every field of the gates, every mode, time, place and velocity; a horizon of up to 3 steps; ticks "
    "of any channels: what the speed limit answers of a tick, and its velocity before and after, are any; where the "
    "fence is enabled and the gates before it are open, a horizon has ticks of 100 ms and a ttl of 250 ms, or ticks of "
    "25 s and a ttl of 100 s, and else every dt and ttl"
)


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
    "watchdog-new",
    "watchdog",
    "watchdog_new",
    "RES-006",
    "A new watchdog has neither a deadline nor a last seq.",
    "state' = (no last, no deadline)",
)
def _(i, o):
    return _all_zero(o, WATCHDOG)


@prove(
    "watchdog-command",
    "order",
    "watchdog_command",
    "RES-001 RES-009 RES-012",
    "From every state: a command that advances becomes the last seq and the deadline, and any other changes no field.",
    "answer = 1 ⟺ advances; advances ⟹ state' = (seq, now, ttl); ¬advances ⟹ state' = state",
    bounds=WATCHDOG_STATES,
)
def _(i, o):
    newer = is_newer(i["has_last"] == 1, i["last"], i["seq"])
    taken = {
        "has_last": ONE, "last": i["seq"], "has_deadline": ONE, "received_s": i["now_s"], "ttl_ms": i["new_ttl_ms"]
    }  # fmt: skip
    return _bit(o["answer"]), iff(o["answer"] == 1, newer), _becomes(i, o, WATCHDOG, newer, taken)


@prove(
    "watchdog-on-hold",
    "order",
    "watchdog_on_hold",
    "RES-010 RES-023 RES-024",
    "From every state: a HOLD that takes effect ends the deadline and moves the last seq to its own where that is above it and not 0; any other changes no field.",
    "answer = 1 ⟺ hold counts; counts ⟹ no deadline' ∧ last' = (seq where advances ∧ seq ≠ 0, else last); ¬counts ⟹ state' = state",
    bounds=WATCHDOG_STATES,
)
def _(i, o):
    return _bit(o["answer"]), iff(o["answer"] == 1, _hold_counts(i)), _is_held(i, o, WATCHDOG, claripy.true())


@prove(
    "watchdog-should-hold",
    "watchdog",
    "watchdog_should_hold",
    "RES-002 RES-003 RES-004 RES-005 RES-006 RES-007 RES-008 RES-010",
    "From every state: the watchdog holds exactly when there is no deadline or the liveness rule fails; then no deadline is left, so the hold persists, and else no field changes. The last seq stays.",
    "answer = 1 ⟺ ¬(has_deadline ∧ alive); answer = 1 ⟹ state' = (last, no deadline); answer = 0 ⟹ state' = state",
    bounds=WATCHDOG_STATES,
)
def _(i, o):
    holds = claripy.Not(_lives(i))
    return _bit(o["answer"]), iff(o["answer"] == 1, holds), _becomes(i, o, WATCHDOG, holds, NO_DEADLINE)


@prove(
    "watchdog-hold",
    "watchdog",
    "watchdog_hold",
    "RES-010",
    "From every state: holding ends the deadline and changes nothing else.",
    "state' = (last, no deadline)",
    bounds=WATCHDOG_STATES,
)
def _(i, o):
    return _becomes(i, o, WATCHDOG, claripy.true(), NO_DEADLINE)


@prove(
    "watchdog-reset",
    "order",
    "watchdog_reset",
    "RES-011 RES-012",
    "From every state: a reset leaves neither a deadline nor a last seq, which is a new watchdog.",
    "state' = (no last, no deadline)",
    bounds=WATCHDOG_STATES,
)
def _(i, o):
    return _all_zero(o, WATCHDOG)


@prove(
    "plant-new",
    "latch",
    "plant_new",
    "RES-006",
    "A new plant has neither a deadline nor a last seq, and no latch.",
    "state' = (no last, no deadline, unlatched)",
)
def _(i, o):
    return _all_zero(o, PLANT)


@prove(
    "plant-command",
    "latch",
    "plant_command",
    "RES-009 RES-020 RES-021 RES-023 RES-024 SAFE-001",
    "From every state and for every mode: an ESTOP latches whatever its seq, and changes no other field; only an advancing active command on an unlatched plant is accepted; what it leaves, and what a HOLD leaves, is that of the watchdog; the latch stays otherwise.",
    "answer and state' exactly: estop ⟹ stopped, state' = state with the latch; active ∧ advances ⟹ (accepted, or stopped where latched), state' = (seq, now, ttl, latch); active ∧ ¬advances ⟹ dropped, state' = state; hold, init ⟹ held or dropped, state' as watchdog-on-hold, latch",
    bounds=PLANT_STATES + ", the four modes",
)
def _(i, o):
    newer = is_newer(i["has_last"] == 1, i["last"], i["seq"])
    is_estop, is_active = i["mode"] == ESTOP, i["mode"] == ACTIVE
    is_hold = claripy.Or(i["mode"] == HOLD, i["mode"] == INIT)
    taken = {
        "has_last": ONE, "last": i["seq"], "has_deadline": ONE, "received_s": i["now_s"], "ttl_ms": i["new_ttl_ms"]
    }  # fmt: skip
    answer = claripy.If(
        is_estop,
        word(ANSWERED_STOP),
        claripy.If(
            is_active,
            claripy.If(
                newer, claripy.If(i["stopped"] == 1, word(ANSWERED_STOP), word(ACCEPTED)), word(DROPPED)
            ),
            claripy.If(_hold_counts(i), word(HELD), word(DROPPED)),
        ),
    )
    return (
        o["answer"] == answer,
        implies(is_estop, _becomes(i, o, PLANT, claripy.true(), {"stopped": ONE})),
        implies(is_active, _becomes(i, o, PLANT, newer, taken)),
        _is_held(i, o, PLANT, is_hold),
    )


@prove(
    "plant-active",
    "latch",
    "plant_active",
    "RES-002 RES-005 RES-006 RES-007 RES-008 RES-010 RES-025 RES-026 RES-027",
    "From every state, without a horizon or with a tick that is no time: a plant moves, by tick 0, exactly while it is unlatched and alive by the liveness rule; asking it ends a deadline that is not alive and changes no other field.",
    "steps = 0 ∨ no dt ∨ ¬(finite(dt) ∧ dt > 0) ⟹ (answer = 1 ⟺ has_deadline ∧ alive ∧ ¬stopped) ∧ answer ≤ 1; state' = state, without its deadline where ¬alive",
    assume=lambda i: [_plain(i)],
    bounds=PLANT_STATES + "; no horizon, or one whose tick is no time",
)
def _(i, o):
    moves = claripy.And(_lives(i), i["stopped"] == 0)
    return (
        _bit(o["answer"]),
        iff(o["answer"] == 1, moves),
        _becomes(i, o, PLANT, claripy.Not(_lives(i)), NO_DEADLINE),
    )


@prove(
    "plant-horizon-holds",
    "latch",
    "plant_active",
    "RES-002 RES-003 RES-004 RES-005 RES-006 RES-007 RES-008 RES-010 RES-025",
    "From every state and for every horizon: a plant that is latched, or is not alive by the liveness rule, does not move; asking it ends a deadline that is not alive and changes no other field.",
    "stopped ∨ ¬has_deadline ∨ ¬alive ⟹ answer = 0 ∧ state' = state, without its deadline where ¬alive",
    assume=lambda i: [claripy.Or(i["stopped"] == 1, claripy.Not(_lives(i)))],
    bounds=PLANT_STATES + ", every horizon",
)
def _(i, o):
    return o["answer"] == 0, _becomes(i, o, PLANT, claripy.Not(_lives(i)), NO_DEADLINE)


@prove(
    "plant-tick",
    "latch",
    "plant_active",
    "RES-025 RES-028 RES-029",
    "From every state: a plant that is unlatched and alive follows the tick of its horizon into which the age falls, and holds for good once that is beyond its last step; no other field changes.",
    "alive ∧ ¬stopped ∧ steps > 0 ∧ finite(dt) ∧ dt > 0, q = ((now − received)·1000)/dt ⟹ (q ≥ steps + 1 ⟺ answer = 0); answer = k + 1 ⟹ k ≤ q < k + 1; state' = state, without its deadline where answer = 0",
    assume=lambda i: [
        _lives(i),
        i["stopped"] == 0,
        claripy.Not(_plain(i)),
        claripy.ULE(i["steps"], 4096),
    ],
    bounds=PLANT_STATES + "; up to 4,096 steps, as many as a frame may have",
)
def _(i, o):
    ticks = claripy.fpDiv(RNE, age_ms(i["now_s"], i["received_s"]), fp(i["dt_ms"]))
    is_over = claripy.fpGEQ(ticks, of_integer(i["steps"] + 1))
    follows = claripy.And(
        claripy.fpLEQ(of_integer(o["answer"] - 1), ticks), claripy.fpLT(ticks, of_integer(o["answer"]))
    )
    return (
        iff(o["answer"] == 0, is_over),
        implies(o["answer"] != 0, claripy.And(claripy.ULE(o["answer"], i["steps"] + 1), follows)),
        _becomes(i, o, PLANT, is_over, NO_DEADLINE),
    )


@prove(
    "plant-stop",
    "latch",
    "plant_stop",
    "RES-021 RES-022",
    "From every state: a stop latches and changes no other field.",
    "state' = state with the latch",
    bounds=PLANT_STATES,
)
def _(i, o):
    return _becomes(i, o, PLANT, claripy.true(), {"stopped": ONE})


@prove(
    "plant-reset",
    "latch",
    "plant_reset",
    "RES-030 RES-031 RES-032",
    "From every state: a reset clears the latch, the deadline and the last seq, so nothing moves until a new command.",
    "state' = (no last, no deadline, unlatched)",
    bounds=PLANT_STATES,
)
def _(i, o):
    return _all_zero(o, PLANT)


@prove(
    "gates-new",
    "latch",
    "gates_new",
    "SAFE-012 SAFE-013 SAFE-017",
    "New gates have the limits and the timeout that were given, as they are; a limit that cannot be enforced is a config fault; nothing is latched.",
    "each limit' = disabled where absent or ±0, faulty where negative or not finite, else that bound; timeout' = timeout; fault' ⟺ a faulty limit; unlatched",
)
def _(i, o):
    parts = []
    for given, value, kind in (("has_speed", "speed_mps", "speed_kind"), ("has_fence", "radius_m", "fence_kind")):
        is_given, bound = has(i[given], FIRST), i[value]
        is_on = claripy.And(is_given, positive(bound))
        number_of = claripy.If(is_bad(is_given, bound), word(FAULTY), claripy.If(is_on, word(ENABLED), word(DISABLED)))
        parts += [o[f"{kind}_after"] == number_of, o[f"{value}_after"] == claripy.If(is_on, bound, word(0))]
    is_faulty = claripy.Or(o["speed_kind_after"] == FAULTY, o["fence_kind_after"] == FAULTY)
    fault = claripy.If(is_faulty, word(1), word(0))
    return *parts, o["timeout_ms_after"] == i["timeout_ms"], o["fault_after"] == fault, o["stopped_after"] == 0


@prove(
    "gates-bind",
    "latch",
    "gates_bind",
    "SAFE-009 SAFE-014 SAFE-018",
    "From every state: a limit that is not disabled and has no channel is a config fault; a fault stays; no other field changes.",
    "state' = state, with the fault where (speed limit ∧ no velocity) ∨ (fence ∧ no position)",
    bounds=GATE_STATES,
)
def _(i, o):
    unbound = claripy.Or(
        claripy.And(i["speed_kind"] != DISABLED, claripy.Not(has(i["has_velocity"], FIRST))),
        claripy.And(i["fence_kind"] != DISABLED, claripy.Not(has(i["has_position"], FIRST))),
    )
    return _becomes(i, o, GATES, unbound, {"fault": ONE})


@prove(
    "gates-note-link",
    "latch",
    "gates_note_link",
    "SAFE-006 SAFE-007",
    "From every state: a burst latches ESTOP and changes no other field; no burst changes no field at all.",
    "state' = state, with the latch where burst",
    bounds=GATE_STATES,
)
def _(i, o):
    return _becomes(i, o, GATES, has(i["burst"], FIRST), {"stopped": ONE})


@prove(
    "gates-reset",
    "latch",
    "gates_reset",
    "SAFE-008 SAFE-009",
    "From every state: the governor's reset clears the latch and changes no other field: neither a limit, the timeout nor a config fault.",
    "state' = state, unlatched",
    bounds=GATE_STATES,
)
def _(i, o):
    return _becomes(i, o, GATES, claripy.true(), {"stopped": ZERO})


# --- The gates, as they are called: with a horizon, whose ticks answer anything -----------------


@prove(
    "gates-latch",
    "latch",
    "gates_govern",
    "SAFE-003 SAFE-004 SAFE-005 SAFE-020",
    "Gates that are latched, or are given an ESTOP, answer ESTOP and are latched after it, with a horizon or without.",
    "stopped ∨ mode = estop ⟹ answer = stopped(estop) ∧ stopped'",
    assume=lambda i: [_latched(i)],
    bounds=GOVERNED,
)
def _(i, o):
    return o["answer"] == GATE_STOPPED, o["reason"] == BY_ESTOP, o["stopped_after"] == 1


@prove(
    "gates-fault",
    "latch",
    "gates_govern",
    "SAFE-017 SAFE-018",
    "Gates with a config fault hold every command that is no ESTOP, and neither latch nor lose the fault.",
    "¬latched ∧ fault ⟹ answer = held(config fault) ∧ fault' ∧ ¬stopped'",
    assume=lambda i: [claripy.Not(_latched(i)), i["fault"] == 1],
    bounds=GOVERNED,
)
def _(i, o):
    return o["answer"] == GATE_HELD, o["reason"] == BY_FAULT, o["fault_after"] == 1, o["stopped_after"] == 0


@prove(
    "gates-stale",
    "watchdog",
    "gates_govern",
    "SAFE-030 SAFE-031 SAFE-032 SAFE-033 SAFE-034 SAFE-035",
    "Gates hold every command whose sensor is not fresh, as section 7.4 says with the timeout of their own.",
    "¬latched ∧ ¬fault ∧ (no time ∨ ¬fresh(now, last, timeout)) ⟹ answer = held(stale sensor) ∧ ¬stopped'",
    assume=lambda i: [claripy.Not(_latched(i)), i["fault"] == 0, claripy.Not(_fresh(i))],
    bounds=GOVERNED,
)
def _(i, o):
    return o["answer"] == GATE_HELD, o["reason"] == BY_STALE, o["stopped_after"] == 0


@prove(
    "gates-no-position",
    "geofence",
    "gates_govern",
    "SAFE-040 SAFE-043 SAFE-044 SAFE-045",
    "With the fence enabled and the gates before it open, a missing position holds, and one outside, or one of which that cannot be computed, latches ESTOP.",
    "¬latched ∧ ¬fault ∧ fresh ∧ fence: no place ⟹ held(no position) ∧ ¬stopped'; place ∧ ¬inside ⟹ stopped(outside fence) ∧ stopped'",
    assume=lambda i: [
        *_before_fence(i),
        i["fence_kind"] == ENABLED,
        claripy.Not(claripy.And(has(i["has_place"], FIRST), _is_inside(i))),
    ],
    bounds=GOVERNED,
)
def _(i, o):
    has_place = has(i["has_place"], FIRST)
    held = claripy.And(o["answer"] == GATE_HELD, o["reason"] == BY_NO_POSITION, o["stopped_after"] == 0)
    stopped = claripy.And(o["answer"] == GATE_STOPPED, o["reason"] == BY_OUTSIDE, o["stopped_after"] == 1)
    return claripy.If(has_place, stopped, held)


@prove(
    "gates-mode",
    "latch",
    "gates_govern",
    "SAFE-001 SAFE-002",
    "A command that is not active does not pass.",
    "mode ≠ active ⟹ answer ∈ {held, stopped}; and where the gates before are open: held(not active)",
    assume=lambda i: [i["mode"] != ACTIVE],
    bounds=GOVERNED,
)
def _(i, o):
    does_not_pass = claripy.Or(o["answer"] == GATE_HELD, o["answer"] == GATE_STOPPED)
    is_open = claripy.And(*_before_fence(i), claripy.Or(i["fence_kind"] != ENABLED, _is_placed(i)))
    return does_not_pass, implies(is_open, claripy.And(o["answer"] == GATE_HELD, o["reason"] == BY_MODE))


@prove(
    "gates-govern",
    "latch",
    "gates_govern",
    "SAFE-003 SAFE-005 SAFE-017 SAFE-020 SAFE-050 SAFE-051 SAFE-052 SAFE-053 SAFE-055 SAFE-066 SAFE-067 SAFE-068",
    "What the gates answer, for which reason, and how many steps of the horizon are left, is exactly what the order of section 7.3 says of state, command, place and ticks: nothing is cut or held that need not be.",
    "answer, reason = those of the first gate that closes, in the order latch, fault, fresh, place, fence, mode, horizon, tick 0, end of tick 0 or of the ttl; where it passes: steps' = the leading steps that the speed limit takes and that, with a fence, end inside; limited ⟺ steps' < steps ∨ a tick taken was changed",
    assume=lambda i: [_faulty_fence_is_fault(i)],
    bounds=GOVERNED,
    assumptions=("a fence that cannot be enforced has its config fault: so gates-new builds it, and each step keeps it (gates-bind, -note-link, -reset, -frame)",),
)
def _(i, o):
    said = _governed(i)
    passes = claripy.ULE(o["answer"], GATE_LIMITED)
    return (
        o["answer"] == said.answer,
        o["reason"] == said.reason,
        implies(passes, o["steps_after"] == said.steps),
    )


@prove(
    "gates-frame",
    "latch",
    "gates_govern",
    "SAFE-003 SAFE-004 SAFE-005 SAFE-009 SAFE-043",
    "From every state: deciding on a command changes no field but the latch: neither a limit, the timeout nor a config fault. The latch is set exactly where the answer is ESTOP, and never cleared.",
    "state' = state with the latch where answer = stopped; stopped ⟹ answer = stopped; the position is asked for at most once, and no tick beyond the horizon",
    bounds=GOVERNED,
)
def _(i, o):
    stops = o["answer"] == GATE_STOPPED
    return (
        _becomes(i, o, GATES, stops, {"stopped": ONE}),
        implies(i["stopped"] == 1, stops),
        claripy.ULE(o["places"], 1),
        o["beyond"] == 0,
    )


@prove(
    "gates-limits",
    "clamp",
    "gates_govern",
    "SAFE-050 SAFE-060 SAFE-063 SAFE-066 SAFE-067",
    "Of a command that passes, tick 0 and each step that is left was brought within the gates' own speed limit, once each, and none of them refused it.",
    "answer ∈ {passed, limited}, k ≤ steps' ⟹ tick k was limited once, by (speed kind, speed), and answered that it may be used; steps' ≤ steps",
    assume=lambda i: [i["fence_kind"] != FAULTY],
    bounds=GOVERNED + "; a fence that is not faulty",
)
def _(i, o):
    passes = claripy.ULE(o["answer"], GATE_LIMITED)
    parts = [claripy.ULE(o["steps_after"], i["steps"])]
    for k in TICKS:
        limited = claripy.And(
            o[f"times{k}"] == 1,
            o[f"kind{k}"] == i["speed_kind"],
            o[f"bound{k}"] == i["speed_mps"],
            claripy.ULE(i[f"says{k}"], SAYS_CHANGED),
        )
        parts.append(implies(claripy.UGE(o["steps_after"], k), limited))
    return implies(passes, claripy.And(*parts))


@prove(
    "gates-inside",
    "geofence",
    "gates_govern",
    "SAFE-043 SAFE-050 SAFE-051 SAFE-052 SAFE-053 SAFE-055",
    "Of a command that passes with the fence enabled, the place is inside, and so is the end of tick 0 and of each step that is left, projected with the velocity after the speed limit; without a step, the end of the ttl.",
    "fence ∧ answer ∈ {passed, limited} ⟹ inside(p) ∧ has_velocity₀; steps' > 0, k ≤ steps' ⟹ inside(endₖ), end₀ = p + v₀·share₀, endₖ = endₖ₋₁ + vₖ·shareₖ; steps' = 0 ⟹ inside(p + v₀·ttl)",
    assume=lambda i: [i["fence_kind"] == ENABLED],
    bounds=GOVERNED,
)
def _(i, o):
    passes = claripy.ULE(o["answer"], GATE_LIMITED)
    inside = _ends_inside(i)
    steps = [implies(claripy.UGE(o["steps_after"], max(k, 1)), inside[k]) for k in TICKS]
    return implies(
        passes,
        claripy.And(
            _is_placed(i),
            has(i["has0"], FIRST),
            *steps,
            implies(o["steps_after"] == 0, _ttl_ends_inside(i)),
        ),
    )


@prove(
    "limit-tick",
    "clamp",
    "limit_tick",
    "SAFE-060 SAFE-062 SAFE-063 SAFE-064 SAFE-065 SAFE-069",
    "A tick is used exactly when each component is finite and, with a limit, there is a velocity of three components in m/s; then each channel in m/s is within the limit, and unchanged where it was within already; every other is unchanged, in whatever order the channels come.",
    "¬finite ⟹ not finite; else limit ≠ disabled ∧ ¬(limit enabled ∧ ∃ velocity in m/s, 3 wide) ⟹ no velocity; else used, changed ⟺ ∃ channel in m/s: √Σxᵢ² > max; in m/s ∧ √Σxᵢ² > max ⟹ finite(out) ∧ √Σoutᵢ² ≤ max; otherwise out = x bit for bit",
    assume=lambda i: [implies(i["kind"] == ENABLED, positive(i["bound"]))],
    bounds="no channel, one of up to three components, or two of three; else none: every double, limit, unit and order",
    assumptions=("an enabled limit has a finite positive bound: so gates-new builds it, and each step keeps it",),
)
def _(i, o):
    channels = [_channel(i, o, k) for k in range(CHANNELS)]
    all_are_finite = claripy.And(*[channel.is_finite for channel in channels])
    is_on = i["kind"] == ENABLED
    is_moved = claripy.Or(*[channel.is_velocity for channel in channels])
    is_used = claripy.And(all_are_finite, claripy.Or(i["kind"] == DISABLED, claripy.And(is_on, is_moved)))
    is_changed = claripy.Or(*[channel.is_above for channel in channels])
    answer = claripy.If(
        claripy.Not(all_are_finite),
        word(2 + BY_NOT_FINITE),
        claripy.If(
            is_used, claripy.If(is_changed, word(1), word(0)), word(2 + BY_NO_VELOCITY)
        ),
    )
    left = [claripy.If(channel.is_above, channel.is_within, channel.is_same) for channel in channels]
    return o["answer"] == answer, implies(is_used, claripy.And(*left))


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
        claripy.fpLEQ(norm(*out), fp(i["max"])),
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
        claripy.fpLEQ(norm(i["x"], i["y"], i["z"]), fp(i["max"])),
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


def _becomes(i, o, fields, when, new):
    """The whole state after: field by field what is new when it is so, and else, and where nothing is new, the same."""
    return claripy.And(
        *[o[f"{field}_after"] == claripy.If(when, new.get(field, i[field]), i[field]) for field in fields]
    )


def _all_zero(o, fields):
    return claripy.And(*[o[f"{field}_after"] == 0 for field in fields])


def _hold_counts(i):
    return hold_counts(i["has_last"] == 1, i["last"], i["seq"])


def _is_held(i, o, fields, when):
    """What a HOLD makes of a watchdog, or of that of a plant, when there is one."""
    has_last, last, seq = i["has_last"] == 1, i["last"], i["seq"]
    moves = claripy.And(is_newer(has_last, last, seq), seq != 0)
    held = NO_DEADLINE | {
        "has_last": claripy.If(moves, ONE, i["has_last"]),
        "last": claripy.If(moves, seq, last),
    }
    return implies(when, _becomes(i, o, fields, _hold_counts(i), held))


def _lives(i):
    return claripy.And(i["has_deadline"] == 1, alive(i["now_s"], i["received_s"], i["ttl_ms"]))


def _plain(i):
    has_tick = claripy.And(has(i["has_dt"], FIRST), positive(i["dt_ms"]))
    return claripy.Or(i["steps"] == 0, claripy.Not(has_tick))


def _latched(i):
    return claripy.Or(i["stopped"] == 1, i["mode"] == ESTOP)


def _fresh(i):
    return claripy.And(has(i["has_time"], FIRST), fresh(i["now_s"], i["last_s"], i["timeout_ms"]))


def _before_fence(i):
    return [claripy.Not(_latched(i)), i["fault"] == 0, _fresh(i)]


def _faulty_fence_is_fault(i):
    return implies(i["fence_kind"] == FAULTY, i["fault"] == 1)


def _is_inside(i):
    return in_ball(i["x"], i["y"], i["z"], i["radius_m"])


def _is_placed(i):
    return claripy.And(has(i["has_place"], FIRST), _is_inside(i))


def _ttl(i):
    """The ttl that is enforced, in ms; 0 for one that is no time."""
    ttl, most = fp(i["ttl_ms"]), number(60_000.0)
    least = claripy.If(claripy.fpLT(ttl, most), ttl, most)
    return claripy.If(positive(i["ttl_ms"]), least, number(0.0))


def _share(i, tick):
    """The part of a tick before the end of the ttl, in ms: section 7.6."""
    dt, ttl = fp(i["dt_ms"]), _ttl(i)
    start = claripy.fpMul(RNE, number(float(tick)), dt)
    rest = claripy.fpSub(RNE, ttl, start)
    return claripy.If(
        claripy.fpLT(start, ttl), claripy.If(claripy.fpLT(dt, rest), dt, rest), number(0.0)
    )


def _velocity_of(i, tick):
    return [fp(i[f"{c}{tick}"]) for c in "uvw"]


def _ends_inside(i):
    """Whether each tick ends inside, each projected from the end of the one before."""
    place, inside = _place(i), []
    for tick in TICKS:
        place = moved(place, _velocity_of(i, tick), _share(i, tick))
        inside.append(claripy.And(has(i[f"has{tick}"], FIRST), ends_in_ball(place, i["radius_m"])))
    return inside


def _ttl_ends_inside(i):
    return ends_in_ball(moved(_place(i), _velocity_of(i, 0), _ttl(i)), i["radius_m"])


def _leading(steps, holds):
    """How many of the steps hold from the first on, as a word, of at most so many."""
    count = word(0)
    for step in reversed(range(1, STEPS + 1)):
        count = claripy.If(claripy.And(claripy.UGE(steps, step), holds[step]), count + 1, word(0))
    return count


@dataclass(frozen=True)
class Governed:
    """What the gates have to answer."""

    answer: object
    reason: object
    steps: object


GOVERNED_BEFORE = {}


def _governed(i):
    """What section 7.3 says of state, command, place and ticks; made once for the same inputs."""
    key = tuple(value.hash() for value in i.values())
    if key not in GOVERNED_BEFORE:
        GOVERNED_BEFORE[key] = _make_governed(i)
    return GOVERNED_BEFORE[key]


def _make_governed(i):
    steps, has_fence = i["steps"], i["fence_kind"] == ENABLED
    has_tick = claripy.And(has(i["has_dt"], FIRST), positive(i["dt_ms"]))
    taken = [claripy.ULE(i[f"says{k}"], SAYS_CHANGED) for k in TICKS]
    limited_steps = _leading(steps, taken)
    changed = claripy.Or(
        *[claripy.And(claripy.UGE(limited_steps, k), i[f"says{k}"] == SAYS_CHANGED) for k in TICKS]
    )
    inside = _ends_inside(i)
    inside_steps = _leading(limited_steps, inside)
    left = claripy.If(has_fence, inside_steps, limited_steps)
    # [NCP-SAFE-051] [NCP-SAFE-053]
    leaves = claripy.Or(
        claripy.And(limited_steps != 0, claripy.Not(inside[0])),
        claripy.And(inside_steps == 0, claripy.Not(_ttl_ends_inside(i))),
    )
    gates = [
        (_latched(i), GATE_STOPPED, BY_ESTOP),
        (i["fault"] == 1, GATE_HELD, BY_FAULT),
        (claripy.Not(_fresh(i)), GATE_HELD, BY_STALE),
        (claripy.And(has_fence, claripy.Not(has(i["has_place"], FIRST))), GATE_HELD, BY_NO_POSITION),
        (claripy.And(has_fence, claripy.Not(_is_inside(i))), GATE_STOPPED, BY_OUTSIDE),
        (i["mode"] != ACTIVE, GATE_HELD, BY_MODE),
        (claripy.And(steps != 0, claripy.Not(has_tick)), GATE_HELD, BY_HORIZON),
        (i["says0"] == SAYS_NOT_FINITE, GATE_HELD, BY_NOT_FINITE),
        (i["says0"] == SAYS_NO_VELOCITY, GATE_HELD, BY_NO_VELOCITY),
        (claripy.And(has_fence, claripy.Not(has(i["has0"], FIRST))), GATE_HELD, BY_NO_VELOCITY),
        (claripy.And(has_fence, leaves), GATE_HELD, BY_LEAVING),
    ]
    is_limited = claripy.Or(changed, claripy.ULT(left, steps))
    answer = claripy.If(is_limited, word(GATE_LIMITED), word(GATE_PASSED))
    reason = word(NO_REASON)
    for closes, says, why in reversed(gates):
        answer, reason = claripy.If(closes, word(says), answer), claripy.If(closes, word(why), reason)
    return Governed(answer, reason, left)


@dataclass(frozen=True)
class Limited:
    """What is asked of a channel, each with whether there is such a channel in it."""

    is_finite: object
    is_velocity: object
    is_above: object
    is_within: object
    is_same: object


def _channel(i, o, k):
    before, left = [i[f"{c}{k}"] for c in "xyz"], [o[f"{c}_after{k}"] for c in "xyz"]
    is_there, width = claripy.UGT(i["count"], k), i[f"width{k}"]
    in_mps = claripy.And(is_there, has(i[f"in_mps{k}"], FIRST))
    counts = [claripy.And(is_there, claripy.UGT(width, n)) for n in range(WIDTH)]
    is_wide = width == WIDTH
    bound = fp(i["bound"])

    def is_above(vector):
        above = [claripy.Not(claripy.fpLEQ(length([fp(x) for x in vector[:n]]), bound)) for n in (1, 2, 3)]
        return claripy.Or(*[claripy.And(width == n, above[n - 1]) for n in (1, 2, 3)])

    limits = claripy.And(in_mps, i["kind"] == ENABLED)
    unused = [implies(claripy.ULE(width, n), left[n] == before[n]) for n in range(WIDTH)]
    are_finite = [implies(counts[n], finite(left[n])) for n in range(WIDTH)]
    return Limited(
        claripy.And(*[implies(counts[n], finite(before[n])) for n in range(WIDTH)]),
        claripy.And(in_mps, has(i[f"is_velocity{k}"], FIRST), is_wide),
        claripy.And(limits, is_above(before)),
        claripy.And(*unused, *are_finite, claripy.Not(is_above(left))),
        claripy.And(*[a == b for a, b in zip(before, left, strict=True)]),
    )
