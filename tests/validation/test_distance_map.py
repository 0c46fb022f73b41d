"""Tests of maps of the distances between two lines on a plane."""

import csv
import json
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project, write_project
from lispac.language import gettext, in_language
from lispac.present.checking.validation import ValidationPlane
from lispac.report.csv_tables import write_tables
from lispac.report.distance_maps import (
    CAPTION,
    LARGEST_CAPTION,
    SOME_CAPTION,
    map_caption,
    map_figure_of,
    map_row_figure_of,
)
from lispac.report.text_width import text_width
from lispac.validation.comparison_results import PlaneComparison
from lispac.validation.distance_map import DistanceMap, distance_map
from lispac.validation.plane_comparison import compare_plane
from lispac.value_conversion import decode_value, encode_value
from tests.support.long_runs import others_long
from tests.support.report_sample import sample_content, sample_project

OPPOSITE = {"L1": 0.0, "L2": np.pi}
TO_VESSEL = np.array([0.0, 1.0, 0.0])


def wall(seed: int, *, slope: float = 0.0, lift: float = 0.0, noise: float = 0.002) -> np.ndarray:
    """Points of a wall 6 m long (north) and 3 m high, with the vessel to the west.

    The wall approaches the vessel by ``slope`` metres a metre to the right (south) and by ``lift``
    metres a metre upwards.
    """
    rng = np.random.default_rng(seed)
    north, up = rng.uniform(0, 6, 6000), rng.uniform(2, 5, 6000)
    off = slope * (6 - north) + lift * (up - 2) + rng.normal(0, noise, 6000)
    return np.column_stack([north, -20.0 + off, up])


def test_each_cell_has_the_distance_at_its_place() -> None:
    before = wall(1, slope=0.01), wall(1, lift=0.004)
    found = distance_map(
        ("L1", "L2"), before, (wall(2), wall(2)), np.ones(len(wall(2)), dtype=bool),
        facing=TO_VESSEL, spacing=0.1, reach=(0.08, 0.03),
    )  # fmt: skip
    assert found is not None
    assert found.cell == pytest.approx(0.4)
    assert len(found.before) > 0.9 * (6 / 0.4) * (3 / 0.4)
    # The place of a cell is that of one of its points; 40 points with 2 mm noise are averaged.
    np.testing.assert_allclose(found.before, 0.01 * found.across, atol=0.01 * 0.2 + 0.0025)
    np.testing.assert_allclose(found.after, 0.004 * found.up, atol=0.004 * 0.2 + 0.0025)
    assert np.corrcoef(found.before, found.across)[0, 1] > 0.99
    again = decode_value(json.loads(json.dumps(encode_value(found))), DistanceMap)
    for name, values in vars(found).items():
        np.testing.assert_array_equal(getattr(again, name), values)


def test_the_map_of_a_horizontal_plane_has_north_up_and_east_to_the_right() -> None:
    """A deck, 6 m by 3 m, that rises by 10 mm a metre to the east and is seen from below."""
    rng = np.random.default_rng(4)
    north, west = rng.uniform(0, 3, 6000), rng.uniform(0, 6, 6000)
    flat = np.column_stack([north, west, np.full(6000, 20.0)])
    risen = flat + np.outer(0.01 * (6 - west), [0, 0, -1.0])
    found = compare_plane(
        "V1", {"L1": risen, "L2": flat}, {"L1": risen, "L2": flat}, OPPOSITE,
        facing=np.array([0.0, 0.0, -1.0]),
    )  # fmt: skip
    (mapped,) = found.maps
    assert mapped.is_horizontal
    assert np.ptp(mapped.across) > 2 * np.ptp(mapped.up)
    np.testing.assert_allclose(mapped.after, 0.01 * mapped.across, atol=0.004)
    planes = found.pairs[0].after.planes
    assert planes is not None
    # The eastern edge of the first plane is turned towards the vessel: about north, west negative
    assert np.tan(planes.rotation_slope_axis) == pytest.approx(-0.01, abs=1e-6)
    assert planes.rotation_horizontal_axis == pytest.approx(0.0, abs=1e-6)
    labels = {text.get_text() for text in map_figure_of(ValidationPlane.of(found)).texts}
    assert "East (m)" in labels


def test_the_map_of_a_wall_is_not_horizontal() -> None:
    clouds = {"L1": wall(1), "L2": wall(2)}
    (mapped,) = compare_plane("V1", clouds, clouds, OPPOSITE, facing=TO_VESSEL).maps
    assert not mapped.is_horizontal


