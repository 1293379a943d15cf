"""The first periods of a design between its stops, on which methods in time are compared."""

from collections.abc import Iterable, Iterator
from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.stopping.choice import choose
from flexcli.engine.stopping.excitation import excitation
from flexcli.engine.stopping.scene import stop_scene
from flexcli.engine.stopping.statics import task_of
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.signal_pieces import Piece
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes

__all__ = ["PERIODS", "StoppedMotion", "motions"]

Floats = NDArray[np.float64]

PERIODS = 6
"""Length of a run in periods of the first mode: short enough for the slowest method."""


class StoppedMotion(NamedTuple):
    """A blade between stops, what shakes its base, and its modal rates at the start."""

    name: str
    label: str
    blade: ModalBlade
    stops: Stops
    pieces: tuple[Piece, ...]
    rate: Floats


def motions(design: DesignSpec, sizes: Sizes) -> Iterator[StoppedMotion]:
    """Yield the first periods, from rest, of every sine and shock between the chosen stops."""
    if design.stops is None:
        return
    asked = {name: alone for name, case in design.cases.items() if (alone := _sine_and_shock(case))}
    if not asked:
        return
    task = task_of(design, design.stops, sizes)
    place = choose(task).place
    signs = (1,) if design.stops.sides == "both" else (1, -1)
    for name, case in asked.items():
        blade, stops, _ = stop_scene(design, task, sizes, place, name)
        all_shaken = [
            shaken
            for sign in signs
            for shaken in excitation(name, case, blade, design.stops.simulation, sign)
        ]
        window = PERIODS * 2.0 * pi / float(blade.angular[0])
        for count, shaken in enumerate(all_shaken, 1):
            yield StoppedMotion(
                name=name if len(all_shaken) == 1 else f"{name}_{count}",
                label=f"{name}, {shaken.kind}, first {PERIODS} periods of the blade",
                blade=blade,
                stops=stops,
                # a sine or a shock has no samples
                pieces=tuple(
                    _first_part(
                        (p for leg in shaken.legs for p in leg if isinstance(p, Piece)), window
                    )
                ),
                rate=np.zeros(blade.angular.size) if shaken.rate is None else shaken.rate,
            )


def _sine_and_shock(case: Case) -> Case | None:
    """Return a case with its sine and its shock in time only, or nothing where it has neither."""
    shock = case.shock
    if shock is not None and (shock.srs or shock.record is not None):
        shock = None
    if case.sine is None and shock is None:
        return None
    return case.model_copy(
        update={"asd": None, "axes": None, "sines": (), "sweep": None, "shock": shock}
    )


def _first_part(pieces: Iterable[Piece], window: float) -> Iterator[Piece]:
    """Yield pieces up to a time."""
    left = window
    for piece in pieces:
        yield piece._replace(duration=min(piece.duration, left))
        left -= piece.duration
        if left <= 1e-9 * window:
            return
