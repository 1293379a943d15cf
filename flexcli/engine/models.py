"""The models of a joint, from the cheapest to the finest, by the names that a user gives them."""

from collections.abc import Iterable
from functools import cached_property

from flexcli.engine.joint_models.corrected import Corrected
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import MODEL_EFFECTS
from flexcli.parts.requirements import AS_PRINTED, CLOSED_FORM, Ask, JointModel, Requirement
from flexcli.results import Check, QuantityKind

__all__ = ["MODEL_SERIES", "NamedModel", "model_series", "series_of"]

MODEL_SERIES = ("closed-form", "linear", "exact", "shell", "solid")
"""What judges, the cheapest first."""


OF_PLATES = (EffectName.PLATE_WIDENING, EffectName.ANTICLASTIC)
"""Effects of wide blades in the plane, which shells have whole."""

TOLD_BY_SHELLS = 0.01
"""Width of the range of a stress (relative) that shells of a joint of the plane leave."""


class NamedModel:
    """A model of a design by its name, made when it is first asked; it keeps what it solved.

    It shares what the one ``before`` it solves alike.
    """

    def __init__(self, design: DesignSpec, name: str, before: "NamedModel | None" = None) -> None:
        self.design = design
        self.name = name
        self.before = before

    @cached_property
    def joint_model(self) -> JointModel:
        """Return the model itself."""
        found = self._made()
        if self.before is not None:
            found.shares(self.before.joint_model)
        return found

    def _made(self) -> JointModel:
        planar = _joint_model(self.design, self.name)
        scenes = self.design.scenes()
        leaves = any(scene.tilts or scene.leaves_plane for scene in scenes)
        across = any(scene.across_by for scene in scenes)
        whole = self.name == "solid" and self.design.geometry.solids != "cross"
        if whole or not (across or (leaves and self.name != "source")):
            return planar
        from flexcli.engine.joint_models.out_of_plane import OutOfPlane

        return OutOfPlane(planar)

    def may_tell_more(self, requirement: Requirement, ask: Ask, known: Iterable[Check]) -> bool:
        """Return whether it may decide what those before it left open, ``known`` by their checks.

        In a joint of the plane shells judge little, and solids not all; shells decide nothing where
        an effect that they lack leaves no error of a stress. A load that buckles blades whose
        errors nobody knows would be looked for in vain. So would be the stiffness of hinges where a
        number has no error for what limbs weigh that nobody has weighed, or a pass hangs on that.
        """
        if self.name == "shell" and not self.design.geometry.in_space:
            asked, of_stress = requirement.by_shells, QuantityKind.STRESS
            if asked is of_stress and not self.joint_model.may_know(ask, of_stress):
                return False
            unsure = not requirement.is_of_stress or any(map(_is_unsure, known))
            return asked is not None and unsure
        if self.name == "solid":
            limbs = ask.geometry.has_limbs(ask.material.elastic, ask.sizes)
            if limbs and requirement.weighs(ask.scene):
                may_fail = requirement.falls_with_mass and not all(map(_hangs_on_mass, known))
                return requirement.by_solids and may_fail
            return requirement.by_solids
        return requirement.may_be_decided(ask)


def _is_unsure(check: Check) -> bool:
    """Return whether a check is less sure than shells tell a stress of a joint of the plane."""
    if check.factor_range is None:
        return True
    low, high = check.factor_range
    return high - low > TOLD_BY_SHELLS * check.factor


def _hangs_on_mass(check: Check) -> bool:
    """Return whether a check that no mass lets fail may fail by some, whatever the stiffness is."""
    low = 0.0 if check.factor_range is None else check.factor_range[0]
    return low <= 0.0 and (check.factor >= check.required or check.is_target)


def model_series(design: DesignSpec, model: str | None = None) -> tuple[NamedModel, ...]:
    """Return the models that may judge a design, the cheapest first; the one insisted on alone.

    Raises
    ------
    SolveError
        When closed forms are asked of a geometry that has none.

    """
    asked = model or design.model
    if asked is not None:
        return (NamedModel(design, asked),)
    found: list[NamedModel] = []
    for name in series_of(design):
        found.append(NamedModel(design, name, found[-1] if found else None))
    return tuple(found)


def series_of(design: DesignSpec) -> tuple[str, ...]:
    """Return the names of the models that a design's geometry has, the cheapest first."""
    lacking = set[str]()
    if not design.geometry.closed_forms:
        lacking.add("closed-form")
    if not _has_shells(design):
        lacking.add("shell")
    if not _has_solids(design):
        lacking.add("solid")
    return tuple(name for name in MODEL_SERIES if name not in lacking)


