"""Axes of the joints, drawn in text: what x, y, z and the signs of a spec mean."""

__all__ = ["AXES"]

_PIVOT = r"""
      y                      z comes out of the plane: the axis of rotation,
      |   / blade            and the direction of the width b
      |  /
      | / half_angle         x is the bisector of the blades, through the
      O-------- x            centre O; a load of direction 0 deg pulls along it
        \                    p is from O to the near end of each blade,
          \ blade            l the length of a blade, h its thickness
"""

_STAGE = r"""
        x, stroke            the base is below, the stage above; z comes out of
     ------>                 the plane, and the width b is along it
   ==============  stage
    |          |             y is along the blades, from the base to the stage:
    | l        |  blades     a load of direction 0 deg pulls along it
    |          |
   ##############  base      spacing is from blade to blade
"""

_BLADE = r"""
   x, stroke                 the blade is clamped in the base; its tip moves
   --->                      along x and turns about z, out of the plane
   o  tip
   |                         y is along the blade: a load of direction 0 deg
   | l                       pulls along it, away from the base
   |                         h is along x, the width b along z
   ###  base
"""

_TURNED_BLADE = r"""
      y                      the blade is clamped in the base; its tip turns
      |                      about z, out of the plane; h is along y, b along z
   ###|                      x is along the blade: a load of direction 0 deg
   ###====O====o-----> x     pulls along it
   ### <--l--> tip           loads act at the middle O of the blade, where a
   base                      payload has its centre of mass
"""

_TORSION = r"""
   ###====== bar ======[ body ]      z is the axis of the bar, about which the
   base       l          ) turns     body turns; x and y are across it
"""

_HINGE = r"""
   base  ######\   /######  body     z comes out of the plane: the axis of the
                ) (  e               rotation, along which the width b is
         ######/   \######           x is along the hinge, e or h is across it
"""

_DRAWN = r"""
      y                      x and y are those of your drawing, with any origin
      |                      z comes out of the plane, the width b is along it
      O----- x               directions are angles from x, turning towards y
"""

_IN_SPACE = r"""
      z
      |                x, y and z are those of your drawing, with any origin;
      O----- y         loads and requirements are along them, and theta_x turns
     /                 about x as a right-handed screw
    x
"""

AXES = {
    **dict.fromkeys(
        ("rcc", "cross-spring", "unseparated-cross", "three-blade", "star", "hinged-pivot"), _PIVOT
    ),
    **dict.fromkeys(("leaf-spring-stage", "necked-down-stage", "hinged-stage"), _STAGE),
    **dict.fromkeys(("cantilever", "guided-blade"), _BLADE),
    "moment-blade": _TURNED_BLADE,
    **dict.fromkeys(("torsion-bar", "round-torsion-bar", "torsion-star"), _TORSION),
    **dict.fromkeys(("notch-hinge", "elliptic-hinge", "filleted-hinge"), _HINGE),
    **dict.fromkeys(("linkage", "layout"), _DRAWN),
    "space-layout": _IN_SPACE,
}
"""The sketch of each kind of geometry."""
