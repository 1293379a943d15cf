"""What a long run is doing, on a terminal's stderr, and how it ends before its time.

Ctrl-C and the time limit are one thing: a wish to stop at once, with what was done kept.
"""

import signal
import sys
import threading
from _thread import interrupt_main
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from time import monotonic
from typing import Any

from flexcli.results.activity import doing, listener

__all__ = ["Run", "bounded", "run", "watched"]

PATIENCE = 1.0
"""Seconds before a run says what it is doing."""


class Run:
    """One call of a verb: until when it may take, and why it ended before its time."""

    def __init__(self, limit: float | None = None) -> None:
        self.limit = limit
        self.end = None if limit is None else monotonic() + limit
        self.stopped = ""

    def time_is_up(self) -> None:
        """Interrupt what runs, for its time is over."""
        self.stopped = f"not done within the time limit of {self.limit:g} s"
        interrupt_main()

    @property
    def remedy(self) -> str:
        """Return what to do about a run that was stopped."""
        if self.limit is None:
            return "run it again to its end"
        return "raise --time-limit, or ask for less at once"


run: ContextVar[Run | None] = ContextVar("run", default=None)


@contextmanager
def bounded(what: str) -> Iterator[None]:
    """Raise KeyboardInterrupt at Ctrl-C or when the run's time is up; show what takes long."""
    now = run.get() or Run()
    if threading.current_thread() is not threading.main_thread():
        yield  # no signal reaches it
        return
    if now.stopped or (now.end is not None and now.end <= monotonic()):
        now.stopped = now.stopped or f"not begun within the time limit of {now.limit:g} s"
        raise KeyboardInterrupt
    before = signal.getsignal(signal.SIGINT)

    def stop(*_: Any) -> None:
        if before is signal.SIG_IGN and not now.stopped:
            return  # a background job, which its shell shields from Ctrl-C
        now.stopped = now.stopped or "interrupted"
        raise KeyboardInterrupt

    clock = threading.Timer(0.0 if now.end is None else now.end - monotonic(), now.time_is_up)
    clock.daemon = True
    signal.signal(signal.SIGINT, stop)
    try:
        if now.end is not None:
            clock.start()
        with _shown(what):
            yield
    finally:
        clock.cancel()
        signal.signal(signal.SIGINT, before)


@contextmanager
def _shown(what: str) -> Iterator[None]:
    """Show what is being done on a terminal's stderr, once it takes long."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console
    from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    bar = Progress(
        SpinnerColumn(),
        TextColumn("{task.description}", markup=False),
        TimeElapsedColumn(),
        console=Console(stderr=True),
        transient=True,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    task = bar.add_task(what)
    token = listener.set(lambda text: bar.update(task, description=f"{what}: {text}"))
    delay = threading.Timer(PATIENCE, bar.start)
    delay.daemon = True
    delay.start()
    try:
        yield
    finally:
        delay.cancel()
        delay.join()
        bar.stop()
        listener.reset(token)


@contextmanager
def watched() -> Iterator[Callable[[str, float], bool]]:
    """Give a watch: told what runs and the share done, it answers whether to go on.

    The first Ctrl-C, or the end of the time limit, makes it answer no; the second ends the
    program as ever.
    """
    stopped = False

    def stop(*_: Any) -> None:
        nonlocal stopped
        stopped = True
        signal.signal(signal.SIGINT, before)

    def watch(name: str, share: float) -> bool:
        doing(f"{name}, {share:.0%}")
        return not stopped

    before = signal.signal(signal.SIGINT, stop)
    try:
        yield watch
    finally:
        signal.signal(signal.SIGINT, before)