def mapped_pairs(plane: PlaneComparison) -> set[tuple[str, str]]:
    return {(each.line_a, each.line_b) for each in plane.maps}


def test_the_pairs_with_the_largest_offsets_are_mapped_and_the_caption_says_so() -> None:
    clouds = {f"L{k}": wall(k) for k in range(1, 5)}
    headings = OPPOSITE | {"L3": 0.1, "L4": 1.5}
    shifts = {"L1": 0.0, "L2": 0.02, "L3": 0.05, "L4": -0.03}
    moved = {name: points + [0.0, shifts[name], 0.0] for name, points in clouds.items()}
    found = compare_plane("V1", clouds, moved, headings, facing=TO_VESSEL)
    by_offset = sorted(
        ((pair.line_a, pair.line_b) for pair in found.pairs),
        key=lambda pair: -abs(shifts[pair[0]] - shifts[pair[1]]),
    )
    # L3 - L4: 80 mm, L1 - L3 and L2 - L4: 50 mm each
    assert mapped_pairs(found) == set(by_offset[:4])
    plane = ValidationPlane.of(found)
    titles = [text.get_text() for text in map_row_figure_of(plane).texts]
    assert any("L3" in title and "L4" in title for title in titles)

    def caption(template: str, shown: int) -> str:
        return gettext(template, plane="V1", shown=shown, total=6)

    assert map_caption(plane) == caption(LARGEST_CAPTION, 4)
    assert map_caption(plane, 2) == caption(LARGEST_CAPTION, 2)
    # An earlier version mapped reciprocal pairs with smaller offsets.
    earlier = replace(plane, maps=plane.maps[1:])
    assert map_caption(earlier, 2) == caption(SOME_CAPTION, 2)


def test_all_pairs_of_few_lines_are_mapped() -> None:
    clouds = {f"L{k}": wall(k) for k in range(1, 4)}
    found = compare_plane("V1", clouds, clouds, dict.fromkeys(clouds, 0.0), facing=TO_VESSEL)
    assert len(found.maps) == 3
    assert map_caption(ValidationPlane.of(found)) == gettext(CAPTION, plane="V1")


def images(figure: Figure) -> list[tuple[str, np.ndarray, tuple[float, float]]]:
    return [
        (axes.get_title(), image.get_array(), image.get_clim())
        for axes in figure.axes
        for image in axes.images
    ]


@pytest.mark.parametrize("tall", [False, True])
@pytest.mark.parametrize("draw", [map_figure_of, map_row_figure_of])
def test_all_maps_have_one_scale_that_their_distances_fill(
    tmp_path: Path, tall: bool, draw: Callable[[ValidationPlane], Figure]
) -> None:
    plane = ValidationPlane.of(sample_project(tmp_path).validation[0])
    if tall:
        maps = [replace(m, across_m=m.up_m, up_m=m.across_m) for m in plane.maps]
        plane = replace(plane, maps=tuple(maps))
    figure = draw(plane)
    figure.canvas.draw()
    found = images(figure)
    assert len(found) == 2 * len(plane.maps)
    for k, pair in enumerate(plane.maps):
        for (title, *_), state in zip(found[2 * k :], ("before", "after"), strict=False):
            (compared,) = (
                each for each in plane.pairs
                if (each.line_a, each.line_b) == (pair.line_a, pair.line_b)
            )  # fmt: skip
            assert title.startswith(state)
            offset = 1000 * getattr(compared, state).signed.median_m
            assert f"{abs(offset):.1f}" in title, "as in the tables"
    ((low, high),) = {clim for *_, clim in found}
    largest = 1000 * max(
        np.percentile(np.abs(values), 98.0)
        for each in plane.maps
        for values in (each.before_m, each.after_m)
    )
    assert high == -low == pytest.approx(largest)
    (bar,) = (axes for axes in figure.axes if not axes.images)
    assert bar.get_ylabel()
    assert bar.get_ylim() == pytest.approx((low, high))
    cells = np.unique(np.ma.compressed(np.ma.masked_invalid(found[0][1])))
    np.testing.assert_allclose(cells, np.unique(1000 * np.array(plane.maps[0].before_m)))


