"""The numbers of a model with their errors, as solid elements are compared with them."""

from math import isfinite

import numpy as np

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.exact_with_shells import ExactWithShells
from flexcli.engine.joint_models.joint_states import layout_of
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.engine.solid.model import solid_model
from flexcli.engine.solid.numbers import STRAIGHT, StressPlace
from flexcli.formulas.profile import Constant
from flexcli.formulas.quantity import Computed
from flexcli.formulas.section import second_moment
from flexcli.mechanics.tangent import free_compliance
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import ACROSS_WIDTH, MOVING, Critical
from flexcli.parts.own_motion import own_mode
from flexcli.parts.requirements import Ask, JointModel
from flexcli.parts.requirements.buckling import strained
from flexcli.parts.requirements.support import CENTRE
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["PRINTED", "Found", "ModelNumbers"]

PRINTED = 2e-6
"""Relative error of what CalculiX prints with seven digits."""

DIGITS = 5e-5
"""Relative error of stresses, of which it prints six digits."""

BESIDE_CLAMP = 2.0
"""Thicknesses from a clamp to where stresses are compared: what its corner does fades by some
e⁻⁴ a thickness."""

HELD_STRESS = 5e-3
"""Share of the stress of a blade that its clamps hold across that is left there along it."""

SLIGHT = 0.1
"""Force across a stroke over E I/l² of a blade that changes how it is bent by less than 1e-4."""

Found = tuple[float, ErrorRange | None]


