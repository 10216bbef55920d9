"""Proves what the machine code of the safety kernel does. `README.md` says how to run it.

Exit code 0: every property is proved, and every broken kernel refuted. 1: not so.
"""

import argparse
import hashlib
import importlib.metadata
import json
import os
import subprocess
import sys
import time
import tomllib
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import claripy

import native
import solver
import vector
from machine import Incomplete, Library
import controls
from properties import PROPERTIES, SIGNATURES, outputs
from sabotage import SABOTAGES, sabotaged

HERE = Path(__file__).resolve().parent
DEFECTS = HERE.parent.parent / "defects" / "kernel.toml"
HINTS = HERE / "hints.toml"
PATHS = HERE / "paths.toml"
# So many paths are one obligation.
GROUP = 32

SLOW = ("gates_govern", "limit_tick", "projection", "plant_active", "clamp")

PATHS_HEAD = "# How many paths each function has: `prove.sh --accept` writes it. Another number is looked at first.\n\n"
# What the parts of a function add up to.
SUMS = ("paths", "obligations", "by_arithmetic", "instructions", "seconds")
# What a sabotaged engine is run on.
SABOTAGED = "machine/watchdog-hold"

# What a process of the pool works with.
HELD = {}

TRUSTED = [
    "angr's lifter (VEX) gives each instruction its meaning, doubles by IEEE 754 in round-to-nearest; the control registers are those that a program starts with",
    "memset, which the C library brings, writes one byte so often as it is told",
    "claripy's translation of formulas to SMT-LIB, and bitwuzla or z3, whichever answers; no two answers contradict each other",
    "the processor computes what the lifter says",
    "the sentences and formulas of proofs/machine/properties.py say what the text says",
    "a program that uses ncp-spec inlines the kernel anew: this is the machine code of the exported functions, by the same compiler and profile",
]
NOT_PROVED = [
    "that a clamped vector keeps its direction: proved over the kernel's source, by the symbolic engine",
    "horizons of more than 3 steps; and with an open fence, a horizon whose ticks and ttl have other lengths than the two pairs that the bounds name",
    "ticks of more than two channels, two channels of which one is not three wide, or more than three components, by the speed limit",
    "that a caller's plan answers the gates by the speed limit that limit-tick is about: the gates are proved for any answers",
    "the machine code of any other target or profile than the one that was built",
]


def main():
    arguments = parse_arguments()
    if arguments.sabotage:
        return sabotage(arguments)
    start = time.monotonic()
    evidence = arguments.evidence
    if evidence:
        evidence.mkdir(parents=True, exist_ok=True)
    wanted = [p for p in PROPERTIES if arguments.only in p.id]
    defects = [] if arguments.no_broken else planted(arguments.only)
    files = (arguments.library, arguments.broken if defects else None, evidence)
    # The slow ones first: none of them is left alone at the end.
    functions = sorted(
        {p.function for p in wanted},
        key=lambda function: (SLOW.index(function) if function in SLOW else len(SLOW), function),
    )
    with ProcessPoolExecutor(arguments.jobs, initializer=begin, initargs=files) as pool:
        controlled = pool.submit(control_here)
        proved = [
            pool.submit(prove_here, function, part, arguments.only)
            for function in functions
            for part in range(len(SIGNATURES[function].slices))
        ]
        refuted = [pool.submit(refute_here, *defect) for defect in defects]
        parts = [result for future in proved for result in future.result()]
        faults = controlled.result() + pinned(parts, arguments.accept)
        results = [joined(p, [part for part in parts if part["property"] == p.id]) for p in wanted]
        if any(result["verdict"] == "refuted" for result in results):
            print("the kernel is refuted: the broken kernels would mean nothing and are left out")
            pool.shutdown(cancel_futures=True)
            refuted = []
        refuted = [future.result() for future in refuted]
    report = {
        "name": "machine",
        "version": "angr {}, bitwuzla {}, z3 {}".format(
            *(importlib.metadata.version(name) for name in ("angr", "bitwuzla", "z3-solver"))
        ),
        "results": results,
        "broken": refuted,
        "trusted": TRUSTED,
        "not_proved": NOT_PROVED,
        "library_sha256": hashlib.sha256(arguments.library.read_bytes()).hexdigest(),
        "seconds": round(time.monotonic() - start, 1),
    }
    for fault in faults:
        print(f"THE ENGINE IS WRONG: {fault}")
    if faults:
        # What a wrong engine says means nothing.
        for result in results:
            result |= {"verdict": "not run", "detail": f"the engine is wrong: {faults[0]}"}
    if arguments.json:
        text = json.dumps(report, indent=2, ensure_ascii=False) + "\n"
        arguments.json.write_text(text, encoding="utf-8")
    good = all(r["verdict"] == "proved" for r in results) and not any("missed" in r for r in refuted)
    print(f"{report['seconds']} s: " + ("all proved and refuted" if good else "NOT all"))
    return 2 if faults else 0 if good else 1


