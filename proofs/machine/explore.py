"""Proves what the machine code of the safety kernel does. `README.md` says how to run it.

Exit code 0: every property is proved, and every broken kernel refuted. 1: not so.
"""

import argparse
import contextlib
import hashlib
import importlib.metadata
import io
import json
import multiprocessing
import os
import sys
import time
import tomllib
from pathlib import Path

import claripy
from elftools.elf.constants import SH_FLAGS
from elftools.elf.elffile import ELFFile

import controls
import native
import solver
import vector
from machine import Incomplete, Library
from properties import PROPERTIES, SIGNATURES, outputs

HERE = Path(__file__).resolve().parent
DEFECTS = HERE.parent.parent / "defects" / "kernel.toml"
HINTS = HERE / "hints.toml"
# What z3 may spend where doubles are computed: it answers soon, or not at all.
SHORT_RESOURCES = 200_000
# So many paths are one obligation.
GROUP = 32

SLOW = ("projection", "clamp", "plant_active", "gates_govern")

# What a process of the pool works with.
HELD = {}

TRUSTED = [
    "angr's lifter (VEX) gives each instruction its meaning, doubles by IEEE 754 in round-to-nearest; the control registers are those that a program starts with",
    "claripy's translation of formulas to SMT-LIB, and bitwuzla or z3, whichever answers; no two answers contradict each other",
    "the processor computes what the lifter says",
    "the sentences and formulas of proofs/machine/properties.py say what the text says",
    "a program that uses ncp-spec inlines the kernel anew: this is the machine code of the exported functions, by the same compiler and profile",
]
NOT_PROVED = [
    "that a clamped vector keeps its direction: proved over the kernel's source, by the symbolic engine",
    "what the governor's gates do with an active command that is fresh, within the fence and in no fault, and with a position that is finite: that they ask the clamp and the projection, and all of a horizon",
    "which step of a horizon a plant follows, and that with a horizon it holds once the command is too old; without one it is proved",
    "that the governor compares the age of a sensor with the timeout as is-fresh does: only what is decided without the age",
    "the machine code of any other target or profile than the one that was built",
]


def loaded_sha256(library: Path) -> str:
    """What of a library runs: its sections that are loaded, but for the build's id. Debug information has paths."""
    digest = hashlib.sha256()
    with library.open("rb") as file:
        for section in ELFFile(file).iter_sections():
            if section["sh_flags"] & SH_FLAGS.SHF_ALLOC and section.name != ".note.gnu.build-id":
                digest.update(section.data())
    return digest.hexdigest()


def main():
    arguments = parse_arguments()
    start = time.monotonic()
    evidence = arguments.evidence
    if evidence:
        evidence.mkdir(parents=True, exist_ok=True)
    wanted = [p for p in PROPERTIES if arguments.only in p.id]
    defects = [] if arguments.no_broken else planted(arguments.only)
    with contextlib.redirect_stdout(io.StringIO()):
        faults = controls.faults(lambda control: prove(Library(arguments.library), control, None))
    if faults:
        raise SystemExit("the engine is at fault: " + "; ".join(faults))
    files = (arguments.library, arguments.broken if defects else None, evidence)
    # The slow ones first: none of them is left alone at the end.
    queue = sorted(wanted, key=lambda p: p.function not in SLOW)
    begin(*files)
    # A process for each task, forked off this one: what a solver finds depends on what it was asked before.
    with multiprocessing.get_context("fork").Pool(arguments.jobs, maxtasksperchild=1) as pool:
        proved = {p.id: pool.apply_async(prove_here, (p.id,)) for p in queue}
        refuted = [pool.apply_async(refute_here, defect) for defect in defects]
        results = [proved[p.id].get() for p in wanted]
        if any(result["verdict"] == "refuted" for result in results):
            print("the kernel is refuted: the broken kernels would mean nothing and are left out")
            refuted = []
        refuted = [later.get() for later in refuted]
    report = {
        "name": "machine",
        "version": "angr {}, bitwuzla {}, z3 {}".format(
            *(importlib.metadata.version(name) for name in ("angr", "bitwuzla", "z3-solver"))
        ),
        "results": results,
        "broken": refuted,
        "trusted": TRUSTED,
        "not_proved": NOT_PROVED,
        "library_sha256": loaded_sha256(arguments.library),
        "seconds": round(time.monotonic() - start, 1),
    }
    if arguments.json:
        text = json.dumps(report, indent=2, ensure_ascii=False) + "\n"
        arguments.json.write_text(text, encoding="utf-8")
    good = all(r["verdict"] == "proved" for r in results) and not any("missed" in r for r in refuted)
    print(f"{report['seconds']} s: " + ("all proved and refuted" if good else "NOT all"))
    return 0 if good else 1


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
    """Loads the libraries, which the processes of all tasks inherit."""
    HELD["library"] = Library(library)
    if broken:
        HELD["broken"] = Library(broken)
        HELD["native"] = (native.load(broken), native.load(library))
    HELD["evidence"] = evidence


def prove_here(name):
    wanted = next(p for p in PROPERTIES if p.id == name)
    return prove(HELD["library"], wanted, HELD["evidence"])


def refute_here(defect, wanted):
    return refute(HELD["broken"], *HELD["native"], defect, next(p for p in PROPERTIES if p.id == wanted))


