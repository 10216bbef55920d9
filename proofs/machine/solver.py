"""What decides an obligation: two solvers, which read one SMT-LIB text.

Their answers are words. Only the word `unsat` counts as a proof, only `sat` as a refutation, and
anything else, in whatever letters, as neither. They are limited by steps, never by the clock: an answer
does not depend on how busy the machine is.
"""

import tempfile
import time
from dataclasses import dataclass, field
from enum import Enum

import bitwuzla
import claripy
import z3

from sabotage import sabotaged

# What z3 may spend on a question, in its own unit: without arithmetic, with it, and at a fork. A million is a
# second or less of a processor.
PLAIN = 20_000_000
EXACT = 200_000
FORK = 200_000
# How often bitwuzla asks whether it is to give up, until it has to.
CALLS = 300_000

# The operations on doubles, by name; all of them round.
OPERATIONS = {
    z3.Z3_OP_FPA_ADD: "add",
    z3.Z3_OP_FPA_SUB: "sub",
    z3.Z3_OP_FPA_MUL: "mul",
    z3.Z3_OP_FPA_DIV: "div",
    z3.Z3_OP_FPA_SQRT: "sqrt",
}
COMMUTES = {"add", "mul"}
# The comparisons, by name, and whether the other way round.
COMPARISONS = {
    z3.Z3_OP_FPA_LT: ("lt", False),
    z3.Z3_OP_FPA_GT: ("lt", True),
    z3.Z3_OP_FPA_LE: ("le", False),
    z3.Z3_OP_FPA_GE: ("le", True),
    z3.Z3_OP_FPA_EQ: ("eq", False),
    z3.Z3_OP_FPA_IS_NAN: ("nan", False),
    z3.Z3_OP_FPA_IS_INF: ("inf", False),
}


class Verdict(Enum):
    """What an answer says."""

    UNSAT = "unsat"
    SAT = "sat"
    UNKNOWN = "unknown"


@dataclass
class Decision:
    """What the solvers made of one question: a word each, all together, and whether arithmetic was needed."""

    words: dict
    verdict: Verdict
    seconds: float
    by_arithmetic: bool = False


def read(word):
    """The verdict of an answer: the very words `unsat` and `sat`, and nothing like them."""
    if word == "unsat" or (word == "sat" and sabotaged("sat-as-unsat")):
        return Verdict.UNSAT
    if word == "sat":
        return Verdict.SAT
    return Verdict.UNSAT if sabotaged("ignore-unknown") else Verdict.UNKNOWN


def together(words):
    """The verdict of several answers: decided by one at least, contradicted by none."""
    verdicts = {read(word) for word in words} - {Verdict.UNKNOWN}
    return verdicts.pop() if len(verdicts) == 1 else Verdict.UNKNOWN


@dataclass
class Writer:
    """Formulas of claripy as formulas of z3 in which no bits of a computed double stand.

    Where these are used, they are any bits which stand for that double: the standard does not say which NaN an
    operation gives. With `plain`, operations on doubles are functions of which nothing is known but that equal
    arguments have equal values, in either order where the operation commutes; what is unsatisfiable then is so
    with arithmetic, too. With `atoms`, nothing is known of comparisons either, but that each is true or false.
    """

    plain: bool
    atoms: bool = False
    known: dict = field(default_factory=dict)
    bits: dict = field(default_factory=dict)
    standing: dict = field(default_factory=dict)

    def write(self, formulas):
        """What has to be asserted for the formulas."""
        terms = [self.term(claripy.backends.z3.convert(formula)) for formula in formulas]
        if sabotaged("contradiction"):
            terms.append(z3.BoolVal(False, claripy.backends.z3._context))
        if self.atoms:
            return terms
        used, free = set(), {}
        for term in terms:
            self._bits_in(term, used, free)
        return terms + [stands for _, stands in sorted(free.items())]

    def _bits_in(self, term, seen, free):
        """The meaning of each variable for bits that a term has."""
        stack = [term]
        while stack:
            node = stack.pop()
            if node.get_id() in seen:
                continue
            seen.add(node.get_id())
            if node.get_id() in self.bits:
                free[node.get_id()] = self.bits[node.get_id()]
                stack.append(free[node.get_id()])
            stack.extend(node.children())

    def term(self, term):
        """The term, written."""
        stack = [(term, False)]
        while stack:
            node, ready = stack.pop()
            key = node.get_id()
            if key in self.known:
                continue
            if not ready:
                stack.append((node, True))
                stack.extend((child, False) for child in node.children())
                continue
            # A node is kept with what it became, so that its number is not given to another one.
            self.known[key] = (node, self._node(node, [self.known[c.get_id()][1] for c in node.children()]))
        return self.known[term.get_id()][1]

    def _node(self, node, children):
        kind = node.decl().kind() if z3.is_app(node) else None
        if kind == z3.Z3_OP_FPA_TO_IEEE_BV:
            return self._free_bits(children[0], node)
        if kind == z3.Z3_OP_FPA_LE and sabotaged("wrong-operator"):
            return children[0] < children[1]
        if self.atoms and kind in COMPARISONS:
            name, is_turned = COMPARISONS[kind]
            numbers = [str(child.get_id()) for child in (reversed(children) if is_turned else children)]
            return z3.Bool(f"{name} {' '.join(numbers)}", node.ctx)
        if self.plain and kind in OPERATIONS and is_to_nearest(children[0]):
            return operation(OPERATIONS[kind], children[1:])
        return node.decl()(*children) if children else node

    def _free_bits(self, double, node):
        """A variable for the bits of a computed double, and what it stands for."""
        if double.get_id() not in self.standing:
            free = z3.BitVec(f"bits_{len(self.standing)}", node.size(), node.ctx)
            self.standing[double.get_id()] = (free, double)
            self.bits[free.get_id()] = z3.fpBVToFP(free, double.sort()) == double
        return self.standing[double.get_id()][0]


