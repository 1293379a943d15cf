"""Every flexure of the union keeps the contract of a part, on the day it appears."""

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, asked, geometry, kinds, travel
from hypothesis import given, settings
from hypothesis import strategies as st

from flexcli.parts.elastic import Elastic, NotAvailable

KINDS = sorted(SAMPLES)

ROUNDING = 1e-13
"""Some hundred operations; powers of arrays round otherwise than those of numbers."""

every_kind = pytest.mark.parametrize("kind", KINDS)


def closed_forms(part, sizes):
    """Every closed form of a part by its name, where it has one."""
    moved = travel(part)
    found = {"stiffness": part.stiffness(ELASTIC, sizes), "volume": part.volume(sizes)}
    found |= {f"stress {k}": x for k, x in part.end_stresses(ELASTIC, sizes, moved).items()}
    found |= {f"ratio {k}": x for k, x in part.ratios(sizes).items()}
    found |= {f"indicator {k}": x for k, x in part.indicators(sizes, moved).items()}
    maybe = {
        "shift": asked(part.parasitic_shift, sizes, moved),
        "axial stress": asked(part.axial_stress, 10.0, sizes),
        "critical": asked(lambda: part.critical(ELASTIC, sizes, "clamped-clamped")[0].force),
    }
    return found | {k: form for k, form in maybe.items() if not isinstance(form, NotAvailable)}


def test_every_kind_of_the_union_has_a_sample():
    # a linkage is made of the others, drawings have no closed forms: they have tests of their own
    assert set(kinds()) - set(SAMPLES) == {"linkage", "layout", "space-layout"}


@every_kind
@settings(max_examples=10)
@given(factors=st.lists(st.floats(0.5, 2.0), min_size=1, max_size=4))
def test_an_array_of_designs_equals_the_designs_one_by_one(kind, factors):
    part = geometry(kind)
    base = part.probe()
    # the first size varies most and the others less and less, so that no two vary alike
    many = base._make(x * np.array(factors) ** (1.0 - 0.3 * k) for k, x in enumerate(base))
    found = closed_forms(part, many)
    for index in range(len(factors)):
        one = closed_forms(part, base._make(float(x[index]) for x in many))
        assert one.keys() == found.keys()
        for name, value in one.items():
            there = np.broadcast_to(found[name], len(factors))[index]
            assert there == pytest.approx(value, rel=ROUNDING), name


@every_kind
@settings(max_examples=10)
@given(scale=st.floats(0.01, 100.0))
def test_closed_forms_scale_as_their_units(kind, scale):
    """All lengths times s: N·m/rad by s³, N/m by s, m³ by s³, N by s², angles and Pa not at all."""
    small, large = geometry(kind), geometry(kind, scale)
    turn = small.motion == "rotation"
    powers = {"stiffness": 3 if turn else 1, "volume": 3, "shift": 1, "critical": 2}
    forms = closed_forms(small, small.probe())
    moved = travel(small) * (1.0 if turn else scale)
    sizes = large.probe()
    assert large.stiffness(ELASTIC, sizes) == pytest.approx(
        forms["stiffness"] * scale ** powers["stiffness"], rel=ROUNDING
    )
    assert large.volume(sizes) == pytest.approx(forms["volume"] * scale**3, rel=ROUNDING)
    for place, stress in large.end_stresses(ELASTIC, sizes, moved).items():
        assert stress == pytest.approx(forms[f"stress {place}"], rel=10 * ROUNDING)
    for name, ratio in large.indicators(sizes, moved).items():
        assert ratio == pytest.approx(forms[f"indicator {name}"], rel=ROUNDING)
    if "shift" in forms:
        shift = large.parasitic_shift(sizes, moved)
        assert shift == pytest.approx(forms["shift"] * scale, rel=10 * ROUNDING)
    if "critical" in forms:
        load = large.critical(ELASTIC, sizes, "clamped-clamped")[0].force
        assert load == pytest.approx(forms["critical"] * scale**2, rel=ROUNDING)


@every_kind
def test_stiffness_and_stresses_are_proportional_to_the_modulus(kind):
    """Twice E at the same Poisson's ratio: twice the stiffness and every stress."""
    part = geometry(kind)
    sizes, moved = part.probe(), travel(part)
    stiff = Elastic(2.0 * ELASTIC.E, ELASTIC.nu)
    assert part.stiffness(stiff, sizes) == pytest.approx(2.0 * part.stiffness(ELASTIC, sizes))
    for place, stress in part.end_stresses(stiff, sizes, moved).items():
        assert stress == pytest.approx(2.0 * part.end_stresses(ELASTIC, sizes, moved)[place])


@every_kind
@given(share=st.floats(-10.0, 10.0))
@settings(max_examples=10)
def test_stresses_are_linear_in_the_travel(kind, share):
    part = geometry(kind)
    sizes = part.probe()
    unit = part.end_stresses(ELASTIC, sizes, 1.0)
    for place, stress in part.end_stresses(ELASTIC, sizes, share).items():
        assert stress == pytest.approx(share * unit[place], rel=ROUNDING)


@every_kind
def test_critical_loads_are_positive_with_way_and_source(kind):
    part = geometry(kind)
    for ends in ("clamped-clamped", "clamped-guided"):
        found = asked(part.critical, ELASTIC, part.probe(), ends)
        if isinstance(found, NotAvailable):
            assert "no closed form" in str(found)
            continue
        assert found
        for critical in found:
            assert critical.force > 0.0
            assert critical.way
            assert ends in critical.source


@every_kind
def test_every_size_has_a_label_and_every_formula_a_card(kind):
    part = geometry(kind)
    sizes = set(part.dimensions._fields)
    assert sizes <= set(part.labels) <= sizes | {"root_radius"}
    assert all(part.label(name) for name in part.extents)
    assert part.cards
    assert part.source
    assert part.stiffness_unit == ("N*m/rad" if part.motion == "rotation" else "N/m")


@every_kind
def test_its_validity_is_stated_in_quantities_that_it_has(kind):
    part = geometry(kind)
    known = part.indicators(part.probe(), travel(part))
    assert {limits.quantity for limits in part.validity} <= set(known)
    assert all(limits.why for limits in part.validity)


@every_kind
def test_a_layout_exists_or_the_reason_is_told(kind):
    part = geometry(kind)
    layout = asked(part.layout, ELASTIC, part.probe())
    if isinstance(layout, NotAvailable):
        assert str(layout)
        assert part.strain == "twist"  # bars along the axis of rotation lie in no plane across it
    else:
        assert "moving" in {body.name for body in layout.bodies}
