"""The stress of loads out of the plane of a joint, beside its stroke, with its error.

Joints of even blades are told by their second order, those with hinges by exact beams.
"""

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import product
from math import inf, sqrt
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Filleted, Notch
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.second_order import SecondOrder
from flexcli.mechanics.space.states import Acting, SpaceState, Stresses, action, combined
from flexcli.mechanics.space.stresses import equivalent
from flexcli.mechanics.space.warping_error import warping_error
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_states import (
    KNOWN,
    SOFTENED,
    acting_groups,
    hinge_stress_error,
    hull,
    largest_stress,
    spring_change,
    third_order,
    warping_change,
)
from flexcli.parts.spring_limits import changed_by_springs
from flexcli.results import ErrorRange

if TYPE_CHECKING:
    from flexcli.mechanics.space.exact.stresses import SectionStates

__all__ = [
    "ACROSS", "WITHIN", "AcrossStress", "across_stress", "acting_across", "borne_stress",
    "changed_across",
]  # fmt: skip

Floats = NDArray[np.float64]

EXACT, NODES = 1e-5, (18, 27, 40)
"""Error of the forces of exact beams beside a stroke, relative, and their nodes, level by level."""

SWINGS, TURNING = 1.2, 2.0
"""On what loads across hinges alternate by in exact beams, and the rest of it as a share of their
stress per rotation of a hinge: the flow of forces about a throat turns with it. Solids by CalculiX
(``tests/benchmarks/hinges_at_stroke.py``) had up to 1.07 times that of beams by a moment M_y, and
up to 1.5 θ of the stress of a force or a torque."""

FAR = 0.2
"""Rotation of a hinge under loads out of its plane, by small motion, up to which exact beams are
used [rad]."""

SMALL = 1e-3
"""Share of loads that moves hinges by so little that twice as much moves them twice as far."""

ACROSS, WITHIN = (2, 3, 4), (0, 1, 5)
"""Springs of a blade that loads out of its plane strain, and those of loads in it."""

NEGLIGIBLE = 1e-3
"""Share of the stress of loads across a joint that those in its plane may add to it unseen."""


class AcrossStress(NamedTuple):
    """The largest stress of loads across a joint [Pa], its error, and how far it alternates [Pa].

    ``swings`` is by how much the stroke's amplitude may be more or less beside these loads.
    """

    value: float
    error: ErrorRange | None
    swings: float = 0.0


def across_stress(joint: SpaceJoint, scene: Scene) -> AcrossStress:
    """Return the largest stress of a case's loads out of the plane of a joint, and its error.

    Each load acts either way, the drive free, in the pose at rest. The error includes the
    interaction of the stroke, and of loads in the plane, with these loads: to second order, in
    joints with hinges by exact beams.
    """
    stresses, acting = Stresses(joint.assembly), acting_across(joint, scene)
    if not acting:
        return AcrossStress(0.0, ErrorRange(0.0, 0.0))
    groups = [action(joint.assembly, each) for each in acting]
    rest = _at_once(groups, stresses)
    if scene.temperature is not None:
        return AcrossStress(rest, None)  # nobody has told how far what it strains stiffens the rest
    if not _is_told(joint, scene) or _leaves_plane(joint, scene, stresses, rest):
        return AcrossStress(rest, None)
    if not joint.is_uniform:
        return _across_hinges(joint, scene, acting, stresses, rest)
    found = list(_beside(joint, scene, stresses))
    most = max(more for more, _, _ in found)
    off = max(each for _, each, _ in found)
    warped = hull(each for *_, each in found)
    if off > KNOWN or warped is None:
        return AcrossStress(rest + most, None)
    # what the stroke adds was taken as if largest at one place
    known = warped + ErrorRange(-off - most / (rest + most), off)
    return AcrossStress(rest + most, known, (rest + most) * known.largest)


def _is_told(joint: SpaceJoint, scene: Scene) -> bool:
    """Return whether the stress of loads across was compared; of sharp fillets that is at rest."""
    if joint.is_known_in_stress or scene.moves or not joint.is_known:
        return joint.is_known_in_stress
    filleted = all(
        isinstance(blade, SpaceBlade) and isinstance(blade.profile, Filleted)
        for blade in joint.layout.blades
    )
    return filleted and hull(map(hinge_stress_error, joint.layout.blades)) is not None


