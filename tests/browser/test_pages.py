"""Pages of examples in a real browser: silent, offline, no wider than the window, accessible.

Run by ``-m browser`` with the extra ``browser`` and an installed Chromium; nothing is downloaded.
"""

import shutil
from pathlib import Path
from typing import NamedTuple

import pytest

import flexcli
from flexcli.report.page import design_page, folder_page, folder_row

sync = pytest.importorskip("playwright.sync_api", reason="needs the extra 'browser'")
axe = pytest.importorskip("axe_playwright_python.sync_playwright")
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser"))), None)

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(CHROMIUM is None, reason="there is no chromium on the path"),
]

ROOT = Path(__file__).parents[2] / "examples"
EXAMPLES = sorted(path.parent.name for path in ROOT.glob("*/flexure.yaml"))
INDEX = "index"
DATE = "1 January 2026"


class View(NamedTuple):
    """How a page is looked at: a medium, its width and the least size of drawn text [px]."""

    media: str
    width: int
    least: float


# type of 13 px stands beside it; paper is read from nearer
PHONE, TABLET, LAPTOP = (View("screen", width, 9.5) for width in (380, 860, 1280))
# A4 between margins of 16 mm; one less, as 178 mm are 672.8 px
PRINTED = View("print", 672, 7.0)
VIEWS = (PHONE, TABLET, LAPTOP, PRINTED)

COLOURS = ["color-contrast", "link-in-text-block"]
"""Rules of axe that a view decides; the others ask of a page's elements, which are always alike."""

WIDER = """() => [...document.querySelectorAll('body *')]
    .filter(e => !e.closest('svg') || e.tagName === 'svg')
    .filter(e => e.getBoundingClientRect().right > innerWidth + 0.5 && !e.closest('.scroll, pre'))
    .map(e => `${e.tagName} ${e.className.baseVal ?? e.className} ${e.textContent.slice(0, 40)}`)"""
"""What reaches beyond the right edge, but for what scrolls by itself."""

CUT = """() => [...document.querySelectorAll('.scroll, pre')]
    .filter(e => e.scrollWidth > e.clientWidth + 1)
    .map(e => `${e.className || e.tagName} ${e.scrollWidth} > ${e.clientWidth}`)"""
"""What would be cut off on paper, where nothing scrolls."""


GRID = """() => {
    const box = e => e.getBoundingClientRect();
    const seen = e => box(e).width > 0 && box(e).height > 0;
    return [...document.querySelectorAll('main > section')].filter(seen).map(section => {
        const head = section.querySelector(':scope > header');
        const rest = [...section.children].filter(e => e !== head && seen(e));
        return {
            name: section.id, wide: section.classList.contains('wide'),
            top: box(section).top, left: box(section).left,
            right: box(section).right, head: {...box(head).toJSON()},
            rest: rest.map(e => box(e).toJSON()),
        };
    });
}"""
"""Where the sections of a page stand, their heads and what they have beside or below."""

TINY = """least => [...document.querySelectorAll('svg text')]
    .filter(e => e.getClientRects().length)
    .map(e => [parseFloat(getComputedStyle(e).fontSize) * Math.hypot(e.getScreenCTM().a,
               e.getScreenCTM().b), e.textContent])
    .filter(([size, _]) => size < least)"""
"""Text of drawings and plots that is smaller than so many pixels."""

OVERLAPPING = """() => {
    const blocks = [...document.querySelectorAll(
        'h1, h2, h3, p, li, dt, dd, table, pre, figure > svg')]
        .filter(e => !e.closest('.hidden, .vh, details:not([open])') && e.getClientRects().length)
        .filter(e => !e.querySelector('p, table, pre, dl, ul'));
    const boxes = blocks.map(e => e.getBoundingClientRect());
    const found = [];
    for (let i = 0; i < blocks.length; i++)
        for (let j = i + 1; j < blocks.length; j++) {
            const [a, b] = [boxes[i], boxes[j]];
            const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
            const high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
            if (wide > 1 && high > 1 && !blocks[i].contains(blocks[j]))
                found.push([i, j].map(k => blocks[k].textContent.slice(0, 30)).join(' | '));
        }
    return found;
}"""
"""Pairs of blocks of text, tables and figures that lie over each other."""


def page_of(name):
    """Return the page of an example; free sizes are chosen by the formulas as printed."""
    spec = flexcli.load(ROOT / name / "flexure.yaml")
    model = "source" if spec.part.geometry.free else None
    return design_page(flexcli.dossier(spec, model=model), DATE)


def index():
    """Return the page of a folder with a design that passes and one that fails."""
    names = ("wittrick-crossing", "necked-down-stage")
    results = [flexcli.check(ROOT / name / "flexure.yaml") for name in names]
    assert len({result.status for result in results}) == 2
    return folder_page("examples", [folder_row(r, f"{r.title}.html") for r in results], DATE)


