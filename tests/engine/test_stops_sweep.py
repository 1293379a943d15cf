"""The frequency response with stops: where the blade touches, and the range with two motions."""

from math import exp, hypot, pi, sqrt

import pytest
from stop_designs import LENGTH, MASS, SINE, E, I, stopped

from flexcli.engine.stopping import ratios as along_the_line
from flexcli.engine.stopping import sweep as module
from flexcli.engine.stopping.ratios import ratios
from flexcli.engine.stopping.simulation import simulated
from flexcli.engine.stopping.statics import task_of
from flexcli.engine.stopping.sweep import swept
from flexcli.engine.stops import stops
from flexcli.errors import SolveError

pytestmark = pytest.mark.slow  # runs in time, contact by contact

OWN = f"{sqrt(3 * E * I / LENGTH**3 / MASS) / (2 * pi)} Hz"
PLACE = {"height": "17 mm", "gap": "36 um"}
SWEEP = {"from": "160 Hz", "to": "230 Hz", "rate": "100 Hz/s", "acceleration": "2 g"}


@pytest.fixture(autouse=True, scope="module")
def _few_steps():
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(module, "STEPS", 15)
        monkeypatch.setattr(module, "KICKS", 1)
        monkeypatch.setattr(along_the_line, "COUNT", 2)
        yield


def whole(cases, stops_=PLACE, watch=lambda *_: True, **changes):
    design = stopped(stops_, cases=cases, **changes)
    sizes = design.fixed_sizes()
    return swept(stops(design, sizes, "spec"), design, sizes, watch)


def run(*arguments, **changes):
    return whole(*arguments, **changes).stops.sweeps


@pytest.fixture(scope="module")
def sweep(_few_steps):
    """Return the frequency response of the blade between its stops."""
    (found,) = run(SINE)
    return found


def test_stops_stiffen_going_up_keeps_contact_longer_than_going_down_finds_it(sweep):
    assert sweep.contact_up[1] > sweep.contact_down[1]
    assert sweep.metastable == (sweep.contact_down[1], sweep.contact_up[1])
    inside = [s for s in sweep.steps if sweep.metastable[0] < s.frequency < sweep.metastable[1]]
    up, down = (max(s.travel for s in inside if s.up is way) for way in (True, False))
    assert up > 1.5 * down


def test_between_far_stops_both_ways_are_the_same():
    (sweep,) = run(SINE, {"height": "17 mm", "gap": "10 mm"})
    assert sweep.metastable is sweep.contact_up is sweep.contact_down is None
    up, down = ([s.travel for s in sweep.steps if s.up is way] for way in (True, False))
    assert up == pytest.approx(down[::-1], rel=1e-12)


@pytest.mark.parametrize("q", [30, 290, 10_000])
def test_without_contact_every_step_is_the_exact_steady_state(q):
    # a mass on its spring: A/√((ω_0² − ω²)² + (ω ω_0/Q)²), whatever the time to settle
    far = {"height": "17 mm", "gap": "400 mm"}
    (sweep,) = run(SINE, far, mechanism={"damping": {"q": q}})
    own = sqrt(3 * E * I / LENGTH**3 / MASS)
    for step in sweep.steps:
        omega = 2 * pi * step.frequency
        exact = 1.5 * 9.80665 / hypot(own**2 - omega**2, omega * own / q)
        assert step.settled
        assert step.travel == pytest.approx(exact, rel=1e-9)
        # what is not steady dies by exp(−π ω_0/(ω Q)) in a period
        assert step.multiplier == pytest.approx(exp(-pi * own / (omega * q)), rel=1e-9)


def test_contact_is_followed_beyond_the_response_to_where_it_ends(sweep):
    last = max(s.frequency for s in sweep.steps if s.contacts)
    assert last > 1.3 * 176.0
    assert last <= sweep.contact_up[1] < 1.05 * last


