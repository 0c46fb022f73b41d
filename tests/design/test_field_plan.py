"""Tests that the field plan shows the lines and targets of the survey plan."""

import re
from dataclasses import replace
from io import BytesIO
from itertools import pairwise

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Annotation

from lispac.design.plan import Line
from lispac.design.plan_choices import thesis_plan
from lispac.design.plan_search import ReductionStep
from lispac.design.scenarios import predict_scenarios, thesis_setting
from lispac.design.site import Site, Wall
from lispac.report.design_figures import pareto_front_figure, scenario_figure
from lispac.report.field_plan import field_plan_figure
from lispac.simulation.closed_form_survey import Ball


def words(figure: Figure) -> list[str]:
    """All texts of a page."""
    return [text.get_text() for text in figure.findobj(lambda a: hasattr(a, "get_text"))]


def drawn_arrows(axes: Axes) -> list[Annotation]:
    """Annotations with an arrow: those of the lines, and that to the north."""
    return [text for text in axes.texts if getattr(text, "arrow_patch", None) is not None]


@pytest.mark.parametrize("facing", [270.0, 0.0, 130.0])
def test_lines_are_drawn_along_their_headings(facing: float) -> None:
    site = Site((0.0, 0.0, 0.0), facing)
    plan = thesis_plan(site)
    page = field_plan_figure(plan, site.wall, "Quay")
    above = page.axes[0]
    arrows = [each for each in drawn_arrows(above) if each.xycoords == "data"]
    assert len(arrows) == len(plan.lines)
    for arrow, line in zip(arrows, plan.lines, strict=True):
        begin, end = np.array(arrow.xyann), np.array(arrow.xy)
        east, north = end - begin
        drawn = np.degrees(np.arctan2(east, north)) % 360
        assert (drawn - line.heading_deg + 180) % 360 - 180 == pytest.approx(0, abs=1e-6)
        # The line is on the water, and the wall is on the given side
        azimuth = np.radians(facing)
        assert begin @ [np.sin(azimuth), np.cos(azimuth)] > 0
        assert (east * -begin[1] - north * -begin[0] < 0) == line.starboard


def test_the_tables_agree_with_the_plan() -> None:
    wall = Wall((0.0, 0.0, 0.0), 200.0)
    plan = replace(
        thesis_plan(Site(wall.middle, 200.0)),
        targets=(
            wall.board("left", -3.25, 6.5, 90.0, (1.0, 0.8)),
            wall.board("nose", 4.0, 2.0, 130.0, (1.0, 0.8), off=0.5),
            Ball("ball", wall.local_point(1.0, 0.0, 3.0), 0.145),
        ),
        lines=(
            Line(110.0, 12.5, True, 0.7),
            Line(110.0, 12.5, True, 0.7),
            Line(335.0, 30.0, False),
        ),
    )
    texts = words(
        field_plan_figure(plan, wall, "Quai Bickerdike", ["Ask the harbour master first."])
    )
    for text in (
        "Quai Bickerdike", "left", "\u22123.25", "90, vertical", "50, tilted forward", "+0.50",
        "sphere, r 0.145", "1.00 x 0.80", "1, 2", "12.5", "starboard", "port", "0.7", "335",
    ):  # fmt: skip
        assert text in texts, text
    assert any("Ask the harbour master first." in text for text in texts)


def test_north_is_up_and_the_scale_bar_has_the_given_length() -> None:
    site = Site((0.0, 0.0, 0.0), 130.0)
    page = field_plan_figure(thesis_plan(site), site.wall, "Quay")
    page.draw_without_rendering()
    above = page.axes[0]
    north = next(text for text in above.texts if text.get_text() == "N")
    (arrow,) = (each for each in drawn_arrows(above) if each.xycoords != "data")
    tail, tip = (each.transform((1.0, 1.0)) for each in (arrow.anncoords, arrow.xycoords))
    box = north.get_window_extent()
    assert tail[0] == pytest.approx(tip[0])
    assert (box.y0 + box.y1) / 2 > tip[1] > tail[1] > above.get_window_extent().y0
    bar_text = next(text.get_text() for text in above.texts if text.get_text().endswith(" m"))
    bar = above.lines[-1].get_xdata()
    assert bar[1] - bar[0] == pytest.approx(float(bar_text.split()[0]))
    (left, right), (low, high) = above.get_xlim(), above.get_ylim()
    box = above.get_window_extent()
    assert (right - left) / (high - low) == pytest.approx(box.width / box.height, rel=1e-3)


