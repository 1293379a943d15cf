"""The verbs as functions, for notebooks, scripts and the command line alike.

Each takes a spec and returns a :class:`~flexcli.results.Result`, in SI units. A spec is the path of
a file, YAML text (a string of more than one line), or what :func:`load` returned. ``overrides``
are values put over those of the spec, by their paths, e.g. ``{"geometry.h": "0.2 mm"}``, written
as in the spec. Sizes that a design leaves free are chosen first, as by :func:`size`, and a note in
the result says so; where no sizes meet the requirements, the result is that of the sizing.

Raises
------
SpecError
    Mistakes in the spec or in an argument: all findings, with file, line and column.
SolveError
    A question that has no answer for this design, with its remedy; ``NoSolution`` where a good
    spec was asked and the solver found none.

"""

from collections.abc import Callable, Collection, Iterable, Mapping, MutableMapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from os import PathLike, fspath
from pathlib import Path
from pickle import dumps, loads
from time import perf_counter
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, TypeAlias, get_args

from flexcli.errors import Finding, NoSolution, SolveError, SpecError
from flexcli.parts.design import DesignSpec, ModelName
from flexcli.parts.geometries import Sizes
from flexcli.results import Note, Result, Status
from flexcli.results.shown import register
from flexcli.spec.findings import nearest
from flexcli.spec.load import Loaded, validated
from flexcli.spec.overrides import Place
from flexcli.spec.parse import parse_document
from flexcli.spec.places import placed
from flexcli.spec.read import read_document
from flexcli.spec.references import from_anywhere
from flexcli.spectra import (
    asd_combine,
    asd_envelope,
    asd_equal_damage,
    asd_fds,
    asd_grms,
    asd_list,
    asd_scale,
    asd_show,
    asd_srs,
    asd_tolerance,
)
from flexcli.units import show, written

if TYPE_CHECKING:
    from flexcli.results.dossier import Dossier
    from flexcli.results.drawing import Drawing
    from flexcli.results.simulation import SupportSweeps
    from flexcli.spec.table_file import Columns

__all__ = [
    "Loaded",
    "accuracy",
    "asd_combine",
    "asd_envelope",
    "asd_equal_damage",
    "asd_fds",
    "asd_grms",
    "asd_list",
    "asd_notch",
    "asd_response",
    "asd_scale",
    "asd_show",
    "asd_srs",
    "asd_tolerance",
    "asd_worst_case",
    "balance",
    "check",
    "dossier",
    "drawing",
    "exported",
    "is_sized",
    "joint_drawing",
    "load",
    "plan",
    "simulate",
    "size",
    "sized",
    "spec_text",
    "stops",
    "support_over_stroke",
    "tolerances",
    "validate",
    "verdicts",
    "verify",
]

Spec: TypeAlias = str | PathLike[str] | Loaded
Overrides: TypeAlias = Mapping[str, Any]
Watch: TypeAlias = Callable[[str, float], bool]


class Portable(NamedTuple):
    """A spec as another process or machine makes it anew: its text, and what was put over it.

    ``file`` is where it stood; what it names is looked for from there.
    """

    text: str
    file: str
    changed: Mapping[tuple[str | int, ...], Any]

    @classmethod
    def of(cls, spec: Loaded) -> "Portable":
        """Return what makes a spec anew."""
        document = spec.document
        return cls(document.text, document.file, document.changed)

    def at(self, point: Mapping[str, Any]) -> Loaded:
        """Return the spec with the values of a point, or raise SpecError."""
        document = parse_document(self.text, self.file)
        return validated(document, Path(self.file).parent, {**self.changed, **point})


def load(
    source: Spec,
    *,
    overrides: Overrides | None = None,
    name: str = "<text>",
    allow_outside: bool = False,
) -> Loaded:
    """Read and validate a spec of any kind, so that several verbs need not read it again.

    Parameters
    ----------
    source : str, path or Loaded
        The spec.
    overrides : mapping, optional
        Values put over its own.
    name : str, optional
        What findings and results call a spec that is given as text.
    allow_outside : bool
        Let the spec name files outside its folder; not for a spec of strangers.

    """
    if isinstance(source, Loaded):
        return _again(source, overrides) if overrides else source
    with from_anywhere() if allow_outside else nullcontext():
        if isinstance(source, str) and "\n" in source:
            return validated(parse_document(source, name), Path(), overrides)
        path = Path(fspath(source))
        return validated(read_document(path), path.parent, overrides)


