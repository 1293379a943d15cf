"""Formulas for calculation by hand: explain prints them, no verdict rests on them."""

from flexcli.formulas import guide_support
from flexcli.formulas.handbook import (
    actuator,
    contact_load,
    impact,
    large_stroke,
    loaded_pivot,
    stop_numbers,
    thick_pivot,
    tip_mass,
)

__all__ = ["CARDS"]

CARDS = (
    *actuator.CARDS,
    *contact_load.CARDS,
    *guide_support.CARDS,
    *impact.CARDS,
    *large_stroke.CARDS,
    *loaded_pivot.CARDS,
    *stop_numbers.CARDS,
    *thick_pivot.CARDS,
    *tip_mass.CARDS,
)
