"""Stresses at ends and faces of blades."""

import pytest

from flexcli.parts.requirements.ask import EndStress


@pytest.mark.parametrize(("mean", "axial"), [(30.0, 20.0), (-30.0, -20.0), (30.0, -20.0)])
def test_at_a_face_the_largest_stress_has_the_size_of_all_that_stands_there(mean, axial):
    either = EndStress("root", 40.0, mean, axial)
    assert either.largest == 40.0 + mean + axial
    assert either._replace(is_at_face=True).largest == 40.0 + abs(mean + axial)