def acting_across(joint: SpaceJoint, scene: Scene) -> list[Acting]:
    """Return what acts out of the plane of a joint, each load by itself."""
    acting = (_along(each, scene.across) for each in acting_groups(joint, scene))
    return [each for each in acting if each.wrench.any() or each.acceleration.any()]


def _along(acting: Acting, components: Sequence[int]) -> Acting:
    """Return what of a load acts along some components of a wrench."""
    kept = np.isin(np.arange(6), components)
    return acting._replace(
        wrench=np.where(kept, acting.wrench, 0.0),
        acceleration=np.where(kept[:3], acting.acceleration, 0.0),
    )


class _Loads(NamedTuple):
    """What acts out of the plane of a joint and in it, where all has some sense."""

    across: SpaceState
    beside: SpaceState


def _senses(joint: SpaceJoint, scene: Scene) -> Iterator[_Loads]:
    """Yield the loads of a case in every sense they have together.

    What a wrench does in the plane and out of it has one sense. Where nothing acts in the plane all
    loads the other way are the mirror image, and left out.
    """
    groups, beside = acting_groups(joint, scene), [i for i in range(6) if i not in scene.across]
    parts = [
        [action(joint.assembly, _along(each, own)) for each in groups]
        for own in (scene.across, beside)
    ]
    mirrored = not any(state.moved.forces.any() for state in parts[1])
    for signs in product((1.0, -1.0), repeat=len(groups)):
        if mirrored and signs[0] < 0.0:
            continue
        across, along = (combined(states, list(signs)) for states in parts)
        yield _Loads(across, along)


class Changed(NamedTuple):
    """How a stroke changes the stress of loads across hinges: factors on that by small motion.

    ``swings`` is by what share of itself it alternates as the stroke does.
    """

    least: float
    most: float
    swings: float


def changed_across(joint: SpaceJoint, scene: Scene) -> Changed | None:
    """Return how a stroke, and their own size, change the stress of loads across hinges.

    That is by exact beams under the loads in every sense, at both ends of the stroke; None where
    there is no such state.
    """
    # exact beams are for hinges alone
    from flexcli.mechanics.space.exact.stresses import largest_of

    acting, turned = (
        acting_across(joint, scene),
        _turned_by(joint, max(map(abs, scene.stroke_ends))),
    )
    if any(not action(joint.assembly, each).loads for each in acting):
        return None
    ratios, swings, pushed = list[float](), 0.0, 0.0
    for loads in _senses(joint, scene):
        if _largest_turn(loads.across) > FAR:
            return None
        pushed = max(pushed, _largest_turn(loads.beside))
        few = _Loads(combined([loads.across], [SMALL]), combined([loads.beside], [0.0]))
        small = _added(joint, few, (0.0,))
        added = _added(joint, loads, tuple(dict.fromkeys(scene.stroke_ends)))
        if small is None or added is None:
            return None
        here = largest_of(joint.layout, small[0]) / SMALL
        ratios += [largest_of(joint.layout, each) / here for each in added]
        swings = max(swings, _alternating(joint, added) / here)
    swing, turned = TURNING * _turned_by(joint, scene.travel), TURNING * (turned + pushed)
    return Changed(min(ratios) - turned, max(ratios) + turned, SWINGS * swings + swing)


def _leaves_plane(joint: SpaceJoint, scene: Scene, stresses: Stresses, rest: float) -> bool:
    """Return whether loads in the plane strain blades out of it, beside a stress [Pa].

    Blades that cross side by side bear a force in the plane at different heights, which tilts the
    body.
    """
    beside = [i for i in range(6) if i not in scene.across]
    acting = [_along(each, beside) for each in acting_groups(joint, scene)]
    states = (action(joint.assembly, each) for each in acting)
    most = sum(borne_stress(stresses, state.moved.forces[:, 0], ACROSS) for state in states)
    return most > NEGLIGIBLE * rest


def borne_stress(stresses: Stresses, forces: Floats, springs: Sequence[int]) -> float:
    """Return the largest stress of what some springs of each blade bear of its forces [Pa]."""
    count = len(stresses.names)
    borne = forces[: 6 * count].reshape(-1, 6) * np.isin(np.arange(6), springs)
    return max(map(largest_stress, stresses.of(borne.ravel(), np.zeros((count, 3)))))


