"""Regular expressions of quantities, for schemas that know what a spec may say of a size.

They hold for ECMA 262 and for Python alike. A unit is one name with any prefix (``kPa``, ``um``,
``inch``), or a product in the shape of an everyday unit (``lbf/in`` as ``N/mm``). What only
cancels out to a dimension, such as ``kg/s^2`` for ``N/m``, is a quantity but no such text.
"""

import re
from collections import defaultdict
from functools import cache
from typing import Any

from pint import PintError

from flexcli.units import DIMENSIONS, SLIPS, registry

__all__ = ["number_pattern", "quantity_pattern"]

_DIGITS = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?0*[0-9]{1,2})?"
_NOT_ZERO = "(?=[0.]*[1-9])"
_SIGNS = {"": r"[+\-−]?", "+": rf"\+?{_NOT_ZERO}", "0+": r"\+?", "-": rf"[\-−]{_NOT_ZERO}"}
_TOKEN = re.compile(r"([A-Za-z]+|%)|\^([23])|([*/()1])")
_MARKS = {"*": "(?: ?[*·×⋅] ?| )", "/": " ?/ ?", "(": r"\( ?", ")": r" ?\)", "1": "1?"}
_POWERS = {"2": r"(?:(?:\^|\*\*)?2|²)", "3": r"(?:(?:\^|\*\*)?3|³)"}
_RUN_TOGETHER = "m?Nmm?"
"""Moments written without a sign between force and length."""
_SPOKEN = {"u": "[uµμ]", "deg": "(?:deg|°)"}
"""Prefixes and units that are written otherwise too."""


def number_pattern(sign: str = "") -> str:
    """Return a regular expression of decimal numbers of a sign, as of :func:`quantity_pattern`."""
    return f"{_SIGNS[sign]}{_DIGITS}"


@cache
def quantity_pattern(dimension: str, sign: str = "") -> str:
    """Return a regular expression of how quantities of a dimension are written.

    Parameters
    ----------
    dimension : str
        A key of :data:`flexcli.units.DIMENSIONS`.
    sign : {"", "+", "0+", "-"}
        Which numbers: any, above zero, not below it, below it.

    Returns
    -------
    str
        Anchored at both ends.

    """
    expected = DIMENSIONS[dimension]
    is_acceleration = "acceleration" in dimension
    whole = "g" if dimension == "acceleration" else _of_dimension(expected.si or "dimensionless")
    shapes = (_in_the_shape_of(u, is_acceleration) for u in expected.units if not u.isalpha())
    units = "|".join(dict.fromkeys(filter(None, (whole, *shapes))))
    if dimension == "moment":
        units = f"{units}|{_RUN_TOGETHER}"
    return rf"^\s*{number_pattern(sign)}\s*(?:{units}){'' if expected.si else '?'}\s*$"


def _in_the_shape_of(unit: str, is_acceleration: bool) -> str:
    """Return a product of units as a pattern, each factor by any name of its dimension."""
    found = []
    for name, power, mark in _TOKEN.findall(unit):
        if mark:
            found.append(_MARKS[mark])
        elif power:
            found.append(_POWERS[power])
        elif name == "%":
            found.append(name)
        else:
            same = "g" if is_acceleration and name == "g" else _of_dimension(name)
            found.append(f"(?:{same})")
    return "".join(found)


def _of_dimension(unit: str) -> str:
    """Return all units of one name that measure the same as a unit, as a pattern."""
    return _names().get(_measured(unit), "")


def _measured(unit: str) -> Any:
    return registry().parse_units(unit).dimensionality


@cache
def _names() -> dict[Any, str]:
    """Return a pattern of all units of one name, for whatever they measure."""
    known = registry()
    prefixes = list(known._prefixes)
    accepted: dict[tuple[Any, tuple[str, ...]], list[str]] = defaultdict(list)
    for name in filter(str.isalpha, known._units):
        for spelled in (name, f"{name}s"):
            measured = _measured(name)
            taken = tuple(p for p in prefixes if _is(f"{p}{spelled}", measured))
            accepted[measured, taken].append(_SPOKEN.get(spelled, spelled))
    found: dict[Any, list[str]] = defaultdict(list)
    for (measured, taken), names in accepted.items():
        before = "|".join(_SPOKEN.get(prefix, prefix) for prefix in taken if prefix)
        if taken:
            optional = "?" if "" in taken else ""
            found[measured].append((f"(?:{before}){optional}" if before else "") + _either(names))
    return {measured: "|".join(patterns) for measured, patterns in found.items()}


def _is(unit: str, measured: Any) -> bool:
    try:
        return unit not in SLIPS and bool(_measured(unit) == measured)
    except PintError:
        return False


def _either(names: list[str]) -> str:
    """Return a pattern of any of several names."""
    return f"(?:{'|'.join(names)})"
