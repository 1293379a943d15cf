"""Many specs over the cores of the machine: answers in the order of the specs."""

import os
from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from itertools import islice
from pathlib import Path
from time import monotonic, time
from typing import TypeVar

__all__ = ["over", "usual_jobs"]

A_JOB = 4
"""Specs for which a further process is worth its start."""

Answer = TypeVar("Answer")


def usual_jobs(count: int) -> int:
    """Return in how many processes so many specs are done."""
    try:
        cores = len(os.sched_getaffinity(0))
    except AttributeError:  # not on this system
        cores = os.cpu_count() or 1
    return max(1, min(cores, count // A_JOB))


def over(
    task: Callable[[Path], Answer],
    stopped: Callable[[Path], Answer],
    specs: Sequence[Path],
    jobs: int,
) -> Generator[Answer, None, None]:
    """Yield the answer of a task about each spec, by so many processes at a time.

    ``stopped`` answers for a spec that Ctrl-C left undone.
    """
    if jobs < 2 or len(specs) < 2:
        yield from map(task, specs)
        return
    with closing(_spread(task, specs, min(jobs, len(specs)))) as answers:
        done = 0
        try:
            for answer in answers:
                done += 1
                yield answer
        except KeyboardInterrupt:
            yield from map(stopped, specs[done:])


def _spread(
    task: Callable[[Path], Answer], specs: Sequence[Path], jobs: int
) -> Generator[Answer, None, None]:
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import get_context

    from flexcli.cli import progress
    from flexcli.spec.references import is_from_anywhere

    now = progress.run.get()
    end = None if now is None or now.end is None else time() + now.end - monotonic()
    pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"))
    try:
        told = [pool.submit(_in_process, task, spec, is_from_anywhere(), end) for spec in specs]
        done = 0
        try:
            for future in told:
                yield future.result()
                done += 1
        except BrokenProcessPool:  # one was killed, as for want of memory: the rest one by one
            yield from map(task, islice(specs, done, None))
    finally:
        pool.shutdown(cancel_futures=True)


def _in_process(
    task: Callable[[Path], Answer], spec: Path, allow_outside: bool, end: float | None
) -> Answer:
    """Return an answer in a process of its own, with what the command line allowed."""
    from flexcli.cli import progress
    from flexcli.spec.references import from_anywhere

    progress.run.set(progress.Run(None if end is None else max(end - time(), 1e-3)))
    with from_anywhere(allow_outside):
        return task(spec)
