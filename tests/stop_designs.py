"""Designs with end stops for tests: the bender of the source's chapter 9, changed at will."""

from flexcli.parts.design import DesignSpec

LENGTH, THICKNESS, WIDTH, MASS, E = 28.5e-3, 1.25e-3, 7.8e-3, 8.07e-3, 60e9
I = WIDTH * THICKNESS**3 / 12
STEEL = {"youngs_modulus": "210 GPa", "poisson_ratio": 0.3}
BALL = {"kind": "ball", "radius": "50 mm", "material": STEEL}
SINE = {"resonance": {"sine": {"acceleration": "1.5 g", "frequency": "176 Hz"}}}
REST = {"operation": {"stroke": {"translation": "50 um"}}}


def stopped(stops=None, *, cases=None, mechanism=None, material=None, requirements=None):
    """Give the design; ``stops`` adds to a travel of ±100 µm."""
    return DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": {
                "youngs_modulus": "60 GPa",
                "poisson_ratio": 0.31,
                "yield_strength": "55.4 MPa",
                **(material or {}),
            },
            "geometry": {"kind": "cantilever", "h": "1.25 mm", "l": "28.5 mm", "b": "7.8 mm"},
            "mechanism": {
                "kind": "tip-mass",
                "mass": "8.07 g",
                "damping": {"q": 30},
                **(mechanism or {}),
            },
            "cases": cases or SINE,
            "requirements": requirements or {},
            "stops": {"travel": "100 um", **(stops or {})},
        }
    )
