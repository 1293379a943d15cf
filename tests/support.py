"""Support stiffness for tests: the compliance inverted, or stated elsewhere."""

import numpy as np
from planar_support import support_compliance

from flexcli.formulas.rigid_motion import motion_along, motion_at
from flexcli.mechanics.space.exact.support import support_compliance as in_space


def support_stiffness(*arguments, **options):
    """Return the inverse of the compliance, rows and columns scaled to one on the diagonal."""
    C = support_compliance(*arguments, **options)
    size = 1 / np.sqrt(np.diagonal(C, axis1=-2, axis2=-1))
    scale = size[..., :, None] * size[..., None, :]
    return np.linalg.inv(C * scale) * scale


def body_stiffness(state, body, point):
    """Return ∂(force, moment)/∂(shift, rotation) of a point in space, all six of them held."""
    first = 6 * state.layout.index(body)
    return np.linalg.inv(in_space(state, body, point, free=range(first, first + 6)))


def compliance_from(C, offset, axes):
    """Return a compliance at the point an offset away, along other axes (orthonormal rows)."""
    forth = motion_along(axes) @ motion_at(offset)
    return forth @ C @ forth.swapaxes(-1, -2)
