"""Many tasks over the workers of a Dask cluster: answers in the order of the tasks.

The scheduler has the queue: what a lost worker was doing, or had done, another one does.
"""

from collections import deque
from collections.abc import Callable, Generator, Sequence
from functools import partial
from importlib import import_module
from logging import CRITICAL, getLogger
from pickle import dumps, loads
from typing import Any, TypeVar

from flexcli import __version__
from flexcli.errors import Finding, NoSolution, SpecError

__all__ = ["OPTION", "over_workers"]

OPTION = "--scheduler"

PATIENCE = 10.0
"""Seconds in which a scheduler answers."""

Task = TypeVar("Task")
Answer = TypeVar("Answer")


def over_workers(
    do: Callable[[Task], Answer], tasks: Sequence[Task], scheduler: str
) -> Generator[Answer, None, None]:
    """Yield the answer to each task in order, done by the workers of a scheduler.

    What ends worker after worker, as for want of memory, is done here.

    Raises
    ------
    SpecError
        When Dask is not installed, no scheduler answers, or a worker has another version.
    NoSolution
        When the scheduler is lost.

    """
    from flexcli.spec.references import is_from_anywhere

    distributed = _installed()
    client = _client(distributed, scheduler)
    try:
        task = partial(_on_worker, do, __version__, is_from_anywhere())
        told = deque(zip(tasks, client.map(task, tasks, pure=False), strict=True))
        while told:
            of, future = told.popleft()  # forgotten once told, it is kept on no worker
            try:
                yield loads(future.result())
            except distributed.KilledWorker:
                yield do(of)
    except distributed.CancelledError as error:
        text = f"the scheduler {scheduler} was lost"
        hint = "start it and run this again; a sweep goes on by --resume"
        raise NoSolution("scheduler-lost", text, hint) from error
    finally:
        client.close()


def _installed() -> Any:
    try:
        return import_module("distributed")
    except ImportError as error:
        hint = "pip install 'flexcli[cluster]'"
        raise SpecError([Finding(OPTION, "a cluster needs the extra 'cluster'", hint)]) from error


def _client(distributed: Any, scheduler: str) -> Any:
    getLogger("distributed.client").setLevel(CRITICAL)  # what it logs is told here, in one line
    try:
        return distributed.Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:  # a TimeoutError is an OSError
        hint = "start one by 'dask scheduler', and 'dask worker' on each machine"
        text = f"no scheduler answers at '{scheduler}'"
        raise SpecError([Finding(OPTION, text, hint)]) from error


def _on_worker(
    do: Callable[[Task], Answer], version: str, allow_outside: bool, task: Task
) -> bytes:
    """Return an answer on a worker, with what the command line allowed.

    It is pickled here, for Dask's own serialization makes plain tuples of named ones.
    """
    from flexcli.spec.references import from_anywhere

    if version != __version__:
        text = f"a worker has flexcli {__version__}, this is {version}"
        raise SpecError([Finding(OPTION, text, "install the same version everywhere")])
    with from_anywhere(allow_outside):
        return dumps(do(task))
