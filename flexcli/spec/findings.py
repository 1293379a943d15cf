"""Findings from pydantic's errors: by type and context, never by their English text."""

from collections.abc import Iterable, Iterator
from difflib import SequenceMatcher, get_close_matches
from functools import cache
from itertools import takewhile
from types import UnionType
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError

from flexcli.errors import Finding
from flexcli.parts.base import Part, said
from flexcli.parts.fields import note
from flexcli.parts.named import Kinds, Named, marked
from flexcli.spec.document import MAX_FINDINGS, Document, finding_at

__all__ = ["findings_of", "nearest", "path_text", "with_nearest_kinds"]

Path = tuple[str | int, ...]

NEAR = 0.6
"""Similarity of two words (difflib's) from which one may be a misspelling of the other."""

FEW = 8
"""Number of keys of a part that a hint about a misplaced key also names."""

_EXPECTED = {
    "string_type": ("a text", "write it in quotes if it looks like a number"),
    "int_type": ("a whole number", "write e.g. 4"),
    "list_type": ("a list", "write [first, second]"),
    "tuple_type": ("a list", "write [first, second]"),
    "dict_type": ("a mapping", "write 'name: value' lines below the key"),
}
"""What each of pydantic's type errors expects, and how it is written."""


def nearest(word: str, names: Iterable[str]) -> str:
    """Return "did you mean …" for the nearest name, or the names themselves."""
    known = sorted(names)
    close = _close(word, known)
    if close:
        return f"did you mean '{close}'?"
    shown = ", ".join(known[:12]) + (", …" if len(known) > 12 else "")
    return f"one of: {shown}" if known else ""


def _close(word: str, names: Iterable[str], cutoff: float = NEAR) -> str | None:
    spelled = {name.casefold(): name for name in names}
    close = get_close_matches(word[:60].casefold(), spelled, n=1, cutoff=cutoff)
    return spelled[close[0]] if close else None


def path_text(path: Iterable[str | int]) -> str:
    """Return a path as people write it: ``cases.operation.points[2]``."""
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text


def findings_of(
    error: ValidationError, model: Any, document: Document, below: Path = ()
) -> list[Finding]:
    """Return a finding for each of pydantic's errors about the value ``below`` the root."""
    raws = error.errors(include_url=False)
    keys = [raw["loc"] for raw in raws if raw["type"] == "extra_forbidden"][:MAX_FINDINGS]
    meant = {(loc[:-1], _meant(model, loc).required) for loc in keys}
    raws = [r for r in raws if r["type"] != "missing" or (r["loc"][:-1], r["loc"][-1]) not in meant]
    found = []
    for raw in raws[:MAX_FINDINGS]:
        fault = _fault(raw, model)
        place, path = document.position.closest((*below, *fault.path))
        # a mapping or a list is pointed at by its key, not by the first of what it holds
        at_key = bool(path) and (fault.at_key or bool(place.children))
        found.append(
            finding_at(
                place, document.lines, path_text(path), fault.text, fault.hint, at_key=at_key
            )
        )
    if len(raws) > MAX_FINDINGS:
        text = f"{len(raws) - MAX_FINDINGS} more findings are not shown"
        found.append(Finding(document.file, text, "mend the ones shown first"))
    return found


class _Fault(NamedTuple):
    """One mistake: its path in pydantic's steps, what is wrong, what would be right."""

    path: Path
    text: str
    hint: str
    at_key: bool = False


def _fault(raw: Any, model: Any) -> _Fault:
    kind, loc, given, context = raw["type"], raw["loc"], raw["input"], raw.get("ctx", {})
    match kind:
        case "spec":
            return _Fault((*loc, *context["at"]), context["text"], context["hint"])
        case "extra_forbidden":
            return _Fault(loc, f"unknown key '{loc[-1]}'", _meant(model, loc).hint, at_key=True)
        case "missing":
            hint = _how_to_add(str(loc[-1]), model, loc[:-1])
            return _Fault(loc[:-1], f"'{loc[-1]}' is missing", hint, at_key=True)
        case "literal_error":
            text = f"{said(given)} is not known here"
            if not isinstance(given, str):
                text = f"a name is expected here, not {said(given)}"
            return _Fault(loc, text, _choice(given, context["expected"]))
        case "union_tag_invalid":
            tag = context["discriminator"].strip("'")
            text = f"{said(given[tag])} is not a known {_noun(loc)}"
            near = _nearest_kind(raw, model)
            hint = f"did you mean '{near.tag}'? it takes {near.shown}" if near else ""
            hint = hint or _choice(given[tag], context["expected_tags"])
            return _Fault((*loc, tag), text, hint)
        case "union_tag_not_found":
            return _without_tag(raw, model)
        case "too_short":
            return _Fault(loc, "is empty", f"give at least {context['min_length']}")
        case "greater_than_equal":
            return _Fault(loc, f"{said(given)} must be at least {context['ge']}", "write more")
        case "less_than_equal":
            return _Fault(loc, f"{said(given)} must be at most {context['le']}", "write less")
        case "none_required":
            return _Fault(loc, "nothing can be given here", "take the key out", at_key=True)
    if kind in ("model_type", "model_attributes_type"):
        text = f"a mapping is expected here, not {said(given)}"
        return _Fault(loc, text, f"give its keys: {_some_keys(model, loc)}")
    if kind in _EXPECTED:
        expected, hint = _EXPECTED[kind]
        return _Fault(loc, f"{expected} is expected here, not {said(given)}", hint)
    return _Fault(loc, f"{said(given)} cannot stand here", "see 'flexure schema' for what may")


