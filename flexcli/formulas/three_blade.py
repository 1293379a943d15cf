"""Three-blade pivot along its axis: width bending with the shear that a wide blade adds."""

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.results import QuantityKind

__all__ = ["CARDS", "out_of_plane_compliance", "out_of_plane_stiffness"]


def out_of_plane_compliance(
    *, E: Quantity, G: Quantity, h: Quantity, l: Quantity, b: Quantity, blades: int = 3
) -> Computed:
    """Return the compliance along the pivot's axis of n blades around it, bending and shear.

    ``1/K_z = (l³/b³ + (6/5)(E/G) l/b)/(n E h)``.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; broadcast.
    blades : int
        Number n of blades, three or more evenly around the axis.

    Returns
    -------
    1/K_z : Quantity
        Compliance [m/N].

    Notes
    -----
    Timoshenko's beam with κ = 5/6; the body does not tilt. A sum of two powers of the dimensions:
    it takes signomials, and a sag m g/K_z is bounded by it as it stands.

    Examples
    --------
    >>> C = out_of_plane_compliance(E=116e9, G=43.28e9, h=250e-6, l=80e-3, b=30e-3)
    >>> f"{0.8 * 3.7 * C * 1e9:.0f} nm"
    '937 nm'

    References
    ----------
    Exercise 12 B, equation (3), for the first term; Przemieniecki (1968), Theory of Matrix
    Structural Analysis, section 5.6, for the second.

    """
    return (l**3 / b**3 + 1.2 * E / G * l / b) / (blades * E * h)


def out_of_plane_stiffness(
    *, E: Quantity, G: Quantity, h: Quantity, l: Quantity, b: Quantity, blades: int = 3
) -> Computed:
    """Return the stiffness along the pivot's axis of n blades around it, bending and shear.

    ``K_z = n E h b³/(l³ (1 + Φ))`` with ``Φ = (6/5)(E/G)(b/l)² = (12/5)(1 + ν)(b/l)²``.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; broadcast.
    blades : int
        Number n of blades, three or more evenly around the axis.

    Returns
    -------
    K_z : Quantity
        Stiffness [N/m].

    Notes
    -----
    Exercise 12 B leaves Φ out: at its b/l = 0.375 and ν = 0.34 it is 0.45, so that the payload
    sinks by 937 nm where 645 nm are printed. Plane stress solved by Ritz's method is stiffer than
    this formula by 2.0 % at b/l = 0.375 and 4.6 % at b/l = 1 (ν = 0.34; 0.3 % and 2.2 % for 0).

    Examples
    --------
    >>> K = out_of_plane_stiffness(E=116e9, G=43.28e9, h=250e-6, l=80e-3, b=30e-3)
    >>> f"{K:.3g}"
    '3.16e+06'

    References
    ----------
    Exercise 12 B, equation (3); Przemieniecki (1968), Theory of Matrix Structural Analysis,
    section 5.6.

    """
    return 1.0 / out_of_plane_compliance(E=E, G=G, h=h, l=l, b=b, blades=blades)


def _share_left(ratio: float) -> float:
    """Return K_z over that of bending alone at b/l, for ν = 1/3."""
    return float(out_of_plane_stiffness(E=8.0, G=3.0, h=1.0, l=1.0, b=ratio) / (24.0 * ratio**3))


CARDS: tuple[Card, ...] = (
    Card(
        name="three-blade-out-of-plane",
        function=out_of_plane_stiffness,
        example={"E": 116e9, "G": 43.28e9, "h": 250e-6, "l": 80e-3, "b": 30e-3},
        validity=(Range("b/l", most=1.0, why="beam theory with shear; a wider blade is a plate"),),
        tables={
            "width": Table(
                variable="b/l",
                values=(0.05, 0.1, 0.2, 0.3, 0.375, 0.5, 0.75, 1.0),
                columns={"K_z/K_z(bending)": ("", _share_left)},
                note="ν = 1/3",
            )
        },
        kind=QuantityKind.SAG,
    ),
)
