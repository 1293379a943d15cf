# %% [markdown]
# # Vary one size
#
# `overrides` puts values over those of a spec, by their paths. Here the blades of the lecture's
# leaf-spring stage get thicker, step by step.

# %%
import flexcli

SPEC = "examples/lecture-leaf-spring/flexure.yaml"
rows = []
for microns in (150, 200, 250, 300):
    result = flexcli.check(SPEC, overrides={"geometry.h": f"{microns} um"})
    (row,) = (row for row in result.records() if row["name"].startswith("yield"))
    rows.append({"h [µm]": microns, **{key: row[key] for key in ("factor", "verdict", "model")}})
rows

# %% [markdown]
# Bending stress grows with the thickness at a given stroke, so the factor falls as 1/h:

# %%
[round(row["h [µm]"] * row["factor"] / 1e3, 3) for row in rows]
