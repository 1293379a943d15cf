"""A measured motion of the base: in a case, from CSV and Parquet, judged and simulated."""

import json

import numpy as np
import pytest

BENDER = """\
flexure: 1
material: {youngs_modulus: 60 GPa, yield_strength: 55.4 MPa, poisson_ratio: 0.36}
geometry: {kind: cantilever, h: 1.25 mm, l: 28.5 mm, b: 7.8 mm}
mechanism: {kind: tip-mass, mass: 8.07 g, damping: {q: 30}}
cases:
  drop: {shock: SHOCK}
requirements: {dynamic-yield: 1.1}
"""
STOPS = """\
stops: {height: 20 mm, gap: 50 um, travel: 125 um, contact: {kind: rigid}}
"""
WIDTH, PEAK, STEP = 2e-3, 400.0, 1e-5


@pytest.fixture
def told(flexure, tmp_path):
    """Return the JSON of a command for a shock."""
    t = np.arange(0.0, 3.0 * WIDTH, STEP)
    a = np.where(t < WIDTH, PEAK * np.sin(np.pi * t / WIDTH), 0.0)
    rows = "".join(f"{x!r},{y!r}\n" for x, y in zip(t.tolist(), a.tolist(), strict=True))
    (tmp_path / "base.csv").write_text("time [s],acceleration [m/s^2]\n" + rows)

    def run(shock, *command, stops=""):
        spec = BENDER.replace("SHOCK", shock) + stops
        (tmp_path / "flexure.yaml").write_text(spec)
        answer = flexure(*command, "--format", "json")
        assert answer.returncode in (0, 1), answer.stdout + answer.stderr
        return json.loads(answer.stdout)

    return run


PULSE = f"{{half-sine: {{acceleration: {PEAK} m/s^2, duration: {WIDTH} s}}, q: 30}}"


def test_a_recorded_half_sine_is_judged_as_the_half_sine_itself(told):
    (pulse,) = told(PULSE, "check")["checks"]
    (record,) = told("{record: base.csv, q: 30}", "check")["checks"]
    # straight lines between 200 samples of the pulse
    assert record["demand"] == pytest.approx(pulse["demand"], rel=1e-3)


def test_a_record_drives_the_stops_as_the_pulse_itself(told):
    runs = [
        told(shock, "stops", "--simulate", stops=STOPS)["stops"]["simulations"]
        for shock in (PULSE, "{record: base.csv, q: 30}")
    ]
    (pulse,), (record,) = runs
    assert record["contacts"] == pulse["contacts"] > 0
    assert record["travel"] == pytest.approx(pulse["travel"], rel=1e-3)
    assert "600 samples" in record["kind"]
    assert record["energy_residual"] < 1e-6


def test_parquet_reads_as_csv_does(told, tmp_path):
    arrow, parquet = pytest.importorskip("pyarrow"), pytest.importorskip("pyarrow.parquet")
    lines = (tmp_path / "base.csv").read_text().splitlines()[1:]
    columns = np.array([line.split(",") for line in lines], dtype=float).T
    names = ["time [s]", "acceleration [m/s^2]"]
    table = arrow.table(dict(zip(names, columns, strict=True)))
    parquet.write_table(table, tmp_path / "base.parquet")
    by_csv, by_parquet = (
        told(f"{{record: base.{suffix}, q: 30}}", "check")["checks"][0]["demand"]
        for suffix in ("csv", "parquet")
    )
    assert by_parquet == pytest.approx(by_csv, rel=1e-12)


@pytest.mark.parametrize(
    ("shock", "said"),
    [
        ("{record: 3}", "a table over time is expected"),
        ("{record: nowhere.csv}", "there is no"),
        ("{record: base.csv, velocity: 1 m/s}", "give one of the four"),
        ("{record: [{time: 0 s}]}", "a table"),
    ],
)
def test_what_is_no_record_is_a_finding(flexure, told, tmp_path, shock, said):
    (tmp_path / "flexure.yaml").write_text(BENDER.replace("SHOCK", shock))
    found = flexure("check")
    assert found.returncode == 2
    assert said in found.stderr
