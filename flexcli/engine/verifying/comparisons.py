"""The numbers that are compared: how a model and how solid elements give each."""

from collections.abc import Callable, Iterator
from functools import cache
from math import sqrt
from typing import NamedTuple

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.solid.numbers import BESIDE, SolidNumbers, StressPlace, moving_masses
from flexcli.engine.verifying.model_numbers import PRINTED, Found, ModelNumbers
from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import DIRECTIONS, compliance_of
from flexcli.parts.space_joint import joint_in_space
from flexcli.results import QuantityKind

__all__ = ["CaseAsks", "Comparison", "comparisons"]

TANGENT = 1e-4
"""Relative error of a stiffness from forces a hundredth of the stroke to either side."""

UNMESHED = 0.05
"""Share of the mass of a notch that is not meshed: beside its mouths, where its faces are steep."""

OUT_OF_PLANE = (2, 3, 4)
"""Directions along z and about x and y, where they are in the six."""


class Comparison(NamedTuple):
    """A number: its name, how a model and how solids give it, what its deck is of."""

    name: str
    label: str
    unit: str
    ask: Ask
    ours: Callable[[], Found]
    solid: Callable[[SolidNumbers], float]
    deck: str
    read: str
    error: Callable[[], float] = lambda: PRINTED
    case: str = ""
    share: Callable[[], float] = lambda: 1.0
    kind: QuantityKind | None = None
    """Kind of a shift, a support or the stiffness at rest, whose error a directed material widens
    in its own way."""
    on_demand: bool = False
    """Whether it takes so long that it is only compared where somebody asks for it."""
    of_less: float = 1.0
    """Share of the forces that it is read from which is its own: of all of them is the rounding."""
    directs: Callable[[], bool] = lambda: True
    """Whether the model gives each blade the moduli of its own direction, in a support."""


class CaseAsks(NamedTuple):
    """What is asked in a case, and at assembly: the same where the case has no temperature."""

    case: Ask
    cold: Ask


def comparisons(asks: list[CaseAsks], at_stroke: bool) -> Iterator[Comparison]:
    """Yield what is compared: at rest and assembly once, then case by case.

    ``at_stroke``: the support stiffness there is compared without being named.
    """
    first = asks[0].cold
    turns = first.geometry.motion == "rotation"
    unit, effort = ("N*m/rad", "moment") if turns else ("N/m", "force")
    model = ModelNumbers(first.joint_model)
    yield Comparison(
        "k_pivot" if turns else "k_stage", "stiffness at rest", unit, first,
        lambda: model.of(first, QuantityKind.STIFFNESS, first.joint_model.stiffness(first)),
        lambda solid: solid.stiffness(), "rest", f"{effort} on the moving body over its motion",
        kind=QuantityKind.STIFFNESS,
    )  # fmt: skip
    yield from _supports(first)
    if _has_mass(first):
        yield Comparison(
            "f_0", "natural frequency", "Hz", first, lambda: model.frequency(first),
            lambda solid: solid.frequency(), "modes", "lowest mode that moves the body",
            lambda: PRINTED + UNMESHED * abs(first.joint_model.frequency_factor(first) - 1.0),
        )  # fmt: skip
    for asked in asks if not first.geometry.in_space else ():
        if asked.case.scene.temperature is not None:
            yield from _at_temperature(asked, model, unit, effort)
        yield from _of_case(asked, model, many=len(asks) > 1)
        if asked.case.scene.moves and asked.case.scene.temperature is None:
            supports = _supports_at_stroke(asked.case, model, many=len(asks) > 1)
            yield from (each._replace(on_demand=not at_stroke) for each in supports)


def _at_temperature(
    asked: CaseAsks, model: ModelNumbers, unit: str, effort: str
) -> Iterator[Comparison]:
    """Yield the stiffness at a temperature, and the frequency that is its own and of its masses."""
    ask, cold = asked
    case, turns = ask.scene.case, ask.geometry.motion == "rotation"
    yield Comparison(
        f"k_{'pivot' if turns else 'stage'}_{case}", "stiffness at its temperature", unit, ask,
        lambda: model.of(ask, QuantityKind.STIFFNESS, ask.joint_model.stiffness(ask)),
        lambda solid: solid.warm_stiffness(), f"warm-{case}",
        f"change of the {effort} over that of the motion, steps 1 and 2", lambda: TANGENT, case,
    )  # fmt: skip
    if not _has_mass(cold):
        return

    def solid(numbers: SolidNumbers) -> float:
        rest = SolidNumbers(cold, numbers.runner, numbers.fineness)
        return rest.frequency() * sqrt(numbers.warm_stiffness() / rest.stiffness())

    yield Comparison(
        f"f_0_{case}", "frequency at its temperature", "Hz", ask, lambda: model.frequency(ask),
        solid, f"warm-{case}", "that at assembly, times the root of what the stiffness changes by",
        lambda: TANGENT, case,
    )  # fmt: skip


def _supports(ask: Ask) -> Iterator[Comparison]:
    """Yield the stiffness in every direction, all others free."""
    guided = ask.geometry.motion == "translation" and ask.geometry.held(0.0)[2] is not None
    for index in range(5 if guided else 6):
        yield _support(ask, index)


def _support(ask: Ask, index: int) -> Comparison:
    """Return the stiffness at rest in one of the six directions."""

    def stiffness(assembly: SpaceAssembly) -> float:
        return float(1.0 / compliance_of(ask, assembly=assembly)[index, index])

    def ours() -> Found:
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        return stiffness(joint.assembly), joint.error(stiffness)

    way, unit = _direction(index)
    return Comparison(
        f"support_{DIRECTIONS[index]}", f"support {way}", unit, ask, ours,
        lambda solid: float(1.0 / solid.compliance()[index, index]), "support",
        f"motion of the moving body in step {index + 1}, a unit load", kind=QuantityKind.SUPPORT,
    )  # fmt: skip


