"""Buckling of a joint of equal blades: the force at which its body turns away or a blade bows."""

from collections.abc import Sequence
from math import cos, inf, pi, sin

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.buckling import thick_load
from flexcli.formulas.card import SLENDER, Card
from flexcli.formulas.pivot import axial_share

__all__ = [
    "CARDS",
    "STRAIN",
    "held_load",
    "pulled_straight",
    "shares",
    "sway",
    "turning_load",
    "turning_stiffness",
]

Floats = NDArray[np.float64]

_SERIES = 1e-3
"""|n| below which the series, whose next term is n³, is more exact than the quotient."""

_PLACES = 64
"""Forces at which the stiffness is looked at before its first root is closed in on."""

_PULLED = 1e5
"""Largest tension of interest [EI/l²] where nothing is said of the strain."""

STRAIN = 0.3
"""Largest axial strain of interest [-], far beyond what metals bear."""

_REFINED = 9


def turning_stiffness(
    n: NDArray[np.float64] | float, *, delta: float, axial: float = 0.0, shear: float = 0.0
) -> Floats:
    """Return what one blade that carries an axial force adds to the turning of its pivot.

    ``k = 1/τ + ñτ/4 + (β − mτ/2)²/(m D) − n β``, ``D = m (1 − τ)/ñ + s/m``, with ``ñ = m n``,
    ``m = 1 − (s − a) n``, ``β = 1 + δ`` and ``τ = tanh(√ñ/2)/(√ñ/2)``.

    Parameters
    ----------
    n : array
        Axial force N l²/(EI), positive in tension [-].
    delta : float
        Place of the centre, p/l [-].
    axial : float
        a = EI/(EA l²), (h/l)²/12 of a rectangle [-].
    shear : float
        s = EI/(κGA l²), Φ/12 of Timoshenko's parameter [-].

    Returns
    -------
    k : array
        Stiffness of the body's rotation about the centre, in units EI/l [-].

    Notes
    -----
    The blade starts clamped at p from the centre and ends on the body, which turns by θ about
    the centre: its end moves across by β l θ and turns by θ. With ψ'' = ñψ − m q and y' = mψ + s q
    (Reissner's beam about its straight state, q the force across in EI/l²) the moment of its end
    forces about the centre is k θ. Without shear and stretching it is the sum of
    ``loaded_pivot.loaded_stiffness``, ``1/τ + γ²(n/4) τ/(1 − τ) + n (γ² − 1)/4``.

    Examples
    --------
    >>> round(float(turning_stiffness(0.0, delta=-0.5)), 6)
    1.0
    >>> round(float(turning_stiffness(4 * 1.1996786402577337**2, delta=-0.5)), 9)
    0.0

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 1.11; Haringx (1949), Philips
    Research Reports 4 (cross-spring pivots).

    """
    n = np.asarray(n, dtype=np.float64)
    m = 1.0 - (shear - axial) * n
    product = m * n
    small = np.abs(product) < _SERIES
    safe = np.where(small, 1.0, product)
    half = np.sqrt(np.abs(safe)) / 2.0
    with np.errstate(over="ignore"):
        tau = np.where(safe > 0.0, np.tanh(half), np.tan(half)) / half
    rest = np.where(small, 1.0 / 12.0 - product / 120.0, (1.0 - tau) / safe)
    tau = np.where(small, 1.0 - product * rest, tau)
    beta = 1.0 + delta
    D = m * rest + shear / m
    return np.asarray(
        1.0 / tau + product * tau / 4.0 + (beta - m * tau / 2.0) ** 2 / (m * D) - n * beta
    )


def shares(*, angles: Sequence[float], direction: float, across: bool) -> tuple[float, ...]:
    """Return the axial force in each blade per force on a joint, and what the body moves across.

    ``N_i = cos(α_i − φ)/Σ cos²(α_j − φ)`` where the body is kept from moving across the force,
    else those of ``pivot.axial_share``: blades of equal axial stiffness.

    Parameters
    ----------
    angles : sequence of float
        Direction of each blade from the axis of symmetry [rad].
    direction : float
        Direction of the force from the axis of symmetry [rad].
    across : bool
        Whether the body is held across the force.

    Returns
    -------
    shares : tuple of float
        Axial force of each blade over the force, positive in tension [-].

    Raises
    ------
    ValueError
        When parallel blades have no stiffness against the force.

    Examples
    --------
    >>> from math import pi
    >>> [round(n, 4) for n in shares(angles=(pi / 4, -pi / 4), direction=pi / 4, across=True)]
    [1.0, 0.0]

    References
    ----------
    Least strain energy of a truss, e.g. Przemieniecki (1968), Theory of Matrix Structural
    Analysis.

    """
    if not across:
        return axial_share(tuple(angles), direction)
    along = [cos(angle - direction) for angle in angles]
    total = sum(c**2 for c in along)
    if total < _ROUNDING:
        raise ValueError("blades across the force cannot balance it by axial force")
    return tuple(c / total for c in along)


def sway(*, angles: Sequence[float], shares: Sequence[float]) -> float:
    """Return how far the body moves across a blade as it stretches them, over the most stretched.

    The body's motion d with ``u_i·d = N_i`` by least squares; the largest ``|u_i × d|/max|N|``:
    tan α for two blades at ±α and a force along their bisector.

    Parameters
    ----------
    angles : sequence of float
        Direction of each blade [rad].
    shares : sequence of float
        Axial force of each [-].

    Returns
    -------
    sway : float
        Motion across over motion along [-].

    Examples
    --------
    >>> from math import pi
    >>> round(sway(angles=(pi / 4, -pi / 4), shares=(0.7, 0.7)), 6)
    1.0

    References
    ----------
    Small motions of a truss.

    """
    u = np.array([(cos(angle), sin(angle)) for angle in angles])
    d = np.linalg.lstsq(u, np.asarray(shares), rcond=None)[0]
    across = np.abs(u[:, 0] * d[1] - u[:, 1] * d[0])
    return float(across.max() / np.abs(np.asarray(shares)).max())


