"""Requirements that a spec can ask; a new one is a file here and a field below."""

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Annotated, Any, TypeAlias, get_args

from pydantic import (
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    TypeAdapter,
)
from pydantic_core import CoreSchema, core_schema

from flexcli.parts.base import Part
from flexcli.parts.named import Named
from flexcli.parts.requirements.as_printed import AS_PRINTED
from flexcli.parts.requirements.ask import (
    MOST_SHARE,
    Ask,
    Bent,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
    MisfitStress,
    RequirementError,
    Swing,
    Told,
    WideFactor,
)
from flexcli.parts.requirements.base import Bound, ErrorOf, Limit, Requirement, limit_of
from flexcli.parts.requirements.closed_form import CLOSED_FORM

__all__ = [
    "AS_PRINTED",
    "CLOSED_FORM",
    "MOST_SHARE",
    "Ask",
    "Bent",
    "Bound",
    "CriticalShare",
    "DriveEffort",
    "EndStress",
    "ErrorOf",
    "JointModel",
    "Limit",
    "MisfitStress",
    "Requirement",
    "RequirementError",
    "Requirements",
    "Several",
    "Swing",
    "Told",
    "WideFactor",
    "are_at_rest",
    "limit_of",
]


def _as_list(data: Any) -> Any:
    return data if isinstance(data, list) else [data]


def _as_boxes(data: Any) -> Any:
    is_box = not isinstance(data, list) or not any(isinstance(one, list | dict) for one in data)
    return [data] if is_box else data


class Several(Named):
    """A type marker: one requirement of a class, or a list of them (e.g. one per case).

    A start builds nothing for those that the spec does not ask. ``listed`` says what is a list of
    them, and what is one alone.
    """

    def __init__(self, name: str, listed: Callable[[Any], Any] = _as_list) -> None:
        super().__init__(f"flexcli.parts.requirements.{name}")
        self.listed = listed

    @cached_property
    def _adapter(self) -> TypeAdapter[Any]:
        one = Annotated[Any, Named(self.path)]
        return TypeAdapter(
            Annotated[tuple[one, ...], BeforeValidator(self.listed), Field(min_length=1)]
        )

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self._read)

    def _read(self, data: Any) -> Any:
        return self._adapter.validate_python(data)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        one = super().__get_pydantic_json_schema__(schema, handler)
        return {"anyOf": [one, {"minItems": 1, "type": "array", "items": one}]}


_Tuple: TypeAlias = tuple[Requirement, ...]

Fatigue: TypeAlias = Annotated[_Tuple, Several("fatigue:Fatigue")]
Buckling: TypeAlias = Annotated[_Tuple, Several("buckling:Buckling")]
Yield: TypeAlias = Annotated[_Tuple, Several("yielding:Yield")]
DynamicYield: TypeAlias = Annotated[_Tuple, Several("dynamic:DynamicYield")]
DynamicBuckling: TypeAlias = Annotated[_Tuple, Several("dynamic:DynamicBuckling")]
DynamicLife: TypeAlias = Annotated[_Tuple, Several("dynamic:DynamicLife")]
Stiffness: TypeAlias = Annotated[_Tuple, Several("stiffness:Stiffness")]
Drive: TypeAlias = Annotated[_Tuple, Several("drive:Drive")]
Frequency: TypeAlias = Annotated[_Tuple, Several("frequency:Frequency")]
Sag: TypeAlias = Annotated[_Tuple, Several("sag:Sag")]
Mass: TypeAlias = Annotated[_Tuple, Several("mass:Mass")]
ParasiticShift: TypeAlias = Annotated[_Tuple, Several("parasitic_shift:ParasiticShift")]
Support: TypeAlias = Annotated[_Tuple, Several("support:Support")]
Deflection: TypeAlias = Annotated[_Tuple, Several("support:Deflection")]
ParasiticMotion: TypeAlias = Annotated[_Tuple, Several("parasitic:ParasiticMotion")]
ParasiticFrequency: TypeAlias = Annotated[_Tuple, Several("parasitic:ParasiticFrequency")]
MisalignmentStress: TypeAlias = Annotated[_Tuple, Several("misalignment:MisalignmentStress")]
Envelope: TypeAlias = Annotated[_Tuple, Several("envelope:Envelope", _as_boxes)]
Slenderness: TypeAlias = Annotated[_Tuple, Several("shape:Slenderness")]
WidthRatio: TypeAlias = Annotated[_Tuple, Several("shape:WidthRatio")]


