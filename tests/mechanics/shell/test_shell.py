"""Blades as shells: plates at small motion, curved strips, guides at stroke, buckling."""

from dataclasses import replace

import numpy as np
import pytest
from layouts_in_space import LOADS, STEEL, askew, guide, rod, strip, turned
from plates.clamped_sheet import Sheet
from plates.clamped_strip import Strip
from support import body_stiffness

from flexcli.errors import Outcome, SolveError
from flexcli.formulas.plate_flattening import secant_factor
from flexcli.formulas.profile import NeckedDown
from flexcli.mechanics.shell.element import derivatives
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.shell.shells import shells_of
from flexcli.mechanics.shell.strain import strains
from flexcli.mechanics.shell.stresses import rod_stresses, shell_stresses, twisted_corners
from flexcli.mechanics.space.exact.critical import critical_load
from flexcli.mechanics.space.exact.demand import Frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import SpaceLoad

E, nu = STEEL.E, STEEL.nu
HELD = {"two": (None, None, None, 0.01, -0.02, 0.1)}


def _at_rest(b, h, l, modes):
    """Stiffness of a strip by its end, about its middle."""
    state = solve(strip(h=h, b=b, l=l), levels=(modes,), made=shells_of)
    return body_stiffness(state, "tip", (l / 2.0, 0.0, 0.0))


def _stroke(layout, stroke, *levels, tolerance=1e-9):
    return solve(layout, {"stage": (stroke, *(None,) * 5)}, levels=(0, *levels),
                 tolerance=tolerance, made=shells_from_beams)  # fmt: skip


@pytest.mark.parametrize("ratio", [0.5, pytest.param(1.0, marks=pytest.mark.slow)])
def test_a_shell_moved_little_is_a_clamped_plate(ratio):
    """Against plates and sheets by Ritz's method: bending both ways, twist, stretch, in the plane.

    The corners of clamps and free sides slow polynomials down; from above, as Ritz's method is.
    """
    l, h = 0.1, 1e-5
    b = ratio * l
    even, odd = Strip(ratio, nu, levels=3), Strip(ratio, nu, odd=True, levels=3)
    pull, bend = Sheet(ratio, nu, bends=False, levels=3), Sheet(ratio, nu, bends=True, levels=3)
    EI, EI_wide = E * b * h**3 / 12.0, E * h * b**3 / 12.0
    GJ = STEEL.G * b * h**3 / 3.0
    plate = np.array([
        E * b * h / l * pull.axial_factor(), 12.0 * EI / l**3 * even.guided_factor(),
        GJ / l * odd.twist_factor(), EI_wide / l * bend.bending_factor(),
        EI / l * even.bending_factor(),
    ])  # fmt: skip
    off = [np.diag(_at_rest(b, h, l, modes))[[0, 1, 3, 4, 5]] / plate - 1.0 for modes in (12, 24)]
    assert np.all(np.abs(off[1]) < 3e-4)
    assert np.all(np.abs(off[0]) < 3e-3)
    assert np.all(np.abs(off[1]) < 0.5 * np.abs(off[0]))


@pytest.mark.parametrize("beta", [1.0, 4.0, 7.0])
def test_a_strip_that_is_bent_far_flattens(beta):
    """Between its ends the bend of a strip is Ashwell's; what two lengths differ by has no ends."""
    b, h = 20e-3, 0.1e-3
    kappa = beta**2 * h / (b**2 * np.sqrt(3.0 * (1.0 - nu**2)))
    EI = E * b * h**3 / 12.0
    turns = []
    for l in (60e-3, 90e-3):
        moment = float(secant_factor(beta=beta, poisson_ratio=nu)) * EI * kappa
        load = SpaceLoad("tip", (l, 0, 0), moment=(0.0, 0.0, moment))
        state = solve(strip(h=h, b=b, l=l), loads=[load], levels=(0, 16), made=shells_from_beams)
        turns.append(state.coordinates[0, 5])
    assert (turns[1] - turns[0]) / 30e-3 == pytest.approx(kappa, rel=1e-3)


