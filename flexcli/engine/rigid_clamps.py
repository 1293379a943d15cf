"""Which passes turn on clamps that are rigid, where nothing says how the blades end."""

from collections.abc import Iterator

from flexcli.engine.judge import again
from flexcli.engine.models import NamedModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.results import Check, Note, Verdict

__all__ = ["rests_on_rigid_clamps"]


def rests_on_rigid_clamps(
    design: DesignSpec,
    sizes: Sizes,
    near: list[Check],
    geometry: Geometry,
    models: tuple[NamedModel, ...],
) -> Iterator[Note]:
    """Yield a warning of those of some checks that would, or might, not pass with another geometry.

    It is that of the design with clamps that give way. Each check is asked of the model that
    decided it, which knows what its blades do; what that model leaves open might not pass.
    """
    other = design.model_copy(update={"geometry": geometry})
    names = {(check.full_name, check.model) for check in near}
    found = [c for c in again(other, sizes, models, near) if (c.full_name, c.model) in names]
    kinds = ((Verdict.FAIL, "would"), (Verdict.UNDECIDED, "might"))
    told = [
        f"these {verb} not pass: {', '.join(map(_told, turned))}"
        for verdict, verb in kinds
        if (turned := [check for check in found if check.verdict is verdict])
    ]
    if told:
        text = (
            "the clamps are taken as rigid; were the blades cut from one piece with their bodies, "
            f"{'; '.join(told)}. Say geometry.clamps: rigid or monolithic"
        )
        yield Note("rigid-clamps", text)


def _told(check: Check) -> str:
    return f"{check.full_name}, a factor of {check.factor:.4g} where {check.required:.4g} is asked"
