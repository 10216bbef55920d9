"""Decides an SMT-LIB 2 file with bitwuzla: one line of answer for each check-sat.

    python proofs/evidence/solve.py FILE [SECONDS [CPU]]

SECONDS are those of the clock for each check-sat (default 60), after which the answer is `unknown`; CPU are those of
the processor for the whole file (default: no limit), after which the program is ended.
"""
import sys

import bitwuzla


def main() -> None:
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    if len(sys.argv) > 3:
        import resource

        resource.setrlimit(resource.RLIMIT_CPU, (int(sys.argv[3]),) * 2)
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.PRODUCE_MODELS, True)
    options.set(bitwuzla.Option.TIME_LIMIT_PER, int(seconds * 1000))
    bitwuzla.Parser(bitwuzla.TermManager(), options).parse(sys.argv[1], parse_only=False)


main()
