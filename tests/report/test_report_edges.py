"""Tests of figures and sections of the report with little or no content."""

import re
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from matplotlib.figure import Figure

from lispac.design.monte_carlo import MonteCarloResult
from lispac.project import Project
from lispac.report import boresight_section, sections
from lispac.report.content import ReportContent
from lispac.report.design_figures import simulated_errors_figure
from lispac.report.distance_profiles import profile_figure
from lispac.report.document_blocks import Block, Paragraph, Table, UndrawnPictures
from lispac.report.figures import correlation_figure_of, site_figure, svg_of, svg_pictures
from lispac.report.validation_section import validation_blocks
from lispac.validation.comparison_results import PairState
from tests.support.report_sample import sample_content, sample_project, undrawn_pictures


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    return sample_project(tmp_path_factory.mktemp("sample"))


@pytest.fixture(scope="module")
def content(project: Project) -> ReportContent:
    return sample_content(project)


def _titles(blocks: list[Block]) -> list[str]:
    tables = [block.title for block in blocks if isinstance(block, Table)]
    return tables + [picture.caption for picture in undrawn_pictures(blocks)]


def _text(blocks: list[Block]) -> str:
    return "\n".join(block.text for block in blocks if isinstance(block, Paragraph))


# -- figures ---------------------------------------------------------------------------------


@pytest.mark.parametrize(("count", "rotation"), [(3, 0.0), (4, 40.0)])
def test_labels_of_many_values_are_slanted(count: int, rotation: float) -> None:
    names = ("roll", "pitch", "yaw", "lever_x")[:count]
    axes, _scale = correlation_figure_of(names, np.eye(count)).axes
    labels = axes.get_xticklabels()
    assert [label.get_rotation() for label in labels] == [rotation] * count
    assert len(axes.texts) == count**2


def test_the_legend_of_a_site_plan_explains_the_marks_only() -> None:
    """The lines have their names beside them."""
    assert site_figure({}, {}, {}).legends == []
    tracks = {"L1": [[0.0, 0.0], [5.0, 0.0]]}
    assert site_figure(tracks, {}, {}).legends == []
    (legend,) = site_figure(tracks, {"T1": (1.0, 2.0, 3.0)}, {}).legends
    assert [text.get_text() for text in legend.get_texts()] == ["target"]


def test_a_line_of_one_position_has_no_direction() -> None:
    """It has its name but no arrow."""
    (one,) = site_figure({"L1": [[1.0, 2.0]]}, {}, {}).axes
    (two,) = site_figure({"L1": [[1.0, 2.0], [4.0, 2.0]]}, {}, {}).axes
    assert len(one.lines) == len(two.lines) == 1
    assert "L1" in {text.get_text() for text in one.texts}
    assert len(one.texts) < len(two.texts)


def test_a_picture_shows_the_figure_as_drawn() -> None:
    names, matrix = ("roll", "pitch", "yaw"), np.eye(3)
    (picture,) = svg_pictures(correlation_figure_of, names, matrix)
    assert picture == svg_of(correlation_figure_of(names, matrix))


def test_a_figure_with_options_is_drawn_once() -> None:
    sizes: list[tuple[float, float]] = []

    def draw(title: str, *, size: tuple[float, float]) -> Figure:
        sizes.append(size)
        return Figure(size)

    for size in ((2.0, 1.0), (2.0, 1.0), (3.0, 1.0)):
        svg_pictures(partial(draw, size=size), "title")
    assert sizes == [(2.0, 1.0), (3.0, 1.0)]


def test_rectangles_in_place_of_figures_have_their_size(request: pytest.FixtureRequest) -> None:
    draw = partial(correlation_figure_of, ("roll", "pitch", "yaw"), np.eye(3))
    (figure,) = svg_pictures(draw)
    request.getfixturevalue("rectangles")
    (rectangle,) = svg_pictures(draw)
    assert len(rectangle) < 300 < len(figure)
    for name in ("width", "height"):
        size, expected = (
            float(re.findall(rf'\b{name}="([0-9.]+)pt"', svg.decode())[0])
            for svg in (rectangle, figure)
        )
        assert size == pytest.approx(expected, abs=0.01)