class ModelNumbers:
    """The numbers of a model with their errors."""

    def __init__(self, joint_model: JointModel) -> None:
        self.joint_model = joint_model
        self.inner = joint_model
        while hasattr(self.inner, "inner"):
            self.inner = self.inner.inner
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
        at_rest = float(self.joint_model.stiffness(ask) / ExactModel().stiffness(ask))
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
        is_known = all(isinstance(blade.profile, Constant) for blade in state.layout.blades)
        error = _between_beam_and_plate(ask, 1.0) if is_known else None
        return 1.0 / float(free_compliance(state)[0, index, index]), error

    def by_support(self, ask: Ask, index: int) -> tuple[JointModel, Found]:
        """Return a stiffness at the end of the stroke, by shells where beams know no error."""
        for exact in (self.exact, ExactWithShells()):
            found = exact.support_at_stroke(ask, index, CENTRE, locked=True)[0]
            if found[1] is not None:
                break
        return exact, found

    def across_force(self, ask: Ask) -> float:
        """Return a force that moves the body across its stroke by 1e-4 of that, or a smaller one.

        It is small beside E I/l² of each blade, which bends otherwise under it.
        """
        scene, elastic = ask.scene, ask.material.elastic
        blades = ask.geometry.layout(elastic, ask.sizes).blades
        lengths = [float(blade.length) for blade in blades]
        length = max(lengths) if ask.geometry.motion == "rotation" else 1.0
        slight = SLIGHT * min(
            float(elastic.E * second_moment(blade.b, blade.least_thickness)) / l**2
            for blade, l in zip(blades, lengths, strict=True)
        )
        moved = 1e-4 * (scene.travel + scene.mean_travel) * length
        return min(self.across_at_end(ask)[0] * moved, slight)

    def critical(self, ask: Ask) -> Found:
        """Return the least critical force in the plane."""
        least = _least_critical(self.joint_model, ask)
        error = least.error or self.joint_model.error(ask, QuantityKind.BUCKLING)
        elastic = least.elastic
        if error is not None and elastic is not None:
            error = strained(error, float(np.max(elastic)) / ask.material.elastic.E)
        return float(least.force), error

    def law_in_buckling(self, ask: Ask) -> float:
        """Return by what share a joint that bends before it buckles differs from a straight one.

        A buckling step of solids is linear about rest.
        """
        bent, straight = (_least_critical(each, ask) for each in (self.exact, LinearModel()))
        return PRINTED + abs(float(bent.force) / float(straight.force) - 1.0)

    def stress(self, ask: Ask, place: StressPlace) -> Found:
        """Return the stress at a place, in proportion to the worst that the model knows."""
        worst = max(abs(float(s.largest)) for s in self.joint_model.stresses(ask)[1])
        found, error = self.of(ask, QuantityKind.STRESS, worst * self.share_at(ask, place))
        if place.s is not None or error is None:
            return found, error
        # the middle of a wide hinge bears more than the mean over its width, which is compared
        return found, error + ErrorRange(-((ask.material.elastic.nu or 0.0) ** 2), 0.0)

    def share_at(self, ask: Ask, place: StressPlace) -> float:
        """Return the stress at a place over the greatest, by exact beams.

        Where a hinge bears the most is the place itself, whatever its peak is there.
        """
        if place.s is None:
            return 1.0
        exact = max(abs(float(s.largest)) for s in self.exact.stresses(ask)[1])
        return abs(self._stress_at(ask, place)) / exact

    def law_in_stress(self, ask: Ask) -> float:
        """Return what the law of finite strain of a solid may change in a stress: the strain.

        What clamps hold a blade from growing across is not quite gone where it is compared.
        """
        worst = max(abs(float(s.largest)) for s in self.exact.stresses(ask)[1])
        strain = worst / ask.material.elastic.E
        warm, held = ask.scene.temperature, 0.0
        if warm is not None:
            held = warm.held_across(layout_of(ask), ask.material, ask.geometry.axes)
        return DIGITS + strain + HELD_STRESS * held / strain

    def _stress_at(self, ask: Ask, place: StressPlace) -> float:
        names = [blade.name for blade in self.exact.states(ask).layout.blades]
        found = self.exact.stress_along(ask, names.index(place.stretch), 257)
        face = (found.left if place.face == "left" else found.right)[0]
        if place.s is None:
            return float(np.abs(face).max())
        return float(np.interp(place.s, found.s[0], face))

    def stress_place(self, ask: Ask) -> StressPlace:
        """Return where the stress of solids is compared: where it is greatest but in no corner.

        On blades that end in a corner that is two thicknesses from a clamp, else along the face.
        Those shorter than four thicknesses are left out: near one clamp is near the other.
        """
        layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
        found: dict[StressPlace, float] = {}
        for stretch in solid_model(layout).stretches:
            blade = next(b for b in layout.blades if b.name == stretch.name)
            s = stretch.bricks.places[:, 0]
            at: tuple[float | None, ...] = (None,)
            if isinstance(blade.profile, STRAIGHT):
                low, high = (
                    float(2.0 * stretch.bricks.places[stretch.bricks.end(side), 1].max())
                    for side in (0, -1)
                )
                first, last = s.min() + BESIDE_CLAMP * low, s.max() - BESIDE_CLAMP * high
                at = (float(first), float(last)) if first <= last else ()
            for face in ("left", "right"):
                for one in at:
                    place = StressPlace(stretch.name, face, one)
                    found[place] = abs(self._stress_at(ask, place))
        if not found:
            raise NotAvailable("has no place away from both clamps: its blades are too short")
        return max(found, key=found.__getitem__)


def _between_beam_and_plate(ask: Ask, factor: float) -> ErrorRange:
    """Return how far blades between a beam and a plate are off a number that has a factor."""
    nu = ask.material.elastic.nu or 0.0
    least, most = min(factor, 1.0), max(factor, 1.0)
    return ErrorRange(least / factor - 1.0, most / (factor * (1.0 - nu**2)) - 1.0)


def _least_critical(joint_model: JointModel, ask: Ask) -> Critical:
    """Return the least critical force in the plane that a model has."""
    found = [c for c in joint_model.critical(ask) if c.way != ACROSS_WIDTH]
    least = min(found, key=lambda c: float(c.force))
    if not isfinite(float(least.force)):
        raise NotAvailable("does not buckle under the forces of the case")
    return least
