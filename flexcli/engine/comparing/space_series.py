"""The series of models of a mechanism in space, timed: shells of many modes are the finest."""

from collections.abc import Iterator
from functools import partial
from time import perf_counter

import numpy as np

from flexcli.engine.comparing.compared import Reference, Timed, relative_bound
from flexcli.engine.comparing.model_series import (
    Number,
    SeriesModel,
    SolvedSeries,
    asked_of,
    largest_stress,
    parasitic_shift,
    stiffness,
)
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_linear import SpaceLinearModel
from flexcli.engine.joint_models.space_shell import SHELLS, SpaceShellModel
from flexcli.engine.joint_models.space_stroke import at_travel, driven_coordinate, forget
from flexcli.mechanics.space.exact.members import FIRST_GUESS
from flexcli.mechanics.space.exact.support import driven_stiffness
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import AS_PRINTED, Ask

__all__ = ["space_series"]

NEWTON = 1e-4
"""What Newton's method leaves of the finest shell's numbers, at most."""

CENTRE = (0.0, 0.0, 0.0)
AXES = {
    "x": "N/m", "y": "N/m", "z": "N/m",
    "theta_x": "N*m/rad", "theta_y": "N*m/rad", "theta_z": "N*m/rad",
}  # fmt: skip
"""The directions of a support stiffness, and their units."""


class _Finest(SpaceShellModel):
    name = "shell, 24 modes"
    blades = SHELLS._replace(name=name, levels=(FIRST_GUESS, 20, 24))


class _Control(SpaceShellModel):
    name = "shell, 20 modes"
    blades = SHELLS._replace(name=name, levels=(FIRST_GUESS, 16, 20))


SERIES = (
    SeriesModel("linear", SpaceLinearModel),
    SeriesModel("exact", SpaceExactModel),
    SeriesModel("shell", SpaceShellModel),
    SeriesModel(_Finest.name, _Finest),
)


def space_series(design: DesignSpec, sizes: Sizes, runs: int) -> SolvedSeries:
    """Return the models of a mechanism in space with their numbers and seconds.

    One equilibrium gives all numbers of a stroke: its time is in each of them, and once in all.
    """
    settled, unsettled = [], []
    for number in _numbers(design, sizes):
        finest, control = number.tried(_Finest()), number.tried(_Control())
        if finest is None:
            continue  # as along a drive that is locked
        bound = None if control is None else relative_bound(finest, control, NEWTON)
        if bound is None:
            unsettled.append(number.name)
        else:
            settled.append(Reference(number, finest, bound))
    values = np.full((len(SERIES), len(settled)), np.nan)
    seconds, whole = np.full((runs, *values.shape), np.nan), np.full((runs, len(SERIES)), np.nan)
    asks = design.asks(sizes, AS_PRINTED)
    for run in range(runs):
        for i, model in enumerate(SERIES):
            forget()
            joint_model, begun = model.new(), perf_counter()
            if isinstance(joint_model, SpaceExactModel):
                _solve(asks, joint_model)
            solved = whole[run, i] = perf_counter() - begun
            for j, each in enumerate(settled):
                started = perf_counter()
                value = each.number.tried(joint_model)
                took = perf_counter() - started
                whole[run, i] += took
                if value is not None:
                    values[i, j], seconds[run, i, j] = value, solved + took
    return SolvedSeries(settled, SERIES, Timed(values, seconds, whole), tuple(unsettled))


def _solve(asks: list[Ask], joint_model: SpaceExactModel) -> None:
    """Solve the ends of all strokes; the model remembers them."""
    for ask in asks:
        if ask.scene.moves:
            joint_model.parasitic_shift(ask._replace(joint_model=joint_model))


def _numbers(design: DesignSpec, sizes: Sizes) -> Iterator[Number]:
    """Yield what is reported of a mechanism in space: at rest, then stroke by stroke."""
    asks = design.asks(sizes, AS_PRINTED)
    turns = design.geometry.motion == "rotation"
    name, unit = ("k_pivot", "N*m/rad") if turns else ("k_stage", "N/m")
    yield Number(name, "stiffness at rest", unit, asked_of(asks[0], stiffness))
    for ask in asks:
        case = ask.scene.case
        end = f"_{case}" if len(asks) > 1 else ""
        if not ask.scene.moves:
            continue
        label = f"largest stress, {case}"
        yield Number(f"sigma{end}", label, "Pa", asked_of(ask, largest_stress))
        label = f"stiffness at full stroke, {case}"
        yield Number(f"k_end{end}", label, unit, asked_of(ask, _stiffness_at_end))
        label = f"parasitic shift, {case}"
        yield Number(f"shift{end}", label, "m", asked_of(ask, parasitic_shift))
        for index, (axis, own) in enumerate(AXES.items()):
            label = f"support along {axis} at full stroke, drive locked, {case}"
            support = asked_of(ask, partial(_support, index=index))
            yield Number(f"support_{axis}{end}", label, own, support)


def _stiffness_at_end(ask: Ask) -> float:
    """Return the tangent at full stroke: that at rest by a model in which nothing changes it."""
    model, scene = ask.joint_model, ask.scene
    if not isinstance(model, SpaceExactModel):
        return stiffness(ask)
    state = at_travel(ask, scene.stroke_ends[0], model.blades)
    return driven_stiffness(state, driven_coordinate(state.layout))


def _support(ask: Ask, index: int) -> float:
    model = ask.joint_model
    if not isinstance(model, SpaceExactModel):
        raise NotAvailable("knows no stroke")
    return model.support_at_stroke(ask, index, CENTRE, locked=True)[0][0]
