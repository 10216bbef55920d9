"""Tests of what an answer of a solver counts for, and of the choices that are made on a path.

python -m unittest discover proofs/machine
"""

import unittest

import claripy

import choices
import solver
from explore import obligations
from machine import Exploration, Path
from properties import RNE, Property, fp, number
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


class Choices(unittest.TestCase):
    """Of a word that is loaded from one of two places, 1.0 or 2.0, and by which a double is multiplied."""

    def setUp(self):
        is_low = claripy.fpLT(claripy.fpMul(RNE, fp(X), fp(X)), number(4.0))
        self.place = claripy.If(is_low, claripy.BVV(0x10, 64), claripy.BVV(0x18, 64))
        self.scales = {0x10: 1.0, 0x18: 2.0}

    def path(self, places):
        """What is left of a load from these places: the product; and that the place is one of them."""
        word = claripy.BVV(0, 64)
        for place in places:
            word = claripy.If(self.place == place, number(self.scales[place]).raw_to_bv(), word)
        product = claripy.fpMul(RNE, fp(X), fp(word)).raw_to_bv()
        return [claripy.Or(*[self.place == place for place in places])], [product]

    def verdicts(self, paths, conclusion=lambda i, o: claripy.true()):
        """What the solvers make of a claim on these paths, by the name of the obligation."""
        wanted = Property("test", "test", "is_fresh", (), "", "", conclusion)
        explored = Exploration({"x": X}, [Path(conditions, left[0], left, []) for conditions, left in paths])
        return {name: solver.decide(text).verdict for name, text in obligations(wanted, explored)}

    def test_each_place_is_a_path_with_a_constant(self):
        paths = list(choices.made(*self.path([0x10, 0x18])))
        products = {left[0].hash() for _, left in paths}
        self.assertEqual(products, {claripy.fpMul(RNE, fp(X), number(s)).raw_to_bv().hash() for s in (1.0, 2.0)})
        self.assertEqual(self.verdicts(paths)["no-other-path"], Verdict.UNSAT)

    def test_a_lost_place_is_noticed(self):
        # The other condition is false where the place is lost, and the path is none.
        paths = list(choices.made(*self.path([0x10])))
        self.assertEqual(self.verdicts(paths)["no-other-path"], Verdict.SAT)

    def test_a_lost_path_is_noticed(self):
        for kept in choices.made(*self.path([0x10, 0x18])):
            self.assertEqual(self.verdicts([kept])["no-other-path"], Verdict.SAT)

    def test_a_choice_within_the_condition_of_another_is_made_first(self):
        _, [product] = self.path([0x10, 0x18])
        outer = claripy.If(claripy.fpLT(fp(product), number(1.0)), X, product)
        paths = list(choices.made([], [claripy.fpAdd(RNE, fp(outer), number(1.0)).raw_to_bv()]))
        self.assertEqual(len(paths), 4)
        for conditions, left in paths:
            self.assertNotIn("If", {part.op for term in [*conditions, *left] for part in term.children_asts()})
        self.assertEqual(self.verdicts(paths)["no-other-path"], Verdict.UNSAT)

    def test_a_path_without_a_choice_stays_as_it_is(self):
        path = [X == 7], [claripy.If(X == 7, X, X + 1)]
        self.assertEqual(list(choices.made(*path)), [path])


if __name__ == "__main__":
    unittest.main()