def _without_tag(raw: Any, model: Any) -> _Fault:
    """Return what is wrong with a mapping without its kind, or with a misspelt key for it."""
    loc, tag = raw["loc"], raw["ctx"]["discriminator"].strip("'")
    misspelled = _misspelled_tag(raw, model)
    if misspelled is not None:
        text = f"unknown key '{misspelled}'"
        return _Fault((*loc, misspelled), text, f"did you mean '{tag}'?", at_key=True)
    kinds = ", ".join(str(k) for m in _models_at(model, loc) for k in _tag_values(m))
    near = _nearest_kind(raw, model)
    fits = f"its keys fit '{near.tag}'; " if near else ""
    return _Fault(loc, f"'{tag}' is missing", f"{fits}say which {_noun(loc)}: {kinds}", at_key=True)


def _misspelled_tag(raw: Any, model: Any) -> str | None:
    """Return the key that was meant to give the kind."""
    loc, given, tag = raw["loc"], raw["input"], raw["ctx"]["discriminator"].strip("'")
    close = _close(tag, (key for key in given if isinstance(key, str)))
    return close if close is not None and close not in _keys_at(model, loc) else None


class _Kind(NamedTuple):
    """The kind that a mapping most likely is meant to be, and the keys that it takes."""

    tag: str
    keys: tuple[str, ...]

    @property
    def shown(self) -> str:
        return ", ".join(self.keys[:12]) + (", …" if len(self.keys) > 12 else "")


def _nearest_kind(raw: Any, model: Any) -> _Kind | None:
    """Return the kind of the nearest name whose keys fit best, or else that of the most keys."""
    given, tag = raw["input"], raw["ctx"]["discriminator"].strip("'")
    kinds = {str(k): m for m in _models_at(model, raw["loc"]) for k in _tag_values(m)}
    if not isinstance(given, dict) or not kinds:
        return None
    misspelled = _misspelled_tag(raw, model)
    named = str(given.get(tag, given.get(misspelled, "")))[:60].casefold()
    keys = {str(key) for key in given} - {tag, misspelled}
    near = {name: SequenceMatcher(None, named, name).ratio() for name in kinds}
    words = set(named.split("-"))
    close = [k for k in kinds if near[k] >= NEAR or words & set(k.split("-")) == set(k.split("-"))]
    if not close:
        shared = {name: len(keys & set(_fields(m))) for name, m in kinds.items()}
        most = max(shared.values())
        close = [name for name, count in shared.items() if count == most and 2 * most > len(keys)]
    best = min(close, key=lambda name: _misfit(keys, kinds[name]) - near[name], default=None)
    if best is None:
        return None
    return _Kind(best, tuple(key for key in _fields(kinds[best]) if key != tag))


def _misfit(keys: set[str], model: type[BaseModel]) -> float:
    """Return how many keys a kind does not know or lacks; a similar key counts half."""
    known = {info.alias or name: info.is_required() for name, info in model.model_fields.items()}
    lacking = {key for key, is_required in known.items() if is_required} - keys - {"kind"}
    misfit = 0.0
    for key in keys - set(known):
        close = _close(key, lacking)
        lacking.discard(close or "")
        misfit += 0.5 if close else 1.0
    return misfit + len(lacking)


def with_nearest_kinds(value: Any, error: ValidationError, model: Any) -> Any | None:
    """Return a value with unknown kinds put right, for the rest of it to be validated too.

    Nothing when there is no unknown kind in it, or none is near.
    """
    mended = value
    for raw in error.errors(include_url=False):
        if raw["type"] not in ("union_tag_invalid", "union_tag_not_found"):
            continue
        near = _nearest_kind(raw, model)
        if near is not None:
            tag = raw["ctx"]["discriminator"].strip("'")
            gone = _misspelled_tag(raw, model) if tag not in raw["input"] else None
            rest = {key: inner for key, inner in raw["input"].items() if key != gone}
            mended = _put(mended, raw["loc"], {**rest, tag: near.tag})
    return None if mended is value else mended


def _put(value: Any, loc: Path, new: Any) -> Any:
    """Return a value with another at a pydantic location, whose own steps are passed over."""
    if not loc:
        return new
    step, rest = loc[0], loc[1:]
    if isinstance(value, dict) and step in value:
        return {**value, step: _put(value[step], rest, new)}
    if isinstance(value, list) and isinstance(step, int) and step < len(value):
        return [*value[:step], _put(value[step], rest, new), *value[step + 1 :]]
    return _put(value, rest, new)


def _noun(loc: Path) -> str:
    return next((str(step) for step in reversed(loc) if isinstance(step, str)), "kind")


