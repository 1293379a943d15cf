r"""Rigid bodies on one degree of freedom, on a base that accelerates and turns: Lagrange, once.

Bodies are those of :mod:`flexcli.mechanics.layout`. With the coordinate q, each has its centre of
mass at x(q), y(q) and is turned by φ(q) (anticlockwise) in the base's frame, a spring of stiffness
k resists q, and the displacement u(q) is what the force F works on:

    T = ½ m_q q̇² + (c_x γ̇_x + c_y γ̇_y + c_φ Ω) q̇ + …,   V = ½ k q²
    m_q = Σ m (x'² + y'²) + J φ'²
    c_x = Σ m x',   c_y = Σ m y',   c_φ = Σ m (x y' − y x') + J φ'

Lagrange's equation, per unit of u, with γ̈ the acceleration of the base, Ω̇ its rotation about the
origin, and F positive along u:

    F = m_eq ü + ½ m_eq' u̇² + V'/u' + τ_x γ̈_x + τ_y γ̈_y + τ_φ Ω̇ − ½ I'/u' Ω²
    m_eq = m_q/u'²,  τ = c/u',  k_eq = d(V'/u')/du,  I = Σ m (x² + y²)

(the gyroscopic terms of one degree of freedom cancel). A body at rest in a field of gravity g
feels what a base accelerated by −g does, so gravity pulls along u with τ · g, and the base feels
back −τ_x ü, −τ_y ü and the torque −τ_φ ü.

Derivatives are Taylor coefficients: exact to rounding like a complex step, but of every order, and
the orders beyond the first are what is asked of the stroke.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

from flexcli.mechanics.layout import Body
from flexcli.numerics.taylor import Scalar, Taylor, cos, lifted, sin

__all__ = ["Expansion", "Path", "SingleFreedom", "expand"]

Path: TypeAlias = Callable[[Taylor], tuple[Scalar, Scalar, Scalar]]
"""Position x, y [m] of a body's reference point and turn [rad] from rest, of the coordinate."""


class SingleFreedom(NamedTuple):
    """Bodies and where they go with the coordinate, its spring, what the force works on.

    The spring has its stiffness against the coordinate [N/m or N·m/rad], and is at rest at zero.
    """

    bodies: Sequence[tuple[Body, Path]]
    spring: float
    output: Callable[[Taylor], Scalar]


class Expansion(NamedTuple):
    """Terms of the equation of motion about one position, as series in the coordinate q.

    Per unit of the output u: with u in metres masses and τ_x, τ_y are in kg, τ_φ in kg·m; with u
    an angle in kg·m², kg·m and kg·m². ``.value`` is the term at the position itself.
    """

    output: Taylor
    output_rate: Taylor
    mass: Taylor
    force: Taylor
    stiffness: Taylor
    coupling_x: Taylor
    coupling_y: Taylor
    coupling_rotation: Taylor
    potential: Taylor

    def gravity_stiffness(self, gx: float, gy: float) -> float:
        """Return what a field of gravity along x and y [m/s²] adds to the stiffness."""
        pull = self.coupling_x * gx + self.coupling_y * gy
        return -pull.derivative().value / self.output_rate.value


def expand(system: SingleFreedom, at: float = 0.0, *, order: int = 3) -> Expansion:
    """Return the equation of motion about a position, to an order in the coordinate.

    Parameters
    ----------
    system : SingleFreedom
        Bodies, spring and output.
    at : float
        Coordinate to expand about [m or rad].
    order : int
        Highest order of the couplings and the mass; the stiffness has one less.

    Returns
    -------
    Expansion
        Series in the distance from ``at``.

    Notes
    -----
    Rigid bodies, a massless linear spring, motion in a plane. The output must move with the
    coordinate at ``at`` (u' ≠ 0).

    Examples
    --------
    Mass on a spring whose base shakes:

    >>> stage = SingleFreedom(
    ...     [(Body("stage", (0.0, 0.0), mass=1.0), lambda q: (q, 0.0, 0.0))],
    ...     864.0,
    ...     lambda q: q,
    ... )
    >>> motion = expand(stage)
    >>> motion.mass.value, motion.stiffness.value, motion.coupling_x.value
    (1.0, 864.0, 1.0)

    References
    ----------
    Exercise 9 part I, question 1, and exercise 12 A, which are cases of it.

    """
    kept = max(order, 1) + 1
    q = Taylor.variable(at, kept)
    output = lifted(system.output(q), kept)
    rate = output.derivative()
    nothing = lifted(0.0, kept - 1)
    mass = c_x = c_y = c_phi = nothing
    for body, path in system.bodies:
        x, y, phi = _centre(body, *(lifted(term, kept) for term in path(q)))
        dx, dy, dphi = x.derivative(), y.derivative(), phi.derivative()
        mass = mass + (dx * dx + dy * dy) * body.mass + dphi * dphi * body.inertia
        c_x = c_x + dx * body.mass
        c_y = c_y + dy * body.mass
        c_phi = c_phi + (x * dy - y * dx) * body.mass + dphi * body.inertia
    potential = q * q * (0.5 * system.spring)
    force = potential.derivative() / rate
    return Expansion(
        output=output,
        output_rate=rate,
        mass=mass / (rate * rate),
        force=force,
        stiffness=force.derivative() / rate,
        coupling_x=c_x / rate,
        coupling_y=c_y / rate,
        coupling_rotation=c_phi / rate,
        potential=potential,
    )


def _centre(body: Body, x: Taylor, y: Taylor, phi: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    """Return where the centre of mass goes with the reference point, and the turn."""
    across, along = (body.com[i] - body.point[i] for i in (0, 1))
    s, c = sin(phi), cos(phi)
    return c * across - s * along + x, c * along + s * across + y, phi
