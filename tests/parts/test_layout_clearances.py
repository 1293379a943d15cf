"""Blades of a drawing that stand in each other's way, by hand-made geometry."""

from math import cos, radians, sin

import pytest
import yaml

import flexcli


def spec(blades, **more):
    """Return a spec of blades (between, from, to, height), ends in mm, of h = 0.2 and b = 4 mm."""
    drawn = {
        f"b{k}": {"between": list(between), "from": [f"{each} mm" for each in start],
                  "to": [f"{each} mm" for each in end], "h": "0.2 mm", "b": "4 mm", "z": f"{z} mm"}
        for k, (between, start, end, z) in enumerate(blades)
    }  # fmt: skip
    geometry = {"kind": "layout", "bodies": {"stage": {"at": ["0 mm", "0 mm"]},
                "link": {"at": ["20 mm", "20 mm"]}}, "blades": drawn, "moving": "stage",
                "motion": "rotation"}  # fmt: skip
    return {
        "flexure": 1, "title": "drawn", "material": {"youngs_modulus": "200 GPa"},
        "geometry": geometry, "requirements": {"stiffness": {"min": "1e-9 N*m/rad"}}, **more,
    }  # fmt: skip


def overlaps(blades):
    """Return the texts of the warnings of blades that meet."""
    notes = flexcli.check(yaml.safe_dump(spec(blades))).warnings
    return [note.text for note in notes if note.code == "blades-meet"]


BASE, LINK = ("ground", "stage"), ("ground", "link")
HOLDS = (LINK, (20, 20), (40, 20), 0), (LINK, (20, 30), (40, 30), 0)
"""Blades of the second body, away from the others."""


@pytest.mark.parametrize(("z", "meet"), [(0.0, True), (3.9, True), (4.0, False), (-4.0, False)])
def test_blades_that_cross_in_one_plane_are_told_unless_they_pass_beside_each_other(z, meet):
    crossed = (BASE, (-5, -5), (5, 5), 0), (BASE, (-5, 5), (5, -5), z)
    found = overlaps([*crossed, *HOLDS])
    assert len(found) == meet
    assert all("blades b0 and b1 overlap by 200 µm" in text for text in found)


@pytest.mark.parametrize(("apart", "meet"), [(0.19, True), (0.21, False)])
def test_parallel_blades_need_their_thickness_between_them(apart, meet):
    row = (BASE, (0, 0), (10, 0), 0), (BASE, (0, apart), (10, apart), 0)
    assert bool(overlaps([*row, *HOLDS])) is meet


@pytest.mark.parametrize(("degrees", "meet"), [(90, False), (20, False), (8, True)])
def test_blades_that_end_in_one_point_of_a_body_may_do_so(degrees, meet):
    """A tenth of 10 mm from it their middles are 2 mm · sin(half the angle) apart, or 0.2 mm."""
    ends = [(10 * cos(radians(each)), 10 * sin(radians(each))) for each in (0, degrees)]
    v = [(BASE[::-1], (0, 0), end, 0) for end in ends]
    assert bool(overlaps([*v, *HOLDS])) is meet


@pytest.mark.parametrize(("end", "meet"), [((4.85, 5), True), ((4.5, 5), False)])
def test_a_blade_that_ends_at_the_face_of_another_is_told(end, meet):
    tee = (BASE, (5, 0), (5, 10), 0), (LINK, (0, 5), end, 0)
    assert bool(overlaps([*tee, *HOLDS])) is meet


def test_the_gap_of_a_process_is_asked_of_drawn_blades():
    row = (BASE, (0, 0), (10, 0), 0), (BASE, (0, 1), (10, 1), 0)
    words = spec([*row, *HOLDS], manufacturing={"least_gap": "1 mm"})
    (worst, *_) = sorted(
        (c for c in flexcli.check(yaml.safe_dump(words)).checks if "gap" in c.name),
        key=lambda check: check.factor,
    )
    assert worst.factor == pytest.approx(0.8)
    assert worst.verdict == "fail"
