"""The statics of a blade against its stop, for one place or many, and the limits on it."""

from collections.abc import Iterator
from math import inf
from typing import NamedTuple

from flexcli.engine.assess import ROUNDING
from flexcli.engine.omitted_effects import setting
from flexcli.formulas.card import outside
from flexcli.formulas.pi_law import MEASURED, SCATTER, contact_threshold, operating_line
from flexcli.formulas.section import second_moment, shear_parameter
from flexcli.formulas.stop_stiffness import bent_shape, contact_stiffness, stiffness_ratio
from flexcli.formulas.stopped_cantilever import (
    bending_moment,
    bending_stress,
    contact_load,
    excess_load,
    load_at_travel,
    reaction,
)
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import Setting
from flexcli.parts.effects.plate import PlateWidening
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.requirements import Limit
from flexcli.parts.stops import Stops
from flexcli.results import EXACT, ErrorRange
from flexcli.results.stops import StopPlace

__all__ = [
    "LINE",
    "StopTask",
    "contact_error",
    "force_at_travel",
    "holds",
    "line_error",
    "line_limit",
    "margin",
    "place_limits",
    "root_error",
    "static_limits",
    "stop_place",
    "task_of",
]

SOURCE = "Monti (2014), chapters 4, 8.5 and 9; corrected"
LINE = "operating line"
BELOW_THE_LINE = 0.22
"""How far below the line the simulated steady range lies at the most, from 0.55 to 0.85 of the
length (examples/boundary-control): the line's own models of contact and body differ from ours."""
LINE_ERROR = ErrorRange(-(SCATTER + BELOW_THE_LINE), inf)
"""Of the line as the peak of the tip: the way there from rest goes farther, and no line says how
far; so it may prove that a stop fails, never that it does."""
RESONANT = 0.01
"""How near (relative) to the blade's own frequency a sine has to be for the line to hold."""
LEAST_OVERHANG = 2.0
"""Overhang over thickness below which the statics of the blade on its stop have no known error."""
SHEAR_OF_STRENGTH = 0.5
"""Tresca: yield in shear at half the strength in tension."""


class StopTask(NamedTuple):
    """Tip mass and blade [SI], the stops, the deflection of the tip allowed, what must stay free.

    ``rigidity`` is how far the blade's bending rigidity may be off that of the beam: more by its
    plate widening, more or less by the rotation at the end of its travel. ``Phi`` is Timoshenko's
    parameter of the whole blade.
    """

    mechanism: TipMass
    elastic: Elastic
    I: float
    h: float
    L: float
    stops: Stops
    travel: float
    bending: float | None
    shear: float | None
    free: tuple[tuple[str, float], ...]
    rigidity: ErrorRange = EXACT
    Phi: float = 0.0

    def shear_on(self, length: float) -> float:
        """Return how much shear softens a part of the blade, bent as a cantilever [-]."""
        return 0.25 * self.Phi * (self.L / length) ** 2 if length > 0.0 else inf

    def rigidity_at(self, place: StopPlace) -> ErrorRange:
        """Return the same with the shear of the overhang beyond a stop, which softens it."""
        softer = self.shear_on(self.L - place.L_a)
        return ErrorRange(max(self.rigidity.low - softer, -0.5), self.rigidity.high)


def task_of(design: DesignSpec, stops: Stops, sizes: Sizes) -> StopTask:
    """Return what a design asks of its stops; each case with a stroke must stay free of contact."""
    mechanism = design.mechanism
    assert isinstance(mechanism, TipMass)  # the design refuses others
    material = design.material
    scenes = design.scenes()
    given = setting(design, sizes)
    travel = stops.allowed(material, sizes)
    return StopTask(
        mechanism=mechanism,
        elastic=material.elastic,
        I=float(second_moment(sizes.b, sizes.h)),
        h=float(sizes.h),
        L=float(sizes.l),
        stops=stops,
        travel=travel,
        bending=stops.bending.of(material) if stops.bending else None,
        shear=SHEAR_OF_STRENGTH * stops.shear.of(material) if stops.shear else None,
        free=tuple(
            (scene.case, scene.travel + scene.mean_travel) for scene in scenes if scene.travel > 0.0
        ),
        rigidity=_rigidity(given, travel / float(sizes.l)),
        Phi=float(
            shear_parameter(
                depth=float(sizes.h), l=float(sizes.l), poisson_ratio=given.poisson_bound
            )
        ),
    )


