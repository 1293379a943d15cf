"""A drawing as a picture of pixels, in its light colours."""

import re
from importlib import import_module
from pathlib import Path

from flexcli.errors import SolveError
from flexcli.report.drawings.style import LIGHT

__all__ = ["png"]

ZOOM = 2
"""Pixels of the picture for one of the page: sharp in print at its own size."""


def png(svg: str) -> bytes:
    """Return a picture of a drawing.

    Raises
    ------
    SolveError
        When what draws pixels is not installed.

    """
    try:
        resvg, matplotlib = import_module("resvg_py"), import_module("matplotlib")
    except ImportError as error:
        text = "a PNG needs the extra 'report'"
        hint = "pip install 'flexcli[report]', or write an SVG"
        raise SolveError("no-pixels", text, hint) from error
    plain = re.sub(r"@media[^{]*\{[^{}]*\{[^{}]*\}\}", "", svg)
    for name, colour in LIGHT.items():
        plain = plain.replace(f"var(--{name})", colour)
    fonts = str(Path(matplotlib.get_data_path()) / "fonts" / "ttf")  # a machine may have none
    return bytes(
        resvg.svg_to_bytes(
            svg_string=plain, font_dirs=[fonts], zoom=ZOOM, sans_serif_family="DejaVu Sans"
        )
    )
