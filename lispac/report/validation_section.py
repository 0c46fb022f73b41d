"""The sections on validation: distances between lines, or from a reference, and standards."""

from collections.abc import Sequence

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.calibration.displacement import S44_TABLE
from lispac.present.checking.absolute import (
    MEAN_UNCERTAINTY_TABLE,
    REFERENCE_DISTANCES_TABLE,
    SURVEYED_POINTS_TABLE,
    AbsoluteCheckValues,
    line_states,
    lines_and_all,
)
from lispac.present.checking.acceptance import AcceptanceValues, acceptance_table
from lispac.present.checking.validation import (
    PAIR_DISTANCES_TABLE,
    PAIR_PLACES_TABLE,
    PAIR_PLANES_TABLE,
    POOLED_DISTANCES_TABLE,
    RECIPROCAL_PAIRS_TEXT,
    SHIFTS_TABLE,
    ValidationPlane,
    pair_rows,
    pooled_rows,
    shift_rows,
    swath_overlap_table,
)
from lispac.present.targets.surface_geometry import PlaneSection
from lispac.present.text_format import (
    sentence_text,
    shortest_number,
)
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Group,
    Paragraph,
    PictureRow,
    UndrawnPictures,
    report_table,
)
from lispac.report.report_values import ReportContent
from lispac.report.section_summaries import validation_summary
from lispac.report.validation_warnings import shift_limit
from lispac.targets.surface_geometry import SECTION_THICKNESS_M

DISTANCES_TEXT = N_(
    "Distances from each point of one line to the surface of the other, in both directions and for "
    "all pairs of lines, only where both lines cover the plane. The points are the same before and "
    "after the calibration. The distances that remain after the calibration are caused mainly by "
    "the POS error of each line, which the boresight cannot correct."
)
ROBUST_SIGMA_TEXT = N_(
    "Robust sigma: 1.4826 times the median absolute deviation from the median. Outliers: distances "
    "more than three robust sigmas above the median; all other statistics include them."
)
SIGNED_DISTANCES_TEXT = N_(
    "Distance of the first line from the second, positive towards the vessel, between means "
    "within cylinders along the local normal (M3C2); averaging reduces the noise of single "
    "points. A place is one cylinder. Offset: median of the places. The 95 % interval is that of "
    "one place, from the scatter of its points. The last column of each state gives the "
    "percentage of places whose distance exceeds this interval."
)
PLANE_OFFSETS_TEXT = N_(
    "The plane fitted to the points of the first line is compared with that of the second, with "
    "95 % intervals from the scatter of the points. A plane offset, the distance of the planes in "
    "the middle of the points, is positive if the first plane is nearer to the vessel. Axis u is "
    "the horizontal axis in the plane, to the right as seen from the vessel, and axis v points up "
    "its slope; on a horizontal plane, u points west and v north. A rotation about u is positive "
    "if the edge of the first plane in direction v is turned towards the vessel, a rotation about "
    "v if the edge in direction u is."
)
ACCEPTANCE_TEXT = N_(
    "RMS: of the distances between the lines after the calibration, as in the table above. Offset: "
    "absolute value of the median signed distance between two lines; the pair with the largest "
    "offset of all pairs is given. A smaller value than before the calibration is not a criterion."
)
SHIFTS_TEXT = N_(
    "Mean distance of one line, or of several lines, from the others after the calibration; "
    "positive if nearer to the vessel. The sigma combines the POS errors of the lines, the "
    "covariance of the boresight, the form error of the surface (its change from line to line) and "
    "the scatter of the distances. Test value w: shift divided by sigma; a shift is significant, "
    "with a warning, if the absolute value of w exceeds {limit:x.1}. Smaller shifts can also give "
    "a histogram several peaks."
)
MAP_LEGEND_TEXT = N_(
    "Maps: distance of the first line from the second along the normal of the plane, seen from the "
    "vessel, or from above if the plane is horizontal; red: the first line is nearer to the "
    "vessel, blue: it is farther away, grey: too few points. A colour scale that ends beyond 40 mm "
    "is logarithmic beyond 20 mm. The number above a map is the offset of the two lines."
)
SECTION_TEXT = N_(
    "Sections: points of all lines in a strip {thickness:m.1} m wide across the middle of a "
    "validation plane. Distances are from the middle of all lines along the normal, positive "
    "towards the vessel. The scales before and after the calibration differ."
)
S44_TEXT = N_(
    "Total horizontal and vertical uncertainty (THU, TVU) as defined in IHO S-44, edition 6.1.0, "
    "at 95 % confidence: 2.45 standard deviations along the longest axis of the horizontal error "
    "ellipse, 1.96 standard deviations of the height. The table gives the contribution of the "
    "boresight to the uncertainty of a point at that distance from the scanner, for the most "
    "unfavourable beam and a level vessel. It is not the total uncertainty of a survey, which "
    "also includes position, attitude, range, lever arm and the reduction of heights. The orders "
    "of the standard limit the total uncertainty; the table is not compared with them."
)
OVERLAP_TEXT = N_(
    "The swath overlap difference of the USGS Lidar Base Specification (2024 rev. A) is the root "
    "mean square of the height differences of overlapping swaths (RMSDz) on open ground. The "
    "differences given here are those along the normal of each validation plane, whatever its "
    "orientation, between the means of both lines within cylinders (places), for every pair of "
    "overlapping lines. Averaging reduces the noise of single points; after the calibration, the "
    "POS error of each line remains. The quality levels of the specification apply to "
    "heights on the ground; the differences are not compared with them."
)
MAX_MAP_HEIGHT_MM = 95.0
"""Largest height of the maps of a plane, which fit on a page with its other figures."""
LOCAL_FRAME_NAME = "the local frame"
"""Value of `AbsoluteCheckValues.system` for a reference with coordinates in the local frame."""