@pytest.mark.parametrize(
    ("b", "stroke", "force", "stiffness"),
    [
        (50e-3, 20e-3, 56.87, (3.561e6, 9.173e5, 1311.4, 9283.5, 35809.0)),
        (20e-3, 20e-3, 22.275, (1.3808e6, 1.5603e5, 208.26, 1579.9, 13873.0)),
        (50e-3, 5e-3, 13.567, (3.9548e7, 7.2128e6, 10574.0, 71996.0, 3.8187e5)),
        (20e-3, 5e-3, 5.2554, (1.4754e7, 9.245e5, 995.66, 9249.1, 1.4763e5)),
    ],
)
def test_support_stiffness_of_a_deflected_guide_is_that_of_solids(b, stroke, force, stiffness):
    """CalculiX 2.20, C3D20R between rigid bodies, one element through 0.5 mm, 1 % by its mesh.

    Along the blades at 5 mm, where they are all but straight, that mesh is 3.6 % too stiff: so is
    the wide guide's; the narrow one's is that of 768 elements, two through the thickness.
    """
    frames = {"stage": Frame((0.0, 50e-3, 0.0), np.eye(3))}
    state = solve(guide(b=b), {"stage": (stroke, *(None,) * 5)}, frames=frames, levels=(0, 16),
                  made=shells_from_beams)  # fmt: skip
    assert state.unstable == 0
    assert state.reactions[0, 0] == pytest.approx(force, rel=0.01)
    C = support_compliance(state, "stage", (0.0, 50e-3, 0.0))
    assert 1.0 / C[1, 1] == pytest.approx(
        stiffness[0], rel=0.01 if stroke > 5e-3 or b < 50e-3 else 0.036
    )
    assert 1.0 / np.diag(C)[2:] == pytest.approx(stiffness[1:], rel=0.012)


@pytest.mark.slow
def test_a_deflected_guide_converges_and_tells_its_error():
    found = {}
    for modes in (12, 16, 20, 24):
        state = _stroke(guide(), 20e-3, modes)
        C = support_compliance(state, "stage", (0.0, 50e-3, 0.0))
        found[modes] = np.append(1.0 / np.diag(C)[1:], state.reactions[0, 0])
    off = {modes: np.abs(found[modes] / found[24] - 1.0) for modes in (12, 16, 20)}
    assert np.max(off[12]) < 4e-3
    assert np.max(off[16]) < 2e-3
    assert np.max(off[20]) < 1e-3
    told = _stroke(guide(), 20e-3, 12, 16, tolerance=5e-3)
    assert told.outcome is Outcome.CONVERGED
    assert off[16][-1] < told.estimated_error < 5e-3
    coarser = told.coarser.reactions[0, 0]
    assert coarser == pytest.approx(found[12][-1], rel=1e-5)


def test_shells_that_stand_askew_with_a_rod_are_turned_with_their_frame():
    axis = np.array([0.3, -0.8, 0.5])
    R, _ = np.linalg.qr(np.column_stack([axis, [1.0, 0.2, 0.0], [0.0, 0.4, 1.0]]))
    R *= np.linalg.det(R)
    how = {"levels": (8,), "made": shells_of, "tolerance": 1e-9}
    plain = askew()
    plain = type(plain)(plain.bodies, plain.blades, plain.drive)
    state = solve(plain, loads=LOADS, **how).checked()
    frames = {b.name: Frame(tuple(R @ b.point + 0.3), R.T) for b in plain.bodies}
    loads = [SpaceLoad(load.body, tuple(R @ np.asarray(load.point) + 0.3),
                       tuple(R @ load.force), tuple(R @ load.moment))
             for load in LOADS]  # fmt: skip
    moved = solve(turned(plain, R, 0.3), loads=loads, frames=frames, **how).checked()
    assert moved.coordinates == pytest.approx(state.coordinates, rel=1e-7, abs=1e-12)
    both = state.end_forces.reshape(-1, 2, 3) @ R.T
    assert moved.end_forces.reshape(-1, 2, 3) == pytest.approx(both, rel=1e-6, abs=1e-9)
    assert len(rod_stresses(state)) == 1


