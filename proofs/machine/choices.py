"""A path on which a double is a choice of several, as paths on each of which the choice is made.

A compiler chooses of two constants by their place in a table, or by a mask. What is computed of a choice is more than a
solver decides; what is computed of a constant is what the property says.
"""

import claripy


def made(conditions, left):
    """The paths of which one is taken where this one is: each as its conditions, and what it leaves.

    The condition of a choice is true of one and false of the other, and is put in for what it is. Neither is asked for,
    and neither is left out.
    """
    chooses = _first([*conditions, *left])
    if chooses is None:
        yield conditions, left
        return
    for side, truth in ((chooses, claripy.true()), (claripy.Not(chooses), claripy.false())):
        known = {chooses.hash(): truth}
        told = [_told(part, known) for part in conditions]
        yield from made([*told, side], [_told(part, known) for part in left])


def _first(terms):
    """The condition by which a double is chosen, and in which none is; None where no double is a choice."""
    seen = set()

    def find(term, in_double):
        if not isinstance(term, claripy.ast.Base) or (term.hash(), in_double) in seen:
            return None
        seen.add((term.hash(), in_double))
        in_double = isinstance(term, claripy.ast.FP) or (in_double and isinstance(term, claripy.ast.BV))
        for part in term.args:
            found = find(part, in_double)
            if found is not None:
                return found
        return term.args[0] if in_double and term.op == "If" else None

    for term in terms:
        found = find(term, False)
        if found is not None:
            return found
    return None


def _told(term, known):
    """The term, with what is known put in for its parts."""
    if not isinstance(term, claripy.ast.Base) or term.is_leaf():
        return term
    if term.hash() not in known:
        parts = tuple(_told(part, known) for part in term.args)
        known[term.hash()] = term.make_like(term.op, parts, simplify=True)
    return known[term.hash()]
