"""Axial forces that buckle notches and fillets between rigid bodies: solids by CalculiX, *BUCKLE.

Run by hand: python tests/benchmarks/hinges_buckled.py FILE, some minutes: the rows of
tests/parts/hinges_buckled.json. Each is a geometry clamped at its mouths, ν, what holds its body,
the critical force [N] by two meshes of the package's own decks, E = 200 GPa, and the error by the
coarser one, as if the order were one. A hinge whose body is "swaying" is half of the shortest limb
of a stage: its body turns and moves across, and the force acts at its far mouth.
"""

import json
import sys
from dataclasses import replace
from pathlib import Path

import yaml

import flexcli
from flexcli.engine.joint_models import corrected
from flexcli.engine.joint_models.buckling import linear_critical_forces, push_scene
from flexcli.engine.solid.calculix import run
from flexcli.engine.solid.numbers import SolidNumbers
from flexcli.mechanics.mesh import Effects

MESHES = (2, 3)


def notch(e, b):
    """Return a circular notch of radius 1 mm."""
    return {"kind": "notch-hinge", "e": f"{e} mm", "r": "1 mm", "b": f"{b} mm"}


def ellipse(depth, l, b):
    """Return a flat ellipse with a throat of 0.1 mm."""
    return {
        "kind": "elliptic-hinge", "e": "0.1 mm", "depth": f"{depth} mm", "l": f"{l} mm",
        "b": f"{b} mm",
    }  # fmt: skip


def fillet(b):
    """Return a blade with fillets."""
    return {"kind": "filleted-hinge", "h": "0.1 mm", "l": "5 mm", "r": "1 mm", "b": f"{b} mm"}


HELD = ("clamped-guided", "clamped-clamped")
CASES = (
    *((notch(e, b), nu, ends) for e, b, nu in (
        (0.02, 0.6, 0.3), (0.05, 0.25, 0.3), (0.05, 1.5, 0.3), (0.1, 0.8, 0.45), (0.1, 2.0, 0.45),
        (0.3, 2.4, 0.45),
    ) for ends in HELD),
    *((each, nu, ends) for each, nu in (
        (ellipse(0.5, 5.0, 0.3), 0.45), (ellipse(0.5, 5.0, 1.0), 0.45),
        (ellipse(0.3, 6.0, 2.0), 0.3), (fillet(1.0), 0.45), (fillet(3.0), 0.45),
    ) for ends in HELD),
    *((notch(e, b), nu, "swaying") for e, b, nu in (
        (0.1, 0.3, 0.0), (0.3, 0.9, 0.0), (0.6, 1.8, 0.0), (0.1, 0.8, 0.45), (0.3, 2.4, 0.45),
        (0.1, 3.0, 0.45),
    )),
)  # fmt: skip


def spec_of(geometry, nu, ends):
    """Return a spec of a hinge under a force of 1 N along it."""
    return {
        "flexure": 1, "material": {"name": "m", "youngs_modulus": "200 GPa", "poisson_ratio": nu},
        "geometry": {**geometry, "blocks": "0 mm"}, "requirements": {"buckling": 1},
        "cases": {"work": {"load": {"force": "1 N"},
                           "ends": "clamped-free" if ends == "swaying" else ends}},
    }  # fmt: skip


def ask_of(spec):
    """Return what a check of a spec asks its model."""
    asked, whole = [], corrected.Corrected.critical

    def noted(model, ask):
        asked.append(ask)
        return whole(model, ask)

    corrected.Corrected.critical = noted
    try:
        flexcli.verdicts(yaml.safe_dump(spec), model="linear")
    finally:
        corrected.Corrected.critical = whole
    return asked[0]


def pushed(ask, ends):
    """Return a hinge under a unit force that pushes it."""
    scene = push_scene(ask, ask.scene.pushes()[0])
    load = scene.pattern[0]._replace(force=(-1.0, 0.0))
    if ends != "swaying":
        return replace(scene, pattern=(load,))
    body, mouth = scene.layout.bodies[0], scene.layout.blades[0].end
    layout = replace(scene.layout, bodies=(body._replace(point=mouth),))
    return replace(scene, layout=layout, pattern=(load._replace(point=mouth),))


def force(ask, scene, fineness):
    """Return the critical force by solids [N]."""
    near = min(float(found.force) for found in linear_critical_forces(ask, Effects()))
    numbers = SolidNumbers(ask, lambda deck: run(deck.text, "hinge"), fineness)
    return numbers._critical(scene, near)


def main():
    """Add the rows that a file lacks."""
    file = Path(sys.argv[1])
    rows = json.loads(file.read_text(encoding="utf-8")) if file.exists() else []
    for geometry, nu, ends in CASES[len(rows) :]:
        ask = ask_of(spec_of(geometry, nu, ends))
        coarse, fine = (force(ask, pushed(ask, ends), each) for each in MESHES)
        rows.append(
            [geometry, nu, ends, float(f"{fine:.6g}"), float(f"{abs(coarse / fine - 1):.2g}")]
        )
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
        file.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
