"""Loading specs: each kind alone, references by name and path, positions, and any content."""

import os
from pathlib import Path
from shutil import copytree
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

import flexcli
from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.geometries import Geometry
from flexcli.parts.material import Material
from flexcli.parts.stroke import Stroke
from flexcli.spec import load as load_module
from flexcli.spec.load import KINDS, load, load_shipped
from flexcli.spec.shipped import FOLDERS, shipped_names, shipped_path

ROOT = Path(__file__).parent.parent.parent
GOOD = Path(__file__).parent / "good"
SHIPPED = [(kind, name) for kind in FOLDERS for name in shipped_names(kind)]

MATERIAL = """flexure: 1
material:
  youngs_modulus: 113.8 GPa
  fatigue_amplitude: {value: 510 MPa, cycles: 1e7}
"""
DESIGN = """flexure: 1
material: MATERIAL
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}
cases:
  work:
    stroke: STROKE
requirements:
  fatigue: 1.5
"""


def design(material: str = "ti-6al-4v", stroke: str = "{rotation: 2 deg, cycles: 1e7}") -> str:
    return DESIGN.replace("MATERIAL", material).replace("STROKE", stroke)


@pytest.fixture
def spec(tmp_path: Path) -> Path:
    return tmp_path / "flexure.yaml"


def refused(path: Path) -> list[Finding]:
    with pytest.raises(SpecError) as raised:
        load(path)
    return raised.value.findings


def only(path: Path) -> Finding:
    (finding,) = refused(path)
    return finding


@pytest.mark.parametrize(("kind", "name"), SHIPPED)
def test_every_shipped_spec_validates(kind: str, name: str) -> None:
    path = shipped_path(kind, name)
    assert path is not None
    assert load(path).kind == kind
    assert load_shipped(kind, name) == load(path).part


def test_materials_and_profiles_are_shipped() -> None:
    assert {"ti-6al-4v"} <= set(shipped_names("material"))
    assert {"gevs-acceptance"} <= set(shipped_names("asd"))


def test_a_shipped_spec_that_does_not_exist_has_a_neighbour() -> None:
    with pytest.raises(SpecError) as raised:
        load_shipped("material", "ti-6al-4w")
    assert raised.value.findings[0].hint == "did you mean 'ti-6al-4v'?"


@pytest.mark.parametrize("path", sorted(ROOT.glob("examples/*/flexure.yaml")), ids=str)
def test_every_example_validates(path: Path) -> None:
    _, loaded, document = load(path)
    assert loaded.flexure == 1
    assert document.position.children["geometry"].file.endswith(".yaml")


@pytest.mark.parametrize(
    ("text", "kind", "model"),
    [
        ("material: {youngs_modulus: 210 GPa}", "material", Material),
        ("stroke: {rotation: 2 deg}", "stroke", Stroke),
        ("geometry: {kind: three-blade, h: free, l: free, b: free}", "geometry", Geometry),
        (
            "asd: {points: [{frequency: 20 Hz, level: 1 g^2/Hz},"
            " {frequency: 2 kHz, level: 1 g^2/Hz}]}",
            "asd",
            ASDProfile,
        ),
    ],
)
def test_each_kind_is_validated_alone(spec: Path, text: str, kind: str, model: type) -> None:
    spec.write_text(f"flexure: 1\n{text}\n")
    loaded = load(spec)
    assert loaded.kind == kind
    assert isinstance(loaded.part, model)
    with pytest.raises(SpecError, match=f"is a spec of kind {kind}, not a design"):
        flexcli.check(spec)


@pytest.mark.parametrize("kind", KINDS)
def test_the_mistakes_of_a_kind_alone_are_found(spec: Path, kind: str) -> None:
    spec.write_text(f"flexure: 1\n{kind}:\n  colour: red\n  colour: blue\n")
    found = refused(spec)
    assert {f.line for f in found} >= {2, 4} or {f.line for f in found} >= {3, 4}
    assert all(f.path.startswith(kind) for f in found)


def test_a_material_is_named_given_by_path_or_written_out(spec: Path) -> None:
    (spec.parent / "sub").mkdir()
    (spec.parent / "sub" / "mine.yml").write_text(MATERIAL)
    (spec.parent / "elsewhere.yaml").write_text(MATERIAL)
    inline = "{youngs_modulus: 113.8 GPa, fatigue_amplitude: {value: 510 MPa, cycles: 1e7}}"
    parts = []
    for material in (
        "sub/mine.yml",
        "./elsewhere.yaml",
        str(spec.parent / "elsewhere.yaml"),
        inline,
    ):
        spec.write_text(design(material))
        parts.append(load(spec).part.material)
    assert all(part == parts[0] for part in parts)
    spec.write_text(design("ti-6al-4v"))
    assert load(spec).part.material == load_shipped("material", "ti-6al-4v")


