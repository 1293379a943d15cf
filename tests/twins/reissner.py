"""Plane frames of geometrically exact beams between rigid bodies, by minimising their energy.

Reissner's beam with Timoshenko's shear (κ = 5/6), positions and rotation interpolated by Lagrange
polynomials on Lobatto nodes. Nothing here is taken from flexcli, and the method is the opposite of
its exact model's: displacements are the unknowns there is a potential of, so that stability is the
count of negative eigenvalues of its Hessian. Newton keeps the stresses as unknowns of their own,
eliminated point by point (Magisano, Leonetti & Garcea 2017, mixed integration points), because
thin beams need hundreds of steps otherwise.
"""

from dataclasses import dataclass, field
from functools import cache
from typing import NamedTuple

import numpy as np
from scipy.linalg import eigh

SHEAR = 5.0 / 6.0
GROUND = "ground"
PIECES = (0.0, 0.07, 0.28, 0.72, 0.93, 1.0)
"""Ends of the elements of a blade over its length: short ones where clamps bend tense blades."""


class NoEquilibrium(Exception):
    """Newton found none, however short the steps of the load."""


class Beam(NamedTuple):
    """A straight blade: bodies it joins, its ends at rest [m], thickness(s) [m], width [m].

    ``breaks`` are where elements end, over the length.
    """

    first: str
    second: str
    start: tuple[float, float]
    end: tuple[float, float]
    h: object
    b: float
    breaks: tuple[float, ...] = PIECES

    @property
    def length(self):
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))

    @property
    def angle(self):
        return float(np.arctan2(self.end[1] - self.start[1], self.end[0] - self.start[0]))


class Mass(NamedTuple):
    """A rigid body: where its motion is told [m], its mass, inertia about its centre, centre."""

    at: tuple[float, float]
    mass: float = 0.0
    inertia: float = 0.0
    com: tuple[float, float] | None = None


class Push(NamedTuple):
    """A dead force at a body's point [N], and a moment [N·m]."""

    body: str
    point: tuple[float, float]
    force: tuple[float, float]
    moment: float = 0.0


