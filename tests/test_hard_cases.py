"""Every hard case says what usually breaks."""

import ast
from pathlib import Path

import pytest

FILES = sorted((Path(__file__).parent / "hard_cases").glob("test_*.py"))


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_case_has_a_sentence(file):
    """A case without its reason is taken out by the next one who finds it slow."""
    functions = [n for n in ast.walk(ast.parse(file.read_text())) if isinstance(n, ast.FunctionDef)]
    cases = [f for f in functions if f.name.startswith("test_")]
    assert cases
    assert [case.name for case in cases if not ast.get_docstring(case)] == []
