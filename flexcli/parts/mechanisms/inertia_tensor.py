"""Moments of inertia of a body as a spec writes them."""

from typing import ClassVar

from flexcli.parts.base import Inertia, Shorthand

__all__ = ["InertiaTensor"]


class InertiaTensor(Shorthand):
    """Moments of inertia about the body's own centre of mass; a plain value stands for zz."""

    stands_for: ClassVar[str] = "zz"

    xx: Inertia | None = None
    """Moment of inertia around x, e.g. ``xx: 3e-6 kg*m^2, zz: 5.4e-6 kg*m^2``."""
    yy: Inertia | None = None
    """Moment of inertia around y, e.g. ``yy: 3e-6 kg*m^2, zz: 5.4e-6 kg*m^2``."""
    zz: Inertia
    """Moment of inertia around z, the axis of the pivots, e.g. ``5.4e-6 kg*m^2``."""
