"""flexcli: a design desk for flexure mechanisms.

The verbs of :mod:`flexcli.api` are here too, e.g. ``flexcli.check("flexure.yaml")``; they are
imported when the first of them is asked for.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexcli.api import *

__version__ = "0.3.0"

__all__ = [
    "Loaded",
    "__version__",
    "accuracy",
    "asd_combine",
    "asd_envelope",
    "asd_equal_damage",
    "asd_fds",
    "asd_grms",
    "asd_list",
    "asd_notch",
    "asd_response",
    "asd_scale",
    "asd_show",
    "asd_srs",
    "asd_tolerance",
    "asd_worst_case",
    "balance",
    "check",
    "dossier",
    "drawing",
    "exported",
    "is_sized",
    "joint_drawing",
    "load",
    "plan",
    "simulate",
    "size",
    "sized",
    "spec_text",
    "stops",
    "support_over_stroke",
    "tolerances",
    "validate",
    "verdicts",
    "verify",
]


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module 'flexcli' has no attribute '{name}'")
    from flexcli import api

    return getattr(api, name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
