"""Stops verified in time: closed forms, the engine asked directly, and runs that end early."""

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from stop_designs import BALL, LENGTH, MASS, SINE, E, I, stopped

from flexcli.engine.stopping.excitation import exposures
from flexcli.engine.stopping.run import stop_runs
from flexcli.engine.stopping.scene import stop_scene
from flexcli.engine.stopping.simulation import decided, simulated
from flexcli.engine.stopping.statics import force_at_travel, stop_place, task_of
from flexcli.engine.stops import stops
from flexcli.errors import SolveError
from flexcli.formulas.peaks import peak_factor
from flexcli.formulas.stopped_cantilever import load_at_travel
from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.vibration import StoppedVibration, simulate
from flexcli.numerics.signal_pieces import sine
from flexcli.parts.response import random_response
from flexcli.results import Status, Verdict

pytestmark = pytest.mark.slow  # runs in time, contact by contact

K = 3 * E * I / LENGTH**3
OMEGA = sqrt(K / MASS)
PLACE = {"height": "17 mm", "gap": "36 um"}
FAR = {"height": "17 mm", "gap": "10 mm"}
BALANCE = 1e-12
FLAT = [{"frequency": "20 Hz", "level": "0.01 g^2/Hz"},
        {"frequency": "400 Hz", "level": "0.01 g^2/Hz"}]  # fmt: skip
EXPOSURE = 0.1
"""Duration of a random exposure [s]."""
RANDOM = {"launch": {"asd": {"profile": {"points": FLAT}, "q": 30, "duration": f"{EXPOSURE} s"}}}
LIVELY = {"damping": {"q": 10}}
"""Damping by which a sine is steady soon."""


def on(*_):
    return True


def run(limits, *, watch=on, seed=None, keep_history=False, **changes):
    design = stopped(limits, **changes)
    sizes = design.fixed_sizes()
    result = stops(design, sizes, "spec")
    return simulated(result, design, sizes, watch, seed=seed, keep_history=keep_history)


def only(result):
    (found,) = result.stops.simulations
    return found


def check(result, name):
    (found,) = (c for c in result.checks if c.name == name and c.case)
    return found


def test_a_sine_between_far_stops_ends_at_q_times_the_static_travel():
    found = only(run(FAR))
    assert found.contacts == 0
    assert found.travel == pytest.approx(30 * 1.5 * 9.80665 / OMEGA**2, rel=2e-3)
    assert found.sigma_base == pytest.approx(
        K * found.travel * LENGTH * 1.25e-3 / (2 * I), rel=1e-9
    )


def test_it_is_what_the_engine_gives_when_asked_directly():
    found = only(run(PLACE))
    blade = cantilever_modes(E=E, I=I, L=LENGTH, L_a=17e-3, m=MASS, quality=30.0)
    direct = simulate(
        blade,
        Stops(LinearStop(), 36e-6, 36e-6),
        sine(amplitude=1.5 * 9.80665, angular=2 * pi * 176.0, duration=found.planned),
    )
    assert found.travel == pytest.approx(direct.peaks.travel, rel=1e-9)
    assert found.force == pytest.approx(direct.peaks.force, rel=1e-9)
    assert found.contacts == direct.contacts.time.size > 100


@pytest.mark.parametrize("height", ["16 mm", "20 mm", "24 mm"])
def test_the_plateau_hardly_knows_the_damping_and_lies_above_the_threshold(height):
    # figure 8.7: one ratio for a stop, whatever drives it; no contact exists below the threshold
    low, high = (only(run({"height": height}, mechanism={"damping": {"q": q}})) for q in (20, 80))
    assert low.pi_5 == pytest.approx(high.pi_5, rel=0.02)
    place = run({"height": height}).stops.chosen
    assert place.pi_5_threshold < high.pi_5 < 1.02 * place.pi_5
    # on the way there it goes farther
    assert high.travel > 1.02 * high.pi_5 * place.delta_G / 2


