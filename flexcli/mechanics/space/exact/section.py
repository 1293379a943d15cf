"""Sections of blades and rods of constant thickness: compliances in units of the blade.

Lengths by its length l, forces by EI/l², moments by EI/l, with EI = E b h³/12 that of bending
across the thickness (of a round rod: π E d⁴/64). Axes: x along the blade, y across its thickness,
z across its width.
"""

from math import pi
from typing import NamedTuple

import numpy as np

from flexcli.errors import SolveError
from flexcli.formulas import plate_factors, sheet_factors
from flexcli.formulas.profile import Constant, NeckedDown
from flexcli.formulas.section import second_moment
from flexcli.formulas.torsion_fibres import rectangle_fourth_moment
from flexcli.formulas.torsion_section import torsion_constant, warping
from flexcli.formulas.torsion_shapes import circle_torsion_constant
from flexcli.mechanics.mesh import SHEAR_FACTOR
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod

__all__ = ["BeamEffects", "Section", "section_of", "thickness"]

ROUND_SHEAR_FACTOR = 0.9
"""κ of a round section, from the energy of the parabolic shear stress along its load."""


class BeamEffects(NamedTuple):
    """What a blade feels besides bending and Saint-Venant's torsion.

    ``plate`` multiplies bending, stretching and shear by what rigid clamps do to a wide blade;
    ``warping`` keeps clamped ends from warping, ``long_fibres`` is the stretch of the fibres that
    twist makes into helices (Wagner's term). ``curling`` joins it with the flattening of a curved
    section (:mod:`flexcli.mechanics.space.exact.section_law`); where a blade bends to and fro, it
    costs more nodes.
    """

    extension: bool = True
    shear: bool = True
    plate: bool = True
    warping: bool = True
    long_fibres: bool = True
    curling: bool = True


class Section(NamedTuple):
    """A blade's section: compliances in the blade's units, and its flexible stretches.

    ``stretches`` are starts and ends of flexible pieces over the length. ``axial``, ``shear_y``,
    ``shear_z`` are EI/(l² EA), EI/(l² κGA). Bending about y is ``bend_y`` everywhere, about z
    ``bend_z + bend_z_edge · 12 (t − ½)²`` at the share t of a piece: its clamps keep a wide
    blade flat, its middle narrows; ``curl`` is the ``width`` by which curvature and twist flatten
    it besides. ``torsion`` is GJ/(a EI), ``warping`` E'Γ/(a² EI l²) and ``spin`` EI/(G I_p) with
    a = 1 − J/I_p, or GJ/EI, 0 and 0 where ends may warp; ``polar`` I_p/(A l²), ``fibres``
    ½E(∫r⁴ − I_p²/A)/(EI l²) without what curling has of it, so that the torque of a twist rate τ
    is ``torsion τ + polar N τ + fibres τ³ − (warping τ')'`` and that of curling. A torque twists
    the section by ``spin`` of it besides, which warping takes no part in (Benscoter's torsion:
    :func:`flexcli.formulas.restrained_torsion.restrained_stiffness`; the warping is τ/a).
    """

    EI: float
    l: float
    stretches: tuple[tuple[float, float], ...]
    axial: float
    shear_y: float
    shear_z: float
    bend_y: float
    bend_z: float
    bend_z_edge: float
    curl: float
    nu: float
    torsion: float
    warping: float
    spin: float
    polar: float
    fibres: float


def section_of(blade: SpaceBlade | SpaceRod, effects: BeamEffects) -> Section:
    """Return the section of a blade of constant thickness, of two hinges, or of a round rod.

    Raises
    ------
    SolveError
        When the thickness varies along a flexible piece.

    """
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    return _rod(blade, l, effects) if isinstance(blade, SpaceRod) else _strip(blade, l, effects)