REFERENCE_DISTANCES_TEXT = N_(
    "Distances between the lines and the reference along the normal of the surface, positive "
    "where the line is nearer to the vessel than the reference. They are computed at the same "
    "places before and after the calibration, for points within {reach} m of the reference."
)
UNCERTAINTY_TEXT = N_(
    "POS: from the given accuracies, with one error common to all points of a line. Scatter: "
    "uncertainty of the mean of a line from the scatter of its distances. Errors "
    "common to all ranges, such as a range offset, are not included."
)


def validation_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the distances between the lines before and after the calibration."""
    if not content.validation:
        return [Paragraph(gettext("The lines have not been compared on any validation plane."))]
    models = sorted({message_text(plane.measured_to) for plane in content.validation})
    blocks: list[Block] = [
        *validation_summary(content),
        Paragraph(gettext(DISTANCES_TEXT)),
        Paragraph(gettext("Surface model of a line: {models:names}.", models=models)),
        *reciprocal_pairs_note(content.validation),
        Paragraph(gettext(ROBUST_SIGMA_TEXT)),
        report_table(POOLED_DISTANCES_TABLE, pooled_rows(content.validation)),
        *_acceptance_blocks(content.acceptance),
        report_table(PAIR_DISTANCES_TABLE, pair_rows(content.validation)),
        *_signed_tables(content.validation),
        *_shift_blocks(content.validation),
    ]
    omitted = tuple(_not_compared_text(plane) for plane in content.validation if plane.not_compared)
    if omitted:
        blocks += [
            Paragraph(
                gettext("Not compared, because the two lines cover no common part of the plane:")
            ),
            Bullets(omitted),
        ]
    return [*blocks, *_figures(content.validation)]


def reciprocal_pairs_note(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Note on the planes of earlier versions whose statistics use the reciprocal pairs only."""
    names = [plane.name for plane in planes if plane.pooled_from != "all pairs"]
    return [Paragraph(gettext(RECIPROCAL_PAIRS_TEXT, planes=names))] if names else []


def _acceptance_blocks(acceptance: AcceptanceValues) -> list[Block]:
    """Table of the acceptance criteria on every plane; none without criteria."""
    checks = [check for check in acceptance.checks if check.plane]
    if not checks:
        return []
    return [
        Paragraph(gettext(ACCEPTANCE_TEXT)),
        report_table(acceptance_table(acceptance.criteria.source), checks),
    ]