@pytest.mark.parametrize(("lines", "balls"), [(6, 1), (24, 10)])
def test_all_texts_are_on_the_page(lines: int, balls: int) -> None:
    site = Site((0.0, 0.0, 0.0), 270.0)
    plan = thesis_plan(site)
    plan = plan.with_lines((plan.lines * 4)[:lines])
    plan = plan.with_targets(
        (*plan.targets, *(Ball(f"B{k}", (k, 0.0, 4.0), 0.1) for k in range(balls)))
    )
    page = field_plan_figure(
        plan, site.wall, "Quay", warnings=["Line 1 would run through the wall."] * balls
    )
    page.draw_without_rendering()
    whole = page.bbox
    for text in filter(lambda each: each.get_text(), page.texts):
        box = text.get_window_extent()
        assert whole.x0 <= box.x0 < box.x1 <= whole.x1, text.get_text()
        assert whole.y0 <= box.y0 < box.y1 <= whole.y1, text.get_text()
    rows = [text for text in page.texts if text.get_position()[0] == pytest.approx(0.07)]
    boxes = sorted((text.get_window_extent() for text in rows), key=lambda box: box.y0)
    assert all(one.y1 <= other.y0 + 0.5 for one, other in pairwise(boxes)), "no row over another"


def test_the_crew_is_told_which_targets_to_survey() -> None:
    site = Site((0.0, 0.0, 0.0), 270.0, control_sigma=0.003)
    plan = thesis_plan(site)
    texts = " ".join(words(field_plan_figure(plan, site.wall, "Quay")))
    assert "T1 (3 mm) and T2 (3 mm)" in texts
    without = words(field_plan_figure(plan.without_control(), site.wall, "Quay"))
    assert "(3 mm)" not in " ".join(without)


def test_an_undetermined_plan_is_reported() -> None:
    site = Site((0.0, 0.0, 0.0), 270.0)
    plan = thesis_plan(site)
    with_sigmas = words(field_plan_figure(plan, site.wall, "All lines"))
    texts = words(field_plan_figure(plan.with_lines(plan.lines[:1]), site.wall, "One line"))
    sigma = re.compile(r"roll \d\.\d{4}")
    assert any(map(sigma.search, with_sigmas))
    assert not any(map(sigma.search, texts))


def test_the_same_plan_gives_the_same_page() -> None:
    site = Site((0.0, 0.0, 0.0), 270.0)
    pages = []
    for _ in range(2):
        stream = BytesIO()
        page = field_plan_figure(thesis_plan(site), site.wall, "Quay")
        page.savefig(stream, format="pdf", metadata={"CreationDate": None})
        pages.append(stream.getvalue())
    assert pages[0] == pages[1]


def test_scenarios_and_front_are_drawn() -> None:
    found = predict_scenarios(thesis_setting(), ("lines",))
    figure = scenario_figure(found)
    assert [axes.get_title(loc="left") for axes in figure.axes] == [
        "correlated POS errors", "uncorrelated POS errors (classical)",
    ]  # fmt: skip
    assert sum(text == "not determined" for text in words(figure)) == 10
    heights = [bar.get_height() for bar in figure.axes[0].containers[1]]
    last = next(o for o in found if o.case == "all six" and o.pos_errors == "correlated")
    assert heights[-1] == pytest.approx(np.degrees(last.sigma[1]))
    plan = thesis_setting()
    front = (
        ReductionStep(plan, 39.0, 0.0002),
        ReductionStep(plan.with_lines(plan.lines[:4]), 36.0, 0.0003),
    )
    assert "1 × 4" in words(pareto_front_figure(front, "largest of the three standard deviations"))