class Requirements(Part):
    """What is asked of the design; none is implied."""

    fatigue: Fatigue | None = None
    """Factor on the stress amplitude of the stroke against what the material bears for its cycles,
    e.g. ``2.5``.
    """
    buckling: Buckling | None = None
    """Factor on the load against the least that buckles the joint; the case says what holds the
    ends,
    e.g. ``2.5``.
    """
    yielding: Yield | None = Field(None, alias="yield")
    """Factor on the largest stress of a case against the yield strength, or other strengths,
    e.g. ``{factor: 1.5, allowable: [yield-strength, fatigue-amplitude]}``.
    """
    dynamic_yield: DynamicYield | None = Field(None, alias="dynamic-yield")
    """Factor on the peak stress of the modes under vibration or shock, e.g. ``1.5``."""
    dynamic_buckling: DynamicBuckling | None = Field(None, alias="dynamic-buckling")
    """Factor on the peak axial force of the modes under vibration or shock, e.g. ``2.5``."""
    dynamic_life: DynamicLife | None = Field(None, alias="dynamic-life")
    """Factor on the fatigue life under random vibration, e.g. ``4``."""
    stiffness: Stiffness | None = None
    """Bounds on the stiffness of a joint along its motion, at rest without the loads of cases,
    e.g. ``{max: 15 N*m/rad}``.
    """
    drive: Drive | None = None
    """Factor on the force at the ends of the stroke against what the actuator has left there,
    e.g. ``1.5``.
    """
    frequency: Frequency | None = None
    """Bounds on the frequency of the mechanism's own motion, at rest without the loads of cases:
    a weight that stands on its blades lowers it, e.g. ``{min: 20 Hz}``.
    """
    sag: Sag | None = None
    """Bounds on how far a steady acceleration moves the body, e.g. ``{max: 10 um}``."""
    mass: Mass | None = None
    """Bounds on the mass of what flexes, e.g. ``{max: 5 g}``."""
    parasitic_shift: ParasiticShift | None = None
    """Bound on the motion that comes with the stroke but was not asked for,
    e.g. ``{max: 5 um}``.
    """
    support: Support | None = None
    """Bounds on the stiffness in a direction that the joint should hold, or on a ratio of two,
    e.g. ``{direction: z, min: 1 N/um}``.
    """
    deflection: Deflection | None = None
    """Bound on how far a case's wrench moves a point, e.g. ``{direction: z, max: 5 um}``."""
    parasitic_motion: ParasiticMotion | None = None
    """Bound on what a mechanism in space moves or turns beside its stroke,
    e.g. ``{direction: z, max: 5 um}``.
    """
    parasitic_frequency: ParasiticFrequency | None = None
    """Bounds on the lowest frequency of a mechanism in space with its drive locked,
    e.g. ``{min: 150 Hz}``.
    """
    misalignment_stress: MisalignmentStress | None = None
    """Factor on the stress where the end of a blade misses its seat by so much,
    e.g. ``{of: outer-1, rotation: {about: x, by: 1 mrad}, factor: 3}``.
    """
    envelope: Envelope | None = None
    """Sides of a box along x, y and z in which blades and bodies stay, at rest and over the stroke,
    e.g. ``[80 mm, 40 mm, 30 mm]``.
    """
    slenderness: Slenderness | None = Field(None, alias="l/h")
    """Bounds on length over thickness of a blade, e.g. ``{min: 20}``."""
    width_ratio: WidthRatio | None = Field(None, alias="b/h")
    """Bounds on width over thickness of a blade, e.g. ``{min: 10}``."""

    def each(self) -> Iterator[tuple[tuple[str | int, ...], Requirement]]:
        """Yield every requirement with its path below ``requirements``."""
        for field, info in type(self).model_fields.items():
            for index, requirement in enumerate(getattr(self, field) or ()):
                yield (info.alias or field, index), requirement


_BY_KEY: dict[str, Named] = {
    # of Annotated[…, Several(…)] | None
    info.alias or field: get_args(info.annotation)[0].__metadata__[0]
    for field, info in Requirements.model_fields.items()
}


def are_at_rest(written: Any) -> bool:
    """Return whether requirements, as a spec has them, are all of the joint itself."""
    if not isinstance(written, dict) or not written:
        return False
    return all(key in _BY_KEY and not _BY_KEY[key].classes[0].per_case for key in written)
