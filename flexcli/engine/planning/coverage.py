"""What each model declares: the effects that it carries, its cost, what it borrows."""

from typing import NamedTuple

__all__ = ["COARSE", "COVERAGE", "FINE", "OUTER", "Coverage"]


class Coverage(NamedTuple):
    """The effects a model ``can`` carry or leave out, and those that it ``always`` carries.

    What it does not carry, its answers to ``borrowed`` included, is corrected on top or left out.
    ``cost`` is declared in closed forms, with all that is printed of a design.
    """

    can: frozenset[str]
    always: frozenset[str]
    cost: float
    borrowed: tuple[str, ...] = ()


COVERAGE = {
    "closed-form": Coverage(frozenset(), frozenset(), 1.0),
    "linear": Coverage(
        frozenset({"shear", "axial extension"}),
        frozenset({"blade tension", "hinge length"}),
        20.0,
        ("shift",),
    ),
    "exact": Coverage(
        frozenset({"shear", "axial extension"}),
        frozenset({"large rotation", "axial load", "blade tension", "hinge length"}),
        40.0,
    ),
}
"""From the cheapest to the finest; the exact one's cost is at its coarsest tolerance."""

OUTER = frozenset({"plate widening", "anticlastic", "clamp stress", "blade mass"})
"""What no model of beams has inside, so that a correction on top carries it in all of them."""

COARSE, FINE = 1e-6, 1e-12
"""Tolerances between which the exact model is asked to work."""
