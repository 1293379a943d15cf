"""Print a digest of what BLAS, LAPACK and NumPy's functions compute here, to the last bit.

Where it is the same on the kernels of another CPU, so is whatever is computed by them.
"""

from hashlib import sha256

import numpy as np
from scipy.linalg import cholesky, eigh, lapack, solve_triangular

SIZES = (*range(1, 20), 31, 33, 48, 63, 64, 65, 90, 127, 128, 129, 200, 257, 300, 384)


def of(n: int, rng: np.random.Generator) -> list[np.ndarray]:
    """Return what kernels make of random matrices of n rows."""
    A, B, x = rng.normal(size=(n, n)), rng.normal(size=(n, 7)), rng.normal(size=n)
    C, symmetric, definite = A + 1j * A[::-1], A + A.T, A @ A.T + n * np.eye(n)
    factor = cholesky(definite, lower=True)
    size = np.abs(x)
    return [
        A @ B, A.T @ A, A @ x, A.T @ x, x @ x, C @ C,
        np.linalg.solve(A, B), np.linalg.inv(A), np.linalg.solve(C, B + 0j),
        np.linalg.eigvals(A), *np.linalg.eigh(symmetric), np.linalg.eigvalsh(symmetric),
        *np.linalg.svd(A), *np.linalg.qr(A), np.linalg.lstsq(A, B, rcond=None)[0],
        *eigh(symmetric, definite), lapack.dsytrf(symmetric, lower=1)[0],
        factor, *(solve_triangular(factor, B, way, lower=True) for way in "NT"),
        np.einsum("ij,jk->ik", A, B), np.sum(A, axis=0), np.sum(x), np.cumsum(x),
        np.exp(x), np.expm1(x), np.log(size), np.log1p(size), np.sqrt(size), size**1.7,
        np.sin(x), np.cos(x), np.tan(x), np.sinh(x), np.cosh(x), np.tanh(x), np.arctan2(x, size),
        np.hypot(x, 1.0), x / size, np.maximum(x, 0.0), np.sort(x),
    ]  # fmt: skip


digest = sha256()
for n in SIZES:
    for found in of(n, np.random.default_rng(n)):
        digest.update(np.ascontiguousarray(found).tobytes())
print(digest.hexdigest())
