"""The section on validation: distances between lines on planes not used in the adjustment."""

from collections.abc import Mapping, Sequence

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Column,
    Paragraph,
    Table,
    UndrawnPictures,
    as_rows,
)
from lispac.report.report_values import ReportContent
from lispac.report.text_format import (
    UNKNOWN,
    fixed_number,
    format_known,
    grouped_number,
    interval_text,
    millimetres,
    percent_text,
    signed_number,
    title_with_unit,
    with_interval,
)
from lispac.report.validation_values import DistanceValues, PairValues, ValidationPlane

PLACES = N_("Signed distances along the normal, reciprocal pairs (mm)")
PLANES = N_("Comparison of the planes fitted to two lines, reciprocal pairs")

POOLED: Mapping[str, str] = {
    "reciprocal pairs": N_("Histograms and totals use the reciprocal pairs of lines only."),
    "all pairs": N_("Histograms and totals use all pairs of lines."),
}
"""Line pairs that the statistics of a plane are from, by what the content calls them."""

DISTANCES = N_(
    "Distances from each point of one line to the surface of the other, in both directions, only "
    "where both lines cover the plane. The points are the same before and after the calibration. "
    "The distances that remain after the calibration are caused by the POS error of each line, "
    "which the boresight cannot correct."
)
ROBUST = N_(
    "Robust sigma: 1.4826 times the median absolute deviation from the median. Outliers: distances "
    "more than three robust sigmas above the median; all other statistics include them."
)
SIGNED = N_(
    "Distance of the first line from the second, positive towards the vessel, between means "
    "within cylinders along the local normal (M3C2); averaging reduces the noise of single "
    "points. The 95 % interval is that of one place, from the scatter of its points. The last "
    "column of each state gives the percentage of places whose distance exceeds this interval."
)
PLANE_OFFSETS = N_(
    "The plane fitted to the points of the first line is compared with that of the second, with "
    "95 % intervals from the scatter of the points. An offset is positive if the first plane is "
    "nearer to the vessel. A rotation is positive if the upper edge of the first plane "
    "(horizontal axis), or its right edge as seen from the vessel (vertical axis), is turned "
    "towards the vessel."
)
MAP = N_(
    "{plane}: distance of the first line from the second along the normal; the plane is shown as "
    "seen from the vessel. Red: the first line is nearer to the vessel; blue: it is farther away; "
    "grey: one of the lines has too few points."
)


def validation_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the distances between the lines before and after the calibration."""
    if not content.validation:
        return [Paragraph(gettext("The lines have not been compared on any validation plane."))]
    models = sorted({message_text(plane.measured_to) for plane in content.validation})
    pooled = sorted({plane.pooled_from for plane in content.validation})
    blocks: list[Block] = [
        Paragraph(gettext(DISTANCES)),
        Bullets(
            (
                gettext("Surface model of a line: {models:names}.", models=models),
                *(gettext(POOLED[each]) for each in pooled),
            )
        ),
        _statistics_table(content.validation),
        Paragraph(gettext(ROBUST)),
    ]
    for plane in content.validation:
        blocks += _figure_blocks(plane)
    blocks.append(
        distance_table(
            gettext("Distances for every pair of lines (mm)"),
            [
                Column(gettext("Plane"), "left"), Column(gettext("Lines"), "left"),
                Column(gettext("Reciprocal"), "left"),
            ],
            [
                (
                    (
                        *_pair_name_cells(plane, pair),
                        gettext("yes") if pair.reciprocal else gettext("no"),
                    ),
                    pair.before.distances,
                    pair.after.distances,
                )
                for plane in content.validation
                for pair in plane.pairs
            ],
        )
    )  # fmt: skip
    blocks += _signed_tables(content.validation)
    omitted = tuple(_not_compared_text(plane) for plane in content.validation if plane.not_compared)
    if omitted:
        blocks += [
            Paragraph(
                gettext("Not compared, because the two lines cover no common part of the plane:")
            ),
            Bullets(omitted),
        ]
    return blocks


def _figure_blocks(plane: ValidationPlane) -> list[Block]:
    from lispac.report.distance_maps import map_figure_of
    from lispac.report.distance_profiles import profile_figure_of
    from lispac.report.histograms import validation_figure

    caption = gettext(
        "{plane}: distances between lines before and after the calibration.", plane=plane.name
    )
    blocks: list[Block] = [UndrawnPictures(caption, validation_figure, (plane,))]
    if plane.by_height is not None or plane.by_range is not None:
        caption = gettext(_profile_caption(plane), plane=plane.name)
        blocks.append(UndrawnPictures(caption, profile_figure_of, (plane,)))
    if plane.maps:
        blocks.append(UndrawnPictures(gettext(MAP, plane=plane.name), map_figure_of, (plane,)))
    return blocks


def _profile_caption(plane: ValidationPlane) -> str:
    if plane.by_range is None:
        return N_("{plane}: median and 95th percentile of the distances by height.")
    if plane.by_height is None:
        return N_("{plane}: median and 95th percentile of the distances by range.")
    return N_("{plane}: median and 95th percentile of the distances by height and by range.")


def _statistics_table(planes: Sequence[ValidationPlane]) -> Table:
    """Statistics of the pooled distances, one row for each state."""
    columns = (
        Column(gettext("Plane"), "left"), Column(gettext("State"), "left"),
        Column(gettext("Points")), Column(gettext("Mean")), Column(gettext("Median")),
        Column(gettext("RMS")), Column(gettext("68 %")), Column(gettext("95 %")),
        Column(gettext("99 %")), Column(gettext("Robust\nsigma")), Column(gettext("Outliers")),
    )  # fmt: skip
    cells = []
    for plane in planes:
        for state, d in ((gettext("before"), plane.before), (gettext("after"), plane.after)):
            cells.append(
                [
                    plane.name,
                    state,
                    grouped_number(d.n),
                    millimetres(d.mean_m),
                    millimetres(d.median_m),
                    millimetres(d.rms_m),
                    millimetres(d.p68_m),
                    millimetres(d.p95_m),
                    millimetres(d.p99_m),
                    format_known(d.robust_sigma_m, millimetres),
                    format_known(d.outliers, grouped_number),
                ]
            )
    return Table(gettext("Distances between lines on each plane (mm)"), columns, as_rows(cells))


def _signed_tables(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Offsets and rotations with their intervals, of the pairs where the boresight shows most."""
    listed = [
        (plane, pair)
        for plane in planes
        for pair in plane.pairs
        if pair.reciprocal or plane.pooled_from == "all pairs"
    ]
    blocks: list[Block] = []
    if any(pair.after.signed is not None for _, pair in listed):
        blocks += [
            Table(
                gettext(PLACES),
                (
                    Column(gettext("Plane"), "left"),
                    Column(gettext("Lines"), "left"),
                    Column(gettext("Compared\nplaces")),
                    *_before_after_columns(
                        gettext("Median"),
                        gettext("95 % interval\nof a place"),
                        gettext("Significant\nplaces"),
                    ),
                ),
                as_rows(
                    [*_pair_name_cells(plane, pair), *_place_cells(pair)] for plane, pair in listed
                ),
            ),
            Paragraph(gettext(SIGNED)),
        ]
    if any(pair.after.planes is not None for _, pair in listed):
        blocks += [
            Table(
                gettext(PLANES),
                (
                    Column(gettext("Plane"), "left"),
                    Column(gettext("Lines"), "left"),
                    *_before_after_columns(
                        title_with_unit(gettext("Offset"), "mm"),
                        gettext("Rotation, horiz.\naxis (deg)"),
                        gettext("Rotation, vert.\naxis (deg)"),
                    ),
                ),
                as_rows(
                    [*_pair_name_cells(plane, pair), *_plane_cells(pair)] for plane, pair in listed
                ),
            ),
            Paragraph(gettext(PLANE_OFFSETS)),
        ]
    return blocks


