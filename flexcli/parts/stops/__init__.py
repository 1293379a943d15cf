"""End stops of a spec: place, task, contact."""

from flexcli.parts.stops.contact import Ball, Contact, Cylinder, Rigid, Spring
from flexcli.parts.stops.stops import Stops

__all__ = ["Ball", "Contact", "Cylinder", "Rigid", "Spring", "Stops"]
