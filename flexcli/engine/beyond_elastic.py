"""Where a design leaves what elasticity is about: notes, whatever the requirements ask."""

from collections.abc import Iterable, Iterator

from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import JointModel, RequirementError
from flexcli.results import Check, Note
from flexcli.units import show

__all__ = ["beyond_elastic"]

MOST_STRAIN = 0.02
"""Strain beyond which a metal is no longer taken for elastic, where its strength is not given."""

BUCKLING = ("buckling", "dynamic buckling")
"""Names of checks that say when blades buckle."""


def beyond_elastic(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel, checks: Iterable[Check]
) -> Iterator[Note]:
    """Yield a note for each case whose stress passes R_m or a strain of 2 %, and for buckling.

    The stress is the largest that a check or the model of the values tells, nominal, in any
    direction. Buckling that lacks a yield strength is elastic, whatever the blades bear.
    """
    found, material = tuple(checks), design.material
    tensile = material.tensile_strength
    strained = MOST_STRAIN * material.elastic.E
    for case in design.cases:
        stress = max(
            _told(design, sizes, joint_model, case),
            max((c.demand for c in found if c.case == case and c.unit == "Pa"), default=0.0),
        )
        if tensile is not None and stress > tensile.value:
            limit = f"the tensile strength, {show(tensile.value, 'Pa')}"
        elif stress > strained:
            limit = f"a strain of {MOST_STRAIN:.0%}"
        else:
            continue
        text = f"case '{case}': a stress of {show(stress, 'Pa')} passes {limit}"
        yield Note("beyond-elastic", f"{text}; every number of the case is elastic")
    if material.yield_strength is None and any(c.name.startswith(BUCKLING) for c in found):
        text = (
            "material.yield_strength is not given: the buckling factor is elastic, and blades "
            "that yield first bear less"
        )
        yield Note("buckling-without-yield-strength", text)


def _told(design: DesignSpec, sizes: Sizes, joint_model: JointModel, case: str) -> float:
    """Return the largest stress of a case by formulas, nothing where only solving tells it."""
    if not design.geometry.closed_forms or joint_model.name not in ("source", "closed-form"):
        return 0.0
    ask = design.ask(design.scene(case), sizes, joint_model)
    if not (ask.scene.moves or ask.scene.is_loaded):
        return 0.0
    try:
        _, stresses = joint_model.stresses(ask)
    except (NotAvailable, RequirementError, SolveError):
        return 0.0
    return max((abs(float(s.largest)) for s in stresses), default=0.0)
