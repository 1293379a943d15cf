"""Which passes turn on clamps that are rigid, where nothing says how the blades end."""

from collections.abc import Iterator

from flexcli.engine.judge import again
from flexcli.engine.models import NamedModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.results import Check, Note

__all__ = ["rests_on_rigid_clamps"]


def rests_on_rigid_clamps(
    design: DesignSpec,
    sizes: Sizes,
    near: list[Check],
    geometry: Geometry,
    models: tuple[NamedModel, ...],
) -> Iterator[Note]:
    """Yield a warning of those of some checks that would not pass with another geometry.

    It is that of the design with clamps that give way. The models are those that judged, which
    know what its blades do.
    """
    other = design.model_copy(update={"geometry": geometry})
    names = {check.full_name for check in near}
    turned = [
        check
        for check in again(other, sizes, models, near)
        if check.full_name in names and not check.passed
    ]
    if turned:
        each = ", ".join(
            f"{check.full_name}, a factor of {check.factor:.4g} where {check.required:.4g} is asked"
            for check in turned
        )
        text = (
            "the clamps are taken as rigid; were the blades cut from one piece with their bodies, "
            f"these would not pass: {each}. Say geometry.clamps: rigid or monolithic"
        )
        yield Note("rigid-clamps", text)
