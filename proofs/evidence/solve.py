"""Decides an SMT-LIB 2 file with bitwuzla: one line of answer for each check-sat.

    python proofs/evidence/solve.py FILE [STEPS [ALL]]

STEPS limit one question, and ALL the file (default: no limit). A step is a place of its search at which the solver
asks whether to go on: the same places in every run and on every machine, whatever else that does. A question that
takes more is answered with `unknown`.
"""
import sys

import bitwuzla

QUESTION = "(push 1)"


class Steps:
    """Counts the steps, and ends a question at its limit."""

    def __init__(self, each: float, whole: float) -> None:
        self.each, self.whole = each, whole
        self.begin(float("inf"))

    def begin(self, most: float) -> None:
        self.most, self.count, self.is_over = most, 0, False

    def __call__(self) -> bool:
        self.count += 1
        self.is_over |= self.count > self.most
        return self.is_over


def main() -> None:
    limits = [float(word) for word in sys.argv[2:]] + [float("inf")] * 2
    steps = Steps(limits[0], limits[1])
    with open(sys.argv[1], encoding="utf-8") as file:
        head, *questions = file.read().split(QUESTION)
    parser = begin(head, steps)
    for question in questions:
        # Reading a command takes a step, too.
        read = question.count("(assert") + 3
        steps.begin(read + max(0, min(steps.each, steps.whole)))
        parser.parse(QUESTION + question, parse_only=False, parse_file=False)
        steps.whole -= steps.count
        if steps.is_over:
            # A parser that was ended does not go on.
            parser = begin(head, steps)


def begin(head: str, steps: Steps) -> bitwuzla.Parser:
    """A parser that knows the terms of the file; these have no limit."""
    steps.begin(float("inf"))
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.PRODUCE_MODELS, True)
    parser = bitwuzla.Parser(bitwuzla.TermManager(), options)
    parser.configure_terminator(steps)
    parser.parse(head, parse_only=False, parse_file=False)
    return parser


main()
