"""A start loads what a check needs: counted in modules, for seconds are the machine's."""

import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from flexcli.parts.geometries import GEOMETRIES
from flexcli.parts.mechanisms import MECHANISMS

EASY = """
flexure: 1
material: {youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34}
geometry: {kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 0.1 mm, l: 20 mm, b: 5 mm}
stroke: {rotation: 2 deg}
requirements: {yield: 1.5}
"""

LOADED = """
import sys
sys.argv = ["flexure", "check", sys.argv[1]]
from flexcli.__main__ import main
try:
    main()
except SystemExit as end:
    code = end.code
print(code, *sorted(name for name in sys.modules if name.partition(".")[0] == "flexcli"))
"""


TASKS = Path("/proc/self/task")

THREADS = f"""
import sys
sys.argv = ["flexure", "check", sys.argv[1], "--model", "exact"]
from flexcli.__main__ import main
try:
    main()
except SystemExit:
    from pathlib import Path
    from time import sleep
    counts = []
    for _ in range(20):  # the clock of the run may take a while to end
        counts.append(len(list(Path("{TASKS}").iterdir())))
        sleep(0.02)
    print(min(counts))
"""


PUSHED = """
flexure: 1
material: {youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34}
geometry: {kind: leaf-spring-stage, h: 0.1 mm, l: 20 mm, b: 5 mm, blades: 2, spacing: 30 mm}
cases: {work: {stroke: {translation: 0.5 mm}, wrench: {y: 0.5 N}}}
requirements: {yield: 1.5}
"""


@pytest.fixture(scope="module")
def loaded(tmp_path_factory):
    """Return the modules of ours that a check of an easy design has loaded at its end."""
    return modules(tmp_path_factory.mktemp("easy") / "flexure.yaml", EASY)


def modules(spec, text):
    """Return the modules of ours that a check that passes has loaded at its end."""
    spec.write_text(text, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, "-c", LOADED, str(spec)],
        capture_output=True, text=True, check=True, timeout=60,
    )  # fmt: skip
    code, *names = run.stdout.splitlines()[-1].split()
    assert code == "0", run.stdout + run.stderr
    return names


def test_a_check_that_the_closed_form_decides_loads_140_modules_at_most(loaded):
    assert len(loaded) <= 140, Counter(".".join(name.split(".")[:2]) for name in loaded)


def test_it_loads_the_one_joint_that_the_spec_names_and_no_mechanism(loaded):
    paths = {**GEOMETRIES.paths, **MECHANISMS.paths}
    named = {path.partition(":")[0] for path in paths.values()}
    assert named & set(loaded) == {"flexcli.parts.geometries.cross_spring"}


def test_it_loads_no_solver_of_a_finer_model(loaded):
    solvers = {"equilibrium", "linear", "linear_buckling", "stability", "vibrating_layout"}
    assert not {f"flexcli.mechanics.{name}" for name in solvers} & set(loaded)


def test_loads_far_from_those_that_leave_the_plane_need_no_model_in_space(tmp_path):
    found = modules(tmp_path / "flexure.yaml", PUSHED)
    assert "flexcli.mechanics.lateral_bound" in found
    assert not [name for name in found if name.startswith("flexcli.mechanics.space.exact")]
    assert "flexcli.engine.joint_models.out_of_plane_buckling" not in found


def test_everyday_units_of_either_kind_load_no_library_of_units():
    read = "from flexcli.parts.base import in_either; print(in_either('2 N/mm', *sys.argv[1:]))"
    run = subprocess.run(
        [sys.executable, "-c", f"import sys; {read}; print('pint' in sys.modules)",
         "rotational stiffness", "stiffness"],
        capture_output=True, text=True, check=True, timeout=60,
    )  # fmt: skip
    assert run.stdout.split("\n")[:2] == ["(2000.0, 'N/m')", "False"]


@pytest.mark.slow
@pytest.mark.skipif(not TASKS.exists(), reason="threads are counted as Linux tells them")
@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="there is but one core")
def test_matrices_are_solved_in_one_thread_unless_the_environment_says_otherwise(tmp_path):
    spec = tmp_path / "flexure.yaml"
    spec.write_text(EASY, encoding="utf-8")
    free = {key: value for key, value in os.environ.items() if not key.endswith("_NUM_THREADS")}
    threads = []
    for stated in ({}, {"OPENBLAS_NUM_THREADS": "2"}):
        run = subprocess.run(
            [sys.executable, "-c", THREADS, str(spec)],
            capture_output=True, text=True, check=True, timeout=60, env=free | stated,
        )  # fmt: skip
        threads.append(int(run.stdout.splitlines()[-1]))
    assert threads == [1, 2]