def is_to_nearest(mode):
    return mode.decl().kind() == z3.Z3_OP_FPA_RM_NEAREST_TIES_TO_EVEN


def operation(name, arguments):
    """An operation on doubles of which only its arguments are known."""
    if name == "add" and is_square(arguments[1]) and is_plus_zero(arguments[0]):
        return arguments[1]  # A square is never -0.
    if name in COMMUTES:
        arguments = sorted(arguments, key=lambda argument: argument.get_id())
    if sabotaged("wrong-equality"):
        name, arguments = "mul", [arguments[0], arguments[0]]
    sorts = [argument.sort() for argument in arguments]
    return z3.Function(f"double_{name}", *sorts, sorts[0])(*arguments)


def is_plus_zero(term):
    return z3.is_fp_value(term) and term.isZero() and not term.isNegative()


def is_square(term):
    return term.decl().name() == "double_mul" and term.arg(0).eq(term.arg(1))


EXACTLY, PLAINLY, AS_ATOMS = Writer(False), Writer(True), Writer(True, True)


def smt(formulas, writer=EXACTLY):
    """Formulas of claripy as one SMT-LIB 2 text, all of them asserted."""
    asked = z3.Solver(ctx=claripy.backends.z3._context)
    asked.add(*writer.write(formulas))
    logic = "ALL" if writer.plain else "QF_BVFP"
    return f"(set-logic {logic})\n" + asked.to_smt2().split("\n", 1)[1]


def can_be(conditions):
    """Whether conditions can be true together as far as that is seen with each comparison of doubles true or false,
    whatever the others are: False is a proof."""
    asked = z3.SimpleSolver(ctx=claripy.backends.z3._context)
    asked.set("rlimit", FORK)
    asked.add(*AS_ATOMS.write(conditions))
    return read(repr(asked.check())) is not Verdict.UNSAT


def decide(formulas):
    """Asks first what holds whatever the operations on doubles are, and then what is left of it. The texts, too."""
    start = time.monotonic()
    plain = smt(formulas, PLAINLY)
    words = {"z3 plain": ask_z3(plain, PLAIN)}
    if read(words["z3 plain"]) is Verdict.UNSAT:
        return plain, Decision(words, Verdict.UNSAT, time.monotonic() - start)
    exact = smt(formulas)
    answers = {"bitwuzla": ask_bitwuzla(exact), "z3": ask_z3(exact, EXACT)}
    return exact, Decision(words | answers, together(answers.values()), time.monotonic() - start, True)


def decide_text(text):
    """Asks both solvers of a text."""
    start = time.monotonic()
    words = {"bitwuzla": ask_bitwuzla(text), "z3": ask_z3(text, EXACT)}
    return Decision(words, together(words.values()), time.monotonic() - start, True)


def ask_z3(text, limit):
    """The answer of z3, which is the word that it prints, within so much of its resources."""
    try:
        asked = z3.Solver(ctx=z3.Context())
        asked.set("rlimit", 1 if sabotaged("short-limit") else limit)
        asked.from_string(text)
        return repr(asked.check())
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
    if found.word() != "sat":
        return None
    declared = {str(symbol): symbol for symbol in found.parser.get_declared_funs()}
    return {
        name: int(found.solver.get_value(declared[symbol]).value(10)) if symbol in declared else 0
        for name, symbol in names.items()
    }


class Parsed:
    """A text as bitwuzla has read it, which gives up after so many of its own questions whether to."""

    def __init__(self, text, calls, produce_models=False):
        self.left = 1 if sabotaged("short-limit") else calls
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
