"""The exact model of a joint of the plane, its support and deflections at stroke by shells."""

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.space_deflection import deflections
from flexcli.engine.joint_models.space_shell import SHELLS, SpaceShellModel
from flexcli.engine.joint_models.space_stroke import support_at_stroke
from flexcli.parts.requirements import Ask
from flexcli.results import ErrorRange

__all__ = ["ExactWithShells"]


class ExactWithShells(ExactModel):
    """Exact beams in the plane, thin shells where a joint is solved in space."""

    name = "shell"
    at_stroke = SpaceShellModel.at_stroke
    directs_blades = SpaceShellModel.directs_blades

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, by the joint in space."""
        return support_at_stroke(ask, index, point, locked=locked, blades=SHELLS)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return how far the wrench moves a point, the tangents at the stroke being shells'."""
        return deflections(ask, point, direction, SHELLS)
