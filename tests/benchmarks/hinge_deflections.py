"""What a stroke changes in the deflections of a notch: solids by CalculiX, NLGEOM, drive free.

Run by hand: python tests/benchmarks/hinge_deflections.py, a minute for each deflection. A notch
clamped at its mouths is turned by a moment that is kept while a small force acts on its middle.
Prints for each force along x, y and z what it deflects over that at rest, by CalculiX, by the model
of solids and by that of exact beams, the two with what they are off at most.
"""

import sys
from pathlib import Path

import numpy as np
import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from hinges_at_stroke import WIDTHS, E, layout_of

import flexcli
from flexcli.engine.solid import bricks as meshes
from flexcli.engine.solid.calculix import run
from flexcli.mechanics.space.springs import springs_of

MM, SMALL, STILL = 1e3, 1e-3, 1e-9
CONTROLS = "*CONTROLS, PARAMETERS=FIELD\n1e-7, 1e-6, 1e-7, , 1e-7, 1e-7"
NOTCHES = ((0.3, 1.5, 0.3, 0.06), (0.1, 0.4, 0.3, 0.15), (0.2, 2.0, 0.4, 0.05))
"""Throat and width over the radius, ν, and the turn of the beam under the moment [rad]."""


def deflected(layout, moment, force):
    """Return how far a force moves the middle (3,) [mm], and how far the moment turns it [rad]."""
    blade = layout.blades[0]
    l, b, nu = blade.end[0], blade.b, blade.material.nu
    meshes._widths = lambda b, h: WIDTHS if b > 4.0 * h else WIDTHS[[0, 1, 3, 5, 6]]
    made = meshes.bricks(blade.profile.stretches(l), b)
    ref, rot = len(made.places) + 1, len(made.places) + 2
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i},{x:.12g},{y:.12g},{z:.12g}" for i, (x, y, z) in enumerate(made.places * MM, 1)]
    lines += ["*NODE", *(f"{node},{l * MM / 2.0},0.,0." for node in (ref, rot))]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=ALL")
    for i, nodes in enumerate(made.elements + 1, 1):
        lines += [",".join(map(str, [i, *nodes[:14]])) + ",", ",".join(map(str, nodes[14:]))]
    sets = ("GROUND", made.end(0) + 1), ("END", made.end(-1) + 1), ("REF", [ref]), ("ROT", [rot])
    for name, nodes in sets:
        lines += [f"*NSET, NSET={name}", *(f"{node}," for node in nodes)]
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"{E * 1e-6:.10g},{nu:.10g}",
        "*SOLID SECTION, ELSET=ALL, MATERIAL=M",
        f"*RIGID BODY, NSET=END, REF NODE={ref}, ROT NODE={rot}", "*BOUNDARY", "GROUND,1,3",
    ]  # fmt: skip
    for acting in (np.zeros(3), force):
        lines += ["*STEP, NLGEOM, INC=1000", "*STATIC", "0.25,1.,1e-4,1.", CONTROLS]
        lines += ["*CLOAD, OP=NEW", f"{rot},3,{moment * MM:.14g}"]
        lines += [f"{ref},{axis},{F:.12g}" for axis, F in enumerate(acting, 1) if F]
        for name in ("REF", "ROT"):
            lines += [f"*NODE PRINT, NSET={name}, FREQUENCY=100000", "U"]
        lines.append("*END STEP")
    found = list(run("\n".join([*lines, ""]), "hinge").tables("displacements"))
    return found[2][ref] - found[0][ref], found[1][rot][2]


def told(shape, turn, axis, force, model):
    """Return a deflection at a stroke over that at rest, and what it is off at most."""
    e, b, nu, _ = shape
    spec = {
        "flexure": 1, "requirements": {"deflection": {"direction": axis, "max": "1 m"}},
        "material": {"name": "steel", "youngs_modulus": f"{E} Pa", "poisson_ratio": nu},
        "geometry": {"kind": "notch-hinge", "e": f"{e} mm", "r": "1 mm", "b": f"{b} mm",
                     "blocks": "0 mm"},
    }  # fmt: skip
    found = []
    for end in (STILL, turn):
        stroke = {"rotation": ["0 rad", f"{end!r} rad"]}
        spec["cases"] = {"work": {"stroke": stroke, "wrench": {axis: f"{force!r} N"}}}
        checks = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
        found.append(next(check for check in checks if check.name.startswith("deflection")))
    rest, there = found
    low, high = (there.factor / end - 1.0 for end in reversed(there.factor_range))
    return there.demand / rest.demand, low, high


def main():
    """Print the deflections."""
    for shape in NOTCHES:
        e, b, nu, turn = shape
        layout = layout_of("notch", [e, 1.0], 2.0, b, nu)
        stiffness = float(springs_of(layout.blades[0]).springs.stiffness[5])
        force = SMALL * stiffness / 2e-3
        for k, axis in enumerate("xyz"):
            acting = force * np.eye(3)[k]
            (rest, _), (there, angle) = (
                deflected(layout, each * stiffness, acting) for each in (0.0, turn)
            )
            row = f"e {e} b {b} ν {nu} turned by {angle:.4f}, {axis}: {there[k] / rest[k]:.4f}"
            for model in ("solid", "exact"):
                ratio, low, high = told(shape, float(angle), axis, force, model)
                row += f" | {model} {ratio:.4f}, {low:+.3f} to {high:+.3f}"
            print(row, flush=True)


if __name__ == "__main__":
    main()
