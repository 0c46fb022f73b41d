"""The section on the absolute check: the lines against a static scan or surveyed points."""

from collections.abc import Sequence

from lispac.language import N_, gettext
from lispac.report.absolute_values import Absolute, AgainstReference, SurveyedPoint
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, rows
from lispac.report.values import ReportContent
from lispac.report.wording import (
    fixed,
    grouped,
    interval,
    known,
    mm,
    percent,
    sentence,
    shortest,
    signed,
)
from lispac.validation.absolute import ALL_LINES

LOCAL = "the local frame"
"""Coordinate system of a reference in the local frame, as the content calls it."""

DISTANCES = N_(
    "Distances between the lines and the reference along the normal of the surface, positive "
    "where the line is nearer to the vessel than the reference. They are computed at the same "
    "places before and after the calibration, for points within {reach} m of the reference."
)
UNCERTAINTY = N_(
    "POS: from the given accuracies, with one error common to all points of a line. Scatter: "
    "uncertainty of the mean of a line from the scatter of the distances at its places. Errors "
    "common to all ranges, such as a range offset, are not included."
)


def absolute(content: ReportContent) -> list[Block]:
    """The check against a static scan or surveyed points."""
    from lispac.report.absolute_figure import absolute_figure

    found = content.absolute
    if found is None:
        return []
    blocks: list[Block] = [
        Paragraph(_reference(found)),
        Paragraph(gettext(DISTANCES, reach=shortest(found.reach_m))),
        _table(found),
        Bullets(tuple(map(sentence, found.in_words))),
    ]
    caption = gettext(
        "Distances of all lines from the reference, before and after the calibration."
    )
    blocks += [
        Drawing(caption, absolute_figure, (found,)),
        _uncertainty(found),
        Paragraph(gettext(UNCERTAINTY)),
    ]
    if found.points:
        blocks.append(_points(found.points))
    if found.not_compared:
        reasons = tuple(map(sentence, found.not_compared))
        blocks += [Paragraph(gettext("Not compared with the reference:")), Bullets(reasons)]
    return blocks


def _reference(found: Absolute) -> str:
    system = gettext("local frame") if found.system == LOCAL else found.system
    if found.kind == "scan":
        return gettext(
            "Reference: {file} (static scan). Coordinate system: {system}.",
            file=found.reference, system=system,
        )  # fmt: skip
    return gettext(
        "Reference: {file} (surveyed points). Coordinate system: {system}.",
        file=found.reference, system=system,
    )  # fmt: skip


def _table(found: Absolute) -> Table:
    """Statistics of the distances, one row for each line and state."""
    columns = (
        Column(gettext("Line"), "left"), Column(gettext("State"), "left"),
        Column(gettext("Places")), Column(gettext("Mean")),
        Column(gettext("95 %\ninterval\nof mean")),
        Column(gettext("Median")), Column(gettext("RMS")), Column(gettext("68 %")),
        Column(gettext("95 %")), Column(gettext("99 %")), Column(gettext("Robust\nsigma")),
        Column(gettext("Mean\nsignificant")),
    )  # fmt: skip
    cells = []
    for line in (*found.lines, found.together):
        for state, against in ((gettext("before"), line.before), (gettext("after"), line.after)):
            cells.append([_line(line.line), state, *_cells(against)])
    title = gettext("Distances of the lines from the reference (mm)")
    return Table(title, columns, rows(cells))


def _line(name: str) -> str:
    return gettext("all lines") if name == ALL_LINES else name


def _cells(found: AgainstReference) -> list[str]:
    return [
        grouped(found.distances.n),
        signed(1000 * found.signed.mean_m, 1),
        interval(mm(found.mean_interval95_m)),
        signed(1000 * found.signed.median_m, 1),
        mm(found.distances.rms_m),
        mm(found.distances.p68_m),
        mm(found.distances.p95_m),
        mm(found.distances.p99_m),
        mm(found.signed.robust_sigma_m),
        gettext("yes") if found.mean_significant else gettext("no"),
    ]


def _uncertainty(found: Absolute) -> Table:
    columns = (
        Column(gettext("Line"), "left"), Column(gettext("Reference")),
        Column(gettext("POS\nposition")), Column(gettext("POS\nattitude")),
        Column(gettext("Boresight")), Column(gettext("Scatter")), Column(gettext("Total")),
        Column(gettext("Expected\nRMS")), Column(gettext("RMS share due\nto the reference")),
    )  # fmt: skip
    cells = []
    for line in (*found.lines, found.together):
        sigma = line.after.mean_sigma
        cells.append(
            [
                _line(line.line), mm(sigma.reference_m), mm(sigma.pos_position_m),
                mm(sigma.pos_attitude_m), known(sigma.boresight_m, mm), mm(sigma.scatter_m),
                mm(sigma.total_m), mm(line.after.rms_expected.total_m),
                percent(line.after.reference_share),
            ]
        )  # fmt: skip
    title = gettext("Uncertainty of the mean distance after the calibration, 1 sigma (mm)")
    return Table(title, columns, rows(cells))


def _points(points: Sequence[SurveyedPoint]) -> Table:
    return Table(
        gettext("Distances from surveyed points and planes, mean of the lines (mm)"),
        (
            Column(gettext("Name"), "left"), Column(gettext("Lines")), Column(gettext("Sigma")),
            Column(gettext("Before")), Column(gettext("After")),
            Column(gettext("95 %\ninterval\nof mean")), Column(gettext("Mean\nsignificant")),
        ),
        rows(
            [
                point.name, fixed(point.lines, 0), mm(point.sigma_m),
                signed(1000 * point.before_m, 1), signed(1000 * point.after_m, 1),
                known(point.after_interval95_m, lambda half: interval(mm(half))),
                gettext("yes") if point.significant else gettext("no"),
            ]
            for point in points
        ),
    )  # fmt: skip
