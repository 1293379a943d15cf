"""Plots stand where their numbers do, and no text of them lies on another or off the page."""

import re
from itertools import combinations
from xml.etree import ElementTree

import numpy as np
import pytest

from flexcli.report.plots.chart import Axis, Chart, standalone
from flexcli.report.plots.sizes import front_plot, region_plot
from flexcli.report.plots.stroke import stroke_plots
from flexcli.report.plots.tolerances import tolerances_plots
from flexcli.results.dossier import Region
from flexcli.results.simulation import SpacePoint, SpaceSweep
from flexcli.results.tolerances import Histogram, ToleranceRow, TolerancesResult, YieldRow
from flexcli.results.trade_off import Front, FrontPoint

SVG = "{http://www.w3.org/2000/svg}"

ENLARGED = 14.5
"""Type on phones [px], as the page has it."""

NARROW = 0.5
"""Least width of a figure or letter over the size of the type, in the faces asked for."""


def numbers(path):
    return np.array([float(n) for n in re.findall(r"-?[\d.]+", path.get("d"))]).reshape(-1, 2)


def inked(svg):
    """Return the lines of an SVG that are drawn in ink, as points of the page."""
    paths = ElementTree.fromstring(svg).iter(f"{SVG}path")
    return [numbers(p) for p in paths if p.get("stroke") == "var(--ink)"]


def texts(svg):
    return [t.text for t in ElementTree.fromstring(svg).iter(f"{SVG}text")]


def place_of(svg, text, key):
    """Return where along an axis the number stands that says so."""
    found = [t for t in ElementTree.fromstring(svg).iter(f"{SVG}text") if t.text == text]
    return float(found[0].get(key))


def rooms(svg):
    for text in ElementTree.fromstring(svg).iter(f"{SVG}text"):
        wide = NARROW * ENLARGED * len(text.text)
        x, y = float(text.get("x")), float(text.get("y"))
        left = x - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.get("text-anchor")] * wide
        yield text.text, (left, y - 0.72 * ENLARGED, left + wide, y)


def assert_legible(svg):
    _, _, width, height = map(float, ElementTree.fromstring(svg).get("viewBox").split())
    found = list(rooms(svg))
    assert found
    for text, (left, top, right, bottom) in found:
        assert min(left, top) >= 0.0, text
        assert right <= width, text
        assert bottom <= height, text
    for (one, a), (other, b) in combinations(found, 2):
        wide, high = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
        assert wide <= 0.0 or high <= 0.0, f"{one!r} lies on {other!r}"


@pytest.mark.parametrize("log", [False, True])
def test_a_curve_stands_where_the_numbers_of_its_axes_say(log):
    values = np.array([10.0, 100.0, 1000.0]) if log else np.array([0.0, 10.0, 20.0])
    chart = Chart(Axis("x, mm", log=log), Axis("y, N", log=log))
    chart.curve(values, values[::-1])
    svg = chart.svg()
    (line,) = inked(svg)
    for value, (x, _) in zip((values[0], values[-1]), (line[0], line[-1]), strict=True):
        assert x == pytest.approx(place_of(svg, f"{value:g}", "x"), abs=0.02)  # of a pixel
    assert line[0][1] < line[-1][1], "what is larger stands higher"


def test_a_gap_in_the_numbers_is_one_in_the_curve():
    chart = Chart(Axis("x"), Axis("y"))
    chart.curve([0, 1, 2, 3, 4], [1.0, 2.0, np.nan, 2.0, 1.0])
    assert len(inked(chart.svg())) == 2


def test_a_level_curve_has_an_axis_that_does_not_magnify_its_rounding():
    chart = Chart(Axis("x"), Axis("y"))
    chart.curve([0.0, 1.0], [5.0, 5.0 * (1 + 1e-13)])
    (line,) = inked(chart.svg())
    assert line[0][1] == line[1][1]


@pytest.mark.parametrize("log", [False, True])
@pytest.mark.parametrize("ends", [(1e-9, 3e4), (0.97, 1.04), (2.0, 7.0), (36.812e6, 36.84e6)])
def test_the_numbers_of_an_axis_are_several_and_legible(log, ends):
    chart = Chart(Axis("stiffness, N/m", log=log), Axis("largest error", log=log))
    chart.curve(ends, ends, "a curve of a long name that says what it is")
    chart.note("a note", *ends)
    assert_legible(chart.svg())
    told = [text for text in texts(chart.svg()) if re.match(r"[−\d]", text)]
    assert len(told) >= 4


def test_what_stands_alone_names_its_colours():
    chart = Chart(Axis("x"), Axis("y"))
    chart.curve([0, 1], [0, 1])
    svg = standalone(chart.svg())
    assert "var(" not in svg
    assert ElementTree.fromstring(svg).get("width") == "432"