@pytest.mark.parametrize("rate", ["100 Hz/s", "40 oct/min"])
def test_a_sweep_runs_at_its_own_rate_both_ways(rate):
    sweep, steady = run({"climb": {"sweep": {**SWEEP, "rate": rate}}})
    frequencies = [[s.frequency for s in sweep.steps if s.up is way] for way in (True, False)]
    assert frequencies[0] == frequencies[1][::-1] == sorted(frequencies[0])
    assert len(frequencies[0]) == 15
    assert sweep.metastable is not None
    # beside it what it would be at no rate: a resonance takes time to build up
    assert steady.how == "from one steady motion to the next"
    assert steady.contact_up[0] < sweep.contact_up[0] * (1.0 + 0.5 / 15)


def test_a_sweep_that_falls_comes_back_up():
    falling = {**SWEEP, "from": "230 Hz", "to": "160 Hz"}
    sweep, _ = run({"fall": {"sweep": falling}})
    assert not sweep.steps[0].up
    assert sweep.metastable is not None


def test_an_interrupted_response_keeps_its_steps():
    (sweep,) = run(SINE, watch=lambda case, share: share < 0.2)
    assert len(sweep.steps) == 7
    assert "interrupted after 7 of 31 steps" in sweep.how
    assert sweep.metastable is None
    assert not sweep.is_complete


def test_an_interrupted_response_is_no_pass_and_its_time_is_in_the_cost():
    cut = whole(SINE, watch=lambda *_: False)
    assert cut.status.exit_code == 1
    assert "interrupted" in [note.code for note in cut.warnings]
    (sweep,) = cut.stops.sweeps
    assert cut.cost.by_model["periodic motions"] == sweep.seconds > 0.0
    assert cut.cost.seconds >= sweep.seconds


def test_the_range_of_two_motions_goes_from_touch_to_fold_with_the_blow_between_them(sweep):
    low, high = sweep.metastable
    ends = {end.why: end.frequency for end in sweep.ends}
    assert ends["it folds back, no such motion lies beyond"] == high
    touches = [end.frequency for end in sweep.ends if end.why == "it reaches the stop"]
    assert touches == pytest.approx([sweep.contact_up[0], low])
    # where the motion without contact goes as far as the gap, by its closed form
    own = sqrt(3 * E * I / LENGTH**3 / MASS)
    at_tip = 36e-6 * 2 / (17 / 28.5) ** 2 / (3 - 17 / 28.5)
    for frequency in touches:
        omega = 2 * pi * frequency
        reach = 1.5 * 9.80665 / hypot(own**2 - omega**2, omega * own / 30)
        assert reach == pytest.approx(at_tip, rel=1e-9)
    (kick,) = sweep.kicks
    assert low < kick.frequency < high
    assert 0.0 < kick.none < kick.enough
    assert kick.speed_enough == pytest.approx(kick.enough / MASS)


def test_along_the_line_the_range_over_the_gap_is_that_of_a_run_once_steady():
    design = stopped(PLACE, cases={"at": {"sine": {"acceleration": "1.5 g", "frequency": OWN}}})
    sizes = design.fixed_sizes()
    task = task_of(design, design.stops, sizes)
    found = list(ratios(design, task, sizes, "at", 1.5 * 9.80665, lambda: True))
    for row in found:
        # the tip goes farther than where it touches when held, and the line lies not far off
        assert row.threshold < row.simulated < 1.1 * row.line
    place = {"height": f"{found[0].L_a} m", "gap": f"{found[0].delta_G} m"}
    design = stopped(place, cases={"at": {"sine": {"acceleration": "1.5 g", "frequency": OWN}}})
    run_ = simulated(stops(design, sizes, ""), design, sizes, lambda *_: True)
    (steady,) = run_.stops.simulations
    # a run counts as steady where a thousandth of its first swing is left
    assert steady.pi_5 == pytest.approx(found[0].simulated, rel=2e-3)


def test_an_interruption_within_a_part_of_a_sweep_is_heard():
    slow = {"climb": {"sweep": {**SWEEP, "rate": "0.1 Hz/s"}}}
    asked = []
    sweeps = run(slow, watch=lambda *_: asked.append(1) or len(asked) < 3)
    assert not any(sweep.is_complete for sweep in sweeps)
    assert sweeps[0].steps == ()


def test_without_a_sine_there_is_no_response():
    with pytest.raises(SolveError, match="no case has a sine"):
        run({"kick": {"shock": {"velocity": "0.1 m/s"}}})
