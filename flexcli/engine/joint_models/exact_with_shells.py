"""The exact model of a joint of the plane, by shells where these tell more of it than beams."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from functools import partial

from flexcli.engine.joint_models.exact import ExactModel, alone
from flexcli.engine.joint_models.face_stress import PlateStresses
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.shell_shift import shift_by_shells
from flexcli.engine.joint_models.shell_stress import by_plates
from flexcli.engine.joint_models.space_deflection import deflections
from flexcli.engine.joint_models.space_shell import SHELLS, SpaceShellModel
from flexcli.engine.joint_models.space_stroke import support_at_stroke
from flexcli.mechanics.mesh import Effects
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, EndStress, JointModel, MisfitStress, Told
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["ExactWithShells"]


class ExactWithShells(ExactModel):
    """Exact beams in the plane, thin shells where a joint is solved in space."""

    name = "shell"
    has_all_strain_laws = True
    at_stroke = SpaceShellModel.at_stroke
    directs_blades = SpaceShellModel.directs_blades

    def __init__(self, effects: Effects | None = None) -> None:
        super().__init__(effects)
        self._known_pairs = Remembered("shell", of_blades=True)
        self._known_plates: Remembered[PlateStresses] = Remembered("shell", of_blades=True)
        self._known_stresses = Remembered("shell", of_blades=True)
        self._stresses_of_beams: Remembered[tuple[list[EndStress], float]]
        self._stresses_of_beams = Remembered("exact", of_blades=True)

    def shares(self, other: JointModel) -> None:
        """Share the stress of beams as well."""
        super().shares(other)
        if type(other) is ExactModel:
            self._stresses_of_beams = other._known_stresses

    def may_carry(self, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what shells have in a shift or a stress, where they tell it."""
        if kind is QuantityKind.SHIFT:
            return frozenset({EffectName.PLATE_WIDENING})
        if kind is QuantityKind.STRESS:
            return frozenset({EffectName.PLATE_WIDENING, EffectName.ANTICLASTIC})
        return frozenset()

    def carries(self, ask: Ask, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what shells have in a shift or a stress, and its error."""
        if kind is QuantityKind.SHIFT or (
            kind is QuantityKind.STRESS and self._plates(ask) is not None
        ):
            return self.may_carry(kind)
        return super().carries(ask, kind)

    def _plates(self, ask: Ask) -> PlateStresses | None:
        """Return what plates add to the stress of beams, where shells tell it."""
        with suppress(NotAvailable):
            return self._known_plates.of("plates", ask, partial(by_plates, ask))
        return None

    def _judged(self, ask: Ask) -> tuple[list[EndStress], float]:
        if self._plates(ask) is None:
            find = partial(self._judge_stress, ask)
            return self._stresses_of_beams.of("stress", ask, find)
        return super()._judged(ask)

    def _settled_shift(self, ask: Ask) -> tuple[float, float]:
        if ask.scene.temperature is not None:  # shells are asked for what the stroke makes of it
            return super()._settled_shift(ask)
        if not ask.scene.moves:
            raise NotAvailable("has no shift by shells but of a stroke: take --model exact")
        return shift_by_shells(alone(ask))

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, by the joint in space."""
        return support_at_stroke(ask, index, point, locked=locked, blades=SHELLS)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return how far the wrench moves a point, the tangents at the stroke being shells'."""
        return deflections(ask, point, direction, SHELLS)

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield the largest stress of each missed seat, by shells."""
        return SpaceShellModel().misfit_stresses(ask, small)