def pulled_straight(pulled: float, pushed: float) -> float:
    """Return how much more a force that turns a body changes by what it changes of its blades.

    ``(n + m)/(√n + m)`` from n = 4π² on, else 1: what straight blades of a large tension n hold a
    body by is √n beside the n that turns it, so that a force which turns it by their stretching
    alone is of no first order in that.

    Parameters
    ----------
    pulled, pushed : float
        Largest tension n and compression m of a blade [EI/l²].

    Returns
    -------
    more : float
        Factor on the relative change of the critical force over that of the blades [-].

    Examples
    --------
    >>> pulled_straight(0.0, 40.0), pulled_straight(900.0, 0.0)
    (1.0, 30.0)

    References
    ----------
    From ``turning_stiffness`` at large n.

    """
    if pulled <= 4.0 * pi**2:
        return 1.0
    more: float = (pulled + pushed) / (pulled**0.5 + pushed)
    return more


def turning_load(
    *,
    tensions: Sequence[float],
    delta: float,
    axial: float = 0.0,
    shear: float = 0.0,
) -> float:
    """Return the force at the centre of a pivot at which its body turns away, in units EI/l².

    The first root of ``Σ k(n_i) = 0`` over the blades, ``n_i = F t_i`` with their shares t_i of the
    force, or the force that buckles the most compressed blade between ends that stand still.

    Parameters
    ----------
    tensions : sequence of float
        Axial force of each blade over the force, positive in tension: its share [-].
    delta : float
        Place of the centre, p/l [-].
    axial, shear : float
        EI/(EA l²) and EI/(κGA l²) of a blade [-].

    Returns
    -------
    F : float
        Critical force over EI/l² [-]; infinite where none is up to a strain of 30 %.

    Notes
    -----
    The blades hold the centre, which is what slender ones that are not all but parallel do; free
    to move across the force or not is then the same. The force keeps its direction and acts at
    the centre.

    Examples
    --------
    >>> round(turning_load(tensions=(0.5**0.5, 0.5**0.5), delta=-0.5), 4)
    8.1415

    References
    ----------
    Wittrick (1951), Aeronautical Quarterly 3, for the stiffness under load; the root as here.

    """
    shares = np.asarray(tensions, dtype=np.float64)
    pushed, pulled = -float(shares.min()), float(shares.max())
    blade = thick_load(ends="clamped-clamped", axial=axial, shear=shear)
    bowed = blade / pushed if pushed > _ROUNDING else inf
    reach = min(_PULLED, STRAIN / axial) if axial else _PULLED
    most = min(bowed, reach / max(pulled, pushed))

    def stiffness(F: Floats) -> Floats:
        n = np.asarray(F)[:, None] * shares
        return np.asarray(turning_stiffness(n, delta=delta, axial=axial, shear=shear).sum(axis=-1))

    # evenly where blades are pushed, by a constant factor where the force is large
    low, high = 0.0, most
    places = np.concatenate([np.geomspace(1e-3 * most, most, _PLACES)[:-1], [(1.0 - 1e-9) * most]])
    if bowed == most:
        places = np.linspace(0.0, (1.0 - 1e-9) * most, _PLACES + 1)[1:]
    for _ in range(_REFINED):
        falls = np.flatnonzero(stiffness(places) <= 0.0)
        if falls.size == 0:
            return bowed
        first = int(falls[0])
        low, high = (places[first - 1] if first else low), places[first]
        places = np.linspace(low, high, 33)[1:]
        if high - low <= _ROUNDING * high:
            break
    return float((low + high) / 2.0)


_ROUNDING = 1e-12


def held_load(
    *, tensions: Sequence[float], ends: str, axial: float = 0.0, shear: float = 0.0
) -> float:
    """Return the force on a joint whose body keeps its blades' ends, in units EI/l².

    ``F = P/max(−t_i)``: the most compressed blade buckles alone, P that of its ends.

    Parameters
    ----------
    tensions : sequence of float
        Axial force of each blade over the force, positive in tension: its share [-].
    ends : str
        How a blade's ends are held: ``clamped-clamped``, or ``pinned-pinned`` for hinges.
    axial, shear : float
        EI/(EA l²) and EI/(κGA l²) of a blade [-].

    Returns
    -------
    F : float
        Critical force over EI/l² [-]; infinite where no blade is compressed.

    Examples
    --------
    >>> round(held_load(tensions=(-(0.5**0.5), -(0.5**0.5)), ends="clamped-clamped"), 4)
    55.8309

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 2.1.

    """
    pushed = -min(tensions)
    if pushed <= _ROUNDING:
        return inf
    return thick_load(ends=ends, axial=axial, shear=shear) / pushed


_BLADE = {"axial": 1e-4, "shear": 3e-4}

CARDS = (
    Card("pivot-buckling-turning", turning_load,
         {**_BLADE, "tensions": (0.5**0.5, 0.5**0.5), "delta": -0.5}, (SLENDER,)),
    Card("pivot-buckling-held", held_load,
         {**_BLADE, "tensions": (-(0.5**0.5), -(0.5**0.5)), "ends": "clamped-clamped"},
         (SLENDER,)),
)  # fmt: skip
