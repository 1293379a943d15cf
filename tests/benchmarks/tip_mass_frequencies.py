"""Explain the measured frequencies of table 7.3 by the offset and rotary inertia of the tip mass.

Run by hand: python tests/benchmarks/tip_mass_frequencies.py
Three numbers that all four samples share are fitted on four of the twenty frequencies and held
against the other sixteen: the offset c and inertia J of the bare tip body, and the offset of the
inserts. Nothing is tuned per beam. Then: which combinations of them the data leave open.
"""

from pathlib import Path

import numpy as np
import yaml
from scipy.optimize import least_squares

from flexcli.formulas.handbook.tip_mass import (
    massless_frequencies,
    tip_mass_frequencies,
)
from flexcli.formulas.section import second_moment
from flexcli.formulas.stop_stiffness import free_stiffness
from flexcli.units import parse_quantity

DATA = Path(__file__).parents[2] / "examples" / "boundary-control" / "table-7-3.yaml"
DENSITY = 2700.0  # kg/m³, aluminium 6061; the blade weighs a tenth of its tip body at the most
FITTED = [(0, 0), (0, 4), (3, 0), (3, 4)]  # shortest and longest blade, lightest and heaviest end
START = np.array([12e-3, 2e-6, 12e-3])
NAMES = ("c of the body", "J of the body", "c of the inserts")


def read():
    """Give blades (E, I, L and mass per length as columns), masses, and measured frequencies."""
    data = yaml.safe_load(DATA.read_text())
    E = parse_quantity(data["youngs_modulus"], "stress")
    h, b, L = (
        np.array([[parse_quantity(row[name], "length")] for row in data["samples"]])
        for name in ("h", "b", "L")
    )
    blade = {"E": E, "I": second_moment(b, h), "L": L, "mass_per_length": DENSITY * b * h}
    masses = (
        parse_quantity(data["tip_mass"], "mass"),
        np.array([parse_quantity(text, "mass") for text in data["inserts"]]),
    )
    measured = np.array(
        [[parse_quantity(f, "frequency") for f in row["frequencies"]] for row in data["samples"]]
    )
    return blade, masses, measured


def body(parameters, masses):
    """Give the tip body with each insert."""
    c, J, c_insert = parameters[:3]
    m = masses[0] + masses[1]
    centre = (masses[0] * c + masses[1] * c_insert) / m
    inertia = J + masses[0] * (c - centre) ** 2 + masses[1] * (c_insert - centre) ** 2
    return {"m": m, "c": centre, "J": inertia}


def model(parameters, blade, masses):
    """Give the first frequency of each sample with each insert."""
    return tip_mass_frequencies(**blade, **body(parameters, masses))[..., 0]


def fit(residual, start):
    """Give the best parameters, scaled by their start, and the logarithmic Jacobian there."""
    result = least_squares(
        lambda p: residual(p * start),
        np.ones_like(start),
        bounds=(0.0, np.inf),  # neither a negative inertia nor a centre below the blade's end
        xtol=1e-12,
        ftol=1e-12,
        diff_step=1e-6,
    )
    best = result.x * start
    return best, result.jac * result.x


def show_errors(title, found, measured, fitted=()):
    """Print the error of each frequency in per cent, the fitted ones marked."""
    error = 100 * (found / measured - 1)
    print(title)
    for i, row in enumerate(error):
        cells = [f"{e:+7.2f}{'*' if (i, j) in fitted else ' '}" for j, e in enumerate(row)]
        print(f"  sample {i + 1}: {' '.join(cells)}")
    others = [error[at] for at in np.ndindex(error.shape) if at not in fitted]
    print(f"  not fitted: rms {np.sqrt(np.mean(np.square(others))):.2f} %, "
          f"worst {np.abs(others).max():.2f} %")  # fmt: skip


def show_parameters(best, jacobian, scatter):
    """Print the parameters with the uncertainty that a scatter of the frequencies leaves."""
    covariance = np.linalg.inv(jacobian.T @ jacobian) * scatter**2
    for name, value, spread in zip(NAMES, best, np.sqrt(np.diag(covariance)), strict=True):
        print(f"  {name:17s} {value:.4g} (SI) ± {100 * spread:.0f} %")


def show_open_combinations(jacobian):
    """Print how strongly each combination of the parameters moves the frequencies."""
    _, singular, directions = np.linalg.svd(jacobian, full_matrices=False)
    for s, direction in zip(singular, directions, strict=True):
        mix = ", ".join(f"{w:+.2f} {name}" for w, name in zip(direction, NAMES, strict=True))
        print(f"  {100 * s / np.sqrt(len(jacobian)):6.2f} % rms of f per 100 % of ({mix})")


def show_rest(J, c_insert):
    """Give inertia and offset of the inserts as text; 1e-7 kg·m² is 1 g·cm²."""
    return f"J {1e7 * J:5.1f} g·cm², inserts at {1e3 * c_insert:5.1f} mm"


def main():
    """Fit, predict, and say what the data leave open."""
    blade, masses, measured = read()
    k = free_stiffness(E=blade["E"], I=blade["I"], L=blade["L"])
    point = np.sqrt(k / (masses[0] + masses[1])) / (2 * np.pi)
    show_errors("√(k/m)/2π, error in %", point, measured)

    def residual(parameters, at=slice(None)):
        return np.log(model(parameters, blade, masses) / measured)[at]

    chosen = tuple(np.transpose(FITTED))
    best, jacobian = fit(lambda p: residual(p, chosen), START)
    print("\nfitted on 4 (*) of 20:")
    show_parameters(best, jacobian, scatter=0.01)
    show_errors("  error in %", model(best, blade, masses), measured, FITTED)
    bare = {name: value for name, value in blade.items() if name != "mass_per_length"}
    light, _ = massless_frequencies(**bare, **body(best, masses))
    ratio = light / model(best, blade, masses) - 1
    print(f"  leaving out the blade's mass raises f by at most {100 * ratio.max():.2f} %")

    best, jacobian = fit(lambda p: residual(p).ravel(), START)
    print("\nfitted on all 20:")
    scatter = np.sqrt(np.sum(residual(best) ** 2) / (measured.size - best.size))
    show_parameters(best, jacobian, scatter)
    show_errors("  error in %", model(best, blade, masses), measured)

    print("\nwhat the 20 frequencies can tell apart:")
    show_open_combinations(jacobian)
    print("\nwith c of the body held, J and the inserts' offset fitted on all 20:")
    for c in (0.0, 4e-3, 8e-3, 12e-3, 16e-3):
        rest, _ = fit(lambda p, c=c: residual([c, *p]).ravel(), START[1:])
        rms = np.sqrt(np.mean(residual([c, *rest]) ** 2))
        print(f"  c {1e3 * c:4.0f} mm: {show_rest(*rest)}, rms {100 * rms:.2f} %")

    print("\nwith the blade softer or stiffer than E says, all three fitted again on all 20:")
    for factor in (0.8, 0.9, 1.0, 1.1, 1.2):
        other = {**blade, "E": blade["E"] * factor}

        def scaled(p, other=other):
            return np.log(model(p, other, masses) / measured).ravel()

        c, *rest = fit(scaled, START)[0]
        rms = np.sqrt(np.mean(scaled([c, *rest]) ** 2))
        print(f"  E × {factor:.1f}: c {1e3 * c:5.1f} mm, {show_rest(*rest)}, rms {100 * rms:.2f} %")


if __name__ == "__main__":
    main()
