"""A YAML file to a document, or the finding that says why it cannot be read."""

from pathlib import Path

from flexcli.errors import Finding, SpecError, printable
from flexcli.spec.document import Document
from flexcli.spec.parse import parse_document

__all__ = ["MAX_BYTES", "read_document", "text_of"]

MAX_BYTES = 2_000_000


def read_document(path: Path) -> Document:
    """Read a YAML file, or raise :class:`SpecError` when it cannot be read as one."""
    file = str(path)
    try:
        if not path.is_file():
            raise SpecError([_not_a_file(path, file)])
        with path.open("rb") as stream:
            raw = stream.read(MAX_BYTES + 1)
    except OSError as error:
        text = f"cannot be read: {error.strerror}"
        raise SpecError([Finding(file, text, "give the path of a YAML file")]) from error
    return parse_document(text_of(raw, file), file)


def text_of(raw: bytes, file: str) -> str:
    """Return the text of a spec's bytes, or raise :class:`SpecError` where they are none."""
    if len(raw) > MAX_BYTES:
        text = f"is larger than {MAX_BYTES} bytes, too large for a spec"
        raise SpecError([Finding(file, text, "give the path of a spec")])
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        lines = raw[: error.start].decode("utf-8", errors="replace").split("\n")
        raise SpecError(
            [
                Finding(
                    file,
                    "is not UTF-8 text",
                    "save it as UTF-8",
                    line=len(lines),
                    column=len(lines[-1]) + 1,
                    source_line=printable(lines[-1]),
                )
            ]
        ) from error


def _not_a_file(path: Path, file: str) -> Finding:
    if path.is_dir():
        return Finding(file, "is a folder, not a file", "give the path of a YAML file in it")
    if path.is_symlink():
        return Finding(file, "is a link that leads to no file", "give the path of a YAML file")
    if path.exists():
        return Finding(file, "is a device, not a file", "give the path of a YAML file")
    return Finding(file, "there is no such file", "give the path of a YAML file")
