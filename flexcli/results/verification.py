"""Comparison of a design's numbers by its model with those by finite elements."""

from typing import NamedTuple

from flexcli.results.judgement import ErrorRange

__all__ = ["Verification", "VerifiedNumber"]


class VerifiedNumber(NamedTuple):
    """A number by a model with the range of its error, and by solid elements, SI.

    ``solid`` is that of the finest mesh and ``solid_error`` the mesh's own, relative: by how much
    the mesh before differs. What is not known is nothing. ``apart`` is the solid's number over the
    model's, less one; ``agrees`` says whether the two intervals overlap. ``deck`` is the name of
    the deck, ``read`` what of its results it is, ``why`` why there is no number. ``seconds`` are
    those of both, ``model_seconds`` the model's, ``deck_seconds`` those of the solid's decks, which
    may serve other numbers too. ``share`` is what the model has here of the greatest of its kind.
    """

    name: str
    label: str
    unit: str
    case: str
    model: float | None
    model_error: ErrorRange | None
    solid: float | None
    solid_error: float | None
    deck: str
    read: str
    seconds: float
    why: str = ""
    model_seconds: float = 0.0
    deck_seconds: float = 0.0
    share: float = 1.0

    @property
    def apart(self) -> float | None:
        """Return the relative difference."""
        if self.model is None or self.solid is None or self.model == 0.0:
            return None
        return self.solid / self.model - 1.0

    @property
    def agrees(self) -> bool | None:
        """Return whether the intervals overlap, nothing where one of them is not known."""
        if self.model_error is None or self.solid_error is None or self.apart is None:
            return None
        ratio = 1.0 + self.apart
        low, high = ratio * (1.0 - self.solid_error), ratio * (1.0 + self.solid_error)
        return low <= 1.0 + self.model_error.high and high >= 1.0 + self.model_error.low


class Verification(NamedTuple):
    """The numbers that were compared, by which model, on how many elements of each mesh."""

    model: str
    program: str
    meshes: tuple[int, ...]
    numbers: tuple[VerifiedNumber, ...]
    decks: tuple[str, ...] = ()
