"""Formatting of numbers for people: significant digits only, and no rounding errors."""

from collections.abc import Callable, Iterable
from math import floor, isfinite, isnan, log10

from flexcli.units import STANDARD_GRAVITY, show, shown_unit

__all__ = ["apart", "error_text", "factor_text", "largest", "share_text", "shown"]

NOISE = 1e-12
"""Part of the largest number of its kind below which a number is shown as 0.

What should cancel leaves some 1e-16 of what it is the difference of, times the few operations
on the way; no number of a design is known to twelve digits. A number alone has no such scale.
"""

FEWEST, MOST = 4, 12
"""Digits of a number: as many as are shown where no error says less, and the most that it takes
to tell two different numbers apart."""

MOST_FACTOR = 1e6
"""Largest factor that is printed: beyond it a demand is mostly a cancelled difference."""


def largest(numbers: Iterable[float | None]) -> float:
    """Return the largest magnitude of the finite ones, the scale of their rounding errors."""
    return max((abs(x) for x in numbers if x is not None and isfinite(x)), default=0.0)


def shown(value: float, unit: str, scale: float = 0.0, error: float | None = None) -> str:
    """Return an SI value as a person reads it, with the digits that its relative error leaves.

    The last digit shown is the first that the error touches, at most the fourth. What is noise
    beside ``scale`` is 0.
    """
    if abs(value) <= NOISE * scale:
        return "0"
    _, size = ("g", STANDARD_GRAVITY) if unit == "m/s^2" else shown_unit(value, unit)
    number = value / size
    if error and isfinite(error) and isfinite(number) and number != 0.0:
        first, touched = (floor(log10(abs(number) * part)) for part in (1.0, error))
        number = float(f"{number:.{min(max(first - touched, 0), FEWEST - 1)}e}")
    return f"{number:.{FEWEST}g} g" if unit == "m/s^2" else show(number * size, unit, FEWEST)


def error_text(error: float | None) -> str:
    """Return a relative error in a few characters; empty where no printed digit shows it."""
    if error is None or not isfinite(error):
        return "unknown"
    if error < 0.5 * 10.0 ** (1 - FEWEST):
        return ""
    return f"{error * 100.0:.2g} %" if error < 10.0 else "> 1000 %"


def apart(text: Callable[[float, int], str], one: float, other: float) -> tuple[str, str]:
    """Return two numbers as texts that differ where the numbers do; empty for no number."""
    enough = (d for d in range(FEWEST, MOST) if text(one, d) != text(other, d))
    digits = next(enough, FEWEST)
    return "" if isnan(one) else text(one, digits), "" if isnan(other) else text(other, digits)


def factor_text(value: float, digits: int = FEWEST) -> str:
    """Return a factor; ∞ where there is no demand, and nothing precise beyond a million."""
    if not isfinite(value):
        return "∞"
    return f"{value:.{digits}g}" if value < MOST_FACTOR else f"> {MOST_FACTOR:.0e}"


def share_text(share: float) -> str:
    """Return a share in per cent, with the digits that distinguish it from all and from none."""
    if isnan(share):
        return ""
    digits = 1
    while digits < 5 and 0.0 < share < 1.0 and round(100.0 * share, digits) in (0.0, 100.0):
        digits += 1
    return f"{100.0 * share:.{digits}f} %"
