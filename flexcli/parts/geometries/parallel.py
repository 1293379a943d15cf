"""Blades or limbs side by side: places, axial force, sag along the stroke."""

from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import cos, number, sin
from flexcli.parts.bending import WideBlades
from flexcli.parts.bending.base import Factor
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes

__all__ = [
    "SagsAlongStroke",
    "force_share",
    "is_push",
    "lever",
    "places",
    "pulled_evenly",
    "straight_share",
]

ROUNDING = 1e-9
"""Sine of an angle that counts as zero."""

PULLED_EVENLY = 5e-3
"""Largest error of a section's mean of a force along wide blades that are alike: CalculiX's solids
of necked and leaf-spring stages (two and three blades, spacing from 3 h, h/l 0.03 to 0.2, b/l 0.5
to 2.8, ν 0.3 and 0.45) had 0.000 to 0.002 more where they know it to 0.004, 0.006 ± 0.007 at
most."""


class SagsAlongStroke(Geometry):
    """A straight guide: a weight along its stroke x bends it as the stroke does."""

    def sag_stiffness(self, elastic: Elastic, sizes: Sizes, axis: str) -> Computed:
        """Return the stiffness along the stroke x [N/m]."""
        if not self.sags_along_stroke(axis):
            raise NotAvailable(f"has no closed form for its sag along {axis}, only along x")
        return self.stiffness(elastic, sizes)


def force_share(direction: float, members: int) -> float:
    """Return the axial force in each of equal members per force on a stage [-].

    ``direction`` [rad] is from the members; what is across them drives the stage.
    """
    return abs(cos(direction)) / members


def straight_share(direction: float, spoken: str) -> float:
    """Return 1 for a force along a hinge; raise for one across it, which also bends it."""
    if abs(sin(direction)) > ROUNDING:
        raise NotAvailable(f"has closed forms for a load along its {spoken} only")
    return 1.0


def is_push(direction: float, spoken: str) -> bool:
    """Return whether a force along the members, from the base, compresses them."""
    if abs(sin(direction)) > ROUNDING:
        raise NotAvailable(f"takes a load along its {spoken} only (direction: 0 deg or 180 deg)")
    return cos(direction) < 0.0


def places(members: int, spacing: float | None, spoken: str) -> tuple[float, ...]:
    """Return where equally spaced members stand across the stage [m], about its middle."""
    if spacing is None:
        raise NotAvailable(f"needs spacing: the distance from {spoken} to {spoken}")
    middle = (members - 1) / 2.0
    return tuple((index - middle) * spacing for index in range(members))


def lever(l: float, spacing: float | None) -> float:
    """Return l over the distance between the blades of a stage; 1 where it is unstated."""
    return 1.0 if spacing is None else l / spacing


def pulled_evenly(
    found: WideBlades, h: Computed, spacing: float | None, *, fillet: Computed = 0.0
) -> WideBlades:
    """Return the factors of alike blades side by side, with what a force along them has of it.

    Each bears what statics gives it, whatever it widens, but of a moment on the stage: of that,
    blades bear ``4/3 (h/s)²`` by bending, s their spacing. Nothing more is known of blades with
    fillets, whose middles bear more, or of an unstated spacing.
    """
    if spacing is None or number(fillet):
        return found
    turned = 4.0 / 3.0 * number(h / spacing) ** 2 * (found.stiffness.high - 1.0)
    off = PULLED_EVENLY + turned
    return found._replace(stretched=Factor(1.0, 1.0 - off, 1.0 + off))
