"""The verb verify: a model's numbers beside those of solid elements, each with its own error."""

from collections.abc import Callable, Iterator, MutableMapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import isfinite, sqrt
from time import perf_counter
from typing import NamedTuple

import numpy as np

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.exact_with_shells import ExactWithShells
from flexcli.engine.joint_models.joint_states import warmed
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.engine.models import NamedModel, model_series
from flexcli.engine.solid import calculix
from flexcli.engine.solid.deck import Deck, softness
from flexcli.engine.solid.model import solid_model
from flexcli.engine.solid.numbers import (
    STRAIGHT,
    Place,
    SolidNumbers,
    moving_masses,
    whole_model,
)
from flexcli.errors import NoSolution, SolveError
from flexcli.formulas.profile import Constant
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.stresses import blade_stress
from flexcli.mechanics.tangent import free_compliance
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.geometries.base import ACROSS_WIDTH, MOVING, Critical
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.own_motion import own_mode
from flexcli.parts.requirements import Ask, JointModel
from flexcli.parts.requirements.support import CENTRE, DIRECTIONS, compliance_of
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.temperature import held_across
from flexcli.results import (
    Cost,
    ErrorRange,
    Note,
    QuantityKind,
    Result,
    Status,
)
from flexcli.results.activity import doing
from flexcli.results.verification import Verification, VerifiedNumber

__all__ = ["verifiable", "verify"]

PRINTED = 2e-6
"""Relative error of what CalculiX prints with seven digits."""

TANGENT = 1e-4
"""Relative error of a stiffness from forces a hundredth of the stroke to either side."""

BESIDE_CLAMP = 2.0
"""Thicknesses from a clamp to where stresses are compared: what its corner does fades by some
e⁻⁴ a thickness."""

OUT_OF_PLANE = (2, 3, 4)
"""Directions along z and about x and y, where they are in the six."""

HELD_STRESS = 5e-3
"""Share of the stress of a blade that its clamps hold across that is left there along it."""

Found = tuple[float, ErrorRange | None]


class _NotRun(Exception):
    """A deck was written and nothing runs it."""


class _Question(NamedTuple):
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
    """Of a shift and of a support, which a material doubts in a way of their own."""
    on_demand: bool = False
    """Whether it takes so long that it is only compared where somebody asks for it."""
    directs: Callable[[], bool] = lambda: True
    """Whether the model gives each blade the moduli of its own direction, in a support."""


