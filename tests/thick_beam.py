"""Timoshenko's clamped beam with a rigid body at its tip: where its equations have a frequency."""

import numpy as np
from scipy.linalg import expm


def timoshenko(omega, *, E, G, rho, h, l, b, m, c=0.0, J=0.0):
    """Return what vanishes at an angular frequency; the body's mass sits c beyond the tip."""
    A, I = b * h, b * h**3 / 12.0
    line, turn = rho * A * omega**2, rho * I * omega**2
    # w' = φ + Q/κGA, φ' = M/EI, M' = −Q − ρIω²φ, Q' = −ρAω²w
    rates = [[0, 1, 0, 1.2 / (G * A)], [0, 0, 1 / (E * I), 0], [0, -turn, 0, -1], [-line, 0, 0, 0]]
    # per M and Q at the clamp
    w, phi, M, Q = expm(np.array(rates) * l)[:, 2:]
    force = m * omega**2 * (w + c * phi)
    free = np.array([M - J * omega**2 * phi - c * force, Q - force])
    return float(np.linalg.det(free / np.abs(free).max(axis=0)))
