"""A joint has one set of validity ranges: what explain prints, check warns of and nobody trusts."""

from math import inf
from typing import Any

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, MATERIAL, SAMPLES, geometry, spec

from flexcli.engine import omitted_effects
from flexcli.engine.explain import explain
from flexcli.formulas.card import Range
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS, estimate
from flexcli.parts.geometries import Geometry
from flexcli.parts.geometries.base import AT_REST, TRAVELS
from flexcli.results import QuantityKind

BEYOND = 1.05
"""How far outside of a range a design is looked for, at least: past rounding."""

TRIES = 600
"""Shapes that are tried for each range."""

REACH = 6.0
"""Powers of two by which a length of a sample changes at most."""

KINDS_OF_NUMBERS = (QuantityKind.STIFFNESS, QuantityKind.STRESS, QuantityKind.SHIFT)

every_kind = pytest.mark.parametrize("kind", sorted(SAMPLES))


def printed(kind: str) -> dict[str, tuple[float, float]]:
    """Return the tightest ends that explain prints of each quantity."""
    found: dict[str, tuple[float, float]] = {}
    for formula in explain(kind).formulas:
        for row in formula.validity:
            least, most = found.get(row.quantity, (-inf, inf))
            found[row.quantity] = (
                max(least, -inf if row.least is None else row.least),
                min(most, inf if row.most is None else row.most),
            )
    return found


def outside(value: float, limits: Range) -> bool:
    low = limits.least / BEYOND if limits.least > 0.0 else limits.least * BEYOND
    return value < low or value > limits.most * BEYOND


def beyond(kind: str, limits: Range) -> tuple[Geometry, dict[str, Any], float] | None:
    """Return a sample outside of a range and, if there is one, of no other, with its travel."""
    rng, said, found, least = np.random.default_rng(1), SAMPLES[kind], None, inf
    turns = geometry(kind).motion == "rotation"
    lengths = [name for name, value in said.items() if isinstance(value, float)]
    for tried in range(TRIES):
        # first one size or the travel alone, then all of them
        factors = dict.fromkeys(["travel", *lengths], 1.0)
        changed = [list(factors)[tried % len(factors)]] if tried < TRIES // 3 else factors
        factors |= {name: 2.0 ** rng.uniform(-REACH, REACH) for name in changed}
        travel = min((2e-2 if turns else 2e-4) * factors.pop("travel"), 1.5 if turns else 15e-3)
        changes = {name: said[name] * factor for name, factor in factors.items()}
        try:
            part = geometry(kind, **changes)
        except ValueError:  # sizes that do not fit
            continue
        at = part.indicators(part.probe(), travel)
        if limits.quantity not in at or not outside(float(at[limits.quantity]), limits):
            continue
        left = {r.quantity for r, _ in part.outside_validity(part.probe(), travel)}
        if len(left) < least:
            found, least = (part, spec(kind, **changes), travel), len(left)
        if least == 1:
            break
    return found


def design(said: dict[str, Any], travel: float, turns: bool) -> DesignSpec:
    stroke = {"rotation": f"{travel!r} rad"} if turns else {"translation": f"{travel!r} m"}
    content = {
        "flexure": 1, "material": MATERIAL, "geometry": said,
        "cases": {"work": {"stroke": stroke}}, "requirements": {"yield": 1.0},
    }  # fmt: skip
    return DesignSpec.model_validate(content)


@every_kind
def test_every_range_that_explain_prints_is_one_of_the_joint(kind):
    part = geometry(kind)
    known = part.indicators(part.probe(), 0.01)
    for quantity, (least, most) in printed(kind).items():
        assert quantity in known
        own = [r for r in part.ranges() if r.quantity == quantity]
        assert any(r.least >= least for r in own) or least <= 0.0
        assert any(r.most <= most for r in own) or most == inf


@every_kind
def test_a_design_outside_of_a_range_is_warned_of_and_its_number_has_no_known_error(kind):
    for limits in geometry(kind).ranges():
        found = beyond(kind, limits)
        if found is None:  # sizes that the spec refuses
            assert limits.quantity in {"xi", "2r/l"}, limits
            continue
        part, said, travel = found
        judged = design(said, travel, part.motion == "rotation")
        sizes = judged.fixed_sizes()
        assert sizes is not None
        rows = omitted_effects.effects(judged, sizes)
        notes = [n.text for n in omitted_effects.warnings(judged, sizes, rows)]
        assert any(text.startswith(f"{limits.quantity} = ") for text in notes), limits
        setting = omitted_effects.setting(judged, sizes)
        reach = {"theta": travel, "x/l": travel / part.length(sizes)}.get(limits.quantity, inf)
        corrected = limits.quantity in TRAVELS and reach <= setting.bending.travel_most
        for number in KINDS_OF_NUMBERS if limits.kind is None else (limits.kind,):
            at_rest = float(part.indicators(sizes, 0.0).get(limits.quantity, limits.most))
            if number in AT_REST and not outside(at_rest, limits):
                continue
            if not corrected and limits.quantity not in part.extends:
                assert not part.is_known(ELASTIC, sizes, travel, number)
                assert estimate(setting, number, MODEL_EFFECTS).error is None, limits


def test_what_follows_from_a_stiffness_is_not_known_where_that_is_not():
    short = geometry("torsion-bar", l=0.8)
    assert not short.is_known(ELASTIC, short.probe(), 0.0, QuantityKind.STIFFNESS)
    assert not short.is_known(ELASTIC, short.probe(), 0.0, QuantityKind.FREQUENCY)


def test_a_stroke_of_a_leaf_spring_stage_beyond_what_explain_says_is_warned_of():
    most = min(
        row.most
        for formula in explain("leaf-spring-stage").formulas
        for row in formula.validity
        if row.quantity == "x/l" and row.most is not None
    )
    part = geometry("leaf-spring-stage")
    far = np.nextafter(most, 1.0) * 1.01 * float(part.probe().l)
    assert any(r.quantity == "x/l" for r, _ in part.outside_validity(part.probe(), far))
