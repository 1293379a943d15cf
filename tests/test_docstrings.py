"""Every example in the docstrings of formulas and mechanics runs and gives what it says."""

import doctest
from importlib import import_module
from pkgutil import walk_packages

import pytest

import flexcli

MODULES = tuple(
    each.name
    for each in walk_packages(flexcli.__path__, "flexcli.")
    if each.name.startswith(("flexcli.formulas.", "flexcli.mechanics."))
)


@pytest.mark.parametrize("name", MODULES)
def test_docstring_examples_run(name):
    assert doctest.testmod(import_module(name)).failed == 0