def test_paths_start_at_the_folder_of_the_spec(
    spec: Path, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    (spec.parent / "mine.yaml").write_text(MATERIAL)
    spec.write_text(design("mine.yaml"))
    monkeypatch.chdir(tmp_path_factory.mktemp("elsewhere"))
    assert load(spec).kind == "design"


def test_a_mistake_in_a_named_file_shows_there(spec: Path) -> None:
    other = spec.parent / "mine.yaml"
    other.write_text(MATERIAL.replace("113.8 GPa", "113.8 kg"))
    spec.write_text(design("mine.yaml"))
    found = only(spec)
    assert (found.file, found.line, found.column) == (str(other), 3, 19)
    assert found.path == "material.youngs_modulus"
    assert found.source_line == "  youngs_modulus: 113.8 kg"


def test_mistakes_in_both_files_are_found_in_one_pass(spec: Path) -> None:
    other = spec.parent / "mine.yaml"
    other.write_text(MATERIAL.replace("113.8 GPa", "113.8"))
    spec.write_text(design("mine.yaml", "no-such-stroke") + "titel: x\ntitel: y\n")
    found = refused(spec)
    assert [(Path(f.file).name, f.line) for f in found] == [
        ("flexure.yaml", 6),
        ("flexure.yaml", 9),
        ("flexure.yaml", 10),
        ("mine.yaml", 3),
    ]


def test_a_file_named_by_two_cases_is_reported_once(spec: Path) -> None:
    (spec.parent / "mine.yaml").write_text("flexure: 1\nstroke: {rotation: 2}\n")
    spec.write_text(
        design(stroke="mine.yaml").replace("  work:", "  rest: {stroke: mine.yaml}\n  work:")
    )
    assert Path(only(spec).file).name == "mine.yaml"


@pytest.mark.parametrize(
    ("material", "says"),
    [
        ("nothing", "there is no shipped material 'nothing'"),
        ("nothing.yaml", "there is no file"),
        ("folder.yaml", "is a folder"),
        ("pipe.yaml", "is a device"),
        ("loop.yaml", "there is no file"),
        ("secret.yaml", "is a link to something else"),
        ("../../../../etc/passwd", "there is no shipped material"),
        ("/dev/zero", "there is no shipped material"),
        ('"nul\\0.yaml"', "there is no file"),
        ("long" * 80 + ".yaml", "there is no file"),
        ("large.yaml", "too large"),
        ("stroke.yaml", "holds stroke"),
        ("only-version.yaml", "holds nothing"),
        ("flexure.yaml", "holds material, geometry, cases, requirements"),
        ("''", "there is no shipped material ''"),
    ],
)
def test_a_reference_that_leads_nowhere_shows_where_it_stands(
    spec: Path, material: str, says: str
) -> None:
    folder = spec.parent
    (folder / "folder.yaml").mkdir()
    os.mkfifo(folder / "pipe.yaml")
    (folder / "loop.yaml").symlink_to(folder / "loop.yaml")
    (folder / "secret").write_text("token: 123\n")
    (folder / "secret.yaml").symlink_to(folder / "secret")
    (folder / "large.yaml").write_bytes(b"#" * 4_000_000)
    (folder / "stroke.yaml").write_text("flexure: 1\nstroke: {rotation: 2 deg}\n")
    (folder / "only-version.yaml").write_text("flexure: 1\n")
    spec.write_text(design(material))
    found = only(spec)
    assert says in found.text
    assert (found.file, found.line, found.column) == (str(spec), 2, 11)
    assert found.path == "material"
    assert found.hint


def test_a_link_to_a_spec_is_followed(spec: Path) -> None:
    (spec.parent / "mine.yaml").write_text(MATERIAL)
    (spec.parent / "link.yaml").symlink_to(spec.parent / "mine.yaml")
    spec.write_text(design("link.yaml"))
    assert load(spec).kind == "design"


def test_a_reference_names_no_further_file(spec: Path) -> None:
    (spec.parent / "mine.yaml").write_text("flexure: 1\nmaterial: other.yaml\n")
    spec.write_text(design("mine.yaml"))
    found = only(spec)
    assert Path(found.file).name == "mine.yaml"
    assert "a mapping is expected here" in found.text


def single(case: str) -> str:
    whole = design()
    start, end = whole.index("cases:"), whole.index("requirements:")
    return whole[:start] + case + whole[end:]


def test_a_single_case_stands_at_the_top(spec: Path) -> None:
    spec.write_text(single("stroke: {rotation: 2 deg, cycles: 1e7}\n"))
    loaded = load(spec).part
    assert list(loaded.cases) == ["design"]


def test_the_mistakes_of_a_single_case_show_as_it_is_written(spec: Path) -> None:
    spec.write_text(single("stroke: {rotation: 2, cycles: 1e7}\n"))
    found = only(spec)
    assert (found.line, found.column, found.path) == (4, 20, "stroke.rotation")


def test_what_does_not_fit_in_a_single_case_shows_as_it_is_written(spec: Path) -> None:
    spec.write_text(single("stroke: {translation: 2 mm, cycles: 1e7}\n"))
    found = next(f for f in refused(spec) if f.line == 4)
    assert (found.column, found.path) == (1, "stroke")


def test_problems_of_cases_and_of_requirements_are_found_in_one_pass(spec: Path) -> None:
    text = design().replace("  work:", "  rest: {stroke: {translation: 1 mm}}\n  work:")
    spec.write_text(text.replace("fatigue: 1.5", "fatigue: 1.5\n  frequency: {min: 1 Hz}"))
    assert [f.path for f in refused(spec)] == ["cases.rest.stroke", "requirements.frequency"]


def test_a_missing_version_does_not_hide_other_mistakes(spec: Path) -> None:
    spec.write_text(design().removeprefix("flexure: 1\n").replace("0.1 mm", "0.1"))
    assert len(refused(spec)) == 2


def test_another_version_hides_them(spec: Path) -> None:
    spec.write_text(design().replace("flexure: 1", "flexure: 7").replace("0.1 mm", "0.1"))
    assert only(spec).path == "flexure"


def test_a_file_that_is_no_spec_gives_one_finding(spec: Path) -> None:
    spec.write_text("services:\n  web: {image: nginx}\n  web: {image: nginx2}\n")
    assert {f.text for f in refused(spec)} >= {"'flexure' is missing"}


def test_the_values_of_a_document_include_what_it_names() -> None:
    _, loaded, document = load(GOOD / "force-balanced-stage.yaml")
    assert document.value["material"]["name"] == loaded.material.name
    place, path = document.position.closest(("material", "youngs_modulus"))
    assert path == ("material", "youngs_modulus")
    assert place.file == str(shipped_path("material", "ti-6al-4v-course"))
    assert document.lines[place.file][place.line - 1].lstrip().startswith(("value", "youngs"))


def test_adapters_are_built_once(spec: Path) -> None:
    spec.write_text(design())
    load(spec)
    misses = load_module._adapter.cache_info().misses
    load(spec)
    assert load_module._adapter.cache_info().misses == misses


# --- any content ---------------------------------------------------------------------------

WHOLE = yaml.safe_load((GOOD / "vibrating-stage-with-its-own-profile.yaml").read_text())


def paths(value: Any, here: tuple[str | int, ...] = ()) -> list[tuple[str | int, ...]]:
    if not isinstance(value, dict | list):
        return [here]
    items = value.items() if isinstance(value, dict) else enumerate(value)
    return [here, *(path for key, inner in items for path in paths(inner, (*here, key)))]


def put(value: Any, path: tuple[str | int, ...], new: Any) -> Any:
    if not path:
        return new
    copy = dict(value) if isinstance(value, dict) else list(value)
    copy[path[0]] = put(value[path[0]], path[1:], new)
    return copy


WORDS = st.sampled_from(
    ["free", "rcc", "payload", "solid-2", "5 mm", "-5 mm", "1e-30 m", "1e30 m", "0 mm", "1 g",
     "89.9999999 deg", "1e30 N", "1e30 Hz", "1e-30 kg", "parts/titanium.yaml", "ti-6al-4v"]
)  # fmt: skip
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | WORDS | st.text(max_size=8),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(["kind", "free", "value", "x", "points"]), inner, max_size=3
        )
    ),
    max_leaves=6,
)


