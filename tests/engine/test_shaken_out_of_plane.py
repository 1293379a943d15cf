"""Base motion along z of joints and mechanisms that are drawn in their plane."""

import pytest
import yaml

import flexcli
from flexcli.errors import SpecError

MATERIAL = {"youngs_modulus": "113 GPa", "poisson_ratio": 0.34, "yield_strength": "880 MPa",
            "density": "4430 kg/m^3"}  # fmt: skip
ALONG_Z = {"axes": {"z": {"asd": "gevs-acceptance"}}, "q": 20}
LEVER = {
    "mass": "17 g", "com": "10 mm",
    "inertia": {"xx": "5.3e-6 kg*m^2", "yy": "1.9e-6 kg*m^2", "zz": "5.4e-6 kg*m^2"},
}  # fmt: skip
BALANCE = {"mass": "5 g", "arm": "12 mm",
           "inertia": {"xx": "2e-7 kg*m^2", "yy": "1e-7 kg*m^2", "zz": "2e-7 kg*m^2"}}  # fmt: skip
PIVOT = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
         "h": "0.3 mm", "l": "14 mm", "b": "10 mm"}  # fmt: skip
STAGE = {"kind": "parallel-stage", "height": "20 mm", "solid-1": LEVER,
         "solid-2": {"mass": "68 g"}, "solid-3": LEVER}  # fmt: skip


def spec(geometry, mechanism=None, **case):
    return yaml.safe_dump(
        {
            "flexure": 1,
            "material": MATERIAL,
            "geometry": geometry,
            **({} if mechanism is None else {"mechanism": mechanism}),
            "cases": {"launch": {**ALONG_Z, **case}},
            "requirements": {"dynamic-yield": 1.25},
        }
    )


def judged(*of, **case):
    (check,) = (
        c for c in flexcli.verdicts(spec(*of, **case)).checks if c.name.startswith("dynamic yield")
    )
    return check


def metres(*coordinates):
    return [f"{float(c)!r} m" for c in coordinates]


def drawn(plane, bodies, moving, motion):
    """Return blades of a plane layout as a drawing in space, with other bodies."""
    blades = {
        blade.name.replace(" ", "-"): {
            "between": [blade.first.replace(" ", "-"), blade.second.replace(" ", "-")],
            "from": metres(*blade.start, blade.z), "to": metres(*blade.end, blade.z),
            "h": f"{float(blade.profile.h)!r} m", "b": f"{float(blade.b)!r} m", "width": "z",
        }
        for blade in plane
    }  # fmt: skip
    return {"kind": "space-layout", "bodies": bodies, "blades": blades, "moving": moving,
            "motion": motion}  # fmt: skip


@pytest.mark.slow
def test_a_locked_stage_along_z_is_its_levers_drawn_between_fixed_pivots():
    stage = {**STAGE, "balance-1": BALANCE, "balance-3": BALANCE}
    locked = judged(PIVOT, stage, lock="solid-2")
    design = flexcli.load(spec(PIVOT, stage, lock="solid-2")).part
    sizes = design.fixed_sizes()
    joint = design.geometry.layout(design.material.elastic, sizes)
    layout = design.mechanism.out_of_plane(joint, "solid-2").layout
    # lever and balancing mass as one body: m y, and each I + m (y − y_c)² about x and z
    m = 17e-3 + 5e-3
    y = (17e-3 * 10e-3 - 5e-3 * 12e-3) / m
    apart = 17e-3 * (10e-3 - y) ** 2 + 5e-3 * (12e-3 + y) ** 2
    about = [5.5e-6 + apart, 2.0e-6, 5.6e-6 + apart]
    body = {"at": ["0 m", "0 m", "0 m"], "mass": f"{m} kg", "com": metres(0.0, y, 0.0),
            "inertia": [f"{moment!r} kg*m^2" for moment in about]}  # fmt: skip
    first = [blade for blade in layout.blades if blade.name[:2] in ("P1", "P2")]
    turn = {"rotation": {"about": "z", "at": ["0 mm", "0 mm", "0 mm"]}}
    by_drawing = judged(drawn(first, {"solid-1": body}, "solid-1", turn))
    assert locked.demand == pytest.approx(by_drawing.demand, rel=1e-9)


