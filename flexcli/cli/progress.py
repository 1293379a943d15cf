"""A progress bar on a terminal's stderr, and Ctrl-C as a wish to stop that loses nothing."""

import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

__all__ = ["watched"]


@contextmanager
def watched() -> Iterator[Callable[[str, float], bool]]:
    """Give a watch: told what runs and the share done, it answers whether to go on.

    The first Ctrl-C makes it answer no; the second ends the program as ever.
    """
    from rich.console import Console
    from rich.progress import Progress

    stopped = False

    def stop(*_: Any) -> None:
        nonlocal stopped
        stopped = True
        signal.signal(signal.SIGINT, before)

    before = signal.signal(signal.SIGINT, stop)
    console = Console(stderr=True)
    bar = Progress(console=console, transient=True, disable=not sys.stderr.isatty())
    tasks: dict[str, Any] = {}

    def watch(name: str, share: float) -> bool:
        if name not in tasks:
            tasks[name] = bar.add_task(name, total=1.0)
        bar.update(tasks[name], completed=share)
        return not stopped

    try:
        with bar:
            yield watch
    finally:
        signal.signal(signal.SIGINT, before)
