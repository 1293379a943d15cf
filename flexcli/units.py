"""Quantities as a person writes them, "0.2 mm", to and from SI floats.

Numbers are scaled as decimals and rounded once, so 637 um and 0.637 mm are the same float.
Everyday units are looked up in a table; anything else (``lbf/in``, ``N*mm/deg``) is worked out
by Pint, which is imported only then because it costs more than the rest of a check. A test
holds the table against Pint.
"""

import re
from collections.abc import Iterable
from decimal import Context, Decimal, localcontext
from functools import cache, lru_cache
from math import inf
from typing import Any, NamedTuple

__all__ = [
    "DIMENSIONS",
    "MAX_LENGTH",
    "SHOWN_UNITS",
    "SLIPS",
    "Dimension",
    "QuantityError",
    "number_and_unit",
    "numbers_and_unit",
    "parse_quantity",
    "registry",
    "show",
    "shown_unit",
    "written",
    "written_in",
]

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of free fall [m/s²] (3rd CGPM, 1901)."""

_DEGREE = "0.01745329251994329576923690768488612713"
_G = "9.80665"
_G2 = "96.1703842225"


class Dimension(NamedTuple):
    """What a number measures: its SI unit, an example to show, and everyday units."""

    name: str
    si: str
    example: str
    units: dict[str, str]

    @property
    def named(self) -> str:
        """Return the name with its article."""
        name = self.name if self.si else "plain number"
        return f"an {name}" if name[0] in "aei" else f"a {name}"

    @property
    def unit(self) -> str:
        """Return the unit of the example."""
        return self.example.partition(" ")[2]


class QuantityError(ValueError):
    """A text that is not a quantity of the asked dimension."""

    def __init__(self, text: str, hint: str) -> None:
        super().__init__(text)
        self.hint = hint


def _dimensions(*dimensions: Dimension) -> dict[str, Dimension]:
    return {d.name: d for d in dimensions}


DIMENSIONS = _dimensions(
    Dimension(
        "length",
        "m",
        "0.2 mm",
        {
            "nm": "1e-9",
            "um": "1e-6",
            "mm": "1e-3",
            "cm": "1e-2",
            "m": "1",
            "in": "0.0254",
        },
    ),
    Dimension(
        "angle", "rad", "45 deg", {"urad": "1e-6", "mrad": "1e-3", "rad": "1", "deg": _DEGREE}
    ),
    Dimension("mass", "kg", "17.1 g", {"mg": "1e-6", "g": "1e-3", "kg": "1"}),
    Dimension("time", "s", "60 s", {"ms": "1e-3", "s": "1", "min": "60", "h": "3600"}),
    Dimension("frequency", "Hz", "100 Hz", {"Hz": "1", "kHz": "1e3"}),
    Dimension("force", "N", "10 N", {"uN": "1e-6", "mN": "1e-3", "N": "1", "kN": "1e3"}),
    Dimension("moment", "N*m", "5 N*mm", {"N*mm": "1e-3", "mN*m": "1e-3", "N*m": "1"}),
    Dimension(
        "stress",
        "Pa",
        "500 MPa",
        {"Pa": "1", "kPa": "1e3", "MPa": "1e6", "GPa": "1e9", "N/mm^2": "1e6"},
    ),
    Dimension("velocity", "m/s", "1 m/s", {"mm/s": "1e-3", "m/s": "1"}),
    Dimension("acceleration", "m/s^2", "9.81 m/s^2", {"m/s^2": "1", "g": _G}),
    Dimension(
        "acceleration density",
        "(m/s^2)^2/Hz",
        "0.2 g^2/Hz",
        {"g^2/Hz": _G2, "(m/s^2)^2/Hz": "1", "m^2/s^3": "1"},
    ),
    Dimension("density", "kg/m^3", "4430 kg/m^3", {"kg/m^3": "1", "g/cm^3": "1e3"}),
    Dimension(
        "inertia", "kg*m^2", "5.4e-6 kg*m^2", {"kg*m^2": "1", "g*mm^2": "1e-9", "kg*mm^2": "1e-6"}
    ),
    Dimension("stiffness", "N/m", "200 N/m", {"N/m": "1", "N/mm": "1e3", "N/um": "1e6"}),
    Dimension(
        "rotational stiffness",
        "N*m/rad",
        "15 N*m/rad",
        {"N*m/rad": "1", "N*mm/rad": "1e-3", "kN*m/rad": "1e3"},
    ),
    Dimension("temperature", "K", "293 K", {"K": "1", "mK": "1e-3"}),
    Dimension("temperature change", "K", "60 K", {"K": "1", "mK": "1e-3"}),
    Dimension("temperature gradient", "K/m", "40 K/m", {"K/m": "1", "K/mm": "1e3"}),
    Dimension("expansion", "1/K", "8.6e-6 1/K", {"1/K": "1", "ppm/K": "1e-6"}),
    Dimension("decibel", "dB", "3 dB", {"dB": "1"}),
    Dimension("slope", "dB/oct", "6 dB/oct", {"dB/oct": "1", "dB/octave": "1"}),
    Dimension("sweep rate", "Hz/s", "0.05 Hz/s", {"Hz/s": "1"}),
    Dimension("ratio", "", "2.5", {"": "1", "%": "1e-2"}),
)

MAX_LENGTH = 80
SMALLEST, LARGEST = 1e-30, 1e30
"""What SI values may be: beyond it, h³ and its like leave the range of a float."""

_NUMBER = re.compile(r"\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", re.ASCII)
_DECIMAL_COMMA = re.compile(r"\s*[+-]?\d+,\d", re.ASCII)
_FACTOR = r"(?:[A-Za-z]++|%)(?:\^-?[1-9](?!\d))?"
_GROUP = rf"(?:\({_FACTOR}(?:[*/ ]{_FACTOR})*\)(?:\^-?[1-9](?!\d))?|{_FACTOR})"
_UNIT = rf"(?:1/)?{_GROUP}(?:[*/ ]{_GROUP})*"
_SPELLING = str.maketrans({
    "µ": "u", "μ": "u", "·": "*", "×": "*", "⋅": "*", "²": "^2", "³": "^3", "°": "deg",
    "\N{MINUS SIGN}": "-", "\N{NO-BREAK SPACE}": " ", "\N{NARROW NO-BREAK SPACE}": " ",
    "\N{THIN SPACE}": " ",
})  # fmt: skip
_BARE_POWER = re.compile(r"(?<=[A-Za-z)])(?=[23](?![\d.]))")
_TORQUE = re.compile(r"(?<![A-Za-z])(m?N)(mm?)(?![A-Za-z])")
SLIPS = {"mPa": "MPa", "Mm": "mm"}
"""Units that exist, a billion times off what is meant in this field."""

_PINT_DEFINITIONS = """
nano- = 1e-9 = n-
micro- = 1e-6 = u-
milli- = 1e-3 = m-
centi- = 1e-2 = c-
kilo- = 1e3 = k-
mega- = 1e6 = M-
giga- = 1e9 = G-
meter = [length] = m
second = [time] = s
gram = [mass] = g
kelvin = [temperature] = K
radian = [angle] = rad
degree = 0.01745329251994329576923690768488612713 radian = deg
arcminute = degree / 60 = arcmin
arcsecond = degree / 3600 = arcsec
percent = 0.01 = pct
ppm = 1e-6
minute = 60 second = min
hour = 3600 second = h
inch = 0.0254 meter = in
foot = 0.3048 meter = ft
micron = 1e-6 meter
hertz = 1 / second = Hz
newton = kilogram * meter / second ** 2 = N
pascal = newton / meter ** 2 = Pa
bar = 1e5 pascal
joule = newton * meter = J
standard_gravity = 9.80665 meter / second ** 2 = g_n
pound = 0.45359237 kilogram = lb
pound_force = pound * standard_gravity = lbf
psi = pound_force / inch ** 2
ksi = 1000 psi
decibel = [level] = dB
octave = [interval] = oct
"""


def number_and_unit(text: str) -> tuple[float, str] | None:
    """Return the number of a quantity and its unit as written, or nothing where it is none."""
    match = _NUMBER.fullmatch(text) if len(text) <= MAX_LENGTH else None
    return None if match is None else (float(match[1]), match[2])


def numbers_and_unit(texts: Iterable[str]) -> tuple[list[float], str] | None:
    """Return numbers and their unit as written; nothing where one has none, or another one."""
    read = [number_and_unit(text) for text in texts]
    there = [each for each in read if each is not None]
    units = {unit for _, unit in there}
    if len(there) < len(read) or len(units) != 1:
        return None
    return [number for number, _ in there], units.pop()


@lru_cache(maxsize=4096)  # a drawing that follows free parameters is read at each of their values
def parse_quantity(text: str, dimension: str) -> float:
    """Return the SI value of a quantity such as ``"0.2 mm"``.

    Parameters
    ----------
    text : str
        A decimal number and a unit, e.g. ``"113.8 GPa"``; a ratio may go without unit.
    dimension : str
        A key of :data:`DIMENSIONS`.

    Raises
    ------
    QuantityError
        When the text is no number, has no unit, a unit unknown, or one that measures
        something else; its ``hint`` says what would be right.

    """
    expected = DIMENSIONS[dimension]
    example = f"write e.g. {expected.example}"
    if len(text) > MAX_LENGTH:
        raise QuantityError(f"'{text[:20]}…' is too long for {expected.named}", example)
    if _DECIMAL_COMMA.match(text):
        raise QuantityError(f"'{text}' has a comma", f"write {text.replace(',', '.')}")
    match = _NUMBER.fullmatch(text.translate(_SPELLING))
    if match is None:
        expectation = "a number with a unit" if expected.si else expected.named
        raise QuantityError(f"'{text}' is not {expectation}", example)
    number, unit = match.groups()
    if not unit and dimension != "ratio":
        raise QuantityError(
            f"'{text}' has no unit", f"{expected.named} needs a unit, e.g. {number} {expected.unit}"
        )
    try:
        factor = _factor(unit, expected)
    except QuantityError as error:
        if expected.si:
            raise
        raise QuantityError(f"'{text}' is not {expected.named}", example) from error
    try:
        with localcontext() as context:
            context.prec = 40
            value = float(Decimal(number) * Decimal(factor))
    except ArithmeticError:  # an exponent of more digits than decimals have
        value = inf
    if abs(value) > LARGEST or (abs(value) < SMALLEST and Decimal(number) != 0):
        raise QuantityError(f"'{text}' is beyond any physical size", example)
    return value


def _factor(unit: str, expected: Dimension) -> str:
    """Return the factor to SI of a unit as it is written."""
    plain = _BARE_POWER.sub("^", unit.replace("**", "^"))
    plain = _TORQUE.sub(r"\1*\2", re.sub(r" *([*/^()]) *", r"\1", plain))
    if plain.startswith("/"):
        plain = f"1{plain}"
    everyday = expected.units.get(plain)
    if everyday is not None:
        return everyday
    if plain in SLIPS:
        raise QuantityError(f"'{unit}' is hardly meant", f"did you mean {SLIPS[plain]}?")
    if not re.fullmatch(_UNIT, plain):
        raise QuantityError(f"'{unit}' is not a unit", f"write e.g. {expected.example}")
    return _factor_by_pint(plain, unit, expected.name)


@cache
def _factor_by_pint(unit: str, as_written: str, dimension: str) -> str:
    """Return the factor to SI of a unit that the everyday table does not hold."""
    import pint  # a quarter of a second: only for units that are not everyday ones

    expected = DIMENSIONS[dimension]
    units = ", ".join(filter(None, expected.units))
    hint = f"{expected.named} is written e.g. {expected.example} (units: {units})"
    known = registry()
    spelled = unit.replace("%", "percent")
    if "acceleration" in dimension:
        spelled = re.sub(r"(?<![A-Za-z_])g(?![A-Za-z_])", "g_n", spelled)
    try:
        parsed = known.parse_units(spelled)
        target = known.parse_units(expected.si or "dimensionless")
        factor = known.Quantity(Decimal(1), parsed).to(target).magnitude
    except pint.DimensionalityError:
        raise QuantityError(f"'{as_written}' does not measure {expected.named}", hint) from None
    except (pint.PintError, ArithmeticError, ValueError):  # the last for names such as "nan"
        spellings = {known.casefold(): known for known in expected.units}
        meant = spellings.get(unit.casefold())
        if meant is not None:
            hint = f"did you mean {meant}?"
        raise QuantityError(f"'{as_written}' is not a known unit", hint) from None
    return str(factor)


@cache
def registry() -> Any:
    """Return a Pint registry of the units that a spec may use (its full one is 30 times slower)."""
    import pint

    found: pint.UnitRegistry[Decimal] = pint.UnitRegistry(
        None, non_int_type=Decimal, cache_folder=None
    )
    found.load_definitions(_PINT_DEFINITIONS.strip().splitlines())
    return found


_SHOWN = {
    "m": (("nm", 1e-9), ("µm", 1e-6), ("mm", 1e-3), ("m", 1.0)),
    "Pa": (("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9)),
    "kg": (("mg", 1e-6), ("g", 1e-3), ("kg", 1.0)),
    "N": (("mN", 1e-3), ("N", 1.0), ("kN", 1e3)),
    "rad": (("deg", float(_DEGREE)),),
    "m/s^2": (("m/s²", 1.0),),
    "m^3": (("mm³", 1e-9),),
    "s": (("ms", 1e-3), ("s", 1.0), ("h", 3600.0)),
    "N*m": (("N·mm", 1e-3), ("N·m", 1.0)),
    "N*m/rad": (("N·mm/rad", 1e-3), ("N·m/rad", 1.0)),
    "N/m": (("N/m", 1.0), ("N/mm", 1e3), ("N/µm", 1e6)),
}

SHOWN_UNITS = frozenset(
    {name for scales in _SHOWN.values() for name, _ in scales} | {"%", "Hz", "g", "dB", "g²/Hz"}
)
"""Units in which a person reads numbers."""


def shown_unit(value: float, unit: str) -> tuple[str, float]:
    """Return the unit in which a person reads an SI value, and its size in SI."""
    scales = _SHOWN.get(unit, ((unit, 1.0),))
    name, factor = scales[0]
    for name_next, factor_next in scales[1:]:
        if abs(value) >= 0.9995 * factor_next:
            name, factor = name_next, factor_next
    return name, factor


def show(value: float, unit: str, digits: int = 4) -> str:
    """Return an SI value as a person reads it: ``show(6.371e-4, "m") == "637.1 µm"``."""
    scales = _SHOWN.get(unit)
    if scales is None:
        return f"{value:.{digits}g} {unit}".rstrip()
    name, factor = shown_unit(value, unit)
    if value == 0.0:
        return "0 " + next((scale for scale, size in scales if size == 1.0), name)
    number = f"{value / factor:.{digits}g}"
    if "e" in number and 1.0 <= abs(value / factor) < 1e7:
        number = f"{value / factor:.0f}"
    return f"{number} {name}"


def written_in(unit: str, value: float, dimension: str) -> str:
    """Return an SI value in a unit of its dimension, with the fewest digits that give it back."""
    with localcontext() as context:
        context.prec = 40
        exact = Decimal(value) / Decimal(DIMENSIONS[dimension].units[unit])
    rounded = (Context(prec=digits).create_decimal(exact).normalize() for digits in range(1, 20))
    texts = (f"{d:f} {unit}" if -4 <= d.adjusted() < 7 else f"{d} {unit}" for d in rounded)
    return next(text for text in texts if parse_quantity(text, dimension) == value)


def written(value: float, dimension: str) -> str:
    """Return an SI value as a spec writes it, with every digit: reading it gives it back."""
    expected = DIMENSIONS[dimension]
    exact = Decimal(repr(value))
    powers_of_ten = {
        n: Decimal(f)
        for n, f in expected.units.items()
        if Decimal(f).normalize().as_tuple().digits == (1,)
    }
    for unit, factor in powers_of_ten.items():
        if 1 <= abs(exact / factor) < 1000:
            return f"{(exact / factor).normalize():f} {unit}".rstrip()
    return f"{exact.normalize()} {expected.si}".rstrip()