@cache
def lobatto(degree):
    """Return Lobatto nodes on −1…1."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots().real
    return np.concatenate([[-1.0], np.sort(inner), [1.0]])


@cache
def lagrange(degree, points):
    """Return values and derivatives of the Lagrange polynomials at points."""
    nodes, points = lobatto(degree), np.array(points)
    V = np.polynomial.legendre.legvander(nodes, degree)
    P = np.polynomial.legendre.legvander(points, degree)
    D = np.stack(
        [
            np.polynomial.legendre.Legendre.basis(k).deriv()(points) if k else 0.0 * points
            for k in range(degree + 1)
        ],
        axis=1,
    )
    inverse = np.linalg.inv(V)
    return P @ inverse, D @ inverse


class Mesh:
    """One blade in scaled numbers: interpolation at its quadrature points, stiffness there."""

    def __init__(self, beam, E, G, density, length, force, degree):
        self.beam, l = beam, beam.length
        gauss, weight = np.polynomial.legendre.leggauss(degree + 2)
        values, slopes = lagrange(degree, tuple(gauss))
        n = degree * (len(beam.breaks) - 1) + 1
        rows, steps, places, weights = [], [], [], []
        self.nodes = np.zeros(n)
        for k, (a, c) in enumerate(zip(beam.breaks[:-1], beam.breaks[1:], strict=True)):
            half, here = (c - a) / 2.0, slice(k * degree, (k + 1) * degree + 1)
            N, D = np.zeros((len(gauss), n)), np.zeros((len(gauss), n))
            N[:, here], D[:, here] = values, slopes / (half * l / length)
            rows.append(N), steps.append(D)
            self.nodes[here] = a + half * (1.0 + lobatto(degree))
            places.append(a + half * (1.0 + gauss))
            weights.append(weight * half * l / length)
        self.N, self.D = np.vstack(rows), np.vstack(steps)
        self.places, self.w = np.concatenate(places), np.concatenate(weights)
        h = np.broadcast_to(beam.h(self.places) if callable(beam.h) else beam.h, self.w.shape)
        area = beam.b * h
        self.EA = E * area / force
        self.GA = SHEAR * G * area / force if G is not None else None
        self.EI = E * area * h**2 / 12.0 / force / length**2
        self.rho = density * area * length
        self.rho_I = density * area * h**2 / 12.0 / length
        self.rest = np.stack([self.nodes * l / length, 0.0 * self.nodes, 0.0 * self.nodes])

    def strains(self, u):
        """Return ε, γ, κ, and position slopes, of nodal (x, y, φ)."""
        x, y, turn = self.D @ u[0], self.D @ u[1], self.N @ u[2]
        c, s = np.cos(turn), np.sin(turn)
        return c * x + s * y - 1.0, c * y - s * x, self.D @ u[2], c, s

    def resultants(self, u):
        e, g, k, *_ = self.strains(u)
        return np.stack([self.EA * e, self.GA * g, self.EI * k])

    def force(self, u, sigma):
        """Return the nodal forces (3, n) that resultants make."""
        e, g, _, c, s = self.strains(u)
        N, Q, M = sigma * self.w
        return np.stack(
            [
                self.D.T @ (N * c - Q * s),
                self.D.T @ (N * s + Q * c),
                self.N.T @ (N * g - Q * (1.0 + e)) + self.D.T @ M,
            ]
        )

    def stiffness(self, u, sigma):
        """Return BᵀCB + G(σ), (3n, 3n)."""
        e, g, _, c, s = self.strains(u)
        (N, Q, _), w, D, V = sigma, self.w, self.D, self.N
        EA, GA = self.EA, self.GA
        stretched = 1.0 + e

        def block(left, values, right):
            return left.T @ ((w * values)[:, None] * right)

        xx = block(D, EA * c * c + GA * s * s, D)
        xy = block(D, (EA - GA) * c * s, D)
        yy = block(D, EA * s * s + GA * c * c, D)
        xt = block(D, EA * c * g + GA * s * stretched - N * s - Q * c, V)
        yt = block(D, EA * s * g - GA * c * stretched + N * c - Q * s, V)
        tt = block(V, EA * g * g + GA * stretched**2 - N * stretched - Q * g, V)
        tt += block(D, self.EI, D)
        return np.block([[xx, xy, xt], [xy.T, yy, yt], [xt.T, yt.T, tt]])

    def mass(self):
        """Return the consistent mass of its nodes."""
        m = self.N.T @ ((self.w * self.rho)[:, None] * self.N)
        j = self.N.T @ ((self.w * self.rho_I)[:, None] * self.N)
        zero = 0.0 * m
        return np.block([[m, zero, zero], [zero, m, zero], [zero, zero, j]])

    def ends(self):
        """Return where (x, y, φ) of both ends stand among its unknowns, and the others."""
        n = len(self.nodes)
        edge = np.array([0, n, 2 * n, n - 1, 2 * n - 1, 3 * n - 1])
        return edge, np.setdiff1d(np.arange(3 * n), edge)


def turn(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


@dataclass
class State:
    """A frame's motions of bodies (scaled), nodes and stresses of its blades, at a load share."""

    bodies: np.ndarray
    nodes: list
    sigma: list
    reactions: np.ndarray = field(default_factory=lambda: np.zeros(0))

    def copy(self):
        return State(self.bodies.copy(), [u.copy() for u in self.nodes], list(self.sigma))


