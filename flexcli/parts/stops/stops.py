"""End stops along a blade, as a spec writes them: where, how far away, and what they must keep."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from flexcli.formulas.stop_line import allowed_travel
from flexcli.parts.base import Part, PositiveLength, QuantityOf, spec_error
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.material import Material, MissingProperty
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.mechanisms.free_value import Free, OrFree
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.stops.contact import AnyContact, Ball, Cylinder, Rigid
from flexcli.parts.stops.strength import Strength

__all__ = ["Stops"]

Place = Annotated[float | Free, OrFree("length", above=0.0)]


class Simulation(Part):
    """How ``flexure stops --simulate`` verifies the stops."""

    modes: Annotated[int, Field(strict=True, ge=1, le=20)] = 1
    """Number of modes of the blade that take part, e.g. ``3``."""
    confidence: Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)] = 0.8
    """Confidence that one more exposure shows no higher peak, under random vibration,
    e.g. ``90 %``.
    """
    seed: Annotated[int, Field(strict=True, ge=0)] = 0
    """Seed of the random vibration, e.g. ``1``."""


class Stops(Part):
    """The section ``stops``; height and gap are given, or free for the tool to choose."""

    height: Place = Free()
    """Height of the stops above the clamped end of the blade, given or free, e.g. ``10 mm``."""
    gap: Place = Free()
    """Gap between the blade at rest and a stop, given or free, e.g. ``0.2 mm``."""
    sides: Literal["both", "one"] = "both"
    """Sides on which stops stand, e.g. ``one``."""
    smallest_gap: PositiveLength | None = Field(None, alias="smallest-gap")
    """Smallest gap that manufacturing and assembly allow, e.g. ``0.1 mm``."""
    travel: PositiveLength | None = None
    """Travel of the tip to each side; left out, what the free blade's base bears, e.g. ``2 mm``."""
    contact: AnyContact = Rigid.model_construct(kind="rigid")
    """What a stop is where the blade touches it,
    e.g. ``{kind: ball, radius: 5 mm, material: 17-4ph-h900}``.
    """
    bending: Strength | None = None
    """Factor on the blade's bending stress, e.g. ``1.5``."""
    shear: Strength | None = None
    """Factor on the shear below a contact, against half the strength (Tresca),
    e.g. ``shear: 1.5, bending: 1.5, contact: {kind: ball, radius: 5 mm, material: 17-4ph-h900}``.
    """
    simulation: Simulation = Simulation.model_construct()
    """How 'flexure stops --simulate' verifies the stops, e.g. ``{modes: 3, confidence: 90 %}``."""

    @model_validator(mode="after")
    def _is_one_task(self) -> "Stops":
        if self.travel is None and self.bending is None:
            raise spec_error(
                "nothing says how far the tip may go", "give travel, or bending: a factor"
            )
        if self.shear is not None and not self.contact.has_stress:
            raise spec_error(
                f"a {self.contact.kind} contact has no stress",
                "give the contact its shape: kind: ball or cylinder",
                at=("shear",),
            )
        smallest = self.smallest_gap
        if smallest is not None and isinstance(self.gap, float) and self.gap < smallest:
            raise spec_error("the gap is below smallest-gap", "change one of them", at=("gap",))
        impacts = isinstance(self.contact, Rigid) and self.contact.restitution is not None
        if impacts and self.simulation.modes < 2:
            raise spec_error(
                "a rigid stop with a restitution needs two modes or more: in one, the tip stops "
                "with the blade",
                "give simulation: (modes: 2), or leave the restitution out",
                at=("contact", "restitution"),
            )
        return self

    def allowed(self, material: Material, sizes: Sizes) -> float:
        """Return the deflection of the tip allowed to each side [m]."""
        if self.travel is not None:
            return self.travel
        assert self.bending is not None  # one of them is given
        sigma = self.bending.of(material) / self.bending.factor
        return float(allowed_travel(E=material.E, h=sizes.h, L=sizes.l, sigma=sigma))

    def refuse_misfit(
        self, material: Material, geometry: Geometry, mechanism: Mechanism | None
    ) -> None:
        """Raise a finding where the design has no ground for these stops."""
        if not isinstance(mechanism, TipMass):
            raise spec_error(
                "stops hold a cantilever with a mass on its end",
                "give mechanism: (kind: tip-mass, mass: …)",
                at=("stops",),
            )
        if geometry.compliant_clamps(geometry.probe(), 0.5) is not None:
            raise spec_error(
                "blades at stops end in rigid clamps, without fillets",
                "write clamps: rigid, and leave root_radius out",
                at=("geometry",),
            )
        for key, strength in (("bending", self.bending), ("shear", self.shear)):
            try:
                if strength is not None:
                    strength.of(material)
            except MissingProperty as missing:
                raise spec_error(
                    str(missing),
                    f"give material.{missing.field}, or name another allowable",
                    at=("stops", key),
                ) from missing
        if isinstance(self.contact, Ball | Cylinder):
            bodies = ((("material",), material), (("stops", "contact"), self.contact.material))
            for at, body in bodies:
                if body.elastic.nu is None:
                    raise spec_error(
                        "a contact's stress needs Poisson's ratio", "add poisson_ratio", at=at
                    )
        length = geometry.extents["l"].fixed
        height = self.height
        if length is not None and isinstance(height, float) and height >= length:
            raise spec_error(
                "the stop does not stand along the blade",
                f"write less than {length * 1e3:g} mm",
                at=("stops", "height"),
            )