def load_or_refuse(spec: Path, value: Any) -> None:
    """Load a value as a spec; anything but success and findings with hints fails the test."""
    spec.write_text(yaml.safe_dump(value, allow_unicode=True), encoding="utf-8")
    findings = [Finding("", "accepted", "")]
    try:
        load(spec)
    except SpecError as error:
        findings = error.findings
    assert findings
    assert all(f.text == "accepted" or f.hint for f in findings)


@pytest.fixture(scope="module")
def scratch(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("any")
    copytree(GOOD / "parts", folder / "parts")
    return folder / "flexure.yaml"


@pytest.mark.slow
@settings(max_examples=300)
@given(st.sampled_from(paths(WHOLE)), VALUES)
def test_any_value_anywhere_is_accepted_or_refused(
    scratch: Path, path: tuple[str | int, ...], new: Any
) -> None:
    load_or_refuse(scratch, put(WHOLE, path, new))


@pytest.mark.slow
@given(VALUES)
def test_any_value_is_accepted_or_refused(scratch: Path, value: Any) -> None:
    load_or_refuse(scratch, {"flexure": 1, "material": value})
    load_or_refuse(scratch, value)


EXTENTS = st.floats(min_value=-30, max_value=30).map(lambda power: f"{10.0**power!r} m")


@pytest.mark.slow
@given(EXTENTS, EXTENTS, EXTENTS, EXTENTS, st.floats(min_value=1e-9, max_value=89.999999))
def test_any_size_is_accepted_or_refused(
    scratch: Path,
    h: str,
    l: str,
    b: str,
    p: str,
    half_angle: float,
) -> None:
    geometry = {"kind": "rcc", "p": p, "half_angle": f"{half_angle!r} deg", "h": h, "l": l, "b": b}
    load_or_refuse(scratch, put(WHOLE, ("geometry",), geometry))