class Frame:
    """Rigid bodies and the blades between them; E, G [Pa], density [kg/m³]."""

    def __init__(self, masses, beams, E, G, density=0.0, degree=8):
        self.masses, self.beams = dict(masses), list(beams)
        self.names = list(self.masses)
        self.length = max(beam.length for beam in beams)
        thick = [float(np.min(b.h(np.linspace(0, 1, 99)) if callable(b.h) else b.h)) for b in beams]
        self.unit = E * beams[0].b * min(thick) ** 3 / 12.0 / self.length**2
        self.E, self.G, self.density = E, G, density
        self.meshes = [
            Mesh(beam, E, G, density, self.length, self.unit, degree) for beam in self.beams
        ]

    def rest(self):
        """Return the frame at rest."""
        nodes = [mesh.rest.copy() for mesh in self.meshes]
        zero = [np.zeros((3, len(mesh.w))) for mesh in self.meshes]
        return State(np.zeros((len(self.names), 3)), nodes, zero)

    # -- ties of the blades' ends to the bodies --

    def _tie(self, beam, place, body, motion):
        """Return (x, y, φ) of an end in the blade's frame, its Jacobian and second derivative."""
        back = turn(-beam.angle)
        at = np.array(place) - np.array(beam.start)
        if body == GROUND:
            return np.append(back @ at / self.length, 0.0), None, None
        origin = np.array(self.masses[body].at)
        arm = (np.array(place) - origin) / self.length
        u, v, angle = motion
        moved = (origin - np.array(beam.start)) / self.length + [u, v] + turn(angle) @ arm
        T = np.zeros((3, 3))
        T[:2, :2], T[2, 2] = back, 1.0
        T[:2, 2] = back @ turn(angle + np.pi / 2.0) @ arm
        return np.append(back @ moved, angle), T, back @ turn(angle) @ arm

    def _set_ends(self, state):
        for mesh, u in zip(self.meshes, state.nodes, strict=True):
            beam = mesh.beam
            for node, place, body in ((0, beam.start, beam.first), (-1, beam.end, beam.second)):
                motion = None if body == GROUND else state.bodies[self.names.index(body)]
                u[:, node] = self._tie(beam, place, body, motion)[0]

    # -- assembly --

    def _tangent(self, state, pushes, sigma):
        """Return K and residual of the bodies, and per blade what recovers its inner nodes."""
        size = 3 * len(self.names)
        K, r, inner = np.zeros((size, size)), np.zeros(size), []
        for mesh, u, stress in zip(self.meshes, state.nodes, sigma, strict=True):
            full = mesh.stiffness(u, stress)
            f = mesh.force(u, mesh.resultants(u)).ravel()
            at_sigma = mesh.force(u, stress).ravel()
            edge, rest = mesh.ends()
            solved = np.linalg.solve(
                full[np.ix_(rest, rest)], np.column_stack([full[np.ix_(rest, edge)], f[rest]])
            )
            S = full[np.ix_(edge, edge)] - full[np.ix_(edge, rest)] @ solved[:, :6]
            g = f[edge] - full[np.ix_(edge, rest)] @ solved[:, 6]
            inner.append(solved)
            T, where = self._ties(mesh.beam, state, at_sigma[edge], K)
            K[np.ix_(where, where)] += T.T @ S @ T
            r[where] += T.T @ g
        for push in pushes:
            k = 3 * self.names.index(push.body)
            arm = (np.array(push.point) - np.array(self.masses[push.body].at)) / self.length
            angle = state.bodies[k // 3, 2]
            f = np.array(push.force) / self.unit
            r[k : k + 2] -= f
            r[k + 2] -= f @ turn(angle + np.pi / 2.0) @ arm
            r[k + 2] -= push.moment / self.unit / self.length
            K[k + 2, k + 2] += f @ turn(angle) @ arm
        return K, r, inner

    def _ties(self, beam, state, ends, K):
        """Return dq_ends/dq_bodies (6, ·) with its columns; add the ties' curvature to K."""
        T, where = np.zeros((6, 6)), []
        for k, (place, body) in enumerate(((beam.start, beam.first), (beam.end, beam.second))):
            if body == GROUND:
                continue
            index = self.names.index(body)
            _, J, bend = self._tie(beam, place, body, state.bodies[index])
            T[3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = J
            where += [(3 * k + i, 3 * index + i) for i in range(3)]
            K[3 * index + 2, 3 * index + 2] -= ends[3 * k : 3 * k + 2] @ bend
        columns = [a for a, _ in where]
        return T[:, columns], np.array([b for _, b in where], dtype=int)

    # -- equilibrium --

    def _newton(self, start, pushes, held, most=25):
        """Return the equilibrium with held coordinates {(body, axis): value}, or nothing."""
        state = start.copy()
        fixed = np.zeros(3 * len(self.names), dtype=bool)
        target = np.zeros(fixed.size)
        for (body, axis), value in held.items():
            k = 3 * self.names.index(body) + axis
            fixed[k], target[k] = True, value if axis == 2 else value / self.length
        free, last = ~fixed, np.inf
        for _ in range(most):
            K, r, inner = self._tangent(state, pushes, state.sigma)
            step = np.zeros(fixed.size)
            step[fixed] = target[fixed] - state.bodies.ravel()[fixed]
            if free.any():
                right = -r[free] - K[np.ix_(free, fixed)] @ step[fixed]
                try:
                    step[free] = np.linalg.solve(K[np.ix_(free, free)], right)
                except np.linalg.LinAlgError:
                    return None
            change = np.abs(step).max()
            if not np.isfinite(change) or change > 3.0:
                return None
            before = [u.copy() for u in state.nodes]
            state.bodies += step.reshape(-1, 3)
            self._set_ends(state)
            sigma = []
            for mesh, u, old, solved in zip(self.meshes, state.nodes, before, inner, strict=True):
                edge, rest = mesh.ends()
                # the ends' own motion, to first order, moves the inner nodes
                moved = self._linear_ends(mesh.beam, state, step, start_at=old)
                flat = old.ravel().copy()
                flat[rest] -= solved[:, :6] @ moved + solved[:, 6]
                delta = np.zeros(flat.size)
                delta[rest], delta[edge] = -(solved[:, :6] @ moved + solved[:, 6]), moved
                sigma.append(self._extrapolated(mesh, old, delta))
                new = flat.reshape(3, -1)
                new[:, 0], new[:, -1] = u[:, 0], u[:, -1]
                u[:] = new
                change = max(change, np.abs(delta).max())
            state.sigma = sigma
            if change < 1e-11 or (change < 1e-7 and change > last / 2.0):
                state.sigma = [
                    m.resultants(u) for m, u in zip(self.meshes, state.nodes, strict=True)
                ]
                _, r, _ = self._tangent(state, pushes, state.sigma)
                state.reactions = r
                return state
            last = change
        return None

    def _linear_ends(self, beam, state, step, start_at):
        """Return the linearised motion of a blade's ends (6,) by that of its bodies."""
        moved = np.zeros(6)
        for k, (place, body) in enumerate(((beam.start, beam.first), (beam.end, beam.second))):
            if body == GROUND:
                continue
            index = self.names.index(body)
            motion = state.bodies[index] - step[3 * index : 3 * index + 3]
            _, J, _ = self._tie(beam, place, body, motion)
            moved[3 * k : 3 * k + 3] = J @ step[3 * index : 3 * index + 3]
        return moved

    @staticmethod
    def _extrapolated(mesh, u, delta):
        """Return C(ε + B δu), the stresses of the mixed Newton step."""
        du = delta.reshape(3, -1)
        e, g, k, c, s = mesh.strains(u)
        x, y, t = mesh.D @ du[0], mesh.D @ du[1], mesh.N @ du[2]
        e1 = e + c * x + s * y + g * t
        g1 = g + c * y - s * x - (1.0 + e) * t
        return np.stack([mesh.EA * e1, mesh.GA * g1, mesh.EI * (k + mesh.D @ du[2])])

    def solve(self, held=None, pushes=(), start=None, from_held=None, from_share=0.0):
        """Return the equilibrium, by steps in load and motion from a start (at rest)."""
        held = held or {}
        state = self.rest() if start is None else start
        first = from_held if from_held is not None else dict.fromkeys(held, 0.0)
        share, step = 0.0, 1.0
        while share < 1.0:
            at = min(1.0, share + step)
            now = {key: first[key] + at * (held[key] - first[key]) for key in held}
            scale = from_share + at * (1.0 - from_share)
            loads = [
                p._replace(force=tuple(scale * f for f in p.force), moment=scale * p.moment)
                for p in pushes
            ]
            found = self._newton(state, loads, now)
            if found is None:
                step /= 2.0
                if step < 1.0 / 256.0:
                    raise NoEquilibrium(f"at {share:.5f} of the way")
            else:
                state, share = found, at
                step *= 2.0
        return state

    def stable_solve(self, held=None, pushes=(), steps=12):
        """Return the equilibrium on the path from rest, motion first and then load."""
        found = self.solve(held, pushes)
        if self.stands(found, pushes, held or {}):
            return found
        held = held or {}
        now = self.rest()
        for k in range(1, steps + 1):
            here = {key: value * k / steps for key, value in held.items()}
            before = {key: value * (k - 1) / steps for key, value in held.items()}
            now = self.solve(here, (), start=now, from_held=before)
        if not pushes:
            return now
        for k in range(1, steps + 1):
            loads = [_scaled(p, k / steps) for p in pushes]
            now = self.solve(held, loads, start=now, from_held=held, from_share=(k - 1) / k)
        return now

    def stands(self, state, pushes, held):
        """Return whether the Hessian is positive definite, what is held taken out."""
        sigma = [m.resultants(u) for m, u in zip(self.meshes, state.nodes, strict=True)]
        for mesh, u, stress in zip(self.meshes, state.nodes, sigma, strict=True):
            _, rest = mesh.ends()
            if not is_definite(mesh.stiffness(u, stress)[np.ix_(rest, rest)]):
                return False
        K, *_ = self._tangent(state, pushes, sigma)
        free = self._free(held)
        return is_definite(K[np.ix_(free, free)])

    def _free(self, held):
        fixed = {3 * self.names.index(body) + axis for body, axis in held}
        return [k for k in range(3 * len(self.names)) if k not in fixed]

    # -- what is asked --

    def motion(self, state, body, point):
        """Return how far a body's point moved [m]."""
        u, v, angle = state.bodies[self.names.index(body)]
        arm = np.array(point) - np.array(self.masses[body].at)
        return np.array([u, v]) * self.length + turn(angle) @ arm - arm

    def tangent_stiffness(self, state, pushes, held, along):
        """Return dR/dq of a held coordinate, the others free or held [N/m or N·m/rad]."""
        sigma = [m.resultants(u) for m, u in zip(self.meshes, state.nodes, strict=True)]
        K, *_ = self._tangent(state, pushes, sigma)
        k = 3 * self.names.index(along[0]) + along[1]
        free = [i for i in self._free(held) if i != k]
        value = K[k, k]
        if free:
            value -= K[k, free] @ np.linalg.solve(K[np.ix_(free, free)], K[free, k])
        return value * self.unit * (self.length if along[1] == 2 else 1.0 / self.length)

    def faces(self, state, places):
        """Return per blade the stress at both faces (2, places) [Pa], from its end forces."""
        found = []
        for mesh, u in zip(self.meshes, state.nodes, strict=True):
            beam = mesh.beam
            f = mesh.force(u, mesh.resultants(u))[:, 0]
            F, M0 = -f[:2] * self.unit, -f[2] * self.unit * self.length
            x, y, angle = _interpolated(mesh, u, places)
            along = F[0] * np.cos(angle) + F[1] * np.sin(angle)
            arm = np.stack([x - u[0, 0], y - u[1, 0]]) * self.length
            M = M0 - (arm[0] * F[1] - arm[1] * F[0])
            h = beam.h(places) if callable(beam.h) else np.full(len(places), beam.h)
            bending = 6.0 * M / (beam.b * h**2)
            found.append(along / (beam.b * h) + np.stack([bending, -bending]))
        return found

    def frequencies(self, count=3, held=None):
        """Return natural frequencies at rest [Hz], blades' mass and rotary inertia included."""
        state = self.rest()
        size = 3 * len(self.names)
        inner = sum(len(mesh.ends()[1]) for mesh in self.meshes)
        K, M = np.zeros((size + inner,) * 2), np.zeros((size + inner,) * 2)
        at = size
        for mesh, u in zip(self.meshes, state.nodes, strict=True):
            full, mass = mesh.stiffness(u, 0.0 * mesh.resultants(u)), mesh.mass()
            edge, rest = mesh.ends()
            T, where = self._ties(mesh.beam, state, np.zeros(6), K)
            wide = np.zeros((full.shape[0], T.shape[1] + len(rest)))
            wide[edge, : T.shape[1]] = T
            wide[rest, T.shape[1] + np.arange(len(rest))] = 1.0
            index = np.concatenate([where, at + np.arange(len(rest))])
            K[np.ix_(index, index)] += wide.T @ full @ wide
            M[np.ix_(index, index)] += wide.T @ mass @ wide
            at += len(rest)
        K *= self.unit / self.length
        for k, body in enumerate(self.masses.values()):
            arm = np.zeros(2) if body.com is None else np.subtract(body.com, body.at)
            a = np.array([-arm[1], arm[0]]) / self.length
            here = slice(3 * k, 3 * k + 3)
            J = np.array([[1.0, 0.0, a[0]], [0.0, 1.0, a[1]]])
            M[here, here] += body.mass * J.T @ J
            M[3 * k + 2, 3 * k + 2] += body.inertia / self.length**2
        free = [k for k in range(size + inner) if k >= size or k in self._free(held or {})]
        slow = eigh(M[np.ix_(free, free)], K[np.ix_(free, free)], eigvals_only=True)
        return 1.0 / np.sqrt(slow[::-1][:count]) / (2.0 * np.pi)

    def critical(self, pushes, held, start=None, most=None, first=0.06):
        """Return the least factor on pushes at which the Hessian loses definiteness, or infinity.

        ``held`` {(body, axis): value} stay as they are in ``start``; the factor is found by
        halves between a stable and an unstable (or unreached) equilibrium, to 1e-4.
        """
        state = self.rest() if start is None else start
        if not self.stands(state, (), held):
            return 0.0
        share, step, limit, unreached = 0.0, first, np.inf, False
        for _ in range(90):
            if share >= 1.0:
                return np.inf
            gap = limit - share
            if gap < 1e-4 * limit:
                return (share + limit) / 2.0 * most
            again = unreached and gap < 2e-3 * limit  # a long step may have failed by itself
            at = limit if again else min(1.0, share + step)
            unreached = unreached and not again
            loads = [_scaled(p, at * most) for p in pushes]
            found = self._newton(state, loads, held, most=14)
            if found is None or not self.stands(found, loads, held):
                unreached = unreached or (found is None and not again)
                limit, step = at, (at - share) / 2.0
            elif np.abs(found.bodies - state.bodies).max() > 0.35:
                step /= 2.0  # on another path, maybe
            else:
                state, share = found, at
                limit = np.inf if again else limit
                step = min(1.5 * step, 0.2, (limit - share) / 2.0)
        raise NoEquilibrium("its critical load is not found")


def _scaled(push, share):
    return push._replace(force=tuple(share * f for f in push.force), moment=share * push.moment)


def _interpolated(mesh, u, places):
    breaks = np.array(mesh.beam.breaks)
    degree = (len(mesh.nodes) - 1) // (len(breaks) - 1)
    element = np.clip(np.searchsorted(breaks, places, side="right") - 1, 0, len(breaks) - 2)
    out = np.zeros((3, len(places)))
    for k in range(len(breaks) - 1):
        mine = element == k
        if mine.any():
            local = 2.0 * (places[mine] - breaks[k]) / (breaks[k + 1] - breaks[k]) - 1.0
            values, _ = lagrange(degree, tuple(np.clip(local, -1.0, 1.0)))
            out[:, mine] = u[:, k * degree : (k + 1) * degree + 1] @ values.T
    return out


def is_definite(A):
    """Return whether a symmetric matrix is positive definite."""
    if A.size == 0:
        return True
    diagonal = np.diag(A)
    if not (diagonal > 0.0).all():
        return False
    scale = 1.0 / np.sqrt(diagonal)
    try:
        np.linalg.cholesky((A + A.T) / 2.0 * np.outer(scale, scale))
    except np.linalg.LinAlgError:
        return False
    return True