def _at_once(groups: list[SpaceState], stresses: Stresses) -> float:
    """Return the largest stress of groups of loads in either sense, combined at worst [Pa]."""
    each = (stresses.of(state.moved.forces[:, 0], state.weights) for state in groups)
    blades = zip(*each, strict=True)
    return max(float(np.max(sum(equivalent(s.normal, s.shear) for s in own))) for own in blades)


def _across_hinges(
    joint: SpaceJoint,
    scene: Scene,
    acting: list[Acting],
    stresses: Stresses,
    rest: float,
) -> AcrossStress:
    """Return the stress of loads out of the plane of a joint with hinges, and its error.

    ``rest`` is the stress at rest [Pa]. Exact beams give its relative change at a stroke; that of
    the blades' own weight, which they do not include, is taken to change as that of the loads. What
    they alternate by besides is half of the difference between both ends.
    """
    # exact beams are for hinges alone
    from flexcli.mechanics.space.exact.stresses import largest_of

    known = hull(map(hinge_stress_error, joint.layout.blades))
    unsure = _unevenly_sprung(joint, acting, stresses)
    if unsure is None or any(not action(joint.assembly, each).loads for each in acting):
        return AcrossStress(rest, None)
    least, most, swings = 0.0, 1.0, 0.0
    turned = _turned_by(joint, scene.travel)
    for loads in _senses(joint, scene):
        across = loads.across
        if _largest_turn(across) > FAR:
            return AcrossStress(rest, None)  # far beyond what it bears, and costly to follow
        forces = across.moved.forces[:, 0]
        here = max(map(largest_stress, stresses.of(forces, np.zeros_like(across.weights))))
        added = _added(joint, loads, tuple(dict.fromkeys(scene.stroke_ends)))
        if added is None:
            return AcrossStress(rest, None)
        for there in (largest_of(joint.layout, each) for each in added):
            least, most = max(least, there), max(most, there / here)
        swings = max(swings, _alternating(joint, added) * rest / here)
    found = rest * most
    if known is None:  # of the stress itself; all that acts in its sections is known
        return AcrossStress(found, ErrorRange(-1.0, inf), inf)
    # warping between straight clamps is as unsure as a hinge's is, which has that of its own
    plain = (b for b in joint.layout.blades if not _is_notch(b))
    whole = hull([known, *(warping_error(blade, curled=1.0) for blade in plain)])
    assert whole is not None  # both are told
    low, high = (1.0 + whole.low) * (1.0 + unsure.low), (1.0 + whole.high) * (1.0 + unsure.high)
    swings = (SWINGS * swings + TURNING * turned * found) * high
    return AcrossStress(found, ErrorRange(least / found * low - 1.0, high - 1.0), swings)


def _is_notch(blade: SpaceBlade | SpaceRod) -> bool:
    return isinstance(blade, SpaceBlade) and isinstance(blade.profile, Notch)


def _turned_by(joint: SpaceJoint, travel: float) -> float:
    """Return by how much a travel turns a hinge [rad]."""
    if not travel:
        return 0.0
    body = joint.layout.body(joint.layout.drive.body)
    stroke = action(joint.assembly, Acting(travel, np.zeros(6), body.point, np.zeros(3)))
    return _largest_turn(stroke)


def _largest_turn(state: SpaceState) -> float:
    """Return the largest rotation of one end of a hinge against the other, about any axis [rad]."""
    return float(np.abs(state.bent[:, 3:]).max())


def _alternating(joint: SpaceJoint, ends: "Sequence[list[SectionStates]]") -> float:
    """Return the stress of half of the difference between what loads add at both ends [Pa]."""
    # exact beams are for hinges alone
    from flexcli.mechanics.space.exact.stresses import difference, largest_of

    if len(ends) < 2:
        return 0.0
    apart = [difference(now, then) for now, then in zip(*ends, strict=True)]
    return largest_of(joint.layout, apart) / 2.0


def _unevenly_sprung(
    joint: SpaceJoint, acting: list[Acting], stresses: Stresses
) -> ErrorRange | None:
    """Return the error of the largest stress of loads by springs out of the plane, see limits."""
    if len(joint.layout.blades) == 1:  # what acts on it are the loads
        return ErrorRange(0.0, 0.0)

    def stress(assembly: SpaceAssembly) -> float:
        return _at_once([action(assembly, each) for each in acting], stresses)

    return changed_by_springs(joint, ACROSS, stress)


