"""Quantities: what is accepted, to the last digit, and what is refused, quickly and with a hint."""

from decimal import Decimal
from math import pi

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.units import (
    DIMENSIONS,
    LARGEST,
    MAX_LENGTH,
    SMALLEST,
    QuantityError,
    parse_quantity,
    show,
    written,
)

UNITS = [(name, unit) for name, dimension in DIMENSIONS.items() for unit in dimension.units]
NAMES = sorted(DIMENSIONS)
SIZES = st.floats(min_value=1e-25, max_value=1e25) | st.floats(min_value=-1e25, max_value=-1e-25)


@pytest.fixture(scope="module")
def registry() -> pint.UnitRegistry:
    return pint.UnitRegistry(non_int_type=Decimal, cache_folder=None)


def refused(text: str, dimension: str) -> QuantityError:
    with pytest.raises(QuantityError) as raised:
        parse_quantity(text, dimension)
    assert str(raised.value)
    assert raised.value.hint
    return raised.value


@pytest.mark.parametrize(("name", "unit"), UNITS)
def test_the_table_agrees_with_pint(name: str, unit: str, registry: pint.UnitRegistry) -> None:
    spelled = unit.replace("%", "percent")
    if "acceleration" in name:  # there, and only there, g is not a gram
        spelled = spelled.replace("g", "g_n")
    ours = Decimal(DIMENSIONS[name].units[unit])
    theirs = registry.Quantity(Decimal(1), spelled or "dimensionless")
    factor = theirs.to(DIMENSIONS[name].si or "dimensionless").magnitude
    # Pint's degree comes from a pi of fewer digits than ours
    assert abs(Decimal(factor) / ours - 1) < Decimal("1e-15" if unit == "deg" else "1e-26")


@pytest.mark.parametrize("name", NAMES)
def test_the_example_of_a_dimension_is_one_of_it(name: str) -> None:
    assert parse_quantity(DIMENSIONS[name].example, name) > 0.0


@pytest.mark.parametrize(("name", "unit"), [u for u in UNITS if not u[1].startswith("1")])
def test_a_unit_stands_with_and_without_a_space(name: str, unit: str) -> None:
    assert parse_quantity(f"2.5 {unit}", name) == parse_quantity(f" 2.5{unit} ", name)


@pytest.mark.slow
@given(st.integers(min_value=1, max_value=10**15))
def test_the_same_length_has_the_same_digits_in_any_unit(nanometres: int) -> None:
    length = Decimal(nanometres)
    spelled = [
        f"{length} nm",
        f"{length.scaleb(-3)} um",
        f"{length.scaleb(-6)} mm",
        f"{length.scaleb(-7)} cm",
        f"{length.scaleb(-9)} m",
    ]
    assert len({parse_quantity(text, "length") for text in spelled}) == 1
    assert parse_quantity(spelled[0], "length") == float(length.scaleb(-9))


def test_637_micrometres_are_written_in_three_ways() -> None:
    texts = ["637 um", "0.637 mm", "0.000637 m", "637e-6 m", "6.37e2 µm"]
    assert {parse_quantity(text, "length") for text in texts} == {0.000637}


@given(SIZES, st.sampled_from(NAMES))
def test_what_is_written_reads_back_exactly(value: float, name: str) -> None:
    text = written(value, name)
    assert len(text) <= MAX_LENGTH
    assert parse_quantity(text, name) == value


