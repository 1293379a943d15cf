"""Cards of the stop, contact and tip-mass formulas: their examples run, their sheets are whole."""

import inspect

import numpy as np
import pytest

from flexcli.formulas import (
    hertz,
    impact,
    line_contact,
    pi_law,
    pi_terms,
    point_contact,
    stop_design,
    stop_line,
    stop_stiffness,
    stopped_bending,
    stopped_cantilever,
    tip_mass,
    tip_mass_beam,
)
from flexcli.formulas.card import sheet

MODULES = (
    hertz,
    impact,
    line_contact,
    pi_law,
    pi_terms,
    point_contact,
    stop_design,
    stop_line,
    stop_stiffness,
    stopped_bending,
    stopped_cantilever,
    tip_mass,
    tip_mass_beam,
)
CARDS = [card for module in MODULES for card in module.CARDS]


def numbers(result):
    if isinstance(result, tuple):
        return [x for part in result for x in numbers(part)]
    values = vars(result).values() if hasattr(result, "__dict__") else [result]
    return [float(x) for value in values for x in np.ravel(value)]


@pytest.mark.parametrize("card", CARDS, ids=lambda card: card.name)
def test_example_gives_finite_numbers(card):
    assert np.isfinite(numbers(card.function(**card.example))).all()


@pytest.mark.parametrize("card", CARDS, ids=lambda card: card.name)
def test_sheet_explains_each_argument_of_the_formula(card):
    said = sheet(card.function)
    assert said.title
    assert said.equation
    assert said.gives
    assert {symbol.name for symbol in said.symbols} == set(
        inspect.signature(card.function).parameters
    )


@pytest.mark.parametrize("card", CARDS, ids=lambda card: card.name)
def test_tables_give_finite_numbers(card):
    for table in card.tables.values():
        for _, column in table.columns.values():
            assert np.isfinite([column(value) for value in table.values]).all()


def test_names_are_unique():
    names = [card.name for card in CARDS]
    assert len(set(names)) == len(names)
