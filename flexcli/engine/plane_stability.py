"""Checks of loads in the plane of a joint, held against what they do out of it.

Models of the plane keep its bodies there. Where a cheap bound does not show that nothing but blades
holds them as well, the joint is looked at in space.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from math import inf
from time import perf_counter

from flexcli.engine.models import NamedModel
from flexcli.errors import SolveError
from flexcli.numerics.rows import Number, one_alone
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, CriticalShare, Requirement
from flexcli.parts.requirements.base import FactorRequirement
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import Check, QuantityKind, Verdict

__all__ = ["PlaneStability"]

PUSHING = frozenset({LoadKind.LOAD, LoadKind.WRENCH, LoadKind.ACCELERATION, LoadKind.TEMPERATURE})
"""Loads that may buckle a joint out of its plane."""

CLEAR = 4.0
"""Factor on what is asked up to which a joint that surely bears it is looked at no further: what
loads move, and beams that tilt from the first on, changed it by less."""

SURE = 0.75
"""Of what straight blades bear, what those of joints that tilt from the first on bore at least."""

IN_SPACE = "share of the loads of the case that buckles the joint in space"

SOURCE = "loss of stability of blades and bodies in space, exact beams"


@dataclass(frozen=True, eq=False)
class PlaneStability:
    """What buckles a design out of its plane, found once for each case; ``seconds`` by model."""

    design: DesignSpec
    sizes: Sizes
    models: tuple[NamedModel, ...]
    seconds: dict[str, float]
    _bounds: dict[tuple[str, bool, bool], Number] = field(default_factory=dict)
    _shares: dict[tuple[str, bool, bool, float], CriticalShare | None] = field(default_factory=dict)

    def judged(
        self, requirement: Requirement, scene: Scene, checks: tuple[Check, ...]
    ) -> tuple[Check, ...]:
        """Return checks of a requirement, none of which passes where loads leave the plane.

        What it says of buckling is no more than is known of that.
        """
        failed = all(check.verdict is Verdict.FAIL for check in checks)
        ask = None if failed else self._asked(requirement, scene, checks)
        if ask is None:
            return checks
        asked, bound = _share_asked(requirement), self._bound(requirement, ask)
        if bound >= CLEAR * asked:
            return _no_more(checks, bound) if requirement.is_of_buckling else checks
        share = self._share(requirement, ask)
        if share is None:
            least = max(CLEAR * asked * SURE, bound)
            return _no_more(checks, least) if requirement.is_of_buckling else checks
        if share.least >= asked and not requirement.is_of_buckling:
            return checks
        return tuple(_buckles(check, share, asked, self._model) for check in checks)

    def as_check(
        self, requirement: Requirement, scene: Scene, checks: tuple[Check, ...]
    ) -> Check | None:
        """Return the share of loads that leave the plane as a check of its own, where it is near.

        A sizing sees it change with the sizes, where the checks that it fails jump.
        """
        ask = self._asked(requirement, scene, checks)
        if ask is None or self._bound(requirement, ask) >= CLEAR * _share_asked(requirement):
            return None
        share = self._share(requirement, ask)
        if share is None:
            return None
        name = f"out-of-plane buckling for {requirement.label}"
        none = Check(name, scene.case, "", 1.0, inf, "", inf, 0.0, Verdict.PASS, "")
        return _buckles(none, share, _share_asked(requirement), self._model)

    @property
    def _model(self) -> str:
        """Return the name of the model by which joints are looked at in space."""
        names = [model.name for model in self.models]
        return "exact" if "exact" in names else names[-1]

    def _asked(
        self, requirement: Requirement, scene: Scene, checks: tuple[Check, ...]
    ) -> Ask | None:
        """Return what is asked, nothing where no check looks at loads in the plane alone."""
        mechanism = self.design.mechanism
        loaded = scene.is_loaded and (mechanism is None or mechanism.joints == 1)
        pushed = requirement.looks_at(scene) & scene.loads & PUSHING
        stressed = QuantityKind.STRESS in {check.kind for check in checks}
        by_force = requirement.is_of_buckling and scene.temperature is None
        told = scene.in_space or (by_force and scene.leaves_plane)
        as_printed = self.models[-1].name == "source"
        if not loaded or not (pushed or stressed) or told or as_printed:
            return None
        if not stressed and not requirement.is_of_buckling:
            scene = scene.in_plane()  # what leaves it has no part in other numbers of the plane
        try:
            return self.design.ask(scene, self.sizes, self.models[0].joint_model)
        except SolveError:
            return None  # a model that has no answer to anything

    def _bound(self, requirement: Requirement, ask: Ask) -> Number:
        """Return a factor on loads up to which they surely buckle nothing out of the plane."""
        from flexcli.engine.lateral_factor import lateral_factor

        key = ask.scene.case, requirement.is_of_buckling, bool(ask.scene.across_by)
        if key not in self._bounds:
            self._bounds[key] = lateral_factor(ask, as_stated=requirement.is_of_buckling)
        return self._bounds[key]

    def _share(self, requirement: Requirement, ask: Ask) -> CriticalShare | None:
        """Return the share of loads that buckles the joint in space, if near what is asked."""
        one_alone()
        from flexcli.engine.joint_models.out_of_plane_buckling import out_of_plane_share
        from flexcli.engine.lateral_factor import is_held_by_blades

        started, as_stated = perf_counter(), requirement.is_of_buckling
        asked = _share_asked(requirement)
        key = ask.scene.case, as_stated, bool(ask.scene.across_by), asked
        if key not in self._shares:
            bound = float(self._bound(requirement, ask))
            found: CriticalShare | None = CriticalShare(bound, ask.scene.hold, None, 0.0)
            if is_held_by_blades(ask):
                found = out_of_plane_share(ask, bound, asked, buckling=as_stated)
            self._shares[key] = None if found is None else found.borne(ask.material)
            took = perf_counter() - started
            self.seconds[self._model] = self.seconds.get(self._model, 0.0) + took
        return self._shares[key]


def _share_asked(requirement: Requirement) -> float:
    """Return the factor on its loads up to which a joint shall stay in its plane.

    Of its buckling that is what is asked; of all else the loads themselves.
    """
    if isinstance(requirement, FactorRequirement) and requirement.is_of_buckling:
        return requirement.factor
    return 1.0


def _no_more(checks: Iterable[Check], least: Number) -> tuple[Check, ...]:
    """Return checks of buckling whose factors may be as little as what is known of the plane."""
    return tuple(
        check._replace(factor_range=(least, check.factor_range[1]))
        if check.factor_range is not None and check.factor_range[0] > least
        else check
        for check in checks
    )


def _buckles(check: Check, share: CriticalShare, asked: float, model: str) -> Check:
    """Return a check under loads that buckle the joint in space at a share of them, or may."""
    most = inf if share.error is None else share.share * (1.0 + share.error.high)
    verdict = Verdict.PASS
    if share.least < asked:
        verdict = Verdict.FAIL if most < asked else Verdict.UNDECIDED
    if check.verdict.rank < verdict.rank or (
        check.verdict is verdict and (verdict is not Verdict.PASS or check.factor <= share.share)
    ):
        return check
    return check._replace(
        quantity=IN_SPACE, demand=1.0, capacity=share.share, unit="", factor=share.share,
        required=asked, factor_range=(share.least, most), verdict=verdict, model=model,
        source=SOURCE,
    )  # fmt: skip
