"""End conditions of a case: of the body that the joint moves, and of its blades' ends."""

from typing import Final, Literal, NamedTuple

__all__ = ["ENDS", "FREE", "EndCondition", "Hold"]

EndCondition = Literal[
    "clamped-clamped", "clamped-pinned", "clamped-guided", "pinned-pinned", "clamped-free"
]
"""What holds the two ends of a blade, and so which buckling load is meant."""

FREE: Final = "clamped-free"
"""The ends of a body that nothing but its blades holds."""


class Hold(NamedTuple):
    """Whether the moving body is kept from moving across the force, and from turning.

    Along the force it is always free. ``hinged`` blades turn at both their ends, where they are
    otherwise clamped in the base and in the body.
    """

    across: bool
    turn: bool
    hinged: bool = False

    @property
    def spoken(self) -> str:
        """Return what holds, in words about the body."""
        if self.hinged:
            return "blades hinged at both ends, the body neither turns nor moves across the force"
        return {
            (True, True): "the body neither turns nor moves across the force",
            (False, True): "the body does not turn",
            (True, False): "the body turns about its point but does not move across the force",
            (False, False): "the body is free in the plane",
        }[self.across, self.turn]


ENDS: dict[str, Hold] = {
    "clamped-clamped": Hold(across=True, turn=True),
    "clamped-guided": Hold(across=False, turn=True),
    "clamped-pinned": Hold(across=True, turn=False),
    FREE: Hold(across=False, turn=False),
    "pinned-pinned": Hold(across=True, turn=True, hinged=True),
}
"""The names of a column's ends, for the joint: its base is fixed, its body held as they say.

Of a single blade they are Euler's cases. The body turns about its own point: the centre of a
pivot, the tip of a single blade, half the height of a stage's blades.
"""
