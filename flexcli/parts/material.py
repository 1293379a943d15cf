"""The material of the blades: numbers with their source, and strength as an amplitude."""

from collections.abc import Collection, Iterable
from math import sqrt
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import GetJsonSchemaHandler, PrivateAttr, model_validator
from pydantic_core import CoreSchema

from flexcli.formulas.fatigue import (
    amplitude_at_life,
    fully_reversed_amplitude,
    swt_reversed_amplitude,
)
from flexcli.numerics.rows import Number, larger, number, smaller
from flexcli.parts.base import (
    Density,
    Expansion,
    Part,
    QuantityOf,
    Stress,
    spec_error,
)
from flexcli.parts.elastic import Elastic
from flexcli.parts.named import Named
from flexcli.parts.sourced import Sourced
from flexcli.results import EXACT, ErrorRange, Property, QuantityKind

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from flexcli.mechanics.layout import Layout
    from flexcli.mechanics.space.layout import SpaceLayout
    from flexcli.parts.anisotropic import Crystal, Orientation, Orthotropic
    from flexcli.parts.fatigue_strength import FatigueAmplitude, SNCurve
    from flexcli.parts.over_temperature import OverTemperature
else:
    Crystal = Annotated[Any, Named("flexcli.parts.anisotropic:Crystal")]
    Orientation = Annotated[Any, Named("flexcli.parts.anisotropic:Orientation")]
    Orthotropic = Annotated[Any, Named("flexcli.parts.anisotropic:Orthotropic")]
    FatigueAmplitude = Annotated[Any, Named("flexcli.parts.fatigue_strength:FatigueAmplitude")]
    SNCurve = Annotated[Any, Named("flexcli.parts.fatigue_strength:SNCurve")]
    OverTemperature = Annotated[Any, Named("flexcli.parts.over_temperature:OverTemperature")]

__all__ = ["STRENGTHS", "UNSEEN", "WARM", "Material", "MissingProperty"]

BUCKLED, STRETCHED = 4.0, 20.0
"""By how much more shear takes of a critical force than of a stiffness, π²/3 at most; and how far a
force across moves a body along, over (h/l)², the travel over l and a shift, 1.7 of a guided one."""

UNSEEN = 0.3
"""Part of what thick blades are off that is added where plates tell the rest: with a tenth of it,
solids had up to 0.95 of what was left."""

OUT_OF_PLANE = (QuantityKind.SUPPORT, QuantityKind.RESPONSE)
"""Kinds of numbers that depend on torsion and shear of the blades, whatever the joint."""

STRENGTHS = ("yield_strength", "tensile_strength", "fatigue_amplitude")
"""Properties that may have points over temperature; an admissible stress has none."""

_UNITS = {"poisson_ratio": "", "loss_factor": "", "density": "kg/m^3", "thermal_expansion": "1/K"}
"""SI units of the properties that are no stress."""


SECTIONS = 3.0
"""Power of a length in a stiffness over E: thermal growth of sections changes it by so many
growths."""

MODULUS_DRIFT = 8e-4
"""Largest relative change of Young's modulus per kelvin from assembly, where it is not given over
temperature [1/K]: more than the steepest curve that is shipped, of Invar (NIST)."""

STRENGTH_LOSS, WARM = 4e-3, 80.0
"""Assumed loss of strength per kelvin above assembly where it is not given over temperature [1/K],
and up to which temperature [K]: an allowance, no bound from a source. Age-hardened aluminium goes
soft beyond."""


class MissingProperty(ValueError):
    """A requirement needs a property of the material that is not given."""

    def __init__(self, field: str, why: str) -> None:
        super().__init__(f"the material has no {field}: {why}")
        self.field = field
        self.why = why


