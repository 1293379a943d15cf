"""Moment of the symmetric and of the RCC pivot at 10°: error against time, for us and for peers.

Run with an interpreter that has flexcli and, as far as there, openseespy and exudyn:

    OMP_NUM_THREADS=1 python -W ignore tests/benchmarks/exact_peers.py

Blades are extensible and unshearable in all. The reference is ours at 1e-13. Times of the processor
are the best of some runs and hold the building of the model, which a sizing loop pays every time;
``again`` is another equilibrium of a layout that was solved before, as a sweep of strokes has it.
"""

import math
from itertools import pairwise
from time import process_time

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.mesh import Effects
from flexcli.numerics.compilation import compiled, has_numba

E, H, L, B, ALPHA = 114e9, 0.2e-3, 20e-3, 10e-3, math.pi / 4
THETA = math.radians(10.0)
AREA, INERTIA = B * H, B * H**3 / 12.0
BENDING = Effects(extension=True, shear=False)
PIVOTS = {"symmetric": -0.5, "rcc": 0.2}
ELEMENTS = (2, 4, 8, 16, 32, 64)
STEPS = 4
"""Load steps of the peers."""
LONG = 0.3
"""Seconds for which one thing is measured again and again."""


def ends(delta):
    """Return outer and inner end of both blades; the centre is the origin."""
    for side in (1.0, -1.0):
        c, s = math.cos(ALPHA), side * math.sin(ALPHA)
        yield tuple((r * c, r * s) for r in ((delta + 1.0) * L, delta * L))


def layout(delta):
    """Return the pivot as a layout."""
    blades = tuple(
        Blade(str(i), "ground", "out", *pair, Constant(H), B) for i, pair in enumerate(ends(delta))
    )
    return Layout((Body("out", (0.0, 0.0)),), blades, E, E / 2.68)


def ours(delta, tolerance):
    """Return the moment by the exact solver."""
    state = solve(
        layout(delta), {"out": (None, None, THETA)}, effects=BENDING, tolerance=tolerance
    ).checked()
    return float(state.reactions[0, 0, 2])


def opensees(delta, elements):
    """Return the moment by corotational elastic beams, the body as two stiff ones."""
    import openseespy.opensees as ops

    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Corotational", 1)
    ops.node(1, 0.0, 0.0)
    node, element = 2, 1
    for outer, inner in ends(delta):
        first = node
        for k in range(elements + 1):
            t = k / elements
            ops.node(node, *((1 - t) * o + t * i for o, i in zip(outer, inner, strict=True)))
            if k:
                nodes = (node - 1, node)
                ops.element("elasticBeamColumn", element, *nodes, AREA, E, INERTIA, 1)
                element += 1
            node += 1
        ops.fix(first, 1, 1, 1)
        stiff = (1e3 * AREA, E, 1e6 * INERTIA)
        ops.element("elasticBeamColumn", element, node - 1, 1, *stiff, 1)
        element += 1
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.sp(1, 3, THETA)
    ops.constraints("Transformation")
    ops.numberer("RCM")
    ops.system("UmfPack")
    ops.test("NormDispIncr", 1e-12, 50)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 1.0 / STEPS)
    ops.analysis("Static")
    if ops.analyze(STEPS) != 0:
        return math.nan
    ops.reactions()
    return ops.nodeReaction(1, 3)


