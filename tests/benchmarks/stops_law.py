"""The empirical law of boundary control against simulation and the quasi-static threshold.

Run by hand: python tests/benchmarks/stops_law.py
Monti (2014), section 8.4: π5 = 10.032 π1^−0.304, with π1 = k_c/k_f and π5 = δ_O/δ_G, the whole
range of the tip over the gap on one side. Ours: the massless blade of sample 2 with a mass point
(one mode), driven at its natural frequency from rest as in section 7.2, base range 1 µm, rigid
stops. No number of the simulation is fitted. Quasi-static threshold: twice the ratio of tip to
gap in the shape bent by a force at the tip; below it the blade doesn't reach the stop.
"""

from math import pi, sqrt

import numpy as np

from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.response import stepped_motion

E, L, b, h, m = 69e9, 25.5e-3, 9.837e-3, 1.057e-3, 11.1e-3
BASE = 0.5e-6
"""Amplitude of the base [m]: a range of 1 µm, table 7.3."""
RATIOS = (5.77, 10.0, 25.0, 50.0, 100.0, 150.0, 250.0)
GAPS = (0.03, 0.06, 0.12)
"""Gap over the whole free range of the tip; the law was measured above 0.03."""
QUALITIES = (250.0, 50.0)
"""Table 7.3 has δ_O/δ_D of 173 to 419 without stops, which is Q there; and a poorer one."""
DASHPOTS = (0.0, 0.2, 1.0)
"""Of the stop: c as a share of 2√(k_stop m_eff)."""


def height(ratio):
    """Give L_a/L of a stiffness ratio 4/(β²(3 + β)), β = L_b/L."""
    roots = np.roots([1.0, 3.0, 0.0, -4.0 / ratio])
    return 1.0 - float(next(r.real for r in roots if abs(r.imag) < 1e-9 and 0 < r.real <= 1))


def simulated(ratio, gap_share, *, quality=250.0, dashpot=0.0):
    """Give π5 at the natural frequency, the stop's gap over the free range; nan without contact."""
    a = height(ratio)
    blade = cantilever_modes(E=E, I=b * h**3 / 12, L=L, L_a=a * L, m=m, modes=1, quality=quality)
    omega = float(blade.angular[0])
    # the same free travel for every Q, so that only damping differs
    free = 2.0 * BASE * QUALITIES[0]
    amplitude = omega**2 * BASE * QUALITIES[0] / quality
    gap = gap_share * free
    c = dashpot * 2.0 * sqrt(1.0 / blade.stop_residual) / abs(float(blade.stop[0]))
    stops = Stops(LinearStop(damping=c), gap, gap)
    found = stepped_motion(blade, stops, amplitude).follow(omega)
    return 2.0 * found.peaks.travel / gap if found.contacts else float("nan")


def main():
    """Print the table and what it says."""
    f_n = sqrt(3 * E * b * h**3 / 12 / L**3 / m) / (2 * pi)
    print(f"mass point on the blade of sample 2: {f_n:.1f} Hz, base range {2e6 * BASE:g} µm\n")
    heads = [f"Q {q:g}, gap {g:.0%}" for q in QUALITIES for g in GAPS]
    heads += [f"stop ζ {z:g}" for z in DASHPOTS[1:]]
    print(f"{'π1':>6s} {'L_a/L':>6s} {'law':>6s} {'static':>6s}", *(f"{t:>15s}" for t in heads))
    law, static, ours = [], [], []
    for ratio in RATIOS:
        a = height(ratio)
        law.append(10.032 * ratio**-0.304)
        static.append(4.0 / (a**2 * (3.0 - a)))
        row = [simulated(ratio, g, quality=q) for q in QUALITIES for g in GAPS]
        row += [simulated(ratio, GAPS[1], dashpot=z) for z in DASHPOTS[1:]]
        ours.append(row)
        print(
            f"{ratio:6.2f} {a:6.3f} {law[-1]:6.2f} {static[-1]:6.2f} "
            + " ".join(f"{x:15.2f}" for x in row)
        )
    ours, law, static = np.array(ours), np.array(law), np.array(static)
    print(f"\nours against the law        {span(ours / law[:, None] - 1)}")
    print(f"threshold against the law   {span(static / law - 1)}")
    print(f"ours against the threshold  {span(ours / static[:, None] - 1)}")
    below = ", ".join(f"{r:g}" for r, x, y in zip(RATIOS, law, static, strict=True) if x < y)
    print(f"The law lies below the threshold, where one mode doesn't reach the stop: π1 = {below}.")
    print("A damped stop brings the motion closer to the threshold; a blade of poorer Q, driven")
    print("harder for the same free travel, takes it further off. Neither comes near the law where")
    print("it is highest, and nothing takes one mode below the threshold.")


def span(share):
    """Give the least and greatest of shares."""
    return f"{np.nanmin(share):+.1%} to {np.nanmax(share):+.1%}"


if __name__ == "__main__":
    main()
