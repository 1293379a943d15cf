"""The tools of vibration tests as a user runs them: tolerance, equal damage, spectra, notches."""

import csv
import json

import numpy as np
import pytest

G = 9.80665
STAGE = """\
flexure: 1
material: 7075-t6
geometry: {kind: leaf-spring-stage, h: 1.5 mm, l: 40 mm, b: 15 mm}
mechanism: {kind: payload, mass: 0.5 kg}
cases:
  launch:
    asd: {profile: gevs-qualification, q: 20}
    ends: clamped-guided
requirements:
  dynamic-yield: 1.0
"""


def document(told, code=0):
    assert told.returncode == code, told.stderr or told.stdout
    return json.loads(told.stdout)


def write(path, rows, heading="f [Hz],level [g^2/Hz]"):
    path.write_text("\n".join([heading, *(f"{a!r},{b!r}" for a, b in rows)]) + "\n")


def columns(path):
    with path.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


@pytest.fixture
def limit(tmp_path):
    write(tmp_path / "limit.csv", [(20.0, 0.01), (100.0, 0.05), (2000.0, 0.05)])


@pytest.mark.parametrize(("db", "code"), [(2.9, 0), (3.1, 1), (-2.9, 0), (-3.1, 1)])
def test_a_run_within_3_db_passes_and_one_beyond_exits_1(flexure, tmp_path, limit, db, code):
    rows = [(20.0, 0.01), (100.0, 0.05), (500.0, 0.05 * 10 ** (db / 10.0)), (2000.0, 0.05)]
    write(tmp_path / "run.csv", rows)
    asked = ("--above", "3 dB", "--below", "3 dB", "--format", "json")
    found = document(flexure("asd", "tolerance", "run.csv", "limit.csv", *asked), code)
    name = "most" if db > 0.0 else "least"
    assert found["values"][f"db_{name}"]["value"] == pytest.approx(db, rel=1e-9)
    assert found["values"][f"f_{name}"]["value"] == 500.0
    assert [c["pass"] for c in found["checks"]].count(False) == code


def test_the_rms_has_its_own_limit(flexure, tmp_path, limit):
    write(tmp_path / "run.csv", [(20.0, 0.0125), (100.0, 0.0625), (2000.0, 0.0625)])
    asked = ("asd", "tolerance", "run.csv", "limit.csv", "--above", "3 dB")
    assert flexure(*asked, "--grms", "12 %").returncode == 0  # √1.25 = 1.118
    told = flexure(*asked, "--grms", "10 %")
    assert told.returncode == 1
    assert "FAIL" in told.stdout


def test_a_band_that_was_not_measured_is_out_unless_it_is_not_asked_for(flexure, tmp_path, limit):
    write(tmp_path / "run.csv", [(50.0, 0.025), (100.0, 0.05), (2000.0, 0.05)])
    asked = ("asd", "tolerance", "run.csv", "limit.csv", "--below", "3 dB")
    told = flexure(*asked)
    assert told.returncode == 1
    assert "band-not-covered" in told.stdout
    assert flexure(*asked, "--from", "50 Hz").returncode == 0


def test_the_limits_are_the_profile_s_own_and_missing_ones_are_asked_for(flexure, tmp_path, limit):
    told = flexure("asd", "tolerance", "limit.csv", "limit.csv")
    assert told.returncode == 2
    assert "--above '3 dB'" in told.stderr
    (tmp_path / "own.yaml").write_text(
        "flexure: 1\nasd: {points: limit.csv, tolerance: {above: 1.5 dB, below: 1.5 dB}}\n"
    )
    write(tmp_path / "run.csv", [(20.0, 0.016), (100.0, 0.08), (2000.0, 0.08)])  # 2.04 dB
    assert flexure("asd", "tolerance", "run.csv", "own.yaml").returncode == 1
    assert flexure("asd", "tolerance", "run.csv", "own.yaml", "--above", "3 dB").returncode == 0


