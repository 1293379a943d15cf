"""The quality factor of cases that state none: by the mechanism's damping, or the material's."""

from typing import Any

from pydantic import ValidationError

from flexcli.parts.material import Material

__all__ = ["with_default_quality"]

SHAKEN = ("asd", "axes", "shock", "sine", "sweep", "sines")
"""Loads of a case that a quality factor applies to."""


def with_default_quality(data: Any) -> Any:
    """Return a design as a spec has it, a quality factor in cases that vibrate and state none.

    It is that of the material's loss factor. Where the mechanism states its damping, that is used,
    also for shocks beside a load that has a Q of its own.
    """
    if not isinstance(data, dict) or not isinstance(data.get("cases"), dict):
        return data
    mechanism = data.get("mechanism")
    if isinstance(mechanism, dict) and "damping" in mechanism:
        return {**data, "cases": _damped(data["cases"], mechanism["damping"])}
    quality = _quality_of(data.get("material"))
    if quality is None:
        return data
    cases = {
        name: {**case, "q": quality} if _lacks_q(case) else case
        for name, case in data["cases"].items()
    }
    return {**data, "cases": cases}


def _quality_of(material: Any) -> float | None:
    """Return Q by the loss factor of a material, as a spec has it or read already."""
    if isinstance(material, Material):
        found = material.loss_factor
        return None if found is None else 1.0 / found.value
    given = material.get("loss_factor") if isinstance(material, dict) else None
    given = given.get("value") if isinstance(given, dict) else given
    try:
        return 1.0 / float(given) if given is not None else None
    except (TypeError, ValueError, ZeroDivisionError):
        return None  # which the material's own field tells


def _damped(cases: dict[str, Any], damping: Any) -> dict[str, Any]:
    """Return the cases of a spec with the mechanism's Q where they, or their shocks, lack one."""
    from flexcli.parts.mechanisms.base import Damping

    try:
        quality = Damping.model_validate(damping).quality
    except ValidationError:
        return cases  # which the mechanism's own field tells
    return {name: _with_quality(case, quality) for name, case in cases.items()}


def _with_quality(case: Any, quality: float) -> Any:
    if _lacks_q(case):
        return {**case, "q": quality}
    shock = case.get("shock") if isinstance(case, dict) and case.get("q") is None else None
    if not isinstance(shock, dict) or "q" in shock:
        return case
    return {**case, "shock": {**shock, "q": quality}}


def _lacks_q(case: Any) -> bool:
    """Return whether a case, as a spec has it, vibrates and states no Q anywhere."""
    if not isinstance(case, dict) or case.get("q") is not None:
        return False
    shaken = [case[key] for key in SHAKEN if case.get(key) is not None]
    return bool(shaken) and not any(isinstance(load, dict) and "q" in load for load in shaken)