def validate(source: Spec, *, overrides: Overrides | None = None) -> Result:
    """Return a pass that tells kind and name of a sound spec; anything else is raised."""
    spec = load(source, overrides=overrides)
    name = getattr(spec.part, "title", "") or getattr(spec.part, "name", "")
    return Result("validate", _name(spec), Status.PASS, title=f"{spec.kind} {name}".rstrip())


def size(source: Spec, *, model: str | None = None, overrides: Overrides | None = None) -> Result:
    """Choose the free sizes of a design; ``model`` alone judges, over that of the spec.

    With ``robust:`` they are those at which enough of the parts within the tolerances pass, with
    options of the spec those of the best, with two objectives those at the knee of their front.
    """
    spec = _design(source, overrides)
    name = _model(model)
    design: DesignSpec = spec.part
    if design.sizing.against is None or not design.geometry.free:
        return _sized_of_options(spec, name)
    from flexcli.engine.trade_off import front_of
    from flexcli.parts.trade_off import moving_bound

    moving = moving_bound(design)

    goal = {"maximize" if moving.rises else "minimize": moving.key}

    def at(bound: str | None, near: Mapping[str, float]) -> Result:
        again = spec if bound is None else _again(spec, {moving.path: bound})
        return _sized_of_options(again, name, near)

    def best(bound: str | None, near: Mapping[str, float]) -> Result:
        changed = {("size", "objective"): goal} | ({} if bound is None else {moving.path: bound})
        return _sized_of_options(_again(spec, changed), name, near)

    return front_of(design, moving, at, best, design.sizing.points)


def _sized_of_options(
    spec: Loaded, model: str | None, near: Mapping[str, float] | None = None
) -> Result:
    """Return the sizing of the best of the options of a spec, or ``near`` where it has none."""
    among = spec.part.sizing.among
    if not among or not spec.part.geometry.free:
        return _sized_once(spec, model, near)
    from flexcli.engine.trade_off import best_option

    def sized(option: Mapping[str, Any]) -> tuple[DesignSpec | None, Result]:
        try:
            chosen = _again(spec, option)
        except SpecError as error:
            findings = tuple(error.findings)
            return None, Result("size", _name(spec), Status.ERROR, findings=findings)
        try:
            return chosen.part, _sized_once(chosen, model)
        except NoSolution as error:
            finding = Finding(_name(spec), error.text, error.remedy)
            return None, Result("size", _name(spec), Status.UNDECIDED, findings=(finding,))

    return best_option(among, sized)


def _sized_once(spec: Loaded, model: str | None, near: Mapping[str, float] | None = None) -> Result:
    """Return the sizing of a design as it stands, drawings looked for from sizes ``near``."""
    if spec.part.robust is not None and spec.part.geometry.free:
        from flexcli.engine.tolerances.robust import robust_size

        return placed(robust_size(spec.part, _name(spec), model), spec.document)
    from flexcli.engine.size import size as chosen

    return placed(chosen(spec.part, _name(spec), model, near), spec.document)


def sized(source: Spec, sizing: Result) -> Loaded:
    """Return a design with the sizes that a sizing chose, ready for any verb.

    Raises :class:`SolveError` where the sizing chose none.
    """
    spec = _design(source, None)
    if not is_sized(spec, sizing):
        text = "the sizing chose no sizes"
        raise SolveError("not-sized", text, "mend what the result says is in conflict")
    design: DesignSpec = spec.part
    geometry, height = design.geometry, sizing.values.get("H")
    sizes: dict[Place, str] = {
        geometry.place(name): written(sizing.values[name].value, geometry.dimension(name))
        for name in geometry.free
    }
    if height is not None and height.model == "sized":
        sizes["mechanism", "height"] = written(height.value, "length")
    chosen = sizing.choices.chosen if sizing.choices is not None else {}
    return _again(spec, {**chosen, **sizes})


def is_sized(source: Spec, sizing: Result) -> bool:
    """Return whether a sizing chose every free size of a design."""
    design: DesignSpec = _design(source, None).part
    return all(name in sizing.values for name in design.geometry.free)


