"""What a requirement is judged by: the design, the case, and the model."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from math import pi
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from flexcli.formulas.buckling import johnson_stress
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import Number, larger, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical, Geometry, Sizes
from flexcli.parts.material import UNSEEN, Material
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.scene import WARM, Scene
from flexcli.results import ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.layout import MissedSeat, SpaceLayout
    from flexcli.mechanics.space.springs import MemberSprings
    from flexcli.mechanics.space.swept_box import SweptBox
    from flexcli.parts.actuator import Actuator
    from flexcli.parts.effects import Setting
    from flexcli.parts.requirements.warm_shift import WarmShift

__all__ = [
    "CRUSHED",
    "MOST_SHARE",
    "Ask",
    "Bent",
    "CriticalShare",
    "DriveEffort",
    "EndStress",
    "JointModel",
    "MisfitStress",
    "RequirementError",
    "Swing",
    "Told",
    "WideFactor",
]


LAID = (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY, QuantityKind.STRESS)
"""What beams in the plane tell of blades each of which has its own modulus."""


class Told(NamedTuple):
    """A number and its error, None where that is unknown."""

    value: float
    error: ErrorRange | None

    def times(self, factor: float, error: ErrorRange | None) -> "Told":
        """Return it times a factor that has an error of its own."""
        both = None if self.error is None or error is None else self.error + error
        return Told(self.value * factor, both)


class Bent(NamedTuple):
    """The share of the largest stress that loads and heat make by bending what is deformed [-].

    ``unlike`` is by how much the stiffness of what they bend may differ besides from what the model
    tells of its own.
    """

    share: Number
    unlike: Number = 0.0


class MisfitStress(NamedTuple):
    """The largest stress by a missed seat in small motion [Pa], and where it is.

    ``springs`` is the relative error by the springs of the blades, ``error`` that with restrained
    warping and what small motion leaves out; None where it is unknown.
    """

    missed: "MissedSeat"
    stress: float
    where: str
    springs: ErrorRange | None
    error: ErrorRange | None


class Swing(NamedTuple):
    """What is known of a stroke's amplitude where the stress of other loads is added to it.

    ``own`` is the error of the stress of the stroke alone, ``added`` the stress of the loads [Pa],
    in the axial stress of all places, with its error; ``off`` is how far these may change the
    amplitude [Pa].
    """

    own: ErrorRange
    added: float
    error: ErrorRange
    off: float


class RequirementError(ValueError):
    """A requirement that cannot be judged on this design."""

    def __init__(self, text: str, hint: str = "") -> None:
        super().__init__(text)
        self.hint = hint


class WideFactor(NamedTuple):
    """How a force along a wide blade changes the factor by which plates raise its stress.

    ``low`` to ``high`` is the change of the factor of its bending, ``axial`` the share of its
    stress that is not bending, ``kept`` the largest factor of that, for the same motions. Without
    a stroke, of what a temperature bends, ``low`` to ``high`` is the factor itself.
    """

    low: Number
    high: Number
    axial: Number
    kept: Number

    def of(self, plain: Number) -> tuple[Number, Number]:
        """Return the range of the factor of the whole stress, from that of bending at rest."""
        bent, axial = plain * (1.0 - self.axial), self.axial
        return bent * self.low + axial, bent * self.high + axial * self.kept


class EndStress(NamedTuple):
    """Signed amplitude and mean of the stress of the stroke at one place and face, and the axial.

    ``joint`` is the joint of the place, where there are several with sizes of their own.
    ``is_at_face`` says that the numbers are the total of that face, in tension or compression;
    formulas give each face by itself. ``reverses`` says that the stroke goes as far either way with
    no load beside it, so that its mean is only the difference of both ways. ``wide`` is what the
    force along a blade of constant thickness changes of it, where a model knows that. ``pulled`` is
    the most that stretches the section there, of the stroke too, None where only formulas do not
    bend it, or nobody knows.
    """

    where: str
    amplitude: Computed
    mean: Computed
    axial: Computed
    joint: str = ""
    is_at_face: bool = False
    reverses: bool = False
    wide: WideFactor | None = None
    pulled: Computed | None = None

    @property
    def is_reversed(self) -> bool:
        """Return whether there is no stress beside the amplitude."""
        return all(isinstance(s, float) and s == 0.0 for s in (self.mean, self.axial))

    @property
    def largest(self) -> Computed:
        """Return the largest stress at this face, compression included."""
        if self.is_at_face:
            return abs(self.amplitude) + abs(self.mean + self.axial)
        return self.amplitude + self.mean + self.axial


MOST_SHARE = 5.0
"""Share of its loads and temperature up to which a mechanism is looked at, if no more is asked."""


class DriveEffort(NamedTuple):
    """Drive of a joint at an end of its stroke: its travel [rad or m], the effort [N·m or N].

    The effort is positive where the joint pushes back towards rest, and ``error`` is its own.
    ``load`` is the additional effort by the loads of the case, as if they had not moved the joint
    before [N·m or N].
    """

    travel: float
    effort: float
    error: ErrorRange | None
    load: float = 0.0


CRUSHED = "; blades yield first, J. B. Johnson's parabola"
"""What is said of a critical force or share that is less than the elastic one."""


class CriticalShare(NamedTuple):
    """The share of the loads of a case that buckles a mechanism [-], and how it is held.

    ``error`` is relative; its high end is infinite where nothing buckles up to that share.
    ``stress`` is the largest force along a blade over its area at that share [Pa], that pushes it;
    in the plane one that pulls it straight counts as well, for what it bears ends at its strength.
    """

    share: float
    held: str
    error: ErrorRange | None
    stress: float

    def borne(self, material: Material) -> "CriticalShare":
        """Return the share that is borne where blades yield before they buckle.

        By Johnson's parabola, as a force is; without a yield strength it is the elastic one.
        """
        given = material.yield_strength
        if given is None or self.stress <= 0.0:
            return self
        strength, per_share = given.value, self.stress / self.share

        def least(share: float) -> float:
            return float(johnson_stress(share * per_share, strength)) / per_share

        share = least(self.share)
        held, error = self.held, self.error
        if error is not None:
            low, high = (least(self.share * (1.0 + end)) / share - 1.0 for end in error)
            error = ErrorRange(low, high)
        if share < self.share:
            held += CRUSHED
        return CriticalShare(share, held, error, share * per_share)

    @property
    def least(self) -> float:
        """Return the least that the share may be, zero where nobody knows."""
        return 0.0 if self.error is None else self.share * (1.0 + self.error.low)


class Ask(NamedTuple):
    """What a requirement is judged by: floats for a check, signomials for a sizing.

    ``near`` is the same for a slightly different design, where derivatives are sought: models may
    continue from its solutions.
    """

    material: Material
    geometry: Geometry
    mechanism: Mechanism | None
    sizes: Sizes
    scene: Scene
    joint_model: "JointModel"
    actuator: "Actuator | None" = None
    near: "Ask | None" = None
    most_share: float = MOST_SHARE

    @property
    def clamp_softening(self) -> float:
        """Return the largest increase by its clamps of any compliance, off the motion too [-]."""
        given = self.material.poisson_ratio
        clamped = self.geometry.compliant_clamps(self.sizes, 0.5 if given is None else given.value)
        return 0.0 if clamped is None else clamped.softest

    def doubted(
        self,
        error: ErrorRange,
        kind: QuantityKind | None,
        *,
        in_space: bool = False,
        is_directed: bool = False,
        at_rest: bool = False,
        is_own: bool = False,
    ) -> ErrorRange | None:
        """Return an error of a number of a kind with what its material leaves unsure.

        ``at_rest`` it is the stiffness of the joint's own small motion, or of that alone;
        ``is_own`` it is the model's own number, and no other's.
        """
        is_beams = is_own or kind is QuantityKind.STRESS  # which no other model has
        is_laid = is_beams and kind in LAID and self.joint_model.directs_in_plane and not in_space
        is_laid = is_laid and self.material.is_uneven and self.scene.temperature is None
        thick: Number = 0.0
        bent = None
        if self.material.is_directed and not self.geometry.in_space:
            layout = self.geometry.blades_layout(self.material.elastic, self.sizes)
            travel = larger(map(abs, self.scene.stroke_ends)) if self.scene.moves else 0.0
            turns = self.geometry.motion == "rotation"
            thick = self.material.off_as_thick(kind, layout, travel, turns=turns)
            as_one = is_laid or not self.material.is_uneven
            if at_rest and not in_space and as_one and self._bends_as_drawn:
                from flexcli.parts.directed_joint import bent_as_plates

                layout = self.material.laid_in_plane(layout, self.geometry.drawn_turn)
                bent = bent_as_plates(self.material, kind, layout, self.geometry.held(1.0))
            if bent is not None:
                thick += UNSEEN * thick
        return self.material.doubted(
            error, kind, in_space=in_space, is_directed=is_directed,
            laid=self._plates_apart if is_laid else None, thick=thick, bent=bent,
        )  # fmt: skip

    @property
    def _plates_apart(self) -> Number:
        """Return by how much plates of one direction are stiffer than those of another, relative.

        All count as those of the largest Poisson's ratio.
        """
        least, most = self.material.poisson_ratios
        less, more = (self.geometry.wide_blades(self.sizes, nu) for nu in (least, most))
        found: Number = (1.0 - least**2) / (1.0 - most**2) - 1.0
        if less is not None and more is not None:
            pairs = (more.stiffness, less.stiffness), (more.stress, less.stress)
            found = smaller(found, larger(high.value / low.value - 1.0 for high, low in pairs))
        return found

    @property
    def _bends_as_drawn(self) -> bool:
        """Return whether nothing but its blades between rigid clamps bends, unheated.

        What heat strains changes a stiffness as much however stiff the blades are; at rest there
        are no loads.
        """
        plain = self.scene.temperature is None
        return plain and not self.clamp_softening and not self.geometry.has_fillets


class JointModel(ABC):
    """A model of the joint: the numbers that requirements need, as floats or signomials.

    Each method may raise :class:`flexcli.parts.elastic.NotAvailable`.
    """

    name: str
    covers: frozenset[EffectName] = frozenset()
    """The effects that it includes, and could leave out."""
    always: ClassVar[frozenset[EffectName]] = frozenset()
    """The effects that it cannot leave out."""
    at_stroke: str = "exact beams in space, sections that curl and warp"
    """Model of its blades at a stroke in space, for reports."""
    weighs_blades: ClassVar[bool] = False
    """Whether its stresses have what accelerated blades weigh, where their density is known."""
    directs_in_plane: bool = False
    """Whether each blade has the modulus of its own direction in the plane."""
    has_all_strain_laws: ClassVar[bool] = False
    """Whether the error of its shift has what any law of finite strain may change."""
    at_rest: str = "linear blades between rigid clamps, assembled in space at rest"
    """Model of its blades at rest in space, for reports."""
    directs_blades: bool = True
    """Whether each blade has the moduli of its own direction in a crystal or a sheet there."""

    def shares(self, other: "JointModel") -> None:
        """Take over what another model of the same design solves that both solve alike."""
        return

    def carried(self, setting: "Setting") -> frozenset[EffectName]:
        """Return the effects that its numbers include in a design."""
        return self.covers | self.always

    def springs(self, ask: Ask, *, in_plane: bool) -> "tuple[MemberSprings, ...] | None":
        """Return the springs of the blades in space at rest, None for those of formulas.

        Those that a motion ``in_plane`` does not strain may be any.
        """
        return None

    def own_joint(self, ask: Ask) -> "tuple[SpaceLayout, tuple[MemberSprings, ...]] | None":
        """Return the joint at rest where the model has it whole, None for one of its blades."""
        return None

    def frequency_factor(self, ask: Ask) -> float:
        """Return the ratio of a frequency to that by the stiffness alone, if it has one [-]."""
        return 1.0

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of its numbers of a kind, None where it cannot be estimated."""
        return None

    def may_know(self, ask: Ask, kind: QuantityKind) -> bool:
        """Return whether it may know the error of its numbers of a kind, before it solves any."""
        return True

    @abstractmethod
    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness of the joint along its motion [N·m/rad or N/m]."""

    @abstractmethod
    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration [N/m]."""

    def may_carry(self, kind: QuantityKind) -> frozenset[EffectName]:
        """Return the effects that a kind of number of any design may have, see ``carries``."""
        return frozenset()

    def carries(self, ask: Ask, kind: QuantityKind) -> frozenset[EffectName]:
        """Return the effects that a kind of number and its error have, beside those of all."""
        return frozenset()

    def heat_in_stiffness(self, ask: Ask) -> Number:
        """Return the share of the stiffness at a temperature that would not follow that of blades.

        Heat takes no more of it, and gives no more, where blades are stiffer.
        """
        raise NotAvailable(WARM)

    def axial_stress(self, ask: Ask) -> float | None:
        """Return the largest stress along blades that is no bending [Pa], None if nobody knows."""
        return None

    def bent(self, ask: Ask) -> Bent:
        """Return what of its stress loads and heat make by bending what is deformed."""
        return Bent(0.0)

    def warm_shift(self, ask: Ask) -> "WarmShift":
        """Return what stroke and heat make of the parasitic shift, by beams."""
        raise NotAvailable(WARM)

    def sag(self, ask: Ask) -> Computed:
        """Return how far the moving body sags along the case's acceleration [m]."""
        from flexcli.parts.own_motion import hanging_mass

        scene = ask.scene
        mass = hanging_mass(
            ask.mechanism, ask.geometry, ask.material.elastic, ask.sizes, scene.axis
        )
        return scene.acceleration * mass / self.sag_stiffness(ask)

    def sags(self, ask: Ask) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the sag in either sense of the acceleration, beyond first order [m]."""
        raise NotAvailable("has no sag beyond first order by this model: take --model exact")

    def heat_in_sag(self, ask: Ask) -> ErrorRange | None:
        """Return the relative error of what a temperature strains in a sag off the stroke.

        It is not available where the model's sag is that at assembly.
        """
        raise NotAvailable("has no thermal forces in its sag by this model: take --model exact")

    def sag_changes(self, ask: Ask) -> tuple[tuple[float, float], ...]:
        """Return the relative change of a sag in either sense by its own size, and its error.

        It is not available where first order is sufficient.
        """
        raise NotAvailable("has no sag beyond first order by this model: take --model exact")

    def frequency_squared(self, ask: Ask) -> Computed:
        """Return the square of the natural frequency of the mechanism's own motion [Hz²]."""
        from flexcli.parts.own_motion import own_mode

        elastic = ask.material.elastic
        mode = own_mode(ask.mechanism, self.stiffness(ask), ask.geometry, elastic, ask.sizes)
        factor = self.frequency_factor(ask)
        return mode.stiffness * (factor**2 / (mode.mass * (2.0 * pi) ** 2))

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return the drive of each joint at both ends of the case's stroke, with its error."""
        raise NotAvailable("has no force at stroke by this model: take --model exact")

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the case's stroke, and their errors.

        ``index`` is the direction, of x, y, z and about them along the axes of cases; ``point`` is
        from the moving body's, which it moved with [m]. All other motions are free, but that of the
        drive where it is ``locked`` [N/m or N·m/rad].
        """
        raise NotAvailable("has no support stiffness at stroke by this model: take --model exact")

    def warm_support_ratio(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> Told:
        """Return the ratio of a support stiffness at a case's temperature to the unstrained [-].

        Both are at rest and of the same material; all else is as of :meth:`support_at_stroke`.
        """
        raise NotAvailable("has no support stiffness at a temperature: take --model exact")

    def parasitic_frequency_at_stroke(
        self, ask: Ask
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the lowest frequency at both ends of the case's stroke, the drive locked [Hz]."""
        raise NotAvailable("has no frequency at stroke by this model: take --model exact")

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the displacement of a point by a case's wrench, beyond first order, with errors.

        That is with either sign of the wrench, at rest or at both ends of the stroke, the drive
        free: relative to the point without it, along an axis of cases or about it [m or rad].
        """
        raise NotAvailable("has no deflection beyond first order by this model: take exact")

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield the largest stress and its place for each blade that misses its seat, either way.

        ``small`` are those of small motion; the drive is free.
        """
        raise NotAvailable("has no stress of a missed seat beyond first order: take --model exact")

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the factors on loads and temperature together at which a mechanism buckles.

        They are for mechanisms in space, and for cases with a temperature.
        """
        raise NotAvailable("has no share of loads by this model: take --model exact")

    def knows_critical_shares(self, ask: Ask) -> bool:
        """Return whether the errors of its shares may be known, before any is looked for."""
        return True

    def warm_frequency_ratio(self, ask: Ask, *, locked: bool) -> tuple[float, ErrorRange | None]:
        """Return the ratio of a frequency in space at a case's temperature to the unstrained [-].

        Both are of the same material, the drive ``locked`` or free.
        """
        raise NotAvailable("has no frequency at a temperature by this model: take --model exact")

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return the box around the joint over a case's stroke, and the parts without outlines.

        The box is along the axes of cases.
        """
        raise NotAvailable("has no box around it by this model: take --model linear or exact")

    @abstractmethod
    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the signed shift at the end of the case's stroke [m]."""

    @abstractmethod
    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the name of the stress and its values wherever it may be largest."""

    def swing(self, ask: Ask) -> Swing | None:
        """Return what is known of amplitudes beside loads that are added to the stress, if any."""
        return None

    def swing_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of the largest amplitude where it is not that of the largest stress."""
        return None

    @abstractmethod
    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the forces on the joint, as the case's, that buckle it [N]."""