def test_the_plateau_hardly_knows_mass_or_gap():
    # Monti (2014), notes 1 and 8.4 of chapter 8: from 9.96 to 15.35 g "no discernable trend", and
    # stable above a gap of 3 % of the travel; one motion of the base at each natural frequency
    found = []
    for mass, gap in ((9.96e-3, 30e-6), (15.35e-3, 30e-6), (9.96e-3, 20e-6)):
        own = np.sqrt(K / mass)
        sine = {"acceleration": f"{12e-6 * own**2} m/s^2", "frequency": f"{own / (2 * pi)} Hz"}
        place = {"height": "17 mm", "gap": f"{gap} m"}
        one = only(run(place, cases={"shaken": {"sine": sine}}, mechanism={"mass": f"{mass} kg"}))
        found.append(one.pi_5)
    # a point mass at its own frequency is but another time scale
    assert found[0] == pytest.approx(found[1], rel=1e-6)
    # a gap against the base's 12 µm counts as the level does: 1.5 times, 3 %
    assert found[2] == pytest.approx(found[0], rel=0.05)


def test_a_velocity_shock_goes_as_far_as_its_energy():
    case = {"kick": {"shock": {"velocity": "0.1 m/s", "q": 1e6}}}
    quick = {"damping": {"q": 50}}
    found = only(run(FAR, cases=case, mechanism=quick))
    first = np.exp(-pi / 2 / 100)  # a quarter of a cycle at ζ = 1/100
    assert found.travel == pytest.approx(0.1 / OMEGA * first, rel=1e-3)


@pytest.mark.parametrize("turned", [1, -1])
def test_on_one_side_a_shock_comes_with_either_sign(turned):
    pulse = {"drop": {"shock": {"half-sine": {"acceleration": "30 g", "duration": "3 ms"}}}}
    result = run({**PLACE, "sides": "one"}, cases=pulse)
    both = result.stops.simulations
    assert [row.kind.endswith("turned round") for row in both] == [False, True]
    assert check(result, "travel").demand == max(row.travel for row in both)
    assert all(row.energy_residual < BALANCE for row in both)


@pytest.mark.parametrize(
    "contact",
    [{"kind": "rigid"}, {"kind": "spring", "stiffness": "2 N/um", "restitution": 0.5},
     {"kind": "rigid", "restitution": 0.5}],
)  # fmt: skip
def test_energy_and_momentum_are_accounted_for(contact):
    options = {"contact": contact, "simulation": {"modes": 2}}
    body = {"offset": "3 mm", "inertia": "150 g*mm^2", **LIVELY}
    case = {"near": {"sine": {"acceleration": "3 g", "frequency": "150 Hz"}}}
    found = only(run({**PLACE, **options}, mechanism=body, cases=case))
    assert found.contacts > 20
    assert found.energy_residual < BALANCE
    assert found.impulse_residual < BALANCE
    assert (found.impulse > 0.0) is (contact == {"kind": "rigid", "restitution": 0.5})


@pytest.mark.parametrize("restitution", [0.2, 0.5, 0.9])
def test_the_dashpot_of_a_spring_gives_its_restitution(restitution):
    contact = {"kind": "spring", "stiffness": "1 N/um", "restitution": restitution}
    undamped = {"damping": {"q": 1e9}}
    design = stopped({**PLACE, "contact": contact, "sides": "one"}, mechanism=undamped)
    sizes = design.fixed_sizes()
    task = task_of(design, design.stops, sizes)
    place = stop_place(task, "", 28.4e-3, 1e-9)
    blade, found, _ = stop_scene(design, task, sizes, place, "resonance")
    run = StoppedVibration(blade, found, rate=[1e-3])
    half = pi / OMEGA
    for _ in run.run(sine(amplitude=1e-30, angular=OMEGA, duration=2.5 * half)):
        pass
    speed = run.result().contacts.speed
    # next to the tip the blade's own spring is 1 % of the stop's
    assert speed[1] / speed[0] == pytest.approx(restitution, rel=0.02)


