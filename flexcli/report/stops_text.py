"""The answer of ``flexure stops`` as text for a terminal."""

from collections.abc import Iterator

from flexcli.report.tables import Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.stops import (
    StopKick,
    StopPlace,
    StopRatio,
    StopSimulation,
    StopsResult,
    StopSweep,
    SweepStep,
)
from flexcli.units import show

__all__ = ["section", "stops_tables"]

MOST_STEPS = 25
"""Steps of a frequency response that a terminal gets; CSV and JSON have all."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the stop that was chosen and what verified it."""
    if result.stops is not None:
        yield from stops_tables(result.stops)


def stops_tables(stops: StopsResult) -> Iterator[Piece]:
    """Yield the stop, the operating line, and what was simulated."""
    if stops.outcome == "infeasible":
        yield Line(("no stop is possible: ", "bold red"), stops.reason, hang=2)
        yield Line(f"remedy: {stops.remedy}")
    height, gap = show(stops.chosen.L_a, "m", 5), show(stops.chosen.delta_G, "m")
    yield Line((f"{stops.chosen.name}: height {height}, gap {gap}", "bold"))
    yield _line(stops.places)
    if stops.holds:
        yield _holds(stops)
    for simulation in stops.simulations:
        yield _simulation(simulation)
    for sweep in stops.sweeps:
        yield from _sweep(sweep)


def _line(places: tuple[StopPlace, ...]) -> Rows:
    heads = ("stop", "height", "gap", "π5", "tip touches", "force", "bending", "shear")
    rows = table("Operating line, tip at the end of its travel", *heads, numbers=range(1, 8))
    for place in places:
        rows.add_row(
            place.name,
            show(place.L_a, "m", 4),
            show(place.delta_G, "m", 3),
            f"{place.pi_5:.3g}",
            show(place.tip_at_contact, "m", 3),
            show(place.R_stop, "N", 3),
            show(place.bending, "Pa", 3),
            "" if place.tau_hertz is None else show(place.tau_hertz, "Pa", 3),
        )
    return rows


def _holds(stops: StopsResult) -> Rows:
    rows = table("Heights at which each limit holds", "limit", "heights")
    for hold in stops.holds:
        ranges = (f"{show(least, 'm')} to {show(most, 'm')}" for least, most in hold.ranges)
        rows.add_row(hold.name, ", ".join(ranges) or "nowhere")
    return rows


def _simulation(found: StopSimulation) -> Rows:
    """Return one case as a table of two columns."""
    rows = table(f"Simulated: {found.case}", "", "", numbers=[1])
    rows.add_row("excitation", f"{found.kind}, Q = {found.q:g}")
    done = show(found.duration, "s")
    if found.has_decided:
        done = f"{done} of {show(found.planned, 's')}: a limit was exceeded, which decides"
    elif not found.is_complete:
        done = f"interrupted after {done} of {show(found.planned, 's')}"
    rows.add_row("time", done)
    if found.outcome:
        rows.add_row("ended", found.outcome)
    if found.confidence is not None:
        rows.add_row("confidence", f"{found.confidence:.1%}, seed {found.seed}")
    rows.add_row("peak of the tip", show(found.travel, "m"))
    rows.add_row("range over gap, π5", f"{found.pi_5:.4g}")
    rows.add_row("stop", found.law if not found.model else f"{found.model}: {found.law}")
    if found.contacts:
        share = f"{found.contact_share:.1%} of the time, up to {show(found.fastest, 'm/s', 3)}"
        rows.add_row("contacts", f"{found.contacts}, {share}")
    else:
        rows.add_row("contacts", "none")
    if found.impulse:
        rows.add_row("greatest impulse", f"{found.impulse:.3g} N·s")
    rows.add_row("force on the stop", show(found.force, "N"))
    stresses = [show(stress, "Pa") for stress in (found.sigma_base, found.sigma_contact)]
    rows.add_row("bending at base, stop", ", ".join(stresses))
    if found.p_hertz is not None and found.tau_hertz is not None:
        contact = f"{show(found.p_hertz, 'Pa')}, {show(found.tau_hertz, 'Pa')}"
        rows.add_row("contact pressure, shear", contact)
    rest = f"energy {found.energy_residual:.0e}, momentum {found.impulse_residual:.0e}"
    rows.add_row("unaccounted for", rest)
    rows.add_row("events", f"{found.events} in {show(found.seconds, 's', 3)}")
    return rows


