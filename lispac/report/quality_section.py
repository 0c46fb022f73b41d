"""The table of how good each sighting is."""

from lispac.report.blocks import Block, Column, Paragraph, Table, rows
from lispac.report.values import ReportContent, SightingJudged
from lispac.report.wording import known, mm


def quality_of_sightings(content: ReportContent) -> list[Block]:
    """Every sighting with its figures and its light; nothing where none was judged."""
    if not content.qualities:
        return []
    table = Table(
        "Quality of each sighting",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            Column("Points"),
            Column("RMS\n(mm)"),
            Column("Range\n(m)"),
            Column("Points\nper m²"),
            Column("Incidence\n(deg)"),
            Column("Covered\n(%)"),
            Column("Shown\n(%)"),
            Column("Quality", "left", wide=True),
        ),
        rows(
            [
                each.target,
                each.line,
                f"{each.points:,}",
                mm(each.rms_m),
                f"{each.range_m:.1f}",
                known(each.density_per_m2, lambda value: f"{value:,.0f}"),
                known(each.incidence_deg, lambda value: f"{value:.0f}"),
                f"{100 * each.coverage:.0f}",
                known(each.share_shown, lambda value: f"{100 * value:.0f}"),
                " ".join((f"{each.light.capitalize()}.", *each.reasons, *_edited(each))),
            ]
            for each in content.qualities
        ),
    )
    told = "RMS about the sighting's own surface; incidence counts from its normal."
    if any(each.share_shown is not None for each in content.qualities):
        told += " Shown is its size by what the other lines show of it."
    if not content.calibrated:
        told += (
            " What an error of the rough boresight can explain does not count in RMS, curvature and"
            " flatness: it bends what is seen from a moving vessel."
        )
    return [table, Paragraph(told)]


def _edited(sighting: SightingJudged) -> tuple[str, ...]:
    return ("Its points were edited by hand.",) if sighting.edited_by_hand else ()