def test_random_is_the_same_for_a_seed_and_only_for_it():
    one, same, other = (only(run(PLACE, cases=RANDOM, seed=seed)) for seed in (1, 1, 2))
    assert one.travel == same.travel != other.travel
    assert (one.seed, other.seed) == (1, 2)


def test_the_peak_between_far_stops_is_that_of_a_gaussian_of_the_modes_rms():
    case = {"launch": {"asd": {**RANDOM["launch"]["asd"], "duration": "4 s"}}}
    found = only(run({**FAR, "simulation": {"confidence": "50 %"}}, cases=case))
    design = stopped(FAR, cases=case)
    sizes = design.fixed_sizes()
    structure = design.mechanism.structure(design.geometry, design.material.elastic, sizes, None)
    rms = random_response(structure, design.cases["launch"].asd).outputs["travel"].rms
    # the greatest of some 700 peaks in clumps of Q/π scatters by a tenth or so
    expected = rms * float(peak_factor(OMEGA / (2 * pi), found.duration))
    assert found.contacts == 0
    assert found.travel == pytest.approx(expected, rel=0.2)


def test_what_shakes_along_the_blade_does_not_bend_it():
    along = {"launch": {"asd": {**RANDOM["launch"]["asd"], "axis": "x and y"}}}
    assert only(run(PLACE, cases=along)).travel == only(run(PLACE, cases=RANDOM)).travel
    only_y = {"launch": {"asd": {**RANDOM["launch"]["asd"], "axis": "y"}}}
    result = run(PLACE, cases=only_y | SINE)
    assert [row.case for row in result.stops.simulations] == ["resonance"]
    assert "travel_free_launch" not in result.values


def test_random_lasts_until_its_confidence_is_reached():
    found = only(run({**PLACE, "simulation": {"confidence": "70 %"}}, cases=RANDOM))
    assert found.planned == pytest.approx(3 * EXPOSURE)
    assert found.confidence == pytest.approx(0.75, rel=1e-6)
    assert found.is_complete


@given(st.floats(0.01, 0.999))
def test_as_many_exposures_as_the_confidence_asks_and_no_more(confidence):
    count = exposures(confidence)
    assert count / (count + 1) >= confidence * (1 - 1e-9)
    assert (count - 1) / count < confidence


def test_the_highest_of_alike_exposures_is_the_next_one_in_one_of_n_plus_one():
    peaks = np.random.default_rng(5).gumbel(size=(20_000, 10))
    assert (peaks[:, -1] > peaks[:, :-1].max(axis=1)).mean() == pytest.approx(0.1, abs=0.007)


def test_in_so_many_repeats_the_next_exposure_has_no_higher_peak_than_those_before():
    # four exposures have a confidence of 80 %; binomial, 80 repeats, 3.5 standard deviations
    repeats, before = 80, 4
    short = {"scale": "-3 dB", "duration": "0.04 s"}
    cases = {"launch": {"asd": {**RANDOM["launch"]["asd"], **short}}}
    design = stopped(PLACE, cases=cases, mechanism=LIVELY)
    many = 1.0 - 0.9 / (repeats * (before + 1))
    assert exposures(0.8) == before
    options = design.stops.simulation.model_copy(update={"confidence": many})
    sizes = design.fixed_sizes()
    task = task_of(design, design.stops, sizes)
    place = stop_place(task, "", 17e-3, 36e-6)
    (run,) = stop_runs(design, task, sizes, place, "launch", options=options)
    peaks = []
    for leg in run.shaken.legs:
        for _ in run.engine.run(leg):
            pass
        peaks.append(run.engine.take_peaks().travel)
    assert run.engine.contact_count > 50
    groups = np.array(peaks[: repeats * (before + 1)]).reshape(repeats, -1)
    met = (groups[:, -1] <= groups[:, :-1].max(axis=1)).mean()
    assert met == pytest.approx(0.8, abs=3.5 * sqrt(0.8 * 0.2 / repeats))


