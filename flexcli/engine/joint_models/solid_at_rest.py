"""What solids at rest do not tell: they do not buckle, warm up or stand at a stroke."""

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.parts.requirements.warm_shift import WarmShift
from flexcli.results import ErrorRange

__all__ = ["SolidAtRest"]


class SolidAtRest(ExactModel):
    """Exact beams, of which small motion from rest is a solid's."""

    name = "solid"
    directs_in_plane = False

    def warm_shift(self, ask: Ask) -> WarmShift:
        """Refuse: solids are cold."""
        raise NotAvailable("has no shift at a temperature by solids: take --model exact")

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Refuse: solids at rest do not buckle."""
        raise NotAvailable("has no buckling load by solids: take --model exact")

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Refuse: solids at rest do not buckle."""
        raise NotAvailable("has no buckling load by solids: take --model exact")

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Refuse: solids are at rest."""
        raise NotAvailable("has no support stiffness at stroke by solids: take --model exact")
