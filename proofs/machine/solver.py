"""What decides an obligation: two solvers, which read one SMT-LIB text.

Their answers are words. Only the word `unsat` counts as a proof, only `sat` as a refutation, and
anything else, in whatever letters, as neither. They are limited by steps, and not by the clock: an answer
does not depend on how busy the machine is.
"""

import tempfile
import time
from dataclasses import dataclass
from enum import Enum

import bitwuzla
import claripy
import z3

# What z3 may spend on a question, in its own unit, and how often bitwuzla asks whether it is to give up until it has
# to.
RESOURCES = 20_000_000
CALLS = 3_000_000


class Verdict(Enum):
    """What an answer says."""

    UNSAT = "unsat"
    SAT = "sat"
    UNKNOWN = "unknown"


@dataclass
class Decision:
    """What the solvers made of one text: a word each, and both together."""

    words: dict
    verdict: Verdict
    seconds: float


def read(word):
    """The verdict of an answer: the very words `unsat` and `sat`, and nothing like them."""
    if word == "unsat":
        return Verdict.UNSAT
    if word == "sat":
        return Verdict.SAT
    return Verdict.UNKNOWN


def together(words):
    """The verdict of several answers: decided by one at least, contradicted by none."""
    verdicts = {read(word) for word in words} - {Verdict.UNKNOWN}
    return verdicts.pop() if len(verdicts) == 1 else Verdict.UNKNOWN


def smt(formulas):
    """Formulas of claripy as one SMT-LIB 2 text, all of them asserted.

    Where the bits of a computed double are used, they are any bits which stand for that double: the
    standard does not say which NaN an operation gives.
    """
    solver = z3.Solver(ctx=claripy.backends.z3._context)
    bits = {}
    for formula in formulas:
        solver.add(with_free_bits(claripy.backends.z3.convert(formula), bits))
    for free, double in bits.values():
        solver.add(z3.fpBVToFP(free, double.sort()) == double)
    return "(set-logic QF_BVFP)\n" + solver.to_smt2().split("\n", 1)[1]


def with_free_bits(term, bits):
    """The term with a variable for each reading of the bits of a computed double."""
    known = {}
    stack = [(term, False)]
    while stack:
        node, ready = stack.pop()
        key = node.get_id()
        if key in known:
            continue
        if not ready:
            stack.append((node, True))
            stack.extend((child, False) for child in node.children())
            continue
        children = [known[child.get_id()] for child in node.children()]
        new = node.decl()(*children) if children else node
        if z3.is_app_of(node, z3.Z3_OP_FPA_TO_IEEE_BV):
            double = children[0]
            if double.get_id() not in bits:
                free = z3.BitVec(f"bits_{len(bits)}", new.size(), new.ctx)
                bits[double.get_id()] = (free, double)
            new = bits[double.get_id()][0]
        known[key] = new
    return known[term.get_id()]


def decide(text, resources=RESOURCES):
    """Asks both solvers."""
    start = time.monotonic()
    words = {"bitwuzla": ask_bitwuzla(text), "z3": ask_z3(text, resources)}
    return Decision(words, together(words.values()), time.monotonic() - start)


def ask_z3(text, resources=RESOURCES):
    """The answer of z3, which is the word that it prints."""
    try:
        solver = z3.Solver(ctx=z3.Context())
        solver.set("rlimit", resources)
        solver.from_string(text)
        return repr(solver.check())
    except z3.Z3Exception as error:
        return f"error: {error}"


def ask_bitwuzla(text, calls=CALLS):
    """The answer of bitwuzla, which is the word that it prints."""
    try:
        return Parsed(text, calls).word()
    except Exception as error:  # The bindings raise plain exceptions.
        return f"error: {error}"


def model(text, names, calls=CALLS):
    """The bits of some variables in a model of the text, by bitwuzla; None when there is none.

    A variable that the text does not mention is 0.
    """
    found = Parsed(text, calls, produce_models=True)
    if read(found.word()) is not Verdict.SAT:
        return None
    declared = {str(symbol): symbol for symbol in found.parser.get_declared_funs()}
    return {
        name: int(found.solver.get_value(declared[symbol]).value(10)) if symbol in declared else 0
        for name, symbol in names.items()
    }


class Parsed:
    """A text as bitwuzla has read it, which gives up after so many of its own questions whether to."""

    def __init__(self, text, calls, produce_models=False):
        self.left = calls
        self.options = bitwuzla.Options()
        self.options.set(bitwuzla.Option.PRODUCE_MODELS, produce_models)
        # The parser does not keep what it needs alive.
        self.terms = bitwuzla.TermManager()
        with tempfile.NamedTemporaryFile("w", suffix=".smt2") as file:
            file.write(text.replace("(check-sat)", ""))
            file.flush()
            self.parser = bitwuzla.Parser(self.terms, self.options)
            self.parser.parse(file.name)
        self.solver = self.parser.bitwuzla()
        self.solver.configure_terminator(self._is_enough)

    def word(self):
        """Whether it can be satisfied."""
        return str(self.solver.check_sat())

    def _is_enough(self):
        self.left -= 1
        return self.left < 0