def test_what_was_done_before_an_interruption_is_kept_and_is_no_proof():
    gentle = {"launch": {"asd": {**RANDOM["launch"]["asd"], "scale": "-20 dB"}}}
    whole = run(PLACE, cases=gentle)
    result = run(PLACE, cases=gentle, watch=lambda case, share: share < 0.3)
    found = only(result)
    assert whole.status is Status.PASS
    assert result.status is Status.UNDECIDED
    assert 0.29 < found.duration / found.planned < 0.5  # a flight is flown to its end
    assert found.confidence == pytest.approx(1 - 1 / (1 + found.duration / EXPOSURE))
    # what was not run may go farther: nothing bounds it
    assert check(result, "travel").factor > 1.0
    assert check(result, "travel").factor_range[0] == 0.0
    assert "interrupted" in [note.code for note in result.warnings]


def test_a_history_is_kept_where_it_is_asked():
    result = run(PLACE, cases=RANDOM, keep_history=True)
    (history,) = result.stops.histories
    assert history.case == "launch"
    assert max(map(abs, history.tip)) == pytest.approx(only(result).travel, rel=0.02)
    assert run(PLACE, cases=RANDOM).stops.histories == ()


@pytest.mark.parametrize(
    ("cases", "changes", "words"),
    [({"x": {"stroke": {"translation": "1 um"}}}, {}, "no case shakes the base"),
     (SINE, {"damping": None}, "how the tip mass is damped"),
     ({"x": {"asd": {"profile": {"points": FLAT}, "q": 30}}}, {}, "how long the vibration lasts"),
     ({"x": {"shock": {"srs": [{"frequency": "10 Hz", "acceleration": "1 g"},
                               {"frequency": "1 kHz", "acceleration": "9 g"}]}}},
      {}, "no motion in time")],
)  # fmt: skip
def test_what_cannot_be_run_in_time_is_named(cases, changes, words):
    with pytest.raises(SolveError, match=words):
        run(PLACE, cases=cases, mechanism=changes)


@given(st.floats(1e-6, 1e-3), st.floats(2e-3, 27e-3), st.floats(0.0, 1e-4))
def test_the_force_at_a_travel_is_that_of_the_statics(travel, height, gap):
    design = stopped()
    task = task_of(design, design.stops, design.fixed_sizes())
    place = stop_place(task, "", height, gap)
    expected = load_at_travel(delta=travel, E=E, I=I, L_a=height, L_b=LENGTH - height, d=gap)
    assert force_at_travel(task, place, 0.0, travel) == pytest.approx(float(expected), rel=1e-6)


def test_a_force_beyond_the_end_moves_the_tip_by_its_moment_too():
    design = stopped()
    task = task_of(design, design.stops, design.fixed_sizes())
    place = stop_place(task, "", 17e-3, 1.0)
    c, force = 5e-3, 0.7
    travel = force * (LENGTH**3 / 3 + c * LENGTH**2 / 2) / (E * I)
    assert force_at_travel(task, place, c, travel) == pytest.approx(force, rel=1e-12)


def judged(limits, **changes):
    design = stopped(limits, **changes)
    sizes = design.fixed_sizes()
    return decided(stops(design, sizes, "spec"), design, sizes, on)


def test_a_ball_far_from_its_limits_is_decided_as_a_rigid_stop():
    # Hertz costs many times more and changes half a percent
    result = judged({**PLACE, "travel": "1 mm", "contact": BALL})
    assert check(result, "travel").model == "rigid contact"
    assert check(result, "travel").verdict is not Verdict.UNDECIDED
    assert "Hertz contact" not in result.cost.by_model