def test_errors_of_surveys_are_drawn_over_what_was_predicted() -> None:
    rng = np.random.default_rng(1)
    predicted = np.radians([0.01, 0.02, 0.03])
    errors = rng.normal(size=(400, 3)) * predicted * [1.0, 2.0, 0.5]
    found = MonteCarloResult(errors, np.tile(predicted, (400, 1)), predicted, np.eye(3), 0)
    figure = simulated_errors_figure(found)
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == [
        f"{angle}: {ratio:.2f} \u00b1 {ratio * found.ratio_sigma:.2f}"
        for angle, ratio in zip(("roll", "pitch", "yaw"), found.ratio, strict=True)
    ]
    np.testing.assert_allclose(found.ratio, [1.0, 2.0, 0.5], rtol=0.15)
    # Every survey is in a bar; the last bar holds the largest errors.
    for axes in figure.axes:
        assert sum(bar.get_height() for bar in axes.patches) == 400


def test_a_comparison_of_an_earlier_version_has_no_profile_figure(project: Project) -> None:
    plane = project.validation[0]
    old = profile_figure(replace(plane, by_height=None, by_range=None))
    (axes,) = old.axes
    assert len(axes.texts) == 1
    assert not axes.lines
    assert [axes.get_xlabel() for axes in profile_figure(plane).axes] == ["Height (m)", "Range (m)"]


# -- sections --------------------------------------------------------------------------------


def test_missing_profiles_maps_and_signed_distances_have_no_blocks(project: Project) -> None:
    first = project.validation[0]
    bare = replace(
        first, by_height=None, by_range=None, maps=(), not_compared=(),
        pairs=tuple(
            replace(p, before=PairState(p.before.distances), after=PairState(p.after.distances))
            for p in first.pairs
        ),
    )  # fmt: skip
    whole = validation_blocks(sample_content(replace(project, validation=(first,))))
    less = validation_blocks(sample_content(replace(project, validation=(bare,))))
    missing = set(_titles(whole)) - set(_titles(less))
    assert len(missing) == 4
    assert set(_titles(less)) < set(_titles(whole))
    assert sum("median and 95th percentile" in title for title in missing) == 1
    assert sum(": maps of" in title for title in missing) == 1
    assert "M3C2" in _text(whole)
    assert "M3C2" not in _text(less)
    assert "could not be compared" not in _text(less)


def test_observability_is_omitted_where_it_was_not_computed(project: Project) -> None:
    assert project.result is not None
    complete = project.result.observability
    assert complete is not None
    head = "1 sigma of the angles with one line omitted"
    without = replace(complete, sigma_without_line={})
    cases = ((complete, True, True), (without, True, False), (None, False, False))
    for observability, is_reported, has_table in cases:
        result = replace(project.result, observability=observability)
        blocks = boresight_section.boresight_blocks(sample_content(replace(project, result=result)))
        assert ("Observability of the angles on these lines:" in _text(blocks)) == is_reported
        assert (head in _titles(blocks)) == has_table


def test_a_site_without_tracks_and_planes_is_not_drawn(content: ReportContent) -> None:
    tracks = tuple(replace(line, track_local_m=()) for line in content.lines)
    drawn = sections.site_blocks(content)
    bare = sections.site_blocks(replace(content, lines=tracks, planes=()))
    plans = [[b for b in blocks if isinstance(b, UndrawnPictures)] for blocks in (drawn, bare)]
    assert [len(each) for each in plans] == [1, 0]
    assert "Lines" in _titles(bare)


def test_a_zero_surface_sigma_is_explained(project: Project) -> None:
    with_zero_sigma = replace(project, settings=replace(project.settings, surface=0.0))
    for made, is_explained in ((with_zero_sigma, True), (project, False)):
        cells = [
            cell
            for block in sections.settings_blocks(sample_content(replace(made, result=None)))
            if isinstance(block, Table)
            for row in block.rows
            for cell in row
        ]
        assert (
            any(cell.startswith("zero: all sightings of a target") for cell in cells)
            == is_explained
        )
