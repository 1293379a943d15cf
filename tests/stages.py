"""Bodies of a parallel stage for the tests."""

from flexcli.mechanics.layout import Body


def rider(mass, along, across, inertia):
    """Give a body on a lever: its centre of mass from the base pivot, along and across it."""
    return Body("rider", (0.0, 0.0), mass, inertia, (across, along))