def sabotage(arguments):
    """Runs the engine with a fault of its own, on few properties; each fault has to end the run as the engine's."""
    names = list(SABOTAGES) if arguments.sabotage == "all" else [arguments.sabotage]
    unnoticed = []
    for name in names:
        command = [
            *(sys.executable, __file__, "--no-broken", "--jobs", "1", "--only", SABOTAGED),
            *("--library", arguments.library),
        ]
        ran = subprocess.run(
            command, env=os.environ | {"NCP_MACHINE_SABOTAGE": name}, capture_output=True, text=True, check=False
        )
        said = [line for line in ran.stdout.splitlines() if line.startswith("THE ENGINE")]
        print(f"{name} ({SABOTAGES.get(name, 'unknown')}): " + (said[0] if said else "NOT NOTICED"))
        if ran.returncode != 2 or not said:
            unnoticed.append(name)
            print(ran.stdout[-2000:], ran.stderr[-2000:])
    print(f"not noticed: {unnoticed}" if unnoticed else f"{len(names)} of {len(names)} noticed")
    return 1 if unnoticed else 0


def joined(wanted, parts):
    """What the parts of a function say together of a property."""
    first = said(wanted) | {"function": f"ncp_{wanted.function}"}
    words = {part["verdict"] for part in parts}
    if "refuted" in words:
        return first | next(part for part in parts if part["verdict"] == "refuted")
    undecided = [part["detail"] for part in parts if part["verdict"] == "not run"]
    if not undecided and not any(part["is_possible"] for part in parts):
        undecided = ["what it assumes is a contradiction"]
    sums = {key: sum(part.get(key, 0) for part in parts) for key in SUMS}
    lists = {key: [item for part in parts for item in part.get(key, [])] for key in ("path_blocks", "answers")}
    result = first | sums | lists | {"verdict": "not run" if undecided else "proved"}
    print(
        f"{result['verdict']:8} {wanted.id}: {sums['paths']} paths, {sums['by_arithmetic']} of {sums['obligations']} "
        f"questions need arithmetic, {sums['seconds']:.1f} s",
        *undecided,
        flush=True,
    )
    return result | ({"detail": "; ".join(undecided)} if undecided else {})


def pinned(parts, is_accepted):
    """Functions that have another number of paths than the last time that this was looked at."""
    now = {part["part"]: part["paths"] for part in parts if part["paths"]}
    before = tomllib.loads(PATHS.read_text(encoding="utf-8")) if PATHS.exists() else {}
    if is_accepted:
        lines = [f"{function} = {paths}\n" for function, paths in sorted((before | now).items())]
        PATHS.write_text(PATHS_HEAD + "".join(lines), encoding="utf-8")
        return []
    return [
        f"{function} has {paths} paths, and had {before.get(function, 'none')}: the compiler makes other code, the "
        "kernel changed, or the exploration is wrong; look, and then --accept"
        for function, paths in sorted(now.items())
        if before.get(function) != paths
    ]


