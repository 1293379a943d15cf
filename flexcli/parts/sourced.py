"""Numbers with their source: a document and its page, and the kind of document."""

from typing import ClassVar, Generic, Literal, TypeVar

from pydantic import model_validator

from flexcli.parts.base import Part, Shorthand, spec_error

__all__ = ["Sourced", "Status", "WithSource"]

Status = Literal["measured", "handbook", "vendor", "course", "placeholder", "given"]
"""Where a number comes from; ``given`` is a plain number in the user's own spec."""

Number = TypeVar("Number")


class WithSource(Part):
    """Anything that a document says, with what kind of document that is."""

    status: Status = "given"
    """Where the number comes from; given is a plain number of your own,
    e.g. ``status: handbook, source: MMPDS-2023 table 5.4.1``.
    """
    source: str = ""
    """Document and page that the number is from, e.g. ``MMPDS-2023 table 5.4.1``."""

    @model_validator(mode="after")
    def _name_the_source(self) -> "WithSource":
        if self.status not in ("given", "placeholder") and not self.source:
            raise spec_error(
                f"a value of status '{self.status}' must name its source",
                "add 'source:' with document and page, or leave the status out",
            )
        return self


class Sourced(WithSource, Shorthand, Generic[Number]):
    """A number with its source and status; a plain quantity stands for a given value."""

    stands_for: ClassVar[str] = "value"

    value: Number
    """The number with its unit."""
