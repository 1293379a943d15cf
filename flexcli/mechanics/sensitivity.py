"""How planar equilibria change with the numbers of their layout, by the converged Jacobian.

Of ``R(x, p) = 0`` a small change δp of lengths, thicknesses, widths, places or angles makes
``δx = −(∂R/∂x)⁻¹ ∂R/∂p δp``: no path is followed and nothing is solved again. ∂R/∂p is a
difference of the residual alone, about unknowns that stand still; so any number that a layout may
have can be a parameter, and numbers read off both sides of an equilibrium have its implicit
derivative (direct differentiation: a sizing has few parameters and many numbers).

References
----------
Choi & Kim (2005), Structural Sensitivity Analysis and Optimization 1, section 4.2.
"""

from collections.abc import Sequence
from dataclasses import replace

from flexcli.mechanics.assembly import assemble
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.mechanics.state import Equilibrium, Part

__all__ = ["beside"]


def beside(
    state: Equilibrium, layout: Layout, held: Held | None = None, *, loads: Sequence[Load] = ()
) -> Equilibrium:
    """Return what equilibria become where the numbers of their layout change a little.

    One step of Newton's method from the known unknowns, at the same nodes on either level. Half the
    difference of numbers g at changes ±δp is their implicit derivative times δp,
    ``∂g/∂p − ∂g/∂x (∂R/∂x)⁻¹ ∂R/∂p``: what the step leaves of R is even in δp.

    Parameters
    ----------
    state : Equilibrium
        Equilibria that went all the way.
    layout : Layout
        The same bodies and blades, with other numbers.
    held, loads
        What is held and loaded there, as in :func:`flexcli.mechanics.equilibrium.solve`; it may
        differ a little too.

    """

    def changed(part: Part) -> Part:
        assembly = assemble(layout, state.effects, part.assembly.nodes)
        demand = demand_of(assembly, held or {}, loads)
        x = part.x + assembly.step(part.x, part.share, part.rows, demand)
        return part._replace(assembly=assembly, demand=demand, x=x)

    return replace(
        state,
        layout=layout,
        parts=tuple(map(changed, state.parts)),
        coarser_parts=tuple(map(changed, state.coarser_parts)),
    )
