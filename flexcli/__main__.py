"""The process of the ``flexure`` command: what must be set before any library is imported."""

import gc
import os

GARBAGE_THRESHOLD = 100_000
"""New objects between searches for garbage; Python's own 700 cost a tenth of a short run."""


def main() -> None:
    """Set up the process and run the command line."""
    gc.set_threshold(GARBAGE_THRESHOLD)
    # pydantic would read the metadata of every installed package to look for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    # matrices are small: threads that wait for each other take many times as long as one alone
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from flexcli.cli.app import main as run

    try:
        run()
    finally:
        gc.freeze()  # the end of the process need not search all that was imported


if __name__ == "__main__":
    main()
