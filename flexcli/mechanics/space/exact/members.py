"""What the balance of bodies takes of the blades between them, whatever they are made of.

A blade stands in the frame of its start, in its own units: lengths by its length l, forces by
EI/l², moments by EI/l. What is inside it is known to itself alone.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.layout import BeamEffects, SpaceLayout

__all__ = ["FIRST_GUESS", "EndMotions", "Members", "MembersOf", "Variation"]

Floats = NDArray[np.float64]


FIRST_GUESS = 0
"""Level whose solution is but a start for the next: what it is off by tells nothing of that."""


class EndMotions(NamedTuple):
    """Blades after what is inside them is eliminated from the linearised equations.

    ``motion`` (blades, 3) is r(1) − e_x and ``turn`` (blades, 4) the rotation of the end, once the
    inside has followed; ``F`` (blades, 6, 6) takes (δn, δm) to δr(1) and the spin of the end. The
    inside changes by ``free + follow(δ(n, m))``, forces as rows of blades.
    """

    motion: Floats
    turn: Floats
    F: Floats
    free: Floats
    follow: Callable[[Floats], Floats]


class Variation(NamedTuple):
    """Second variation of the blades' energy by (δn, closing moments, turn of the start).

    ``matrix`` (blades, 9, 9): forces along the axes of the start, closing moments along those of
    the end. ``unstable`` counts the negative directions with ends free at constant end forces.
    """

    matrix: Floats
    unstable: int


class Members(Protocol):
    """The blades of a layout at one level of fineness; z is one row of what is inside them."""

    @property
    def level(self) -> int:
        """Return the level: nodes, or modes."""

    @property
    def bending(self) -> Floats:
        """Return E I of bending across the thickness [N·m²] (blades,)."""

    @property
    def lengths(self) -> Floats:
        """Return the lengths [m] (blades,)."""

    @property
    def stretch(self) -> float:
        """Return the stretch of the stiffest under a force of EI/l² [-]."""

    def rest(self) -> Floats:
        """Return what is inside blades at rest."""

    def unit(self, z: Floats) -> Floats:
        """Return z with all rotations of unit length."""

    def weight(self) -> Floats:
        """Return the weights of z in an arc length: of a mean, or of ends."""

    def condense(self, z: Floats, f: Floats) -> EndMotions:
        """Return end motions about z, under forces and end moments f (blades, 6)."""

    def variation(self, z: Floats, f: Floats) -> Variation:
        """Return the second variation of an equilibrium z under f."""

    def grown(self, strains: Floats) -> "Members":
        """Return the same blades with free strains (blades, 1) that a temperature gives them."""

    def at_level(self, level: int) -> "Members":
        """Return the same blades at another level."""

    def finer(self, fine: Any, z: Floats) -> Floats:
        """Return rows of z at the level of the same blades ``fine``."""


MembersOf: TypeAlias = Callable[[SpaceLayout, BeamEffects, int], Members]
"""Makes the blades of a layout at a level; beams take part with what the effects say."""