def spec_text(spec: Loaded, folder: str | PathLike[str] = ".") -> str:
    """Return a sized design as the text of a spec whose paths start at a folder.

    Comments and order stay; a comment says which tool sized it, and when.
    """
    from flexcli.spec.save import spec_text as text_of

    return text_of(spec, Path(fspath(folder)))


def check(source: Spec, *, model: str | None = None, overrides: Overrides | None = None) -> Result:
    """Judge a design: each check by the cheapest model that decides it, or by one ``model``."""
    from flexcli.engine.check import check as judged

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return judged(design, sizes, name, model)

    return _on_sizes("check", source, overrides, verb, _model(model))


def verdicts(
    source: Spec, *, model: str | None = None, overrides: Overrides | None = None
) -> Result:
    """Judge a design as :func:`check` does, without its values: where many designs are asked."""
    from flexcli.engine.check import verdicts as judged

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return judged(design, sizes, name, model)

    return _on_sizes("check", source, overrides, verb, _model(model))


def simulate(source: Spec, *, points: int = 11, overrides: Overrides | None = None) -> Result:
    """Follow the stroke of every case by the exact model, at so many travels.

    A spec with ``accuracy:`` has the effects of its plan and no others.
    """

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        if design.accuracy is not None and not design.geometry.in_space:
            from flexcli.engine.planning.by_plan import simulate_by_plan

            return simulate_by_plan(design, sizes, name, points)
        from flexcli.engine.simulate import simulate as swept

        return swept(design, sizes, name, points)

    return _on_sizes("simulate", source, overrides, verb)


def tolerances(
    source: Spec,
    *,
    parts: int = 100_000,
    seed: int = 0,
    confidence: float = 0.95,
    model: str | None = None,
    over: Callable[[Callable[[Any], Any], Sequence[Any]], Iterable[Any]] = map,
    overrides: Overrides | None = None,
) -> Result:
    """Say what share of the parts within the tolerances passes, the worst, and what it hangs on.

    Parameters
    ----------
    source, overrides
        The spec, as everywhere.
    parts : int
        How many parts are drawn.
    seed : int
        Of the parts: the same seed gives the same.
    confidence : float
        Of the intervals in which the yields lie.
    model : str, optional
        The model that alone judges, over that of the spec.
    over : callable
        Puts a question to many designs, in order, as ``map`` does.

    """
    from flexcli.engine.tolerances.study import tolerances as studied

    changed = overrides or {}
    if model is not None:
        changed = {**changed, "model": _model(model)}

    def verb(spec: Loaded) -> Result:
        sizes = spec.part.fixed_sizes()
        recipe = (_remade, spec.document.text, spec.document.file, dumps(spec.document.changed))
        return studied(
            spec.part, sizes, _name(spec), parts=parts, seed=seed, confidence=confidence,
            over=over, recipe=recipe,
        )  # fmt: skip

    return _on_sized("tolerances", source, changed, verb)


def _remade(text: str, file: str, changed: bytes) -> DesignSpec:
    """Return a design that was read before, in another process."""
    document = parse_document(text, file)
    with from_anywhere():
        part: DesignSpec = validated(document, Path(file).parent, loads(changed)).part
    return part


def plan(
    source: Spec,
    *,
    model: str | None = None,
    audit: bool = False,
    overrides: Overrides | None = None,
) -> Result:
    """Say which effects a design calls for and which model carries them; audit: and if it held."""
    from flexcli.engine.planning.planned import planned

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return planned(design, sizes, name, model, audit=audit)

    return _on_sizes("plan", source, overrides, verb, _model(model))


def accuracy(
    source: Spec,
    *,
    asked: float | None = None,
    runs: int = 5,
    solid: bool = False,
    files: MutableMapping[str, str] | None = None,
    overrides: Overrides | None = None,
) -> Result:
    """Compare the models on a design: value, error and time of each, median of so many runs.

    ``asked`` is the relative error that will do, over that of the spec. With ``solid`` elements
    those are the finest model, which takes minutes; ``files`` gets their decks, by name.
    """
    from flexcli.engine.accuracy import accuracy as compared

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return compared(design, sizes, name, runs, asked, is_solid=solid, files=files)

    return _on_sizes("accuracy", source, overrides, verb)