def exudyn(delta, elements):
    """Return the moment by ANCF cables (cubic, unshearable) on a rigid body."""
    import exudyn as exu
    from exudyn import itemInterface as Items
    from exudyn.utilities import RotationMatrixZ

    system = exu.SystemContainer()
    mbs = system.AddSystem()
    ground = mbs.AddObject(Items.ObjectGround())
    node = mbs.AddNode(Items.NodeRigidBody2D(referenceCoordinates=[0.0, 0.0, 0.0]))
    inertia = {"mass": 1.0, "inertia": 1.0}
    body = mbs.AddObject(Items.ObjectRigidBody2D(nodeNumber=node, **inertia))
    for outer, inner in ends(delta):
        dx, dy = (i - o for o, i in zip(outer, inner, strict=True))
        angle, slope = math.atan2(dy, dx), (dx / L, dy / L)
        nodes = [
            mbs.AddNode(
                Items.NodePoint2DSlope1(
                    referenceCoordinates=[
                        outer[0] + dx * k / elements,
                        outer[1] + dy * k / elements,
                        *slope,
                    ]
                )
            )
            for k in range(elements + 1)
        ]
        cables = [
            mbs.AddObject(
                Items.ObjectANCFCable2D(
                    length=L / elements,
                    massPerLength=1.0,
                    bendingStiffness=E * INERTIA,
                    axialStiffness=E * AREA,
                    nodeNumbers=list(pair),
                    useReducedOrderIntegration=0,
                )
            )
            for pair in pairwise(nodes)
        ]
        for cable, at, support, place in (
            (cables[0], 0.0, ground, outer),
            (cables[-1], L / elements, body, inner),
        ):
            markers = [
                mbs.AddMarker(
                    Items.MarkerBodyRigid(bodyNumber=support, localPosition=[*place, 0.0])
                ),
                mbs.AddMarker(
                    Items.MarkerBodyRigid(bodyNumber=cable, localPosition=[at, 0.0, 0.0])
                ),
            ]
            mbs.AddObject(
                Items.GenericJoint(
                    markerNumbers=markers,
                    constrainedAxes=[1, 1, 0, 0, 0, 1],
                    rotationMarker0=RotationMatrixZ(angle),
                )
            )
    turn = mbs.AddMarker(Items.MarkerNodeCoordinate(nodeNumber=node, coordinate=2))
    fixed = mbs.AddNode(Items.NodePointGround())
    rest = mbs.AddMarker(Items.MarkerNodeCoordinate(nodeNumber=fixed, coordinate=0))
    drive = mbs.AddObject(
        Items.CoordinateConstraint(
            markerNumbers=[rest, turn],
            offset=0.0,
            offsetUserFunction=lambda mbs, t, number, offset: THETA * t,
        )
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = STEPS
    settings.staticSolver.newton.relativeTolerance = 1e-11
    settings.staticSolver.newton.absoluteTolerance = 1e-13
    settings.staticSolver.verboseMode = 0
    settings.staticSolver.newton.numericalDifferentiation.forODE2 = False
    settings.solutionSettings.writeSolutionToFile = False
    if not mbs.SolveStatic(settings):
        return math.nan
    return abs(float(np.ravel(mbs.GetObjectOutput(drive, exu.OutputVariableType.Force))[0]))


def timed(function, *arguments):
    """Return the value and the best time [s] of a few runs."""
    best, runs, first = math.inf, 0, process_time()
    while runs < 3 or process_time() - first < LONG:
        begun = process_time()
        value = function(*arguments)
        best, runs = min(best, process_time() - begun), runs + 1
    return value, best


def main():
    """Print one table: error and time of every solver."""
    print(f"{'pivot':10} {'solver':10} {'setting':>14} {'moment [N m]':>20} {'error':>9} {'ms':>9}")
    for pivot, delta in PIVOTS.items():
        reference = ours(delta, 1e-13)
        rows = [("flexcli", f"{t:g}", ours, t) for t in (1e-3, 1e-6, 1e-9, 1e-12)]
        rows += [
            (peer.__name__, f"{n} a blade", peer, n)
            for peer in (opensees, exudyn)
            for n in ELEMENTS
        ]
        for name, setting, function, argument in rows:
            try:
                moment, seconds = timed(function, delta, argument)
            except (ImportError, RuntimeError) as error:
                print(f"{pivot:10} {name:10} {setting:>14} {type(error).__name__}: {error}")
                break
            error = abs(moment / reference - 1.0)
            line = f"{moment:20.14f} {error:9.1e} {1e3 * seconds:9.3f}"
            print(f"{pivot:10} {name:10} {setting:>14} {line}")
        for is_so in (False, True)[: 1 + has_numba()]:
            by = "Numba" if is_so else "NumPy"
            with compiled(is_so):
                single(pivot, delta, by)
                for designs in (1000, 8000):
                    batch(pivot, delta, designs, by)


def single(pivot, delta, by):
    """Print the time of one design: its moment from the drawing on, and its next equilibrium."""
    known, held = layout(delta), {"out": (None, None, THETA)}
    for what, function in (
        ("1e-9, moment", lambda: ours(delta, 1e-9)),
        ("1e-9, again", lambda: solve(known, held, effects=BENDING)),
    ):
        _, seconds = timed(function)
        print(f"{pivot:10} {by:10} {what:>14} {'':20} {'':9} {1e3 * seconds:9.4f}")


def batch(pivot, delta, designs, by):
    """Print the time of one design in a batch of mixed ones."""
    rng = np.random.default_rng(1)
    h, l = H * rng.uniform(0.5, 1.5, designs), L * rng.uniform(0.5, 1.5, designs)
    blades = []
    for i, side in enumerate((1.0, -1.0)):
        c, s = math.cos(ALPHA), side * math.sin(ALPHA)
        pair = [(r * l * c, r * l * s) for r in (delta + 1.0, delta)]
        blades.append(Blade(str(i), "ground", "out", *pair, Constant(h[:, None]), B))
    many = Layout((Body("out", (0.0, 0.0)),), tuple(blades), E, E / 2.68)
    held = {"out": (None, None, THETA)}
    found, seconds = timed(lambda: solve(many, held, effects=BENDING))
    assert found.converged.all()
    each = 1e3 * seconds / designs
    print(f"{pivot:10} {by:10} {f'1e-9, {designs}':>14} {'':20} {'':9} {each:9.4f} each")


if __name__ == "__main__":
    main()
