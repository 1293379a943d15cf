"""Materials whose stiffness depends on the direction: crystals, orthotropic sheets, their cut."""

from collections.abc import Iterable
from dataclasses import replace
from math import atan2, cos, hypot, sin, sqrt
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from flexcli.formulas.anisotropy import (
    StripConstants,
    cubic_stiffness,
    in_plane_compliance,
    orthotropic_stiffness,
    plate_anisotropy,
    sheared_in_plane,
    strip_constants,
    turned_stiffness,
)
from flexcli.formulas.card import outside
from flexcli.formulas.clamped_blade import NARROWER, Across
from flexcli.formulas.directed_plates import is_compared
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import Directed, SpaceBlade, SpaceLayout, SpaceRod
from flexcli.numerics.rows import Number, larger, number, of_each, one_by_one
from flexcli.parts.base import Angle, Part, QuantityOf, Stress, spec_error
from flexcli.parts.sourced import WithSource

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout

__all__ = [
    "Blades",
    "Crystal",
    "Orientation",
    "Orthotropic",
    "blades_of",
    "laid",
    "laid_in_plane",
    "stiffness_in",
    "thickness_of",
]

Floats = NDArray[np.float64]

WAFERS = {
    "100": ((1.0, 1.0, 0.0), (0.0, 0.0, 1.0)),
    "110": ((1.0, -1.0, 0.0), (1.0, 1.0, 0.0)),
    "111": ((1.0, -1.0, 0.0), (1.0, 1.0, 1.0)),
}
"""A direction ⟨110⟩ in each wafer, that of its flat, and its normal."""

ALIKE = 1e-9
"""Relative difference of the blades' moduli that counts as rounding [-]."""


SHEARED, SHRUNK = 4.0, 0.42
"""Limits of the comparison of anisotropic blades with solids: shear modulus over the isotropic one
or its inverse, and Poisson's ratio."""

MOST_NU = 0.5
"""Poisson's ratio that no isotropic material reaches, as which plates are taken."""

TWISTS = 1e-6
"""Share S_15²/(S_11 S_55) up to which a blade does not twist as it bends."""


class Crystal(WithSource):
    """A cubic crystal by its stiffness along the cube's edges."""

    c11: Stress
    """Stiffness along an edge, e.g. ``165.7 GPa``."""
    c12: Annotated[float, QuantityOf("stress")]
    """Stress across an edge by a strain along it, e.g. ``63.9 GPa``."""
    c44: Stress
    """Shear stiffness, e.g. ``79.6 GPa``."""

    @model_validator(mode="after")
    def _is_stable(self) -> "Crystal":
        _refuse_unstable(self)
        return self

    def stiffness(self) -> Floats:
        """Return the stiffness along the axes of the crystal (6, 6) [Pa]."""
        return cubic_stiffness(self.c11, self.c12, self.c44)

    def frame(self, orientation: "Orientation") -> Floats:
        """Return rows: the reference direction, that across it in the wafer, the normal."""
        x, n = (np.array(each) / np.linalg.norm(each) for each in WAFERS[orientation.wafer])
        return np.stack([x, np.cross(n, x), n])


class Orthotropic(WithSource):
    """An orthotropic sheet by its constants in its plane."""

    E_1: Stress
    """Young's modulus along its first axis, e.g. ``140 GPa``."""
    E_2: Stress
    """Young's modulus across it, e.g. ``10 GPa``."""
    G_12: Stress
    """Shear modulus in its plane, e.g. ``5 GPa``."""
    nu_12: Annotated[float, QuantityOf("ratio", above=-1.0, below=2.0)]
    """Shrinking across per stretch along the first axis, e.g. ``0.3``."""

    @model_validator(mode="after")
    def _is_stable(self) -> "Orthotropic":
        _refuse_unstable(self)
        return self

    def stiffness(self) -> Floats:
        """Return the stiffness along the axes of the sheet (6, 6) [Pa]."""
        return orthotropic_stiffness(E_1=self.E_1, E_2=self.E_2, G_12=self.G_12, nu_12=self.nu_12)

    def frame(self, orientation: "Orientation") -> Floats:
        """Return rows: its first axis, its second, its normal."""
        return np.eye(3)


def _refuse_unstable(part: Crystal | Orthotropic) -> None:
    try:
        part.stiffness()
    except ValueError as error:
        raise spec_error(str(error), "check the constants and their units") from error


class Orientation(Part):
    """How blades lie in a wafer or sheet."""

    wafer: Literal["100", "110", "111"] = "100"
    """Plane of the wafer of a crystal, e.g. ``"110"``."""
    turned: Angle = 0.0
    """Angle in the wafer from its flat along <110>, or from a sheet's first axis, to x: along the
    blades of a stage, a pivot's axis of symmetry, x of a drawing, e.g. ``turned: 45 deg``.
    """
    width: Literal["normal", "in-plane"] = "normal"
    """Where the width of blades points: along the normal of the wafer, from which they are cut
    through, or in its plane, of blades that are thinned; these all lie along x, e.g. ``in-plane``.
    """