@pytest.mark.slow
def test_inertia_that_is_not_stated_widens_the_error():
    plain = {**LEVER, "inertia": "5.4e-6 kg*m^2"}
    told = judged(PIVOT, STAGE, lock="solid-2").factor_range
    wide = judged(PIVOT, {**STAGE, "solid-1": plain, "solid-3": plain}, lock="solid-2").factor_range
    assert wide[0] < told[0]
    assert wide[1] > told[1]


def test_a_leaf_spring_stage_along_z_is_its_blades_drawn_in_space():
    leaves = {"kind": "leaf-spring-stage", "h": "0.5 mm", "l": "40 mm", "b": "15 mm",
              "spacing": "30 mm"}  # fmt: skip
    payload = {"kind": "payload", "mass": "0.2 kg", "inertia": "6e-6 kg*m^2"}
    planar = judged(leaves, payload)
    design = flexcli.load(spec(leaves, payload)).part
    layout = design.geometry.layout(design.material.elastic, design.fixed_sizes())
    tilt = 0.2 * (0.1 * 40e-3) ** 2  # what is taken where nothing is stated
    body = {"at": metres(20e-3, 0.0, 0.0), "mass": "0.2 kg", "com": metres(20e-3, 0.0, 0.0),
            "inertia": [f"{tilt} kg*m^2", f"{tilt} kg*m^2", "6e-6 kg*m^2"]}  # fmt: skip
    by_drawing = judged(drawn(layout.blades, {"moving": body}, "moving", {"translation": "y"}))
    assert planar.demand == pytest.approx(by_drawing.demand, rel=1e-9)
    assert planar.factor_range[0] <= by_drawing.factor <= planar.factor_range[1]


def test_a_stage_whose_levers_stand_nobody_knows_where_is_refused_with_the_way_out():
    with pytest.raises(SpecError) as raised:
        flexcli.check(spec(PIVOT, STAGE))
    (finding,) = raised.value.findings
    assert "levers whose distance" in finding.text
    assert "space-layout" in finding.hint


def result_of_locked(verb=flexcli.verdicts, **case):
    """Return the result of a locked stage."""
    text = yaml.safe_load(spec(PIVOT, STAGE))
    text["cases"] = {"launch": {"lock": "solid-2", **case}}
    kinds = ("dynamic-yield",) if "asd" in case else ("yield",)
    if "asd" in case and case["asd"]["axis"] != "z":
        kinds += ("yield",)
    text["requirements"] = dict.fromkeys(kinds, 1.25)
    return verb(yaml.safe_dump(text))


def checks_of_locked(**case):
    """Return its checks by name."""
    found = result_of_locked(**case).checks
    return {check.name.partition(" (")[0]: check for check in found}


def test_a_locked_stage_may_be_shaken_along_every_axis():
    """Along y its bodies bear the worst acceleration as a steady one; its modes respond besides."""
    shaken = {"profile": "gevs-acceptance", "q": 20}
    along = {
        axis: checks_of_locked(asd=shaken | {"axis": axis}) for axis in ("x", "y", "z", "x and y")
    }
    for axis, found in along.items():
        assert found["dynamic yield"].factor > 1.0, axis
    values = result_of_locked(flexcli.check, asd=shaken | {"axis": "y"}).values
    level = 3.0 * values["g_rms_worst"].value
    steady = checks_of_locked(acceleration={"level": f"{level!r} m/s^2", "axis": "y"})
    assert along["y"]["yield"].factor == pytest.approx(steady["yield"].factor, rel=1e-6)
    # both at once have the stress of both, in the worst of their senses
    both = along["x and y"]["yield"].demand
    each = [along[axis]["yield"].demand for axis in "xy"]
    assert max(each) < both <= 1.001 * sum(each)


def test_a_locked_stage_shaken_off_x_beside_a_force_is_a_named_outcome():
    found = checks_of_locked(
        asd={"profile": "gevs-acceptance", "q": 20, "axis": "y"}, load={"force": "3 N"}
    )
    assert found["yield"].verdict == "undecided"
    assert "state each in a case of its own" in found["yield"].quantity