def verify(
    design: DesignSpec,
    sizes: Sizes,
    spec: str,
    *,
    model: str | None = None,
    meshes: int = 2,
    only: Sequence[str] = (),
    run: bool = True,
    files: MutableMapping[str, str] | None = None,
) -> Result:
    """Return a design's numbers by its finest model, or one named, beside CalculiX's.

    Parameters
    ----------
    design, sizes, spec
        The design, its sizes [m], and what it is called.
    model : str, optional
        The model that is verified.
    meshes : int
        Meshes, each edge of the coarsest cut in one, two, three: at least two for an error.
    only : sequence of str
        Names of the numbers to compare; all, if left out.
    run : bool
        Run CalculiX where it is installed; else the decks alone are made.
    files : mapping, optional
        Gets decks and what CalculiX printed, by the names of their files.

    Raises
    ------
    SolveError
        ``no-solid`` when the joint is no layout of straight blades and rods, ``no-such-number``
        when it has none of a name.

    """
    begun = perf_counter()
    design, notes = _between_rigid_clamps(design, sizes)
    named = model_series(design, model)[-1]
    asks = _asks(design, sizes, named)
    try:
        whole = [whole_model(asks[0].cold, k + 1) for k in range(meshes)]
    except NotAvailable as error:
        text = f"a {design.geometry.name} {error}: it has no solids to verify it by"
        raise SolveError(
            "no-solid", text, "give what is missing, or verify another joint"
        ) from error
    if not design.geometry.in_space:
        _refuse_crossing(design, sizes)
    elif any(scene.moves or scene.temperature is not None for scene in design.scenes()):
        text = "a mechanism in space is compared at rest and at assembly alone"
        notes.append(Note("at-rest", text))
    runs, soft = run and calculix.is_installed(), softness(whole[-1])
    bench = _Bench(runs, meshes, {} if files is None else files, soft)
    questions = _named(list(_questions(asks, _asks_at_stroke(design))), only)
    rows = tuple(bench.row(question) for question in questions)
    if not bench.runs:
        why = "ccx is not installed (Debian: apt install calculix-ccx)" if run else "not run"
        text = f"{why}: decks and what to compare only; -o DIR writes the decks"
        notes.append(Note("not-run", text))
    done = [row for row in rows if row.solid is not None]
    agreed = [row.agrees for row in done]
    if any(agrees is False for agrees in agreed):
        status = Status.FAIL
    else:
        is_known = bool(done) and None not in agreed and not bench.has_failed
        status = Status.PASS if is_known else Status.UNDECIDED
    seconds = perf_counter() - begun
    return Result(
        command="verify",
        spec=spec,
        status=status,
        title=design.title,
        warnings=tuple(notes),
        cost=Cost(seconds, named.name, None, by_model={
            named.name: seconds - bench.seconds, "solid elements": bench.seconds,
        }),
        verification=Verification(
            model=named.name,
            program="CalculiX, C3D20R" if bench.runs else "",
            meshes=tuple(model.elements for model in whole),
            numbers=rows,
            decks=tuple(bench.decks),
        ),
    )  # fmt: skip


def verifiable(design: DesignSpec, sizes: Sizes) -> tuple[str, ...]:
    """Return the names of the numbers that solid elements are asked for."""
    asks = _asks(design, sizes, model_series(design, None)[-1])
    questions = _questions(asks, _asks_at_stroke(design))
    return tuple(question.name for question in questions)


def _asks_at_stroke(design: DesignSpec) -> bool:
    """Return whether a design asks for a support stiffness at full stroke."""
    return any(each.is_of_a_case for each in design.requirements.support or ())


class _Asked(NamedTuple):
    """What is asked in a case, and at assembly: the same where the case has no temperature."""

    case: Ask
    cold: Ask


def _asks(design: DesignSpec, sizes: Sizes, model: NamedModel) -> list[_Asked]:
    """Return what is asked in every case."""
    return [
        _Asked(
            *(design.ask(each, sizes, model.joint_model) for each in (scene, scene.at_assembly()))
        )
        for scene in design.scenes()
    ]


def _between_rigid_clamps(design: DesignSpec, sizes: Sizes) -> tuple[DesignSpec, list[Note]]:
    """Return a design whose clamps are rigid, as those of the solids, and what to say of it."""
    geometry = design.geometry
    if geometry.compliant_clamps(sizes, design.material.elastic.nu or 0.0) is None:
        return design, []
    if "clamps" not in type(geometry).model_fields:
        text = f"the roots of a {geometry.name} are compliant, those of its solids rigid"
        hint = "leave 'clamps' and fillets out of its flexures to verify the rest"
        raise SolveError("no-solid", text, hint)
    if getattr(geometry, "clamps", None) in (None, "rigid"):
        return design, []  # fillets alone, which are in the solids
    text = "blades are compared between rigid clamps, without the compliance of their bodies"
    rigid = geometry.model_copy(update={"clamps": "rigid"})
    return design.model_copy(update={"geometry": rigid}), [Note("rigid-clamps", text)]


def _named(questions: list[_Question], only: Sequence[str]) -> list[_Question]:
    """Return the questions of given names."""
    names = [question.name for question in questions]
    for name in only:
        if name not in names:
            text = f"there is no number '{name}' to compare"
            raise SolveError("no-such-number", text, f"one of {', '.join(names)}")
    if only:
        return [question for question in questions if question.name in only]
    return [question for question in questions if not question.on_demand]


