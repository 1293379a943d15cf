"""How far a wrench moves a joint in space: exact beams under it, and their tangent at a stroke."""

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_stroke import (
    along_cases,
    at_travel,
    compliance_along_cases,
)
from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.space.layout import SpaceLoad
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import CENTRE, DIRECTIONS, compliance_of, deflection_form
from flexcli.parts.space_joint import joint_in_space
from flexcli.results import ErrorRange

__all__ = ["deflections"]

Floats = NDArray[np.float64]

STROKE_ERROR = 0.15
"""Of what a stroke changes in a deflection, by beams: against shells, within 0.07 of the largest
change in any direction.

Crossed and remote pivots and stages, b/l 0.3 to 2.5, h/l 0.005 and 0.02, at 3 and 30 mrad, or 0.003
and 0.03 of the length."""

LOAD_ERROR = 0.05
"""The same of what the size of a load changes, besides what beams are off at rest."""

MOST = 1.0
"""Change over the number at rest beyond which that is not known any more."""


IN, OUT = [0, 1, 5], [2, 3, 4]
"""Motions and loads in the plane of a joint, and out of it."""

ROUNDING = 1e-9
"""Share of a compliance without units below which a direction is held."""


def deflections(
    ask: Ask, point: tuple[float, float, float], direction: str
) -> tuple[tuple[float, ErrorRange | None], ...]:
    """Return how far the wrench of a case, either way, moves a point along an axis of cases.

    To the deflection of the joint at rest by its best springs, what the size of the wrench changes
    and what the stroke changes are added, both by exact beams; each is known to a share of itself.
    No load in the plane of a joint that is its own mirror image there moves it out of it.

    Raises
    ------
    NotAvailable
        When there is no stable equilibrium.

    """
    scene, joint = ask.scene, joint_in_space(ask.geometry, ask.material, ask.sizes)
    if scene.temperature is not None:
        raise NotAvailable("has no deflection by exact beams beside a temperature")
    assert scene.wrench is not None  # of a case that has one
    load, sought = np.array(scene.wrench), motion_at(point)[DIRECTIONS.index(direction)]
    best, (first, known, work) = compliance_of(ask), deflection_form(ask, sought, load)
    try:
        rest = compliance_along_cases(ask, at_travel(ask, 0.0), CENTRE, locked=False)
        ends = dict.fromkeys(scene.stroke_ends) if scene.moves else ()
        there = [
            compliance_along_cases(ask, at_travel(ask, travel), CENTRE, locked=False)
            for travel in ends
        ]
        bent = {sign: _moved(ask, sign * load, sought) for sign in (1.0, -1.0)}
    except SolveError as failed:
        raise NotAvailable(f"has no deflection by exact beams: {failed}") from failed
    if joint.is_mirrored and not (np.any(load[OUT]) or np.any(sought[IN])):
        return ((0.0, ErrorRange(0.0, 0.0)),)
    found: list[tuple[float, ErrorRange | None]] = []
    # what varies in thickness is no surer than its springs
    unsure = 0.0 if joint.is_uniform else float(np.max(np.maximum(joint.high, -joint.low)))
    if not np.isfinite(unsure):
        known = None
    beams = max(LOAD_ERROR, unsure) + _largest_share(best - rest, rest)
    for sign, moved in bent.items():
        own = moved - sign * float(sought @ rest @ load)
        for C in there or [rest]:
            turned = sign * float(sought @ (C - rest) @ load)
            value = sign * first + own + turned
            share = _largest_share(C - rest, rest)
            # a load amplifies as 1/(1 − s), s its share of what buckles the joint
            off = beams * abs(own) * (1.0 + abs(own) / work)
            off += max(STROKE_ERROR, unsure) * share * work
            off += abs(own) * share  # what both do to each other
            if known is None or value == 0.0 or abs(own) + share * work > MOST * work:
                found.append((value, None))
                continue
            low, high = sorted(sign * end for end in known)
            ends_of = sorted(((low - off) / value, (high + off) / value))
            found.append((value, ErrorRange(*ends_of)))
    return tuple(found)


def _moved(ask: Ask, load: Floats, sought: Floats) -> float:
    """Return how far a wrench moves what is sought from rest, the drive free [m or rad]."""
    layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
    along, body = along_cases(ask), layout.body(layout.drive.body)
    wrench = (along.T @ load).tolist()
    acting = SpaceLoad(body.name, body.point, tuple(wrench[:3]), tuple(wrench[3:]))
    state = at_travel(ask._replace(near=None), None, loads=(acting,))
    return float(sought @ along @ state.motion_of(body.name, body.point))


def _largest_share(change: Floats, C: Floats) -> float:
    """Return the largest share of a compliance that a change is, of any load in any direction."""
    values, axes = np.linalg.eigh(C / np.sqrt(_outer(C)))
    kept = values > ROUNDING * values[-1]
    root = axes[:, kept] / np.sqrt(values[kept])
    return float(np.abs(np.linalg.eigvalsh(root.T @ (change / np.sqrt(_outer(C))) @ root)).max())


def _outer(C: Floats) -> Floats:
    """Return the products of the diagonal, which make a compliance free of units; 1 for none."""
    diagonal = np.where(np.diag(C) > 0.0, np.diag(C), 1.0)
    return np.asarray(np.outer(diagonal, diagonal))