def test_one_shape_of_another_duration_is_raised_by_the_ratio_of_times(flexure, limit, tmp_path):
    asked = ("asd", "equal-damage", "limit.csv=10 h", "--duration", "2 min", "-b", "8")
    found = document(flexure(*asked, "--write", "test.yaml", "--format", "json"))
    db = 10.0 * np.log10(300.0) * 2.0 / 8.0
    assert found["values"]["db"]["value"] == pytest.approx(db, rel=1e-9)
    back = ("asd", "equal-damage", "test.yaml", "--duration", "10 h", "-b", "8")
    again = document(flexure(*back, "--format", "json"))
    assert again["values"]["db"]["value"] == pytest.approx(-db, rel=1e-9)
    assert {note["code"] for note in found["warnings"]} == {"higher-peaks"}
    assert not again["warnings"]


def test_another_shape_does_no_less_damage_at_any_frequency(flexure, limit):
    asked = ("asd", "equal-damage", "limit.csv=1 h", "gevs-acceptance=1 min", "--shape",
             "nasa-std-7001-workmanship", "--duration", "5 min", "-b", "6")  # fmt: skip
    found = document(flexure(*asked, "--format", "json"))
    f, wanted, made = (column["values"] for column in found["spectra"][0]["columns"])
    ratio = np.array(made) / np.array(wanted)
    assert ratio.min() == pytest.approx(1.0, rel=1e-9)
    governing = found["values"]["f_governing"]["value"]
    assert ratio[np.argmin(np.abs(np.array(f) - governing))] == pytest.approx(1.0, rel=1e-9)
    excess = found["values"]["db_excess"]["value"]
    assert 10.0 * np.log10(ratio.max()) * 2.0 / 6.0 == pytest.approx(excess, rel=1e-9)


def test_an_environment_without_a_duration_is_asked_for_it(flexure, limit):
    told = flexure("asd", "equal-damage", "limit.csv", "--duration", "2 min", "-b", "8")
    assert told.returncode == 2
    assert "nothing says how long limit.csv lasts" in told.stderr


def test_a_sum_of_equal_profiles_is_3_db_above_one(flexure, limit, tmp_path):
    told = flexure("asd", "combine", "limit.csv", "limit.csv", "--format", "json")
    one = document(flexure("asd", "grms", "limit.csv", "--format", "json"))["profiles"][0]["g_rms"]
    assert document(told)["values"]["g_rms"]["value"] == pytest.approx(one, rel=1e-3)
    (tmp_path / "again.csv").write_text((tmp_path / "limit.csv").read_text())
    told = flexure("asd", "combine", "limit.csv", "again.csv", "--format", "json")
    both = document(told)["values"]["g_rms"]["value"]
    assert both == pytest.approx(np.sqrt(2.0) * one, rel=1e-12)
    told = flexure("asd", "combine", "limit.csv", "again.csv", "--rule", "envelope", "--format",
                  "json")  # fmt: skip
    assert document(told)["values"]["g_rms"]["value"] == pytest.approx(one, rel=1e-12)


def test_a_record_s_spectrum_is_saved_and_its_units_are_read(flexure, tmp_path):
    t = np.arange(0, 0.05, 1e-4)
    pulse = np.where(t < 0.011, 50.0 * np.sin(np.pi * t / 0.011), 0.0)
    rows = list(zip((1e3 * t).tolist(), pulse.tolist(), strict=True))
    write(tmp_path / "pulse.csv", rows, "time [ms],acceleration [g]")
    asked = ("asd", "srs", "pulse.csv", "--q", "1000", "--from", "20 Hz", "--to", "800 Hz",
             "--per-octave", "24", "-o", "srs.csv", "--format", "json")  # fmt: skip
    found = document(flexure(*asked))
    # the largest of an undamped oscillator is 1.7685 times the peak (Ayre)
    assert found["values"]["srs_max"]["value"] == pytest.approx(1.7685 * 50.0 * G, rel=2e-3)
    saved = columns(tmp_path / "srs.csv")
    assert saved["srs [m/s^2]"].max() == found["values"]["srs_max"]["value"]
    assert saved["frequency [Hz]"][0] == pytest.approx(20.0)