def verify(
    source: Spec,
    *,
    model: str | None = None,
    meshes: int = 2,
    only: Sequence[str] = (),
    run: bool = True,
    files: MutableMapping[str, str] | None = None,
    overrides: Overrides | None = None,
) -> Result:
    """Put a design's numbers beside those of solid elements, where CalculiX is installed.

    ``meshes`` are solved, each finer than the one before; ``only`` names the numbers to
    compare; ``files`` gets decks and what CalculiX printed, by name.
    """
    from flexcli.engine.verify import verify as verified

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return verified(
            design, sizes, name, model=model, meshes=meshes, only=only, run=run, files=files
        )

    return _on_sizes("verify", source, overrides, verb, _model(model))


def balance(source: Spec, *, overrides: Overrides | None = None) -> Result:
    """Balance a mechanism against the motion of its base.

    Blades that cannot be sized, since nothing is asked of them, leave it without a stiffness.
    """
    from flexcli.engine.balance import balance as balanced

    spec = _design(source, overrides)
    try:
        spec, notes, instead = _sized_first("balance", spec)
    except SolveError as error:
        notes, instead = (Note("not-sized", f"the blades are not sized: {error.text}"),), None
    if instead is not None:
        return instead
    result = balanced(spec.part, _name(spec))
    return placed(replace(result, warnings=(*notes, *result.warnings)), spec.document)


def stops(
    source: Spec,
    *,
    simulate: bool | None = None,
    sweep: bool = False,
    seed: int | None = None,
    keep_history: bool = False,
    watched: Callable[[], AbstractContextManager[Watch]] = lambda: nullcontext(lambda *_: True),
    overrides: Overrides | None = None,
) -> Result:
    """Size an end stop on a blade and verify it.

    Parameters
    ----------
    source, overrides
        The spec, as everywhere.
    simulate : bool, optional
        Run every case in time to its end, or none; left out, what the line leaves undecided.
    sweep : bool
        Give the frequency response with stops, up and down.
    seed : int, optional
        Of random vibration, over that of the spec.
    keep_history : bool
        Keep the samples of what is run.
    watched : callable
        Gives, for the time of a simulation, a watch: told what runs and the share done, it answers
        whether to go on.

    """
    from flexcli.engine.stopping.by_plan import with_plan
    from flexcli.engine.stopping.simulation import decided, simulated
    from flexcli.engine.stopping.sweep import swept
    from flexcli.engine.stops import stops as stopped

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        result = with_plan(stopped(design, sizes, name), design, sizes)
        with watched() as watch:
            if simulate:
                kept = keep_history
                result = simulated(result, design, sizes, watch, seed=seed, keep_history=kept)
            elif simulate is None:
                result = decided(result, design, sizes, watch, seed=seed)
            return swept(result, design, sizes, watch) if sweep else result

    return _on_sizes("stops", source, overrides, verb)


def drawing(
    source: Spec, *, case: str | None = None, overrides: Overrides | None = None
) -> "Drawing":
    """Return a mechanism to scale, at rest and at the ends of the stroke of a case.

    A body on one joint, or no mechanism, is drawn as :func:`joint_drawing` has it.
    """
    from flexcli.engine.draw_mechanism import mechanism_drawing

    design, sizes = _to_draw(source, overrides)
    return mechanism_drawing(design, sizes, case)


def joint_drawing(
    source: Spec, *, case: str | None = None, overrides: Overrides | None = None
) -> "Drawing":
    """Return one joint to scale, without the bodies of a mechanism on several of them."""
    from flexcli.engine.draw import drawing as drawn

    design, sizes = _to_draw(source, overrides)
    return drawn(design, sizes, case)


def _to_draw(source: Spec, overrides: Overrides | None) -> tuple[DesignSpec, Sizes]:
    """Return a design and its sizes, chosen where they are free."""
    spec, _, instead = _sized_first("draw", _design(source, overrides))
    if instead is not None:
        text = "no sizes meet the requirements: there is nothing to draw"
        raise NoSolution("not-sized", text, "see flexure size")
    design: DesignSpec = spec.part
    return design, design.geometry.sized({})


