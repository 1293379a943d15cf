"""Oscillators of one mode for the tests of stops."""

from dataclasses import replace

import numpy as np

from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.periodic import DrivenBlade
from flexcli.mechanics.stopping.response import stepped_motion
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


def polynomial(coefficients, duration):
    """Give one piece, a polynomial of time, lowest power first."""
    return [Piece(duration, ((0j, [complex(c) for c in coefficients]),))]


def steady_steps(blade, stops, *, angular, amplitude, kick=0.0):
    """Yield the steady motion at each frequency of the base, in the order given, without a jump.

    ``amplitude`` is one for all or one for each; ``kick`` the speed of the first mode at the start.
    """
    motion = None
    for omega, A in zip(angular, np.broadcast_to(amplitude, len(angular)), strict=True):
        if motion is None:
            motion = stepped_motion(blade, stops, float(A))
            motion.point.rate[0] = kick
        elif motion.driven.amplitude != A:
            motion = replace(motion, driven=DrivenBlade(blade, stops, float(A)), known=[])
        yield motion.follow(float(omega))


def stepped(blade, stops, **base):
    """Give the steady steps of a base's sine, and their peaks of travel."""
    steps = list(steady_steps(blade, stops, **base))
    return steps, np.array([step.peaks.travel for step in steps])
