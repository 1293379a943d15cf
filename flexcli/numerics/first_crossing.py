"""The first time at which a function falls to zero, found from the safe side."""

from math import hypot, inf, sqrt

from flexcli.numerics.exponential_sum import ExponentialSum

__all__ = ["Crossing", "first_crossing", "safe_step"]

_REFINEMENTS = 3
_RESOLUTION = 1e-15
"""Share of the horizon below which two times are the same."""

Crossing = tuple[float, int]
"""The time of a crossing, infinite where there is none, and the number of evaluations."""


def quadratic_zero(d: float, v: float, a: float) -> float:
    """Return the smallest h ≥ 0 with ``d + v h + a h²/2 = 0`` for d > 0, or inf.

    The root of each factor is taken before they meet: a product may be too small for a number.
    """
    if a < 0.0:
        root = hypot(v, sqrt(-2.0 * a) * sqrt(d))
        return 2.0 * d / (root - v) if v < 0.0 else (v + root) / -a
    discriminant = v * v - 2.0 * a * d
    return 2.0 * d / (sqrt(discriminant) - v) if v < 0.0 <= discriminant else inf


def safe_step(*, d: float, v: float, a: float, J: float, most: float) -> float:
    """Return a step within which a function that is now d > 0 cannot fall below zero.

    v and a are its slope and second derivative, J bounds the third. Within H the function lies
    above the parabola ``d + v h + (a − J H/3) h²/2``: the smaller of H and its zero is safe, and
    the two meet at the zero of the cubic. The step is at most ``most``.
    """
    low = min(most, quadratic_zero(d, v, a - J * most / 3.0))
    high = min(most, quadratic_zero(d, v, a - J * low / 3.0))
    for _ in range(_REFINEMENTS):
        if high <= 1.5 * low:
            break
        H = sqrt(low * high)
        zero = quadratic_zero(d, v, a - J * H / 3.0)
        low, high = max(low, min(H, zero)), min(high, max(H, zero))
    return low


def leaving_step(v: float, a: float, J: float) -> float:
    """Return a step within which a function that rises from zero cannot return to it.

    The zero of ``v + a h/2 − J h²/6``, for v > 0, or v = 0 and a > 0.
    """
    root = sqrt(a * a / 4.0 + 2.0 * J * v / 3.0)
    if a <= 0.0:
        return 2.0 * v / (root - a / 2.0) if root > a / 2.0 else inf
    return 3.0 * (a / 2.0 + root) / J if J > 0.0 else inf


def first_crossing(distance: ExponentialSum, horizon: float) -> Crossing:
    """Return the first time in [0, horizon) at which a function falls to zero.

    Each step is one that the bound of the third derivative proves free of zeros, so no crossing
    is missed, however short the time below zero. Near a crossing the steps are those of
    Newton's method from the left and converge as fast.

    Parameters
    ----------
    distance : ExponentialSum
        The function, at zero or above it at the start. Where it starts at zero and rises, the
        start is no crossing.
    horizon : float
        Time of the last interest, at most the sum's own.

    Returns
    -------
    tuple of float, int
        The time, or ``inf`` when there is no crossing; number of evaluations.

    Notes
    -----
    A value below the rounding of the sum is zero. Whether a minimum that close to zero touches
    can't be told in these numbers: it may count as a crossing or not.

    Examples
    --------
    >>> cosine = ExponentialSum([(1j, (1.0 + 0j,))], 10.0)
    >>> round(first_crossing(cosine, 10.0)[0], 12)
    1.570796326795

    """
    t = 0.0
    count = 0
    resolution = _RESOLUTION * horizon
    while True:
        d, v, a, J = distance.jet(t)
        count += 1
        if d <= distance.rounding:
            dips_below_rounding = a > 0.0 and v * v <= 2.0 * a * distance.rounding
            if v <= 0.0 and not dips_below_rounding:
                return t, count
            step = leaving_step(max(v, 0.0), a, J)
        else:
            step = safe_step(d=d, v=v, a=a, J=J, most=horizon - t)
        if t + step >= horizon:
            return inf, count
        if step <= resolution:
            return t, count
        t += step
