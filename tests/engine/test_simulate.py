"""A static sweep: energy is work, mirror strokes mirror, what is not reached is said."""

import numpy as np
import pytest
from geometries_for_tests import MATERIAL
from strategies import crossed, design, rcc, stage

from flexcli.engine.simulate import simulate
from flexcli.errors import SolveError
from flexcli.report.sweep_text import sweep_csv
from flexcli.results import Status


def swept(geometry, stroke, points=21, requirements=None):
    one = design(
        geometry, requirements or {"yield": 1}, {"move": {"stroke": stroke}}, material=MATERIAL
    )
    return simulate(one, one.fixed_sizes(), "spec", points)


@pytest.mark.parametrize(
    ("geometry", "stroke"),
    [
        (crossed(delta=-0.5, h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": "10 deg"}),
        (stage(h="0.1 mm", l="20 mm", b="5 mm", spacing="30 mm"), {"translation": "1 mm"}),
    ],
)
def test_the_work_of_the_drive_is_the_strain_energy(geometry, stroke):
    (sweep,) = swept(geometry, stroke, 41).sweeps
    x = np.array([p.travel for p in sweep.points])
    effort = np.array([p.effort for p in sweep.points])
    work = np.concatenate([[0.0], np.cumsum((effort[1:] + effort[:-1]) / 2 * np.diff(x))])
    energy = np.array([p.energy for p in sweep.points])
    assert energy == pytest.approx(work - work[20], abs=2e-3 * energy.max())


def test_the_tangent_is_the_slope_of_the_effort():
    (sweep,) = swept(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": "8 deg"}, 201).sweeps
    x = np.array([p.travel for p in sweep.points])
    slope = np.gradient([p.effort for p in sweep.points], x, edge_order=2)
    assert [p.stiffness for p in sweep.points] == pytest.approx(slope, rel=1e-3)


def test_a_symmetric_stroke_is_its_own_mirror():
    (sweep,) = swept(
        crossed(delta=0.2, h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": "8 deg"}
    ).sweeps
    for one, other in zip(sweep.points, reversed(sweep.points), strict=True):
        assert one.effort == pytest.approx(-other.effort, abs=1e-9)
        assert one.shift_x == pytest.approx(other.shift_x, abs=1e-12)
        assert one.total == pytest.approx(other.total, rel=1e-9)


def test_a_stage_stiffens_by_what_its_shortening_stretches_not_at_all():
    result = swept(stage(h="0.1 mm", l="20 mm", b="5 mm", spacing="30 mm"), {"translation": "1 mm"})
    (sweep,) = result.sweeps
    # free to come down, a parallel stage keeps its stiffness to the order of (x/l)²
    k = [p.stiffness for p in sweep.points]
    assert max(k) / min(k) == pytest.approx(1.0, abs=0.02)
    assert sweep.points[-1].shift_x == pytest.approx(-0.6 * 1e-3**2 / 20e-3, rel=5e-3)


def test_a_design_that_fails_its_margin_fails_the_simulation():
    result = swept(rcc(h="1 mm", l="20 mm", b="5 mm"), {"rotation": "8 deg"}, 3)
    assert result.status is Status.FAIL


def test_every_point_goes_to_the_table():
    result = swept(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": "8 deg"}, 7)
    lines = sweep_csv(result.sweeps).splitlines()
    assert len(lines) == 8
    assert lines[0].startswith("case,travel [rad],effort [N*m]")


def test_a_design_without_a_stroke_says_what_is_missing():
    one = design(
        rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"buckling": 1},
        {"push": {"load": {"force": "1 N"}, "ends": "clamped-clamped"}}, material=MATERIAL,
    )  # fmt: skip
    with pytest.raises(SolveError, match="no case moves"):
        simulate(one, one.fixed_sizes(), "spec", 3)


def test_the_admissible_stroke_is_where_the_real_stress_reaches_the_strength():
    result = swept(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": "2 deg"}, 3)
    reached = result.values["theta_adm"]
    assert reached.model == "exact"
    at_it = swept(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"rotation": f"{reached.value!r} rad"}, 3)
    assert at_it.sweeps[0].points[-1].total == pytest.approx(800e6, rel=1e-8)


def test_the_stiffness_in_the_plane_is_that_of_the_blades():
    l, h, b, E = 20e-3, 0.1e-3, 5e-3, 114e9
    (sweep,) = swept(
        stage(h="0.1 mm", l="20 mm", b="5 mm", spacing="30 mm"), {"translation": "1 um"}, 3
    ).sweeps
    rest = sweep.points[1]
    assert rest.stiffness_x == pytest.approx(2 * E * h * b / l, rel=1e-3)
    assert rest.stiffness_y == rest.stiffness
    assert rest.stiffness_phi == pytest.approx(2 * E * h * b / l * 15e-3**2, rel=1e-3)