def _rigidity(given: Setting, rotation: float) -> ErrorRange:
    """Return the error of E I: widening at any curvature, and the square of the rotation."""
    wide = PlateWidening().changes(given).get("stiffness")
    high = 0.0 if wide is None else wide.bound
    return ErrorRange(-(rotation**2), high + rotation**2)


def contact_error(task: StopTask, place: StopPlace) -> ErrorRange:
    """Return the error of the tip's deflection at contact: shear bends the blade to another shape.

    ``(1 + s)/(1 + s a/φ) − 1`` with s of the tip's deflection by shear, φ(a) the bent shape.
    """
    s, share = task.shear_on(task.L), place.L_a / task.L
    changed = (1.0 + s) / (1.0 + s * share / float(bent_shape(share))) - 1.0
    return ErrorRange(min(changed, 0.0), max(changed, 0.0))


def line_error(task: StopTask, place: StopPlace, case: Case, f_0: float) -> ErrorRange | None:
    """Return the error of the operating line for a case, nothing where the line says nothing.

    It was measured with a sine at the blade's own frequency between two stops, in the first mode:
    of a shock, a random vibration or a swing that dies it is no bound at all.
    """
    if case.sine is None or case.vibration or case.shock or case.sweep or case.sines:
        return None
    if case.acceleration is not None or case.stroke is not None:
        return None
    inside = not list(outside(MEASURED, {"pi_1": place.pi_1, "pi_5": place.pi_5}))
    tuned = abs(case.sine.frequency / f_0 - 1.0) <= RESONANT
    return LINE_ERROR if inside and tuned and task.stops.sides == "both" else None


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
    """Yield what a stop must keep by the line and by statics: travel, room, stresses."""
    yield line_limit(task, place, "", None)
    yield from static_limits(task, place)


def line_limit(task: StopTask, place: StopPlace, case: str, error: ErrorRange | None) -> Limit:
    """Return the tip's travel as the operating line has it."""
    half_range = place.pi_5 * place.delta_G / 2.0
    return Limit(
        "travel", case, "tip on the operating line", half_range, task.travel, "m",
        "Monti (2014), section 8.4", error=error,
    )  # fmt: skip


def static_limits(task: StopTask, place: StopPlace) -> Iterator[Limit]:
    """Yield what statics say of a stop: room, and the stresses at the end of the travel."""
    stops = task.stops
    shape, rigidity = contact_error(task, place), task.rigidity_at(place)
    loaded = rigidity if task.L - place.L_a >= LEAST_OVERHANG * task.h else None
    yield Limit(
        "contact", "", "tip when the blade touches, within the travel", place.tip_at_contact,
        task.travel, "m", "Monti (2014), section 9.1.1, with 3L − x", error=shape,
    )  # fmt: skip
    if stops.smallest_gap is not None:
        yield Limit(
            "smallest gap", "", "smallest gap that can be made", stops.smallest_gap,
            place.delta_G, "m", "smallest-gap of the spec", error=EXACT,
        )  # fmt: skip
    for case, stroke in task.free:
        yield Limit(
            "free travel", case, "stroke free of contact", stroke, place.tip_at_contact, "m",
            "stroke of the case", in_capacity=True, error=shape,
        )  # fmt: skip
    if stops.bending is not None and task.bending is not None:
        yield Limit(
            "bending", "", "bending stress, worst of base and stop", place.bending,
            task.bending, "Pa", f"{stops.bending.allowable}; Monti (2014), section 9.1.2",
            required=stops.bending.factor, error=loaded,
        )  # fmt: skip
    if stops.shear is not None and task.shear is not None and place.tau_hertz is not None:
        yield Limit(
            "contact shear", "", "shear below the contact", place.tau_hertz, task.shear, "Pa",
            f"Hertz; half the {stops.shear.allowable} (Tresca)", required=stops.shear.factor,
            error=loaded and root_error(loaded),
        )  # fmt: skip


def root_error(of_force: ErrorRange) -> ErrorRange:
    """Return the error of a contact's stress, which grows as a root of the force at the most."""
    low, high = (max(1.0 + end, 0.0) ** 0.5 - 1.0 for end in of_force)
    return ErrorRange(low, high)


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