def test_a_rigid_stop_tells_what_a_ball_would_change():
    (rigid, hertz) = (
        check(judged({**PLACE, "travel": "1 mm", "contact": c}, mechanism=LIVELY), "travel")
        for c in ({"kind": "rigid"}, BALL)
    )
    wider = [hertz.factor_range[i] - rigid.factor_range[i] for i in (0, 1)]
    assert wider[0] < 0.0 < wider[1]
    ball = only(run({**PLACE, "contact": BALL}, mechanism=LIVELY))
    assert ball.contacts > 20
    assert hertz.factor_range[0] <= 1e-3 / ball.travel <= hertz.factor_range[1]


def test_a_line_in_place_of_hertz_decides_where_a_rigid_stop_leaves_it_open():
    known = {"mechanism": LIVELY}
    most = 1e-3 / check(judged({**PLACE, "travel": "1 mm", "contact": BALL}, **known),
                        "travel").factor_range[0]  # fmt: skip
    limit = 0.998 * most
    limits = {**PLACE, "travel": f"{limit} m", "contact": BALL}
    found = check(judged(limits, **known), "travel")
    assert (found.model, found.verdict) == ("linear contact", Verdict.PASS)
    ball = only(run(limits, **known))
    assert ball.law == "ball, Hertz, elastic"
    assert found.factor_range[0] <= limit / ball.travel <= found.factor_range[1]


def test_a_random_run_that_exceeds_its_limit_ends_and_fails():
    long = {"launch": {"asd": {**RANDOM["launch"]["asd"], "duration": "20 s"}}}
    result = judged({**PLACE, "travel": "90 um"}, cases=long)
    found = only(result)
    assert found.has_decided
    assert not found.is_complete
    assert check(result, "travel").verdict is Verdict.FAIL


def test_a_load_beside_the_vibration_that_no_run_has_leaves_it_undecided():
    both = {"launch": {**SINE["resonance"], "acceleration": {"level": "50 g", "axis": "x"}}}
    result = judged(PLACE, cases=both)
    assert check(result, "travel").factor_range is None
    assert "left-out-of-simulation" in [note.code for note in result.warnings]


def test_of_two_alike_exposures_the_second_is_higher_half_of_the_time():
    # a confidence of one half is one exposure; 24 pairs: 3 standard deviations are 7.3 of them
    design = stopped({**PLACE, "simulation": {"confidence": 0.5}}, cases=RANDOM)
    sizes = design.fixed_sizes()
    task = task_of(design, design.stops, sizes)
    place = stops(design, sizes, "spec").stops.chosen
    peaks = []
    for seed in range(48):
        options = design.stops.simulation.model_copy(update={"seed": seed})
        (one,) = stop_runs(design, task, sizes, place, "launch", options=options)
        peaks.append(one.driven(lambda _: True).travel)
    higher = sum(b > a for a, b in zip(peaks[::2], peaks[1::2], strict=True))
    assert abs(higher - 12) <= 8


@pytest.mark.parametrize("rate", ["40 Hz/s", "20 oct/min"])
@pytest.mark.parametrize("ends", [("100 Hz", "240 Hz"), ("240 Hz", "100 Hz")])
def test_a_sweep_of_displacement_runs_as_tests_specify_it(rate, ends):
    """Without contact a slow sweep peaks as the sine at the resonance, at the level there."""
    start, end = ends
    level = {"displacement": "20 um", "acceleration": "1.5 g"}  # they cross at 136 Hz
    sweep = {"sweep": {**level, "from": start, "to": end, "rate": rate}}
    swept = only(run(FAR, cases={"way": sweep}, mechanism=LIVELY))
    sine = {"sine": {"acceleration": "1.5 g", "frequency": "176 Hz"}}
    steady = only(run(FAR, cases={"one": sine}, mechanism=LIVELY))
    # a mode by itself builds up to all but 1 % at this rate (Q 10)
    assert swept.travel == pytest.approx(steady.travel, rel=0.02)