@pytest.fixture(scope="session")
def chromium():
    with sync.sync_playwright() as player:
        # no sandbox: the root of a container has none; the pages are our own
        browser = player.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture(
    params=[pytest.param(name, marks=pytest.mark.xdist_group(name)) for name in [*EXAMPLES, INDEX]],
    scope="module",
)
def page(request, chromium, tmp_path_factory):
    """Yield an opened page with all that it logged and asked for."""
    path = tmp_path_factory.mktemp("pages") / f"{request.param}.html"
    html = index() if request.param == INDEX else page_of(request.param)
    path.write_text(html, encoding="utf-8")
    opened = chromium.new_page(viewport={"width": LAPTOP.width, "height": 900})
    opened.logged, opened.asked = [], []
    opened.on("console", lambda message: opened.logged.append(message.text))
    opened.on("pageerror", lambda error: opened.logged.append(str(error)))
    opened.on("request", lambda asked: opened.asked.append(asked.url))
    opened.goto(path.as_uri(), wait_until="load")
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def views(page):
    """Return what each view of a page shows; a page is laid out once for each."""
    found = {}
    for view in VIEWS:
        page.emulate_media(media=view.media)
        page.set_viewport_size({"width": view.width, "height": 900})
        found[view] = page.evaluate(f"""() => ({{
            width: document.documentElement.scrollWidth, wider: ({WIDER})(), cut: ({CUT})(),
            grid: ({GRID})(), overlapping: ({OVERLAPPING})(), tiny: ({TINY})({view.least}),
        }})""")
    return found


def test_says_nothing_to_the_console_and_asks_for_nothing_but_itself(page):
    assert page.logged == []
    assert page.asked == [page.url]


def test_is_no_wider_than_the_window_and_nothing_is_cut_off_on_paper(views):
    for view, seen in views.items():
        assert seen["width"] <= view.width
        assert seen["wider"] == []
    assert views[PRINTED]["cut"] == []


@pytest.mark.parametrize(
    ("view", "head"), [(PHONE, None), (LAPTOP, 168.0), (PRINTED, 27.0 / 25.4 * 96.0)]
)
def test_has_heads_beside_the_text_where_there_is_room(page, views, view, head):
    sections = views[view]["grid"]
    assert sections or page.url.endswith(f"{INDEX}.html")
    tops = [section["top"] for section in sections]
    assert tops == sorted(tops)
    assert len({(section["left"], section["right"]) for section in sections}) <= 1
    for section in sections:
        title, rest = section["head"], section["rest"]
        assert rest, f"{section['name']} is empty"
        # a table too wide for the paper takes the column of the heads too
        if head is None or (view is PRINTED and section["wide"]):
            assert min(each["top"] for each in rest) >= title["bottom"]
            assert all(each["left"] == pytest.approx(title["left"], abs=1) for each in rest)
        else:
            assert title["width"] == pytest.approx(head, abs=1)
            assert min(each["left"] for each in rest) > title["right"]


def test_nothing_lies_over_anything_else(views):
    assert {view: seen["overlapping"] for view, seen in views.items() if seen["overlapping"]} == {}


def test_text_of_drawings_and_plots_can_be_read(views):
    assert {view: seen["tiny"] for view, seen in views.items() if seen["tiny"]} == {}


@pytest.mark.parametrize(
    ("view", "scheme", "rules"),
    [(PHONE, "dark", {}), (LAPTOP, "light", {"runOnly": COLOURS})],
    ids=["phone, dark", "laptop, light"],
)
def test_has_no_barrier_that_axe_finds(page, view, scheme, rules):
    page.emulate_media(media="screen", color_scheme=scheme)
    page.set_viewport_size({"width": view.width, "height": 900})
    found = axe.Axe().run(page, options={"resultTypes": ["violations"], **rules})
    assert found.violations_count == 0, found.generate_report()


def test_the_checks_find_what_they_look_for(chromium):
    opened = chromium.new_page(viewport={"width": PHONE.width, "height": 900})
    opened.set_content(
        "<main style='color:#ccc'>pale <img src='data:,'><p style='width:999px'>wide</p>"
        "<div class='scroll' style='overflow:auto;width:9px'>cut</div>"
        "<p>under</p><p style='margin-top:-30px'>over</p></main>"
    )
    assert {"image-alt", "color-contrast"} <= {
        barrier["id"] for barrier in axe.Axe().run(opened).response["violations"]
    }
    assert any("wide" in found for found in opened.evaluate(WIDER))
    assert len(opened.evaluate(CUT)) == 1
    opened.set_content(opened.content() + "<svg viewBox='0 0 900 9'><text y='9'>small</text></svg>")
    assert [text for _, text in opened.evaluate(TINY, 9.5)] == ["small"]
    assert opened.evaluate(OVERLAPPING) == ["under | over"]
    opened.close()
