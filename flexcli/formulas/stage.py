"""Parallel leaf-spring stage: n equal parallel blades, clamped at both ends, that swing."""

from flexcli.formulas.quantity import Quantity

__all__ = ["end_stress", "shortening", "translational_stiffness"]


def translational_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, blades: int = 2
) -> Quantity:
    """Return the stiffness of a parallel leaf-spring stage along its stroke.

    ``K = n 12EI/l³ = n E b h³/l³``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; broadcast.
    blades : int
        Number of blades.

    Returns
    -------
    Quantity
        Stiffness [N/m].

    Notes
    -----
    Stroke small against l; no axial load.

    Examples
    --------
    >>> round(translational_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3), 6)
    864.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation;
    exercise 12 A.

    """
    return blades * E * b * h**3 / l**3


def end_stress(*, E: Quantity, h: Quantity, l: Quantity, x: Quantity) -> Quantity:
    """Return the bending stress at the ends of a blade whose stage has moved by x.

    ``σ = 3 E h x/l²``, which the lecture writes as the admissible stroke σ l²/(3 E h).

    Examples
    --------
    >>> round(end_stress(E=200e9, h=300e-6, l=50e-3, x=1e-3) / 1e6, 6)
    72.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", admissible stroke.

    """
    return 3.0 * E * h * x / l**2


def shortening(*, l: Quantity, x: Quantity) -> Quantity:
    """Return the parasitic motion 3x²/(5l) of a stage towards its base [m], x [m] small.

    Examples
    --------
    >>> round(shortening(l=50e-3, x=5e-3) * 1e6, 6)
    300.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints" (λ ≈ 0.6 x²/L).

    """
    return 0.6 * x**2 / l
