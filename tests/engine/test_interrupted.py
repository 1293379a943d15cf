"""A judgement that is interrupted keeps what it had found out, and decides no more."""

from pathlib import Path

import pytest

from flexcli.engine.check import check
from flexcli.engine.judge import Interrupted, judge
from flexcli.engine.models import model_series
from flexcli.engine.simulate import simulate
from flexcli.results import Status, Verdict
from flexcli.spec.load import load

SPEC = """flexure: 1
material: ti-6al-4v
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}
cases:
  work: {stroke: {rotation: 2 deg, cycles: 1e7}}
  far: {stroke: {rotation: 3 deg, cycles: 1e7}}
requirements:
  yield: YIELD
  fatigue: 1.01
"""


def design(folder: Path, strength: float):
    path = folder / "flexure.yaml"
    path.write_text(SPEC.replace("YIELD", repr(strength)))
    return load(path).part


def interrupted(*_):
    raise KeyboardInterrupt


class Endless:
    """A model that is interrupted whenever it is asked."""

    name = "exact"
    joint_model = property(interrupted)


def test_checks_before_an_interruption_are_kept_and_the_rest_is_undecided(tmp_path):
    first = design(tmp_path, 1.01)
    rows = check(first, first.fixed_sizes(), "", "closed-form").checks
    factor = next(row.factor for row in rows if row.name.startswith("yield"))
    spec = design(tmp_path, factor)  # at its limit, so that a finer model is asked
    with pytest.raises(Interrupted) as raised:
        judge(spec, spec.fixed_sizes(), (model_series(spec)[0], Endless()))
    found = {check.name: check for check in raised.value.so_far.checks}
    assert found["fatigue"].verdict is Verdict.PASS
    assert found["yield"].verdict is Verdict.UNDECIDED
    assert "stopped" in found["yield"].quantity
    assert raised.value.so_far.status is Status.UNDECIDED


def test_a_check_that_is_stopped_reports_what_it_had_judged(tmp_path, monkeypatch):
    first = design(tmp_path, 1.01)
    rows = check(first, first.fixed_sizes(), "", "closed-form").checks
    spec = design(tmp_path, next(row.factor for row in rows if row.name.startswith("yield")))
    monkeypatch.setattr(
        "flexcli.engine.check.model_series", lambda *_: (model_series(spec)[0], Endless())
    )
    result = check(spec, spec.fixed_sizes(), "flexure.yaml")
    assert result.status is Status.UNDECIDED
    assert [note.code for note in result.warnings] == ["interrupted"]
    assert Verdict.PASS in [row.verdict for row in result.checks]


def test_a_simulation_keeps_the_cases_that_it_had_done(tmp_path, monkeypatch):
    spec = design(tmp_path, 1.5)
    monkeypatch.setattr("flexcli.engine.simulate.judge", interrupted)
    result = simulate(spec, spec.fixed_sizes(), "flexure.yaml", 5)
    assert [len(sweep.points) for sweep in result.sweeps] == [5, 5]
    assert result.status is Status.UNDECIDED
    assert "interrupted" in [note.code for note in result.warnings]
