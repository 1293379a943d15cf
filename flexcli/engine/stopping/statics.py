"""The statics of a blade against its stop, for one place or many, and the limits on it."""

from collections.abc import Iterator
from math import inf
from typing import NamedTuple

from flexcli.engine.assess import ROUNDING
from flexcli.formulas.pi_law import contact_threshold, operating_line
from flexcli.formulas.section import second_moment
from flexcli.formulas.stop_stiffness import bent_shape, contact_stiffness, stiffness_ratio
from flexcli.formulas.stopped_bending import bending_moment, bending_stress
from flexcli.formulas.stopped_cantilever import (
    contact_load,
    excess_load,
    load_at_travel,
    reaction,
)
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.parts.stops import Stops
from flexcli.results import StopPlace

__all__ = [
    "StopTask",
    "force_at_travel",
    "holds",
    "margin",
    "place_limits",
    "stop_place",
    "task_of",
]

SOURCE = "Monti (2014), chapters 4, 8.5 and 9; corrected"
SHEAR_OF_STRENGTH = 0.5
"""Tresca: yield in shear at half the strength in tension."""


class StopTask(NamedTuple):
    """The blade [SI], its stops, the deflection of the tip allowed, and what must stay free."""

    elastic: Elastic
    I: float
    h: float
    L: float
    stops: Stops
    travel: float
    bending: float | None
    shear: float | None
    free: tuple[tuple[str, float], ...]


def task_of(design: DesignSpec, stops: Stops, sizes: Sizes) -> StopTask:
    """Return what a design asks of its stops; each case with a stroke must stay free of contact."""
    material = design.material
    scenes = [design.scene(name) for name in design.cases]
    return StopTask(
        elastic=material.elastic,
        I=float(second_moment(sizes.b, sizes.h)),
        h=float(sizes.h),
        L=float(sizes.l),
        stops=stops,
        travel=stops.allowed(material, sizes),
        bending=stops.bending.of(material) if stops.bending else None,
        shear=SHEAR_OF_STRENGTH * stops.shear.of(material) if stops.shear else None,
        free=tuple(
            (scene.case, scene.travel + scene.mean_travel) for scene in scenes if scene.travel > 0.0
        ),
    )


def stop_place(task: StopTask, name: str, L_a: float, gap: float) -> StopPlace:
    """Return a stop with the statics of the tip at the end of its travel."""
    E, L_b = task.elastic.E, task.L - L_a
    beam = {"E": E, "I": task.I, "L_a": L_a, "L_b": L_b, "d": gap}
    F = float(load_at_travel(delta=task.travel, **beam))
    F_contact = float(contact_load(**beam))
    R = -float(reaction(F=F, **beam))
    pi_1 = float(stiffness_ratio(L_a=L_a, L_b=L_b))
    share = L_a / task.L
    contact = task.stops.contact.stress(R, task.elastic)

    def stress(M: float) -> float:
        return float(bending_stress(M=M, I=task.I, h=task.h))

    return StopPlace(
        name=name,
        L_a=L_a,
        delta_G=gap,
        k_contact=float(contact_stiffness(E=E, I=task.I, L_a=L_a, L_b=L_b)),
        pi_1=pi_1,
        pi_5=float(operating_line(pi_1)),
        pi_5_threshold=float(contact_threshold(share)),
        tip_at_contact=gap / float(bent_shape(share)),
        F=F,
        F_contact=F_contact,
        F_excess=float(excess_load(F=F, **beam)),
        R_stop=R,
        sigma_onset=stress(min(F_contact, F) * task.L),
        sigma_base=stress(float(bending_moment(x=0.0, F=F, **beam))),
        sigma_contact=stress(F * L_b),
        p_hertz=contact.pressure if contact else None,
        tau_hertz=contact.shear if contact else None,
    )


def place_limits(task: StopTask, place: StopPlace) -> Iterator[Limit]:
    """Yield what a stop must keep: travel, room, stresses."""
    stops = task.stops
    half_range = place.pi_5 * place.delta_G / 2.0
    yield Limit(
        "travel", "", "tip on the operating line", half_range, task.travel, "m",
        "Monti (2014), section 8.4",
    )  # fmt: skip
    yield Limit(
        "contact", "", "tip when the blade touches, within the travel", place.tip_at_contact,
        task.travel, "m", "Monti (2014), section 9.1.1, with 3L − x",
    )  # fmt: skip
    if stops.smallest_gap is not None:
        yield Limit(
            "smallest gap", "", "smallest gap that can be made", stops.smallest_gap,
            place.delta_G, "m", "smallest-gap of the spec",
        )  # fmt: skip
    for case, stroke in task.free:
        yield Limit(
            "free travel", case, "stroke free of contact", stroke, place.tip_at_contact, "m",
            "stroke of the case",
        )  # fmt: skip
    if stops.bending is not None and task.bending is not None:
        yield Limit(
            "bending", "", "bending stress, worst of base and stop", place.bending,
            task.bending, "Pa", f"{stops.bending.allowable}; Monti (2014), section 9.1.2",
            required=stops.bending.factor,
        )  # fmt: skip
    if stops.shear is not None and task.shear is not None and place.tau_hertz is not None:
        yield Limit(
            "contact shear", "", "shear below the contact", place.tau_hertz, task.shear, "Pa",
            f"Hertz; half the {stops.shear.allowable} (Tresca)", required=stops.shear.factor,
        )  # fmt: skip


def force_at_travel(task: StopTask, place: StopPlace, c: float, travel: float) -> float:
    """Return the force, c beyond the blade's end, that holds the tip at a deflection [N].

    Without an offset it is that of `load_at_travel`.
    """
    L, L_a = task.L, place.L_a
    tip = L**2 * (2.0 * L + 3.0 * c) / 6.0
    stop = L_a**2 * (3.0 * (L + c) - L_a) / 6.0  # of the force at the stop
    between = L_a**2 * (3.0 * L - L_a) / 6.0
    rigidity = task.elastic.E * task.I
    if travel * stop <= place.delta_G * tip:
        return rigidity * travel / tip
    share = between / (L_a**3 / 3.0)
    return rigidity * (travel - place.delta_G * share) / (tip - stop * share)


def margin(limit: Limit) -> float:
    """Return the factor of a limit over the required one."""
    demand, capacity = float(limit.demand), float(limit.capacity)
    return capacity / (demand * limit.required) if demand > 0.0 else inf


def holds(limit: Limit) -> bool:
    """Return whether a limit is kept, to rounding."""
    return margin(limit) >= 1.0 - ROUNDING
