"""The rectangular section of a blade: area, second moments, volume, stress of a force."""

from flexcli.formulas.quantity import Quantity

__all__ = ["axial_stress", "blade_volume", "second_moment"]


def second_moment(width: Quantity, depth: Quantity) -> Quantity:
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


def axial_stress(force: Quantity, h: Quantity, b: Quantity) -> Quantity:
    """Return the mean stress N/(h b) of a force N [N] along a blade [Pa].

    Examples
    --------
    >>> axial_stress(100.0, 1e-3, 1e-2)
    10000000.0

    """
    return force / (h * b)


def blade_volume(blades: int, h: Quantity, l: Quantity, b: Quantity) -> Quantity:  # noqa: E741
    """Return the volume n h l b of n blades [m³].

    Examples
    --------
    >>> blade_volume(2, 1.0, 2.0, 3.0)
    12.0

    """
    return blades * h * l * b