def prove(library, wanted, evidence, prefix="ncp"):
    """Shows one property of one function on each of its paths, and that no path is missing."""
    start = time.monotonic()
    result = {
        "property": wanted.id,
        "family": wanted.family,
        "rules": list(wanted.rules),
        "sentence": wanted.sentence,
        "statement": wanted.formal,
        "bounds": wanted.bounds,
        "assumptions": list(wanted.assumptions),
    }
    try:
        exploration = library.explore(
            f"{prefix}_{wanted.function}", SIGNATURES[wanted.function], wanted.assume
        )
    except Incomplete as error:
        print(f"not run  {wanted.id}: {error}")
        return result | {"verdict": "not run", "detail": str(error), "paths": 0, "seconds": 0}
    resources = SHORT_RESOURCES if SIGNATURES[wanted.function].computes else solver.RESOURCES
    decisions = [
        (name, text, solver.decide(text, resources))
        for name, text in obligations(wanted, exploration)
    ]
    verdicts = {decision.verdict for _, _, decision in decisions}
    if verdicts == {solver.Verdict.UNSAT}:
        outcome = "proved"
    elif solver.Verdict.SAT in verdicts:
        outcome = "refuted"
    else:
        outcome = "not run"
    if evidence:
        for name, text, _ in decisions:
            file = evidence / f"{wanted.id.replace('/', '-')}-{name}.smt2"
            file.write_text(text, encoding="utf-8")
    seconds = round(time.monotonic() - start, 2)
    if outcome == "refuted":
        inputs = shown_model(wanted, exploration, decisions) or {}
        result["counterexample"] = {"function": wanted.function, "inputs": inputs}
        print(inputs)
    print(f"{outcome:8} {wanted.id}: {len(exploration.paths)} paths, {seconds} s", flush=True)
    return result | {
        "verdict": outcome,
        "paths": len(exploration.paths),
        "seconds": seconds,
        "function": f"{prefix}_{wanted.function}",
        "address": hex(exploration.start),
        "instructions": len(exploration.instructions),
        "path_blocks": [[hex(block) for block in path.blocks] for path in exploration.paths],
        "obligations": len(decisions),
        "answers": [
            {
                "obligation": name,
                "sha256": hashlib.sha256(text.encode()).hexdigest(),
                "answers": decision.words,
            }
            for name, text, decision in decisions
        ],
    }


def shown_model(wanted, exploration, decisions):
    """Inputs for which a property does not hold."""
    names = {name: variable.args[0] for name, variable in exploration.inputs.items()}
    text = next(text for _, text, decision in decisions if decision.verdict is solver.Verdict.SAT)
    found = solver.model(text, names)
    return found and native.shown(SIGNATURES[wanted.function], found)


def obligations(wanted, exploration):
    """What must be unsatisfiable: a path that ends wrongly, and an input that takes no path or is no case."""
    inputs, assumed = exploration.inputs, wanted.assume(exploration.inputs)
    cases = wanted.cases(inputs)
    for name, when, said in cases:
        wrong = [ends_wrongly(wanted, inputs | said, path) for path in exploration.paths]
        for first in range(0, len(wrong), GROUP):
            some = claripy.Or(claripy.false(), *wrong[first : first + GROUP])
            yield f"{name}-paths-from-{first}".lstrip("-"), solver.smt([*assumed, when, some])
    if len(cases) > 1:
        whens = [when for _, when, _ in cases]
        yield "no-other-case", solver.smt([*assumed, claripy.Not(claripy.Or(*whens))])
    taken = [claripy.And(claripy.true(), *path.conditions) for path in exploration.paths]
    yield "no-other-path", solver.smt([*assumed, claripy.Not(claripy.Or(*taken, claripy.false()))])


def ends_wrongly(wanted, inputs, path):
    """That the path is taken, and leaves what the property forbids."""
    left = outputs(wanted.function, path.answer, path.memory)
    return claripy.And(*path.conditions, claripy.Not(wanted.conclusion(inputs, left)))


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
        function, signature = wanted.function, SIGNATURES[wanted.function]
        wrong = native.run(broken, f"{prefix(defect)}_{function}", function, signature, found)
        right = native.run(whole, f"ncp_{function}", function, signature, found)
        shown = {
            "function": function,
            "inputs": native.shown(signature, found),
            "broken": native.shown_outputs(function, wrong),
            "kernel": native.shown_outputs(function, right),
        }
        case = vector.case(defect["name"], wanted, found, right, wrong)
        if case:
            shown["vector"] = case
        if not holds(wanted, found, wrong) and holds(wanted, found, right):
            del report["missed"]
            report["counterexample"] = shown
        else:
            report["missed"] = f"its counterexample shows nothing natively: {shown}"
    print(f"{'NOT REFUTED' if 'missed' in report else 'refuted':8} {defect['name']}", flush=True)
    return report


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
    assumed = wanted.assume(exploration.inputs)
    for path in exploration.paths:
        for _, when, said in wanted.cases(exploration.inputs):
            wrong = ends_wrongly(wanted, exploration.inputs | said, path)
            found = solver.model(solver.smt([*assumed, when, wrong]), names)
            if found is not None:
                return found | fixed
    return None


def holds(wanted, inputs, left):
    """Whether a property holds of one native run."""
    bits = {name: claripy.BVV(value, 64) for name, value in inputs.items()}
    words = {name: claripy.BVV(value, 64) for name, value in left.items()}
    wrong = claripy.Or(
        *[
            claripy.And(when, claripy.Not(wanted.conclusion(bits | said, words)))
            for _, when, said in wanted.cases(bits)
        ]
    )
    answer = solver.decide(solver.smt([wrong]))
    return answer.verdict is solver.Verdict.UNSAT


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
    return parser.parse_args()


if __name__ == "__main__":
    sys.exit(main())