class Blades(NamedTuple):
    """Common elastic constants of the blades of a joint.

    ``E`` [Pa] and ``nu`` stand for all; ``spread`` is the relative error of a stiffness with them,
    ``sheared`` the further one of torsion and shear, ``uneven`` the share of it by which blades
    differ from each other, ``least_nu`` the least Poisson's ratio of any beside ``nu``, the most.
    ``thick`` are further errors over (h/l)² and over h/l; ``skewed`` is by how much a shear stress
    stretches a blade, over what as much along it does. Where clamps keep blades from twisting they
    are as much as ``held`` stiffer, and their stress is as much as ``stressed`` higher [-].
    ``planes`` are the compliances (3, 3) of blades in the plane of their faces, along, across and
    of shear [1/Pa]: of each direction, and of none where they were not compared with solids.
    """

    E: float
    nu: float
    spread: float
    sheared: float
    uneven: float
    least_nu: float
    thick: tuple[float, float]
    skewed: float
    held: float
    stressed: float
    planes: tuple[Floats, ...] = ()


def blades_of(
    sheet: Crystal | Orthotropic, orientation: Orientation | None, angles: Iterable[float]
) -> Blades:
    """Return the common elastic constants of blades at angles from x [rad].

    Plates and clamps are taken as isotropic ones with Poisson's ratio √(ν_13 ν_31), which is exact
    for very wide blades; their distance from that, times the largest effect of a plate, is in the
    error.
    """
    if orientation is not None and orientation.width == "in-plane":
        angles = [0.0]
    angles = tuple(dict.fromkeys(angles)) or (0.0,)
    each = [strip_of(sheet, orientation, angle) for angle in angles]
    moduli = [strip.E for strip in each]
    E = (min(moduli) + max(moduli)) / 2.0
    first = max(each, key=lambda strip: abs(strip.nu))
    wide = 1.0 / (1.0 - first.nu**2) - 1.0
    uneven = (max(moduli) - min(moduli)) / (2.0 * E)
    uneven = uneven if uneven > ALIKE else 0.0
    least = min(each, key=lambda strip: abs(strip.nu))
    rough = wide * max(plate_anisotropy(strip) for strip in each)
    sheared = max(abs(s.G_wide * 2.0 * (1.0 + first.nu) / E - 1.0) for s in each)
    squares, firsts = zip(*map(sheared_in_plane, each), strict=True)
    thick = max(squares), max(firsts)
    skewed = max(sqrt(strip.skews * strip.E / strip.G_thin) for strip in each)
    held = max(s.held for s in each)
    stressed = max((1.0 + s.held) * sqrt(1.0 + 3.0 * s.sheared_held**2) for s in each) - 1.0
    planes = tuple[Floats, ...]()
    if all(map(is_compared, each)):
        C = sheet.stiffness()
        planes = tuple(in_plane_compliance(C, _axes(sheet, orientation, a)) for a in angles)
    return Blades(
        E, first.nu, uneven + rough, sheared, uneven, least.nu, thick, skewed, held, stressed,
        planes,
    )  # fmt: skip


def strip_of(
    sheet: Crystal | Orthotropic, orientation: Orientation | None, angle: float
) -> StripConstants:
    """Return the constants of a blade at an angle from x [rad]; of a thinned one, along x."""
    thinned = orientation is not None and orientation.width == "in-plane"
    axes = _axes(sheet, orientation, 0.0 if thinned else angle)
    return strip_constants(sheet.stiffness(), axes)


def _axes(sheet: Crystal | Orthotropic, orientation: Orientation | None, angle: float) -> Floats:
    """Return rows: along a blade at an angle from x [rad], across it, across its width."""
    lie = Orientation() if orientation is None else orientation
    frame = sheet.frame(lie)
    c, s = cos(lie.turned), sin(lie.turned)
    along, aside, normal = c * frame[0] + s * frame[1], c * frame[1] - s * frame[0], frame[2]
    across, width = (normal, -aside) if lie.width == "in-plane" else (aside, normal)
    c, s = cos(angle), sin(angle)
    return np.stack([c * along + s * across, c * across - s * along, width])


class Thickness(NamedTuple):
    """How thick the blades of a joint are: the largest h/l, and the largest l [m]."""

    slender: Number
    longest: Number


