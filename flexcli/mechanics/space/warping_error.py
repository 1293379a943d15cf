"""How far the stress of blades whose ends cannot warp may be from what beams have.

It is nominal: of its moment in the section, ∫σ y z dA, as bending stress is of its own. Near the
corner of a clamp it is not spread so, which no nominal stress has.
"""

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.formulas.restrained_torsion import restraint_error
from flexcli.mechanics.space.layout import Isotropic, SpaceBlade, SpaceRod
from flexcli.results import ErrorRange

__all__ = ["warping_error"]

UNCOMPARED = 0.2
"""Error of hinges and of blades that are stiffer one way, either way [-]."""

THICK, THICKEST = 0.5, ErrorRange(-0.35, 0.003)
"""h/b beyond which a section's warping is not that of a strip, and its error there: blocks of h/b
0.5 to 1 had 0.1 to 0.3 less."""

AT_STROKE = 0.05
"""What a stroke or a load that bends the blade adds either way, where its section curls: shells of
strips twisted beside it, b/l 0.15 to 1, h/b 0.01 and 0.03, ν to 0.45, bent by up to 0.4 rad and a
fifth of their length, had up to 0.035 more and 0.02 less than at rest."""


def warping_error(blade: SpaceBlade | SpaceRod, curled: float = 0.0) -> ErrorRange:
    """Return the error of the normal stress of restrained warping of a blade [-].

    ``curled`` is the share of the most by which its section may curl, or flatten, as it bends. Of
    isotropic blades of one thickness it was told by blocks and plates, see
    :func:`flexcli.formulas.restrained_torsion.restraint_error`.
    """
    if not (isinstance(blade, SpaceBlade) and isinstance(blade.material, Isotropic)):
        return ErrorRange(-UNCOMPARED, UNCOMPARED)
    if not isinstance(blade.profile, Constant):
        return ErrorRange(-UNCOMPARED, UNCOMPARED)
    h, b = float(blade.profile.h), blade.b
    if min(h, b) > THICK * max(h, b):
        return THICKEST
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    error = restraint_error(nu=blade.material.nu, h=h, b=b, l=l)
    (low, high), turned = map(float, error.normal), error.stiffness.left
    # by its twist or by its torque, whichever is known
    low = min(low, (1.0 + low) / (1.0 + max(float(turned.high), 0.0)) - 1.0)
    high = max(high, (1.0 + high) / (1.0 + float(turned.low)) - 1.0)
    return ErrorRange(low - AT_STROKE * curled, high + AT_STROKE * curled)