def exported(
    source: Spec, to: str, *, overrides: Overrides | None = None, plain: bool = False
) -> tuple[bytes, tuple[str, ...]]:
    """Return a joint at rest as a file for CAD, ``step``, ``dxf`` or ``stl``, and what to know.

    Blades are exact, bodies plain blocks; what a wire cuts, as the spec's manufacturing states, is
    one plate with slots unless it shall be ``plain``. Lengths are in mm. It needs the extra
    ``cad``.
    """
    if to == "dxf":
        from flexcli.report.export_dxf import dxf as written_as
    elif to == "step":
        from flexcli.report.export_solid import step as written_as
    elif to == "stl":
        from flexcli.report.export_solid import stl as written_as
    else:
        hint = nearest(to, ("step", "dxf", "stl"))
        raise SpecError([Finding("to", f"there is no format '{to}'", hint)])
    from flexcli.report.prisms import in_one_plane, prisms

    drawn = drawing(source, overrides=overrides)
    is_plate = drawn.cut is not None and not plain
    if to == "dxf" or is_plate:
        drawn = in_one_plane(drawn)
    if not is_plate:
        return written_as(prisms(drawn)), () if drawn.in_space else drawn.notes
    from flexcli.report.slots import cut_plate

    plate, notes = cut_plate(drawn)
    return written_as([plate]), (*drawn.notes, *notes)


def dossier(
    source: Spec, *, model: str | None = None, overrides: Overrides | None = None
) -> "Dossier":
    """Gather what a design review reads: verdicts, drawing, stroke, spectra, equations.

    Free sizes are chosen first, and the verdicts are those of the sizing.
    """
    from flexcli.engine.dossier import dossier as gathered
    from flexcli.results.dossier import Dossier

    spec = _design(source, overrides)
    found = (size if spec.part.geometry.free else check)(spec, model=model)
    if not is_sized(spec, found):
        return Dossier(found, spec.document.text)
    design: DesignSpec = sized(spec, found).part if spec.part.geometry.free else spec.part
    names = spec.part.geometry.free
    return gathered(design, design.geometry.sized({}), found, spec.document.text, names)


def support_over_stroke(
    source: Spec, *, points: int = 11, overrides: Overrides | None = None
) -> "SupportSweeps":
    """Follow what holds a joint over the stroke of every case: in six axes where it has blades.

    Joints of no known shear modulus have the three of their plane. Free sizes are chosen first.

    Raises :class:`SolveError` where no case has a stroke, or the sizing chose no sizes.
    """
    from flexcli.engine.simulate import support_over_stroke as swept

    spec = _design(source, overrides)
    if spec.part.geometry.free:
        spec = sized(spec, size(spec))
    design: DesignSpec = spec.part
    return swept(design, design.fixed_sizes(), points)


def asd_response(
    source: Spec,
    *,
    spectra: Collection[Literal["density", "transfer"]] = (),
    overrides: Overrides | None = None,
) -> Result:
    """Say what the modes of a design make of the vibration or the shock of every case.

    ``spectra`` asks for densities of the responses, or for transfer functions to every body.
    """
    from flexcli.engine.response import respond

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        return respond(design, sizes, name, spectra)

    return _on_sizes("asd response", source, overrides, verb)


def asd_worst_case(
    source: Spec,
    *,
    qualities: Sequence[float] = (),
    duration: float | None = None,
    spectra: bool = False,
    columns: "Columns | None" = None,
    overrides: Overrides | None = None,
) -> Result:
    """Give Miles' worst case beside the exact response, of a design or of a profile.

    ``source`` may also be the name of a shipped profile; a profile needs quality factors, a design
    has its own. ``duration`` [s] of exposure is over that of the spec. ``spectra`` asks for both
    over the natural frequency. ``columns`` tells of a table what its heading does not.
    """
    from flexcli.engine.asd_worst_case import environments, exposed, worst_case
    from flexcli.parts.asd import ASDProfile
    from flexcli.spec.profiles import load_design_or_profile

    if isinstance(source, str) and "\n" not in source:
        spec, name = load_design_or_profile(source, overrides, columns), source
    else:
        spec = load(source, overrides=overrides)
        name = _name(spec)
    if isinstance(spec.part, ASDProfile):
        if not qualities:
            raise SpecError([Finding(name, "a profile needs a quality factor", "add --q 100")])
        found = exposed(name, spec.part, qualities, duration)
        return worst_case(found, name, spec.part.name, spectra=spectra)
    design: DesignSpec = _design(spec, None).part
    found = environments(design, qualities, duration)
    if not found:
        raise SpecError([Finding(name, "no case has an asd", "add one, or name a profile")])
    return worst_case(found, name, design.title, spectra=spectra)


