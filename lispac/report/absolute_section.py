"""The section on the absolute check: the lines against a static scan or surveyed points."""

from collections.abc import Sequence

from lispac.language import N_, gettext
from lispac.present.absolute import AbsoluteCheckValues, ReferenceDistances, SurveyedPoint
from lispac.present.text_format import (
    fixed_number,
    format_known,
    grouped_number,
    interval_text,
    millimetres,
    percent_text,
    sentence_text,
    shortest_number,
    signed_number,
)
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
from lispac.validation.absolute_check import ALL_LINES

LOCAL = "the local frame"
"""Coordinate system of a reference in the local frame, as the content calls it."""

DISTANCES = N_(
    "Distances between the lines and the reference along the normal of the surface, positive "
    "where the line is nearer to the vessel than the reference. They are computed at the same "
    "places before and after the calibration, for points within {reach} m of the reference."
)
UNCERTAINTY = N_(
    "POS: from the given accuracies, with one error common to all points of a line. Scatter: "
    "uncertainty of the mean of a line from the scatter of its distances. Errors "
    "common to all ranges, such as a range offset, are not included."
)


def absolute_check_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the check against a static scan or surveyed points."""
    from lispac.report.absolute_figure import reference_distance_figure

    found = content.absolute
    if found is None:
        return []
    blocks: list[Block] = [
        Paragraph(_reference_text(found)),
        Paragraph(gettext(DISTANCES, reach=shortest_number(found.search_distance_m))),
        _distance_table(found),
        Bullets(tuple(map(sentence_text, found.messages))),
    ]
    caption = gettext(
        "Distances of all lines from the reference, before and after the calibration."
    )
    blocks += [
        UndrawnPictures(caption, reference_distance_figure, (found,)),
        _uncertainty_table(found),
        Paragraph(gettext(UNCERTAINTY)),
    ]
    if found.points:
        blocks.append(_surveyed_points_table(found.points))
    if found.not_compared:
        reasons = tuple(map(sentence_text, found.not_compared))
        blocks += [Paragraph(gettext("Not compared with the reference:")), Bullets(reasons)]
    return blocks


def _reference_text(values: AbsoluteCheckValues) -> str:
    system = gettext("local frame") if values.system == LOCAL else values.system
    if values.kind == "scan":
        return gettext(
            "Reference: {file} (static scan). Coordinate system: {system}.",
            file=values.reference, system=system,
        )  # fmt: skip
    return gettext(
        "Reference: {file} (surveyed points). Coordinate system: {system}.",
        file=values.reference, system=system,
    )  # fmt: skip


def _distance_table(values: AbsoluteCheckValues) -> Table:
    """Statistics of the distances, one row for each line and state."""
    columns = (
        Column(gettext("Line"), "left"), Column(gettext("State"), "left"),
        Column(gettext("Compared\nplaces")), Column(gettext("Mean")),
        Column(gettext("95 %\ninterval\nof mean")),
        Column(gettext("Median")), Column(gettext("RMS")), Column(gettext("68 %")),
        Column(gettext("95 %")), Column(gettext("99 %")), Column(gettext("Robust\nsigma")),
        Column(gettext("Mean\nsignificant")),
    )  # fmt: skip
    cells = []
    for line in (*values.lines, values.all_lines):
        for state, against in ((gettext("before"), line.before), (gettext("after"), line.after)):
            cells.append([_line_label(line.line), state, *_statistics_cells(against)])
    title = gettext("Distances of the lines from the reference (mm)")
    return Table(title, columns, as_rows(cells))


def _line_label(name: str) -> str:
    return gettext("all lines") if name == ALL_LINES else name


def _statistics_cells(distances: ReferenceDistances) -> list[str]:
    return [
        grouped_number(distances.distances.n),
        signed_number(1000 * distances.signed.mean_m, 1),
        interval_text(millimetres(distances.mean_interval95_m)),
        signed_number(1000 * distances.signed.median_m, 1),
        millimetres(distances.distances.rms_m),
        millimetres(distances.distances.p68_m),
        millimetres(distances.distances.p95_m),
        millimetres(distances.distances.p99_m),
        millimetres(distances.signed.robust_sigma_m),
        gettext("yes") if distances.mean_significant else gettext("no"),
    ]


def _uncertainty_table(values: AbsoluteCheckValues) -> Table:
    columns = (
        Column(gettext("Line"), "left"), Column(gettext("Reference")),
        Column(gettext("POS\nposition")), Column(gettext("POS\nattitude")),
        Column(gettext("Boresight")), Column(gettext("Scatter")), Column(gettext("Total")),
        Column(gettext("Expected\nRMS")), Column(gettext("RMS share due\nto the reference")),
    )  # fmt: skip
    cells = []
    for line in (*values.lines, values.all_lines):
        sigma = line.after.mean_sigma
        cells.append(
            [
                _line_label(line.line),
                millimetres(sigma.reference_m),
                millimetres(sigma.pos_position_m),
                millimetres(sigma.pos_attitude_m),
                format_known(sigma.boresight_m, millimetres),
                millimetres(sigma.scatter_m),
                millimetres(sigma.total_m),
                millimetres(line.after.rms_expected.total_m),
                percent_text(line.after.reference_share),
            ]
        )
    title = gettext("Uncertainty of the mean distance after the calibration, 1 sigma (mm)")
    return Table(title, columns, as_rows(cells))


def _surveyed_points_table(points: Sequence[SurveyedPoint]) -> Table:
    return Table(
        gettext("Distances from surveyed points and planes, mean of the lines (mm)"),
        (
            Column(gettext("Name"), "left"),
            Column(gettext("Lines")),
            Column(gettext("Sigma")),
            Column(gettext("Before")),
            Column(gettext("After")),
            Column(gettext("95 %\ninterval\nof mean")),
            Column(gettext("Mean\nsignificant")),
        ),
        as_rows(
            [
                point.name,
                fixed_number(point.lines, 0),
                millimetres(point.sigma_m),
                signed_number(1000 * point.before_m, 1),
                signed_number(1000 * point.after_m, 1),
                format_known(
                    point.after_interval95_m, lambda half: interval_text(millimetres(half))
                ),
                gettext("yes") if point.significant else gettext("no"),
            ]
            for point in points
        ),
    )
