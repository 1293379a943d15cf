"""The notebooks of the documentation run, and results show themselves as notebooks ask them to."""

import json
import runpy
from pathlib import Path
from xml.etree import ElementTree

import pytest

import flexcli
from flexcli.results import Status

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.py"))
WITTRICK = ROOT / "examples" / "wittrick-crossing" / "flexure.yaml"


@pytest.fixture(scope="module")
def ran():
    """Return the names that each notebook leaves, run from the repository's folder."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(ROOT)
        return {path.stem: runpy.run_path(str(path)) for path in NOTEBOOKS}


def test_there_are_notebooks_and_each_has_prose_and_code():
    assert len(NOTEBOOKS) == 3
    for path in NOTEBOOKS:
        text = path.read_text(encoding="utf-8")
        assert text.count("# %% [markdown]") >= 2
        assert text.count("# %%\n") >= 2


@pytest.mark.slow
def test_the_sized_stage_of_the_notebook_holds_when_it_is_judged_again(ran):
    names = ran["size_a_blade"]
    assert names["sizing"].status is Status.PASS
    assert flexcli.check(names["design"]).status is Status.PASS


def test_the_factor_of_the_study_falls_as_the_blades_get_thicker(ran):
    rows = ran["thickness_study"]["rows"]
    products = [row["h [µm]"] * row["factor"] for row in rows]
    # σ = 3 E h f/l² at a stroke f; what stretching adds to it is of the next order in f/l
    assert products == pytest.approx([products[0]] * len(products), rel=0.02)


def test_the_stroke_of_the_notebook_covers_both_ends(ran):
    points = ran["follow_the_stroke"]["stroke"].records("sweeps.points")
    travels = [point["travel"] for point in points]
    assert len(travels) == 5
    assert travels[0] == -travels[-1]


def test_a_result_as_a_mapping_is_what_the_command_line_prints(inside_root):
    result = flexcli.check(WITTRICK)
    said = result.to_dict()
    printed = inside_root("check", str(WITTRICK), "--format", "json")
    for document in (said, printed):
        for check in document["checks"]:
            check.pop("cost")
        document.pop("cost")
    assert json.loads(json.dumps(said)) == printed


def test_every_table_of_a_result_is_rows_of_one_shape():
    result = flexcli.simulate(WITTRICK, points=3)
    assert {"values", "sweeps", "sweeps.points"} <= {*result.tables}
    for name in result.tables:
        rows = result.records(name)
        assert rows
        assert {frozenset(row) for row in rows} == {frozenset(rows[0])}, name
    assert result.records("sweeps.points")[0]["case"] == result.records("sweeps")[0]["case"]
    with pytest.raises(KeyError):
        result.records("sweep")


def test_a_notebook_is_shown_verdict_and_margins_and_a_picture():
    found = flexcli.dossier(WITTRICK)
    html = ElementTree.fromstring(f"<div>{found.result._repr_html_()}</div>")
    said = " ".join("".join(html.itertext()).split())
    assert found.result.status.value.upper() in said
    for check in found.result.checks:
        assert check.full_name in said
    assert "<svg" in found._repr_html_()
    svg = ElementTree.fromstring(flexcli.drawing(WITTRICK)._repr_svg_())
    assert svg.tag.endswith("svg")


def test_what_asks_nothing_shows_its_values():
    html = flexcli.balance(ROOT / "examples" / "linear-stage" / "flexure.yaml")._repr_html_()
    assert html.count("<tr>") > 5


def test_a_title_is_text_for_a_notebook_and_no_markup():
    text = WITTRICK.read_text(encoding="utf-8")
    result = flexcli.validate(text.replace("title: ", "title: <script>alert(1)</script> "))
    assert "<script>" not in result._repr_html_()
