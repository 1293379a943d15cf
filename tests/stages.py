"""Bodies of stages and of cantilevers for the tests."""

from flexcli.mechanics.layout import Body


def rider(mass, along, across, inertia):
    """Give a body on a lever: its centre of mass from the base pivot, along and across it."""
    return Body("rider", (0.0, 0.0), mass, inertia, (across, along))


def at_the_tip(*bodies):
    """Give mass, centre and inertia of what several (m, c, J) beyond a blade's end make."""
    m = sum(each[0] for each in bodies)
    c = sum(each[0] * each[1] for each in bodies) / m
    J = sum(each[2] + each[0] * (each[1] - c) ** 2 for each in bodies)
    return {"m": m, "c": c, "J": J}
