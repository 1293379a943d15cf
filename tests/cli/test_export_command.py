"""``flexure export`` writes one file, never over another, and says what it lacks."""

import sys

import pytest

SPEC = """\
flexure: 1
material: {name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3}
geometry: {kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}
cases:
  a: {stroke: {translation: 1 mm}}
requirements: {parasitic_shift: {max: 0.1 mm}}
"""


@pytest.fixture
def spec(tmp_path):
    (tmp_path / "arm.yaml").write_text(SPEC)
    return tmp_path


def test_it_writes_a_file_beside_and_none_over_another(flexure, spec):
    pytest.importorskip("ezdxf")
    first = flexure("export", "arm.yaml", "--to", "dxf")
    assert (first.returncode, first.stdout) == (0, "wrote arm.dxf\n")
    assert b"LWPOLYLINE" in (spec / "arm.dxf").read_bytes()
    again = flexure("export", "arm.yaml", "--to", "dxf")
    assert again.returncode == 2
    assert "--force" in again.stderr
    assert flexure("export", "arm.yaml", "--to", "dxf", "--force").returncode == 0


@pytest.mark.parametrize(("to", "library"), [("dxf", "ezdxf"), ("step", "OCP"), ("stl", "OCP")])
def test_without_its_library_it_names_the_extra(flexure, spec, monkeypatch, to, library):
    for name in [n for n in sys.modules if n.partition(".")[0] == library]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, library, None)
    told = flexure("export", "arm.yaml", "--to", to)
    assert told.returncode == 2
    assert "flexcli[cad]" in told.stderr
    assert [path.name for path in spec.iterdir()] == ["arm.yaml"]


def test_what_a_wire_cuts_is_one_plate_and_what_it_cannot_cut_is_told(flexure, spec):
    pytest.importorskip("ezdxf")
    pytest.importorskip("OCP")
    wire = "manufacturing: {process: wire-edm, wire: 0.2 mm}\n"
    (spec / "sharp.yaml").write_text(SPEC + wire)
    (spec / "cut.yaml").write_text(SPEC.replace("b: 2 mm", "b: 2 mm, root_radius: 0.2 mm") + wire)
    told = flexure("export", "sharp.yaml", "--to", "dxf")
    assert told.returncode == 2
    assert "roots of blade are sharp" in told.stderr
    assert flexure("export", "sharp.yaml", "--to", "dxf", "--plain").returncode == 0
    told = flexure("export", "cut.yaml", "--to", "dxf")
    assert told.returncode == 0
    assert "slots of 0.2 mm" in told.stderr
    assert b"SLOTS" in (spec / "cut.dxf").read_bytes()


def test_it_takes_one_spec_and_a_format_that_there_is(flexure, spec):
    assert flexure("export", "arm.yaml", "arm.yaml", "--to", "dxf").returncode == 2
    assert flexure("export", "arm.yaml", "--to", "dwg").returncode == 2
    assert flexure("export", "arm.yaml").returncode == 2


def test_what_draws_no_blades_cannot_be_cut(flexure, spec):
    bar = SPEC.replace("{kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}",
                       "{kind: round-torsion-bar, d: 1 mm, l: 20 mm}")  # fmt: skip
    bar = bar.replace("translation: 1 mm", "rotation: 1 mrad").replace(
        "parasitic_shift: {max: 0.1 mm}", "stiffness: {min: 1 N*m/rad}"
    )
    (spec / "bar.yaml").write_text(bar)
    told = flexure("export", "bar.yaml", "--to", "dxf")
    assert told.returncode == 2
    assert "draws no blades" in told.stderr
