"""Vibration of mechanisms in space, against planar matrices and a direct solution."""

import numpy as np
import pytest
from space_mechanisms import STEEL, random_mechanism, rod

from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.inertia import mass_matrix, weight_along
from flexcli.mechanics.space.layout import Drive, SpaceBody, SpaceLayout
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.vibrating import vibrating
from flexcli.mechanics.vibrating_layout import vibrating_layout
from flexcli.numerics.modes import natural_modes
from flexcli.parts.asd import RandomVibration
from flexcli.parts.quality import Quality
from flexcli.parts.response import random_outputs, sine_peaks
from flexcli.parts.space_vibration import space_structure


def narrow_stage(mass):
    """Two blades so narrow that no plate effect tells, along x; the stage travels along y."""
    blades = tuple(
        Blade(name, "ground", "moving", (0.0, y), (0.05, y), Constant(2e-4), 4e-4)
        for name, y in (("upper", 0.01), ("lower", -0.01))
    )
    body = Body("moving", (0.05, 0.0), mass, 2e-9, (0.05, 0.0))
    return Layout((body,), blades, STEEL.E, STEEL.G)


@pytest.mark.parametrize("mass", [1e-2, 1e-5])
def test_in_its_plane_it_vibrates_as_the_planar_one_blades_included(mass):
    plane = narrow_stage(mass)
    flat = vibrating_layout(plane, STEEL.density)
    space = vibrating(assemble(from_plane(plane, "moving", turns=False, density=STEEL.density)))
    ours, theirs = (natural_modes(x.stiffness, x.mass) for x in (space, flat))
    moves = np.array([(ours.shapes.T @ space.pull[axis]) ** 2 for axis in "xy"]).sum(axis=0)
    in_plane = ours.angular[moves > 1e-4 * space.moved][:3]
    flat_moves = np.array([(theirs.shapes.T @ flat.pull[axis]) ** 2 for axis in "xy"]).sum(axis=0)
    expected = theirs.angular[flat_moves > 1e-4 * space.moved][:3]
    # shear and what clamps hold: h/l = 1/250, b/l = 1/125
    np.testing.assert_allclose(in_plane, expected, rtol=4e-3)
    assert space.moved == pytest.approx(flat.moved["x"], rel=1e-9)


def test_a_light_stage_on_heavy_blades_is_stressed_by_their_inner_modes_as_in_the_plane():
    plane = narrow_stage(1e-5)
    flat = vibrating_layout(plane, STEEL.density)
    space = vibrating(assemble(from_plane(plane, "moving", turns=False, density=STEEL.density)))
    for omega in (0.0, 2.0 * np.pi * 700.0):
        flat_x, space_x = (
            np.linalg.solve(x.stiffness - omega**2 * x.mass, x.pull["y"]) for x in (flat, space)
        )
        bent = np.abs(flat.bending["upper"] @ flat_x).max()
        found = np.abs(space.stresses["upper"][:, 0] @ space_x).max()
        assert found == pytest.approx(bent, rel=1e-2)  # stretching beside, and plates


@pytest.mark.parametrize("seed", range(3))
def test_a_steady_acceleration_is_the_static_end_of_the_response(seed):
    layout = random_mechanism(np.random.default_rng(seed))
    assembly = assemble(layout)
    found, M = vibrating(assembly), mass_matrix(assembly)
    for axis in "xyz":
        unit = np.array([float(axis == each) for each in "xyz"])
        expected = assembly.moved(weight_along(assembly, M, unit)[:, None]).coordinates[:, 0]
        x = np.linalg.solve(found.stiffness, found.pull[axis])[: assembly.size]
        np.testing.assert_allclose(x, expected, rtol=1e-6, atol=1e-9 * np.abs(expected).max())


def test_the_root_mean_square_of_von_mises_stress_is_that_of_the_covariance_at_every_place():
    structure = space_structure(assemble(random_mechanism(np.random.default_rng(1))))
    level = {"frequency": "20 Hz", "level": "1 (m/s^2)^2/Hz"}, {
        "frequency": "200 Hz", "level": "1 (m/s^2)^2/Hz"}  # fmt: skip
    shaken = RandomVibration.model_validate(
        {"profile": {"points": list(level)}, "q": 15, "axis": "x, y and z"}
    )
    modes = natural_modes(structure.stiffness, structure.mass)
    f = np.linspace(20.0, 200.0, 4001)
    omega = 2.0 * np.pi * f
    # the covariance of the modes, by trapezia over a fine grid, then of normal and shear stress
    covariance = np.zeros((modes.angular.size,) * 2)
    gain = 1.0 / (modes.angular**2 - omega[:, None] ** 2 + 1j * omega[:, None] * modes.angular / 15)
    for axis in "xyz":
        each = gain * (modes.shapes.T @ structure.pull[axis])
        covariance += np.trapezoid((each[:, :, None] * each[:, None].conj()).real, f, axis=0)
    found = random_outputs(structure, shaken)
    for name, rows in structure.outputs.items():
        if not name.startswith("stress"):
            continue
        normal, shear = rows[:, 0] @ modes.shapes, rows[:, 1] @ modes.shapes
        square = np.einsum("pi,ij,pj->p", normal, covariance, normal)
        square += np.einsum("pi,ij,pj->p", shear, covariance, shear)
        assert found[name].rms == pytest.approx(np.sqrt(square.max()), rel=1e-3)  # of the trapezia


def test_a_rod_with_a_mass_on_it_resonates_alike_in_both_directions():
    body = SpaceBody("tip", (0.0, 0.0, 0.03), (0.0, 0.0, 0.03), 0.01, tuple(
        tuple(row) for row in (np.eye(3) * 1e-8).tolist()))  # fmt: skip
    layout = SpaceLayout(
        (body,), (rod("r", "ground", "tip", (0, 0, 0), (0, 0, 0.03), d=1e-3),),
        Drive("tip", False, (1.0, 0.0, 0.0), (0.0, 0.0, 0.03)),
    )  # fmt: skip
    structure, one = space_structure(assemble(layout)), np.ones_like
    first = float(natural_modes(structure.stiffness, structure.mass).angular[0] / (2.0 * np.pi))
    peaks = [
        sine_peaks(structure, one, Quality(all=20.0), (first, first), axis)["stress r"]
        for axis in "xy"
    ]
    assert peaks[0] == pytest.approx(peaks[1], rel=1e-6)
    diagonal = sine_peaks(structure, one, Quality(all=20.0), (0.01 * first,) * 2, "x")["stress r"]
    assert peaks[0] == pytest.approx(20.0 * diagonal, rel=0.1)
