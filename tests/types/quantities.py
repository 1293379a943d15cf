"""What the strict checker accepts as a quantity, and what it must refuse.

It is read by mypy, not run: an ``ignore`` that nothing needs any more is an error of its own.
"""

import numpy as np

from flexcli.formulas.pivot import rotational_stiffness
from flexcli.numerics.signomial import Signomial


def accepted(h: Signomial, many: "np.ndarray[tuple[int], np.dtype[np.float64]]") -> None:
    """Floats, arrays and signomials are quantities, also together."""
    rotational_stiffness(E=114e9, h=1e-4, l=0.02, b=0.005, p=0.0)
    rotational_stiffness(E=114e9, h=many, l=0.02, b=0.005, p=0.0)
    rotational_stiffness(E=114e9, h=h, l=h, b=0.005, p=0.0)


def refused() -> None:
    """Words, lists and nothing are none."""
    rotational_stiffness(E="steel", h=1e-4, l=0.02, b=0.005, p=0.0)  # type: ignore[arg-type]
    rotational_stiffness(E=114e9, h=[], l=0.02, b=0.005, p=0.0)  # type: ignore[arg-type]
    rotational_stiffness(E=114e9, h=None, l=0.02, b=0.005, p=0.0)  # type: ignore[arg-type]
