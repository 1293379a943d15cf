"""A long run can be watched: whoever listens hears what is being done."""

from flexcli import api
from flexcli.results.activity import listener

SPEC = """\
flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.33, yield_strength: 900 MPa}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: {free: [0.1 mm, 1 mm]}, l: 10 mm, b: 2 mm}
stroke: {rotation: 2 deg}
requirements: {yield: 1}
size: {objective: least-volume, round: {h: 10 um}}
"""


def test_a_sizing_tells_its_rounds_its_grid_and_what_is_judged():
    heard = []
    token = listener.set(heard.append)
    try:
        api.size(SPEC)
    finally:
        listener.reset(token)
    for words in ("optimum", "grid", "yield"):
        assert any(words in text for text in heard)
