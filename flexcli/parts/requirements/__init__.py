"""Requirements that a spec can ask; a new one is a file here and a field below."""

from collections.abc import Iterator
from typing import Annotated, Any, TypeAlias, TypeVar, get_args

from pydantic import BeforeValidator, Field

from flexcli.parts.base import OneOrMore, Part
from flexcli.parts.named import Named
from flexcli.parts.requirements.as_printed import AS_PRINTED
from flexcli.parts.requirements.ask import (
    MOST_SHARE,
    Ask,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
    RequirementError,
    Swing,
)
from flexcli.parts.requirements.base import Bound, Limit, Requirement, limit_of
from flexcli.parts.requirements.closed_form import CLOSED_FORM

__all__ = [
    "AS_PRINTED",
    "CLOSED_FORM",
    "MOST_SHARE",
    "Ask",
    "Bound",
    "CriticalShare",
    "DriveEffort",
    "EndStress",
    "JointModel",
    "Limit",
    "Requirement",
    "RequirementError",
    "Requirements",
    "Swing",
    "are_at_rest",
    "limit_of",
]

_HERE = "flexcli.parts.requirements"

Kind = TypeVar("Kind", bound=Requirement)


def _as_list(data: Any) -> Any:
    return data if isinstance(data, list) else [data]


Several = Annotated[tuple[Kind, ...], BeforeValidator(_as_list), Field(min_length=1), OneOrMore()]
"""One requirement of a kind, or a list of them (e.g. one per case)."""


def _as_boxes(data: Any) -> Any:
    is_box = not isinstance(data, list) or not any(isinstance(one, list | dict) for one in data)
    return [data] if is_box else data


SeveralBoxes = Annotated[
    tuple[Kind, ...], BeforeValidator(_as_boxes), Field(min_length=1), OneOrMore()
]
"""The same of a requirement that is a list itself."""

Fatigue: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.fatigue:Fatigue")]
Buckling: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.buckling:Buckling")]
Yield: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.yielding:Yield")]
DynamicYield: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.dynamic:DynamicYield")]
DynamicBuckling: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.dynamic:DynamicBuckling")]
DynamicLife: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.dynamic:DynamicLife")]
Stiffness: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.stiffness:Stiffness")]
Drive: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.drive:Drive")]
Frequency: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.frequency:Frequency")]
Sag: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.sag:Sag")]
Mass: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.mass:Mass")]
ParasiticShift: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.parasitic_shift:ParasiticShift")]
Support: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.support:Support")]
Deflection: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.support:Deflection")]
ParasiticMotion: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.parasitic:ParasiticMotion")]
ParasiticFrequency: TypeAlias = Annotated[
    Requirement, Named(f"{_HERE}.parasitic:ParasiticFrequency")
]
MisalignmentStress: TypeAlias = Annotated[
    Requirement, Named(f"{_HERE}.misalignment:MisalignmentStress")
]
Envelope: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.envelope:Envelope")]
Slenderness: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.shape:Slenderness")]
WidthRatio: TypeAlias = Annotated[Requirement, Named(f"{_HERE}.shape:WidthRatio")]


class Requirements(Part):
    """What is asked of the design; none is implied."""

    fatigue: Several[Fatigue] | None = None
    """Factor on the stress amplitude of the stroke against what the material bears for its cycles,
    e.g. ``2.5``.
    """
    buckling: Several[Buckling] | None = None
    """Factor on the load against the least that buckles the joint; the case says what holds the
    ends,
    e.g. ``2.5``.
    """
    yielding: Several[Yield] | None = Field(None, alias="yield")
    """Factor on the largest stress of a case against the yield strength, or other strengths,
    e.g. ``{factor: 1.5, allowable: [yield-strength, fatigue-amplitude]}``.
    """
    dynamic_yield: Several[DynamicYield] | None = Field(None, alias="dynamic-yield")
    """Factor on the peak stress of the modes under vibration or shock, e.g. ``1.5``."""
    dynamic_buckling: Several[DynamicBuckling] | None = Field(None, alias="dynamic-buckling")
    """Factor on the peak axial force of the modes under vibration or shock, e.g. ``2.5``."""
    dynamic_life: Several[DynamicLife] | None = Field(None, alias="dynamic-life")
    """Factor on the fatigue life under random vibration, e.g. ``4``."""
    stiffness: Several[Stiffness] | None = None
    """Bounds on the stiffness of a joint along its motion, at rest without the loads of cases,
    e.g. ``{max: 15 N*m/rad}``.
    """
    drive: Several[Drive] | None = None
    """Factor on the force at the ends of the stroke against what the actuator has left there,
    e.g. ``1.5``.
    """
    frequency: Several[Frequency] | None = None
    """Bounds on the frequency of the mechanism's own motion, at rest without the loads of cases:
    a weight that stands on its blades lowers it, e.g. ``{min: 20 Hz}``.
    """
    sag: Several[Sag] | None = None
    """Bounds on how far a steady acceleration moves the body, e.g. ``{max: 10 um}``."""
    mass: Several[Mass] | None = None
    """Bounds on the mass of what flexes, e.g. ``{max: 5 g}``."""
    parasitic_shift: Several[ParasiticShift] | None = None
    """Bound on the motion that comes with the stroke but was not asked for,
    e.g. ``{max: 5 um}``.
    """
    support: Several[Support] | None = None
    """Bounds on the stiffness in a direction that the joint should hold, or on a ratio of two,
    e.g. ``{direction: z, min: 1 N/um}``.
    """
    deflection: Several[Deflection] | None = None
    """Bound on how far a case's wrench moves a point, e.g. ``{direction: z, max: 5 um}``."""
    parasitic_motion: Several[ParasiticMotion] | None = None
    """Bound on what a mechanism in space moves or turns beside its stroke,
    e.g. ``{direction: z, max: 5 um}``.
    """
    parasitic_frequency: Several[ParasiticFrequency] | None = None
    """Bounds on the lowest frequency of a mechanism in space with its drive locked,
    e.g. ``{min: 150 Hz}``.
    """
    misalignment_stress: Several[MisalignmentStress] | None = None
    """Factor on the stress where the end of a blade misses its seat by so much,
    e.g. ``{of: outer-1, rotation: {about: x, by: 1 mrad}, factor: 3}``.
    """
    envelope: SeveralBoxes[Envelope] | None = None
    """Sides of a box along x, y and z in which blades and bodies stay, at rest and over the stroke,
    e.g. ``[80 mm, 40 mm, 30 mm]``.
    """
    slenderness: Several[Slenderness] | None = Field(None, alias="l/h")
    """Bounds on length over thickness of a blade, e.g. ``{min: 20}``."""
    width_ratio: Several[WidthRatio] | None = Field(None, alias="b/h")
    """Bounds on width over thickness of a blade, e.g. ``{min: 10}``."""

    def each(self) -> Iterator[tuple[tuple[str | int, ...], Requirement]]:
        """Yield every requirement with its path below ``requirements``."""
        for field, info in type(self).model_fields.items():
            for index, requirement in enumerate(getattr(self, field) or ()):
                yield (info.alias or field, index), requirement


_BY_KEY: dict[str, Named] = {
    # of Several[Kind] | None
    info.alias or field: get_args(get_args(get_args(info.annotation)[0])[0])[0].__metadata__[0]
    for field, info in Requirements.model_fields.items()
}


def are_at_rest(written: Any) -> bool:
    """Return whether requirements, as a spec has them, are all of the joint itself."""
    if not isinstance(written, dict) or not written:
        return False
    return all(key in _BY_KEY and not _BY_KEY[key].classes[0].per_case for key in written)
