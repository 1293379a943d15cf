"""How drawings look: colours in the light and the dark, line weights, type."""

from xml.sax.saxutils import escape

from flexcli.report.svg import Page

__all__ = ["HEAT", "LIGHT", "STYLE", "sheet_of"]

LIGHT = {
    "paper": "#fff", "ink": "#16181b", "ink2": "#4a5057", "steel": "#e6e9ec", "motion": "#5a4fa3",
    "force": "#9a3412",
}  # fmt: skip
DARK = {
    "paper": "#121417", "ink": "#eceae6", "ink2": "#b9bec4", "steel": "#2b3036",
    "motion": "#b3a9f7", "force": "#ff9a70",
}  # fmt: skip
"""Colours; every one of text has a contrast of 7 and more on its paper."""


def _colours(names: dict[str, str]) -> str:
    return "".join(f"--{name}:{colour};" for name, colour in names.items())


STYLE = (
    f"""\
.dwg{{{_colours(LIGHT)}}}
@media screen and (prefers-color-scheme:dark){{.dwg{{{_colours(DARK)}}}}}
"""
    + """\
.dwg{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif}
.dwg .paper{fill:var(--paper)}
.dwg text{font-size:12.5px;fill:var(--ink);stroke:var(--paper);stroke-width:3.5px;\
stroke-linejoin:round;paint-order:stroke;font-variant-numeric:tabular-nums}
.dwg text.s{fill:var(--ink2);font-size:11.5px}
.dwg text.m{fill:var(--motion)}
.dwg text.f{fill:var(--force)}
.dwg .body{fill:var(--steel);stroke:var(--ink);stroke-width:1.5;stroke-linejoin:round}
.dwg .blade{fill:var(--ink);stroke:none}
.dwg .face{fill:var(--steel);stroke:var(--ink);stroke-width:.75;stroke-linejoin:round}
.dwg .curved{fill:var(--steel);stroke:var(--steel);stroke-width:.75}
.dwg .edge{stroke:var(--ink);stroke-width:1.5;fill:none}
.dwg .thin{stroke:var(--ink2);stroke-width:.75;fill:none}
.dwg .axis{stroke:var(--ink2);stroke-width:.75;stroke-dasharray:11 2.5 2 2.5;fill:none}
.dwg .plus{stroke:var(--motion);stroke-width:1.1;fill:none;stroke-linejoin:round}
.dwg .minus{stroke:var(--motion);stroke-width:.9;fill:none;stroke-dasharray:7 2 1.5 2 1.5 2}
.dwg .plusb{stroke:var(--motion);stroke-width:2;fill:none}
.dwg .head{fill:var(--ink2)}
.dwg .headf{fill:var(--force)}
.dwg .force{stroke:var(--force);stroke-width:1.75;fill:none}
.dwg .dot{fill:var(--ink)}
.dwg .hole{fill:var(--paper);stroke:var(--ink);stroke-width:1}
.dwg .heat{fill:none;stroke-width:3.2}
"""
)

HEAT = ("#fee8c8", "#fdd49e", "#fdbb84", "#fc8d59", "#ef6548", "#d7301f", "#990000")
"""Stress from none to the largest: a series of even steps in lightness (Brewer's OrRd)."""


def sheet_of(page: Page, title: str, description: str) -> str:
    """Return a page as an SVG that stands alone, with title and description for readers."""
    w, h = f"{page.width:.0f}", f"{page.height:.0f}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="dwg" role="img" width="{w}" height="{h}" '
        f'viewBox="0 0 {w} {h}"><title>{escape(title)}</title><desc>{escape(description)}</desc>'
        f'<style>{STYLE}</style><path class="paper" d="M0 0H{w}V{h}H0Z"/>'
        + "".join(page.shapes)
        + "</svg>\n"
    )
