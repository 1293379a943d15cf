# %% [markdown]
# # Size a blade, and read the answer
#
# A spec may be a file or, as here, text. The stage hangs on two parallel blades, moves by ± 2 mm
# for ten million strokes, and bears 50 N along its blades when it is handled.

# %%
import flexcli

SPEC = """
flexure: 1
title: Parallel-blade stage
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, blades: 2, spacing: 40 mm, h: free, l: free, b: 10 mm}
cases:
  operation:
    stroke: {translation: 2 mm, cycles: 1e7}
  handling:
    load: {force: 50 N, direction: 180 deg}
    ends: clamped-guided
requirements:
  fatigue: 2
  buckling: 3
  l/h: {min: 20, max: 400}
size: {objective: least-volume}
"""
sizing = flexcli.size(SPEC)
sizing

# %% [markdown]
# The answer is a record: `status`, `values` with unit, model and error, `checks` with their ranges.

# %%
sizing.status.value

# %%
{name: f"{1e3 * sizing.values[name].value:.3f} mm" for name in ("h", "l")}

# %% [markdown]
# What 1 % more of each demand costs, as rows that `pandas.DataFrame` takes as they are:

# %%
sizing.records("sizing.sensitivities")

# %% [markdown]
# The sized design goes into any other verb, and into a file that `flexure check` judges in CI.

# %%
design = flexcli.sized(SPEC, sizing)
flexcli.drawing(design)

# %%
print(flexcli.spec_text(design))
