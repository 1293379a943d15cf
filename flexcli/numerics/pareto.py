"""Which of several choices no other beats in both of two costs."""

from collections.abc import Sequence

__all__ = ["pareto"]


def pareto(first: Sequence[float], second: Sequence[float]) -> tuple[bool, ...]:
    """Return which choices are on the Pareto front of two costs.

    Parameters
    ----------
    first, second : sequence of float
        Both costs of each choice, the less the better; one that is infinite is no choice.

    Returns
    -------
    tuple of bool
        True where no other choice is at most as dear in both and less in one; of equals, all.

    Examples
    --------
    >>> pareto([1.0, 2.0, 3.0], [9.0, 9.0, 1.0])
    (True, False, True)

    """
    rows = list(zip(first, second, strict=True))
    return tuple(
        max(a, b) < float("inf")
        and not any(c <= a and d <= b and (c < a or d < b) for c, d in rows)
        for a, b in rows
    )
