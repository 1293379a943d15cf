"""Solid elements as the finest model of a design, beside plane beams and the model that decides."""

from collections.abc import MutableMapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.comparing.compared import UNSURE, Reference, Timed
from flexcli.engine.comparing.model_series import SolvedSeries
from flexcli.engine.verify import verifiable, verify
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.results import Note
from flexcli.results.verification import VerifiedNumber

__all__ = ["with_solids"]

SOLID = "solid"
"""What the finest model is called."""


class _Model(NamedTuple):
    """A model by the name that reports give it."""

    name: str


def with_solids(
    design: DesignSpec, sizes: Sizes, series: SolvedSeries, files: MutableMapping[str, str] | None
) -> tuple[SolvedSeries, list[Note]]:
    """Return the models with two more, the deciding one and solids, and what to say of them.

    Errors are against the solids where they have a number that is sure to a tenth; other numbers
    take no part. A stress is that of the solid beside the clamp, times what exact beams have more
    where it is greatest. Without CalculiX the models stay as they are.

    Raises
    ------
    SolveError
        ``no-solid`` when the joint has none.

    """
    same = set(verifiable(design, sizes)) - _in_other_states(design)
    asked = [each.number.name for each in series.settled if each.number.name in same]
    if not asked:
        text = "solids have none of its numbers in the same state"
        raise SolveError("no-solid", text, "flexure verify compares those that they have")
    result = verify(design, sizes, "", only=asked, files=files)
    found = result.verification
    assert found is not None  # a verification has one
    notes = [note for note in result.warnings if note.code != "not-run"]
    if not found.program:
        text = (
            "no solid takes part: ccx is not installed (Debian: apt install calculix-ccx). Its "
            f"decks, which -o DIR writes: {', '.join(found.decks)}; each number on two meshes"
        )
        return series, [*notes, Note("not-run", text)]
    numbers = {number.name: number for number in found.numbers}
    is_kept = [_is_sure(numbers.get(each.number.name)) for each in series.settled]
    kept = [each for each, sure in zip(series.settled, is_kept, strict=True) if sure]
    gone = [each for each, sure in zip(series.settled, is_kept, strict=True) if not sure]
    if not kept:
        text = "no solid takes part: none of their numbers is known to a tenth"
        return series, [*notes, Note("no-sure-solid", text)]
    solids = [numbers[each.number.name] for each in kept]
    settled = [
        Reference(each.number, _greatest(by.solid, by), float(by.solid_error or 0.0))
        for each, by in zip(kept, solids, strict=True)
    ]
    whole = sum(number.seconds - number.model_seconds for number in found.numbers)
    finer = [_Model(f"{found.model}, corrected"), _Model(SOLID)]
    times = _with_models(series.times, np.flatnonzero(is_kept), solids, whole)
    unsettled = (*series.unsettled, *(each.number.name for each in gone))
    return SolvedSeries(settled, [*series.models, *finer], times, unsettled), notes


def _in_other_states(design: DesignSpec) -> set[str]:
    """Return the numbers that solids have without the loads of a case, or without its stroke.

    The models have them with both.
    """
    scenes = design.scenes()
    return {
        f"{name}_{scene.case}" if len(scenes) > 1 else name
        for scene in scenes
        if scene.moves and scene.is_loaded
        for name in ("k_end", "shift", "F_cr")
    }


def _is_sure(number: VerifiedNumber | None) -> bool:
    return (
        number is not None
        and bool(number.solid)
        and number.solid_error is not None
        and number.solid_error <= UNSURE
    )


def _greatest(value: float | None, number: VerifiedNumber) -> float:
    """Return a number where it is greatest: a stress is compared beside the clamp."""
    return np.nan if value is None else value / number.share


def _with_models(
    times: Timed, columns: NDArray[np.intp], solids: Sequence[VerifiedNumber], whole: float
) -> Timed:
    """Return some columns of what was timed, with rows of the deciding model and of solids."""
    runs = times.seconds.shape[0]
    values = np.array(
        [[_greatest(by.model, by) for by in solids], [_greatest(by.solid, by) for by in solids]]
    )
    took = np.array([[by.model_seconds for by in solids], [by.deck_seconds for by in solids]])
    seconds = times.seconds[:, :, columns]
    together = np.append(seconds.sum(axis=2), np.full((runs, 1), took[0].sum()), axis=1)
    return Timed(
        np.vstack([times.values[:, columns], values]),
        np.concatenate([seconds, np.broadcast_to(took, (runs, *took.shape))], axis=1),
        np.append(together, np.full((runs, 1), whole), axis=1),
    )
