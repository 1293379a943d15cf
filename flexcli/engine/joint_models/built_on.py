"""A model that is built on another: what it does not tell itself is the other's."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from flexcli.parts.requirements import Ask, CriticalShare, JointModel, MisfitStress, Told
from flexcli.results import ErrorRange

if TYPE_CHECKING:
    from flexcli.mechanics.space.layout import SpaceLayout
    from flexcli.mechanics.space.springs import MemberSprings
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["BuiltOn"]


class BuiltOn(JointModel):
    """A model with the numbers of an inner one that need no correction."""

    inner: JointModel

    def springs(self, ask: Ask, *, in_plane: bool) -> "tuple[MemberSprings, ...] | None":
        """Return those of the inner model."""
        return self.inner.springs(ask, in_plane=in_plane)

    def own_joint(self, ask: Ask) -> "tuple[SpaceLayout, tuple[MemberSprings, ...]] | None":
        """Return that of the inner model."""
        return self.inner.own_joint(ask)

    def axial_stress(self, ask: Ask) -> float | None:
        """Return that of the inner model."""
        return self.inner.axial_stress(ask)

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return that of the inner model: it is in its errors what it leaves out."""
        return self.inner.envelope(ask)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return those of the inner model."""
        return self.inner.support_at_stroke(ask, index, point, locked=locked)

    def warm_support_ratio(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> Told:
        """Return that of the inner model."""
        return self.inner.warm_support_ratio(ask, index, point, locked=locked)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return those of the inner model."""
        return self.inner.deflections(ask, point, direction)

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield those of the inner model."""
        return self.inner.misfit_stresses(ask, small)

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return those of the inner model; their errors have what it does not carry."""
        return self.inner.critical_shares(ask)
