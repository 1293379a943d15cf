"""A tip mass on a cantilever: its frequencies, its stress, and what it refuses."""

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError
from stop_designs import LENGTH, MASS, THICKNESS, E, I, stopped

from flexcli.engine.balance import balance
from flexcli.engine.check import check
from flexcli.engine.response import respond
from flexcli.errors import SolveError
from flexcli.formulas.handbook.tip_mass import massless_frequencies
from flexcli.formulas.single_blade import force_stress
from flexcli.numerics.modes import natural_modes
from flexcli.parts.design import DesignSpec
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.requirements import Requirements

BODY = {"kind": "tip-mass", "mass": "8 g", "offset": "5 mm", "inertia": "200 g*mm^2"}
FLAT = [{"frequency": "20 Hz", "level": "0.01 g^2/Hz"},
        {"frequency": "2 kHz", "level": "0.01 g^2/Hz"}]  # fmt: skip
RANDOM = {"launch": {"asd": {"profile": {"points": FLAT}, "q": 30}}}


@given(st.integers(-30, 300), st.integers(0, 300))
def test_its_first_mode_is_that_of_the_body_beyond_the_end(offset, gyration):
    c, J = offset / 100 * LENGTH, MASS * (gyration / 100 * LENGTH) ** 2
    body = TipMass(kind="tip-mass", mass="8.07 g", offset=f"{c!r} m", inertia=f"{J!r} kg*m^2")
    first, _ = massless_frequencies(E=E, I=I, L=LENGTH, m=MASS, c=c, J=J)
    ours = sqrt(3 * E * I / LENGTH**3 / body.equivalent_mass(LENGTH)) / (2 * pi)
    assert ours == pytest.approx(float(first), rel=1e-9)


def test_its_structure_has_both_modes_and_the_stress_at_the_clamp():
    design = stopped(mechanism={k: v for k, v in BODY.items() if k != "kind"})
    sizes = design.fixed_sizes()
    found = design.mechanism.structure(design.geometry, design.material.elastic, sizes, None)
    modes = natural_modes(found.stiffness, found.mass).angular[:2]  # the third is along the blade
    expected = massless_frequencies(E=E, I=I, L=LENGTH, m=8e-3, c=5e-3, J=2e-7)
    assert sorted(modes / (2 * pi)) == pytest.approx([float(f) for f in expected], rel=1e-9)
    # a force across the end, which bends the blade by 0.1 mm
    force = np.linalg.solve(found.stiffness, found.motion) * found.motion_stiffness * 1e-4
    stress = force_stress(E=E, h=THICKNESS, l=LENGTH, x=1e-4, s=0.0)
    assert np.abs(found.outputs["stress blade"] @ force).max() == pytest.approx(stress, rel=1e-9)


def test_check_and_response_know_it():
    asked = Requirements.model_validate({"frequency": {"min": "1 Hz"}})
    design = stopped(cases=RANDOM).model_copy(update={"requirements": asked})
    sizes = design.fixed_sizes()
    printed = check(design, sizes, "", "source").values["f_0"].value
    assert printed == pytest.approx(176.0, abs=0.5)
    f_0 = check(design, sizes, "").values["f_0"].value
    (response,) = respond(design, sizes, "").responses
    assert response.modes[0].frequency == pytest.approx(f_0, rel=1e-9)


def test_balance_refuses_it_by_name():
    with pytest.raises(SolveError, match="cannot be balanced"):
        balance(stopped(), "")


def test_a_frequency_with_an_offset_needs_the_length():
    design = stopped()
    free = design.geometry.model_copy(
        update={"l": design.geometry.l.model_copy(update={"fixed": None})}
    )
    body = TipMass(**BODY)
    with pytest.raises(MechanismError, match="needs the blade's length"):
        body.mode(1.0, free)
    assert body.values(1.0, free) == {}
    point = TipMass(kind="tip-mass", mass="8 g")
    assert point.mode(1.0, free).mass == 8e-3


@pytest.mark.parametrize("ask", [
    lambda body: body.locked_forces("tip", 1.0),
    lambda body: body.structure(None, None, None, "tip"),
])  # fmt: skip
def test_a_locked_tip_mass_is_refused(ask):
    with pytest.raises(MechanismError, match=r"unload|loads no blade"):
        ask(TipMass(**BODY))


def test_along_the_blade_it_loads_the_blade_with_its_weight():
    case = {"climb": {"acceleration": {"level": "10 m/s^2", "axis": "y"}}}
    scene = stopped(cases=case).scene("climb")
    assert scene.force == pytest.approx(MASS * 10.0)
    assert scene.axial_share == 1.0


def test_it_sits_on_a_cantilever_only():
    design = stopped().model_dump(mode="python")
    assert design["geometry"]["kind"] == "cantilever"
    with pytest.raises(ValidationError, match="a tip mass sits on a cantilever"):
        DesignSpec.model_validate(
            {
                "flexure": 1,
                "material": {"youngs_modulus": "60 GPa"},
                "geometry": {"kind": "guided-blade", "h": "1 mm", "l": "20 mm", "b": "8 mm"},
                "mechanism": BODY,
                "cases": {"work": {"stroke": {"translation": "10 um"}}},
                "requirements": {},
            }
        )
