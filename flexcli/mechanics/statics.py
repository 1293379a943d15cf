"""Balance of the bodies by statics alone, from the forces of blades that are closed."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly
from flexcli.mechanics.beam import paired, turning
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.mesh import pick
from flexcli.mechanics.outer_forces import apply_force, apply_spring

__all__ = ["balance"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def balance(assembly: Assembly, demand: Demand, x: Floats, share: Floats, rows: Integers) -> Floats:
    """Return what blades, forces and springs leave on each body, scaled (designs, 3 · bodies).

    At an equilibrium x that is what holds the held coordinates: the ends of each blade lie where
    their bodies are, so that nothing inside a blade is asked for.
    """
    _, forces, motions = assembly.split(x)
    designs, bodies = len(x), np.arange(assembly.bodies)[:, None]
    poses = np.concatenate([motions, np.zeros((designs, 1, 3))], axis=1)
    places, turns = paired(poses[..., 0], poses[..., 1]), turning(poses[..., 2])
    warmth, found = demand.warmth(share)[:, None], np.zeros((designs, assembly.bodies, 3))
    for mesh, place, weights in zip(
        assembly.meshes, assembly.places, assembly.weights, strict=True
    ):
        blades = list(mesh.blades)
        first, second = assembly.first[blades], assembly.second[blades]
        start, end, along = (pick(each, rows) for each in (place.start, place.end, place.along))
        scale, reach, misfit = (
            pick(place.scale, rows),
            pick(place.reach, rows),
            pick(place.misfit, rows),
        )
        moved = scale * (places[:, second] - places[:, first]) + warmth * misfit
        moved += end * turns[:, second]
        nu, m = paired(forces[:, blades, 0], forces[:, blades, 1]), forces[:, blades, 2]
        weight, pull = pick(weights, rows), scale * nu
        lever, far = start + reach * along + moved, end + end * turns[:, second]
        for on, sign, arm in ((first, -weight, lever), (second, weight, far)):
            load = np.stack([pull.real, pull.imag, m + (arm.conj() * nu).imag], axis=-1)
            found += (bodies == on).astype(np.float64) @ (sign[..., None] * load)
    residual = found.reshape(designs, -1)
    unused = np.zeros((designs, residual.shape[1], residual.shape[1]))
    for force in demand.forces:
        before, after = pick(force.before, rows), pick(force.after, rows)
        apply_force(force, motions, before + share * (after - before), rows, residual, unused)
    for spring in demand.springs:
        apply_spring(spring, motions, rows, residual, unused)
    return residual