def _refuse_crossing(design: DesignSpec, sizes: Sizes) -> None:
    """Raise where parts of blades meet in a point: what is solid there is in no drawing of them."""
    layout = design.geometry.layout(design.material.elastic, sizes)
    for body in layout.bodies:
        ends = [
            np.array(place, dtype=np.float64)
            for blade in layout.blades
            for place, name in ((blade.start, blade.first), (blade.end, blade.second))
            if name == body.name
        ]
        apart = [float(np.hypot(*(a - b))) for i, a in enumerate(ends) for b in ends[:i]]
        heights = {float(np.ravel(blade.z)[0]) for blade in layout.blades}
        if apart and max(apart) == 0.0 and len(heights) == 1 and len(ends) > 1:
            text = f"the blades of a {design.geometry.name} meet in a point of '{body.name}'"
            hint = "the solid of such a crossing is not drawn; separate the blades across the width"
            raise SolveError("no-solid", text, hint)


@dataclass(eq=False)
class _Bench:
    """Runs decks, each once, on every mesh."""

    runs: bool
    meshes: int
    files: MutableMapping[str, str]
    softness: float
    decks: dict[str, None] = field(default_factory=dict)
    seconds: float = 0.0
    known: dict[str, calculix.Printed] = field(default_factory=dict)
    has_failed: bool = False
    """Whether CalculiX found no answer to some question."""
    asked: float = 0.0
    """Seconds of all decks that the numbers so far rest on, each time anew."""

    def row(self, question: _Question) -> VerifiedNumber:
        """Return a number by the model and by solids."""
        begun, before = perf_counter(), self.asked
        why, ours, error, share = "", None, None, 1.0
        try:
            ours, error = question.ours()
            if error is not None:
                error = _doubted(question, error)
            share = question.share()
        except (NotAvailable, SolveError, MechanismError) as wrong:
            why = f"the model: {wrong}"
        by_model = perf_counter() - begun
        found: list[float] = []
        try:
            for fineness in range(1, self.meshes + 1):
                name = f"{question.deck}-mesh-{fineness}"
                doing(f"{question.label}, mesh {fineness}")
                numbers = SolidNumbers(question.ask, self._runner(name), fineness)
                found.append(question.solid(numbers))
        except _NotRun:
            pass
        except (NotAvailable, MechanismError) as wrong:
            why = f"it {wrong}"
        except NoSolution as wrong:
            why, self.has_failed = wrong.text, True
        solid = found[-1] if len(found) == self.meshes else None
        own = None
        if solid is not None and self.meshes > 1 and solid != 0.0:
            try:
                own = abs(found[-2] / solid - 1.0) + question.error() + self.softness
            except NotAvailable as wrong:
                why = f"what solids leave out: {wrong}"
        return VerifiedNumber(
            question.name, question.label, question.unit, question.case, ours, error,
            solid, own, f"{question.deck}-mesh-{self.meshes}", question.read,
            perf_counter() - begun, why, by_model, self.asked - before, share,
        )  # fmt: skip

    def _runner(self, name: str) -> Callable[[Deck], calculix.Printed]:
        def run(deck: Deck) -> calculix.Printed:
            if deck.text in self.known:
                self.asked += self.known[deck.text].seconds
                return self.known[deck.text]
            own = name if name not in self.decks else f"{name}-{len(self.decks) + 1}"
            self.decks[own] = None
            self.files[f"{own}.inp"] = deck.text
            if not self.runs:
                raise _NotRun
            printed = calculix.run(deck.text, own)
            self.seconds += printed.seconds
            self.asked += printed.seconds
            self.files[f"{own}.dat"] = printed.dat
            if printed.frd:
                self.files[f"{own}.frd"] = printed.frd
            self.known[deck.text] = printed
            return printed

        return run


