"""What accuracy costs in time: errors fall with the tolerance, bounds are honest, notes told."""

import json
from math import asin, atan2, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar
from stop_designs import BALL, REST, SINE, stopped

from flexcli.engine.accuracy import accuracy
from flexcli.engine.comparing import time_accuracy as verb
from flexcli.engine.comparing import time_motions
from flexcli.engine.comparing.penalty_law import penalty_law
from flexcli.engine.comparing.time_accuracy import accuracy_in_time, bounded
from flexcli.engine.comparing.time_methods import stretches
from flexcli.engine.comparing.time_motions import PERIODS, StoppedMotion, motions
from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.signal_pieces import Piece
from flexcli.report.as_json import document, dumps
from flexcli.results import Status

PLACE = {"height": "17 mm", "gap": "36 um"}
KICK = {"kick": {"shock": {"velocity": "0.1 m/s", "q": 50}}}
FLAT = {"points": [{"frequency": "20 Hz", "level": "0.01 g^2/Hz"},
                   {"frequency": "400 Hz", "level": "0.01 g^2/Hz"}]}  # fmt: skip
BODY = {"offset": "3 mm", "inertia": "150 g*mm^2"}
LUCK = 1e3
"""Global error over tolerance of an integrator that steps over kinks of the force."""
LEGS = 1e-12
"""What smooth legs, each to 1e-13, leave after some dozen of them."""
NAMES = ("tip_peak", "F_peak", "t_contact")

pytestmark = pytest.mark.slow  # general integrators step through many contacts


def run(one, asked=0.01):
    return accuracy_in_time(one, one.fixed_sizes(), 1, asked)


def moved(one):
    return list(motions(one, one.fixed_sizes()))


@pytest.fixture
def quick(monkeypatch):
    """Leave the slow end of the series out."""
    monkeypatch.setattr(verb, "TOLERANCES", (1e-4, 1e-6))


@pytest.fixture(scope="module")
def found():
    return run(stopped(PLACE))


def test_errors_fall_with_the_tolerance_of_either_method(found):
    for method in ("Radau", "DOP853"):
        for quantity in found.quantities:
            errors = [r.error for r in quantity.readings if r.model.startswith(method)]
            assert len(errors) == 4
            assert errors[0] > 1e-6
            for error, tolerance in zip(errors, verb.TOLERANCES, strict=True):
                assert error <= LUCK * tolerance


def test_the_numbers_are_named_by_their_case_and_tell_their_window(found):
    assert [q.name for q in found.quantities] == [f"{name}_resonance" for name in NAMES]
    assert all(f"first {PERIODS} periods" in q.label for q in found.quantities)
    assert [q.unit for q in found.quantities] == ["m", "N", "s"]
    assert found.finest == found.models[-1].model == "event-driven"
    assert found.unsettled == ()


def test_all_three_numbers_of_a_run_take_its_time(found):
    for i, model in enumerate(found.models):
        assert {q.readings[i].seconds for q in found.quantities} == {model.seconds}


def test_the_bound_on_a_swing_between_springs_holds_against_its_closed_form():
    # unit oscillator, springs nine times as stiff at ±1, from the middle at a speed of 1.1
    touch, at, k = asin(1 / 1.1), sqrt(1.1**2 - 1), 9.0
    period = 4 * touch + 4 * atan2(at / sqrt(k + 1), 1 / (k + 1)) / sqrt(k + 1)
    travel = (k + sqrt(k * k - (k + 1) * (k - 1.1**2))) / (k + 1)
    one = np.ones(1)
    blade = ModalBlade(angular=one, damping=0 * one, base=one, tip=one, stop=one, base_moment=one)
    pieces = (Piece(3 * period, ()),)
    motion = StoppedMotion(
        "free", "free", blade, Stops(LinearStop(k), 1.0, 1.0), pieces, np.array([1.1])
    )
    truth = (travel, k * (travel - 1), 2.5 * period + touch)
    for (_, value, bound), true in zip(bounded(motion), truth, strict=True):
        assert abs(value / true - 1.0) <= bound < 1e-8


@pytest.mark.parametrize("contact", [{"kind": "rigid"}, BALL], ids=["line", "ball"])
def test_the_bound_between_real_stops_holds_against_a_run_of_smooth_legs(contact):
    (motion,) = moved(stopped({**PLACE, "contact": contact}))
    truth = run_of_legs(motion, 1e-13)
    for (_, value, bound), true in zip(bounded(motion), truth, strict=True):
        assert abs(value / true - 1.0) <= bound + LEGS
        assert bound < 1e-4


