"""``flexure report`` and ``flexure plot`` as a user runs them."""

from pathlib import Path
from xml.etree import ElementTree

from matplotlib.image import imread

EXAMPLES = Path(__file__).parents[2] / "examples"
WITTRICK = EXAMPLES / "wittrick-crossing" / "flexure.yaml"
NECKED = EXAMPLES / "necked-down-stage" / "flexure.yaml"

UNKNOWN = "material: {youngs_modulus: 210 GPa, admissible_stress: 800 MPa}"
"""A material of no known shear modulus."""


def test_report_writes_a_page_and_ends_as_check_does(flexure, tmp_path):
    done = flexure("report", str(WITTRICK), "-o", "it.html")
    assert done.returncode == flexure("check", str(WITTRICK)).returncode
    html = (tmp_path / "it.html").read_text(encoding="utf-8")
    assert html.startswith("<!doctype html>")
    again = flexure("report", str(WITTRICK), "-o", "it.html")
    assert again.returncode == 2
    assert "--force" in again.stderr


def test_a_report_of_several_has_an_index(flexure, tmp_path):
    done = flexure("report", str(WITTRICK), str(NECKED), "-o", "pages")
    assert done.returncode == 1  # the necked-down stage fails, as its README says
    index = (tmp_path / "pages" / "index.html").read_text(encoding="utf-8")
    for name in ("wittrick-crossing-flexure.html", "necked-down-stage-flexure.html"):
        assert name in index
        assert (tmp_path / "pages" / name).exists()


def test_a_spec_that_cannot_be_read_has_no_page(flexure, tmp_path):
    (tmp_path / "bad.yaml").write_text("flexure: 1\nmaterail: steel\n", encoding="utf-8")
    done = flexure("report", "bad.yaml", "-o", "it.html")
    assert done.returncode == 2
    assert not (tmp_path / "it.html").exists()


def test_plot_lists_what_a_design_has_and_writes_one(flexure, tmp_path):
    listed = flexure("plot", str(WITTRICK))
    assert listed.returncode == 0
    for name in ("margins", "stress", "stiffness", "shift", "support", "along"):
        assert f"\n{name} " in f"\n{listed.stdout}"
    done = flexure("plot", str(WITTRICK), "shift", "-o", "shift.svg")
    assert done.returncode == 0
    svg = ElementTree.parse(tmp_path / "shift.svg").getroot()
    assert svg.tag.endswith("svg")
    assert "var(--" not in (tmp_path / "shift.svg").read_text(encoding="utf-8")
    assert flexure("plot", str(WITTRICK), "shift", "-o", "shift.png").returncode == 0
    edge = imread(tmp_path / "shift.png")[0]
    assert (edge == 1.0).all(), "a plot stands on white, whatever shows it"
    wrong = flexure("plot", str(WITTRICK), "shfit")
    assert wrong.returncode == 2
    assert "margins" in wrong.stderr


def test_support_over_the_stroke_is_plotted_in_six_axes_or_says_why_not(flexure, tmp_path):
    axes = [f"{way} {axis}" for way in ("along", "about") for axis in "xyz"]
    done = flexure("plot", str(WITTRICK), "support", "-o", "six.svg")
    assert (done.returncode, done.stderr) == (0, "")
    svg = (tmp_path / "six.svg").read_text(encoding="utf-8")
    assert all(f">{axis}<" in svg for axis in axes)
    spec = WITTRICK.read_text(encoding="utf-8").replace("material: steel-lecture", UNKNOWN)
    (tmp_path / "flexure.yaml").write_text(spec, encoding="utf-8")
    done = flexure("plot", "flexure.yaml", "support", "-o", "three.svg")
    assert done.returncode == 0
    assert "poisson_ratio" in done.stderr
    svg = (tmp_path / "three.svg").read_text(encoding="utf-8")
    drawn = [axis for axis in axes if f">{axis}<" in svg]
    assert drawn == ["along x", "along y", "about z"]
