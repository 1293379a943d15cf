"""Is the confidence of a random run between stops what it says? Repeats of the shipped example.

A run with confidence c says that one exposure more shows no higher peak with that chance. Here
every repeat runs the case and then that one exposure, all with seeds of their own, and the share
of those that stay below is set against c, with the binomial scatter of so many repeats.

    python tests/benchmarks/stops_confidence.py [REPEATS [FIRST]]

FIRST is the number of the first repeat, so that many can be run in parts.
"""

import sys
from math import sqrt
from pathlib import Path
from time import perf_counter

import flexcli
from flexcli.engine.stopping.choice import choose
from flexcli.engine.stopping.run import stop_runs
from flexcli.engine.stopping.statics import task_of

SPEC = Path(__file__).parents[2] / "examples" / "boundary-control-random" / "flexure.yaml"
EXPOSURE = "0.25 s"
CONFIDENCES = (0.5, 0.75, 0.9, 0.95)
ONE = 0.5  # of which one exposure is enough

DESIGN = flexcli.load(SPEC, overrides={"cases.launch.asd.duration": EXPOSURE}).part
SIZES = DESIGN.fixed_sizes()
TASK = task_of(DESIGN, DESIGN.stops, SIZES)
PLACE = choose(TASK).place


def peak(seed: int, confidence: float) -> float:
    """Return the highest travel of a run [m]."""
    options = DESIGN.stops.simulation.model_copy(update={"confidence": confidence, "seed": seed})
    (run,) = stop_runs(DESIGN, TASK, SIZES, PLACE, "launch", options=options)
    return float(run.driven(lambda _: True).travel)


def main(repeats: int, first: int) -> None:
    """Print a row for each confidence."""
    print(f"{repeats} repeats of {EXPOSURE} exposures of {SPEC.parent.name}, from number {first}")
    print("confidence  stayed below  expected scatter  within 2 of it  seconds")
    for confidence in CONFIDENCES:
        begun, below = perf_counter(), 0
        for repeat in range(first, first + repeats):
            run = peak(2 * repeat, confidence)
            below += peak(2 * repeat + 1, ONE) <= run
        share, scatter = below / repeats, sqrt(confidence * (1.0 - confidence) / repeats)
        holds = "yes" if share >= confidence - 2.0 * scatter else "NO"
        seconds = perf_counter() - begun
        print(f"{confidence:10.2f}  {share:12.3f}  {scatter:16.3f}  {holds:>14}  {seconds:7.1f}")


if __name__ == "__main__":
    given = [int(each) for each in sys.argv[1:]]
    main(*given, *(200, 0)[len(given) :])
