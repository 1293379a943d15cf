"""What the peaks of a vibration push blades by, beside what buckles them."""

from math import pi

import pytest
import yaml

import flexcli
from flexcli.parts.design import DesignSpec
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.as_printed import AsPrinted
from flexcli.parts.requirements.pushed_by_peaks import axial_share, pushed_share
from flexcli.parts.requirements.response_range import uncertain_structure
from flexcli.parts.requirements.shaking import at_once
from flexcli.results import Verdict

E, H, L, B = 114e9, 0.1e-3, 40e-3, 1e-3
MATERIAL = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.3, "yield_strength": "880 MPa",
            "density": "4430 kg/m^3"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "40 mm", "b": "1 mm",
         "blades": 2, "spacing": "40 mm"}  # fmt: skip
EULER = 2.0 * pi**2 * E * B * H**3 / 12.0 / L**2
"""Of both blades between guided ends [N]."""


def spec(mass, axis="y", *, geometry=STAGE, asked=None, level="0.01", material=MATERIAL, **case):
    points = [{"frequency": f, "level": f"{level} g^2/Hz"} for f in ("20 Hz", "2000 Hz")]
    return {
        "flexure": 1, "material": material, "geometry": geometry,
        "mechanism": {"kind": "payload", "mass": mass},
        "cases": {"shake": {"asd": {"profile": {"points": points}, "axis": axis, "q": 10}, **case}},
        "requirements": asked or {"dynamic-yield": 1.1},
    }  # fmt: skip


def check(*given, **how):
    (found,) = flexcli.verdicts(yaml.safe_dump(spec(*given, **how))).checks
    return found


def shares(given):
    """Return both shares of a case, and the peaks of its response."""
    found = DesignSpec.model_validate(given)
    ask = Ask(
        found.material, found.geometry, found.mechanism, found.fixed_sizes(), found.scene("shake"),
        AsPrinted(),
    )  # fmt: skip
    structure = uncertain_structure(ask, ()).structure
    (shaking,) = at_once(ask, lambda _scene, vibration, _rate: vibration.sigma)
    each = (share(ask, structure, shaking.peaks) for share in (pushed_share, axial_share))
    return *each, shaking.peaks(structure)


def test_no_response_passes_whose_peaks_would_buckle_the_blades():
    """Of 1300 times Euler's load the modes told 765 MPa, and a yield of 880 MPa passed."""
    found = check("20 g", level="0.16")
    assert found.verdict is Verdict.UNDECIDED
    assert found.factor > 5.0
    assert found.factor_range[0] == 0.0
    assert check("20 g", "x", level="0.16").verdict is Verdict.PASS
    assert check("2 mg", level="1e-6").verdict is Verdict.PASS


def test_what_fails_by_its_modes_alone_fails():
    assert check("2 kg", level="40").verdict is Verdict.FAIL


def test_a_stage_is_pushed_by_its_peak_over_what_buckles_both_blades():
    pushed, axial, peaks = shares(spec("20 mg", level="1e-4"))
    assert pushed == pytest.approx(peaks["force joint"] / EULER, rel=0.02)
    assert axial == pytest.approx(peaks["axial stress joint"] * B * H / (EULER / 2.0), rel=0.02)


def test_small_peaks_widen_the_range_by_what_they_change():
    given = {"level": "1e-9", "material": {**MATERIAL, "density": "1e-3 kg/m^3"}}
    share, *_ = shares(spec("20 g", **given))
    assert 0.002 < share < 0.1
    widths = []
    for level in ("1e-13", "1e-9"):
        low, high = check("20 g", **{**given, "level": level}).factor_range
        widths.append(high / low - 1.0)
    # the rms of a stress grows by the fourth root of the stiffness
    assert widths[1] - widths[0] == pytest.approx(share / 2.0, rel=0.2)


def test_narrow_blades_are_pushed_out_of_their_plane_by_less():
    """Half as wide as thick, pillars with a free head, pushed half as high: kl tan kl = −2.

    A blade as one piece counts for a fifth more.
    """
    narrow = {**STAGE, "b": "0.05 mm"}
    pushed, axial, peaks = shares(spec("0.1 mg", level="1e-4", geometry=narrow))
    aside = 2.0 * 2.2889**2 * E * H * 0.05e-3**3 / 12.0 / L**2
    assert 1.0 < pushed * aside / peaks["force joint"] < 1.3
    assert pushed > 7.0 * axial
    found = check(
        "0.1 mg", level="1e-4", geometry=narrow, asked={"dynamic-buckling": 1.1},
        ends="clamped-free",
    )  # fmt: skip
    assert found.factor_range[0] < 1.01 / pushed < found.factor / 6.0


def test_without_poisson_s_ratio_blades_are_pushed_by_as_much():
    plain = {name: value for name, value in MATERIAL.items() if name != "poisson_ratio"}
    (with_it, *_), (without, *_) = (
        shares(spec("20 mg", level="1e-4", material=material)) for material in (MATERIAL, plain)
    )
    assert without == pytest.approx(with_it, rel=0.02)


def test_blades_whose_distance_is_not_stated_are_pushed_by_as_much():
    near = {name: value for name, value in STAGE.items() if name != "spacing"}
    (stated, *_), (without, *_) = (
        shares(spec("20 mg", level="1e-4", geometry=geometry)) for geometry in (STAGE, near)
    )
    assert without == pytest.approx(stated, rel=1e-6)


def test_without_poisson_s_ratio_blades_are_told_as_they_shake_along_their_width():
    """What pushes them in space asked for a shear modulus, and a check ended as a wrong spec."""
    plain = {name: value for name, value in MATERIAL.items() if name != "poisson_ratio"}
    found = check("2 g", "z", level="1e-4", material=plain)
    assert found.verdict is Verdict.PASS
    low, high = found.factor_range
    with_it = check("2 g", "z", level="1e-4")
    assert low < with_it.factor < high