def _has_shells(design: DesignSpec) -> bool:
    """Return whether a joint has blades in space, or is asked of a stroke or a missed seat.

    While its sizes are sought, beams are fine enough; rods are beams always. Shells are whole:
    nothing of them can be left out.
    """
    asked = any(each.is_of_a_case for each in design.requirements.support or ())
    asked = asked or bool(design.requirements.misalignment_stress)
    if design.requirements.deflection:
        scenes = design.scenes()
        asked = asked or any(each.moves and each.wrench is not None for each in scenes)
    if design.geometry.solids in (None, "cross") and design.geometry.has_plane:
        of, is_known = design.requirements, design.material.poisson_ratio is not None
        asked = asked or bool(of.parasitic_shift or (is_known and (of.yielding or of.fatigue)))
    drawn = design.geometry.in_space and design.geometry.has_blades
    is_whole = drawn or not any(map(design.is_off, OF_PLATES))
    is_whole = is_whole and not design.omitted
    return design.fixed_sizes() is not None and (drawn or asked) and is_whole


def _has_solids(design: DesignSpec) -> bool:
    """Return whether a joint has necks of which there are solids, of a material that is known.

    While its sizes are sought, beams are fine enough. Solids are whole: nothing of them can be left
    out.
    """
    material = design.material
    known = material.poisson_ratio is not None and not material.is_directed
    is_whole = not (design.omitted or design.is_off(EffectName.THICK_NOTCH))
    is_sized = design.fixed_sizes() is not None
    return design.geometry.has_solids and known and is_whole and is_sized


def _joint_model(design: DesignSpec, model: str) -> JointModel:
    """Return a model of a design's joint; solvers are imported for the models that need them.

    The sources' formulas are taken as they stand; the other models get a correction for every
    effect that they do not carry. What the spec switches off corrects nothing, and stays in the
    error of their numbers.
    """
    if model in ("source", "closed-form") and not design.geometry.closed_forms:
        text = f"a {design.geometry.name} has no closed forms"
        raise SolveError("no-closed-forms", text, "take model linear or exact, or name none")
    if model not in ("source", *series_of(design)):
        text = f"a {design.geometry.name} has no {model} model"
        raise SolveError("no-such-model", text, f"take model {', '.join(series_of(design))}")
    heard = tuple(e for e in MODEL_EFFECTS if not design.is_off(e.name))
    off = tuple(e for e in MODEL_EFFECTS if design.is_off(e.name))
    if model == "source":
        return Corrected(AS_PRINTED, (), model, omitted=MODEL_EFFECTS)
    if model == "closed-form":
        return Corrected(CLOSED_FORM, heard, model, omitted=off)
    if design.geometry.in_space:
        if model == "linear":
            from flexcli.engine.joint_models.space_linear import SpaceLinearModel

            return SpaceLinearModel()
        if model == "shell":
            from flexcli.engine.joint_models.space_shell import SpaceShellModel

            return SpaceShellModel()
        from flexcli.engine.joint_models.space_exact import SpaceExactModel

        return SpaceExactModel()
    from flexcli.mechanics.mesh import Effects

    blades = Effects(
        extension=not design.is_off(EffectName.AXIAL_EXTENSION),
        shear=not design.is_off(EffectName.SHEAR),
    )
    if model == "linear":
        from flexcli.engine.joint_models.linear import LinearModel

        return Corrected(LinearModel(blades), heard, model, omitted=off)
    if model == "solid" and design.geometry.solids == "limbs":
        from flexcli.engine.joint_models.exact_with_limbs import ExactWithLimbs

        return Corrected(ExactWithLimbs(blades), heard, model, omitted=off)
    if model == "solid" and design.geometry.solids == "cross":
        from flexcli.engine.joint_models.exact_with_cross import ExactWithCross

        return Corrected(ExactWithCross(), heard, model, omitted=off)
    if model == "solid":
        from flexcli.engine.joint_models.exact_with_solids import ExactWithSolids

        return Corrected(ExactWithSolids(blades), heard, model, omitted=off)
    if model == "shell":
        from flexcli.engine.joint_models.exact_with_shells import ExactWithShells

        return Corrected(ExactWithShells(blades), heard, model, omitted=off)
    from flexcli.engine.joint_models.exact import ExactModel

    return Corrected(ExactModel(blades), heard, model, omitted=off)
