"""What explain tells is true of the code: symbols are arguments, worked cases run."""

import inspect

import numpy as np
import pytest

from flexcli.engine.explain import _topics, explain, topics
from flexcli.errors import SpecError
from flexcli.formulas.card import outside, sheet
from flexcli.formulas.pivot import WITTRICK
from flexcli.units import show

TOPICS = _topics()
CARDS = {card.name: card for topic in TOPICS.values() for card in topic.cards}


@pytest.mark.parametrize("name", CARDS)
def test_the_docstring_of_a_formula_names_every_argument_with_meaning(name):
    card = CARDS[name]
    said = sheet(card.function)
    parameters = list(inspect.signature(card.function).parameters)
    assert sorted(symbol.name for symbol in said.symbols) == sorted(parameters)
    assert all(symbol.meaning for symbol in (*said.symbols, *said.gives))
    assert said.title
    assert said.equation
    assert said.source
    assert set(card.example) <= set(parameters)


@pytest.mark.parametrize("name", CARDS)
def test_the_worked_case_runs_and_lies_where_the_formula_holds(name):
    row = next(r for r in explain(name).formulas if r.name == name)
    assert row.gives
    for symbol in row.gives:
        if isinstance(symbol.value, float):
            assert np.isfinite(symbol.value)
            assert show(symbol.value, symbol.unit.replace("·", "*"))
    assert not outside(CARDS[name].validity, CARDS[name].example)


@pytest.mark.parametrize(
    ("name", "table"), [(n, t) for n, card in CARDS.items() for t in card.tables]
)
def test_every_chart_is_finite_and_in_order(name, table):
    found = explain(name, table).table
    values = next(iter(found.columns.values()))
    assert list(values) == sorted(values)
    for column in found.columns.values():
        assert len(column) == len(values)
        assert np.isfinite(column).all()


def test_every_geometry_and_every_formula_has_a_topic():
    names = {topic.name for topic in topics()}
    assert {"rcc", "cross-spring", "leaf-spring-stage"} <= names
    assert set(CARDS) <= names


def test_no_two_formulas_share_a_name():
    for topic in TOPICS.values():
        assert all(CARDS[card.name].function is card.function for card in topic.cards)


def test_the_names_of_the_lecture_lead_to_the_part():
    assert explain("generalized-cross-spring").name == "cross-spring"
    assert explain("rcc-pivot").name == "rcc"


def test_the_chart_of_the_cross_spring_pivot_has_its_published_points():
    table = explain("cross-spring", "delta").table
    at = {round(d, 6): i for i, d in enumerate(table.columns["delta"])}
    stiffness, ratio = table.columns["K l/(E I)"], table.columns["stiffness ratio"]
    assert stiffness[at[-0.5]] == pytest.approx(2.0)  # 8 (3/4 − 3/2 + 1)
    assert stiffness[at[0.0]] == pytest.approx(8.0)
    assert table.columns["theta_max"][at[0.0]] == pytest.approx(0.4e-2 * 50 / 2)  # σ l/(2 E h)
    assert ratio[at[round(WITTRICK, 6)]] == pytest.approx(8.0 / 3.0)


def test_an_unknown_name_is_answered_with_the_nearest():
    with pytest.raises(SpecError) as error:
        explain("cross-sprng")
    assert "cross-spring" in error.value.findings[0].hint


def test_an_unknown_table_is_answered_with_those_there_are():
    with pytest.raises(SpecError) as error:
        explain("cross-spring", "alpha")
    assert "delta" in error.value.findings[0].hint