def _added(
    joint: SpaceJoint, loads: _Loads, travels: Sequence[float]
) -> "list[list[SectionStates]] | None":
    """Return what loads across add in sections at travels by exact beams, the drive held.

    A travel is from where loads in the plane leave the drive. None where there is no such state,
    or slightly larger loads would buckle the joint, there or at rest with its drive free. All have
    the same nodes.
    """
    from flexcli.mechanics.space.exact.demand import drive_frame
    from flexcli.mechanics.space.exact.equilibrium import solve
    from flexcli.mechanics.space.exact.stresses import added_states

    drive = joint.layout.drive
    made = partial(solve, joint.layout, frames=drive_frame(drive), tolerance=EXACT)
    sag = float(loads.beside.moved.coordinates[joint.assembly.driven, 0])
    held = [{drive.body: _held_at(joint, sag + travel)} for travel in travels]
    beside, both = loads.beside.loads, combined([loads.beside, loads.across], [1.0, 1.0]).loads
    try:
        free = made(loads=both, load_factor=1.0 / SOFTENED, levels=NODES).checked()
        states = [made(at, loads=both, levels=NODES).checked() for at in held]
        most = max(state.nodes for state in states)
        for k, at in enumerate(held):
            if states[k].nodes < most:
                states[k] = made(at, loads=both, levels=(most,)).checked()
        plain = [made(at, loads=beside, levels=(most,)).checked() for at in held]
    except SolveError:
        return None
    if free.unstable or any(state.unstable for state in states):
        return None
    return [added_states(*pair) for pair in zip(states, plain, strict=True)]


def _held_at(joint: SpaceJoint, travel: float) -> tuple[float | None, ...]:
    """Return the motion of the drive's body where the drive alone holds it at a travel."""
    own = 3 if joint.layout.drive.turns else 0
    return tuple(travel if axis == own else None for axis in range(6))


def _beside(
    joint: SpaceJoint, scene: Scene, stresses: Stresses
) -> Iterator[tuple[float, float, ErrorRange]]:
    """Yield what stroke and loads in the plane add to the stress across [Pa], and two errors.

    The errors are of both, the second that of warping; that is at each end of the stroke, for every
    sense of the loads.
    """
    body = joint.layout.body(joint.layout.drive.body)
    for end, loads in product(dict.fromkeys(scene.stroke_ends), _senses(joint, scene)):
        planar = loads.beside
        if end:
            stroke = action(joint.assembly, Acting(end, np.zeros(6), body.point, np.zeros(3)))
            planar = combined([stroke, planar], [1.0, 1.0])
        after = combined([planar, loads.across], [1.0, 1.0]).following()
        alone = planar.following()
        added = stresses.of(after.forces - alone.forces, np.zeros_like(planar.weights))
        inside = stresses.of_moments(after.inside - alone.inside)
        more = max(largest_stress(each) + more for each, more in zip(added, inside, strict=True))
        here = stresses.of(loads.across.moved.forces[:, 0], loads.across.weights)
        most = max(largest_stress(each) for each in here) + more
        beyond = third_order(after)
        if beyond < KNOWN:
            beyond += _returned(loads.across, after, alone, more / most)
        warped = warping_change(joint.layout.blades, here)
        yield more, beyond + spring_change(joint, loads.across), warped


def _returned(across: SpaceState, after: SecondOrder, alone: SecondOrder, share: float) -> float:
    """Return what of a linear state is changed in third and further orders, relative.

    Forces of a share s of those that buckle a joint change a motion by no more than s of itself in
    the norm of the energy: what loads move in second order, less what moves without those
    ``across``, comes back to them so. ``share`` is that of the second order in the stress.
    """
    strained = across.assembly.rows @ (after.coordinates - alone.coordinates)
    second = float(across.assembly.stiffness @ strained**2)
    first = float(across.moved.forces[:, 0] @ across.moved.deformations[:, 0])
    s = after.buckling
    return max(sqrt(second / first), share) * s / (1.0 - s) if first > 0.0 else 0.0