def _shift_blocks(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Table of the shifts of lines; none if they were not computed."""
    rows = shift_rows(planes)
    if not rows:
        return []
    text = gettext(SHIFTS_TEXT, limit=shift_limit(planes))
    return [Paragraph(text), report_table(SHIFTS_TABLE, rows)]


def _figures(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Histogram, profiles and maps of each plane, those of one plane on one page.

    The explanation of the maps is above the first ones.
    """
    from lispac.report.distance_maps import map_caption, map_figure_of
    from lispac.report.distance_profiles import is_drawn, profile_figure_of
    from lispac.report.histograms import validation_figure

    groups: list[Block] = []
    for plane in planes:
        blocks: list[Block] = []
        if not groups and any(each.maps for each in planes):
            blocks.append(Paragraph(gettext(MAP_LEGEND_TEXT)))
        caption = gettext(
            "{plane}: distances between lines before and after the calibration.", plane=plane.name
        )
        blocks.append(UndrawnPictures(caption, validation_figure, (plane,)))
        by_height, by_range = is_drawn(plane.by_height), is_drawn(plane.by_range)
        if by_height or by_range:
            caption = gettext(_profile_caption(by_height, by_range), plane=plane.name)
            blocks.append(UndrawnPictures(caption, profile_figure_of, (plane,)))
        if plane.maps:
            caption = gettext(
                "{caption} Red: the first line is nearer to the vessel; blue: it is farther away.",
                caption=map_caption(plane),
            )
            drawn = UndrawnPictures(caption, map_figure_of, (plane,))
            blocks.append(PictureRow((drawn,), tallest=MAX_MAP_HEIGHT_MM))
        groups.append(Group(tuple(blocks)))
    return groups


def section_explanation() -> Paragraph:
    """Explanation of the sections."""
    return Paragraph(gettext(SECTION_TEXT, thickness=SECTION_THICKNESS_M))


def section_picture(section: PlaneSection) -> UndrawnPictures:
    """Section across a validation plane."""
    from lispac.report.plane_sections import section_figure_of

    caption = gettext(
        "{plane}: section across the middle of the plane, before and after the calibration.",
        plane=section.plane,
    )
    return UndrawnPictures(caption, section_figure_of, (section,))


def _profile_caption(by_height: bool, by_range: bool) -> str:
    if not by_range:
        return N_("{plane}: median and 95th percentile of the distances by height.")
    if not by_height:
        return N_("{plane}: median and 95th percentile of the distances by range.")
    return N_("{plane}: median and 95th percentile of the distances by height and by range.")


def _signed_tables(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Tables of signed distances, and of offsets and rotations, of all pairs of lines."""
    rows = pair_rows(planes)
    blocks: list[Block] = []
    if any(row.pair.after.signed is not None for row in rows):
        blocks += [Paragraph(gettext(SIGNED_DISTANCES_TEXT)), report_table(PAIR_PLACES_TABLE, rows)]
    if any(row.pair.after.planes is not None for row in rows):
        blocks += [Paragraph(gettext(PLANE_OFFSETS_TEXT)), report_table(PAIR_PLANES_TABLE, rows)]
    return blocks


def _not_compared_text(plane: ValidationPlane) -> str:
    pairs = ", ".join(f"{a} / {b}" for a, b in plane.not_compared)
    return gettext("{plane}: {pairs}", plane=plane.name, pairs=pairs)


def standards_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the uncertainty by IHO S-44 and the swath overlap difference."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += [
            Paragraph(gettext(S44_TEXT)),
            report_table(S44_TABLE, content.adjustment.s44),
        ]
    if content.swath_overlap:
        table = swath_overlap_table(len(content.swath_overlap) - 1)
        blocks += [
            Paragraph(gettext(OVERLAP_TEXT)),
            report_table(table, content.swath_overlap),
        ]
    return blocks


def absolute_check_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the check against a static scan or surveyed points."""
    from lispac.report.absolute_figure import reference_distance_figure

    found = content.absolute
    if found is None:
        return []
    blocks: list[Block] = [
        Paragraph(_reference_text(found)),
        Paragraph(
            gettext(REFERENCE_DISTANCES_TEXT, reach=shortest_number(found.search_distance_m))
        ),
        report_table(REFERENCE_DISTANCES_TABLE, line_states(found)),
        Bullets(tuple(map(sentence_text, found.messages))),
    ]
    caption = gettext(
        "Distances of all lines from the reference, before and after the calibration."
    )
    blocks += [
        UndrawnPictures(caption, reference_distance_figure, (found,)),
        Paragraph(gettext(UNCERTAINTY_TEXT)),
        report_table(MEAN_UNCERTAINTY_TABLE, lines_and_all(found)),
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