def tolerance_run(asked):
    histogram = Histogram((0.9, 1.0, 1.1, 1.2), (0.1, 0.6, 0.3))
    row = YieldRow(
        "yield (fatigue-amplitude), take-off", 0.9, (0.85, 0.95), 0.0, 1.05,
        first={"h": 0.6, "l": 0.1}, total={"h": 0.8, "l": 0.3}, histogram=histogram,
    )  # fmt: skip
    rows = tuple(ToleranceRow(n, "m", 1e-3, 0.9e-3, 1.1e-3, "uniform", s)
                 for n, s in (("l", 0.91), ("h", 0.97)))  # fmt: skip
    together = row._replace(name="together", histogram=None, first={}, total={})
    return TolerancesResult(asked, rows, together, (row,), 1000, 100, 0, 0.95, "fits")


@pytest.mark.parametrize("asked", [None, 0.8, 0.99])
def test_a_tolerance_run_shows_yields_causes_parts_and_what_to_narrow_first(asked):
    found = {plot.name: plot for plot in tolerances_plots(tolerance_run(asked))}
    assert set(found) == {"yields", "narrowing", "parts", "causes"}
    for plot in found.values():
        assert_legible(plot.svg)
    assert "together: 90.0 % [85.0 %, 95.0 %]" in texts(found["yields"].svg)
    first = [text for text in texts(found["narrowing"].svg) if ":" in text]
    assert first == ["h: 97.0 %", "l: 91.0 %"], "the one that gains most comes first"
    colour = {None: "ink2", 0.8: "pass", 0.99: "fail"}[asked]
    assert f'fill="var(--{colour})"' in found["yields"].svg
    shaded = ElementTree.fromstring(found["parts"].svg).iter(f"{SVG}path")
    columns = [numbers(p) for p in shaded if p.get("fill") == "var(--ink3)"]
    heights = [np.ptp(column[:, 1]) for column in columns]
    assert np.array(heights) / heights[1] == pytest.approx([1 / 6, 1.0, 0.5], abs=1e-3)


def test_a_front_marks_its_knee():
    points = tuple(FrontPoint(1e-6 / x, 1e-3 * x, None, {}, "", {}) for x in (1.0, 1.2, 2.0, 5.0))
    for knee in (1, None):
        front = Front("volume", "m^3", "parasitic_shift", "m", points, knee, False, ())
        plot = front_plot(front)
        assert_legible(plot.svg)
        assert ("knee" in texts(plot.svg)) is (knee is not None)
        assert plot.svg.count("<circle") == len(points) + (knee is not None)
        assert "not proved" in plot.caption


def test_a_region_is_shaded_where_all_of_its_margins_hold():
    x = np.geomspace(0.1e-3, 1e-3, 30)
    margins = {"thin": x[None, :] / 0.2e-3 + 0.0 * x[:, None],
               "short": 0.5e-3 / x[:, None] + 0.0 * x[None, :]}  # fmt: skip
    rows = {name: tuple(map(tuple, m.tolist())) for name, m in margins.items()}
    region = Region(("h", "l"), tuple(x), tuple(x), rows, (0.3e-3, 0.3e-3))
    svg = region_plot(region).svg
    assert_legible(svg)
    assert {"thin", "short"} <= set(texts(svg))
    paths = ElementTree.fromstring(svg).iter(f"{SVG}path")
    (area,) = [numbers(p) for p in paths if p.get("fill") == "var(--hair)"]
    upright, level = sorted(inked(svg), key=lambda line: np.ptp(line[:, 0]))
    # h ≥ 0.2 mm and l ≤ 0.5 mm: right of one line, below the other; a straight edge to 0.5 px
    assert area[:, 0].min() == pytest.approx(upright[:, 0].mean(), abs=0.5)
    assert area[:, 1].min() == pytest.approx(level[:, 1].mean(), abs=0.5)


def test_a_stroke_in_space_has_all_six_support_stiffnesses_but_the_drives_own():
    names = SpacePoint._fields
    each = dict.fromkeys(names, 1.0) | {"blade": "a", "k_y": float("inf")}
    points = tuple(SpacePoint(**each | {"travel": t, "k_x": 1e6 * (2 + t)}) for t in (-1.0, 0, 1.0))
    found = {p.name: p for p in stroke_plots(SpaceSweep("work", "translation", points))}
    assert set(found) == {"stress", "stiffness", "shift", "support"}
    said = texts(found["support"].svg)
    assert {"along x", "along z", "about x", "about y", "about z"} <= set(said)
    assert "along y" not in said, "the drive holds it"
    driven = SpaceSweep("work", "translation", points, drive="y")
    found |= {p.name: p for p in stroke_plots(driven)}
    assert "along y" in texts(found["support"].svg), "its own stiffness, where the drive is along y"
    for plot in found.values():
        assert_legible(plot.svg)
