"""What shear and stretching of thick hinges do to a stage on necked-down blades.

Only the hinges, the share ξ of a blade, shear and stretch; with ξ = 1 it is the leaf spring of
:mod:`flexcli.formulas.thick_shift`.
"""

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "shear_in_shift", "shear_parameter", "stretch_in_shift"]


def shear_parameter(*, Phi: Quantity, xi: Quantity) -> Quantity:
    """Return the shear of the hinges over their bending, as Timoshenko's Φ is of a whole blade.

    ``Φ' = Φ/(3 − 3ξ + ξ²)``: the stage is softer by the factor 1/(1 + Φ').

    Parameters
    ----------
    Phi : Quantity
        Timoshenko's 12EI/(κGA l²) of the hinge's section and the whole length [-].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    Phi' : Quantity
        Compliance by shear over that by bending [-].

    Examples
    --------
    >>> shear_parameter(Phi=0.03, xi=1.0)
    0.03

    References
    ----------
    Compliances F ξ l/(κGA) and F l³ ξ (3 − 3ξ + ξ²)/(12EI) in series.

    """
    return Phi / (3.0 - 3.0 * xi + xi**2)


def shear_in_shift(*, Phi: Quantity, xi: Quantity) -> Quantity:
    """Return the relative change that shear makes to the motion towards the base.

    ``(1 + Φ' (3 − ξ) D/(2S))/(1 + Φ')² − 1`` with ``D = 3 − 3ξ + ξ²`` and
    ``S = 4.5 − 7.5ξ + 4.5ξ² − 0.9ξ³``: the hinges turn less and shear instead.

    Parameters
    ----------
    Phi : Quantity
        Φ' of :func:`shear_parameter` [-].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        Motion with shear over that without, less one [-].

    Examples
    --------
    >>> from flexcli.formulas.thick_shift import shear_factor
    >>> round(shear_in_shift(Phi=0.1, xi=1.0) - shear_factor(0.1) + 1.0, 12)
    0.0

    References
    ----------
    Shortening ∫(θ²/2 + gθ) ds, the shear angle g of the hinges alone; their ∫θ ds is
    ``x (3ξ − ξ²)/(2D)``.

    """
    D, S = _sums(xi)
    return (1.0 + Phi * (3.0 - xi) * D / (2.0 * S)) / (1.0 + Phi) ** 2 - 1.0


def stretch_in_shift(*, h: Quantity, l: Quantity, xi: Quantity) -> Quantity:
    """Return the relative change that stretching makes to the motion towards the base.

    ``−(h/l)² (3 − ξ)/(2S)`` with ``S = 4.5 − 7.5ξ + 4.5ξ² − 0.9ξ³``.

    Parameters
    ----------
    h, l : Quantity
        Thickness of a hinge and length of the whole blade [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        Motion with stretching over that without, less one [-].

    Examples
    --------
    >>> round(stretch_in_shift(h=0.06, l=1.0, xi=1.0), 6)
    -0.006

    References
    ----------
    ``−F ∫θ ds/(EA)`` over the hinges.

    """
    _, S = _sums(xi)
    return -((h / l) ** 2) * (3.0 - xi) / (2.0 * S)


def _sums(xi: Quantity) -> tuple[Quantity, Quantity]:
    return 3.0 - 3.0 * xi + xi**2, 4.5 - 7.5 * xi + 4.5 * xi**2 - 0.9 * xi**3


_SHARE = Range("xi", 0.0, 1.0, "two hinges make up at most the whole blade")

CARDS = (
    Card("shear-of-necked-hinges", shear_parameter, {"Phi": 0.03, "xi": 0.3}, (_SHARE,)),
    Card("shear-in-necked-shift", shear_in_shift, {"Phi": 0.03, "xi": 0.3}, (_SHARE,)),
    Card(
        "stretching-in-necked-shift",
        stretch_in_shift,
        {"h": 1e-3, "l": 20e-3, "xi": 0.3},
        (_SHARE,),
    ),
)
