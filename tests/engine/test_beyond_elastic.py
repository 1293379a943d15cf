"""What is beyond elasticity is told, whatever the requirements ask."""

from strategies import design

from flexcli.engine.check import check

H, L = 2e-3, 20e-3
BARE = {"name": "steel", "youngs_modulus": "210 GPa", "poisson_ratio": 0.3}


def codes(stroke_strain, requirements=None, cases=None, **more):
    """Return the notes on a cantilever whose face is strained by 3 h x/(2 l²)."""
    x = stroke_strain * 2.0 * L**2 / (3.0 * H)
    spec = design(
        {"kind": "cantilever", "h": f"{H} m", "l": f"{L} m", "b": "10 mm"},
        requirements or {"stiffness": {"min": "1 N/m"}},
        cases or {"op": {"stroke": {"translation": f"{x} m"}}},
        material={**BARE, **more},
    )
    return [note.code for note in check(spec, spec.fixed_sizes(), "test").warnings]


def test_a_strain_of_more_than_two_per_cent_is_told_though_nobody_asks_for_stress():
    assert "beyond-elastic" in codes(0.022)
    assert "beyond-elastic" not in codes(0.018)


def test_a_stress_beyond_the_tensile_strength_is_told_though_nobody_asks_for_stress():
    strength = {"tensile_strength": "1050 MPa"}  # a strain of 0.5 %
    assert "beyond-elastic" in codes(0.0055, **strength)
    assert "beyond-elastic" not in codes(0.0045, **strength)


def test_buckling_without_a_yield_strength_says_that_it_is_elastic():
    push = {"push": {"load": {"force": "1 N"}, "ends": "clamped-free"}}
    code = "buckling-without-yield-strength"
    assert code in codes(0.0, {"buckling": 2}, push)
    assert code not in codes(0.0, {"buckling": 2}, push, yield_strength="800 MPa")
    assert code not in codes(0.001)
