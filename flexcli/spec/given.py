"""The blade that a design gives, or what it leaves open."""

from flexcli.errors import SpecError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Blade
from flexcli.spec.document import Document, finding_at

__all__ = ["given_blade"]


def given_blade(design: DesignSpec, document: Document) -> Blade:
    """Return the fixed blade of a design, or raise :class:`SpecError` for what is free."""
    blade = design.fixed_blade()
    if blade is not None:
        return blade
    findings = []
    for name in design.geometry.free:
        place, _ = document.position.closest(("geometry", name))
        findings.append(
            finding_at(
                place,
                document.lines,
                f"geometry.{name}",
                f"{name} is free, and there is no design to judge",
                "give its size, or let 'flexure size' choose it (--write saves the result)",
            )
        )
    raise SpecError(findings)
