"""What a base that accelerates, vibrates or tilts does to a mechanism, and feels of it."""

from collections.abc import Iterator, Sequence
from math import isfinite

import numpy as np

from flexcli.engine.balancing.freedom import Freedom
from flexcli.errors import SolveError
from flexcli.formulas.transfer import natural_frequency, transfer
from flexcli.mechanics.single_freedom import Expansion, expand
from flexcli.parts.asd import RandomVibration
from flexcli.results import Value
from flexcli.results.balance import GravityRow, TransferRow

__all__ = [
    "gravity_rows",
    "reaction_values",
    "sag_values",
    "suffix",
    "transfer_rows",
    "vibration_values",
]

WORDS = {"before": "before balancing", "after": "after balancing"}


def suffix(freedom: Freedom, states: Sequence[Freedom]) -> str:
    """Return what the names of a state's values end in: nothing where there is one state."""
    if len(states) == 1:
        return ""
    return {"before": "_init", "after": "_final"}[freedom.mounted]


def transfer_rows(
    states: Sequence[Freedom], frequencies: Sequence[float], quality: float | None
) -> tuple[TransferRow, ...]:
    """Return T = X/((jω)² Γ) before and after, without and with damping, per frequency."""
    columns: dict[str, list[complex | None]] = {}
    for state in states:
        if state.k is None:
            return ()
        for name, Q in (("", np.inf), ("_damped", quality)):
            if Q is None:
                continue
            T = transfer(frequencies, m=state.m, k=state.k, coupling=state.coupling, Q=Q)
            columns[f"{state.mounted}{name}"] = [
                complex(t) if isfinite(t.real) else None for t in T
            ]
    nothing: list[complex | None] = [None] * len(frequencies)
    before, after = (columns.get(name, nothing) for name in ("before", "after"))
    damped = [columns.get(f"{name}_damped", nothing) for name in ("before", "after")]
    return tuple(
        TransferRow(
            frequency,
            None if init is None else init.real,
            None if final is None else final.real,
            *both,
        )
        for frequency, init, final, *both in zip(frequencies, before, after, *damped, strict=True)
    )


def vibration_values(
    states: Sequence[Freedom], vibration: RandomVibration, residuals: dict[str, float]
) -> dict[str, Value]:
    """Return the rms displacement that a vibrating base leaves, exact for one oscillator.

    An oscillator that feels τ γ̈ where its mass is m_eq moves τ/m_eq as far as one that feels all
    of its mass. ``residuals`` are couplings that tolerances may leave after balancing, by name.
    """
    found: dict[str, Value] = {}
    for state in states:
        if state.k is None:
            return {}
        full = _full_rms(state.k, state.m, vibration)
        couplings = {suffix(state, states): (abs(state.rest.coupling_x.value), "")}
        if state.mounted == "after":
            couplings |= {
                f"_{name}": (coupling, f", tolerances {name}")
                for name, coupling in residuals.items()
            }
        words = WORDS[state.mounted] if len(states) > 1 else "of the stage"
        found |= {
            f"x_rms{ending}": Value(
                full * coupling / state.m,
                "rad" if state.base_turns else "m",
                f"rms displacement {words}{told}, {vibration.q.told}",
                model="exact response of one oscillator",
                source="Crandall, Mark 1963",
            )
            for ending, (coupling, told) in couplings.items()
        }
    return found


def _full_rms(k: float, m: float, vibration: RandomVibration) -> float:
    """Return the rms displacement of an oscillator that the base shakes in full [m]."""
    from flexcli.formulas.oscillator import oscillator_response
    from flexcli.formulas.spectrum_integrals import rms_displacement

    applied = vibration.applied()
    try:
        if k == 0.0:
            return rms_displacement(applied.frequency, applied.level, scale=applied.scale)
        response = oscillator_response(
            applied.frequency,
            applied.level,
            natural_frequency(k, m),
            vibration.q.all,
            scale=applied.scale,
        )
    except ValueError as error:
        raise SolveError("no-response", f"balance.asd: {error}", "give q: 0.5 or more") from error
    return float(response.relative_displacement)


def gravity_rows(states: Sequence[Freedom], g: float, stroke: float) -> tuple[GravityRow, ...]:
    """Return what gravity along +x, +y and +z does to the freedom, at rest and over the stroke."""
    return tuple(row for state in states for row in _gravity(state, g, stroke))


def _gravity(state: Freedom, g: float, stroke: float) -> Iterator[GravityRow]:
    ends = [expand(state.system, end, order=1) for end in (stroke, -stroke)] if stroke else []
    for axis, gx, gy in (("x", g, 0.0), ("y", 0.0, g), ("z", 0.0, 0.0)):
        torques = [_pull(end, gx, gy) * end.output_rate.value for end in ends]
        yield GravityRow(
            axis=axis,
            mounted=state.mounted,
            unit="N*m" if state.coordinate_turns else "N",
            at_rest=_pull(state.rest, gx, gy) * state.rest.output_rate.value,
            at_stroke=max(torques, key=abs) if torques else None,
            sag=_pull(state.rest, gx, gy) / state.k if state.k else None,
            stiffness=state.rest.gravity_stiffness(gx, gy),
        )


def _pull(motion: Expansion, gx: float, gy: float) -> float:
    """Return the force of gravity on the output."""
    return motion.coupling_x.value * gx + motion.coupling_y.value * gy


def sag_values(rows: Sequence[GravityRow], state: Freedom) -> dict[str, Value]:
    """Return how far gravity along each axis moves the mechanism, where it does."""
    unit = "rad" if state.base_turns else "m"
    return {
        f"sag_{row.axis}": Value(row.sag, unit, f"sag, gravity along {row.axis}", source="τ g/k_eq")
        for row in rows
        if row.sag
    }


def reaction_values(states: Sequence[Freedom]) -> dict[str, Value]:
    """Return the torque that the base feels when the mechanism moves, and what would cancel it."""
    found = {}
    about = "about the base pivots" if len(states) > 1 else "about the joint"
    turns = states[-1].base_turns
    for state in states:
        ending, words = suffix(state, states), WORDS[state.mounted] if len(states) > 1 else ""
        coupling = state.rest.coupling_rotation.value
        if coupling == 0.0:
            continue
        found[f"tau_rotation{ending}"] = Value(
            coupling,
            "kg*m^2" if turns else "kg*m",
            f"torque on the base per acceleration, {about} {words}".rstrip(),
            source="−τ_φ ü",
        )
    last = states[-1]
    if last.coordinate_turns and last.rest.coupling_rotation.value:
        J = abs(last.rest.coupling_rotation.value * last.rest.output_rate.value)
        found["J_counter"] = Value(
            J,
            "kg*m^2",
            "inertia of a body turned by −θ that would cancel the torque on the base",
            source="|c_φ|",
        )
    return found
