"""Limbs between thick notches are as soft as plane bodies: finite elements at shapes not fitted."""

from functools import cache

import pytest
from plates import hinged_limb

from flexcli.formulas.hinged_limb import SHEARED, limb_softening

SHAPES = {
    "thin": (0.035, 6.0), "slender": (0.3, 17.0), "usual": (0.15, 5.0), "short": (0.4, 2.3),
    "thick": (0.75, 3.1), "as thick as round": (1.0, 8.0), "no limb": (0.55, 2.05),
}  # fmt: skip
"""Thickness of the throats and distance between them, in radii."""

BLOCKS = {
    "clamped": (0.02, 0.0), "short": (0.25, 0.0), "square": (0.9, 0.0), "long": (2.3, 0.0),
    "massive": (0.45, 1.5),
}  # fmt: skip
"""Length of the blocks in heights of a mouth, and by which share of it they rise."""

POISSON = {"clamped": 0.3, "short": 0.0, "square": 0.3, "long": 0.45, "massive": 0.2}

ELEMENTS = 1e-4
"""Error of the finite elements, and of the places along a beam."""


@cache
def body(shape, block):
    e, l = SHAPES[shape]
    length, rise = BLOCKS[block]
    return hinged_limb.solid(e=e, l=l, block=length, rise=rise, nu=POISSON[block])


def limb(shape, block):
    e, l = SHAPES[shape]
    length, rise = BLOCKS[block]
    return limb_softening(e=e, r=1.0, l=l, blocks="massive" if rise else length * (e + 2.0))


def unstated(shape):
    e, l = SHAPES[shape]
    return limb_softening(e=e, r=1.0, l=l)


def softer(span, found, sheared=0.0):
    """Return the stiffness of the body over the beam's, and its bounds."""
    beam = span.beam + sheared
    return span.beam / span.high, beam / found, span.beam / span.low


def holds(low, found, high):
    return low - ELEMENTS <= found <= high + ELEMENTS


@pytest.mark.slow
@pytest.mark.parametrize("block", BLOCKS)
@pytest.mark.parametrize("shape", SHAPES)
def test_a_limb_is_as_soft_as_the_plane_body(shape, block):
    found = body(shape, block)
    told = [limb(shape, block)] + ([unstated(shape)] if block != "long" else [])
    for each in told:
        # the beam of both is that of the body's own Poisson's ratio
        sheared = (2.4 * (1.0 + POISSON[block]) - SHEARED) * each.along.beam
        assert holds(*softer(each.turn, found.turn))
        assert holds(*softer(each.swing, found.swing, sheared))


@pytest.mark.slow
@pytest.mark.parametrize("block", BLOCKS)
@pytest.mark.parametrize("shape", SHAPES)
def test_a_limb_stretches_and_shortens_as_the_plane_body(shape, block):
    found = body(shape, block)
    told = [limb(shape, block)] + ([unstated(shape)] if block != "long" else [])
    for each in told:
        assert holds(each.along.low, found.along, each.along.high)
        assert holds(each.arc.low, found.arc, each.arc.high)
        assert holds(each.sway.low, found.sway, each.sway.high)


def test_stated_blocks_leave_little_open():
    for shape in SHAPES:
        for block in BLOCKS:
            for span in limb(shape, block)[:2]:
                assert span.high - span.low < 0.2 * span.value


def test_blocks_are_bent_by_the_force_of_a_stage_most():
    """Its moment rises beyond the hinges, as that of a pivot whose moment is constant does not."""
    found = limb("short", "square")
    turn, swing = (each.beam / each.value for each in found[:2])
    assert swing < 0.8 < turn < 1.0


def test_thin_throats_are_the_beam():
    found = limb_softening(e=1e-4, r=1.0, l=5.0, blocks=1.0)
    for span in (found.turn, found.swing, found.sway, found.arc):
        assert span.value == pytest.approx(span.beam, rel=1e-3)
