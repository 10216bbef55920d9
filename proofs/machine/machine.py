"""Paths through machine code, by angr: all of them, and nothing but that code."""

import logging
from dataclasses import dataclass, field

# angr complains while it is loaded, of an accelerator that nothing here uses.
for noisy in ("angr", "angr.state_plugins.unicorn_engine", "cle", "pyvex", "claripy"):
    logging.getLogger(noisy).setLevel(logging.CRITICAL)

import angr  # noqa: E402
import claripy  # noqa: E402
from angr import sim_options  # noqa: E402
from angr.state_plugins.solver import SimSolver  # noqa: E402

import choices  # noqa: E402
import solver  # noqa: E402

# Where the functions write, and how much.
OUT = 0x10_000_000
OUT_BYTES = 256
STACK = 0x20_000_000
MAX_STEPS = 4_096
# So many steps may bitwuzla take for the question whether a path can be taken where doubles are computed. A path of
# which it stays open is followed: if no input takes it, nothing that it leaves is wrong.
OPEN_CALLS = 2_000

# Whatever would let angr go on where it does not know.
BYPASSES = {
    sim_options.LAZY_SOLVES,
    sim_options.BYPASS_UNSUPPORTED_IROP,
    sim_options.BYPASS_UNSUPPORTED_IREXPR,
    sim_options.BYPASS_UNSUPPORTED_IRSTMT,
    sim_options.BYPASS_UNSUPPORTED_IRDIRTY,
    sim_options.BYPASS_UNSUPPORTED_IRCCALL,
    sim_options.BYPASS_ERRORED_IROP,
    sim_options.BYPASS_ERRORED_IRCCALL,
    sim_options.BYPASS_ERRORED_IRSTMT,
    sim_options.BYPASS_UNSUPPORTED_SYSCALL,
    sim_options.BYPASS_VERITESTING_EXCEPTIONS,
    sim_options.UNSUPPORTED_BYPASS_ZERO_DEFAULT,
    sim_options.UNSUPPORTED_FORCE_CONCRETIZE,
    sim_options.APPROXIMATE_SATISFIABILITY,
    sim_options.APPROXIMATE_GUARDS,
    sim_options.APPROXIMATE_MEMORY_INDICES,
    sim_options.APPROXIMATE_MEMORY_SIZES,
    sim_options.CONSERVATIVE_READ_STRATEGY,
    sim_options.CONSERVATIVE_WRITE_STRATEGY,
    sim_options.AVOID_MULTIVALUED_READS,
    sim_options.AVOID_MULTIVALUED_WRITES,
    sim_options.KEEP_IP_SYMBOLIC,
    sim_options.NO_SYMBOLIC_JUMP_RESOLUTION,
    sim_options.ZERO_FILL_UNCONSTRAINED_MEMORY,
    sim_options.ZERO_FILL_UNCONSTRAINED_REGISTERS,
    sim_options.CONCRETIZE,
    sim_options.CONCRETIZE_SYMBOLIC_FILE_READ_SIZES,
    sim_options.CONCRETIZE_SYMBOLIC_WRITE_SIZES,
}
# Notes that nothing here reads.
NOTES = sim_options.refs | {sim_options.TRACK_CONSTRAINT_ACTIONS}


class Forks(SimSolver):
    """Says by bitwuzla whether a path can be taken, for paths that depend on roots and quotients; what it
    leaves open can be.

    A path that were dropped wrongly would be missed by the obligation that no input takes another.
    """

    def satisfiable(self, extra_constraints=(), exact=None):
        conditions = [*self.constraints, *extra_constraints]
        word = solver.ask_bitwuzla(solver.smt(conditions), OPEN_CALLS)
        return solver.read(word) is not solver.Verdict.UNSAT


class Incomplete(Exception):
    """Not every path was followed to its end."""


@dataclass
class Path:
    """One way through a function: under which conditions, and what it leaves."""

    conditions: list
    answer: object
    memory: list
    blocks: list


@dataclass
class Exploration:
    """All ways through a function."""

    inputs: dict
    paths: list
    instructions: set = field(default_factory=set)
    start: int = 0


