"""Decides an SMT-LIB 2 file with bitwuzla: one line of answer for each check-sat.

    python proofs/solve.py FILE [SECONDS]     # seconds for each check-sat, default 60
"""
import sys

import bitwuzla


def main() -> None:
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.PRODUCE_MODELS, True)
    options.set(bitwuzla.Option.TIME_LIMIT_PER, int(seconds * 1000))
    bitwuzla.Parser(bitwuzla.TermManager(), options).parse(sys.argv[1], parse_only=False)


main()