def _pair_name_cells(plane: ValidationPlane, pair: PairValues) -> tuple[str, str]:
    return plane.name, f"{pair.line_a} / {pair.line_b}"


def _before_after_columns(*names: str) -> tuple[Column, ...]:
    """Each value before, then each after."""
    states = gettext("before"), gettext("after")
    return tuple(Column(f"{name}\n{state}") for state in states for name in names)


def _place_cells(pair: PairValues) -> list[str]:
    cells = [
        format_known(
            None if pair.after.signed is None else pair.after.signed.places, grouped_number
        )
    ]
    for state in (pair.before, pair.after):
        s = state.signed
        cells += (
            [UNKNOWN] * 3
            if s is None
            else [
                signed_number(1000 * s.median_m, 1), interval_text(millimetres(s.interval95_m)),
                percent_text(s.significant_share),
            ]
        )  # fmt: skip
    return cells


def _plane_cells(pair: PairValues) -> list[str]:
    cells: list[str] = []
    for state in (pair.before, pair.after):
        p = state.planes
        cells += (
            [UNKNOWN] * 3
            if p is None
            else [
                with_interval(
                    signed_number(1000 * p.offset_m, 1), millimetres(p.offset_interval95_m)
                ),
                _rotation_cell(
                    p.rotation_horizontal_axis_deg, p.rotation_horizontal_axis_interval95_deg
                ),
                _rotation_cell(p.rotation_slope_axis_deg, p.rotation_slope_axis_interval95_deg),
            ]
        )
    return cells


def _rotation_cell(value: float, half: float) -> str:
    return with_interval(signed_number(value, 3), fixed_number(half, 3))


def _not_compared_text(plane: ValidationPlane) -> str:
    pairs = ", ".join(f"{a} / {b}" for a, b in plane.not_compared)
    return gettext("{plane}: {pairs}", plane=plane.name, pairs=pairs)


def distance_table(
    title: str,
    head: Sequence[Column],
    compared: Sequence[tuple[tuple[str, ...], DistanceValues, DistanceValues]],
) -> Table:
    """Median, RMS and 95 % of distances, before and after."""
    statistics = (gettext("Median"), gettext("RMS"), gettext("95 %"))
    states = gettext("before"), gettext("after")
    columns = (
        *head,
        Column(gettext("Points")),
        *(Column(f"{name}\n{state}") for name in statistics for state in states),
    )
    return Table(
        title,
        columns,
        as_rows(
            [
                *names,
                grouped_number(before.n),
                millimetres(before.median_m), millimetres(after.median_m),
                millimetres(before.rms_m), millimetres(after.rms_m),
                millimetres(before.p95_m), millimetres(after.p95_m),
            ]
            for names, before, after in compared
        ),
    )  # fmt: skip