@pytest.mark.parametrize("sides", [(1.0, 1.0), (0.2, 1.0), (1.0, 0.1)])
@pytest.mark.parametrize("draw", [map_figure_of, map_row_figure_of])
def test_frames_have_the_shape_of_their_maps_and_one_scale(
    tmp_path: Path, sides: tuple[float, float], draw: Callable[[ValidationPlane], Figure]
) -> None:
    plane = ValidationPlane.of(sample_project(tmp_path).validation[0])
    first = plane.maps[0]
    across, up = np.array(first.across_m), np.array(first.up_m)
    whole = replace(
        first, across_m=tuple(sides[0] * across), up_m=tuple(sides[1] * up),
        cell_m=first.cell_m * min(sides),
    )  # fmt: skip
    kept = across < np.median(across)
    part = replace(
        whole,
        **{
            name: tuple(np.array(getattr(whole, name))[kept])
            for name in ("across_m", "up_m", "before_m", "after_m")
        },
    )
    figure = draw(replace(plane, maps=(whole, part)))
    figure.canvas.draw()
    shown = [axes for axes in figure.axes if axes.images]
    sizes = [axes.bbox.size / [np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())] for axes in shown]
    np.testing.assert_allclose(sizes, np.full((4, 2), sizes[0][0]), rtol=1e-3)
    for before, after in (shown[:2], shown[2:]):
        assert before.get_ylim() == after.get_ylim()
        assert before.bbox.y0 == pytest.approx(after.bbox.y0)
    assert shown[2].bbox.width < 0.7 * shown[0].bbox.width
    assert all(figure.bbox.x0 <= axes.bbox.x0 < axes.bbox.x1 <= figure.bbox.x1 for axes in shown)


@pytest.mark.parametrize(
    "lines", [("L1_000", "L2_180"), ("20261122_0815_quay_n", "20261122_0823_s")]
)
@pytest.mark.parametrize("sides", [(1.0, 1.0), (0.2, 1.0), (1.0, 0.1)])
@pytest.mark.parametrize("language", others_long(["en", "fr"], lambda language: language == "fr"))
def test_no_text_overlaps_another_or_the_margin(
    tmp_path: Path, lines: tuple[str, str], sides: tuple[float, float], language: str
) -> None:
    plane = ValidationPlane.of(sample_project(tmp_path).validation[0])
    first = plane.maps[0]
    turned = replace(
        first, line_a=lines[0], line_b=lines[1],
        across_m=tuple(sides[0] * x for x in first.up_m),
        up_m=tuple(sides[1] * x for x in first.up_m),
        cell_m=first.cell_m * min(sides),
    )  # fmt: skip
    plane = replace(plane, maps=(turned, turned))
    with in_language(language):
        figure = map_figure_of(plane)
        FigureCanvasAgg(figure).draw()
    labels = [
        text for axes in figure.axes for text in (axes.title, axes.xaxis.label, axes.yaxis.label)
    ]
    boxes = [text.get_window_extent() for text in (*labels, *figure.texts) if text.get_text()]
    for k, box in enumerate(boxes):
        assert box.x0 >= 0
        assert box.x1 <= figure.bbox.x1
        assert not any(box.overlaps(other) for other in boxes[:k])


def test_text_widths_agree_with_the_drawn_text() -> None:
    figure = Figure(dpi=72.0)
    for text in ("par rapport à L2_180", "Up (m)", "iiii\nWWWW"):
        drawn = figure.text(0, 0, text, fontsize=30).get_window_extent().width / 72
        assert text_width(text, 30) == pytest.approx(drawn, rel=0.05)


def test_the_tables_and_the_project_file_contain_the_cells(tmp_path: Path) -> None:
    project = sample_project(tmp_path / "p")
    write_tables(sample_content(project), tmp_path / "r.zip")
    with zipfile.ZipFile(tmp_path / "r.zip") as archive:
        (name,) = (n for n in archive.namelist() if n.endswith("map-of-v1-l1-relative-to-l2.csv"))
        rows = list(csv.reader(archive.read(name).decode("utf-8-sig").splitlines()))
    found = project.validation[0].maps[0]
    assert rows[0] == ["Horizontal (m)", "Up (m)", "Before (mm)", "After (mm)"]
    values = np.array(rows[1:], dtype=float)
    np.testing.assert_allclose(values[:, 2], 1000 * found.before, atol=0.005)
    write_project(project)
    path = project.folder / PROJECT_FILE_NAME
    stored = json.loads(path.read_text())
    again = read_project(project.folder).validation[0].maps[0]
    np.testing.assert_array_equal(again.after, found.after)
    # A file of an earlier version has no maps, and the picture suggests an action.
    for plane in stored["validation"]:
        del plane["maps"]
    path.write_text(json.dumps(stored))
    without_maps: PlaneComparison = read_project(project.folder).validation[0]
    assert without_maps.maps == ()
    figure = map_figure_of(ValidationPlane.of(without_maps))
    assert "Run the validation again" in figure.axes[0].texts[0].get_text()
