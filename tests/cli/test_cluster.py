"""``--scheduler``: the workers of a Dask cluster give what processes of this machine give."""

import json
import os
import signal
import subprocess
import sys
from time import monotonic, sleep

import pytest

STAGE = """\
flexure: 1
title: guide
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, blades: 2, spacing: 20 mm, h: 0.2 mm, l: 40 mm, b: 10 mm}
stroke: {translation: 1 mm, cycles: 1e6}
requirements: {yield: 1.5, stiffness: {max: 2 N/mm}}
tolerances: {h: 5 um}
"""

SWEEP = ("sweep", "guide.yaml", "--sample", "sobol", "--seed", "3",
         "--vary", "geometry.h=0.1mm:0.3mm:1", "--vary", "geometry.l=30mm:50mm:1")  # fmt: skip
COMMAND = [sys.executable, "-c", "from flexcli.cli.app import main; main()"]
PATIENCE = 100.0


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "guide.yaml"
    path.write_text(STAGE, encoding="utf-8")
    return path


@pytest.mark.parametrize("verb", [[*SWEEP, "--points", "4"], ["tolerances", "guide.yaml"]])
def test_without_the_extra_it_is_named(flexure, spec, monkeypatch, verb):
    monkeypatch.setitem(sys.modules, "distributed", None)
    told = flexure(*verb, "--scheduler", "tcp://127.0.0.1:1")
    assert told.returncode == 2
    assert "flexcli[cluster]" in told.stdout + told.stderr


def test_no_scheduler_is_one_finding(flexure, spec):
    pytest.importorskip("distributed")
    told = flexure(*SWEEP, "--points", "4", "--scheduler", "nowhere")
    assert told.returncode == 2
    assert "no scheduler answers at 'nowhere'" in told.stdout + told.stderr


@pytest.fixture(scope="module")
def cluster():
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as found:
        yield found


def wait_until(is_so, run):
    end = monotonic() + PATIENCE
    while not is_so():
        assert run.poll() is None
        assert monotonic() < end
        sleep(0.02)


@pytest.mark.slow
def test_a_worker_that_is_killed_loses_nothing(flexure, spec, tmp_path, cluster):
    options = ["--points", "64", "-o"]
    flexure(*SWEEP, *options, "alone.csv", "-j", "1")
    command = [*COMMAND, *SWEEP, *options, "killed.csv", "--scheduler", cluster.scheduler_address]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL) as run:
        scheduler = cluster.scheduler
        wait_until(lambda: any(t.state == "memory" for t in scheduler.tasks.values()), run)
        assert any(t.state in ("processing", "queued") for t in scheduler.tasks.values())
        os.kill(cluster.workers[0].pid, signal.SIGKILL)
        run.wait(PATIENCE)
    alone, killed = ((tmp_path / name).read_bytes() for name in ("alone.csv", "killed.csv"))
    assert len(alone.splitlines()) == 65
    assert killed == alone


@pytest.mark.slow
def test_yields_are_the_same_on_a_cluster(flexure, spec, cluster):
    told = [
        flexure("tolerances", "guide.yaml", "--parts", "1000", "--format", "json", *options)
        for options in (["-j", "1"], ["--scheduler", cluster.scheduler_address])
    ]
    alone, spread = (json.loads(one.stdout)["tolerances"] for one in told)
    assert alone["judged"] > 10
    assert spread == alone
