"""Thick notches: how much softer a notch hinge is as a plane body than the beam of its profile.

The faces of a notch are not parallel, so that a section bends out of plane beside the throat, and
the blocks that the notch is cut into give way at its mouth. A beam has neither.
"""

from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.notch import elliptic_stiffness
from flexcli.numerics.rows import number, smaller

__all__ = ["CARDS", "DEEPEST", "THICKEST", "Softening", "softening"]

OF_THROAT = 0.4
"""Compliance that a throat has more than its beam, as a share of that and of e/radius."""

OF_ROUND, OF_SHAPE, MOST_OF_SHAPE = 0.005, 0.21, 0.12
"""Error of that 0.4 as a share of e/radius: of circles, more per |1 − l/(2 depth)|, at most."""

OF_BLOCKS, SHALLOW = 38.0, 0.15
"""Error by the blocks in 1/(E b H²), H the height of the mouth, and how it falls with e/depth."""

THICKEST, DEEPEST = 1.0, 4.0
"""Largest e/radius and e/depth of the notches that were compared."""


class Softening(NamedTuple):
    """Compliance in rotation beyond that of a hinge's beam, times E b, and its error [1/m²]."""

    more: float
    error: float


def softening(*, e: float, depth: float, l: float) -> Softening:
    """Return the compliance of a notch as a plane body beyond that of the beam of its profile.

    ``ΔC = 0.4 (e/ρ) C``, ρ = l²/(4 depth) the radius of the throat and C the beam's 1/K, with an
    error of ``38/(H² (1 + 0.15 e/depth))/(E b)``, H = e + 2 depth, by the blocks beside the notch.

    Parameters
    ----------
    e : float
        Thickness of the throat [m].
    depth, l : float
        Depth of each half-ellipse and its length along the hinge [m]; l = 2 depth is a circle.
        The two quarter circles of a filleted hinge are one such notch: r and 2 r.

    Returns
    -------
    softening : Softening
        ΔC E b and its error [1/m²].

    Notes
    -----
    Plane stress, and plane strain with E/(1 − ν²): a plane body under given moments has the same
    stress for any ν. Compared for circles of e/r from 0.02 to 1, ellipses of l/(2 depth) from ¼ to
    4 with e/ρ ≤ 1 and e/depth ≤ 4, fillets of h/r up to 20; for blocks as high as the mouth or
    twice that, rigid from 0 to 1 H behind it. The value is that of ½ H.

    Examples
    --------
    >>> hinge = {"e": 0.2e-3, "depth": 1e-3, "l": 2e-3}
    >>> beam = 1.0 / elliptic_stiffness(E=1.0, b=1.0, **hinge)
    >>> [round(float(part / beam), 3) for part in softening(**hinge)]
    [0.08, 0.011]

    References
    ----------
    Fitted here to finite elements of high order for plane bodies.

    """
    C = 1.0 / number(elliptic_stiffness(E=1.0, b=1.0, e=e, l=l, depth=depth))
    ratio = e / (l**2 / (4.0 * depth))
    fit = smaller(OF_ROUND + OF_SHAPE * abs(1.0 - l / (2.0 * depth)), MOST_OF_SHAPE)
    blocks = OF_BLOCKS / (1.0 + SHALLOW * smaller(e / depth, 5.0)) / (e + 2.0 * depth) ** 2
    return Softening(OF_THROAT * ratio * C, fit * ratio * C + blocks)


CARDS: tuple[Card, ...] = (
    Card(
        "thick-notch",
        softening,
        {"e": 0.2e-3, "depth": 1e-3, "l": 2e-3},
        (
            Range("e/radius", 0.0, THICKEST, "no thicker throat was compared"),
            Range("e/depth", 0.0, DEEPEST, "no shallower notch was compared"),
        ),
    ),
)
