"""Linkage: rigid links on pivots and stages, each of which has its own sizes."""

from collections import namedtuple
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from math import atan2, cos, pi, sin
from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from flexcli.errors import SolveError
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.mechanics.layout import Body, Layout, Point
from flexcli.mechanics.linkages.extremes import Extremes, extremes
from flexcli.mechanics.linkages.linkage import Linkage, Prismatic, Revolute
from flexcli.mechanics.linkages.travel import Travel, motion, travel
from flexcli.parts.base import Angle, Length, Part, spec_error
from flexcli.parts.bending import CompliantClamps, Thick, WideBlades
from flexcli.parts.bending.thick import thick_linked
from flexcli.parts.bending.wide import wide_linked
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.any_flexure import AnyFlexure
from flexcli.parts.geometries.base import GROUND, MOVING, Extent, Floats, Geometry, Sizes
from flexcli.results import Value
from flexcli.units import show

__all__ = ["LinkageGeometry"]

ROUNDING = 1e-9
"""Mean of a joint's range, over its amplitude, that counts as zero."""

Rows = tuple[tuple[float, float], tuple[float, float]]
Place = tuple[Length, Length]
Direction = tuple[float, float]
Name = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9]*$")]


class LinkageJoint(Part):
    """A joint between two links: a pivot at a point, or a stage along a direction.

    A joint without a flexure is ideal: it guides and has no stiffness. ``turned`` is the angle
    from x to the flexure's axis of symmetry.
    """

    links: tuple[Name, Name]
    """The two links that it joins, e.g. ``[crank, base]``."""
    at: Place = (0.0, 0.0)
    """Point of the joint in the drawing, x and y, e.g. ``[0 mm, 0 mm]``."""
    along: Direction | None = None
    """Direction of a stage, as x and y; a pivot has none, e.g. ``[0, 1]``."""
    flexure: AnyFlexure | None = None
    """The pivot or stage that the joint is; left out, it is ideal,
    e.g. ``{kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 0.1 mm, l: 15 mm, b: 5 mm}``.
    """
    turned: Angle = 0.0
    """Angle from x to the flexure's axis of symmetry, e.g. ``90 deg``."""

    @model_validator(mode="after")
    def _flexure_fits(self) -> "LinkageJoint":
        wanted = "rotation" if self.along is None else "translation"
        if self.along == (0.0, 0.0):
            raise spec_error("this direction has no length", "write e.g. [1, 0]", at=("along",))
        if self.flexure is not None and self.flexure.motion != wanted:
            hint = "give along: [1, 0] for a stage" if wanted == "rotation" else "take a stage"
            raise spec_error(
                f"a {self.flexure.name} makes no {wanted}", hint, at=("flexure", "kind")
            )
        return self

    @property
    def angle(self) -> float:
        """Return the turn of the flexure's frame, in which a stage moves along y [rad]."""
        return self.turned if self.along is None else atan2(*reversed(self.along)) - pi / 2.0