def _rod(rod: SpaceRod, l: float, effects: BeamEffects) -> Section:
    E, G = rod.material.E, rod.material.G
    A, I = pi * rod.d**2 / 4.0, pi * rod.d**4 / 64.0
    EI = E * I
    shear = effects.shear * EI / (ROUND_SHEAR_FACTOR * G * A * l**2)
    return Section(
        EI=EI,
        l=l,
        stretches=((0.0, 1.0),),
        axial=effects.extension * EI / (E * A * l**2),
        shear_y=shear,
        shear_z=shear,
        bend_y=1.0,
        bend_z=1.0,
        bend_z_edge=0.0,
        curl=0.0,
        nu=rod.material.nu,
        torsion=G * circle_torsion_constant(rod.d) / EI,
        warping=0.0,
        spin=0.0,
        polar=effects.long_fibres * 2.0 * I / (A * l**2),
        # ∫r⁴ = π d⁶/192, I_p²/A = π d⁶/256
        fibres=effects.long_fibres * E / 2.0 * pi * rod.d**6 / 768.0 / (EI * l**2),
    )


def thickness(blade: SpaceBlade, l: float) -> tuple[float, float]:
    """Return the thickness and the length of the flexible pieces of a blade of length l [m].

    Raises
    ------
    SolveError
        When the thickness varies along a flexible piece.

    """
    match blade.profile:
        case Constant(h=h):
            return float(h), l
        case NeckedDown(h=h, hinge=hinge):
            return float(h), float(hinge)
    raise SolveError(
        "varying-thickness",
        f"{blade.name}: the thickness varies along a flexible piece",
        "in space, exact beams have pieces of constant thickness; the linear model takes any "
        "profile",
    )


def _strip(blade: SpaceBlade, l: float, effects: BeamEffects) -> Section:
    h, hinge = thickness(blade, l)
    stretches = ((0.0, 1.0),) if hinge == l else ((0.0, hinge / l), (1.0 - hinge / l, 1.0))
    b, E, G, nu = blade.b, blade.material.E, blade.material.G, blade.material.nu
    A, EI, EI_wide = h * b, E * second_moment(b, h), E * second_moment(h, b)
    at = {"b": b, "l": hinge, "poisson_ratio": nu}
    pure = guided = stretched = flat = 1.0
    even = 0.0
    if effects.plate and b > h:
        pure = float(plate_factors.pure_bending_factor(**at, h=h))
        guided = float(plate_factors.guided_factor(**at, h=h))
        stretched = float(sheet_factors.axial_factor(**at))
        flat = float(sheet_factors.bending_factor(**at))
        Phi = 2.4 * (1.0 + nu) * (b / hinge) ** 2
        # the shear compliance that, beside this bending, gives the S shape in the plane
        even = 1.0 - ((1.0 + Phi) / float(sheet_factors.guided_factor(**at)) - 1.0 / flat) / Phi
    # ∫(bend_z + 12 edge (t − ½)²) dt = 1/pure, 12 ∫(t − ½)² (…) dt = 1/guided
    edge = (1.0 / guided - 1.0 / pure) / 0.8
    shear = effects.shear * EI / (SHEAR_FACTOR * G * A * l**2)
    I_p = second_moment(b, h) + second_moment(h, b)
    curls = effects.plate and effects.long_fibres and effects.curling and b > h
    fourth = rectangle_fourth_moment(h, b) - I_p**2 / A - curls * h * b**5 / 180.0
    J = float(torsion_constant(h, b))
    apart = 1.0 - effects.warping * J / I_p
    held = effects.warping * E / (1.0 - nu**2) * float(warping(h, b).constant)
    return Section(
        EI=EI,
        l=l,
        stretches=stretches,
        axial=effects.extension * EI / (E * A * l**2) / stretched,
        shear_y=shear,
        shear_z=shear * (1.0 - even),
        bend_y=EI / EI_wide / flat,
        bend_z=1.0 / pure - edge,
        bend_z_edge=edge,
        curl=curls * 3.0 * (1.0 - nu**2) * (b**2 / (h * l)) ** 2,
        nu=nu,
        torsion=G * J / apart / EI,
        warping=held / apart**2 / (EI * l**2),
        spin=effects.warping * EI / (G * I_p),
        polar=effects.long_fibres * I_p / (A * l**2),
        fibres=effects.long_fibres * E / 2.0 * fourth / (EI * l**2),
    )