def planted(only):
    """The planted defects, each with a property whose id has `only` in it and that has to refute it."""
    defects = tomllib.loads(DEFECTS.read_text(encoding="utf-8"))["defect"]
    hints = tomllib.loads(HINTS.read_text(encoding="utf-8"))
    named = {wanted for defect in defects for wanted in defect["properties"] if wanted.startswith("machine/")}
    unknown = (named - {wanted.id for wanted in PROPERTIES}) | (hints.keys() - {defect["name"] for defect in defects})
    if unknown:
        raise SystemExit(f"there is no such property, or no such defect: {sorted(unknown)}")
    return [
        (defect | {"hint": hints.get(defect["name"], {})}, wanted)
        for defect in defects
        if not defect.get("engines") or "machine" in defect["engines"]
        for wanted in defect["properties"]
        if wanted in named and only in wanted
    ]


def prefix(defect):
    """What the names of a broken kernel's functions begin with."""
    return defect["name"].replace("-", "_")


def begin(library, broken, evidence):
    """Loads the libraries, once a process."""
    HELD["library"] = Library(library)
    HELD["native"] = (native.load(broken) if broken else None, native.load(library))
    if broken:
        HELD["broken"] = Library(broken)
    HELD["evidence"] = evidence


def control_here():
    """What is wrong with the engine, by controls whose answers are known."""
    whole = HELD["native"][1]
    return controls.faults(
        lambda wanted: joined(wanted, prove(HELD["library"], [wanted], None)),
        lambda wanted, found: replays(wanted, found, whole, "ncp", None),
    )


def prove_here(function, part, only):
    wanted = [p for p in PROPERTIES if p.function == function and only in p.id]
    return prove(HELD["library"], wanted, HELD["evidence"], part)


def refute_here(defect, wanted):
    return refute(HELD["broken"], *HELD["native"], defect, next(p for p in PROPERTIES if p.id == wanted))


def prove(library, wanted, evidence, part=0):
    """Shows properties of one part of a function on each of its paths, and that no path is missing."""
    function = wanted[0].function
    name, slice_of, fixed = SIGNATURES[function].slices[part]
    shown = {"part": f"{function}-{name}".rstrip("-"), "paths": 0, "seconds": 0.0}
    start = time.process_time()
    try:
        exploration = library.explore(f"ncp_{function}", SIGNATURES[function], slice_of, fixed)
    except Incomplete as error:
        print(f"not run  {shown['part']}: {error}", flush=True)
        return [said(one) | shown | {"verdict": "not run", "detail": str(error)} for one in wanted]
    shown["paths"] = len(exploration.paths)
    assumes = [*SIGNATURES[function].domain(exploration.inputs), *slice_of(exploration.inputs)]
    complete = [("no-other-path", *solver.decide([*assumes, no_path(exploration)]))]
    shown["seconds"] = round(time.process_time() - start, 2)
    results = []
    for one in wanted:
        start = time.process_time()
        results.append(shown | prove_one(one, exploration, assumes, complete, evidence and (evidence, name)))
        # The exploration and its question are the first one's.
        results[-1]["seconds"] = shown["seconds"] + round(time.process_time() - start, 2)
        shown["seconds"] = 0.0
    print(f"         {shown['part']}: {shown['paths']} paths", flush=True)
    return results


def said(wanted):
    """What a property says."""
    return {
        "property": wanted.id,
        "family": wanted.family,
        "rules": list(wanted.rules),
        "sentence": wanted.sentence,
        "statement": wanted.formal,
        "bounds": wanted.bounds,
        "assumptions": list(wanted.assumptions),
    }


