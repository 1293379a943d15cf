"""The interface of a mechanism: the motion and load of its joints, from those of its bodies."""

from abc import abstractmethod
from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, NamedTuple

from pydantic import model_validator

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.stroke import Stroke
from flexcli.results import Note, Value

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Body, Layout
    from flexcli.mechanics.single_freedom import SingleFreedom
    from flexcli.parts.structure import Structure

__all__ = ["Damping", "Mechanism", "MechanismError", "Mode", "OutOfPlane"]


class MechanismError(ValueError):
    """A case that a mechanism cannot have; ``at`` is the key of the case at fault."""

    def __init__(self, at: str, text: str, hint: str) -> None:
        super().__init__(text)
        self.at = at
        self.hint = hint


class Mode:
    """Stiffness and mass of the one degree of freedom: f = √(k/m)/2π."""

    def __init__(self, stiffness: Quantity, mass: float) -> None:
        self.stiffness: Computed = stiffness
        self.mass = mass


class OutOfPlane(NamedTuple):
    """A mechanism on several joints as it moves out of its plane, where it is drawn.

    ``inertia`` has the moments of bodies about x and y through their centres of mass, where they
    are stated [kg·m²]; ``reach`` is a length of such a body [m].
    """

    layout: "Layout"
    inertia: Mapping[str, tuple[float, float]]
    reach: float

    @property
    def is_stated(self) -> bool:
        """Return whether every body's inertia is stated."""
        return all(body.name in self.inertia for body in self.layout.bodies if body.mass)


class Damping(Part):
    """Damping of the mechanism's own motion: a quality factor, or the ratio 1/(2Q)."""

    q: Annotated[float, QuantityOf("ratio", at_least=0.5)] | None = None
    """Quality factor Q of the mechanism's own motion; or give ratio, e.g. ``100``."""
    ratio: Annotated[float, QuantityOf("ratio", above=0.0)] | None = None
    """Damping ratio, 1/(2Q), e.g. ``ratio: 0.5 %``."""

    @model_validator(mode="after")
    def _one(self) -> "Damping":
        if (self.q is None) == (self.ratio is None):
            raise spec_error("damping is a q or a ratio", "give one of them, e.g. q: 100")
        if self.ratio is not None and self.ratio > 1.0:
            raise spec_error(
                "above critical damping nothing oscillates", "at most 1", at=("ratio",)
            )
        return self

    @property
    def quality(self) -> float:
        """Return Q."""
        return self.q if self.q is not None else 1.0 / (2.0 * (self.ratio or 1.0))


class Mechanism(Part):
    """Bodies that joints of one geometry carry."""

    joints: ClassVar[int]
    joint_motion: ClassVar[str | None]
    joint_kind: ClassVar[str | None] = None
    """The only kind of joint that it sits on."""

    damping: Damping | None = None
    """Damping of the mechanism's own motion, e.g. ``{q: 100}``."""

    @abstractmethod
    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return amplitude and mean of the travel of each joint [rad or m]."""

    @property
    def joint_travel_per_motion(self) -> float:
        """Return the travel of each joint per travel of the mechanism's driven motion."""
        return 1.0

    @abstractmethod
    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return stiffness and mass of the mechanism's driven motion, every part mounted."""

    @abstractmethod
    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Return the force at each joint [N] when a body is locked and the base accelerates."""

    @abstractmethod
    def free_force(self, acceleration: float) -> float:
        """Return the force on the joint [N] when the free mechanism is accelerated in its plane."""

    @property
    def states_stiffness(self) -> bool:
        """Return whether the stiffness of its joints is stated."""
        return False

    def blades_in_motion(
        self, geometry: Geometry, elastic: Elastic, sizes: Sizes, density: float
    ) -> float:
        """Return the mass of its blades in its driven motion [kg], where stiffness is stated."""
        raise MechanismError("mechanism", "this mechanism states no stiffness of its joints", "")

    def carried_body(self, geometry: Geometry, layout: "Layout") -> "Body | None":
        """Return the one body on its one joint, in the joint's axes, where it has just one."""
        return None

    @property
    def turning_inertia(self) -> float | None:
        """Return the inertia of the one body that its joint turns [kg·m²], where it is stated."""
        return None

    @property
    def tilting_inertia(self) -> tuple[float, float] | None:
        """Return the inertia of that body about x and y of cases [kg·m²], where both are stated."""
        return None

    @property
    def arm(self) -> float:
        """Return how far its centre of mass is beyond the joint's centre, along the blades [m]."""
        return 0.0

    @abstractmethod
    def hanging_mass(self) -> float:
        """Return the mass that the joints carry against gravity [kg]."""

    @abstractmethod
    def structure(
        self,
        geometry: Geometry,
        elastic: Elastic,
        sizes: Sizes,
        lock: str | None,
        density: float = 0.0,
        *,
        thick: bool = False,
    ) -> "Structure":
        """Return the mechanism as a linear structure, for its vibration.

        ``density`` is that of the blades [kg/m³]; 0 leaves their mass out. ``thick`` blades shear,
        and their sections have rotary inertia.
        """

    @abstractmethod
    def freedom(
        self,
        joint_stiffness: float,
        geometry: Geometry,
        *,
        balanced: bool = True,
        shift: float = 0.0,
    ) -> "SingleFreedom":
        """Return the mechanism as bodies on its one degree of freedom.

        ``balanced`` mounts the balancing masses; ``shift`` is the parasitic motion of a joint per
        squared travel.
        """

    def out_of_plane(self, joint: "Layout", lock: str | None) -> OutOfPlane:
        """Return its bodies on copies of a joint, with the data for motion out of its plane.

        Raises
        ------
        NotAvailable
            When the spec does not say enough of them.

        """
        raise NotAvailable("carries bodies that are not defined out of its plane")

    def shaken_by(self, geometry: Geometry) -> Literal["translation", "rotation"]:
        """Return the motion of the base for which the transfer function is asked."""
        return "translation"

    def coupling_limit(self) -> tuple[float, float] | None:
        """Return the coupling to the base and its upper limit, where a spec states it."""
        return None

    def notes(self) -> tuple[Note, ...]:
        """Return notes for a reviewer beside the margins."""
        return ()

    def body_forces(self, acceleration: float) -> dict[str, tuple[float, str]]:
        """Return forces at the bodies for reports [N], with their names."""
        return {}

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return the mechanism's own numbers for reports."""
        return {}
