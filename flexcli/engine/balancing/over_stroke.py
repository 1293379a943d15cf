"""The terms of the equation of motion beyond small angles, at the end of the stroke."""

from collections.abc import Callable, Iterator, Sequence

from flexcli.engine.balancing.base_motion import suffix
from flexcli.engine.balancing.freedom import Freedom
from flexcli.mechanics.single_freedom import Expansion, SingleFreedom, expand
from flexcli.numerics.taylor import Taylor
from flexcli.results.balance import StrokeRow

__all__ = ["over_stroke", "shift_coupling"]

ORDERS = 3
"""Powers of the coordinate whose contributions are told apart."""

Term = Callable[[Expansion], Taylor]


def over_stroke(states: Sequence[Freedom], stroke: float) -> tuple[StrokeRow, ...]:
    """Return coupling, mass and stiffness at rest, their orders, and exactly at full stroke."""
    if not stroke:
        return ()
    return tuple(row for state in states for row in _rows(state, suffix(state, states), stroke))


def shift_coupling(state: Freedom, stroke: float) -> float:
    """Return what the parasitic shift of the joints adds to the coupling at full stroke [kg]."""

    def coupling(system: SingleFreedom, end: float) -> float:
        return expand(system, end, order=1).coupling_x.value

    added = (
        abs(coupling(shifted, end) - coupling(state.system, end))
        for shifted in state.shifted
        for end in (stroke, -stroke)
    )
    return max(added, default=0.0)


def _rows(state: Freedom, ending: str, stroke: float) -> Iterator[StrokeRow]:
    turns = state.base_turns
    coupling = "kg*m" if turns else "kg"
    terms: list[tuple[str, str, Term]] = [
        ("tau_x", coupling, lambda motion: motion.coupling_x),
        ("tau_y", coupling, lambda motion: motion.coupling_y),
        ("m_eq", "kg*m^2" if turns else "kg", lambda motion: motion.mass),
    ]
    if state.has_springs:
        terms.append(("k_eq", "N*m/rad" if turns else "N/m", lambda motion: motion.stiffness))
    for name, unit, term in terms:
        yield _row(f"{name}{ending}", unit, term, state.rest, (state.system,), stroke)
    if state.shifted:
        for name, unit, term in terms[:2]:
            rest = expand(state.shifted[0], order=ORDERS + 1)
            label = f"{name}{ending}, pivots shift alike"
            yield _row(label, unit, term, rest, state.shifted, stroke)


def _row(
    name: str,
    unit: str,
    term: Term,
    rest: Expansion,
    systems: Sequence[SingleFreedom],
    stroke: float,
) -> StrokeRow:
    at_rest, *others = term(rest).coefficients
    ends = [
        term(expand(system, end, order=1)).value for system in systems for end in (stroke, -stroke)
    ]
    return StrokeRow(
        name,
        unit,
        at_rest,
        tuple(c * stroke**n for n, c in enumerate(others[:ORDERS], start=1)),
        max(ends, key=lambda value: abs(value - at_rest)),
    )
