"""How the blades of a joint bend, kind by kind: what each effect changes in its numbers."""

from flexcli.parts.bending.base import Bending, Change, Changes, whole
from flexcli.parts.bending.of import bending_of

__all__ = ["Bending", "Change", "Changes", "bending_of", "whole"]
