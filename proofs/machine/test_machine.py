"""Tests of what an answer of a solver counts for, of what is written for it, and of the engine's own checks.

python -m unittest discover proofs/machine
"""

import unittest

import claripy

import controls
import explore
import sabotage
import solver
from properties import PROPERTIES, SIGNATURES, is_double
from solver import Verdict, read, together

X = claripy.BVS("x", 64)


class Answers(unittest.TestCase):
    def test_only_the_word_unsat_is_a_proof(self):
        self.assertIs(read("unsat"), Verdict.UNSAT)
        self.assertIs(read("sat"), Verdict.SAT)
        for word in (
            "UNSAT", "Unsat", "unsat ", " unsat", "unsat\n", "unsat\nerror", "unknown", "", "SAT",
            "timeout", "error: unsat", None, True, "unsatisfiable", "un sat",
        ):  # fmt: skip
            self.assertIs(read(word), Verdict.UNKNOWN, repr(word))

    def test_one_answer_decides_and_a_contradiction_does_not(self):
        self.assertIs(together(["unsat", "unknown"]), Verdict.UNSAT)
        self.assertIs(together(["sat", "error: no"]), Verdict.SAT)
        self.assertIs(together(["unsat", "sat"]), Verdict.UNKNOWN)
        self.assertIs(together(["unknown", "UNSAT"]), Verdict.UNKNOWN)
        self.assertIs(together([]), Verdict.UNKNOWN)

    def test_both_solvers_say_the_words(self):
        for formula, word in ((X == 7, "sat"), (claripy.And(X == 7, X == 8), "unsat")):
            text = solver.smt([formula])
            self.assertEqual(solver.ask_z3(text, solver.PLAIN), word)
            self.assertEqual(solver.ask_bitwuzla(text), word)

    def test_a_text_that_is_none_is_no_proof(self):
        for text in ("(assert false", "(assert (foo))\n(check-sat)\n", "unsat"):
            self.assertIs(solver.decide_text(text).verdict, Verdict.UNKNOWN, text)

    def test_a_solver_that_runs_out_of_steps_proves_nothing(self):
        text = solver.smt(controls.LONG)
        self.assertIs(read(solver.ask_z3(text, controls.SHORT_RESOURCES)), Verdict.UNKNOWN)
        self.assertIs(read(solver.ask_bitwuzla(text, controls.SHORT_CALLS)), Verdict.UNKNOWN)

    def test_an_answer_takes_the_same_steps_each_time(self):
        text = solver.smt([claripy.fpEQ(claripy.fpSqrt(controls.RNE, controls.A), controls.number(2.0))])
        left = []
        for _ in range(2):
            asked = solver.Parsed(text, solver.CALLS)
            left.append((asked.word(), asked.left))
        self.assertEqual(left[0], left[1])

    def test_the_bits_of_a_computed_nan_are_any(self):
        sum_of = claripy.fpAdd(controls.RNE, X.raw_to_fp(), X.raw_to_fp())
        is_nan = claripy.fpIsNaN(sum_of)
        for sign in (0, 1):
            text = solver.smt([is_nan, sum_of.raw_to_bv()[63:63] == sign])
            self.assertIs(solver.decide_text(text).verdict, Verdict.SAT)


class Writing(unittest.TestCase):
    def test_each_operation_and_comparison_is_written_as_it_is(self):
        for name, (formulas, is_possible) in controls.WRITTEN.items():
            word = solver.ask_z3(solver.smt(formulas), solver.PLAIN)
            self.assertEqual(word, "sat" if is_possible else "unsat", name)

    def test_without_arithmetic_only_what_holds_of_any_operation_is_shown(self):
        for name, (formula, is_possible) in controls.PLAIN.items():
            word = solver.ask_z3(solver.smt([formula], solver.PLAINLY), solver.PLAIN)
            self.assertEqual(word, "sat" if is_possible else "unsat", name)

    def test_a_fork_is_given_up_only_where_no_comparison_helps(self):
        less, more = claripy.fpLT(controls.A, controls.B), claripy.fpGT(controls.B, controls.A)
        self.assertFalse(solver.can_be([less, claripy.Not(more)]))
        # So that it is no question of arithmetic, this is left open although it cannot be.
        self.assertTrue(solver.can_be([less, claripy.fpLT(controls.B, controls.A)]))


class Engine(unittest.TestCase):
    def test_another_number_of_paths_is_a_fault(self):
        part = {"part": "within_deadline", "paths": 4}
        self.assertEqual(len(explore.pinned([part], False)), 1)
        self.assertEqual(len(explore.pinned([{"part": "nothing", "paths": 1}], False)), 1)

    def test_parts_prove_only_together(self):
        wanted = PROPERTIES[0]
        proved = {"property": wanted.id, "verdict": "proved", "is_possible": True, "paths": 1}
        open_one = proved | {"verdict": "not run", "detail": "not decided"}
        vacuous = proved | {"is_possible": False}
        self.assertEqual(explore.joined(wanted, [proved, proved])["verdict"], "proved")
        self.assertEqual(explore.joined(wanted, [proved, vacuous])["verdict"], "proved")
        self.assertEqual(explore.joined(wanted, [proved, open_one])["verdict"], "not run")
        self.assertEqual(explore.joined(wanted, [vacuous])["verdict"], "not run")
        self.assertEqual(explore.joined(wanted, [proved, proved | {"verdict": "refuted"}])["verdict"], "refuted")

    def test_no_part_proves_nothing(self):
        self.assertEqual(explore.joined(PROPERTIES[0], [])["verdict"], "not run")

    def test_no_sabotage_is_set_by_itself(self):
        self.assertFalse(any(sabotage.sabotaged(name) for name in sabotage.SABOTAGES))

    def test_broken_kernels_are_told_apart_by_defect_and_property(self):
        planted = [(defect["name"], wanted.id) for defect, wanted in explore.planted("")]
        self.assertEqual(len(planted), len(set(planted)))

    def test_each_function_is_asked_by_a_property_and_each_part_has_a_name(self):
        self.assertEqual({wanted.function for wanted in PROPERTIES}, SIGNATURES.keys())
        for function, signature in SIGNATURES.items():
            names = [name for name, _, _ in signature.slices]
            self.assertEqual(len(names), len(set(names)), function)

    def test_words_and_doubles_are_told_apart(self):
        self.assertTrue(all(map(is_double, ("now_s", "ttl_ms_after", "x_after0", "u3", "bound2", "w_before0"))))
        self.assertFalse(any(map(is_double, ("has0", "says1", "steps_after", "stopped", "kind3", "width1"))))


if __name__ == "__main__":
    unittest.main()