class Library:
    """A library whose functions can be explored."""

    def __init__(self, file):
        self.file = file
        self.project = angr.Project(str(file), auto_load_libs=False)
        self.code = self.project.loader.main_object
        self.base = self.code.mapped_base

    def explore(self, symbol, signature, assume=lambda inputs: [], fixed=None):
        """All paths of a function whose inputs are any bits that `assume` leaves, or are fixed."""
        entry = self.code.get_symbol(symbol)
        if entry is None:
            raise Incomplete(f"there is no function {symbol}")
        inputs = {name: claripy.BVS(name, 64) for name in signature.words + signature.doubles}
        inputs |= {name: claripy.BVV(bits, 64) for name, bits in (fixed or {}).items()}
        state = self.project.factory.blank_state(addr=entry.rebased_addr, remove_options=BYPASSES | NOTES)
        left = {option for option in BYPASSES if option in state.options}
        if left:
            raise Incomplete(f"bypass options are on: {left}")
        if signature.computes:
            state.register_plugin("solver", Forks())
        self._call(state, signature, inputs)
        for condition in assume(inputs):
            state.add_constraints(condition)
        decide = _concretizes(self.code)
        state.inspect.b("address_concretization", when=angr.BP_BEFORE, action=decide)

        exploration = Exploration(inputs, [], start=entry.rebased_addr - self.base)
        manager = self.project.factory.simulation_manager(state, save_unsat=False)
        for _ in range(MAX_STEPS):
            if not manager.active:
                break
            for active in manager.active:
                self._check_place(active, exploration)
            manager.step()
        self._check_end(manager)
        for ended in manager.deadended:
            words = range(OUT_BYTES // 8)
            left = [ended.regs.rax, *(ended.memory.load(OUT + 8 * word, 8, endness="Iend_LE") for word in words)]
            blocks = [address - self.base for address in ended.history.bbl_addrs][:-1]
            conditions = list(ended.solver.constraints)
            paths = choices.made(conditions, left) if signature.computes else [(conditions, left)]
            exploration.paths.extend(Path(taken, answer, memory, blocks) for taken, (answer, *memory) in paths)
        return exploration

    def _call(self, state, signature, inputs):
        """The registers and the stack of a call by the System V convention."""
        registers = ["rdi", "rsi", "rdx", "rcx", "r8", "r9"]
        if signature.writes:
            setattr(state.regs, registers.pop(0), claripy.BVV(OUT, 64))
        for name, register in zip(signature.words, registers, strict=False):
            setattr(state.regs, register, inputs[name])
        for number, name in enumerate(signature.doubles[:8]):
            above = claripy.BVS(f"above_{name}", 64)
            setattr(state.regs, f"xmm{number}", claripy.Concat(above, inputs[name]))
        state.regs.rsp = claripy.BVV(STACK, 64)
        state.memory.store(STACK, claripy.BVV(self._return(), 64), endness="Iend_LE")
        for number, name in enumerate(signature.doubles[8:]):
            state.memory.store(STACK + 8 + 8 * number, inputs[name], endness="Iend_LE")

    def _return(self):
        return self.project.simos.return_deadend

    def _check_place(self, state, exploration):
        """A state stands in the library's own code, or has returned."""
        address = state.addr
        if address == self._return():
            return
        section = self.code.find_section_containing(address)
        if section is None or section.name != ".text" or self.project.is_hooked(address):
            raise Incomplete(f"a path leaves the code for {address:#x}")
        block = self.project.factory.block(address)
        exploration.instructions.update(a - self.base for a in block.instruction_addrs)

    def _check_end(self, manager):
        """No state was given up."""
        if manager.active:
            raise Incomplete(f"{len(manager.active)} paths have no end after {MAX_STEPS} blocks")
        if manager.errored:
            raise Incomplete(f"a path failed: {manager.errored[0].error}")
        for stash, states in manager.stashes.items():
            if states and stash not in ("active", "deadended"):
                raise Incomplete(f"{len(states)} paths are {stash}")
        if not manager.deadended:
            raise Incomplete("no path ends")
        for state in manager.deadended:
            if state.addr != self._return():
                raise Incomplete(f"a path ends at {state.addr:#x}")


def _concretizes(library):
    """What becomes of an address that depends on an input: it is refused, but for a load from a table of constants."""

    def decide(state):
        address = state.inspect.address_concretization_expr
        if address is None or not state.solver.symbolic(address):
            return
        places = _leaves(claripy.excavate_ite(address))
        sections = [library.find_section_containing(place) for place in places or [0]]
        is_table = all(section is not None and not section.is_writable for section in sections)
        if state.inspect.address_concretization_action != "load" or not is_table:
            raise Incomplete(f"an address depends on an input: {address}")
        state.inspect.address_concretization_strategy = Table(sorted(places))

    return decide


class Table(angr.concretization_strategies.SimConcretizationStrategy):
    """All places of a table of constants, from which a condition chooses: the compiler's way to choose of two doubles.

    The address is a choice of these by its form, so that no solver is asked, and no other can come of it. What is read
    is a choice, too, of which `choices` makes paths.
    """

    def __init__(self, places):
        super().__init__()
        self.places = places

    def _concretize(self, memory, addr, **kwargs):
        return self.places


def _leaves(address):
    """The numbers of which an expression is one by its form, whatever its conditions are; none where it may be another."""
    if address.op == "If":
        parts = [_leaves(part) for part in address.args[1:]]
        return None if None in parts else set().union(*parts)
    return {address.concrete_value} if address.concrete else None
