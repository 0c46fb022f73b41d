"""The section on the absolute check: the lines against a static scan or surveyed points."""

from collections.abc import Sequence

from lispac.report.absolute_values import Absolute, AgainstReference, SurveyedPoint
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, rows
from lispac.report.values import ReportContent
from lispac.report.wording import known, mm, signed


def absolute(content: ReportContent) -> list[Block]:
    """The check against a static scan or surveyed points."""
    from lispac.report.absolute_figure import absolute_figure

    found = content.absolute
    if found is None:
        return []
    what = "static scan" if found.kind == "scan" else "surveyed points"
    where = "the local frame" if found.system == "the local frame" else found.system
    blocks: list[Block] = [
        Paragraph(
            f"Signed distances of the lines from {found.reference} ({what}, in {where}) along the "
            "normal, positive where a line lies nearer to the vessel, at the same places before "
            f"and after the calibration and no farther than {found.reach_m:g} m from it."
        ),
        _table(found),
        Bullets(found.in_words),
    ]
    caption = "Distances of all lines from the reference, before and after."
    blocks += [Drawing(caption, absolute_figure, (found,)), _uncertainty(found)]
    blocks.append(
        Paragraph(
            "POS: by the stated accuracies, one error for all that a line saw. Scatter: of the "
            "places about the mean of their line, averaged. What the ranges have in common, a "
            "range offset for one, is not in the sum."
        )
    )
    if found.points:
        blocks.append(_points(found.points))
    if found.not_compared:
        blocks += [Paragraph("Not compared:"), Bullets(found.not_compared)]
    return blocks


def _table(found: Absolute) -> Table:
    """Every figure of the distances, one row a line and state."""
    columns = (
        Column("Line", "left"), Column("State", "left"), Column("Places"), Column("Mean"),
        Column("95 % of\nthe mean"), Column("Median"), Column("RMS"), Column("68 %"),
        Column("95 %"), Column("99 %"), Column("Robust\nsigma"), Column("Mean\ndiffers"),
    )  # fmt: skip
    cells = []
    for line in (*found.lines, found.together):
        for state, against in (("before", line.before), ("after", line.after)):
            cells.append([line.line, state, *_cells(against)])
    return Table("Distances of the lines from the reference (mm)", columns, rows(cells))


def _cells(found: AgainstReference) -> list[str]:
    return [
        f"{found.distances.n:,}",
        signed(1000 * found.signed.mean_m, 1),
        f"\u00b1 {mm(found.mean_interval95_m)}",
        signed(1000 * found.signed.median_m, 1),
        mm(found.distances.rms_m),
        mm(found.distances.p68_m),
        mm(found.distances.p95_m),
        mm(found.distances.p99_m),
        mm(found.signed.robust_sigma_m),
        "yes" if found.mean_significant else "no",
    ]


def _uncertainty(found: Absolute) -> Table:
    columns = (
        Column("Line", "left"), Column("Reference"), Column("POS\nposition"),
        Column("POS\nattitude"), Column("Boresight"), Column("Scatter"), Column("Together"),
        Column("RMS\nexpected"), Column("Share of the RMS\nby the reference"),
    )  # fmt: skip
    cells = []
    for line in (*found.lines, found.together):
        sigma = line.after.mean_sigma
        cells.append(
            [
                line.line, mm(sigma.reference_m), mm(sigma.pos_position_m),
                mm(sigma.pos_attitude_m), known(sigma.boresight_m, mm), mm(sigma.scatter_m),
                mm(sigma.total_m), mm(line.after.rms_expected.total_m),
                f"{100 * line.after.reference_share:.0f}\u00a0%",
            ]
        )  # fmt: skip
    return Table("What the mean after may be off by, 1 sigma (mm)", columns, rows(cells))


def _points(points: Sequence[SurveyedPoint]) -> Table:
    return Table(
        "Surveyed points and planes, on the mean of the lines (mm)",
        (
            Column("Name", "left"), Column("Lines"), Column("Sigma"), Column("Before"),
            Column("After"), Column("95 % of\nthe mean"), Column("Mean\ndiffers"),
        ),
        rows(
            [
                point.name, str(point.lines), mm(point.sigma_m), signed(1000 * point.before_m, 1),
                signed(1000 * point.after_m, 1),
                known(point.after_interval95_m, lambda half: f"\u00b1 {mm(half)}"),
                "yes" if point.significant else "no",
            ]
            for point in points
        ),
    )  # fmt: skip