def _sweep(sweep: StopSweep) -> Iterator[Piece]:
    yield Line((f"Frequency response with stops: {sweep.case}, {sweep.how}", "bold"))
    if sweep.law:
        yield Line(f"  stop: {sweep.law}; {show(sweep.seconds, 's', 3)}")
    if not sweep.steps:
        yield Line("  no step of it was done")
        return
    so_far = "" if sweep.is_complete else " in the steps that were done"
    for way, band in (("up", sweep.contact_up), ("down", sweep.contact_down)):
        if band is None:
            yield Line(f"  going {way} the blade does not touch{so_far}")
        else:
            yield Line(f"  going {way} it touches from {_band(band)}")
    if sweep.metastable is not None:
        yield Line(f"  metastable: {_band(sweep.metastable)} (two motions are possible)")
    for end in sweep.ends:
        way = "up" if end.up else "down"
        at = f"  going {way} a motion ends at {show(end.frequency, 'Hz', 6)}"
        yield Line(f"{at}: {end.why}", hang=4)
    heads = ("frequency", "tip, up", "tip, down", "force, up", "force, down")
    rows = table("", *heads, numbers=range(5))
    pairs = _by_frequency(sweep.steps)
    every = -(-len(pairs) // MOST_STEPS)
    for frequency, (up, down) in pairs[::every]:
        steps = (up, down)
        rows.add_row(
            show(frequency, "Hz", 5),
            *("" if step is None else _settled(step) for step in steps),
            *("" if step is None else show(step.force, "N", 3) for step in steps),
        )
    yield rows
    for outcome in dict.fromkeys(step.outcome for step in sweep.steps if not step.settled):
        yield Line((f"* unsettled: {outcome}; the range that a run shows", "dim"))
    if every > 1:
        yield Line((f"one in {every} of {len(pairs)} steps; --csv and JSON have all", "dim"))
    if sweep.kicks:
        yield _kicks(sweep.kicks)
    if sweep.ratios:
        yield _ratios(sweep.ratios)


def _ratios(ratios: tuple[StopRatio, ...]) -> Rows:
    heads = ("height", "gap", "π1", "π5, line", "π5, threshold", "π5, simulated")
    title = "Range of the tip over the gap on the operating line, at the blade's frequency"
    rows = table(title, *heads, numbers=range(6))
    for ratio in ratios:
        rows.add_row(
            show(ratio.L_a, "m", 4),
            show(ratio.delta_G, "m", 3),
            *(f"{number:.3g}" for number in (ratio.pi_1, ratio.line, ratio.threshold)),
            "no contact" if ratio.simulated is None else f"{ratio.simulated:.3g}",
        )
    return rows


def _kicks(kicks: tuple[StopKick, ...]) -> Rows:
    heads = ("frequency", "reaches no stop", "enough", "jump of its speed")
    title = "Blow at the tip, from the motion without contact to the one with it"
    rows = table(title, *heads, numbers=range(4))
    for kick in kicks:
        found = kick.enough is not None and kick.speed_enough is not None
        rows.add_row(
            show(kick.frequency, "Hz", 5),
            f"{kick.none * 1e3:.3g} mN·s",
            f"{(kick.enough or 0.0) * 1e3:.3g} mN·s" if found else "not found",
            show(kick.speed_enough or 0.0, "m/s", 3) if found else "",
        )
    return rows


def _settled(step: SweepStep) -> str:
    if not step.settled:
        least = "" if step.least is None else f"{show(step.least, 'm', 3)} to "
        return f"{least}{show(step.travel, 'm', 3)} *"
    return show(step.travel, "m") + ("" if step.periods == 1 else f" ({step.periods} periods)")


def _band(ends: tuple[float, float]) -> str:
    return f"{show(ends[0], 'Hz', 5)} to {show(ends[1], 'Hz', 5)}"


def _by_frequency(
    steps: tuple[SweepStep, ...],
) -> list[tuple[float, tuple[SweepStep | None, SweepStep | None]]]:
    """Return both ways beside each other, frequencies rising."""
    up = {step.frequency: step for step in steps if step.up}
    down = {step.frequency: step for step in steps if not step.up}
    return [(f, (up.get(f), down.get(f))) for f in sorted(up.keys() | down.keys())]
