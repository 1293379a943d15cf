"""What a spec names: in its own folder alone unless allowed, and materials with own values."""

from pathlib import Path

import pytest

from flexcli.errors import Finding, SpecError
from flexcli.parts.material import Material
from flexcli.spec.load import load, load_shipped
from flexcli.spec.references import from_anywhere

DESIGN = """flexure: 1
material: {material}
geometry: {{kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}}
cases:
  work:
    stroke: {{rotation: 2 deg, cycles: 1e7}}
requirements:
  fatigue: 1.5
"""
GOOD = """flexure: 1
material:
  youngs_modulus: 113.8 GPa
  fatigue_amplitude: {value: 510 MPa, cycles: 1e7}
"""
WRONG = "flexure: 1\nmaterial:\n  youngs_modulus: 113.8 GHz # the secret line\n"
TWICE = "flexure: 1\nmaterial:\n  name: the secret line\n  name: the secret line again\n"


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    """Return a spec's path in a folder of its own, a foreign folder beside it."""
    (tmp_path / "home").mkdir()
    (tmp_path / "foreign").mkdir()
    return tmp_path / "home" / "flexure.yaml"


def refused(path: Path) -> list[Finding]:
    with pytest.raises(SpecError) as raised:
        load(path)
    return raised.value.findings


def name_foreign(spec: Path, way: str, text: str) -> None:
    """Let a spec name a foreign material in one of the ways that lead out of its folder."""
    foreign = spec.parent.parent / "foreign" / "mine.yaml"
    foreign.write_text(text)
    name = {
        "by steps up": "../foreign/mine.yaml",
        "from the root": str(foreign),
        "by a link": "link.yaml",
        "by a linked folder": "linked/mine.yaml",
        "behind another": "{extends: inner.yaml}",
    }[way]
    (spec.parent / "link.yaml").symlink_to(foreign)
    (spec.parent / "linked").symlink_to(foreign.parent)
    (spec.parent / "inner.yaml").write_text(
        "flexure: 1\nmaterial: {extends: ../foreign/mine.yaml, density: 7900 kg/m^3}\n"
    )
    spec.write_text(DESIGN.format(material=name))


WAYS = (
    "by steps up",
    "from the root",
    "by a link",
    "by a linked folder",
    "behind another",
)


@pytest.mark.parametrize("way", WAYS)
def test_what_lies_outside_the_folder_is_read_only_when_allowed(spec: Path, way: str) -> None:
    name_foreign(spec, way, GOOD)
    (found,) = refused(spec)
    assert "lies outside the spec's folder" in found.text
    assert "--allow-outside" in found.hint
    with from_anywhere():
        assert load(spec).part.material.youngs_modulus.value == 113.8e9
    assert refused(spec) == [found], "allowed only as long as it was said"


@pytest.mark.parametrize("way", WAYS)
def test_a_refusal_does_not_tell_whether_a_foreign_file_exists(spec: Path, way: str) -> None:
    name_foreign(spec, way, GOOD)
    there = refused(spec)
    (spec.parent.parent / "foreign" / "mine.yaml").unlink()
    assert refused(spec) == there


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("text", [WRONG, TWICE, "flexure: 1\nthe secret line\n"])
def test_no_line_of_a_foreign_file_is_shown(spec: Path, way: str, text: str) -> None:
    name_foreign(spec, way, text)
    with from_anywhere():
        findings = refused(spec)
    assert findings
    assert not [f for f in findings if "secret" in f.source_line + f.text + f.hint]


def test_lines_of_a_file_in_the_folder_are_shown(spec: Path) -> None:
    (spec.parent / "mine.yaml").write_text(WRONG)
    spec.write_text(DESIGN.format(material="mine.yaml"))
    assert "the secret line" in refused(spec)[0].source_line


