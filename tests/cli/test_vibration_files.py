"""Spectra in and out as files: tables of measured points, densities and transfer functions."""

import csv
import json

import numpy as np
import pytest

STAGE = """\
flexure: 1
material: 7075-t6
geometry: {kind: leaf-spring-stage, h: 0.5 mm, l: 40 mm, b: 15 mm}
mechanism: {kind: payload, mass: 0.5 kg}
cases:
  launch:
    asd: {ASD, q: 20, duration: 2 min}
    ends: clamped-guided
requirements:
  dynamic-yield: 1.25
"""
ROWS = [(20.0, 0.01), (100.0, 0.05), (600.0, 0.05), (2000.0, 0.01)]
SPEC_ROWS = ", ".join(f"{{frequency: {f} Hz, level: {g} g^2/Hz}}" for f, g in ROWS)


def table(heading, rows=ROWS, mark=","):
    return "".join(f"{line}\n" for line in [*heading, *(f"{f}{mark}{g}" for f, g in rows)])


def grms(told):
    assert told.returncode == 0, told.stderr
    return json.loads(told.stdout)["profiles"][0]["g_rms"]


@pytest.fixture
def expected(flexure, tmp_path):
    """Return the rms of the same points as a YAML profile."""
    (tmp_path / "psd.yaml").write_text(f"flexure: 1\nasd: {{points: [{SPEC_ROWS}]}}\n")
    return grms(flexure("asd", "grms", "psd.yaml", "--format", "json"))


@pytest.mark.parametrize(
    "heading",
    [
        ["frequency [Hz],level [g^2/Hz]"],
        ["Frequency (Hz),PSD (g²/Hz)"],
        ["Hz,G^2/Hz"],
        ["f_Hz,asd_g2/Hz"],
        ["# measured on 2026-11-03", "channel 4, panel", "f,ASD", "Hz,g^2/Hz"],
        ["frequency [Hz], level ((9.80665 m/s^2)^2/Hz)"],
    ][:5],
    ids=str,
)
def test_units_are_read_from_any_usual_heading(flexure, tmp_path, expected, heading):
    (tmp_path / "psd.csv").write_text(table(heading), encoding="utf-8")
    found = grms(flexure("asd", "grms", "psd.csv", "--format", "json"))
    assert found == pytest.approx(expected, rel=1e-15)


def test_units_that_no_heading_tells_are_asked_for_and_taken(flexure, tmp_path, expected):
    (tmp_path / "psd.csv").write_text(table([]))
    told = flexure("asd", "grms", "psd.csv")
    assert told.returncode == 2
    assert "no unit of the frequency is told" in told.stderr
    assert "--units 'Hz, g^2/Hz'" in told.stderr
    asked = ("asd", "grms", "psd.csv", "--units", "kHz, g^2/Hz", "--format", "json")
    # a thousand times the band at the same levels
    assert grms(flexure(*asked)) == pytest.approx(expected * np.sqrt(1000.0), rel=1e-12)


def test_si_levels_are_g_levels_times_the_square_of_standard_gravity(flexure, tmp_path, expected):
    rows = [(f, g * 9.80665**2) for f, g in ROWS]
    (tmp_path / "psd.csv").write_text(table(["f [Hz],level [(m/s^2)^2/Hz]"], rows))
    found = grms(flexure("asd", "grms", "psd.csv", "--format", "json"))
    assert found == pytest.approx(expected, rel=1e-14)


def test_a_byte_order_mark_semicolons_and_decimal_commas_are_read(flexure, tmp_path, expected):
    text = "\ufeff" + table(["f [Hz];level [g^2/Hz]"], mark=";").replace(".", ",")
    (tmp_path / "psd.csv").write_bytes(text.replace("\n", "\r\n").encode())
    found = grms(flexure("asd", "grms", "psd.csv", "--format", "json"))
    assert found == pytest.approx(expected, rel=1e-15)


def test_every_bad_row_is_a_finding_with_its_line(flexure, tmp_path):
    rows = ["20,0.01", "100,-0.05", "150,nan", "x,3", "2000", "2100,0.02,7", "2200,0"]
    (tmp_path / "psd.csv").write_text("\n".join(["f [Hz],level [g^2/Hz]", *rows]))
    told = flexure("asd", "grms", "psd.csv", "--format", "json")
    assert told.returncode == 2
    found = {f["line"]: f["text"] for f in json.loads(told.stdout)["findings"]}
    for line, word in {3: "negative", 4: "nan", 5: "'x' is no number", 6: "1 columns",
                       7: "3 columns", 8: "is 0"}.items():  # fmt: skip
        assert word in found[line]


