"""What blades or limbs that stand side by side share: places, axial force, sag along the stroke."""

from flexcli.formulas.quantity import Quantity
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes

__all__ = ["SagsAlongStroke", "force_share", "places"]


class SagsAlongStroke(Geometry):
    """A straight guide: a weight along its stroke x bends it as the stroke does."""

    def sag_stiffness(self, elastic: Elastic, sizes: Sizes, axis: str) -> Quantity:
        """Return the stiffness along the stroke x [N/m]."""
        if axis != "x":
            raise NotAvailable(f"has no closed form for its sag along {axis}, only along x")
        return self.stiffness(elastic, sizes)


def force_share(direction: float, members: int, spoken: str) -> float:
    """Return the axial force in each of equal members per force along them [-]."""
    if direction != 0.0:
        raise NotAvailable(f"takes a load along its {spoken} only (direction: 0 deg)")
    return 1.0 / members


def places(members: int, spacing: float | None, spoken: str) -> tuple[float, ...]:
    """Return where equally spaced members stand across the stage [m], about its middle."""
    if spacing is None:
        raise NotAvailable(f"needs spacing: the distance from {spoken} to {spoken}")
    middle = (members - 1) / 2.0
    return tuple((index - middle) * spacing for index in range(members))
