"""Parameters of a drawing: what expressions mean, what is refused and where it stands."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

import flexcli
from flexcli.errors import SpecError
from flexcli.results import Status

DRAWING = """flexure: 1
material: ti-6al-4v
{parameters}
geometry:
  kind: layout
  bodies: {{stage: {{at: [{l}, {middle}], mass: 100 g}}}}
  blades:
    low: {{between: [ground, stage], from: [0 mm, 0 mm], to: [{l}, 0 mm], h: {h}, b: 10 mm}}
    high: {{between: [ground, stage], from: [0 mm, {gap}], to: [{l}, {gap}], h: {h}, b: 10 mm}}
  moving: stage
  motion: {{translation: 90 deg}}
cases: {{op: {{stroke: {{translation: 0.5 mm, cycles: 1e6}}}}}}
requirements: {{yield: 2, fatigue: 1}}
"""
NUMBERS = {"parameters": "", "l": "30 mm", "gap": "20 mm", "middle": "10 mm", "h": "0.3 mm"}
NAMES = {
    "parameters": "parameters: {l: 30 mm, gap: 20 mm, slender: 100}",
    "l": "l", "gap": "gap", "middle": "gap/2", "h": "l/slender",
}  # fmt: skip


def one(text, parameters="gap: 30 mm"):
    """Return the start of a blade of which an expression is told, or the findings about it."""
    said = {**NUMBERS, "parameters": f"parameters: {{{parameters}}}", "gap": f"'{text}'"}
    said["middle"] = "0*gap" if "gap:" in parameters else "0 mm"
    try:
        spec = flexcli.load(DRAWING.format(**said))
    except SpecError as error:
        return error.findings
    return spec.part.geometry.blades["high"].start[1]


def test_a_drawing_of_parameters_is_that_of_their_numbers():
    plain, named = (flexcli.check(DRAWING.format(**said)) for said in (NUMBERS, NAMES))
    assert named.status is plain.status is Status.PASS
    for name, value in plain.values.items():
        assert named.values[name].value == pytest.approx(value.value, rel=1e-12, abs=1e-15)


def test_a_parameter_is_set_and_swept_as_any_other_value():
    text = DRAWING.format(**NAMES)
    longer = flexcli.load(text, overrides={"parameters.l": "40 mm"}).part.geometry
    assert longer.blades["low"].length == pytest.approx(40e-3)
    assert longer.blades["low"].h.fixed == pytest.approx(0.4e-3)


@pytest.mark.parametrize(
    ("text", "metres"),
    [
        ("gap/2", 15e-3), ("-gap", -30e-3), ("gap - 2*(gap + 1 mm)/4", 14.5e-3),
        ("2 mm + gap", 32e-3), ("0.5*gap+1e-3 m", 16e-3), ("gap*gap/gap", 30e-3),
        ("gap − 1 mm", 29e-3), ("gap + 1 in", 55.4e-3), ("gap*sin(30 deg)", 15e-3),
        ("gap*cos(30 deg)*cos(30 deg) - gap*tan(45 deg)", -7.5e-3),
    ],
)  # fmt: skip
def test_sums_and_products_mean_what_they_do_on_paper(text, metres):
    assert one(text) == pytest.approx(metres, rel=1e-14)


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 1e3), st.integers(1, 99))
def test_a_parameter_may_be_made_of_those_before_it(a, b, n):
    said = f"gap: {a!r} mm, other: gap*{n} + {b!r} um, third: (other - gap)/2"
    expected = (a * 1e-3 * n + b * 1e-6 - a * 1e-3) / 2.0
    assert one("third", said) == pytest.approx(expected, rel=1e-9, abs=1e-12 * a * n)


@pytest.mark.parametrize(
    ("text", "parameters", "path", "why", "hint"),
    [
        ("gpa", "gap: 30 mm", "from[1]", "gpa", "0.2 mm"),
        ("gpa/2", "gap: 30 mm", "from[1]", "no parameter 'gpa'", "gap"),
        ("gap + 2 deg", "gap: 30 mm", "from[1]", "do not add up", "same dimension"),
        ("gap*gap", "gap: 30 mm", "from[1]", "nothing that a drawing has", "dimension"),
        ("gap/0", "gap: 30 mm", "from[1]", "divides by zero", "divides"),
        ("gap + 2 gap", "gap: 30 mm", "from[1]", "no unit", "2*gap"),
        ("gap**2", "gap: 30 mm", "from[1]", "no sum of products", "gap/2"),
        ("gap if gap else gap", "gap: 30 mm", "from[1]", "no sum of products", "gap/2"),
        ("gap.real", "gap: 30 mm", "from[1]", "no sum of products", "gap/2"),
        ("abs(gap)", "gap: 30 mm", "from[1]", "no sum of products", "gap/2"),
        ("gap/2", "gap: 30 deg", "from[1]", "length", ""),
        ("gap/2", "gap: {free: 2 mm}", "parameters.gap", "free between two", "{free: ["),
        ("gap/2", "gap: {free: [2 mm, 1 mm]}", "parameters.gap", "above zero", "[least, most]"),
        ("gap/2", "gap: {free: [-2 mm, 1 mm]}", "parameters.gap", "above zero", "gap - 10 mm"),
        ("gap/2", "gap: {free: [2 mm, 1 deg]}", "parameters.gap", "no range", "one unit"),
        ("gap/2", "class: {free: [1 mm, 2 mm]}, gap: 0.5*class", "parameters.class", "no name", ""),
        ("gap/2", "gap: {free: [1 mm, 2 mm], from: 1 mm}", "parameters.gap", "between two", ""),
        ("gap*sin(gap)", "gap: 30 mm", "from[1]", "sin is of an angle", "30 deg"),
        ("gap/2", "gap: [1 mm]", "parameters.gap", "is a quantity", "30 mm"),
        ("gap/2", "gap: 30 mm, l: 1 mm", "parameters.l", "nothing uses", "leave it out"),
        ("gap/2", "gap: later, later: 3 mm", "parameters.gap", "no parameter 'later'", ""),
    ],
)
def test_what_is_no_size_is_refused_where_it_stands(text, parameters, path, why, hint):
    findings = one(text, parameters)
    (found,) = [f for f in findings if f.path.endswith(path) and why in f.text]
    assert hint in found.hint
    assert found.line in (3, 9)


def test_parameters_are_for_drawings():
    text = DRAWING.format(**NAMES)
    start = text.index("geometry:")
    pivot = "geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.2 mm, l: 9 mm, b: 5 mm}\n"
    pivot = text[:start] + pivot + text[text.index("cases:") :]
    with pytest.raises(SpecError, match="parameters are for a drawn geometry"):
        flexcli.load(pivot)


def test_nothing_is_run(tmp_path):
    told = tmp_path / "told"
    findings = one(f"__import__('os').system('touch {told}')")
    assert findings
    assert not told.exists()
