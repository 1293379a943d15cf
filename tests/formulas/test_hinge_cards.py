"""Cards of hinges and of what is made of them: examples run, sheets and charts are complete."""

import doctest
import inspect

import numpy as np
import pytest

from flexcli.formulas import (
    hinged_pivot,
    hinged_stage,
    necked_buckling,
    necked_choice,
    necked_size,
    necked_stage,
    notch,
    notch_compliance,
    notch_law,
    stress_concentration,
)
from flexcli.formulas.card import sheet

MODULES = (
    necked_stage,
    necked_buckling,
    necked_size,
    necked_choice,
    notch,
    notch_law,
    notch_compliance,
    stress_concentration,
    hinged_stage,
    hinged_pivot,
)
CARDS = [card for module in MODULES for card in module.CARDS]


@pytest.mark.parametrize("module", MODULES, ids=lambda m: m.__name__.rpartition(".")[2])
def test_docstring_examples_run(module):
    result = doctest.testmod(module)
    assert result.attempted > 0
    assert result.failed == 0


def test_each_card_has_a_name_of_its_own():
    names = [card.name for card in CARDS]
    assert len(set(names)) == len(names)


@pytest.mark.parametrize("card", CARDS, ids=lambda card: card.name)
def test_a_card_can_be_explained(card):
    said = sheet(card.function)
    assert said.title
    assert said.equation
    assert said.source
    assert said.gives
    named = {symbol.name for symbol in said.symbols}
    assert set(inspect.signature(card.function).parameters) == named
    assert np.isfinite(
        np.hstack([np.ravel(v) for v in _values(card.function(**card.example))])
    ).all()


def _values(result):
    return result if isinstance(result, tuple) else (result,)


@pytest.mark.parametrize("card", [card for card in CARDS if card.tables], ids=lambda c: c.name)
def test_charts_have_finite_values_over_their_variable(card):
    for table in card.tables.values():
        assert list(table.values) == sorted(table.values)
        for _, column in table.columns.values():
            assert np.isfinite([column(value) for value in table.values]).all()