def _doubted(question: _Question, error: ErrorRange) -> ErrorRange | None:
    """Return an error of the model's with what its material leaves unsure."""
    ask = question.ask
    is_support = ask.material.is_directed and question.kind is QuantityKind.SUPPORT
    directed = (
        is_support
        and question.directs()
        and joint_in_space(ask.geometry, ask.material, ask.sizes).is_directed
    )
    return ask.material.doubted(error, question.kind, is_directed=directed)


def _questions(asks: list[_Asked], at_stroke: bool) -> Iterator[_Question]:
    """Yield what is compared: at rest and assembly once, then case by case.

    ``at_stroke``: the support stiffness there is compared without being named.
    """
    first = asks[0].cold
    turns = first.geometry.motion == "rotation"
    unit, effort = ("N*m/rad", "moment") if turns else ("N/m", "force")
    model = _Model(first.joint_model)
    yield _Question(
        "k_pivot" if turns else "k_stage", "stiffness at rest", unit, first,
        lambda: model.of(first, QuantityKind.STIFFNESS, first.joint_model.stiffness(first)),
        lambda solid: solid.stiffness(), "rest", f"{effort} on the moving body over its motion",
    )  # fmt: skip
    yield from _supports(first)
    if _has_mass(first):
        yield _Question(
            "f_0", "natural frequency", "Hz", first, lambda: model.frequency(first),
            lambda solid: solid.frequency(), "modes", "lowest mode that moves the body",
        )  # fmt: skip
    for asked in asks if not first.geometry.in_space else ():
        if asked.case.scene.temperature is not None:
            yield from _warm(asked, model, unit, effort)
        yield from _case(asked, model, many=len(asks) > 1)
        if asked.case.scene.moves and asked.case.scene.temperature is None:
            supports = _supports_at_stroke(asked.case, model, many=len(asks) > 1)
            yield from (each._replace(on_demand=not at_stroke) for each in supports)


