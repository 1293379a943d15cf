"""A change of temperature from assembly, of blades and bodies, and how far each would grow."""

from collections.abc import Mapping
from dataclasses import replace
from math import cos, sin
from typing import Annotated, Any

from pydantic import Field, model_validator

from flexcli.mechanics.layout import Layout
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.geometries.base import GROUND

__all__ = ["Temperature"]

Change = Annotated[float, QuantityOf("temperature change")]
Slope = Annotated[float, QuantityOf("temperature gradient")]
Coefficient = Annotated[float, QuantityOf("expansion")]


class Gradient(Part):
    """How the temperature rises from the origin of the joint's drawing on."""

    x: Slope = 0.0
    """Rise along x: the stroke of a stage, the bisector of a pivot, e.g. ``40 K/m``."""
    y: Slope = 0.0
    """Rise in the plane across x, e.g. ``-10 K/m``."""


class Temperature(Part):
    """Changes of temperature from assembly, which add up: bodies and blades grow, and may not fit.

    Stiffness and strength stay those that the material states.
    """

    uniform: Change = 0.0
    """Change of everything, e.g. ``-60 K``."""
    bodies: Mapping[str, Change] = Field(default_factory=dict)
    """Change of single bodies besides, by their names; ``ground`` is the base,
    e.g. ``{moving: 12 K}``.
    """
    gradient: Gradient = Gradient()
    """Rise from place to place, taken at the middle of each blade and at each body's point,
    e.g. ``{x: 40 K/m}``.
    """
    expansion: Mapping[str, Coefficient] = Field(default_factory=dict)
    """Thermal expansion of bodies that are of another material than the blades,
    e.g. ``{moving: 23.6e-6 1/K}``.
    """

    @model_validator(mode="after")
    def _changes_something(self) -> "Temperature":
        if not any((self.uniform, *self.bodies.values(), self.gradient.x, self.gradient.y)):
            raise spec_error("this temperature changes nothing", "give it e.g. uniform: -60 K")
        return self

    @property
    def names(self) -> frozenset[str]:
        """Return the bodies that it names."""
        return frozenset((*self.bodies, *self.expansion))

    def warmed(self, layout: Layout, expansion: float, axes: float) -> Layout:
        """Return a layout whose blades and bodies have grown.

        A body grows about its reference point, the ground about the origin of the layout.

        Parameters
        ----------
        layout : Layout
            The joint at assembly.
        expansion : float
            Coefficient of thermal expansion of the blades, and of bodies of no other [1/K].
        axes : float
            Angle of the x of cases from that of the layout [rad].

        """
        c, s = cos(axes), sin(axes)
        rise_x = c * self.gradient.x - s * self.gradient.y
        rise_y = s * self.gradient.x + c * self.gradient.y

        def at(point: Any) -> Any:
            return self.uniform + rise_x * point[0] + rise_y * point[1]

        points = {body.name: body.point for body in layout.bodies} | {GROUND: (0.0, 0.0)}
        bodies = {
            name: self.expansion.get(name, expansion) * (at(point) + self.bodies.get(name, 0.0))
            for name, point in points.items()
        }
        blades = {
            blade.name: expansion
            * at(tuple((s + e) / 2.0 for s, e in zip(blade.start, blade.end, strict=True)))
            for blade in layout.blades
        }
        return replace(layout, body_growth=bodies, blade_growth=blades)