def _direction(index: int) -> tuple[str, str]:
    """Return one of the six directions in words, and the unit of a stiffness in it."""
    name = DIRECTIONS[index]
    if name.startswith("theta"):
        return f"about {name[-1]}", "N*m/rad"
    return f"along {name}", "N/m"


def _has_mass(ask: Ask) -> bool:
    if ask.geometry.in_space:
        return ask.geometry.has_masses and ask.material.density is not None
    try:
        moving_masses(ask)
    except NotAvailable:
        return False
    return True


def _of_case(asked: CaseAsks, model: ModelNumbers, *, many: bool) -> Iterator[Comparison]:
    ask = asked.case
    scene, end = ask.scene, f"_{ask.scene.case}" if many else ""
    alone = ask._replace(scene=scene.without_loads())
    turns = ask.geometry.motion == "rotation"
    unit = "N*m/rad" if turns else "N/m"
    deck = f"stroke-{scene.case}"
    at_stroke = scene.moves and isinstance(model.inner, ExactModel)
    if at_stroke:
        yield Comparison(
            f"k_end{end}", "stiffness at full stroke", unit, alone,
            lambda: model.stiffness_at_end(alone), lambda solid: solid.stiffness_at_end(),
            deck, "change of the effort over that of the motion, steps 1 and 3",
            lambda: TANGENT, scene.case, of_less=BESIDE,
        )  # fmt: skip
    if scene.moves or scene.temperature is not None:
        when, there = "largest of all steps", alone
        if scene.temperature is None:
            when, there = "step 2", alone._replace(scene=alone.scene.at_first_end())
        yield Comparison(
            f"shift{end}", "parasitic shift", "m", alone,
            lambda: model.of(there, QuantityKind.SHIFT, there.joint_model.parasitic_shift(there)),
            lambda solid: solid.shift(), deck, f"motion of the moving body, {when}",
            lambda: PRINTED, scene.case, kind=QuantityKind.SHIFT,
        )  # fmt: skip
    if at_stroke:
        yield Comparison(
            f"k_across{end}", "stiffness across it", "N/m", alone,
            lambda: model.across_at_end(alone),
            lambda solid: solid.across_at_end(model.across_force(alone)),
            f"across-{scene.case}", "two forces along x over their motion",
            lambda: TANGENT, scene.case,
        )  # fmt: skip
    if scene.moves or scene.is_loaded or scene.temperature is not None:
        # what acts out of the plane has no share in the mean over the width
        flat = ask._replace(scene=scene.in_plane())
        place = cache(lambda: model.stress_place(flat))
        yield Comparison(
            f"sigma{end}", "stress at a face", "Pa", flat, lambda: model.stress(flat, place()),
            lambda solid: solid.stress(place()),
            f"stress-{scene.case}" if scene.is_loaded else f"stroke-{scene.case}",
            _stress_read(place), lambda: model.law_in_stress(flat), scene.case,
            lambda: model.share_at(flat, place()), kind=QuantityKind.STRESS,
        )  # fmt: skip
    if scene.forces and scene.ends is not None:
        cold = asked.cold
        rest = cold._replace(scene=cold.scene._replace(travel=0.0, mean_travel=0.0, middle=0.0))
        yield Comparison(
            f"F_cr{end}", "critical force at rest", "N", rest,
            lambda: model.critical(rest), lambda solid: solid.critical(model.critical(rest)[0]),
            f"buckling-{scene.case}", "buckling factor of a unit force, times the case's share",
            lambda: model.law_in_buckling(rest), scene.case,
        )  # fmt: skip


def _supports_at_stroke(case: Ask, model: ModelNumbers, *, many: bool) -> Iterator[Comparison]:
    """Yield the stiffnesses out of the plane at full stroke, the drive locked.

    Whole blades of varied thickness would take an hour.
    """
    ask, end = case._replace(scene=case.scene.without_loads()), f"_{case.scene.case}" * many
    if not isinstance(model.inner, ExactModel):
        return
    blades = ask.geometry.layout(ask.material.elastic, ask.sizes).blades
    if not all(isinstance(blade.profile, Constant) for blade in blades):
        return
    for index in OUT_OF_PLANE:
        yield _support_at_stroke(ask, model, index, end)


def _support_at_stroke(ask: Ask, model: ModelNumbers, index: int, end: str) -> Comparison:
    """Return the stiffness at full stroke in one direction out of the plane."""

    def solid(numbers: SolidNumbers) -> float:
        try:
            known = model.by_support(ask, index)[1][1] is not None
        except SolveError as error:
            raise NotAvailable(f"is solved by no model: {error}") from error
        if not known:
            raise NotAvailable("is bent or shaped in a way for which no model has an error")
        return numbers.support_at_end(index)

    way, unit = _direction(index)
    return Comparison(
        f"support_{DIRECTIONS[index]}_end{end}", f"support {way} at full stroke", unit, ask,
        lambda: model.by_support(ask, index)[1], solid, f"support-{ask.scene.case}",
        f"motion of two places of the moving body in step {index}, beside step 1",
        lambda: TANGENT, ask.scene.case, kind=QuantityKind.SUPPORT,
        directs=lambda: model.by_support(ask, index)[0].directs_blades,
    )  # fmt: skip


def _stress_read(find: Callable[[], StressPlace]) -> str:
    """Return in words which stress of the solid is read."""
    try:
        place = find()
    except (NotAvailable, SolveError):
        return "stress at a face, the mean over its width"
    where = "greatest along it" if place.s is None else f"{place.s * 1e3:.4g} mm from its start"
    return f"{place.face} face of {place.stretch}, mean over its width, {where}"