def asd_notch(
    source: Spec,
    *,
    constant: float,
    knee: float | None = None,
    exponent: float = 2.0,
    fixed_mass: float = 0.0,
    case: str | None = None,
    axis: str | None = None,
    overrides: Overrides | None = None,
) -> Result:
    """Describe the profile of a case, notched to a semi-empirical limit on the force at the base.

    The limit is C² M₀² S_AA, with ``constant`` C, up to ``knee`` [Hz] and falls with ``exponent``
    beyond; ``fixed_mass`` [kg] stands on the shaker beside what the design moves.
    """
    from flexcli.engine.asd_notch import ForceLimit, notch

    def verb(design: DesignSpec, sizes: Sizes, name: str) -> Result:
        limit = ForceLimit(constant, knee, exponent, fixed_mass)
        return notch(design, sizes, name, limit, case, axis)

    return _on_sizes("asd notch", source, overrides, verb)


def _again(spec: Loaded, overrides: Mapping[Any, Any]) -> Loaded:
    """Validate a spec anew with values put over its own; what it names was allowed before."""
    document = spec.document
    text = parse_document(document.text, document.file)
    with from_anywhere():
        return validated(text, Path(document.file).parent, {**document.changed, **overrides})


def _name(spec: Loaded) -> str:
    return spec.document.file


def _model(name: str | None) -> str | None:
    """Return the name of a model, or raise what is near to it."""
    known = get_args(ModelName)
    if name is not None and name not in known:
        raise SpecError([Finding("model", f"there is no model '{name}'", nearest(name, known))])
    return name


def _design(source: Spec, overrides: Overrides | None) -> Loaded:
    spec = load(source, overrides=overrides)
    if spec.kind != "design":
        text = f"is a spec of kind {spec.kind}, not a design"
        hint = "name it in a design: flexure, material, geometry, cases, requirements"
        raise SpecError([Finding(_name(spec), text, hint)])
    return spec


def _sized_first(
    command: str, spec: Loaded, model: str | None = None
) -> tuple[Loaded, tuple[Note, ...], Result | None]:
    """Return a design with its free sizes chosen, what to say of it, or what says why not."""
    free = spec.part.geometry.free
    if not free:
        return spec, (), None
    sizing = size(spec, model=model)
    if not is_sized(spec, sizing):
        note = Note("sized-first", f"{', '.join(free)} free: no sizes meet the requirements")
        warnings = (note, *sizing.warnings)
        return spec, (), replace(sizing, command=command, warnings=warnings)
    values = [(name, sizing.values[name]) for name in free]
    chosen = ", ".join(f"{name} = {show(each.value, each.unit, 5)}" for name, each in values)
    text = f"sized first, as by flexure size: {chosen}"
    return sized(spec, sizing), (Note("sized-first", text),), None


def _on_sizes(
    command: str,
    source: Spec,
    overrides: Overrides | None,
    verb: Callable[[DesignSpec, Sizes, str], Result],
    model: str | None = None,
) -> Result:
    """Return what a verb says of a design with sizes, chosen first where the spec has none."""

    def on(spec: Loaded) -> Result:
        design: DesignSpec = spec.part
        return verb(design, design.fixed_sizes(), _name(spec))

    return _on_sized(command, source, overrides, on, model)


def _on_sized(
    command: str,
    source: Spec,
    overrides: Overrides | None,
    verb: Callable[[Loaded], Result],
    model: str | None = None,
) -> Result:
    """Return what a verb says of a spec with sizes, chosen first where it has none."""
    started = perf_counter()
    spec = _design(source, overrides)
    spec, notes, instead = _sized_first(command, spec, model)
    if instead is not None:
        return instead
    result = placed(verb(spec), spec.document)
    if not notes:
        return result
    cost = result.cost
    if cost is not None:
        cost = replace(cost, seconds=perf_counter() - started)
    return replace(result, warnings=(*notes, *result.warnings), cost=cost)


def _mapping(result: Result) -> dict[str, Any]:
    from flexcli.report.as_json import contents

    return contents(result)


def _html(found: "Result | Dossier") -> str | None:
    """Return what a notebook shows of a result; nothing where the extra ``report`` is missing."""
    from flexcli.report.page import summary

    try:
        return summary(found)
    except SolveError:
        return None


def _svg(drawn: "Drawing") -> str:
    from flexcli.report.drawings.plane import drawing_svg

    return drawing_svg(drawn, drawn.kind)


register(mapping=_mapping, html=_html, svg=_svg)
