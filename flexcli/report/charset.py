"""Text that any stream can show: without control characters, and in its own alphabet."""

import codecs
import unicodedata

from flexcli.errors import printable

__all__ = ["TRANSLITERATE", "plain"]

TRANSLITERATE = "flexcli.transliterate"
"""Name of the error handler that writes what an encoding lacks in ASCII."""

_SPELT = {
    "²": "^2", "³": "^3", "½": "1/2", "µ": "u", "·": "*", "×": "x", "√": "sqrt", "∂": "d",
    "∞": "inf", "∠": "at", "±": "+-", "−": "-", "–": "-", "—": "-", "…": "...", "•": "*",
    "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "←": "<-", "°": "deg", "’": "'", "∫": "int",
    "┤": "|", "█": "#", "░": ".", "┃": "|", "╂": "+", "✓": "v", "✕": "x", "\ufffd": "?",
}  # fmt: skip
_BRAILLE = 0x2800
_UPPER, _LOWER = 0x1B, 0xE4
"""Dots of the two upper rows of a braille character, and of the two lower ones."""


def plain(text: str, encoding: str = "utf-8") -> str:
    """Return a text of one line that cannot steer a terminal and that an encoding has."""
    return printable(text).encode(encoding, TRANSLITERATE).decode(encoding)


def _spelt(character: str) -> str:
    """Return a character in ASCII: by the table, a Greek letter by name, else without accents."""
    if character in _SPELT:
        return _SPELT[character]
    dots = ord(character) - _BRAILLE
    if 0 <= dots <= 0xFF:
        return " '.:"[bool(dots & _UPPER) + 2 * bool(dots & _LOWER)]
    name = unicodedata.name(character, "")
    if name.startswith("GREEK"):
        letter = name.partition(" LETTER ")[2].partition(" WITH ")[0].removeprefix("FINAL ")
        return letter.capitalize() if "CAPITAL" in name else letter.lower()
    simple = unicodedata.normalize("NFKD", character)
    return "".join(c for c in simple if c.isascii()) or "?"


def _transliterate(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_spelt, error.object[error.start : error.end])), error.end


codecs.register_error(TRANSLITERATE, _transliterate)