def thickness_of(layout: "Layout") -> Thickness:
    """Return how thick the blades of a layout are.

    One whose thickness varies counts as one that is as thin as its throat and bends as much.
    """
    from flexcli.mechanics.mesh import Effects, meshes

    each = meshes(layout, Effects(), 1)
    slender = [of_each((m.thinnest / (m.flexible * m.l)).max(axis=1)) for m in each]
    return Thickness(larger(slender), larger(of_each(m.l.max(axis=1)) for m in each))


def stiffness_in(
    sheet: Crystal | Orthotropic, orientation: Orientation | None, turned: float
) -> Floats:
    """Return the stiffness in the axes of a layout turned by an angle from its drawing [rad, Pa].

    z is along the width of all blades.
    """
    return turned_stiffness(sheet.stiffness(), _axes(sheet, orientation, -turned))


def laid(
    layout: SpaceLayout,
    sheet: Crystal | Orthotropic,
    orientation: Orientation | None,
    turned: float,
    stiffer: float,
) -> SpaceLayout:
    """Return a layout in which each blade has the elastic constants of its direction.

    ``turned`` is the angle by which the layout is turned from the axes of its drawing [rad],
    ``stiffer`` the ratio of its moduli to those at assembly. It is returned unchanged where any
    member is of a kind whose springs were not compared with solids.
    """
    found = []
    for blade in layout.blades:
        if isinstance(blade, SpaceRod) or not isinstance(blade.profile, Constant):
            return layout
        material = _directed(blade, blade.profile, sheet, orientation, turned, stiffer)
        if material is None:
            return layout
        found.append(replace(blade, material=material))
    return replace(layout, blades=tuple(found))


def laid_in_plane(
    layout: "Layout",
    sheet: Crystal | Orthotropic,
    orientation: Orientation | None,
    turned: float,
    E: float,
) -> "Layout":
    """Return a layout of a plane in which each blade is as stiff along itself as its direction.

    ``turned`` is as in :func:`laid`, ``E`` the Young's modulus that stands for all [Pa].
    """

    def stiffer(angle: float) -> float:
        return strip_of(sheet, orientation, angle).E / E

    blades = []
    for blade in layout.blades:
        x, y = (end - start for start, end in zip(blade.start, blade.end, strict=True))
        angle = number(np.arctan2(y, x)) - turned
        blades.append(replace(blade, stiffer=one_by_one(stiffer, angle)))
    return replace(layout, blades=tuple(blades))


def _directed(
    blade: SpaceBlade,
    profile: Constant,
    sheet: Crystal | Orthotropic,
    orientation: Orientation | None,
    turned: float,
    stiffer: float,
) -> Directed | None:
    x, y = (float(e) - float(s) for s, e in zip(blade.start[:2], blade.end[:2], strict=True))
    strip = strip_of(sheet, orientation, atan2(y, x) - turned)
    wider = (strip.E / strip.E_width) ** 0.25
    gamma = 2.0 * (1.0 + strip.nu) * strip.G_wide * wider**2 / strip.E
    h, l, b = float(np.ravel(profile.h)[0]), hypot(x, y), max(1.0, wider) * blade.b
    compared = (
        1.0 / SHEARED <= gamma <= SHEARED
        and 0.0 <= strip.nu <= SHRUNK
        and strip.twists <= TWISTS
        and h <= blade.b
        and not outside(NARROWER, {"h/l": h / l, "b/l": b / l})
    )
    if not compared:
        return None
    E, G, G_thin = (stiffer * modulus for modulus in (strip.E, strip.G_wide, strip.G_thin))
    density = blade.material.density
    return Directed(E, G, density, Across(strip.nu, wider, G_thin, strip.skews))


def stated(data: dict[str, Any]) -> dict[str, Any]:
    """Return a material as a spec states it, with the moduli along x derived from its sheet."""
    kinds: dict[str, type[Crystal] | type[Orthotropic]]
    kinds = {"crystal": Crystal, "orthotropic": Orthotropic}
    (key,) = kinds.keys() & data.keys()
    found = {**data, "youngs_modulus": "1 GPa"}
    try:
        sheet = kinds[key].model_validate(data[key])
        orientation = Orientation.model_validate(data.get("orientation", {}))
    except ValueError:
        return found  # which its own field tells
    blades = blades_of(sheet, orientation, [0.0])
    if blades.nu >= MOST_NU:
        raise spec_error(
            f"blades along x are as wide plates of Poisson's ratio {blades.nu:.3g}, which no "
            "isotropic plate has",
            "turn them otherwise, or lay their width across the sheet: width: normal",
            at=("orientation" if "orientation" in data else key,),
        )
    source = {"status": sheet.status, "source": sheet.source}
    found["youngs_modulus"] = {"value": f"{blades.E!r} Pa", **source}
    found["poisson_ratio"] = {"value": blades.nu, **source}
    return found
