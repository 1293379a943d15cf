"""A planar mechanism as one in space: its plane is z = 0, its blades are as wide as they are."""

from flexcli.mechanics.layout import Layout
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceSpring,
)

__all__ = ["from_plane"]


def from_plane(layout: Layout, moving: str, *, turns: bool, density: float = 0.0) -> SpaceLayout:
    """Return a planar layout of one design in space.

    Parameters
    ----------
    layout : Layout
        The mechanism; it has a shear modulus.
    moving : str
        The body that the stroke moves: about z at its point, or along y.
    turns : bool
        Whether it turns.
    density : float
        Of the blades [kg/m³].

    Returns
    -------
    SpaceLayout
        The same bodies, blades and springs; what the plane does not say of a body's inertia is
        none.

    """
    assert layout.G is not None  # the caller has asked for it
    E, G = float(layout.E), float(layout.G)
    none = (0.0, 0.0, 0.0)
    bodies = tuple(
        SpaceBody(
            body.name,
            (float(body.point[0]), float(body.point[1]), 0.0),
            (float(body.com[0]), float(body.com[1]), 0.0),
            float(body.mass),
            (none, none, (0.0, 0.0, float(body.inertia))),
        )
        for body in layout.bodies
    )
    blades = tuple(
        SpaceBlade(
            blade.name,
            blade.first,
            blade.second,
            (float(blade.start[0]), float(blade.start[1]), float(blade.z)),
            (float(blade.end[0]), float(blade.end[1]), float(blade.z)),
            (0.0, 0.0, 1.0),
            blade.profile,
            float(blade.b),
            Isotropic(E * float(blade.stiffer), G * float(blade.stiffer), density),
            blade.peak,
            crossed=(float(blade.crossed[0]), float(blade.crossed[1])),
            shared=(float(blade.shared[0]), float(blade.shared[1])),
        )
        for blade in layout.blades
    )
    springs = tuple(
        SpaceSpring(
            support.body,
            (float(support.point[0]), float(support.point[1]), 0.0),
            (float(support.stiffness[0]), float(support.stiffness[1]), 0.0, 0.0, 0.0,
             float(support.stiffness[2])),
        )
        for support in layout.supports
    )  # fmt: skip
    x, y = layout.body(moving).point
    along = (0.0, 0.0, 1.0) if turns else (0.0, 1.0, 0.0)
    drive = Drive(moving, turns, along, (float(x), float(y), 0.0))
    return SpaceLayout(bodies, blades, drive, springs)