def prove_one(wanted, exploration, domain, complete, evidence):
    """Shows one property of a function whose paths are known, and are all of them as far as `complete` says."""
    assumes = [*domain, *assumed(wanted, exploration)]
    asked = obligations(wanted, exploration, assumes)
    decisions = complete + [(name, *solver.decide(formulas)) for name, formulas in asked]
    verdicts = {decision.verdict for _, _, decision in decisions}
    result = said(wanted)
    if evidence:
        folder, part = evidence
        for name, text, _ in decisions:
            names = [wanted.id.replace("/", "-"), part, name]
            (folder / ("-".join(filter(None, names)) + ".smt2")).write_text(text, encoding="utf-8")
    if verdicts == {solver.Verdict.UNSAT}:
        outcome = "proved"
    elif solver.Verdict.SAT in verdicts:
        outcome = "refuted"
        inputs = shown_model(wanted, exploration, decisions)
        result["counterexample"] = {"function": wanted.function, "inputs": inputs or {}}
        print(f"refuted  {wanted.id}: {inputs}", flush=True)
    else:
        outcome = "not run"
        left = [name for name, _, decision in decisions if decision.verdict is not solver.Verdict.UNSAT]
        result["detail"] = f"not decided: {left}"
    return result | {
        "verdict": outcome,
        "is_possible": is_possible(assumes),
        "function": f"ncp_{wanted.function}",
        "address": hex(exploration.start),
        "instructions": len(exploration.instructions),
        "path_blocks": [[hex(block) for block in path.blocks] for path in exploration.paths],
        "obligations": len(decisions),
        "by_arithmetic": sum(decision.by_arithmetic for _, _, decision in decisions),
        "answers": [
            {
                "obligation": name,
                "sha256": hashlib.sha256(text.encode()).hexdigest(),
                "answers": decision.words,
            }
            for name, text, decision in decisions
        ],
    }


def is_possible(assumes):
    """Whether there are inputs at all of which a property says something: otherwise it is true of nothing."""
    return solver.ask_bitwuzla(solver.smt(assumes)) == "sat"


def assumed(wanted, exploration):
    """What a property assumes of its inputs."""
    if sabotaged("lose-assumption"):
        return []
    return [*wanted.assume(exploration.inputs), *([claripy.false()] if sabotaged("false-assumption") else [])]


def shown_model(wanted, exploration, decisions):
    """Inputs for which a property does not hold."""
    names = {name: value.args[0] for name, value in exploration.inputs.items() if value.symbolic}
    fixed = {name: value.args[0] for name, value in exploration.inputs.items() if not value.symbolic}
    text = next(text for _, text, decision in decisions if decision.verdict is solver.Verdict.SAT)
    found = solver.model(text, names)
    return found and native.shown(SIGNATURES[wanted.function], found | fixed)


def no_path(exploration):
    """That an input takes no path, which must be unsatisfiable."""
    taken = [claripy.And(claripy.true(), *path.conditions) for path in exploration.paths]
    return claripy.Not(claripy.Or(*taken, claripy.false()))


def obligations(wanted, exploration, assumes):
    """What must be unsatisfiable: a path that ends wrongly, and an input that is no case."""
    inputs = exploration.inputs
    cases = wanted.cases(inputs)
    for name, when, values in cases:
        wrong = [ends_wrongly(wanted, inputs | values, path) for path in exploration.paths]
        for first in range(0, len(wrong), GROUP):
            some = claripy.Or(claripy.false(), *wrong[first : first + GROUP])
            yield f"{name}-paths-from-{first}".lstrip("-"), [*assumes, when, some]
    if len(cases) > 1:
        whens = [when for _, when, _ in cases]
        yield "no-other-case", [*assumes, claripy.Not(claripy.Or(*whens))]


def ends_wrongly(wanted, inputs, path):
    """That the path is taken, and leaves what the property forbids."""
    left = outputs(wanted.function, path.answer, path.memory)
    conclusion = claripy.true() if sabotaged("skip-conclusion") else wanted.conclusion(inputs, left)
    return claripy.And(*path.conditions, claripy.Not(conclusion))


