"""Where the energy and the momentum of a blade between stops went."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.record import Record
from flexcli.mechanics.stopping.result import Balance

__all__ = ["MotionState", "balance"]

Floats = NDArray[np.float64]


class MotionState(NamedTuple):
    """Modal coordinates, rates, and what the springs of the stops hold [J]."""

    q: Floats
    rate: Floats
    springs: float


def balance(
    blade: ModalBlade, record: Record, *, start: MotionState, end: MotionState, lost: float
) -> Balance:
    """Return the balance between two states; ``lost`` [J] at the stops besides the dashpots."""

    def energies(state: MotionState) -> tuple[float, float]:
        kinetic = 0.5 * float(state.rate @ state.rate)
        return kinetic, 0.5 * float(blade.angular**2 @ state.q**2)

    kinetic, strain = energies(end)
    before = sum(energies(start)) + start.springs
    at_stops = lost + record.dashpots
    after = kinetic + strain + end.springs
    # q' of each mode, from its equation of motion integrated over time
    terms = np.stack(
        [
            end.rate - start.rate,
            blade.base * record.base_integral,
            np.diagonal(blade.damper) * (end.q - start.q),
            blade.angular**2 * record.q_integral,
            blade.stop * record.push_integral,
        ]
    )
    greatest = float(np.abs(terms).max())
    return Balance(
        start=before,
        kinetic=kinetic,
        strain=strain,
        stop=end.springs,
        base_work=record.work,
        damped=record.damped,
        lost_at_stops=at_stops,
        energy_residual=after - before - record.work + record.damped + at_stops,
        impulse_residual=float(np.abs(terms.sum(axis=0)).max()) / (greatest or 1.0),
    )
