"""Progress of a long run on a terminal's stderr, and its early end.

Ctrl-C and the time limit are one thing: a wish to stop at once, with what was done kept.
"""

import signal
import sys
import threading
from _thread import interrupt_main
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from time import monotonic, sleep
from types import FrameType

from flexcli.results.activity import doing, listener

__all__ = ["Run", "bounded", "run", "watched"]

PATIENCE = 1.0
"""Seconds before a run says what it is doing."""

RETRY, WIND_UP = 0.1, 10.0
"""Seconds from wish to wish while one is not heard, and after one that was."""


class Run:
    """One call of a verb: its time limit, and why it ended early."""

    def __init__(self, limit: float | None = None) -> None:
        self.limit = limit
        self.end = None if limit is None else monotonic() + limit
        self.stopped = ""

    @property
    def remedy(self) -> str:
        """Return what to do about a run that was stopped."""
        if self.limit is None:
            return "run it again to its end"
        return "raise --time-limit, or ask for less at once"


class _Clock:
    """Interrupts the main thread when a run's time is up, again and again until it is done.

    An interruption may be lost in a library that catches everything.
    """

    def __init__(self, run: Run) -> None:
        self.run = run
        self.heard = -WIND_UP
        self.ticking = False
        self.done = False
        self.lock = threading.Lock()
        self.wished = threading.Event()
        threading.Thread(target=self._tick, daemon=True).start()

    def _tick(self) -> None:
        end = self.run.end
        self.wished.wait(None if end is None else max(end - monotonic(), 0.0))
        while True:
            with self.lock:
                if self.done:
                    return
                late = f"not done within the time limit of {self.run.limit or 0.0:g} s"
                self.run.stopped = self.run.stopped or late
                self.ticking = True
                interrupt_main()
            sleep(RETRY)

    def stop(self) -> None:
        """Let it interrupt no more."""
        with self.lock:
            self.done = True
        self.wished.set()

    def is_heard(self, frame: FrameType | None) -> bool:
        """Return whether an interruption is to be obeyed now.

        An import is not interrupted, for half a library cannot be imported again; nor is what
        winds up after an earlier interruption, but by a second Ctrl-C.
        """
        by_clock, self.ticking = self.ticking, False
        self.run.stopped = self.run.stopped or "interrupted"
        while frame is not None:
            if frame.f_code.co_filename == IMPORTING:
                self.wished.set()
                return False
            frame = frame.f_back
        if by_clock and monotonic() < self.heard + WIND_UP:
            return False
        self.heard = monotonic()
        return True


IMPORTING = "<frozen importlib._bootstrap>"

run: ContextVar[Run | None] = ContextVar("run", default=None)
_clock: ContextVar[_Clock | None] = ContextVar("clock", default=None)


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
    clock = _Clock(now)

    def stop(_: int, frame: FrameType | None) -> None:
        if before is signal.SIG_IGN and not now.stopped:
            return  # a background job, which its shell shields from Ctrl-C
        if clock.is_heard(frame):
            clock.wished.set()  # again, where a library's callback swallows this one
            raise KeyboardInterrupt

    signal.signal(signal.SIGINT, stop)
    token = _clock.set(clock)
    try:
        with _shown(what):
            yield
    finally:
        clock.stop()
        _clock.reset(token)
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
    stopped, clock = False, _clock.get()

    def stop(_: int, frame: FrameType | None) -> None:
        nonlocal stopped
        if clock is None or clock.is_heard(frame):
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
