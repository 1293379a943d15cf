"""A curve of breakpoints drawn in braille dots on log-log axes, for a terminal."""

from collections.abc import Sequence
from math import ceil, floor, log10

__all__ = ["curve"]

_COLUMNS, _ROWS = 60, 12
_DOTS_ACROSS, _DOTS_DOWN = 2, 4
_BRAILLE = 0x2800
_BITS = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))
"""Bit of each dot of a braille character, by column from the left and row from the top."""
_MARGIN = 9


def curve(
    x: Sequence[float],
    y: Sequence[float],
    *,
    linear: bool,
    units: tuple[str, str] = ("Hz", "g²/Hz"),
) -> str:
    """Return lines of text that show y over x, both positive, on log-log axes.

    Between points the curve is straight on log-log axes, or on linear ones where ``linear``.
    The vertical axis spans whole decades; ``units`` stand beside the axes.
    """
    left, right = log10(x[0]), log10(x[-1])
    low, high = floor(log10(min(y)) + 1e-9), ceil(log10(max(y)) - 1e-9)
    high = max(high, low + 1)
    wide, tall = _COLUMNS * _DOTS_ACROSS - 1, _ROWS * _DOTS_DOWN - 1
    cells = [[0] * _COLUMNS for _ in range(_ROWS)]
    previous: int | None = None
    for across, value in _samples(x, y, wide, linear):
        down = round((high - log10(value)) / (high - low) * tall)
        start = down if previous is None else previous
        for dot in range(min(start, down), max(start, down) + 1):
            cells[dot // _DOTS_DOWN][across // _DOTS_ACROSS] |= _BITS[across % _DOTS_ACROSS][
                dot % _DOTS_DOWN
            ]
        previous = down
    labels = {0: f"1e{high}", _ROWS - 1: f"1e{low}"}
    rows = [
        f"{labels.get(index, ''):>{_MARGIN - 2}} ┤" + "".join(chr(_BRAILLE + bits) for bits in row)
        for index, row in enumerate(cells)
    ]
    ends = f"{10**left:.4g}", f"{10**right:.4g} {units[0]}"
    foot = " " * _MARGIN + ends[0] + " " * max(1, _COLUMNS - len("".join(ends))) + ends[1]
    return "\n".join([units[1].rjust(_MARGIN), *rows, foot])


def _samples(
    x: Sequence[float], y: Sequence[float], wide: int, linear: bool
) -> list[tuple[int, float]]:
    """Return the value at every column of dots, and both values at a step."""
    left, right = log10(x[0]), log10(x[-1])
    found: list[tuple[int, float]] = []
    for (x1, y1), (x2, y2) in zip(
        zip(x, y, strict=True), list(zip(x, y, strict=True))[1:], strict=False
    ):
        first, last = ((log10(each) - left) / (right - left) * wide for each in (x1, x2))
        found.append((round(first), y1))
        for across in range(ceil(first), floor(last) + 1):
            at = 10 ** (left + across / wide * (right - left))
            share = (at - x1) / (x2 - x1) if linear else (across - first) / (last - first or 1.0)
            share = min(max(share, 0.0), 1.0)
            found.append((across, y1 + (y2 - y1) * share if linear else y1 * (y2 / y1) ** share))
        found.append((round(last), y2))
    return found
