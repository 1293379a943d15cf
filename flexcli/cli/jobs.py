"""Many tasks over the cores of the machine, or a cluster: answers in the order of the tasks."""

import os
from collections.abc import Callable, Generator, Sequence
from contextlib import closing
from itertools import islice
from time import monotonic, time
from typing import TypeVar

__all__ = ["over", "usual_jobs"]

A_JOB = 4
"""Tasks for which a further process is worth its start."""

Task = TypeVar("Task")
Answer = TypeVar("Answer")


def usual_jobs(count: int) -> int:
    """Return in how many processes so many tasks are done."""
    try:
        cores = len(os.sched_getaffinity(0))
    except AttributeError:  # not on this system
        cores = os.cpu_count() or 1
    return max(1, min(cores, count // A_JOB))


def over(
    do: Callable[[Task], Answer],
    stopped: Callable[[Task], Answer],
    tasks: Sequence[Task],
    jobs: int,
    scheduler: str = "",
) -> Generator[Answer, None, None]:
    """Yield the answer to each task in order, done in so many processes at a time.

    ``stopped`` answers for a task that Ctrl-C left undone. With the address of a Dask
    ``scheduler`` its workers do them.
    """
    if scheduler:
        from flexcli.cli.cluster import over_workers

        spread = over_workers(do, tasks, scheduler)
    elif jobs < 2 or len(tasks) < 2:
        yield from map(do, tasks)
        return
    else:
        spread = _spread(do, tasks, min(jobs, len(tasks)))
    with closing(spread) as answers:
        done = 0
        try:
            for answer in answers:
                done += 1
                yield answer
        except KeyboardInterrupt:
            yield from map(stopped, tasks[done:])


def _spread(
    do: Callable[[Task], Answer], tasks: Sequence[Task], jobs: int
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
        told = [pool.submit(_in_process, do, task, is_from_anywhere(), end) for task in tasks]
        done = 0
        try:
            for future in told:
                yield future.result()
                done += 1
        except BrokenProcessPool:  # one was killed, as for want of memory: the rest one by one
            yield from map(do, islice(tasks, done, None))
    finally:
        pool.shutdown(cancel_futures=True)


def _in_process(
    do: Callable[[Task], Answer], task: Task, allow_outside: bool, end: float | None
) -> Answer:
    """Return an answer in a process of its own, with what the command line allowed."""
    from flexcli.cli import progress
    from flexcli.spec.references import from_anywhere

    progress.run.set(progress.Run(None if end is None else max(end - time(), 1e-3)))
    with from_anywhere(allow_outside):
        return do(task)
