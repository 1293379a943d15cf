"""What a model has solved of a design, so that its requirements ask for each state once."""

from collections.abc import Callable
from typing import Generic, TypeVar

from flexcli.numerics.rows import found_once
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask

__all__ = ["Remembered"]

Answer = TypeVar("Answer")

MOST = 32
"""Answers kept; a design has few cases, and each few states."""


class Remembered(Generic[Answer]):
    """Answers by what was asked and of which case, the latest of them; that there is none too.

    Those of a named model are kept for other passes over some of the same designs. What is said
    ``of_blades`` alone holds however they end.
    """

    def __init__(self, model: str = "", *, of_blades: bool = False) -> None:
        self.model = model
        self.of_blades = of_blades
        self._known: list[tuple[str, Ask, Answer | NotAvailable]] = []

    def of(self, what: str, ask: Ask, find: Callable[[], Answer]) -> Answer:
        """Return the answer to a question on a case, found once."""
        known = next((a for name, of, a in self._known if name == what and self._is(of, ask)), None)
        if known is None:
            try:
                named = f"{what} of {self.model}"
                known = found_once(named, ask.scene, find) if self.model else find()
            except NotAvailable as error:
                known = error
            self._known = [*self._known[1 - MOST :], (what, ask, known)]
        if isinstance(known, NotAvailable):
            raise known
        return known

    def _is(self, one: Ask, other: Ask) -> bool:
        """Return whether what is known of one question answers another."""
        same = one.geometry is other.geometry
        return (
            one.material is other.material
            and one.mechanism is other.mechanism
            and (same or (self.of_blades and one.geometry.has_blades_of(other.geometry)))
            and one.sizes == other.sizes
            and one.scene == other.scene
            and (one.near is None) == (other.near is None)
        )