def test_newtons_matrix_has_the_second_variation_as_its_symmetric_part():
    """Two derivations: forces of blades followed by end motions, and the energy."""
    state = solve(askew(), HELD, loads=LOADS, levels=(8,), made=shells_of)
    at, k_f = state.linearised, 6 * state.part.assembly.blades
    condensed = []
    for matrix in (at.matrix, state.variation.matrix):
        follow = np.linalg.solve(matrix[:k_f, :k_f], matrix[:k_f, k_f:])
        condensed.append(matrix[k_f:, k_f:] - matrix[k_f:, :k_f] @ follow)
    newton, energy = condensed
    scale = np.sqrt(np.abs(np.outer(np.diag(energy), np.diag(energy))))
    # beams tie the two by nodes alone: the rod leaves what theirs leave
    assert np.max(np.abs((newton + newton.T) / 2.0 - energy) / scale) < 1e-6


def _energy(state):
    """Strain energy of all shells, summed over their Gauss points [J]."""
    assembly = state.part.assembly
    shells, total = assembly.members, 0.0
    strips, at = shells.clamped.strips, shells.clamped.strips.basis.sampled()
    z = shells.parts(assembly.at(state.part.x).inside)[0]
    felt = strains(
        derivatives(strips, at.along, at.across, shells.clamped.vectors(z)), strips.grown
    )
    weight = np.outer(at.weight_along, at.weight_across) / 2.0
    for k, blade in enumerate(state.layout.blades):
        l, h = shells.lengths[k], blade.profile.h
        law = strips.law[k] * E / (1.0 - nu**2)
        density = h * np.einsum("abi,ij,abj->ab", felt.stretch[k], law, felt.stretch[k])
        bend = felt.bend[k] / l
        density += h**3 / 12.0 * np.einsum("abi,ij,abj->ab", bend, law, bend)
        total += l * blade.b * float(np.sum(weight * density)) / 2.0
    return total


def test_the_drive_force_is_the_slope_of_the_energy_and_its_slope_the_tangent():
    step = 2e-4
    states = [_stroke(guide(), 10e-3 + n * step, 8) for n in (-1, 0, 1)]
    slope = (_energy(states[2]) - _energy(states[0])) / (2.0 * step)
    # third derivatives, over the square of the stroke: 1e-4 of the step's square
    assert slope == pytest.approx(states[1].reactions[0, 0], rel=2e-5)
    force = (states[2].reactions[0, 0] - states[0].reactions[0, 0]) / (2.0 * step)
    C = support_compliance(states[1], "stage", (0.0, 0.1, 0.0), free=(0,))
    assert 1.0 / C[0, 0] == pytest.approx(force, rel=1e-4)


@pytest.mark.slow
def test_a_column_as_wide_as_long_buckles_as_a_plate():
    """Clamped, its other end free in everything but its turns: against Ritz's plate."""
    l, h = 0.1, 1e-4
    plate = Strip(1.0, nu).critical([2, 3]) * E * h**3 / 12.0 / l
    load = SpaceLoad("tip", (l, 0, 0), (-plate, 0, 0))
    found = critical_load(strip(h=h, b=l, l=l), None, [load], most=1.5, levels=(8, 10, 12),
                          tolerance=1e-2, made=shells_of)  # fmt: skip
    assert found.factor == pytest.approx(1.0, abs=4e-3)


@pytest.mark.slow
def test_a_strip_buckles_sideways_at_michells_load():
    """4.0126 √(EI GJ)/l² (Michell 1899) for b/l → 0: a clamp keeps a strip from warping, as b/l."""
    l, h = 0.1, 1e-4
    factors = []
    for b in (5e-3, 10e-3):
        EI, GJ = E * b * h**3 / 12.0, STEEL.G * b * h**3 / 3.0
        load = SpaceLoad("tip", (l, 0, 0), (0, 0, 4.0126 * np.sqrt(EI * GJ) / l**2))
        found = critical_load(
            strip(h=h, b=b, l=l), None, [load], most=2.0, levels=(12, 16, 20), tolerance=5e-3,
            made=shells_of,
        )  # fmt: skip
        factors.append(found.factor)
    assert 2.0 * factors[0] - factors[1] == pytest.approx(1.0, abs=3e-3)


