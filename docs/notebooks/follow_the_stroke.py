# %% [markdown]
# # Follow the stroke
#
# The exact model moves a crossed pivot through its stroke; the closed form knows it at rest.

# %%
from math import degrees

import flexcli

SPEC = flexcli.load("examples/wittrick-crossing/flexure.yaml")
flexcli.drawing(SPEC)

# %%
stroke = flexcli.simulate(SPEC, points=5)
stroke.tables

# %% [markdown]
# Where the blades cross at Wittrick's point the centre hardly shifts, even at five degrees.

# %%
points = stroke.records("sweeps.points")
[{"degrees": degrees(row["travel"]), "nanometres": 1e9 * row["shift_x"]} for row in points]

# %% [markdown]
# All of it, as the JSON contract has it:

# %%
sorted(stroke.to_dict())
