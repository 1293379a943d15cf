"""Oscillators of one mode for the tests of stops."""

import numpy as np

from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.response import steady_steps
from flexcli.numerics.signal_pieces import Piece


def oscillator(angular=1.0, damping=0.0):
    """Give unit mass on a spring."""
    one = np.ones(1)
    return ModalBlade(
        angular=angular * one,
        damping=damping * one,
        base=one,
        tip=one,
        stop=one,
        base_moment=angular**2 * one,
    )


def quiet(duration, pieces=1):
    """Give silence in equal pieces."""
    return [Piece(duration / pieces, ())] * pieces


def stepped(blade, stops, **base):
    """Give the steady steps of a base's sine, and their peaks of travel."""
    steps = list(steady_steps(blade, stops, **base))
    return steps, np.array([step.peaks.travel for step in steps])
