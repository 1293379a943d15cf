"""A blade of constant thickness as six springs at its middle, in closed form."""

from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity
from flexcli.formulas.section import second_moment, shear_parameter
from flexcli.formulas.torsion_section import torsion_constant

__all__ = ["CARDS", "MiddleStiffness", "middle_stiffness"]


class MiddleStiffness(NamedTuple):
    """Stiffness of a blade between rigid bodies, both motions stated at its middle.

    x along the blade, y across its thickness, z across its width [N/m], and about them [N·m/rad].
    """

    x: Quantity
    y: Quantity
    z: Quantity
    theta_x: Quantity
    theta_y: Quantity
    theta_z: Quantity


def middle_stiffness(
    *, E: Quantity, G: Quantity, h: Quantity, l: Quantity, b: Quantity
) -> MiddleStiffness:
    """Return the six stiffnesses of a blade at its middle, where no two of them are coupled.

    ``k_x = E b h/l``, ``k_y = E b h³/(l³ (1 + Φ_h))``, ``k_z = E h b³/(l³ (1 + Φ_b))``,
    ``k_θx = G J/l``, ``k_θy = E h b³/(12 l)``, ``k_θz = E b h³/(12 l)``, with
    ``Φ_d = (6/5)(E/G)(d/l)²``.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width [m].

    Returns
    -------
    k_x, k_y, k_z : Quantity
        Along the blade, across its thickness, across its width [N/m].
    k_θx, k_θy, k_θz : Quantity
        Torsion, bending of the width, bending of the thickness [N·m/rad].

    Notes
    -----
    Small deformation, shear with κ = 5/6, free warping, section free to contract across: a blade
    wide against its length is stiffer about z by up to 1/(1 − ν²).

    Examples
    --------
    >>> k = middle_stiffness(E=120.0, G=48.0, h=0.1, l=1.0, b=0.3)
    >>> round(k.y, 6), round(k.z, 6)
    (0.034951, 0.255118)

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    nu = E / (2.0 * G) - 1.0
    sheared_h = 1.0 + shear_parameter(depth=h, l=l, poisson_ratio=nu)
    sheared_b = 1.0 + shear_parameter(depth=b, l=l, poisson_ratio=nu)
    bending_h, bending_b = E * second_moment(b, h), E * second_moment(h, b)
    return MiddleStiffness(
        x=E * b * h / l,
        y=12.0 * bending_h / l**3 / sheared_h,
        z=12.0 * bending_b / l**3 / sheared_b,
        theta_x=G * torsion_constant(h, b) / l,
        theta_y=bending_b / l,
        theta_z=bending_h / l,
    )


CARDS: tuple[Card, ...] = (
    Card(
        name="blade-support-stiffness",
        function=middle_stiffness,
        example={"E": 114e9, "G": 42.5e9, "h": 0.25e-3, "l": 30e-3, "b": 10e-3},
        validity=(
            Range("h/l", most=0.3, why="beam theory: thickness well below the length"),
            Range("b/l", most=1.0, why="beam theory with shear; a wider blade is a plate"),
        ),
    ),
)
