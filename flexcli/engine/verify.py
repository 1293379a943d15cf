"""The verb verify: a model's numbers beside those of solid elements, each with its own error."""

from collections.abc import Callable, MutableMapping, Sequence
from dataclasses import dataclass, field
from math import sin
from time import perf_counter

import numpy as np

from flexcli.engine.models import NamedModel, model_series
from flexcli.engine.solid import calculix
from flexcli.engine.solid.deck import Deck, rounding, softness
from flexcli.engine.solid.numbers import (
    SolidNumbers,
    whole_model,
)
from flexcli.engine.verifying.comparisons import CaseAsks, Comparison, comparisons
from flexcli.errors import NoSolution, SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.geometries.notch import Blocks
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.space_joint import joint_in_space
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

ALONG = 1e-6
"""Sine of an angle from x that is none."""


class _NotRun(Exception):
    """A deck was written and nothing runs it."""


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
    design = _with_all_effects(design, notes)
    _refuse_thinned(design)
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
    runs = run and calculix.is_installed()
    errors = *softness(whole[-1]), rounding(whole[-1])
    bench = _Bench(runs, meshes, {} if files is None else files, *errors)
    wanted = _named(list(comparisons(asks, _asks_at_stroke(design))), only)
    rows = tuple(bench.row(comparison) for comparison in wanted)
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
    wanted = comparisons(asks, _asks_at_stroke(design))
    return tuple(comparison.name for comparison in wanted)


def _asks_at_stroke(design: DesignSpec) -> bool:
    """Return whether a design asks for a support stiffness at full stroke."""
    return any(each.is_of_a_case for each in design.requirements.support or ())


def _asks(design: DesignSpec, sizes: Sizes, model: NamedModel) -> list[CaseAsks]:
    """Return what is asked in every case."""
    return [
        CaseAsks(
            *(design.ask(each, sizes, model.joint_model) for each in (scene, scene.at_assembly()))
        )
        for scene in design.scenes()
    ]


def _between_rigid_clamps(design: DesignSpec, sizes: Sizes) -> tuple[DesignSpec, list[Note]]:
    """Return a design whose clamps are rigid, as those of the solids, and what to say of it."""
    geometry = design.geometry
    if getattr(geometry, "blocks", None) is not None:
        text = "hinges are compared between rigid bodies at their mouths, without their blocks"
        bare = geometry.model_copy(update={"blocks": Blocks.model_validate("0 mm")})
        return design.model_copy(update={"geometry": bare}), [Note("rigid-clamps", text)]
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


def _with_all_effects(design: DesignSpec, notes: list[Note]) -> DesignSpec:
    """Return a design with the effects that its spec switches off, and note them."""
    off = sorted(key for key, wish in design.effects.items() if wish == "off")
    if not off:
        return design
    text = f"solids have what the spec switches off: compared with {', '.join(off)}"
    notes.append(Note("all-effects", text))
    kept = {key: wish for key, wish in design.effects.items() if key not in off}
    return design.model_copy(update={"effects": kept})


def _named(wanted: list[Comparison], only: Sequence[str]) -> list[Comparison]:
    """Return the comparisons of given names."""
    names = [comparison.name for comparison in wanted]
    for name in only:
        if name not in names:
            text = f"there is no number '{name}' to compare"
            raise SolveError("no-such-number", text, f"one of {', '.join(names)}")
    if only:
        return [comparison for comparison in wanted if comparison.name in only]
    return [comparison for comparison in wanted if not comparison.on_demand]


def _refuse_thinned(design: DesignSpec) -> None:
    """Raise where blades of one sheet, which all lie along its x, are drawn at angles."""
    material = design.material
    lie = material.orientation
    if not material.is_directed or lie is None or lie.width != "in-plane":
        return
    if any(abs(sin(angle)) > ALONG for angle in design.blade_angles()):
        text = (
            "blades that are thinned all lie along x of their wafer, solids in the drawing's axes"
        )
        raise SolveError("no-solid", text, "verify blades along x, or width: normal")


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
    """Error of solids whose bodies are of finite stiffness, which no finer mesh tells."""
    softness_held: float
    """The same of supports, which stretch blades and bend them in any way."""
    rounding: float
    """Share of a force of solids that is rounding."""
    decks: dict[str, None] = field(default_factory=dict)
    seconds: float = 0.0
    known: dict[str, calculix.Printed] = field(default_factory=dict)
    has_failed: bool = False
    """Whether CalculiX found no answer to some comparison."""
    asked: float = 0.0
    """Seconds of all decks that the numbers so far rest on, each time anew."""

    def row(self, comparison: Comparison) -> VerifiedNumber:
        """Return a number by the model and by solids."""
        begun, before = perf_counter(), self.asked
        why, ours, error, share = "", None, None, 1.0
        try:
            ours, error = comparison.ours()
            if error is not None:
                error = _doubted(comparison, error)
            share = comparison.share()
        except (NotAvailable, SolveError, MechanismError) as wrong:
            why = f"the model: {wrong}"
        by_model = perf_counter() - begun
        found: list[float] = []
        try:
            for fineness in range(1, self.meshes + 1):
                name = f"{comparison.deck}-mesh-{fineness}"
                doing(f"{comparison.label}, mesh {fineness}")
                numbers = SolidNumbers(comparison.ask, self._runner(name), fineness)
                found.append(comparison.solid(numbers))
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
                own = abs(found[-2] / solid - 1.0) + comparison.error()
                is_support = comparison.kind is QuantityKind.SUPPORT
                own += self.softness_held if is_support else self.softness
                own += self.rounding / comparison.of_less
            except NotAvailable as wrong:
                why = f"what solids leave out: {wrong}"
            if own is not None and own >= 1.0:
                own, why = None, "its meshes, or rounding, leave no digit of it"
        return VerifiedNumber(
            comparison.name, comparison.label, comparison.unit, comparison.case, ours, error,
            solid, own, f"{comparison.deck}-mesh-{self.meshes}", comparison.read,
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


def _doubted(comparison: Comparison, error: ErrorRange) -> ErrorRange | None:
    """Return an error of the model's with what its material leaves unsure."""
    ask = comparison.ask
    is_support = ask.material.is_directed and comparison.kind is QuantityKind.SUPPORT
    directed = (
        is_support
        and comparison.directs()
        and joint_in_space(ask.geometry, ask.material, ask.sizes).is_directed
    )
    at_rest = comparison.kind is QuantityKind.STIFFNESS
    return ask.doubted(error, comparison.kind, is_directed=directed, at_rest=at_rest, is_own=True)
