"""The page of a design: sound, self-contained, legible HTML that says what the result says."""

import re
from collections import Counter
from functools import cache
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import pytest

from flexcli import api
from flexcli.report.page import design_page, folder_page, folder_row
from flexcli.report.plots.of_dossier import plots
from flexcli.report.plots.vibration import stops_plots, transfer_plot
from flexcli.results import Status
from flexcli.results.stops import StopsResult, StopSweep, SweepStep

ROOT = Path(__file__).parents[2]
VOID = {"meta", "link", "br", "hr", "img", "input"}
GIVEN = ["wittrick-crossing", "compound-stage", "torsion-bar", "force-balanced-stage"]
SIZED = ["rocket-parallel-stage"]
STOPS = ROOT / "examples" / "boundary-control" / "flexure.yaml"


@cache
def gathered(name):
    """Return the dossier of an example; free sizes are chosen by the formulas as printed."""
    return api.dossier(
        ROOT / "examples" / name / "flexure.yaml", model="source" if name in SIZED else None
    )


@cache
def page(name):
    return design_page(gathered(name), "1 January 2026")


class Outline(HTMLParser):
    """Keeps ids, targets, what is fetched, and tags that do not close."""

    def __init__(self):
        super().__init__()
        self.open, self.faults, self.ids, self.targets, self.fetched = [], [], [], [], []
        self.text = []

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.ids += [given["id"]] if "id" in given else []
        for key in ("href", "src", "xlink:href"):
            if key in given:
                (self.targets if given[key].startswith("#") else self.fetched).append(given[key])
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(tag)

    def handle_data(self, data):
        self.text.append(data)


def outline(html):
    found = Outline()
    found.feed(html)
    found.close()
    return found


@pytest.mark.parametrize("name", [*GIVEN, *SIZED])
def test_a_page_is_whole_and_fetches_nothing(name):
    found = outline(page(name))
    assert not found.faults
    assert not found.open
    assert not found.fetched
    assert not re.search(r"@import|url\((?!#)|<script", page(name))
    assert [i for i, n in Counter(found.ids).items() if n > 1] == []
    assert {target[1:] for target in found.targets} <= set(found.ids)
    assert len(page(name).encode()) < 1_000_000


@pytest.mark.parametrize("name", [*GIVEN, *SIZED])
def test_a_page_says_every_verdict_value_and_warning(name):
    said = re.sub(r"\s+", " ", " ".join(outline(page(name)).text))
    result = gathered(name).result
    assert result.status.value.upper() in said
    for row in result.checks:
        assert row.full_name in said
        assert f"{row.factor:.4g}" in said
        assert f"{row.verdict.value.upper()} " in said
    for key, value in result.values.items():
        assert key in said
        assert value.label in said
    for note in result.warnings:
        assert re.sub(r"\s+", " ", note.text) in said


def test_what_comes_from_a_spec_is_text_never_markup():
    found = gathered("wittrick-crossing")
    evil = '<script>alert("x")</script>'
    html = design_page(
        type(found)(
            type(found.result)("check", evil, Status.FAIL, title=evil), evil, drawing=found.drawing
        ),
        "today",
    )
    assert "<script" not in html
    assert evil in unescape(html)


def test_equations_have_the_numbers_of_the_design_put_in():
    found = gathered("wittrick-crossing")
    E, h, l, b, p = 210e9, 0.1e-3, 20e-3, 5e-3, -2.54e-3
    delta, I = p / l, b * h**3 / 12
    want = 8 * E * I / l * (3 * delta**2 + 3 * delta + 1)  # the lecture's
    (stiffness,) = [one for one in found.equations if "stiffness" in one.title]
    assert stiffness.gives[0].value == pytest.approx(want, rel=1e-12)
    assert {s.name: s.value for s in stiffness.symbols}["p"] == p


