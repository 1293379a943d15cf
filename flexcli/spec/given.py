"""The sizes that a design gives, or what it leaves open."""

from flexcli.errors import SpecError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.spec.document import Document, finding_at

__all__ = ["given_sizes"]


def given_sizes(design: DesignSpec, document: Document) -> Sizes:
    """Return the fixed sizes of a design, or raise :class:`SpecError` for what is free."""
    sizes = design.fixed_sizes()
    if sizes is not None:
        return sizes
    findings = []
    for name in design.geometry.free:
        path = ("geometry", *design.geometry.place(name))
        place, _ = document.position.closest(path)
        findings.append(
            finding_at(
                place,
                document.lines,
                ".".join(path),
                f"{name} is free, and there is no design to judge",
                "give its size, or let 'flexure size' choose it (--write saves the result)",
            )
        )
    raise SpecError(findings)
