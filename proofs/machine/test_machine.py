"""Tests of what an answer of a solver counts for, and of what an exploration refuses.

python -m unittest discover proofs/machine
"""

import unittest

import claripy

import solver
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
            self.assertEqual(solver.ask_z3(text), word)
            self.assertEqual(solver.ask_bitwuzla(text), word)

    def test_a_text_that_is_none_is_no_proof(self):
        for text in ("(assert false", "(assert (foo))\n(check-sat)\n", "unsat"):
            self.assertIs(solver.decide(text).verdict, Verdict.UNKNOWN, text)

    def test_a_solver_that_runs_out_of_steps_proves_nothing(self):
        root = claripy.fpSqrt(claripy.fp.RM.RM_NearestTiesEven, X.raw_to_fp())
        text = solver.smt([claripy.fpEQ(claripy.fpMul(claripy.fp.RM.RM_NearestTiesEven, root, root), claripy.FPV(2.0, claripy.FSORT_DOUBLE))])
        self.assertIs(read(solver.ask_z3(text, 1)), Verdict.UNKNOWN)

    def test_the_bits_of_a_computed_nan_are_any(self):
        sum_of = claripy.fpAdd(claripy.fp.RM.RM_NearestTiesEven, X.raw_to_fp(), X.raw_to_fp())
        is_nan = claripy.fpIsNaN(sum_of)
        for sign in (0, 1):
            text = solver.smt([is_nan, sum_of.raw_to_bv()[63:63] == sign])
            self.assertIs(solver.decide(text).verdict, Verdict.SAT)


if __name__ == "__main__":
    unittest.main()