def _choice(given: Any, expected: str) -> str:
    names = [name.strip().strip("'") for name in expected.replace(" or ", ", ").split(",")]
    return nearest(given if isinstance(given, str) else "", names)


class _Meant(NamedTuple):
    """The likely meaning of an unknown key: the hint, and the key beside it that it replaces."""

    hint: str
    required: str = ""


def _meant(model: Any, loc: Path) -> _Meant:
    key, here = str(loc[-1]), _keys_at(model, loc[:-1])
    close, homes = _close(key, here), _homes(model)
    elsewhere = key if key in homes else _close(key, homes, cutoff=0.75)
    # a key that belongs elsewhere may be nearer than any that may stand here
    if close is not None and _close(key, (close, elsewhere or close)) == close:
        return _Meant(f"did you mean '{close}'?", close)
    if elsewhere is None:
        return _Meant(nearest(key, here))
    home = max(homes[elsewhere], key=lambda path: _shared(path, loc))
    if set(home) <= set(loc):  # a key of another kind of the same thing
        return _Meant(nearest(key, here))
    place = path_text(home) or "the top level"
    required = str(home[0]) if home else ""
    if elsewhere == key:
        far = not _shared(home, loc) and len(here) <= FEW
        instead = f"; here may stand {', '.join(sorted(here))}" if far else ""
        return _Meant(f"'{key}' belongs in {place}{instead}", required)
    return _Meant(f"did you mean '{elsewhere}' (in {place})?", required)


def _shared(path: Path, loc: Path) -> int:
    """Return how far two paths agree, any name matching ``<name>``."""
    pairs = zip(path, loc, strict=False)
    return sum(1 for _ in takewhile(lambda pair: pair[0] in (pair[1], "<name>"), pairs))


def _how_to_add(key: str, model: Any, loc: Path) -> str:
    """Return how a missing key is written, with its example, and what it is."""
    for candidate in _models_at(model, loc):
        for name, info in candidate.model_fields.items():
            if key not in (info.alias, name):
                continue
            about = note(candidate, name)
            line = about.example
            if not line.startswith(f"{key}:"):
                line = f"{key}: {line}".rstrip()
            return f"add '{line}'" + (f" ({about.text})" if about.text else "")
    return f"add '{key}:'"


def _some_keys(model: Any, loc: Path) -> str:
    """Return the keys that a part must have, or may have when it needs none."""
    first = next(iter(_models_at(model, loc)), None)
    fields = first.model_fields if first is not None else {}
    needed = [info.alias or name for name, info in fields.items() if info.is_required()]
    return ", ".join(needed or [info.alias or name for name, info in fields.items()])


def _members(annotation: Any) -> Iterator[Any]:
    """Yield the plain types that an annotation allows, through aliases and unions."""
    origin = get_origin(annotation)
    if origin is Annotated:
        plain, *markers = get_args(annotation)
        named = [m for m in markers if isinstance(m, Kinds | Named)]
        yield from named[0].classes if named else _members(plain)
    elif origin in (Union, UnionType):
        for member in get_args(annotation):
            yield from _members(member)
    elif origin in (tuple, list):
        yield from (m for a in get_args(annotation) if a is not Ellipsis for m in _members(a))
    elif origin is dict:
        yield from _members(get_args(annotation)[1])
    else:
        yield annotation


def _models(annotation: Any) -> list[type[BaseModel]]:
    return [m for m in _members(annotation) if isinstance(m, type) and issubclass(m, BaseModel)]


def _fields(model: type[BaseModel]) -> dict[str, Any]:
    """Return the keys of a part and their types; one that is written plainly has none."""
    if issubclass(model, Part) and model.is_plain:
        return {}
    return {
        info.alias or name: marked(info.annotation, info.metadata)
        for name, info in model.model_fields.items()
    }


def _models_at(model: Any, loc: Path) -> list[type[BaseModel]]:
    """Return the models that may stand at a pydantic location, following union tags."""
    here = _models(model)
    for step in loc:
        inside = [
            inner
            for candidate in here
            if step in (fields := _fields(candidate))
            for inner in _models(fields[str(step)])
        ]
        here = inside or [c for c in here if step in _tag_values(c)] or here
    return here


def _tag_values(model: type[BaseModel]) -> tuple[Any, ...]:
    kind = _fields(model).get("kind")
    return get_args(kind) if get_origin(kind) is Literal else ()


def _keys_at(model: Any, loc: Path) -> set[str]:
    """Return the keys that a spec may have at a location."""
    return {key for candidate in _models_at(model, loc) for key in _fields(candidate)}


@cache
def _homes(model: Any) -> dict[str, list[Path]]:
    """Return every key that a spec of this kind may have, and the places that have it."""
    homes: dict[str, list[Path]] = {}
    level: list[tuple[Path, Any]] = [((), model)]
    while level:
        inside: list[tuple[Path, Any]] = []
        for path, annotation in level:
            for candidate in _models(annotation):
                for key, inner in _fields(candidate).items():
                    homes.setdefault(key, []).append(path)
                    step = (key, "<name>") if get_origin(inner) is dict else (key,)
                    inside.append(((*path, *step), inner))
        level = inside
    return homes