def _warm(asked: _Asked, model: "_Model", unit: str, effort: str) -> Iterator[_Question]:
    """Yield the stiffness at a temperature, and the frequency that is its own and of its masses."""
    ask, cold = asked
    case, turns = ask.scene.case, ask.geometry.motion == "rotation"
    yield _Question(
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

    yield _Question(
        f"f_0_{case}", "frequency at its temperature", "Hz", ask, lambda: model.frequency(ask),
        solid, f"warm-{case}", "that at assembly, times the root of what the stiffness changes by",
        lambda: TANGENT, case,
    )  # fmt: skip


def _supports(ask: Ask) -> Iterator[_Question]:
    """Yield the stiffness in every direction, all others free."""
    guided = ask.geometry.motion == "translation" and ask.geometry.held(0.0)[2] is not None
    for index, direction in enumerate(DIRECTIONS):
        if guided and index == 5:
            continue
        turns = direction.startswith("theta")

        def ours(index: int = index) -> Found:
            def stiffness(assembly: SpaceAssembly) -> float:
                return float(1.0 / compliance_of(ask, assembly=assembly)[index, index])

            joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
            return stiffness(joint.assembly), joint.error(stiffness)

        def solid(numbers: SolidNumbers, index: int = index) -> float:
            return float(1.0 / numbers.compliance()[index, index])

        way = f"about {direction[-1]}" if turns else f"along {direction}"
        yield _Question(
            f"support_{direction}", f"support {way}", "N*m/rad" if turns else "N/m", ask,
            ours, solid, "support", f"motion of the moving body in step {index + 1}, a unit load",
            kind=QuantityKind.SUPPORT,
        )  # fmt: skip


def _has_mass(ask: Ask) -> bool:
    if ask.geometry.in_space:
        return ask.geometry.has_masses and ask.material.density is not None
    try:
        moving_masses(ask)
    except NotAvailable:
        return False
    return True


def _case(asked: _Asked, model: "_Model", *, many: bool) -> Iterator[_Question]:
    ask = asked.case
    scene, end = ask.scene, f"_{ask.scene.case}" if many else ""
    alone = ask._replace(scene=scene.without_loads())
    turns = ask.geometry.motion == "rotation"
    unit = "N*m/rad" if turns else "N/m"
    deck = f"stroke-{scene.case}"
    at_stroke = scene.moves and isinstance(model.inner, ExactModel)
    if at_stroke:
        yield _Question(
            f"k_end{end}", "stiffness at full stroke", unit, alone,
            lambda: model.stiffness_at_end(alone), lambda solid: solid.stiffness_at_end(),
            deck, "change of the effort over that of the motion, steps 1 and 3",
            lambda: TANGENT, scene.case,
        )  # fmt: skip
    if scene.moves or scene.temperature is not None:
        when = "largest of all steps" if scene.temperature is not None else "step 2"
        yield _Question(
            f"shift{end}", "parasitic shift", "m", alone,
            lambda: model.of(alone, QuantityKind.SHIFT, alone.joint_model.parasitic_shift(alone)),
            lambda solid: solid.shift(), deck, f"motion of the moving body, {when}",
            lambda: model.law_in_shift(alone), scene.case, kind=QuantityKind.SHIFT,
        )  # fmt: skip
    if at_stroke:
        yield _Question(
            f"k_across{end}", "stiffness across it", "N/m", alone,
            lambda: model.across_at_end(alone),
            lambda solid: solid.across_at_end(model.across_force(alone)),
            f"across-{scene.case}", "two forces along x over their motion",
            lambda: TANGENT, scene.case,
        )  # fmt: skip
    if scene.moves or scene.is_loaded or scene.temperature is not None:
        place = _Lazy(lambda: model.stress_place(ask))
        yield _Question(
            f"sigma{end}", "stress at a face", "Pa", ask, lambda: model.stress(ask, place.value),
            lambda solid: solid.stress(place.value),
            f"stress-{scene.case}" if scene.is_loaded else f"stroke-{scene.case}",
            place.value_text, lambda: model.law_in_stress(ask), scene.case,
            lambda: model.share_at(ask, place.value),
        )  # fmt: skip
    if scene.forces and scene.ends is not None:
        cold = asked.cold
        rest = cold._replace(scene=cold.scene._replace(travel=0.0, mean_travel=0.0, middle=0.0))
        yield _Question(
            f"F_cr{end}", "critical force at rest", "N", rest,
            lambda: model.critical(rest), lambda solid: solid.critical(model.critical(rest)[0]),
            f"buckling-{scene.case}", "buckling factor of a unit force, times the case's share",
            lambda: model.law_in_buckling(rest), scene.case,
        )  # fmt: skip


def _supports_at_stroke(case: Ask, model: "_Model", *, many: bool) -> Iterator[_Question]:
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
        direction = DIRECTIONS[index]
        turns = direction.startswith("theta")
        way = f"about {direction[-1]}" if turns else f"along {direction}"

        def ours(index: int = index) -> Found:
            return model.by_support(ask, index)[1]

        def directs(index: int = index) -> bool:
            return model.by_support(ask, index)[0].directs_blades

        def solid(numbers: SolidNumbers, index: int = index) -> float:
            try:
                known = model.by_support(ask, index)[1][1] is not None
            except SolveError as error:
                raise NotAvailable(f"is solved by no model: {error}") from error
            if not known:
                raise NotAvailable("is bent or shaped in a way for which no model has an error")
            return numbers.support_at_end(index)

        yield _Question(
            f"support_{direction}_end{end}", f"support {way} at full stroke",
            "N*m/rad" if turns else "N/m", ask, ours, solid, f"support-{ask.scene.case}",
            f"motion of two places of the moving body in step {index}, beside step 1",
            lambda: TANGENT, ask.scene.case, kind=QuantityKind.SUPPORT,
            directs=directs,
        )  # fmt: skip


class _Lazy:
    """A place that is looked for when it is first asked for."""

    def __init__(self, find: Callable[[], Place]) -> None:
        self._find = find

    @cached_property
    def value(self) -> Place:
        return self._find()

    @property
    def value_text(self) -> str:
        try:
            place = self.value
        except (NotAvailable, SolveError):
            return "stress at a face, the mean over its width"
        where = "greatest along it" if place.s is None else f"{place.s * 1e3:.4g} mm from its start"
        return f"{place.face} face of {place.stretch}, mean over its width, {where}"


class _Model:
    """The numbers of a model with their errors."""

    def __init__(self, joint_model: JointModel) -> None:
        self.joint_model = joint_model
        self.inner = getattr(joint_model, "inner", joint_model)
        self.exact = self.inner if isinstance(self.inner, ExactModel) else ExactModel()

    def of(self, ask: Ask, kind: QuantityKind, value: Computed) -> Found:
        """Return a value with the model's error of its kind."""
        return float(value), self.joint_model.error(ask, kind)

    def frequency(self, ask: Ask) -> Found:
        """Return the frequency of the mechanism's own motion."""
        if ask.geometry.in_space:
            squared = self.joint_model.frequency_squared(ask)
            return self.of(ask, QuantityKind.FREQUENCY, float(squared) ** 0.5)
        stiffness = self.joint_model.stiffness(ask)
        mode = own_mode(ask.mechanism, stiffness, ask.geometry, ask.material.elastic, ask.sizes)
        found = float(mode.stiffness / mode.mass) ** 0.5 / (2.0 * np.pi)
        return self.of(ask, QuantityKind.FREQUENCY, found * self.joint_model.frequency_factor(ask))

    def stiffness_at_end(self, ask: Ask) -> Found:
        """Return the tangent at the end of the stroke, for wide blades as far as is known.

        Bent blades of some width lie between the beam and the plate that cannot narrow, which is
        1/(1 − ν²) times as stiff: the range is all between, and the error at rest besides.
        """
        at_rest = float(self.joint_model.stiffness(ask) / self.inner.stiffness(ask))
        found = self.exact.stiffness_at_end(ask)
        own = self.joint_model.error(ask, QuantityKind.STIFFNESS)
        if own is None:
            return found * at_rest, None
        return found * at_rest, own + _between_beam_and_plate(ask, at_rest)

    def across_at_end(self, ask: Ask) -> Found:
        """Return the stiffness along the layout's x at the end of the stroke, the drive held."""
        state = self.exact.states(ask)
        free = state.parts[0].demand.free.tolist()
        index = free.index(3 * state.layout.index(MOVING))
        return 1.0 / float(free_compliance(state)[0, index, index]), _between_beam_and_plate(
            ask, 1.0
        )

    def by_support(self, ask: Ask, index: int) -> tuple[JointModel, Found]:
        """Return a stiffness at the end of the stroke, by shells where beams know no error."""
        for exact in (self.exact, ExactWithShells()):
            found = exact.support_at_stroke(ask, index, CENTRE, locked=True)[0]
            if found[1] is not None:
                break
        return exact, found

    def across_force(self, ask: Ask) -> float:
        """Return a force that moves the body across its stroke by a thousandth of the stroke."""
        scene, length = ask.scene, 1.0
        if ask.geometry.motion == "rotation":
            blades = ask.geometry.layout(ask.material.elastic, ask.sizes).blades
            length = max(float(np.hypot(*np.subtract(b.end, b.start))) for b in blades)
        return self.across_at_end(ask)[0] * 1e-4 * (scene.travel + scene.mean_travel) * length

    def critical(self, ask: Ask) -> Found:
        """Return the least critical force in the plane."""
        least = _least_critical(self.joint_model, ask)
        error = least.error or self.joint_model.error(ask, QuantityKind.BUCKLING)
        return float(least.force), error

    def law_in_buckling(self, ask: Ask) -> float:
        """Return by what share a joint that bends before it buckles differs from a straight one.

        A buckling step of solids is linear about rest.
        """
        bent, straight = (_least_critical(each, ask) for each in (self.exact, LinearModel()))
        return PRINTED + abs(float(bent.force) / float(straight.force) - 1.0)

    def stress(self, ask: Ask, place: Place) -> Found:
        """Return the stress at a place, in proportion to the worst that the model knows."""
        worst = max(abs(float(s.largest)) for s in self.joint_model.stresses(ask)[1])
        return self.of(ask, QuantityKind.STRESS, worst * self.share_at(ask, place))

    def share_at(self, ask: Ask, place: Place) -> float:
        """Return the stress at a place over the greatest, by exact beams."""
        exact = max(abs(float(s.largest)) for s in self.exact.stresses(ask)[1])
        return abs(self._along(ask, place)) / exact

    def law_in_stress(self, ask: Ask) -> float:
        """Return what the law of finite strain of a solid may change in a stress: the strain.

        What clamps hold a blade from growing across is not quite gone where it is compared.
        """
        worst = max(abs(float(s.largest)) for s in self.exact.stresses(ask)[1])
        strain = worst / ask.material.elastic.E
        held = 0.0 if ask.scene.temperature is None else held_across(warmed(ask))
        return PRINTED + strain + HELD_STRESS * held / strain

    def law_in_shift(self, ask: Ask) -> float:
        """Return what the law of finite strain of a solid may change in a shift, relative.

        Between Green's strain and the beam's, a blade bent to ε at its faces differs in length by
        ½ ∫ε² ds; no material states which law is its own.
        """
        state, E, found = self.exact.states(ask), ask.material.elastic.E, 0.0
        for blade in state.layout.blades:
            along = blade_stress(state, blade.name)
            strain = along.bending[0] / E
            found += 0.5 * float(np.trapezoid(strain**2, along.s[0]))
        return PRINTED + found / abs(float(self.exact.parasitic_shift(ask)))

    def _along(self, ask: Ask, place: Place) -> float:
        state = self.exact.states(ask)
        found = blade_stress(state, place.stretch, 257)
        face = (found.left if place.face == "left" else found.right)[0]
        if place.s is None:
            return float(np.abs(face).max())
        return float(np.interp(place.s, found.s[0], face))

    def stress_place(self, ask: Ask) -> Place:
        """Return where the stress of solids is compared: where it is greatest but in no corner.

        On blades that end in a corner that is two thicknesses from a clamp, else along the face.
        """
        layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
        found: dict[Place, float] = {}
        for stretch in solid_model(layout).stretches:
            blade = next(b for b in layout.blades if b.name == stretch.name)
            s = stretch.bricks.places[:, 0]
            at: tuple[float | None, ...] = (None,)
            if isinstance(blade.profile, STRAIGHT):
                low, high = (
                    float(2.0 * stretch.bricks.places[stretch.bricks.end(side), 1].max())
                    for side in (0, -1)
                )
                at = (float(s.min()) + BESIDE_CLAMP * low, float(s.max()) - BESIDE_CLAMP * high)
            for face in ("left", "right"):
                for one in at:
                    place = Place(stretch.name, face, one)
                    found[place] = abs(self._along(ask, place))
        return max(found, key=found.__getitem__)


def _between_beam_and_plate(ask: Ask, factor: float) -> ErrorRange:
    """Return how far blades between a beam and a plate are off a number that has a factor."""
    nu = ask.material.elastic.nu or 0.0
    return ErrorRange(1.0 / factor - 1.0, 1.0 / (factor * (1.0 - nu**2)) - 1.0)


def _least_critical(joint_model: JointModel, ask: Ask) -> Critical:
    """Return the least critical force in the plane that a model has."""
    found = [c for c in joint_model.critical(ask) if c.way != ACROSS_WIDTH]
    least = min(found, key=lambda c: float(c.force))
    if not isfinite(float(least.force)):
        raise NotAvailable("does not buckle under the forces of the case")
    return least
