"""Drawings are sound SVG, to scale, and no label lies on another or off the page."""

import re
from functools import cache
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import pytest
from geometries_for_tests import MATERIAL, SAMPLES, spec

from flexcli.engine.draw import drawing
from flexcli.engine.draw_mechanism import mechanism_drawing
from flexcli.parts.design import DesignSpec
from flexcli.report.drawings.plane import drawing_svg
from flexcli.report.drawings.views import VIEWS, view_svg
from flexcli.spec.load import load

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*/flexure.yaml"))
SVG = "{http://www.w3.org/2000/svg}"

LOAD = {"load": {"force": "5 N"}}

WIDTHS = (640.0, 368.0)
"""Of the page, and of a phone [px]."""

NARROW = 0.5
"""Least width of a figure or letter over the size of the type, in the faces asked for."""


@cache
def sample(kind, **changes):
    rotates = not kind.endswith(("stage", "cantilever", "guided-blade"))
    stroke = {"rotation": "2 deg"} if rotates else {"translation": "0.3 mm"}
    part = DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": MATERIAL,
            "geometry": spec(kind, **changes),
            "cases": {"work": {"stroke": stroke, **({} if "torsion" in kind else LOAD)}},
            "requirements": {"yield": 1.5},
        }
    )
    return drawing(part, part.fixed_sizes())


@cache
def example(path, draw=drawing, free=2e-3):
    design = load(path).part
    sizes = design.geometry.sized(dict.fromkeys(design.geometry.free, free))
    return draw(design, sizes)


DRAWN = [pytest.param(lambda kind=kind: sample(kind), id=kind) for kind in SAMPLES] + [
    pytest.param(lambda path=path: example(path), id=path.parent.name) for path in EXAMPLES
]
DRAWN += [
    pytest.param(lambda p=path: example(p, mechanism_drawing), id=f"all of {path.parent.name}")
    for path in EXAMPLES if "parallel-stage" in path.read_text(encoding="utf-8")
]  # fmt: skip
DRAWN += [
    pytest.param(lambda p=path: example(p, free=1e-4), id=f"thin {path.parent.name}")
    for path in EXAMPLES if "linkage" in path.read_text(encoding="utf-8")
]  # fmt: skip


@cache
def pages(make):
    """Return the drawing for each width and from each side, with what XML reads of it."""
    found, title = make(), "a <joint> & more"
    drawn = [drawing_svg(found, title, stress=True, width=width) for width in WIDTHS]
    drawn += [view_svg(found, title, view, stress=True) for view in VIEWS]
    return tuple((svg, ElementTree.fromstring(svg)) for svg in drawn)


def labels(root):
    """Return the room of every text that is not turned: left, top, right, bottom [px]."""
    for text in root.iter(f"{SVG}text"):
        size = 11.5 if text.get("class") == "s" else 12.5
        x, y, wide = float(text.get("x")), float(text.get("y")), NARROW * size * len(text.text)
        left = x - {"start": 0.0, "middle": 0.5, "end": 1.0}[text.get("text-anchor")] * wide
        if text.get("transform") is None:
            yield text.text, (left, y - 0.72 * size, left + wide, y)


@pytest.mark.parametrize("make", DRAWN)
def test_labels_keep_off_each_other_and_on_the_page(make):
    for _, root in pages(make):
        width, height = float(root.get("width")), float(root.get("height"))
        rooms = list(labels(root))
        assert rooms
        for text, (left, top, right, bottom) in rooms:
            assert min(left, top) >= 0.0, text
            assert right <= width, text
            assert bottom <= height, text
        for (one, a), (other, b) in combinations(rooms, 2):
            wide, high = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            assert wide <= 0.0 or high <= 0.0, f"{one!r} lies on {other!r}"


@pytest.mark.parametrize("make", DRAWN)
def test_a_drawing_has_a_title_and_says_what_it_shows(make):
    for svg, root in pages(make):
        assert root.find(f"{SVG}title").text == "a <joint> & more"
        assert "not in the spec" in root.find(f"{SVG}desc").text
        assert not re.search(r"\b(nan|inf)\b", svg)
        assert not re.search(r"(href|src)=", svg), "a drawing fetches nothing"


def test_a_drawing_is_to_scale():
    root = ElementTree.fromstring(drawing_svg(sample("leaf-spring-stage", h=0.4), "stage"))
    heights, scale = [], None
    for path in root.iter(f"{SVG}path"):
        numbers = [float(n) for n in re.findall(r"-?[\d.]+", path.get("d"))]
        xs, ys = numbers[::2], numbers[1::2]
        if path.get("class") == "blade":
            heights.append((max(xs) - min(xs), max(ys) - min(ys)))
        if path.get("class") == "edge" and scale is None and len(xs) == 4:
            scale = max(xs) - min(xs)  # the bar at the foot
    (text,) = [t.text for t in root.iter(f"{SVG}text") if float(t.get("x")) == 24.0 + scale]
    per_mm = scale / float(text.removesuffix(" mm"))
    assert len(heights) == 3
    for wide, high in heights:
        assert high / per_mm == pytest.approx(20.0, rel=1e-3)  # l, rounded to 0.01 px
        assert wide / per_mm == pytest.approx(0.4, abs=0.01)  # h


def test_colour_shows_stress_only_where_it_is_asked():
    found = sample("rcc")
    assert 'class="heat"' in drawing_svg(found, "rcc", stress=True)
    assert 'class="heat"' not in drawing_svg(found, "rcc")


def test_the_magnification_is_on_the_page_and_in_its_description():
    found = sample("rcc")
    svg = drawing_svg(found, "rcc")
    times = re.search(r"displacements ×([\d.]+)<", svg).group(1)
    assert f"displacements × {times}." in svg


STAGE = Path(__file__).parents[2] / "examples" / "force-balanced-stage" / "flexure.yaml"


def test_a_mechanism_is_drawn_with_all_of_its_pivots_masses_and_lengths():
    design = load(STAGE).part
    found = mechanism_drawing(design, design.fixed_sizes())
    for width in WIDTHS:
        svg = drawing_svg(found, "stage", stress=True, width=width)
        said = [text.text for text in ElementTree.fromstring(svg).iter(f"{SVG}text")]
        assert {"P1", "P2", "P3", "P4", "solid 1", "solid 2", "solid 3"} <= set(said)
        assert said.count("17.14 g") == 2
        assert said.count("balance 35.57 g") == 2
        assert "68.12 g" in said
        for length in ("H = 20 mm", "arm = 24.17 mm"):
            assert length in said or f"No room for the names of {length}" in svg