class LinkageGeometry(Geometry):
    """Rigid links on joints; the stroke is that of the input joint, from the assembled pose."""

    is_linear: ClassVar[bool] = False
    source: ClassVar[str] = "rigid links, each joint by its own closed form"

    kind: Literal["linkage"]
    ground: Name
    """Link that stands still, e.g. ``base``."""
    input: Name
    """Joint that the stroke moves, e.g. ``theta``."""
    joints: Annotated[dict[Name, LinkageJoint], Field(min_length=2, max_length=100)]
    """Joints by names of your own, each between two links,
    e.g. ``{theta: {links: [crank, base]}, beta: {links: [rod, crank], at: [0 mm, 50 mm]},
    alpha: {links: [rod, stage], at: [-50 mm, 50 mm]}, z: {links: [base, stage], along: [1, 0]}}``.
    """

    @model_validator(mode="after")
    def _moves(self) -> "LinkageGeometry":
        try:
            motion(self.rigid, 0.0)
        except ValueError as error:
            raise spec_error(str(error), "check links, ground and input") from error
        except SolveError as error:
            raise spec_error(str(error), error.remedy) from error
        return self

    @cached_property
    def rigid(self) -> Linkage:
        """Return the linkage as rigid links."""
        joints = tuple(
            Revolute(name, *joint.links, joint.at)
            if joint.along is None
            else Prismatic(name, *joint.links, joint.along)
            for name, joint in self.joints.items()
        )
        return Linkage(joints, self.ground, self.input)

    # which motion it is depends on its input: no constant of the class, as it is elsewhere
    @property
    def motion(self) -> str:  # type: ignore[override]
        """Return the kind of motion of the input."""
        return "rotation" if self.joints[self.input].along is None else "translation"

    # nor is whether its closed forms are posynomials, which its flexures decide
    @property
    def posynomial(self) -> bool:  # type: ignore[override]
        """Return whether all its flexures are."""
        return all(flexure.posynomial for _, flexure in self.flexures())

    def flexures(self) -> Iterator[tuple[str, Geometry]]:
        """Yield the joints that are flexures, by name."""
        for name, joint in self.joints.items():
            if joint.flexure is not None:
                yield name, joint.flexure

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the extents of every flexure's sizes, by symbol and joint."""
        return {
            f"{size}_{name}": extent
            for name, flexure in self.flexures()
            for size, extent in flexure.extents.items()
        }

    def label(self, name: str) -> str:
        """Return the name of a size, in words."""
        joint = self._owner(name)
        return f"{self._flexure(joint).label(name.removesuffix(f'_{joint}'))} at {joint}"

    def place(self, name: str) -> tuple[str, ...]:
        """Return the place of a size in the spec: in the flexure of its joint."""
        joint = self._owner(name)
        return "geometry", "joints", joint, "flexure", name.removesuffix(f"_{joint}")

    def _owner(self, name: str) -> str:
        return name.rpartition("_")[2]

    def _flexure(self, name: str) -> Geometry:
        flexure = self.joints[name].flexure
        assert flexure is not None  # only joints with a flexure have sizes
        return flexure

    def sized(self, values: Mapping[str, Quantity]) -> Sizes:
        """Return the sizes of all flexures; what is fixed stays so."""
        found = {name: values.get(name, extent.fixed) for name, extent in self.extents.items()}
        return namedtuple("LinkageSizes", found)(**found)

    def sizes_of(self, joint: str, sizes: Sizes) -> Sizes:
        """Return the sizes of one joint's flexure."""
        flexure = self._flexure(joint)
        return flexure.sized({n: getattr(sizes, f"{n}_{joint}") for n in flexure.extents})

    def _followed(self, start: float, end: float) -> Travel:
        found = travel(self.rigid, start, end)
        for stop in (found.low, found.high):
            if stop.end.name != "RANGE":
                raise NotAvailable(
                    f"stops at {stop.input:.6g} of its input {self.input}: {stop.end.value}"
                )
        return found

    def joint_deflections(self, inputs: Floats) -> Mapping[str, tuple[str, Floats]]:
        """Return the deflections of every joint but the input itself."""
        return {
            name: ("rad" if self.joints[name].along is None else "m", found)
            for name, found in motion(self.rigid, inputs).deflections.items()
            if name != self.input
        }

    def deflections(self, start: float, end: float) -> dict[str, Extremes]:
        """Return the extremes of every joint's deflection over a range of the input."""
        known = self._known_deflections
        if (start, end) not in known:
            known[start, end] = extremes(self._followed(start, end), start, end)
        return known[start, end]

    @cached_property
    def _known_deflections(self) -> dict[tuple[float, float], dict[str, Extremes]]:
        """Return the deflections computed so far, by the range; every stress needs them."""
        return {}

    def stiffness(self, elastic: Elastic, sizes: Sizes) -> Computed:
        """Return the stiffness of the joints as seen from the input at rest."""
        ratios = motion(self.rigid, 0.0).ratios
        found: Quantity = 0.0
        for name, flexure in self.flexures():
            own = flexure.stiffness(elastic, self.sizes_of(name, sizes))
            found = found + own * float(ratios[name]) ** 2
        return found

    def stroke_stresses(
        self, elastic: Elastic, sizes: Sizes, amplitude: float, middle: float
    ) -> tuple[dict[str, Computed], dict[str, Computed]]:
        """Return amplitude and mean of the stress at each place of every joint [Pa].

        Each joint has its own range, whose middle need not be its rest position.
        """
        found: tuple[dict[str, Quantity], dict[str, Quantity]] = ({}, {})
        ranges = self.deflections(middle - amplitude, middle + amplitude)
        for name, flexure in self.flexures():
            least, greatest = ranges[name].least, ranges[name].greatest
            own = self.sizes_of(name, sizes)
            turns = ((greatest - least) / 2.0, abs(greatest + least) / 2.0)
            for each, turn in zip(found, turns, strict=True):
                if turn > ROUNDING * turns[0]:
                    stresses = flexure.end_stresses(elastic, own, turn)
                    each.update({f"{name}, {place}": s for place, s in stresses.items()})
        return found

    def end_stresses(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Return the largest stress at each place of every joint [Pa], over ± the travel."""
        amplitudes, means = self.stroke_stresses(elastic, sizes, travel, 0.0)
        return {place: s + means.get(place, 0.0) for place, s in amplitudes.items()}

    def joint_of(self, place: str) -> str:
        """Return the joint that a place of :meth:`end_stresses` belongs to."""
        return place.partition(",")[0].partition(" ")[0]  # "theta blade 1, right face" too

    def wide_blades(self, sizes: Sizes, nu: float) -> WideBlades | None:
        """Return the range of the plate factors of its joints."""
        return wide_linked(
            [flexure.wide_blades(self.sizes_of(n, sizes), nu) for n, flexure in self.flexures()]
        )

    def thick_notches(self, sizes: Sizes) -> Thick | None:
        """Return the range of the factors of its joints."""
        return thick_linked([f.thick_notches(self.sizes_of(n, sizes)) for n, f in self.flexures()])

    def compliant_clamps(self, sizes: Sizes, nu: float) -> CompliantClamps | None:
        """Return the range of the changes of its joints."""
        each = [f.compliant_clamps(self.sizes_of(name, sizes), nu) for name, f in self.flexures()]
        if not any(each):
            return None
        from flexcli.parts.bending.compliant_clamps import linked_clamps

        return linked_clamps(each)

    @property
    def has_fillets(self) -> bool:
        """Return whether any of its flexures has blades with fillets."""
        return any(flexure.has_fillets for _, flexure in self.flexures())

    def with_compliant_clamps(self) -> Geometry | None:
        """Return it with such flexures where the spec does not state their clamps."""
        found = {
            name: self.joints[name].model_copy(update={"flexure": clamped})
            for name, flexure in self.flexures()
            if (clamped := flexure.with_compliant_clamps()) is not None
        }
        return self.model_copy(update={"joints": {**self.joints, **found}}) if found else None

    def has_limbs(self, elastic: Elastic, sizes: Sizes) -> bool:
        """Return True: its links are rigid parts of unstated mass."""
        return True

    def volume(self, sizes: Sizes) -> Computed:
        """Return the volume of all flexures [m³]."""
        each = [flexure.volume(self.sizes_of(n, sizes)) for n, flexure in self.flexures()]
        return sum(each[1:], each[0]) if each else 0.0

    def fits(self, sizes: Sizes) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return the conditions for every flexure to exist."""
        return tuple(
            (f"{name}: {text}", small, large)
            for name, flexure in self.flexures()
            for text, small, large in flexure.fits(self.sizes_of(name, sizes))
        )

    def ratios(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the ratios of every flexure's shape, by joint."""
        return {
            f"{ratio} {name}": value
            for name, flexure in self.flexures()
            for ratio, value in flexure.ratios(self.sizes_of(name, sizes)).items()
        }

    def radii(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the radii of all flexures, by joint."""
        return {
            f"{name}: {where}": radius
            for name, flexure in self.flexures()
            for where, radius in flexure.radii(self.sizes_of(name, sizes)).items()
        }

    def sections(self, sizes: Sizes) -> tuple[tuple[str, float, float], ...]:
        """Return the sections of all flexures: name of the joint, thickness and width [m]."""
        return tuple(
            (name, h, b)
            for name, flexure in self.flexures()
            for _, h, b in flexure.sections(self.sizes_of(name, sizes))
        )

    def slenderness(self, sizes: Sizes) -> float | None:
        """Return that of the stockiest flexure [-]."""
        found = [f.slenderness(self.sizes_of(name, sizes)) for name, f in self.flexures()]
        return max((each for each in found if each is not None), default=None)

    def length(self, sizes: Sizes) -> float:
        """Return the length of the shortest flexure [m]."""
        return min(f.length(self.sizes_of(name, sizes)) for name, f in self.flexures())

    def layout(self, elastic: Elastic, sizes: Sizes) -> Layout:
        """Return the flexures between the links; the input joint's moving link is ``moving``."""
        for name, joint in self.joints.items():
            if joint.flexure is None:
                raise NotAvailable(f"has an ideal joint {name}: give it a flexure")
        return self.plane_layout(elastic, sizes)

    def plane_layout(self, elastic: Elastic, sizes: Sizes) -> Layout:
        """Return the flexures between the links, which ideal joints to the ground may guide.

        The input turns its moving link anticlockwise or takes it along y, in its own sense: for
        that the drawing may be turned or mirrored.
        """
        layout = self._flexible(elastic, sizes, {self.ground: GROUND, self.moving: MOVING})
        guides = {MOVING if name == self.moving else name: held for name, held in self._guides()}
        return _posed(replace(layout, guides=guides), self.pose)

    @property
    def moving(self) -> str:
        """Return the link that the input moves against the ground."""
        first, second = self.joints[self.input].links
        if self.ground not in (first, second):
            raise NotAvailable("has an input between two moving links: no single body to drive")
        return first if second == self.ground else second

    @property
    def pose(self) -> Rows:
        """Return the matrix from coordinates of the spec to those of the layout."""
        moves = self.joints[self.input]
        turn = 0.0 if moves.along is None else -moves.angle
        side = -1.0 if moves.links[1] == self.ground else 1.0
        return (cos(turn), -sin(turn)), (side * sin(turn), side * cos(turn))

    def as_written(self, elastic: Elastic, sizes: Sizes) -> Layout:
        """Return its flexures between links with their names in the spec, in the spec's frame.

        Ideal joints are left out.
        """
        return self._flexible(elastic, sizes, {self.ground: GROUND})

    def _flexible(self, elastic: Elastic, sizes: Sizes, named: Mapping[str, str]) -> Layout:
        """Return the flexures between the links, some of which are called otherwise."""
        middle = self.joints[self.input].at
        bodies = [Body(named.get(name, name), middle) for name in self.rigid.moving]
        blades = []
        for name, joint in self.joints.items():
            if joint.flexure is None:
                continue
            part = joint.flexure.layout(elastic, self.sizes_of(name, sizes))
            ends = {
                GROUND: named.get(joint.links[0], joint.links[0]),
                MOVING: named.get(joint.links[1], joint.links[1]),
                **{b.name: f"{name} {b.name}" for b in part.bodies if b.name != MOVING},
            }
            bodies += [
                b._replace(name=ends[b.name], point=_placed(b.point, joint))
                for b in part.bodies
                if b.name != MOVING
            ]
            blades += [
                replace(
                    blade,
                    name=f"{name} {blade.name}",
                    first=ends[blade.first],
                    second=ends[blade.second],
                    start=_placed(blade.start, joint),
                    end=_placed(blade.end, joint),
                )
                for blade in part.blades
            ]
        return Layout(tuple(bodies), tuple(blades), elastic.E, elastic.shear)

    def _guides(self) -> Iterator[tuple[str, tuple[bool, bool, bool]]]:
        """Yield the links on ideal stages to the ground, and the motions (x, y, φ) held."""
        guided = set[str]()
        for name, joint in self.joints.items():
            if joint.flexure is not None:
                continue
            link = next((link for link in joint.links if link != self.ground), self.ground)
            if self.ground not in joint.links or joint.along is None or 0.0 not in joint.along:
                what = "is no stage along x or y on the ground"
                raise NotAvailable(f"has an ideal joint {name} that {what}: give it a flexure")
            if link in guided:
                raise NotAvailable(f"has two ideal joints on {link}: give them flexures")
            guided.add(link)
            yield link, (joint.along[0] == 0.0, joint.along[1] == 0.0, True)

    def values(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Value]:
        """Return the largest deflection of every joint over ± the travel."""
        if travel == 0.0:
            return {}
        input_unit = "rad" if self.motion == "rotation" else "m"
        found = {}
        for name, ranges in self.deflections(-travel, travel).items():
            unit = "rad" if self.joints[name].along is None else "m"
            where = f"at {self.input} = {show(ranges.at_largest, input_unit)}"
            label = f"largest deflection of {name}, {where}"
            found[f"{name}_max"] = Value(ranges.largest, unit, label, source="rigid links")
        return found


def _posed(layout: Layout, pose: Rows) -> Layout:
    """Return a layout turned about the origin and mirrored."""
    (xx, xy), (yx, yy) = pose
    if layout.guides and abs(xx * xy) > ROUNDING:
        raise NotAvailable("has an ideal joint oblique to its input: give it a flexure")
    crosswise = abs(xy) > abs(xx)

    def place(point: Point) -> Point:
        x, y = point
        return xx * x + xy * y, yx * x + yy * y

    return replace(
        layout,
        bodies=tuple(b._replace(point=place(b.point), com=place(b.com)) for b in layout.bodies),
        blades=tuple(
            replace(blade, start=place(blade.start), end=place(blade.end))
            for blade in layout.blades
        ),
        guides={
            link: (y, x, phi) if crosswise else (x, y, phi)
            for link, (x, y, phi) in layout.guides.items()
        },
    )


def _placed(point: Point, joint: LinkageJoint) -> Point:
    """Return a point of a flexure's frame where its joint stands."""
    (x, y), (c, s) = point, (cos(joint.angle), sin(joint.angle))
    return joint.at[0] + c * x - s * y, joint.at[1] + s * x + c * y
