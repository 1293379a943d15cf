"""Frames in space by the direct stiffness method: 12×12 beams between points of rigid bodies.

Shares no code with the package: the matrix of a beam is written out at its ends, its joints are
eliminated by the rigid bodies they are on, and everything is solved in one dense system.
"""

import numpy as np

__all__ = ["Beam", "Frame", "beam_matrix"]


def beam_matrix(l, EA, GJ, EI_y, EI_z, shear_y=0.0, shear_z=0.0):
    """Return the 12×12 stiffness of a beam along x: (u, v, w, θx, θy, θz) at both ends."""
    K = np.zeros((12, 12))

    def put(rows, block):
        K[np.ix_(rows, rows)] += block

    put([0, 6], EA / l * np.array([[1, -1], [-1, 1]]))
    put([3, 9], GJ / l * np.array([[1, -1], [-1, 1]]))
    across = ([1, 5, 7, 11], EI_z, shear_y, 1.0), ([2, 4, 8, 10], EI_y, shear_z, -1.0)
    for rows, EI, shear, s in across:
        f = EI / (1.0 + shear) / l**3
        a, b = (4.0 + shear) * l**2, (2.0 - shear) * l**2
        put(rows, f * np.array([
            [12.0, s * 6 * l, -12.0, s * 6 * l],
            [s * 6 * l, a, -s * 6 * l, b],
            [-12.0, -s * 6 * l, 12.0, -s * 6 * l],
            [s * 6 * l, b, -s * 6 * l, a],
        ]))  # fmt: skip
    return K


class Beam:
    """A beam between two bodies by number (None is the ground), with its axes as rows."""

    def __init__(self, first, second, start, end, axes, K):
        self.bodies, self.ends, self.axes, self.K = (first, second), (start, end), axes, K


class Frame:
    """Bodies at points, beams between them; motions are of the points along global axes."""

    def __init__(self, points, beams):
        self.points = [np.asarray(p, dtype=float) for p in points]
        n = 6 * len(points)
        self.K, self.beams, self.rows = np.zeros((n, n)), beams, []
        for beam in beams:
            T = np.zeros((12, n))
            for end, (body, place) in enumerate(zip(beam.bodies, beam.ends, strict=True)):
                if body is None:
                    continue
                rigid = np.eye(6)
                x, y, z = np.asarray(place, dtype=float) - self.points[body]
                rigid[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
                turn = np.kron(np.eye(2), beam.axes)
                T[6 * end : 6 * end + 6, 6 * body : 6 * body + 6] = turn @ rigid
            self.K += T.T @ beam.K @ T
            self.rows.append(T)

    def missed(self, index, offset, held=None):
        """Return the end forces of all beams (beams, 12), one's seat on its second body off (6,).

        ``held`` is a row that may not move.
        """
        off = np.zeros(12)
        off[6:] = np.kron(np.eye(2), self.beams[index].axes) @ offset
        load = -self.rows[index].T @ self.beams[index].K @ off
        K = self.K
        if held is not None:
            size = np.abs(K).max()
            K = np.block([[K, size * held[:, None]], [size * held[None, :], np.zeros((1, 1))]])
            load = np.append(load, 0.0)
        q = np.linalg.solve(K, load)[: len(self.K)]
        return np.array([
            beam.K @ (rows @ q + (off if k == index else 0.0))
            for k, (beam, rows) in enumerate(zip(self.beams, self.rows, strict=True))
        ])  # fmt: skip

    def compliance(self, body, held=None):
        """Return the 6×6 compliance of a body; ``held`` is a row that may not move."""
        n = len(self.K)
        K, extra = self.K, 0
        if held is not None:
            extra = 1
            size = np.abs(K).max()
            K = np.block([[K, size * held[:, None]], [size * held[None, :], np.zeros((1, 1))]])
        C = np.linalg.inv(K)[:n, :n] if extra else np.linalg.inv(K)
        at = slice(6 * body, 6 * body + 6)
        return C[at, at]