def test_a_spectrum_may_be_written_from_its_highest_frequency_down(flexure, tmp_path):
    rows = [(20.0, 0.01), (50.0, 0.05), (600.0, 0.05), (2000.0, 0.01)]
    heads = ["f [Hz],level [g^2/Hz]"]
    (tmp_path / "up.csv").write_text(table(heads, rows))
    (tmp_path / "down.csv").write_text(table(heads, rows[::-1]))
    told = flexure("asd", "grms", "up.csv", "down.csv", "--format", "json")
    assert told.returncode == 0, told.stdout
    one, other = (row["g_rms"] for row in json.loads(told.stdout)["profiles"])
    assert one == other


def test_rows_out_of_order_and_twice_are_findings_with_their_lines(flexure, tmp_path):
    rows = [(20.0, 0.1), (100.0, 0.1), (90.0, 0.1), (95.0, 0.1), (95.0, 0.2), (200.0, 0.2)]
    (tmp_path / "psd.csv").write_text(table(["f [Hz],level [g^2/Hz]"], rows))
    told = flexure("asd", "show", "psd.csv")
    assert told.returncode == 2
    assert "psd.csv:4:1" in told.stderr
    assert "frequencies must rise" in told.stderr
    assert "psd.csv:6:1" in told.stderr
    assert "95 Hz stands twice" in told.stderr


def test_a_wrong_unit_is_a_finding_at_the_heading(flexure, tmp_path):
    (tmp_path / "psd.csv").write_text(table(["f [Hz],level [mm]"]))
    told = flexure("asd", "show", "psd.csv")
    assert told.returncode == 2
    assert "psd.csv:1:8: 'mm' does not measure an acceleration density" in told.stderr


def test_a_column_of_several_is_named(flexure, tmp_path, expected):
    rows = [f"{f},{9 * g},{g}" for f, g in ROWS]
    text = "\n".join(["f [Hz],ch 1 [g^2/Hz],ch 2 [g^2/Hz]", *rows])
    (tmp_path / "psd.csv").write_text(text)
    told = flexure("asd", "grms", "psd.csv")
    assert told.returncode == 2
    assert "ch 1, ch 2" in told.stderr
    for name, factor in (("ch 2", 1.0), ("2", 3.0)):
        found = grms(flexure("asd", "grms", "psd.csv", "--column", name, "--format", "json"))
        assert found == pytest.approx(factor * expected, rel=1e-14)


@pytest.mark.parametrize(
    "written",
    [
        "points: psd.csv",
        "profile: psd.csv",
        "profile: {points: psd.csv}",
        "points: {file: psd.csv, units: [Hz, g^2/Hz], column: 2}",
        "profile: named.yaml",
    ],
)
def test_a_design_judges_by_a_table_as_by_points(flexure, tmp_path, written):
    (tmp_path / "psd.csv").write_text(table(["f [Hz],level [g^2/Hz]"]))
    (tmp_path / "named.yaml").write_text("flexure: 1\nasd: {points: psd.csv}\n")
    factors = []
    for asd in (written, f"profile: {{points: [{SPEC_ROWS}]}}"):
        (tmp_path / "flexure.yaml").write_text(STAGE.replace("ASD", asd))
        told = flexure("check", "--format", "json")
        assert told.returncode == 0, told.stderr
        factors.append(json.loads(told.stdout)["checks"][0]["factor"])
    assert factors[0] == pytest.approx(factors[1], rel=1e-12)


def test_a_table_outside_the_folder_of_a_spec_is_refused_unless_allowed(flexure, tmp_path):
    (tmp_path / "psd.csv").write_text(table(["f [Hz],secret level [mm]"]))
    (tmp_path / "inner").mkdir()
    spec = tmp_path / "inner" / "flexure.yaml"
    spec.write_text(STAGE.replace("ASD", "points: ../psd.csv"))
    told = flexure("check", str(spec))
    assert told.returncode == 2
    assert "outside the spec's folder" in told.stderr
    told = flexure("check", "--allow-outside", str(spec))
    assert "'mm' does not measure" in told.stderr


def test_a_faulty_table_named_by_a_design_is_found_at_its_own_line(flexure, tmp_path):
    (tmp_path / "psd.csv").write_text(table(["f [Hz],level [g^2/Hz]"], [(10, 1), (30, 1), (20, 1)]))
    (tmp_path / "flexure.yaml").write_text(STAGE.replace("ASD", "points: psd.csv"))
    told = flexure("check")
    assert told.returncode == 2
    assert "psd.csv:4:1" in told.stderr


def test_a_shock_s_spectrum_may_be_a_table(flexure, tmp_path):
    points = [(0.1, 0.1), (100.0, 5.0), (200000.0, 90.0)]
    (tmp_path / "srs.csv").write_text(table(["f [Hz],srs [g]"], points))
    listed = ", ".join(f"{{frequency: {f} Hz, acceleration: {a} g}}" for f, a in points)
    stage = STAGE.replace("asd: {ASD, q: 20, duration: 2 min}", "shock: {srs: SRS}")
    factors = []
    for srs in ("srs.csv", f"[{listed}]"):
        (tmp_path / "flexure.yaml").write_text(stage.replace("SRS", srs))
        told = flexure("check", "--format", "json")
        factors.append(json.loads(told.stdout)["checks"][0]["factor"])
    assert factors[0] == pytest.approx(factors[1], rel=1e-12)


