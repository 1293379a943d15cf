"""Derivatives of planar equilibria against central differences of whole solutions."""

from math import cos, sin

import numpy as np
import pytest

from flexcli.formulas.profile import Constant, Notch
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.sensitivity import beside
from flexcli.mechanics.stresses import blade_stress
from flexcli.mechanics.tangent import body_stiffness

HERE = {"l": 30e-3, "h": 0.2e-3, "b": 8e-3, "gap": 20e-3, "angle": 0.2, "neck": 0.3e-3}


def folded(l, h, b, gap, angle, neck):
    """Two stages in series: leaning outer blades, notches inside; everything differs by numbers."""
    c, s = cos(angle), sin(angle)
    blades = (
        Blade("low", "ground", "frame", (0.0, -gap), (l * c, -gap + l * s), Constant(h), b),
        Blade("high", "ground", "frame", (0.0, gap), (l * c, gap - l * s), Constant(h), b),
        Blade("in", "frame", "stage", (l, gap / 2), (l / 4, gap / 2), Notch(neck, 4e-3), b),
        Blade("out", "frame", "stage", (l, -gap / 2), (l / 4, -gap / 2), Constant(2.0 * h), b),
    )
    bodies = (Body("frame", (l, 0.0)), Body("stage", (l / 4, gap / 10)))
    return Layout(bodies, blades, 110e9, 42e9)


def asked(l, h, **_):
    """Return what is held and loaded: a stroke, and forces beside it."""
    held = {"stage": (None, l / 15.0, None)}
    return held, [Load("frame", (l, 1e-3), (0.8, -0.3), 2e-3 * h / HERE["h"])]


def numbers(state):
    """Return displacements, reactions, tangent stiffness and the largest stresses."""
    faces = [blade_stress(state, blade.name, 21) for blade in state.layout.blades]
    return np.concatenate(
        [
            state.motions.ravel(),
            state.reactions.ravel(),
            body_stiffness(state, "stage").ravel(),
            [max(np.abs(each.left).max(), np.abs(each.right).max()) for each in faces],
        ]
    )


def solution(at):
    held, loads = asked(**at)
    return solve(folded(**at), held, loads=loads, tolerance=1e-12).checked()


@pytest.mark.parametrize("name", HERE)
def test_derivatives_are_those_of_whole_solutions(name):
    """Of a length, a thickness, a width, places, an angle and the neck of a notch."""
    known = solution(HERE)

    def moved(share):
        return {**HERE, name: HERE[name] * (1.0 + share)}

    def linear(share):
        held, loads = asked(**moved(share))
        return numbers(beside(known, folded(**moved(share)), held, loads=loads))

    step = 1e-4
    implicit = (linear(step) - linear(-step)) / (2.0 * step)
    far = 2e-3
    one, two, three, four = (numbers(solution(moved(k * far))) for k in (-2, -1, 1, 2))
    whole = (one - 8.0 * two + 8.0 * three - four) / (12.0 * far)
    here = np.abs(numbers(known))
    assert (np.abs(implicit - whole) <= 1e-6 * np.maximum(here, np.abs(whole))).all()
    assert (np.abs(whole) > 0.1 * here)[here > 0.0].any()


def test_the_level_of_fewer_nodes_goes_with_it_and_nothing_is_solved_again():
    known = solve(folded(**HERE), asked(**HERE)[0], loads=asked(**HERE)[1]).checked()
    there = {**HERE, "h": HERE["h"] * 1.001}
    held, loads = asked(**there)
    found = beside(known, folded(**there), held, loads=loads)
    again = solve(folded(**there), held, loads=loads).checked()
    assert found.iterations == known.iterations
    for one, other, before in zip(
        (found, found.coarser), (again, again.coarser), (known, known.coarser), strict=True
    ):
        # what the step leaves goes with the square of the change
        left = np.abs(one.end_forces - other.end_forces).max()
        assert left < 1e-2 * np.abs(before.end_forces - other.end_forces).max()
