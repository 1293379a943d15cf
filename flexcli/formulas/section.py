"""The rectangular section of a blade: area, second moments, volume, stress of a force."""

from flexcli.formulas.quantity import Computed, Quantity

__all__ = ["axial_stress", "blade_volume", "second_moment", "shear_parameter"]


def second_moment(width: Quantity, depth: Quantity) -> Computed:
    """Return the second moment of area of a rectangle about the axis parallel to its width.

    ``I = width depth³ / 12``: with (b, h) for bending across the thickness h, with (h, b) for
    bending across the width b.

    Parameters
    ----------
    width : Quantity
        Side parallel to the neutral axis [m], broadcasts.
    depth : Quantity
        Side across the neutral axis [m], broadcasts.

    Returns
    -------
    Quantity
        Second moment of area [m⁴].

    Examples
    --------
    >>> second_moment(12.0, 2.0)
    8.0

    References
    ----------
    Timoshenko, S. (1955), Strength of Materials, Part I, appendix A.

    """
    return width * depth**3 / 12.0


def axial_stress(force: Quantity, h: Quantity, b: Quantity) -> Computed:
    """Return the mean stress N/(h b) of a force N [N] along a blade [Pa].

    Examples
    --------
    >>> axial_stress(100.0, 1e-3, 1e-2)
    10000000.0

    """
    return force / (h * b)


def blade_volume(blades: int, h: Quantity, l: Quantity, b: Quantity) -> Computed:
    """Return the volume n h l b of n blades [m³].

    Examples
    --------
    >>> blade_volume(2, 1.0, 2.0, 3.0)
    12.0

    """
    return blades * h * l * b


def shear_parameter(*, depth: Quantity, l: Quantity, poisson_ratio: Quantity) -> Computed:
    """Return Timoshenko's shear parameter Φ = 12EI/(κ G A l²) of a rectangular blade.

    ``Φ = (12/5)(1 + ν)(d/l)²`` with κ = 5/6 and d the side across the neutral axis: a
    clamped-guided blade is softer by the factor 1/(1 + Φ).

    Parameters
    ----------
    depth, l : Quantity
        Side across the neutral axis and length [m].
    poisson_ratio : float
        ν of an isotropic material [-].

    Examples
    --------
    >>> round(shear_parameter(depth=0.3, l=1.0, poisson_ratio=0.25), 3)
    0.27

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    return 2.4 * (1.0 + poisson_ratio) * (depth / l) ** 2