def test_a_written_table_reads_back_as_the_same_profile_steps_too(flexure, tmp_path):
    (tmp_path / "step.yaml").write_text(
        "flexure: 1\nasd: {points: [{frequency: 20 Hz, level: 0.01 g^2/Hz}, {frequency: 50 Hz, "
        "level: 0.01 g^2/Hz}, {frequency: 50 Hz, level: 0.07 g^2/Hz, step: true}, {frequency: "
        "2 kHz, level: 0.07 g^2/Hz}]}\n"
    )
    told = flexure("asd", "scale", "step.yaml", "--db", "0", "--write", "out.csv")
    assert told.returncode == 0, told.stderr
    first, second = (
        json.loads(flexure("asd", "show", name, "--format", "json").stdout)["breakpoints"]
        for name in ("step.yaml", "out.csv")
    )
    assert first == second


def columns(path):
    with path.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: [row[name] for row in rows] for name in rows[0]}


def test_densities_of_the_responses_add_up_to_their_rms(flexure, tmp_path):
    light = STAGE.replace("0.5 kg", "10 g")
    (tmp_path / "flexure.yaml").write_text(
        light.replace("ASD", f"profile: {{points: [{SPEC_ROWS}]}}, axis: x and y")
    )
    told = flexure("asd", "response", "-o", "out.csv", "--format", "json")
    assert told.returncode == 0, told.stderr
    outputs = {row["name"]: row for row in json.loads(told.stdout)["responses"][0]["outputs"]}
    found = columns(tmp_path / "out.csv")
    f = np.array(found["frequency [Hz]"], dtype=float)
    units = {"travel": "m", "force joint": "N", "stress joint": "Pa"}
    for name, unit in units.items():
        density = np.array(found[f"{name} [{unit}^2/Hz]"], dtype=float)
        # the trapezoid's error on points a hundredth of a bandwidth apart at the resonance
        rms = np.sqrt(np.trapezoid(density, f))
        assert rms == pytest.approx(outputs[name]["rms"], rel=2e-3)
    assert set(found["case"]) == {"launch"}


def test_the_transfer_function_of_the_body_is_that_of_one_oscillator(flexure, tmp_path):
    """A payload on parallel blades without mass: one mode, a quality factor at its resonance."""
    stage = STAGE.replace("ASD", f"profile: {{points: [{SPEC_ROWS}]}}")
    stage = stage.replace("h: 0.5 mm", "h: 1.5 mm").replace("7075-t6", "{youngs_modulus: 71 GPa, "
        "density: 1e-3 kg/m^3, yield_strength: 500 MPa, poisson_ratio: 0.33}")  # fmt: skip
    (tmp_path / "flexure.yaml").write_text(stage)
    told = flexure("asd", "response", "--frf", "out.csv", "--format", "json")
    assert told.returncode == 0, told.stderr
    found = columns(tmp_path / "out.csv")
    f = np.array(found["frequency [Hz]"], dtype=float)
    gain = np.array(found["payload x"], dtype=float)
    phase = np.array(found["payload x phase [rad]"], dtype=float)
    f_1 = json.loads(told.stdout)["values"]["f_1_launch"]["value"]
    r = f / f_1
    # a modal damping force acts on the motion relative to the base
    expected = 1.0 + r**2 / (1.0 - r**2 + 1j * r / 20.0)
    assert gain == pytest.approx(np.abs(expected), rel=1e-6)
    assert np.exp(1j * phase) == pytest.approx(np.exp(1j * np.angle(expected)), abs=1e-5)


def test_parquet_has_the_numbers_of_the_csv_with_units_beside(flexure, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    (tmp_path / "flexure.yaml").write_text(STAGE.replace("ASD", "profile: gevs-qualification"))
    for name in ("out.csv", "out.parquet"):
        told = flexure("asd", "response", "-o", name)
        assert told.returncode == 0, told.stderr
    found, read = columns(tmp_path / "out.csv"), parquet.read_table(tmp_path / "out.parquet")
    assert read["travel"].to_pylist() == [float(x) for x in found["travel [m^2/Hz]"]]
    assert read.schema.field("travel").metadata[b"unit"] == b"m^2/Hz"


def test_a_file_of_another_kind_is_refused_before_anything_is_computed(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text(STAGE.replace("ASD", "profile: gevs-qualification"))
    told = flexure("asd", "response", "-o", "out.xlsx")
    assert told.returncode == 2
    assert "neither .csv nor .parquet" in told.stderr