def test_a_saved_spectrum_is_a_shock_of_a_design(flexure, tmp_path):
    t = np.arange(0, 0.2, 2e-4)
    rows = list(zip(t.tolist(), np.sin(np.pi * t / 0.02).tolist(), strict=True))
    write(tmp_path / "rec.csv", rows[:100], "t_s,a_g")
    told = flexure("asd", "srs", "rec.csv", "--from", "1 Hz", "--to", "99 kHz", "-o", "srs.csv")
    assert told.returncode == 0, told.stderr
    assert "coarse-record" in told.stdout
    shock = "shock: {srs: {file: srs.csv, column: srs}}"
    (tmp_path / "flexure.yaml").write_text(
        STAGE.replace("asd: {profile: gevs-qualification, q: 20}", shock)
    )
    found = json.loads(flexure("asd", "response", "--format", "json").stdout)
    peaks = {row["name"]: row["peak"] for row in found["responses"][0]["outputs"]}
    # the payload's own mode carries nearly all of the force: mass times the spectrum there
    mode = 1.5**1.5 / 0.5**1.5 * 15.1
    saved = columns(tmp_path / "srs.csv")
    spectrum = np.interp(mode, saved["frequency [Hz]"], saved["srs [m/s^2]"])
    assert peaks["force joint"] == pytest.approx(0.5 * spectrum, rel=0.1)


def test_a_record_out_of_step_or_out_of_order_is_refused(flexure, tmp_path):
    write(tmp_path / "rec.csv", [(0.0, 1.0), (1.0, 2.0), (1.5, 1.0), (4.0, 0.0)], "t [s],a [g]")
    told = flexure("asd", "srs", "rec.csv")
    assert told.returncode == 2
    assert "not at equal steps" in told.stderr
    write(tmp_path / "rec.csv", [(0.0, 1.0), (2.0, 2.0), (1.5, 1.0)], "t [s],a [g]")
    told = flexure("asd", "srs", "rec.csv")
    assert told.returncode == 2
    assert "rec.csv:4:1" in told.stderr


def test_a_random_vibration_has_an_extreme_spectrum_and_a_damage_spectrum(flexure, limit):
    asked = ("limit.csv", "--duration", "2 min", "--format", "json")
    found = document(flexure("asd", "srs", *asked))
    names = [column["name"] for column in found["spectra"][0]["columns"]]
    assert names == ["frequency", "extreme", "rms pseudo", "rms absolute"]
    low, high = (
        np.array(document(flexure("asd", "fds", *asked, "-b", b))["spectra"][0]["columns"][1][
            "values"]) for b in ("4", "8")
    )  # fmt: skip
    assert (high < low).all()  # displacements are far below a metre


def test_a_profile_without_a_duration_has_no_extreme(flexure, limit):
    told = flexure("asd", "srs", "limit.csv")
    assert told.returncode == 2
    assert "--duration" in told.stderr


def test_a_notch_holds_the_force_and_specs_take_what_it_writes(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text(STAGE)
    for name in ("notched.yaml", "notched.csv"):
        told = flexure("asd", "notch", "--c", "1.2", "--write", name, "--format", "json")
        found = document(told)
        _, force, limit, without = (
            np.array(column["values"]) for column in found["spectra"][0]["columns"]
        )
        assert (force <= limit * (1.0 + 1e-9)).all()
        assert without.max() > 10.0 * limit.max()
        assert found["values"]["F_rms_notched"]["value"] < found["values"]["F_rms"]["value"]
        plain = json.loads(flexure("check", "--format", "json").stdout)["checks"][0]["factor"]
        profile = f"cases.launch.asd.profile={name}"
        lowered = json.loads(flexure("check", "--set", profile, "--format", "json").stdout)
        assert lowered["checks"][0]["factor"] > 1.5 * plain


def test_a_heavy_fixture_beside_the_item_needs_a_shallower_notch(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text(STAGE)
    asked = ("asd", "notch", "--c", "1.2", "--knee", "2 kHz", "--format", "json")
    told = [document(flexure(*asked, *mass)) for mass in ((), ("--fixed-mass", "5 kg"))]
    depths = [found["values"]["db_deepest"]["value"] for found in told]
    assert depths[0] < depths[1] < 0.0


def test_the_constant_of_a_force_limit_is_asked_for(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text(STAGE)
    told = flexure("asd", "notch")
    assert told.returncode == 2
    assert "add --c" in told.stderr
