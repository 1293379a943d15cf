"""What the stiffness of a linkage's joints asks of its input: energy, effort, stiffness."""

from collections.abc import Mapping
from typing import NamedTuple

from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.linkages.motion import Motion

__all__ = ["Reflected", "reflected"]


class Reflected(NamedTuple):
    """Stored energy [J], effort to hold the input [N·m or N], its tangent stiffness."""

    energy: Quantity
    effort: Quantity
    stiffness: Quantity


def reflected(motion: Motion, stiffnesses: Mapping[str, Quantity]) -> Reflected:
    """Return energy, effort and tangent stiffness that the joints' springs reflect to the input.

    ``V = Σ k φ²/2``, ``M = dV/dθ = Σ k φ φ'`` and ``dM/dθ = Σ k (φ'² + φ φ'')`` over the joints,
    with φ' and φ'' the derivatives of a joint's deflection by the input θ. At rest φ = 0 and the
    stiffness is Σ k φ'².

    Parameters
    ----------
    motion : Motion
        The linkage at values of its input.
    stiffnesses : mapping of Quantity
        Stiffness of the joints [N·m/rad or N/m]; a joint left out is free. Arrays broadcast
        with the inputs.

    Returns
    -------
    energy : Quantity
        Stored energy [J].
    effort : Quantity
        Torque on a revolute input [N·m], or force on a prismatic one [N].
    stiffness : Quantity
        Derivative of the effort by the input [N·m/rad or N/m].

    Notes
    -----
    Linear joints, relaxed in the assembled pose; exact for any motion of the links.

    Raises
    ------
    ValueError
        When a name is no joint of the linkage.

    Examples
    --------
    >>> from flexcli.mechanics.linkages.linkage import Link, Linkage, Revolute
    >>> from flexcli.mechanics.linkages.travel import motion
    >>> parallelogram = Linkage(
    ...     tuple(map(Link, ("base", "crank", "stage", "rocker"))),
    ...     (Revolute("A", "base", "crank", (0.0, 0.0)),
    ...      Revolute("B", "crank", "stage", (0.0, 1.0)),
    ...      Revolute("C", "stage", "rocker", (2.0, 1.0)),
    ...      Revolute("D", "base", "rocker", (2.0, 0.0))),
    ...     ground="base", input="A")
    >>> round(float(reflected(motion(parallelogram, 0.1), dict.fromkeys("ABCD", 5.0)).stiffness), 9)
    20.0

    References
    ----------
    Howell (2001), Compliant Mechanisms, chapter 6 (virtual work of the pseudo-rigid-body model).

    """
    unknown = sorted(set(stiffnesses) - set(motion.deflections))
    if unknown:
        raise ValueError(f"no joint of the linkage is named {', '.join(unknown)}")
    energy = effort = stiffness = motion.input * 0.0
    for name, k in stiffnesses.items():
        phi, ratio, curvature = (
            x[name] for x in (motion.deflections, motion.ratios, motion.curvatures)
        )
        energy = energy + k * phi**2 / 2.0
        effort = effort + k * phi * ratio
        stiffness = stiffness + k * (ratio**2 + phi * curvature)
    return Reflected(energy, effort, stiffness)