def test_stress_at_a_clamp_is_higher_than_a_beams():
    """σ_x at the middle of a clamp in pure bending, b/l = 0.2: by a plate's curvature there."""
    l, b, h = 0.1, 20e-3, 0.1e-3
    plate = Strip(0.2, nu, levels=3)
    shape = np.polynomial.Polynomial([0.0, -0.5, 0.5])
    raised = float(plate.curvature(shape, 0.0, 0.0)[0]) / (1.0 - nu**2) / plate.bending_factor()
    state = solve(strip(h=h, b=b, l=l), {"tip": (None,) * 5 + (1e-3,)}, levels=(0, 16),
                  made=shells_from_beams)  # fmt: skip
    beam = 6.0 * abs(state.end_forces[0, 5]) / (b * h**2)
    (found,) = shell_stresses(state)
    middle = np.abs(found.z) < 1e-9
    # the stress at the rim of a polynomial converges slowly: it swings by 1 %
    assert np.max(np.abs(found.along[:, middle])) / beam == pytest.approx(raised, rel=0.02)
    assert 0.98 < np.max(found.equivalent) / beam < 1.11
    # nothing is read off in the corners
    assert np.all((np.minimum(found.s, l - found.s) >= h) | (b / 2.0 - np.abs(found.z) >= h))


@pytest.mark.parametrize("b", [10e-3, 40e-3])
def test_what_a_twisted_strip_is_stressed_by_in_its_corners_is_nearly_a_beams(b):
    """A thickness from the corners restrained warping is a fifth below a beam's, or near it."""
    h = 0.5e-3
    held = {"tip": (None, None, None, 1e-3, None, None)}
    shells = solve(strip(h=h, b=b), held, levels=(0, 16), made=shells_from_beams)
    (beam,) = blade_stresses(solve(strip(h=h, b=b), held, levels=(24,)))
    outside = float(np.max(shell_stresses(shells)[0].equivalent))
    assert outside < 0.75 * beam.warping.max()
    corner = twisted_corners(shells)
    assert 0.77 * beam.warping.max() < corner < 1.1 * beam.warping.max()


def test_what_bends_and_pulls_a_strip_is_no_twist():
    """In corners it counts as where they end: their own stress has no bound."""
    held = {"tip": (1e-9, 1e-7, 1e-8, None, -1e-7, 1e-6)}
    state = solve(strip(h=0.5e-3, b=40e-3), held, levels=(0, 16), made=shells_from_beams)
    outside = float(np.max(shell_stresses(state)[0].equivalent))
    assert twisted_corners(state) == pytest.approx(outside, rel=0.05)
    assert np.max(shell_stresses(state, corner=0.0)[0].equivalent) > 1.1 * outside


def test_a_warm_blade_that_is_free_is_longer_and_bears_nothing():
    """Between bodies that do not grow; held by both, it bears what a clamped sheet does."""
    l, b, h, strain = 0.1, 50e-3, 0.5e-3, 1e-4
    warm = replace(strip(h=h, b=b, l=l), blade_growth={"blade": strain})
    free = solve(warm, levels=(0, 12, 16), tolerance=1e-6, made=shells_from_beams)
    assert free.coordinates[0, 0] == pytest.approx(strain * l, rel=1e-9)
    assert np.max(np.abs(shell_stresses(free)[0].equivalent)) < 1e-6 * E * strain
    held = solve(warm, {"tip": (0.0,) * 6}, levels=(0, 16), made=shells_from_beams)
    sheet = Sheet(b / l, nu, bends=False).axial_factor() * E * h * b * strain
    assert -held.end_forces[0, 0] == pytest.approx(sheet, rel=2e-3)


def test_what_no_shell_can_be_is_refused():
    layout = strip(h=0.2e-3, b=10e-3)
    blade = layout.blades[0]
    necked = type(blade)(**{**vars(blade), "profile": NeckedDown(0.2e-3, 10e-3)})
    with pytest.raises(SolveError, match="thickness"):
        solve(type(layout)(layout.bodies, (necked,), layout.drive), made=shells_of, levels=(12,))


def test_rods_alone_are_no_shells():
    with pytest.raises(SolveError, match="rods"):
        solve(rod(d=1e-3), made=shells_of, levels=(12,))