class Material(Part):
    """Elastic, strength and fatigue properties; what nobody gave is absent, never guessed."""

    extends: str = ""
    """Name or path of a material whose values hold where none are given here,
    e.g. ``extends: ti-6al-4v``.
    """
    name: str = ""
    """Name that reports print, e.g. ``Ti-6Al-4V``."""
    condition: str = ""
    """Heat treatment or temper, e.g. ``annealed``."""
    note: str = ""
    """Anything a reader should know of the numbers,
    e.g. ``sheet, across the rolling direction``.
    """
    youngs_modulus: Sourced[Stress]
    """Young's modulus E, e.g. ``114 GPa``."""
    poisson_ratio: Sourced[Annotated[float, QuantityOf("ratio", above=-1.0, below=0.5)]] | None = (
        None
    )
    """Poisson's ratio, e.g. ``0.34``."""
    crystal: Crystal | None = None
    """Stiffness of a cubic crystal, of which the moduli are by its orientation,
    e.g. ``crystal: {c11: 165.7 GPa, c12: 63.9 GPa, c44: 79.6 GPa}``.
    """
    orthotropic: Orthotropic | None = None
    """Constants of an orthotropic sheet, of which the moduli are by its orientation,
    e.g. ``orthotropic: {E_1: 140 GPa, E_2: 10 GPa, G_12: 5 GPa, nu_12: 0.3}``.
    """
    orientation: Orientation | None = None
    """How the blades lie in the crystal or the sheet,
    e.g. ``orientation: {turned: 45 deg}, crystal: {c11: 165.7 GPa, c12: 63.9 GPa, c44: 79.6 GPa}``.
    """
    loss_factor: Sourced[Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)]] | None = None
    """Loss factor of the material, 1/Q, which a vibration has where it states no Q,
    e.g. ``1e-3``.
    """
    density: Sourced[Density] | None = None
    """Mass per volume, e.g. ``4430 kg/m^3``."""
    tensile_strength: Sourced[Stress] | None = None
    """Tensile strength R_m, e.g. ``950 MPa``."""
    yield_strength: Sourced[Stress] | None = None
    """Yield strength R_p0.2, e.g. ``880 MPa``."""
    admissible_stress: Sourced[Stress] | None = None
    """A design stress that its source gives as such, e.g. ``400 MPa``."""
    fatigue_amplitude: FatigueAmplitude | None = None
    """Stress amplitude that is borne for a number of cycles,
    e.g. ``{value: 510 MPa, cycles: 1e7}``.
    """
    sn_amplitudes: SNCurve | None = None
    """S-N curve in stress amplitudes,
    e.g. ``{basquin: {coefficient: 2000 MPa, exponent: -0.08, to_cycles: 1e7}}``.
    """
    thermal_expansion: Sourced[Expansion] | None = None
    """Coefficient of thermal expansion, e.g. ``8.6e-6 1/K``."""
    over_temperature: OverTemperature | None = None
    """What changes with temperature, points with their source,
    e.g. ``{elongation: {points: [[80 K, -0.391 %], [293 K, 0 %]]}}``.
    """

    _warmed: "dict[tuple[float, ...], tuple[Material, Material]]" = PrivateAttr(
        default_factory=dict
    )
    _spread: float = PrivateAttr(0.0)
    _drift: float = PrivateAttr(0.0)
    _weaker: dict[str, float] = PrivateAttr(default_factory=dict)
    _sheared: float = PrivateAttr(0.0)
    _rough: float = PrivateAttr(0.0)
    _thick: tuple[float, float] = PrivateAttr((0.0, 0.0))
    _stiffer: float = PrivateAttr(1.0)
    _differ: float = PrivateAttr(0.0)
    _uneven: float = PrivateAttr(0.0)
    _skewed: float = PrivateAttr(0.0)
    _held: float = PrivateAttr(0.0)
    _stressed: float = PrivateAttr(0.0)
    _least_nu: float = PrivateAttr(0.0)
    _planes: "tuple[NDArray[np.float64], ...]" = PrivateAttr(())

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        alone = {"required": whole.pop("required")}
        others = ("extends", "crystal", "orthotropic")
        return {**whole, "anyOf": [alone, *({"required": [key]} for key in others)]}

    @model_validator(mode="before")
    @classmethod
    def _moduli_of_sheet(cls, data: Any) -> Any:
        """Give a crystal or an orthotropic sheet the moduli along x."""
        if not isinstance(data, dict):
            return data
        sheets = [key for key in ("crystal", "orthotropic") if data.get(key) is not None]
        if not sheets:
            if data.get("orientation") is not None:
                raise spec_error(
                    "nothing says what depends on the orientation",
                    "give crystal or orthotropic",
                    at=("orientation",),
                )
            return data
        for key in ("youngs_modulus", "poisson_ratio", *sheets[1:]):
            if data.get(key) is not None:
                raise spec_error(
                    f"{key} stands beside {sheets[0]}, of which it follows", "keep one", at=(key,)
                )
        from flexcli.parts.anisotropic import stated

        return stated(data)

    @model_validator(mode="after")
    def _strengths_in_order(self) -> "Material":
        if (
            self.tensile_strength
            and self.yield_strength
            and self.yield_strength.value > self.tensile_strength.value
        ):
            raise spec_error(
                "the yield strength is above the tensile strength",
                "check both values and their units",
                at=("yield_strength",),
            )
        for name in ("fatigue_amplitude", "sn_amplitudes"):
            self._refuse_mean_beyond(name)
        modulus = self.youngs_modulus.value
        for name in ("tensile_strength", "yield_strength", "fatigue_amplitude"):
            given = getattr(self, name)
            if given is not None and given.value > 0.2 * modulus:
                raise spec_error(
                    f"{given.value:g} Pa is more than a fifth of Young's modulus",
                    "no solid is that strong: check the units of both",
                    at=(name,),
                )
        return self

    def _refuse_mean_beyond(self, name: str) -> None:
        """Refuse a fatigue strength whose mean stress reaches the tensile strength."""
        given, tensile = getattr(self, name), self.tensile_strength
        if given is None or given.stress_ratio is None or tensile is None:
            return
        curve = name == "sn_amplitudes"
        amplitude = max(s for _, s in given.curve()) if curve else given.value
        mean = amplitude * (1.0 + given.stress_ratio) / (1.0 - given.stress_ratio)
        if mean >= tensile.value:
            raise spec_error(
                f"the mean stress at R = {given.stress_ratio:g} is {mean / 1e6:.4g} MPa, which "
                "reaches the tensile strength",
                "check the amplitude (half of the range) and the stress ratio",
                at=(name,),
            )

    @property
    def E(self) -> float:  # noqa: N802 - the field's symbol
        """Return Young's modulus [Pa]."""
        return self.youngs_modulus.value

    @property
    def elastic(self) -> Elastic:
        """Return the elastic constants of the material."""
        ratio = self.poisson_ratio
        return Elastic(self.E, ratio.value if ratio is not None else None)

    def oriented(self, angles: Iterable[float]) -> "Material":
        """Return the material of blades at angles from x [rad], unchanged where it is isotropic."""
        if self.sheet is None:
            return self
        from flexcli.parts.anisotropic import blades_of

        blades = blades_of(self.sheet, self.orientation, angles)
        values = {"youngs_modulus": blades.E, "poisson_ratio": blades.nu}
        found = self.model_copy(
            update={
                name: getattr(self, name).model_copy(update={"value": value})
                for name, value in values.items()
            }
        )
        found._spread, found._sheared = blades.spread, blades.sheared
        found._rough = blades.spread
        found._uneven = blades.uneven
        found._thick, found._skewed = blades.thick, blades.skewed
        found._held, found._stressed = blades.held, blades.stressed
        found._least_nu = blades.least_nu
        found._planes = blades.planes
        return found

    @property
    def sheet(self) -> "Crystal | Orthotropic | None":
        """Return the crystal or sheet that makes its stiffness depend on the direction, if any."""
        return self.crystal if self.crystal is not None else self.orthotropic

    def laid(self, layout: "SpaceLayout", turned: float) -> "SpaceLayout":
        """Return a layout, its blades with the constants of their directions where these matter.

        ``turned`` is the angle by which it is turned from the axes of its drawing [rad].
        """
        if self.sheet is None:
            return layout
        from flexcli.parts.anisotropic import laid

        return laid(layout, self.sheet, self.orientation, turned, self._stiffer)

    def laid_in_plane(self, layout: "Layout", turned: float) -> "Layout":
        """Return a layout of a plane, its blades as stiff as their directions where they differ.

        ``turned`` is as in :meth:`laid`. At a temperature they are as :meth:`at` has them.
        """
        if self.sheet is None or not self.is_uneven:
            return layout
        from flexcli.parts.anisotropic import laid_in_plane

        return laid_in_plane(layout, self.sheet, self.orientation, turned, self.E / self._stiffer)

    def stiffness_in(self, turned: float) -> "NDArray[np.float64] | None":
        """Return the stiffness (6, 6) in a layout so turned [Pa]; nothing where it is isotropic."""
        if self.sheet is None:
            return None
        from flexcli.parts.anisotropic import stiffness_in

        return self._stiffer * stiffness_in(self.sheet, self.orientation, turned)

    def off_as_thick(
        self, kind: QuantityKind | None, layout: "Layout", travel: Number, *, turns: bool
    ) -> Number:
        """Return what thick blades of a directed material in a plane are off besides, relative.

        They shear by a modulus of their own, and one that is pulled at an angle to its axes shears.
        So a force across it stretches it too: beside its shift at a ``travel`` [rad or m], that is
        of first order.
        """
        if self.sheet is None:
            return 0.0
        from flexcli.parts.anisotropic import thickness_of

        slender, longest = thickness_of(layout)
        by_square, by_first = self._thick
        off: Number = (BUCKLED if kind is QuantityKind.BUCKLING else 1.0) * by_square * slender**2
        off += by_first * slender
        if kind is QuantityKind.SHIFT and travel:
            off += STRETCHED * self._skewed * slender**2 / (travel if turns else travel / longest)
        return off

    def doubted(
        self,
        error: ErrorRange,
        kind: QuantityKind | None,
        *,
        in_space: bool = False,
        is_directed: bool = False,
        laid: Number | None = None,
        thick: Number = 0.0,
        bent: ErrorRange | None = None,
    ) -> ErrorRange | None:
        """Return an error of a number of a kind, widened by the uncertainty of the moduli.

        Where each blade has its own modulus in the model, those that differ leave no more unsure
        than ``laid``, what their plates make of it. A crystal's shear modulus is not that of its
        Young's modulus and Poisson's ratio, which matters for torsion and shear, for all numbers
        ``in_space``; where ``is_directed``, number and error include the direction. Blades that
        differ by their directions change a shift by an unknown amount.
        Those that would twist as they bend, which their clamps may keep them from, are from as soft
        as their moduli say to as stiff as if they were held. ``thick`` is what
        :meth:`off_as_thick` tells, ``bent`` what plates of its planes tell instead, if they do.
        """
        if self.is_uneven and kind is QuantityKind.SHIFT:
            return None
        by_plates = self._rough + (0.0 if laid is None else laid - self._uneven)
        off = thick + self._spread - self._rough + (0.0 if is_directed else by_plates)
        if kind is QuantityKind.SHIFT and not in_space:  # which has each blade's own modulus
            off -= self._differ
        if not is_directed and (in_space or kind in OUT_OF_PLANE):
            off += self._sheared
        own = ErrorRange(-off, off) + self._twisting(kind)
        if bent is not None:  # by plates, and no further than by bounds
            off -= by_plates
            ends = larger(own.low, bent.low - off), smaller(own.high, bent.high + off)
            # of a plate that is isotropic both are as exact as fits are, and may miss each other
            own = ErrorRange(smaller(*ends), larger(*ends))
        found = error + own + self._drifted(kind)
        return found._replace(low=larger(found.low, -1.0)) if self._held else found

    def _twisting(self, kind: QuantityKind | None) -> ErrorRange:
        """Return the error of a number by blades that may be kept from twisting as they bend."""
        match kind:
            case QuantityKind.STIFFNESS | QuantityKind.BUCKLING:
                return ErrorRange(0.0, self._held)
            case QuantityKind.FREQUENCY:
                return ErrorRange(0.0, sqrt(1.0 + self._held) - 1.0)
            case QuantityKind.STRESS:
                return ErrorRange(0.0, self._stressed)
            case _:  # motions are less, or their parts more
                return ErrorRange(-self._held / (1.0 + self._held), self._held)

    def _drifted(self, kind: QuantityKind | None) -> ErrorRange:
        """Return the error of a number by a Young's modulus that is not given at a temperature."""
        if kind is QuantityKind.SHIFT:  # it follows from lengths, not from how stiff all is
            return EXACT
        least, most = max(0.0, 1.0 - self._drift), 1.0 + self._drift
        if kind is QuantityKind.FREQUENCY:
            least, most = sqrt(least), sqrt(most)
        return ErrorRange(least - 1.0, most - 1.0)

    def weakened(self, error: ErrorRange, strengths: Collection[str]) -> ErrorRange | None:
        """Return an error of a stress, widened by the loss of strength by heat.

        None where that loss is unknown.
        """
        lost = max((self._weaker.get(name, 0.0) for name in strengths), default=0.0)
        if lost >= 1.0:
            return None
        return ErrorRange(error.low, (1.0 + error.high) / (1.0 - lost) - 1.0)

    @property
    def is_directed(self) -> bool:
        """Return whether its stiffness depends on the direction."""
        return self.sheet is not None

    @property
    def stiffest(self) -> float:
        """Return Young's modulus in the direction in which it is the largest [Pa]."""
        if self.sheet is None:
            return self.E
        from flexcli.formulas.anisotropy import stiffest

        return self._stiffer * stiffest(self.sheet.stiffness())

    @property
    def poisson_ratios(self) -> tuple[float, float]:
        """Return the least and the most of the ratios of its plates, by directions of blades."""
        least, most = sorted((abs(self._least_nu), abs(self.elastic.most_nu)))
        return (least, most) if self.is_uneven else (most, most)

    @property
    def is_uneven(self) -> bool:
        """Return whether blades differ in stiffness from each other, by what ``spread`` says."""
        return self._uneven > 0.0

    @property
    def planes(self) -> "tuple[NDArray[np.float64], ...]":
        """Return compliances (3, 3) of blades in the plane of their faces, see ``Blades``."""
        return self._planes

    @property
    def bounds(self) -> ErrorRange:
        """Return what a stiffness is off at most by the anisotropy of plates and sheets."""
        return ErrorRange(-self._rough, self._rough + self._held)

    @property
    def expands(self) -> bool:
        """Return whether its thermal expansion is given."""
        known = self.over_temperature
        return self.thermal_expansion is not None or (
            known is not None and known.elongation is not None
        )

    def growth(self, change: float, assembly: float) -> float:
        """Return the change of length by a change of temperature, over the length at assembly [-].

        By its elongation over temperature where it is given, else and beyond its hottest point by
        the one coefficient.
        """
        known = self.over_temperature
        one = None if self.thermal_expansion is None else self.thermal_expansion.value
        found = None if known is None else known.growth(assembly + change, assembly, one)
        if found is not None:
            return found
        assert one is not None  # a spec without is refused
        return one * change

    def stiffer(self, change: float, assembly: float) -> float:
        """Return Young's modulus at a change of temperature over the material's own [-]."""
        known = self.over_temperature
        ratio = 1.0 if known is None else known.ratio("youngs_modulus", assembly + change, assembly)
        return ratio / self._stiffer

    def drift(self, one: float, other: float, assembly: float) -> float:
        """Return what Young's modulus may differ between two changes beyond its points [-]."""
        known = self.over_temperature
        if known is not None and known.youngs_modulus is not None:
            top = known.youngs_modulus.range[1] - assembly
            one, other = max(one, top), max(other, top)
        return MODULUS_DRIFT * abs(one - other)

    def at(self, assembly: float, coldest: float, hottest: float, clamps: float) -> "Material":
        """Return the material between two temperatures [K], its values being those at assembly.

        Young's modulus is that of the middle, each strength the least, at the hottest of the bodies
        that clamp it too (``clamps``). What is not given over temperature stays as it is; its
        possible change counts in the errors.
        """
        # copies of a part share what it keeps: each finds its own, which stays as long as it does
        key = (id(self), assembly, coldest, hottest, clamps)
        if key not in self._warmed:
            self._warmed[key] = self, self._between(*key[1:])
        return self._warmed[key][1]

    def _between(
        self, assembly: float, coldest: float, hottest: float, clamps: float
    ) -> "Material":
        known, ends = self.over_temperature, (coldest, hottest)
        warmest = max(hottest, clamps)

        def ratios(name: str, *at: float) -> list[float]:
            return [1.0 if known is None else known.ratio(name, T, assembly) for T in at]

        low, high = sorted(ratios("youngs_modulus", *ends))
        changed = {"youngs_modulus": (low + high) / 2.0}
        changed |= {name: min(ratios(name, coldest, warmest)) for name in STRENGTHS}
        update: dict[str, Any] = {
            name: given.model_copy(update={"value": ratio * given.value})
            for name, ratio in changed.items()
            if (given := getattr(self, name)) is not None
        }
        if self.sn_amplitudes is not None:
            update["sn_amplitudes"] = self.sn_amplitudes.times(changed["fatigue_amplitude"])
        found = self.model_copy(update=update)
        grown = max(abs(self.growth(T - assembly, assembly)) for T in ends) if self.expands else 0.0
        differ = (high - low) / (high + low)
        found._spread = self._spread + differ + SECTIONS * grown
        found._stiffer, found._differ = (low + high) / 2.0, differ
        tabled: Collection[str] = () if known is None else known.given
        heat = max(0.0, warmest - assembly)
        lost = STRENGTH_LOSS * heat if heat <= WARM else 1.0
        found._weaker = {
            name: lost for name in (*STRENGTHS, "admissible_stress") if name not in tabled
        }
        beyond = hottest - assembly, assembly - coldest
        if known is not None and known.youngs_modulus is not None:
            beyond = hottest - max(known.youngs_modulus.range[1], assembly), 0.0
        found._drift = MODULUS_DRIFT * max(0.0, *beyond)
        return found

    @property
    def spread(self) -> float:
        """Return the relative error of a stiffness by its moduli [-].

        Blades of different temperatures or directions differ in them, sections grow with heat, and
        plates of a crystal are not quite isotropic.
        """
        return self._spread

    def strength(self, field: str) -> float:
        """Return a static strength [Pa] by its field name, or raise :class:`MissingProperty`."""
        given = getattr(self, field)
        if given is None:
            raise MissingProperty(field, "this requirement compares with it")
        return number(given.value)

    def reversed_amplitude(self, cycles: float, mean_stress: str = "goodman") -> tuple[float, str]:
        """Return the fully reversed stress amplitude [Pa] borne for a life, and its source.

        From the S-N curve where it holds the life; else the fatigue amplitude, for any life up to
        its own (safe, and said so). A life beyond the data raises :class:`MissingProperty`. A
        strength at another stress ratio is converted to R = −1 by Goodman's line, but to no more
        than by ``mean_stress``, the method by which a mean counts: under the stresses of its tests
        it is what they found. A source that names no stress ratio is read as fully reversed.
        """
        curve, single = self.sn_amplitudes, self.fatigue_amplitude
        if curve is not None and curve.curve()[0][0] <= cycles <= curve.curve()[-1][0]:
            amplitude = amplitude_at_life(curve.curve(), cycles)
            strength = self._reversed(amplitude, curve.stress_ratio, mean_stress)
            return strength, f"S-N curve at {cycles:g} cycles"
        if single is None:
            field = "fatigue_amplitude" if curve is None else "sn_amplitudes"
            why = "fatigue compares with it" if curve is None else f"none for {cycles:g} cycles"
            raise MissingProperty(field, why)
        if single.cycles is None:
            where = "fatigue amplitude (its source states no life)"
            return self._reversed(single.value, single.stress_ratio, mean_stress), where
        if cycles > single.cycles:
            raise MissingProperty(
                "sn_amplitudes",
                f"the fatigue amplitude holds to {single.cycles:g} cycles, {cycles:g} are asked",
            )
        where = f"fatigue amplitude at {single.cycles:g} cycles"
        if cycles < single.cycles:
            where += f", kept for {cycles:g} (no S-N curve there)"
        return self._reversed(single.value, single.stress_ratio, mean_stress), where

    def reversed_curve(self) -> tuple[tuple[float, float], ...]:
        """Return the corners (cycles, amplitude [Pa]) of the S-N curve at R = −1."""
        curve = self.sn_amplitudes
        if curve is None:
            raise MissingProperty("sn_amplitudes", "a life follows from it")
        return tuple((n, self._reversed(s, curve.stress_ratio)) for n, s in curve.curve())

    def _reversed(
        self, amplitude: float, stress_ratio: float | None, mean_stress: str = "goodman"
    ) -> float:
        if stress_ratio is None or stress_ratio == -1.0 or mean_stress == "none":
            return amplitude
        tensile = self.strength("tensile_strength")
        found = fully_reversed_amplitude(amplitude, stress_ratio, tensile)
        if mean_stress == "swt":
            return min(found, swt_reversed_amplitude(amplitude, stress_ratio))
        return found

    def properties(self) -> tuple[Property, ...]:
        """Return every number that the material has, in SI, with where it comes from."""
        rows = []
        for name in type(self).model_fields:
            given = getattr(self, name)
            if given is not None and name == "sn_amplitudes":
                ratio = f", R = {given.stress_ratio:g}" if given.stress_ratio is not None else ""
                rows += [
                    Property(name, s, "Pa", f"{n:g} cycles{ratio}", given.status, given.source)
                    for n, s in given.curve()
                ]
            elif given is not None and name == "fatigue_amplitude":
                detail = [f"{given.cycles:g} cycles"] if given.cycles is not None else []
                if given.stress_ratio is not None:
                    detail.append(f"R = {given.stress_ratio:g}")
                rows.append(
                    Property(name, given.value, "Pa", ", ".join(detail), given.status, given.source)
                )
            elif isinstance(given, Sourced):
                unit = _UNITS.get(name, "Pa")
                rows.append(Property(name, given.value, unit, "", given.status, given.source))
        return tuple(rows)

    def placeholders(self) -> tuple[str, ...]:
        """Return the fields whose numbers are only placeholders."""
        return tuple(
            name
            for name in type(self).model_fields
            if getattr(getattr(self, name), "status", None) == "placeholder"
        )
