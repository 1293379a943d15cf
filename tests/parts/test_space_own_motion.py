"""The lowest frequency of mechanisms in space, its error."""

import yaml
from twins.space_scenes import space_scene

import flexcli


def test_a_mode_whose_part_is_about_as_small_as_counts_is_in_the_range():
    """CalculiX's solids have 328.2 Hz: a mode in which the drive takes just 1 % of its part."""
    drawn = space_scene(142)
    spec = yaml.safe_dump({**drawn.spec, "requirements": drawn.easy})
    (row,) = (c for c in flexcli.check(spec).checks if c.name.startswith("frequency"))
    low, high = (end / row.factor for end in row.factor_range)
    assert low < 1.0 < high
    assert low * row.capacity < 328.2 < high * row.capacity