def run_of_legs(motion, tolerance):
    """Return tip, force and last contact, integrated afresh from every touch and every parting.

    No step runs over a kink of the force, so that the error is that of a smooth problem.
    """
    blade, stops, n = motion.blade, motion.stops, motion.blade.angular.size
    push = penalty_law(blade, stops.law)
    state, begun, side = np.concatenate([np.zeros(n), motion.rate]), 0.0, 0
    greatest, last = np.zeros(2), np.nan

    def signed_push(x, side):
        if not side:
            return 0.0
        approach = side * (blade.stop @ x[:n]) - stops.gap(side)
        return side * push(max(approach, 0.0), side * (blade.stop @ x[n:]))

    def meets(side, direction):
        def approach(_, x):
            return side * (blade.stop @ x[:n]) - stops.gap(side)

        approach.terminal, approach.direction = True, direction
        return approach

    for piece in stretches(motion.pieces):
        t = 0.0
        while t < piece.duration:

            def slope(t, x, side=side, piece=piece):
                force = -blade.base * piece(t) - np.diagonal(blade.damper) * x[n:]
                force -= blade.angular**2 * x[:n] + signed_push(x, side) * blade.stop
                return np.concatenate([x[n:], force])

            events = [meets(side, -1.0)] if side else [meets(1, 1.0), meets(-1, 1.0)]
            leg = solve_ivp(slope, (t, piece.duration), state, "DOP853", rtol=tolerance,
                            atol=tolerance * 1e-9, dense_output=True, events=events)  # fmt: skip

            def sizes(t, side=side, sol=leg.sol):
                p = signed_push(sol(t), side)
                return np.abs([blade.tip @ sol(t)[:n] - blade.tip_residual * p, p])

            times = np.linspace(t, leg.t[-1], 200)
            samples = np.array([sizes(s) for s in times])
            for j, i in enumerate(samples.argmax(axis=0)):
                ends = times[max(i - 1, 0)], times[min(i + 1, 199)]
                best = minimize_scalar(lambda s, j=j: -sizes(s)[j], bounds=ends, method="bounded",
                                       options={"xatol": 1e-6 * (ends[1] - ends[0])})  # fmt: skip
                greatest[j] = max(greatest[j], samples[i, j], -best.fun)
            state, t = leg.y[:, -1], leg.t[-1]
            if leg.status == 1 and not side:
                side = 1 if leg.t_events[0].size else -1
                last = begun + t
            elif leg.status == 1:
                side = 0
        begun += piece.duration
    return *greatest, last


@pytest.mark.usefixtures("quick")
def test_a_finer_accuracy_takes_a_finer_method():
    fine = run(stopped({**PLACE, "contact": BALL}), 1e-4)
    errors = {model.model: model.error for model in fine.models}
    assert errors[fine.recommended] < 1e-4 < errors["DOP853 at 1e-04"]


@pytest.mark.usefixtures("quick")
def test_a_rigid_stop_has_no_peak_force_and_its_penalty_a_model_error():
    stops = {**PLACE, "contact": {"kind": "rigid", "restitution": 0.5}, "simulation": {"modes": 2}}
    one = stopped(stops, cases={**KICK, **REST}, mechanism=BODY)
    result = accuracy(one, one.fixed_sizes(), "spec", 1)
    in_time = result.accuracy.in_time
    assert in_time.unsettled == ("F_peak_kick",)
    assert "penalty-for-rigid" in [note.code for note in result.warnings]
    (last,) = (q for q in in_time.quantities if q.name == "t_contact_kick")
    fine = [r.error for r in last.readings if r.model.endswith("1e-06")]
    # the contact takes time that an impulse does not, whatever the tolerance
    assert all(1e-3 < error < 1e-2 for error in fine)


@pytest.mark.usefixtures("quick")
def test_far_stops_leave_the_tip_to_compare():
    far = run(stopped({"height": "17 mm", "gap": "10 mm"}))
    assert [q.name for q in far.quantities] == ["tip_peak_resonance"]
    assert far.unsettled == ("F_peak_resonance", "t_contact_resonance")


@pytest.mark.parametrize(
    "case",
    [{"asd": {"profile": FLAT, "q": 30, "duration": "1 s"}},
     {"shock": {"srs": [{"frequency": "10 Hz", "acceleration": "5 g"},
                        {"frequency": "1 kHz", "acceleration": "50 g"}]}}],
    ids=["random", "spectrum"],
)  # fmt: skip
def test_what_is_neither_periodic_nor_short_runs_no_code_in_time(case, monkeypatch):
    def refuse(*_, **__):
        raise AssertionError

    for module, name in (
        (time_motions, "choose"), (time_motions, "stop_scene"), (time_motions, "excitation"),
        (verb, "event_driven"), (verb, "penalty_run"),
    ):  # fmt: skip
        monkeypatch.setattr(module, name, refuse)
    assert run(stopped(PLACE, cases={"one": case})) is None


@pytest.mark.usefixtures("quick")
def test_json_has_the_ladder_in_time_beside_that_at_rest():
    one = stopped(PLACE, cases={**SINE, **REST})
    result = accuracy(one, one.fixed_sizes(), "spec", 1)
    assert result.status is Status.PASS
    content = json.loads(dumps(document(result)))
    in_time = content["accuracy"]["in_time"]
    assert [q["name"] for q in in_time["quantities"]] == [f"{name}_resonance" for name in NAMES]
    assert content["values"]["tip_peak_resonance"]["model"] == "event-driven"
    assert content["values"]["k_stage"]["model"] == content["accuracy"]["finest"]
    assert in_time["recommended"] in [model["model"] for model in in_time["models"]]


@pytest.mark.usefixtures("quick")
def test_what_no_method_meets_in_time_fails_the_whole_and_says_where():
    one = stopped(PLACE, cases={**SINE, **REST})
    result = accuracy(one, one.fixed_sizes(), "spec", 1, 1e-11)
    assert result.accuracy.recommended
    assert result.accuracy.in_time.recommended == ""
    assert result.status is Status.FAIL
    (note,) = result.warnings
    assert note.code == "accuracy-not-met"
    assert note.text.endswith("of the finest, in time")