def luminance(colour):
    digits = colour.lstrip("#")
    digits = digits if len(digits) == 6 else "".join(2 * d for d in digits)
    parts = [int(digits[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("mode", [0, 1], ids=["light", "dark"])
def test_text_stands_out_from_its_paper(mode):
    """WCAG 2.2 asks 4.5 of text (success criterion 1.4.3)."""
    blocks = re.findall(r":root\{([^}]*)\}", page("wittrick-crossing"))
    colours = dict(re.findall(r"--(\w+):(#\w+)", blocks[mode]))
    paper = luminance(colours["paper"])
    for name in ("ink", "ink2", "ink3", "fail", "undecided", "pass", "motion", "force"):
        one, other = sorted((paper, luminance(colours[name])))
        assert (other + 0.05) / (one + 0.05) > 4.5, name


def test_a_design_has_the_plots_that_it_has_data_for():
    names = {plot.name for plot in plots(gathered("rocket-parallel-stage"))}
    assert names >= {"stress", "stiffness", "shift", "support", "along", "spectrum", "region"}
    assert {plot.name for plot in plots(gathered("torsion-bar"))} == set()


def test_plots_keep_their_style_and_names_to_themselves():
    for plot in plots(gathered("rocket-parallel-stage")):
        assert "<style" not in plot.svg
        assert "<metadata" not in plot.svg
        assert "DOCTYPE" not in plot.svg
        assert "var(--ink)" in plot.svg


def test_the_spectrum_has_miles_at_every_frequency():
    (spectrum,) = gathered("rocket-parallel-stage").spectra
    g = 9.80665
    k = len(spectrum.natural) - 1
    f, q = spectrum.natural[k], spectrum.q
    level = spectrum.level[-1]
    assert spectrum.miles[k] == pytest.approx((3.141592653589793 / 2 * f * q * level) ** 0.5)
    assert max(spectrum.exact) / g < 1.2 * max(spectrum.miles) / g


def test_the_region_holds_the_chosen_design_where_its_margins_do():
    found = gathered("rocket-parallel-stage")
    region = found.region
    at = [min(range(len(line)), key=lambda k, line=line, c=c: abs(line[k] / c - 1))
          for line, c in ((region.x, region.chosen[0]), (region.y, region.chosen[1]))]  # fmt: skip
    for name, rows in region.margins.items():
        # the chosen design passes as printed, and lies in the middle of the region
        assert rows[at[1]][at[0]] > 0.97, name


def test_a_folder_leads_to_its_designs_the_worst_first():
    rows = [
        folder_row(gathered(name).result, f"{name}.html") for name in ("wittrick-crossing", *SIZED)
    ]
    failing = folder_row(
        type(gathered("wittrick-crossing").result)("check", "c.yaml", Status.FAIL), "c.html"
    )
    html = folder_page("stage designs", [*rows, failing], "today")
    found = outline(html)
    assert not found.faults
    assert found.fetched[0] == "c.html"
    assert set(found.fetched) == {"c.html", "wittrick-crossing.html", "rocket-parallel-stage.html"}
    assert "1 fail" in html


def test_the_transfer_of_a_balanced_stage_is_drawn_before_and_after():
    balanced = api.balance(ROOT / "examples" / "force-balanced-stage" / "flexure.yaml").balance
    svg = transfer_plot(balanced).svg
    assert "frequency, Hz" in svg
    assert "after balancing" in svg


def test_a_response_with_stops_has_both_ways_and_what_did_not_settle():
    steps = [
        SweepStep(up, f, 1e-4 * f, 0.0, 0.0, settled=f < 30.0)
        for up in (True, False)
        for f in (10.0, 20.0, 30.0)
    ]
    sweep = StopSweep("sine", "", tuple(steps), None, None, (18.0, 22.0))
    place = api.stops(STOPS, simulate=False).stops.chosen
    (plot,) = stops_plots(StopsResult("placed", place, (place,), sweeps=(sweep,)))
    assert plot.title.endswith("sine")
    for label in ("up", "down"):
        assert f">{label}</text>" in plot.svg
