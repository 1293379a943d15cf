"""The twenty measured ranges of a blade's tip at resonance, beside the response of its modes."""

from math import pi
from pathlib import Path

import numpy as np
import yaml

import flexcli
from flexcli.numerics.modes import natural_modes
from flexcli.parts.own_motion import structure_of
from flexcli.parts.quality import Quality
from flexcli.parts.response import sine_peaks
from flexcli.units import parse_quantity

TABLE = Path(__file__).parents[2] / "examples" / "boundary-control" / "table-7-3.yaml"
BASE = 0.5e-6
C, J, C_INSERT = 10.64e-3, 2.221e-6, 15.51e-3  # fitted on four of the frequencies (README)
Q = 700.0


def ranges():
    """Yield sample, insert, measured range and that of the response at one Q [m]."""
    data = yaml.safe_load(TABLE.read_text())
    bare = parse_quantity(data["tip_mass"], "mass")
    for sample, row in enumerate(data["samples"], 1):
        for insert, (text, measured) in enumerate(
            zip(data["inserts"], row["tip_range"], strict=True)
        ):
            added = parse_quantity(text, "mass")
            m = bare + added
            c = (bare * C + added * C_INSERT) / m
            inertia = J + bare * (C - c) ** 2 + added * (C_INSERT - c) ** 2
            design = flexcli.load(
                f"""
flexure: 1
material: {{youngs_modulus: 69 GPa, poisson_ratio: 0.33, density: 2700 kg/m^3}}
geometry: {{kind: cantilever, h: {row["h"]}, l: {row["L"]}, b: {row["b"]}}}
mechanism: {{kind: tip-mass, mass: {m} kg, offset: {c} m, inertia: {inertia} kg*m^2}}
cases: {{free: {{stroke: {{translation: 0.1 mm}}}}}}
requirements: {{stiffness: {{max: 1 N/um}}}}
"""
            ).part
            found = structure_of(
                design.mechanism, design.geometry, design.material.elastic,
                design.fixed_sizes(), None, 2700.0,
            )  # fmt: skip
            own = natural_modes(found.stiffness, found.mass).angular[0]
            level = BASE * own**2
            peaks = sine_peaks(
                found, lambda f, a=level: np.full(np.shape(f), a), Quality(all=Q),
                (own / (2 * pi), own / (2 * pi)), next(iter(found.pull)),
            )  # fmt: skip
            yield sample, insert, parse_quantity(measured, "length"), 2.0 * peaks["travel"]


def test_one_quality_factor_meets_nineteen_of_twenty_measured_ranges():
    # Monti (2014), table 7.3, base ±0.5 µm; the source prints no Q
    found = {(s, i): (measured, ours) for s, i, measured, ours in ranges()}
    assert len(found) == 20
    far = {key for key, (measured, ours) in found.items() if abs(ours / measured - 1.0) > 0.2}
    assert far == {(1, 0)}
    # heavier ends swing farther, as measured
    for sample in (1, 2, 3, 4):
        of = [found[sample, insert] for insert in range(5)]
        assert of == sorted(of)
        assert [ours for _, ours in of] == sorted(ours for _, ours in of)