def refute(code, broken, whole, defect, wanted):
    """Finds a counterexample to a property in a broken kernel, and runs it natively."""
    report = {
        "id": defect["name"],
        "property": wanted.id,
        "family": wanted.family,
        "about": defect["about"],
        "missed": "no counterexample",
    }
    try:
        found = counterexample(code, wanted, defect)
    except Incomplete as error:
        found, report["missed"] = None, str(error)
    if found is not None:
        shown = replays(wanted, found, broken, prefix(defect), whole)
        if shown is None:
            report["missed"] = f"its counterexample shows nothing natively: {found}"
        else:
            case = vector.case(defect["name"], wanted, found, *shown.pop("left"))
            report["counterexample"] = shown | ({"vector": case} if case else {})
            del report["missed"]
    print(f"{'NOT REFUTED' if 'missed' in report else 'refuted':8} {defect['name']} by {wanted.id}", flush=True)
    return report


def replays(wanted, found, broken, prefix, whole):
    """What the code does on a counterexample, run natively; None unless that breaks the property, and the kernel,
    where it is given, keeps it."""
    function, signature = wanted.function, SIGNATURES[wanted.function]
    wrong = native.run(broken, f"{prefix}_{function}", function, signature, found)
    right = native.run(whole, f"ncp_{function}", function, signature, found) if whole else None
    breaks = sabotaged("no-replay") or not holds(wanted, found, wrong)
    if not breaks or (whole and not holds(wanted, found, right)):
        return None
    shown = {
        "function": function,
        "inputs": native.shown(signature, found),
        "broken": native.shown_outputs(wrong),
    }
    return shown | ({"kernel": native.shown_outputs(right), "left": (right, wrong)} if whole else {})


def counterexample(code, wanted, defect):
    """Inputs for which a path of a broken kernel ends where the property forbids.

    A hint says with which inputs a defect shows, which spares the search for them.
    """
    signature = SIGNATURES[wanted.function]
    fixed = {name: native.bits(value) for name, value in defect["hint"].items()}
    symbol = f"{prefix(defect)}_{wanted.function}"
    exploration = code.explore(symbol, signature, wanted.assume, fixed)
    names = {
        name: variable.args[0]
        for name, variable in exploration.inputs.items()
        if name not in fixed
    }
    assumes = [*signature.domain(exploration.inputs), *assumed(wanted, exploration)]
    for path in exploration.paths:
        for _, when, values in wanted.cases(exploration.inputs):
            wrong = [*assumes, when, ends_wrongly(wanted, exploration.inputs | values, path)]
            # Where nothing is wrong even without arithmetic, there is nothing to search for.
            found = solver.model(solver.smt(wrong), names) if solver.can_be(wrong) else None
            if found is not None:
                return found | fixed
    return None


def holds(wanted, inputs, left):
    """Whether a property holds of one native run."""
    bits = {name: claripy.BVV(value, 64) for name, value in inputs.items()}
    words = {name: claripy.BVV(value, 64) for name, value in left.items()}
    wrong = claripy.Or(
        claripy.false(),
        *[
            claripy.And(when, claripy.Not(wanted.conclusion(bits | values, words)))
            for _, when, values in wanted.cases(bits)
        ],
    )
    assumes = [*SIGNATURES[wanted.function].domain(bits), *wanted.assume(bits)]
    return solver.decide([*assumes, wrong])[1].verdict is solver.Verdict.UNSAT


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    release = HERE.parent.parent / "target" / "release"
    parser.add_argument("--library", type=Path, default=release / "libncp_machine.so")
    parser.add_argument(
        "--broken", type=Path, default=release / "examples" / "libncp_machine_broken.so"
    )
    parser.add_argument("--json", type=Path, help="write the result there")
    parser.add_argument("--evidence", type=Path, help="write each obligation there, as SMT-LIB 2")
    parser.add_argument("--only", default="", help="only properties whose id has this in it")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes")
    parser.add_argument("--no-broken", action="store_true", help="leave the broken kernels out")
    parser.add_argument("--accept", action="store_true", help="take the numbers of paths as they are for those to come")
    parser.add_argument("--sabotage", help="plant a fault in the engine, or `all` one after the other: each has to be noticed")
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
