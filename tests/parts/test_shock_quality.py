"""Q of a shock: its own, else the case's, else the mechanism's, else the material's, else 10."""

import numpy as np
import pytest
from strategies import TITANIUM, design

BLADE = {"kind": "cantilever", "h": "0.25 mm", "l": "25 mm", "b": "10 mm"}
PULSE = {"half-sine": {"acceleration": "50 g", "duration": "2 ms"}}
LOSS = {"value": 0.01, "status": "measured", "source": "ring-down of a coupon"}


def quality(*, own=None, case=None, damping=None, loss=None):
    """Return the Q of a shock where these are stated."""
    drop = {"shock": PULSE | ({"q": own} if own else {})} | ({"q": case} if case else {})
    mass = {"kind": "tip-mass", "mass": "10 g"} | ({"damping": damping} if damping else {})
    material = TITANIUM | ({"loss_factor": loss} if loss else {})
    found = design(
        BLADE, {"dynamic-yield": 1.25}, {"drop": drop}, mechanism=mass, material=material
    )
    return found.cases["drop"].shock.q


def test_it_is_ten_where_nothing_is_stated():
    assert quality() == 10.0


@pytest.mark.parametrize(("stated", "q"), [(30, 30.0), ({"all": 20, "modes": {2: 80}}, 80.0)])
def test_the_case_damps_its_shock_the_least_damped_mode_before_others(stated, q):
    assert quality(case=stated, damping={"q": 50}) == q


@pytest.mark.parametrize("damping", [{"q": 100}, {"ratio": "0.5 %"}])
def test_the_mechanism_damps_a_shock_where_the_case_does_not(damping):
    assert quality(damping=damping, loss=LOSS) == pytest.approx(100.0, rel=1e-12)


def test_the_loss_of_the_material_damps_it_where_nothing_else_does():
    assert quality(loss=LOSS) == pytest.approx(100.0, rel=1e-12)


def test_its_own_goes_before_all():
    assert quality(own=5, case=30, damping={"q": 50}, loss=LOSS) == 5.0


@pytest.mark.parametrize("milliseconds", [2.0, 3.0, 6.0, 7.0, 11.0, 0.3])
def test_modes_far_above_the_pulse_follow_it(milliseconds):
    """However 200 pulses a period round: some durations ended in an error of the formula."""
    pulse = {"half-sine": {"acceleration": "100 m/s^2", "duration": f"{milliseconds} ms"}}
    spec = design(
        BLADE, {"dynamic-yield": 1.25}, {"drop": {"shock": pulse}},
        mechanism={"kind": "tip-mass", "mass": "10 g"},
    )  # fmt: skip
    turn = 200.0 / (milliseconds * 1e-3)
    fn = np.array([np.nextafter(turn, 0.0), turn, np.nextafter(turn, np.inf), 10.0 * turn])
    shock, alone = spec.cases["drop"].shock, [np.ones((1, 1, 1))]
    peaks = np.array([shock.peaks(alone, f)[0] for f in np.split(fn, fn.size)])
    assert peaks == pytest.approx(100.0, rel=1e-2)
    assert peaks[-1] == pytest.approx(100.0, rel=1e-12)