def test_a_folder_of_parts_may_name_its_neighbours(spec: Path) -> None:
    (spec.parent / "parts").mkdir()
    (spec.parent / "parts" / "base.yaml").write_text(GOOD)
    (spec.parent / "mine.yaml").write_text("flexure: 1\nmaterial: {extends: parts/base.yaml}\n")
    (spec.parent / "parts" / "own.yaml").write_text(
        "flexure: 1\nmaterial: {extends: ../mine.yaml}\n"
    )
    spec.write_text(DESIGN.format(material="parts/own.yaml"))
    assert load(spec).part.material.youngs_modulus.value == 113.8e9


def material(spec: Path, text: str) -> Material:
    spec.write_text(DESIGN.format(material=text))
    return load(spec).part.material


def test_own_values_take_the_place_of_those_of_the_material_that_is_extended(spec: Path) -> None:
    base = load_shipped("material", "ti-6al-4v")
    own = material(spec, "{extends: ti-6al-4v, density: 4400 kg/m^3}")
    assert own.density is not None
    assert (own.density.value, own.density.status) == (4400.0, "given")
    same = ("youngs_modulus", "poisson_ratio", "yield_strength", "fatigue_amplitude", "condition")
    assert [getattr(own, name) for name in same] == [getattr(base, name) for name in same]
    assert own.name == f"{base.name}, with own density"
    assert material(spec, "{extends: ti-6al-4v, name: Ours}").name == "Ours"


def test_the_sketch_of_a_coupon_test_is_accepted(spec: Path) -> None:
    own = material(
        spec,
        "{extends: 1-4310-c1300, fatigue_amplitude: {value: 420 MPa, cycles: 1e8, "
        'stress_ratio: -1, source: "coupon test 14"}}',
    )
    assert own.reversed_amplitude(1e8)[0] == pytest.approx(420e6)
    assert own.fatigue_amplitude is not None
    assert own.fatigue_amplitude.source == "coupon test 14"


def test_own_fatigue_data_leave_none_of_the_extended_test(spec: Path) -> None:
    base = load_shipped("material", "7075-t6")
    assert base.sn_amplitudes is not None
    own = material(spec, "{extends: 7075-t6, fatigue_amplitude: {value: 90 MPa, cycles: 1e7}}")
    assert own.sn_amplitudes is None
    assert own.reversed_amplitude(1e5)[0] == pytest.approx(90e6)


def test_a_material_file_extends_another_and_a_design_extends_it(spec: Path) -> None:
    (spec.parent / "strip.yaml").write_text(
        "flexure: 1\nmaterial: {extends: ti-6al-4v, name: Strip, density: 4400 kg/m^3}\n"
    )
    assert load(spec.parent / "strip.yaml").part.density.value == 4400.0
    own = material(spec, "{extends: strip.yaml, poisson_ratio: 0.31}")
    assert own.density is not None
    assert own.poisson_ratio is not None
    assert (own.density.value, own.poisson_ratio.value) == (4400.0, 0.31)


@pytest.mark.parametrize(
    ("text", "path", "says"),
    [
        ("{extends: ti-6al-4w}", "material.extends", "no shipped material 'ti-6al-4w'"),
        ("{extends: nothing.yaml}", "material.extends", "there is no file"),
        ("{extends: loop.yaml}", "material.extends", "name one another without end"),
        ("{extends: ti-6al-4v, density: 4400}", "material.density", "has no unit"),
        ("{extends: ti-6al-4v, densty: 4400 kg/m^3}", "material.densty", "unknown key"),
        ("{extend: ti-6al-4v}", "material.extend", "unknown key"),
        ("{extends: 5}", "material.extends", "a text is expected here, not 5"),
        ("{extends: ti-6al-4v, yield_strength: 990 MPa}", "material.yield_strength", "above"),
    ],
)
def test_mistakes_in_an_extended_material_stand_where_they_are(
    spec: Path, text: str, path: str, says: str
) -> None:
    (spec.parent / "loop.yaml").write_text("flexure: 1\nmaterial: {extends: loop.yaml}\n")
    spec.write_text(DESIGN.format(material=text))
    found = refused(spec)
    assert any(f.path == path and says in f.text for f in found), found
    assert all(f.hint for f in found)
