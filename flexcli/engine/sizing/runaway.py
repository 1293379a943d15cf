"""Sizes that nothing holds: a sizing that leads to them has no end."""

from flexcli.errors import NoSolution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.units import show

__all__ = ["refuse_runaway"]

SMALLEST = 1e-9
"""A size [m] of a few atoms: a sizing that leads there is held by nothing."""


def refuse_runaway(design: DesignSpec, sizes: Sizes) -> None:
    """Raise where nothing holds a size above what anybody can make."""
    for name in design.geometry.free:
        x = float(getattr(sizes, name))
        if design.geometry.extents[name].least is None and x < SMALLEST:
            what = design.geometry.label(name)
            raise NoSolution(
                "nothing-holds-it",
                f"nothing holds the {what} {name}: it would be {show(x, 'm')}",
                f"bound {name} from below, e.g. {{free: [20 um, null]}}, or add a requirement "
                "that a thinner blade fails: a stiffness, a frequency, a buckling factor",
            )
