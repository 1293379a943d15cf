"""Sections along blades and rods: compliances in units of the blade.

Lengths by its length l, forces by EI/l², moments by EI/l, with EI = E b h³/12 that of bending
across the thickness where it is least (of a round rod: π E d⁴/64). Axes: x along the blade, y
across its thickness, z across its width.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import plate_factors, sheet_factors
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Piece, Tabulated
from flexcli.formulas.section import second_moment
from flexcli.formulas.torsion_fibres import rectangle_fourth_moment
from flexcli.formulas.torsion_section import torsion_constant, warping
from flexcli.mechanics.mesh import SHEAR_FACTOR
from flexcli.mechanics.space.layout import (
    BeamEffects,
    Directed,
    Isotropic,
    SpaceBlade,
    SpaceRod,
    SpaceStar,
)
from flexcli.mechanics.wide_hinge import wide_hinge

__all__ = ["Compliances", "Section", "section_of"]

Floats = NDArray[np.float64]

ROUND_SHEAR_FACTOR = 0.9
"""κ of a round section, from the energy of the parabolic shear stress along its load."""


class Compliances(NamedTuple):
    """What a section gives way by, in the blade's units; arrays over places of its thickness.

    ``axial``, ``shear_y``, ``shear_z`` are EI/(l² EA), EI/(l² κGA). Bending about y is ``bend_y``,
    about z ``bend_z + bend_z_edge · 12 (t − ½)²`` at the share t of a flexible stretch: its clamps
    keep a wide blade flat, its middle narrows; ``curl`` is the ``width`` by which curvature and
    twist flatten it besides. ``torsion`` is GJ/(a EI), ``warping`` E'Γ/(EI l²) and ``spin``
    EI/(G I_p) with ``apart`` a = 1 − J/I_p, or GJ/EI, 0, 0 and 1 where ends may warp; ``polar``
    I_p/(A l²), ``fibres`` ½E(∫r⁴ − I_p²/A)/(EI l²) without what curling has of it, so that the
    torque of a twist rate τ is ``torsion τ + polar N τ + fibres τ³ − (warping (τ/a)')'/a`` and that
    of curling. A torque twists the section by ``spin`` of it besides, which warping takes no part
    in (Benscoter's torsion: :func:`flexcli.formulas.restrained_torsion.restrained_stiffness`; the
    warping is τ/a).
    """

    axial: Floats
    shear_y: Floats
    shear_z: Floats
    bend_y: Floats
    bend_z: Floats
    bend_z_edge: Floats
    curl: Floats
    torsion: Floats
    warping: Floats
    apart: Floats
    spin: Floats
    polar: Floats
    fibres: Floats


_REMEMBERED = 64
"""Blades whose sections are kept: those of a few layouts, each solved in many states."""


@dataclass(frozen=True, eq=False)
class Section:
    """A blade's sections: ``at`` gives the compliances of thicknesses [m], or diameters.

    ``stretches`` are its flexible pieces, in groups between which it is rigid.
    """

    EI: float
    l: float
    nu: float
    stretches: list[list[Piece]]
    at: Callable[[Floats], Compliances]


@lru_cache(maxsize=_REMEMBERED)
def section_of(blade: SpaceBlade | SpaceRod, effects: BeamEffects) -> Section:
    """Return the sections of a blade of any profile, or of a round rod."""
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    return _rod(blade, l, effects) if isinstance(blade, SpaceRod) else _strip(blade, l, effects)


def _rod(rod: SpaceRod, l: float, effects: BeamEffects) -> Section:
    EI = rod.material.E * rod.bent
    found = partial(_of_rod, rod, l, effects, EI)
    return Section(EI, l, rod.material.nu, Constant(rod.d).stretches(l), found)


def _of_rod(rod: SpaceRod, l: float, effects: BeamEffects, EI: float, d: Floats) -> Compliances:
    E, G, A, I = rod.material.E, rod.material.G, rod.area, rod.bent
    one, none = np.ones_like(d), np.zeros_like(d)
    plate, along_load = _Plate(), ROUND_SHEAR_FACTOR * A
    if isinstance(rod, SpaceStar):
        plate = _of_sheet(rod.b, l, rod.material) if effects.plate else plate
        along_load = SHEAR_FACTOR * rod.b * rod.h * rod.strips / 2.0
    shear = effects.shear * EI / (G * along_load * l**2) * (1.0 - plate.even)
    return Compliances(
        axial=one * effects.extension * EI / (E * A * l**2) / plate.stretched,
        shear_y=one * shear,
        shear_z=one * shear,
        bend_y=one / plate.flat,
        bend_z=one / plate.flat,
        bend_z_edge=none,
        curl=none,
        torsion=one * G * rod.torsion / EI,
        warping=none,
        apart=one,
        spin=none,
        polar=one * effects.long_fibres * 2.0 * I / (A * l**2),
        fibres=one * effects.long_fibres * E / 2.0 * (rod.fourth - 4.0 * I**2 / A) / (EI * l**2),
    )


class _Plate(NamedTuple):
    """What rigid clamps do to a stretch that is wider than thick, factors over the beam's [-].

    ``even`` is the share of shear across the width that clamps hold back, ``curls`` the thickness
    at which its section does [m].
    """

    pure: float = 1.0
    guided: float = 1.0
    stretched: float = 1.0
    flat: float = 1.0
    even: float = 0.0
    curls: float = 0.0


def _strip(blade: SpaceBlade, l: float, effects: BeamEffects) -> Section:
    stretches = blade.profile.stretches(l)
    ends = np.array([-1.0, 1.0])
    thin = min(float(np.min(piece.thickness(ends))) for each in stretches for piece in each)
    EI = blade.material.E * second_moment(blade.b, thin)
    effects = effects.and_(blade.feels)
    plate = _plate(blade, l, thin, effects) if effects.plate and blade.b > thin else _Plate()
    at = partial(_of_strip, blade, l, effects, plate, EI)
    return Section(EI, l, blade.material.nu, stretches, at)


def _plate(blade: SpaceBlade, l: float, h: float, effects: BeamEffects) -> _Plate:
    """Return the factors of constant thickness and of tapers, or of a hinge's plate in bending.

    What stretching and shear across the width feel of a short throat's clamps is left out, and so
    is its curling where its thickness varies: there it is too short.
    """
    b, nu, profile = blade.b, blade.material.nu, blade.profile
    curls = h * (effects.long_fibres and effects.curling and not isinstance(profile, Tabulated))
    if isinstance(profile, Notch | Filleted):
        numbers = tuple(float(each) for each in vars(profile).values())
        bent = wide_hinge(type(profile), numbers, l, b, nu).stiffness
        return _Plate(bent, bent, curls=curls * isinstance(profile, Filleted))
    hinge = float(profile.hinge) if isinstance(profile, NeckedDown) else l
    at = {"b": b * blade.material.wider, "l": hinge, "poisson_ratio": nu}
    return _of_sheet(b, hinge, blade.material)._replace(
        pure=float(plate_factors.pure_bending_factor(**at, h=h)),
        guided=float(plate_factors.guided_factor(**at, h=h)),
        curls=curls,
    )


def _of_sheet(b: float, l: float, material: Isotropic | Directed) -> _Plate:
    """Return what clamps do to a strip in its own plane."""
    nu, wide, sheared = material.nu, b * material.wider, material.shear
    at = {"b": wide, "l": l, "poisson_ratio": nu}
    flat = float(sheet_factors.bending_factor(**at))
    Phi = 2.4 * (1.0 + nu) / sheared * (wide / l) ** 2
    # the shear compliance that, beside this bending, gives the S shape in the plane
    aside = float(sheet_factors.guided_factor(**at, shear=sheared))
    even = 1.0 - ((1.0 + Phi) / aside - 1.0 / flat) / Phi
    return _Plate(stretched=float(sheet_factors.axial_factor(**at)), flat=flat, even=even)


def _of_strip(
    blade: SpaceBlade, l: float, effects: BeamEffects, plate: _Plate, EI: float, h: Floats
) -> Compliances:
    b, E, G, nu = blade.b, blade.material.E, blade.material.G, blade.material.nu
    A, bent, wide = h * b, second_moment(b, h), second_moment(h, b)
    # ∫(bend_z + 12 edge (t − ½)²) dt = 1/pure, 12 ∫(t − ½)² (…) dt = 1/guided
    edge = (1.0 / plate.guided - 1.0 / plate.pure) / 0.8
    shear = effects.shear * EI / (SHEAR_FACTOR * G * A * l**2)
    I_p, J = bent + wide, torsion_constant(h, b)
    held = effects.warping and not blade.warps_freely
    curls = h == plate.curls
    fourth = rectangle_fourth_moment(h, b) - I_p**2 / A - curls * h * b**5 / 180.0
    apart = 1.0 - held * J / I_p
    return Compliances(
        axial=effects.extension * EI / (E * A * l**2) / plate.stretched,
        shear_y=shear,
        shear_z=shear * (1.0 - plate.even),
        bend_y=EI / (E * wide) / plate.flat,
        bend_z=EI / (E * bent) * (1.0 / plate.pure - edge),
        bend_z_edge=EI / (E * bent) * edge,
        curl=curls * 3.0 * (1.0 - nu**2) * (b**2 / (h * l)) ** 2,
        torsion=G * J / apart / EI,
        warping=held * E / (1.0 - nu**2) * warping(h, b).constant / (EI * l**2),
        apart=apart,
        spin=held * EI / (G * I_p),
        polar=effects.long_fibres * I_p / (A * l**2),
        fibres=effects.long_fibres * E / 2.0 * fourth / (EI * l**2),
    )
