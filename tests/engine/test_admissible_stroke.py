"""The admissible stroke is where the stress of the model reaches the strength."""

from math import degrees

import pytest
from strategies import design

from flexcli.engine.check import check

STEEL = {
    "name": "steel",
    "youngs_modulus": "210 GPa",
    "poisson_ratio": 0.3,
    "yield_strength": "800 MPa",
}
PRINTED = 2e-4
"""Of true numbers printed with four or five digits."""


def admissible(geometry, stroke, *, model=None, strength="800 MPa", effects=None):
    spec = design(
        geometry, {"yield": 1.0}, {"op": {"stroke": stroke}},
        material={**STEEL, "yield_strength": strength},
    )  # fmt: skip
    if effects:
        spec = spec.model_copy(update={"effects": effects})
    sizes = spec.fixed_sizes()
    values = check(spec, sizes, "test", model).values
    return next(v for name, v in values.items() if name.endswith("_adm"))


NECKED = {"kind": "necked-down-stage", "h": "0.2 mm", "l_c": "25 mm", "l": "50 mm",
          "b": "10 mm", "spacing": "40 mm"}  # fmt: skip
SYMMETRIC = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg", "h": "0.3 mm",
             "l": "50 mm", "b": "2 mm"}  # fmt: skip
BEAMS = {"plate-widening": "off", "anticlastic": "off"}


def test_a_long_stroke_of_a_stage_has_its_rotation_in_it():
    """15.216 mm by elastica solutions of 50 digits; 15.873 mm without the next order."""
    found = admissible(NECKED, {"translation": "7 mm"}, effects=BEAMS)
    assert found.estimated_error is not None
    assert found.value == pytest.approx(15.216e-3, rel=found.estimated_error + PRINTED)
    assert found.estimated_error < 0.07  # most of it of plates, which are switched off


def test_a_pivot_beyond_the_reach_of_its_formulas_does_not_promise_a_stroke():
    found = admissible(SYMMETRIC, {"rotation": "20 deg"}, strength="1000 MPa", effects=BEAMS)
    assert found.estimated_error is None


def test_the_exact_model_tells_how_far_a_pivot_turns():
    """64.06° by elastica solutions; 90.95° by the formula that the rotation is small for."""
    found = admissible(
        SYMMETRIC, {"rotation": "20 deg"}, model="exact", strength="1000 MPa", effects=BEAMS
    )
    assert degrees(found.value) == pytest.approx(64.06, rel=PRINTED)


def test_long_fibres_shorten_the_stroke_of_a_wide_torsion_bar():
    """σ = E (b θ/l)²/8 between ends that are held: 800 MPa at θ = 2 · 0.17457 at b/l = 1/2."""
    bar = {"kind": "torsion-bar", "h": "0.02 mm", "l": "20 mm", "b": "10 mm", "bars": 2}
    found = admissible(bar, {"rotation": "5 deg"})
    fibres = 2.0 * (8.0 * 800e6 / 210e9) ** 0.5
    assert found.value == pytest.approx(fibres, rel=0.01)  # and a little shear at the edge
