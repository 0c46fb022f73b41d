"""The section on the absolute check: the lines against a static scan or surveyed points."""

from lispac.language import N_, gettext
from lispac.present.absolute import (
    MEAN_UNCERTAINTY_TABLE,
    REFERENCE_DISTANCES_TABLE,
    SURVEYED_POINTS_TABLE,
    AbsoluteCheckValues,
    line_states,
    lines_and_all,
)
from lispac.present.text_format import (
    sentence_text,
    shortest_number,
)
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    UndrawnPictures,
    report_table,
)
from lispac.report.report_values import ReportContent

LOCAL_FRAME_NAME = "the local frame"
"""Value of `AbsoluteCheckValues.system` for a reference with coordinates in the local frame."""

DISTANCES_TEXT = N_(
    "Distances between the lines and the reference along the normal of the surface, positive "
    "where the line is nearer to the vessel than the reference. They are computed at the same "
    "places before and after the calibration, for points within {reach} m of the reference."
)
UNCERTAINTY_TEXT = N_(
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
        Paragraph(gettext(DISTANCES_TEXT, reach=shortest_number(found.search_distance_m))),
        report_table(REFERENCE_DISTANCES_TABLE, line_states(found)),
        Bullets(tuple(map(sentence_text, found.messages))),
    ]
    caption = gettext(
        "Distances of all lines from the reference, before and after the calibration."
    )
    blocks += [
        UndrawnPictures(caption, reference_distance_figure, (found,)),
        report_table(MEAN_UNCERTAINTY_TABLE, lines_and_all(found)),
        Paragraph(gettext(UNCERTAINTY_TEXT)),
    ]
    if found.points:
        blocks.append(report_table(SURVEYED_POINTS_TABLE, found.points))
    if found.not_compared:
        reasons = tuple(map(sentence_text, found.not_compared))
        blocks += [Paragraph(gettext("Not compared with the reference:")), Bullets(reasons)]
    return blocks


def _reference_text(values: AbsoluteCheckValues) -> str:
    system = gettext("local frame") if values.system == LOCAL_FRAME_NAME else values.system
    if values.kind == "scan":
        return gettext(
            "Reference: {file} (static scan). Coordinate system: {system}.",
            file=values.reference, system=system,
        )  # fmt: skip
    return gettext(
        "Reference: {file} (surveyed points). Coordinate system: {system}.",
        file=values.reference, system=system,
    )  # fmt: skip
