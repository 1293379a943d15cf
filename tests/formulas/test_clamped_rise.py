import numpy as np
import pytest
from plates.twisted_strip import twisted_strip

from flexcli.formulas.torsion_fibres import clamped_rise, clamped_rise_error
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.torsion_bar import TorsionBar


@pytest.mark.parametrize("shortening", ["held", "free"])
@pytest.mark.parametrize(
    ("long", "twist", "nu"), [(0.3, 0.08, 0.3), (1.0, 0.05, 0.45), (1.7, 0.1, 0.3), (4.0, 0.4, 0.0)]
)
def test_fibres_raise_the_stress_in_clamped_corners_as_in_von_karmans_plate(
    long, twist, nu, shortening
):
    bar = TorsionBar(
        kind="torsion-bar", h="0.1 mm", l=f"{6 * long} mm", b="6 mm", warping="restrained",
        shortening=shortening,
    )  # fmt: skip
    sizes, elastic = bar.sized({}), Elastic(1.0, nu)
    size = {"b": sizes.b, "l": sizes.l, "h": sizes.h, "nu": nu, "free": shortening == "free"}
    small = twisted_strip(**size, theta=1e-7, steps=1).bent * twist / 1e-7
    at_stroke = twisted_strip(**size, theta=twist)
    true = (at_stroke.bent + at_stroke.stretched) / small - 1.0
    change = bar.bending(elastic, sizes, twist).rotation()["stress"]
    at_rest = bar.end_errors(sizes, nu).stress
    assert true > 0.05
    assert (1.0 + change.value) / (1.0 + true) - 1.0 == pytest.approx(
        0.0, abs=change.error - at_rest
    )


@pytest.mark.parametrize("free", [False, True])
def test_fibres_of_a_small_twist_raise_nothing(free):
    size = {"h": 0.2e-3, "b": 6e-3, "l": 10e-3}
    assert clamped_rise(fibre=0.0, stiffening=0.0, free=free, **size) == 0.0


def test_the_rise_is_less_sure_where_fibres_are_tighter_than_compared():
    errors = clamped_rise_error(np.array([0.1, 0.6, 1.2]))
    assert errors[0] == errors[1] < errors[2]