@pytest.mark.parametrize("name", NAMES)
def test_zero_is_written_and_read(name: str) -> None:
    assert parse_quantity(written(0.0, name), name) == 0.0


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [
        ("45°", "angle", pi / 4),
        ("45 °", "angle", pi / 4),
        ("3 \N{MICRO SIGN}m", "length", 3e-6),
        ("3 \N{GREEK SMALL LETTER MU}m", "length", 3e-6),
        ("0.2\N{NO-BREAK SPACE}mm", "length", 2e-4),
        ("\N{MINUS SIGN}2 mm", "length", -2e-3),
        ("9.81 m/s²", "acceleration", 9.81),
        ("1 g", "acceleration", 9.80665),
        ("1 g", "mass", 1e-3),
        ("0.2 g²/Hz", "acceleration density", 0.2 * 9.80665**2),
        ("0.2 g2/Hz", "acceleration density", 0.2 * 9.80665**2),
        ("0.2 g**2 / Hz", "acceleration density", 0.2 * 9.80665**2),
        ("500 N/mm2", "stress", 5e8),
        ("4430 kg/m³", "density", 4430.0),
        ("15 Nm/rad", "rotational stiffness", 15.0),
        ("15 N·m/rad", "rotational stiffness", 15.0),
        ("15 Nmm", "moment", 0.015),
        ("5 lbf/in", "stiffness", 5 * 4.4482216152605 / 0.0254),
        ("1 ksi", "stress", 6894757.293168),
        ("8.6 ppm/K", "expansion", 8.6e-6),
        ("8.6e-6 /K", "expansion", 8.6e-6),
        ("20 %", "ratio", 0.2),
        ("1e7", "ratio", 1e7),
        (".5", "ratio", 0.5),
        ("010", "ratio", 10.0),
    ],
)
def test_usual_spellings_are_understood(text: str, name: str, value: float) -> None:
    assert parse_quantity(text, name) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "name", "says", "hint"),
    [
        ("5", "length", "no unit", "5 mm"),
        ("5 kg", "length", "does not measure a length", "0.2 mm"),
        ("5 mm", "ratio", "not a plain number", "2.5"),
        ("100 rad/s", "frequency", "does not measure a frequency", "Hz"),
        ("3 gram", "acceleration", "does not measure an acceleration", "g"),
        ("3 g", "force", "does not measure a force", "10 N"),
        ("3 m s", "length", "does not measure", "mm"),
        ("2 m m", "length", "does not measure", "mm"),
        ("5 mmm", "length", "not a known unit", "mm"),
        ("5 degC", "angle", "not a known unit", "deg"),
        ("880 Mpa", "stress", "not a known unit", "did you mean MPa?"),
        ("880 mPa", "stress", "hardly meant", "did you mean MPa?"),
        ("5 Mm", "length", "hardly meant", "did you mean mm?"),
        ("0,2 mm", "length", "comma", "0.2 mm"),
        ("1_000 mm", "length", "not a unit", "mm"),
        ("1:30", "time", "not a unit", "60 s"),
        ("mm", "length", "not a number", "mm"),
        ("nan mm", "length", "not a number", "mm"),
        ("inf mm", "length", "not a number", "mm"),
        ("5 nan", "length", "not a known unit", "mm"),
        ("no", "ratio", "not a plain number", "2.5"),
        ("", "length", "not a number", "mm"),
        ("5 mm; import os", "length", "not a unit", "mm"),
        ("5 __class__", "length", "not a unit", "mm"),
        ("1e999 mm", "length", "beyond any physical size", "mm"),
        ("1e-999 mm", "length", "beyond any physical size", "mm"),
        ("1e999999999 mm", "length", "beyond any physical size", "mm"),
        ("1e-999999999999999999999999999 mm", "length", "beyond any physical size", "mm"),
        ("5 mm^9999999", "length", "not a unit", "mm"),
        ("5 9^9^9^9*mm", "length", "not a unit", "mm"),
        ("5 m" + "^9" * 30, "length", "not a unit", "mm"),
        ("5 " + "(" * 70 + "m", "length", "not a unit", "mm"),
        ("1" * 10_000 + " mm", "length", "too long", "mm"),
        ("1" * 10_000, "ratio", "too long", "2.5"),
        ("5 " + "m*" * 5_000 + "m", "length", "too long", "mm"),
    ],
)
def test_what_is_wrong_is_named_with_what_would_be_right(
    text: str, name: str, says: str, hint: str
) -> None:
    error = refused(text, name)
    assert says in str(error)
    assert hint in error.hint


@pytest.mark.parametrize("name", NAMES)
def test_a_unit_measures_what_the_table_says_and_nothing_else(name: str) -> None:
    # a moment per radian is the moment's dimension in SI, but the radian is kept apart here
    own = DIMENSIONS[name].units
    for unit in {unit for _, unit in UNITS if unit}:
        if unit in own:
            assert parse_quantity(f"1 {unit}", name) == float(own[unit]), unit
        else:
            refused(f"1 {unit}", name)


@pytest.mark.parametrize("name", NAMES)
def test_a_size_is_within_what_powers_of_it_can_bear(name: str) -> None:
    si = DIMENSIONS[name].si
    assert parse_quantity(f"{LARGEST!r} {si}", name) == LARGEST
    assert parse_quantity(f"{SMALLEST!r} {si}", name) == SMALLEST
    refused(f"1.1e30 {si}", name)
    refused(f"0.9e-30 {si}", name)


def read(text: str, name: str) -> tuple[float, str]:
    """Return a value and no hint, or no value and the hint of the refusal."""
    try:
        return parse_quantity(text, name), ""
    except QuantityError as error:
        return 0.0, error.hint


@given(st.text(max_size=100), st.sampled_from(NAMES))
def test_any_text_is_a_number_or_refused(text: str, name: str) -> None:
    value, hint = read(text, name)
    assert hint or value == 0.0 or SMALLEST <= abs(value) <= LARGEST


PIECES = ["m", "mm", "kg", "g", "%", "1", "/", "*", "^", "-", "(", ")", "2", "9", " ", "nan", "inf",
          "e", "in", "not", "deg", "Hz", "K", "rad", "°", "²", "N", "_", ".", "or"]  # fmt: skip


@given(st.lists(st.sampled_from(PIECES), max_size=12), st.sampled_from(NAMES))
def test_any_unit_is_known_or_refused(pieces: list[str], name: str) -> None:
    value, hint = read("5 " + "".join(pieces), name)
    assert hint or value > 0.0


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (6.371e-4, "m", "637.1 µm"),
        (9.9996e-4, "m", "1 mm"),
        (0.0, "m", "0 m"),
        (0.0, "rad", "0 deg"),
        (pi / 4, "rad", "45 deg"),
        (-2.5e-3, "m", "-2.5 mm"),
        (1.138e11, "Pa", "113.8 GPa"),
        (12345.6, "kg", "12346 kg"),
        (2.0, "1/K", "2 1/K"),
        (2.0, "", "2"),
        (1.234e-8, "N/m", "1.234e-08 N/m"),
    ],
)
def test_a_value_is_shown_in_the_unit_that_people_would_take(
    value: float, unit: str, text: str
) -> None:
    assert show(value, unit) == text


@given(st.floats(min_value=1e-9, max_value=1e9), st.sampled_from(["m", "Pa", "kg", "N", "s"]))
def test_what_is_shown_is_the_value_to_its_digits(value: float, unit: str) -> None:
    number, shown_unit = show(value, unit, digits=6).split(" ")
    name = {"m": "length", "Pa": "stress", "kg": "mass", "N": "force", "s": "time"}[unit]
    assert parse_quantity(f"{number} {shown_unit}", name) == pytest.approx(value, rel=1e-5)
