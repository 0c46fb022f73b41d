"""The short report: result, validation, signatures, system and pictures on a few pages.

All errors and warnings are complete. The signatures are on the page of the angles and the verdict.
Of a large survey, the validation planes that fail or have the largest RMS and the first notes are
shown, with a sentence on what is omitted.
"""

from collections.abc import Sequence
from functools import partial

from lispac.acceptance import planes_to_show
from lispac.language import gettext
from lispac.present.calibration.adjustment import AdjustmentValues
from lispac.present.calibration.adjustment_fit import chi_square_facts
from lispac.present.calibration.cross_checks import agreement_text
from lispac.present.calibration.methods import method_facts
from lispac.present.calibration.sigmas import sigma_facts
from lispac.present.checking.validation import ValidationPlane
from lispac.present.survey.survey_data import planes_table
from lispac.present.tables import Fact
from lispac.present.targets.targets import TARGETS_TABLE
from lispac.present.text_format import fixed_number
from lispac.report import sections
from lispac.report.boresight_section import angle_tables, convention_paragraph, rule_tables
from lispac.report.checks_section import control_comparison
from lispac.report.document_blocks import (
    Block,
    Group,
    Paragraph,
    Picture,
    PictureRow,
    Section,
    UndrawnPictures,
    facts_table,
    report_table,
)
from lispac.report.report_values import ReportContent
from lispac.report.validation_section import (
    MAP_LEGEND_TEXT,
    section_explanation,
    section_picture,
)

MAX_PLANES = 12
"""Largest number of validation planes in the table."""
MAX_PICTURED_PLANES = 3
"""Largest number of validation planes with pictures, sections and maps."""
MAX_PLANES_BESIDE_SECTIONS = 8
"""Largest number of validation planes in the table with which there is space for all sections."""
MAX_LISTED_LINES = 12
"""Largest number of lines that are listed by name."""
MAX_NOTES = 8
"""Largest number of notes."""
MAX_MAP_HEIGHT_MM, MAX_PLAN_HEIGHT_MM, MAX_SECTION_HEIGHT_MM = 62.0, 60.0, 42.0
PLAN_SIZE_INCHES = 3.2, 2.35
"""Width and height of the site plan, half as wide as the page."""
MAX_HISTOGRAM_HEIGHT_MM = 42.0
MAX_OVERVIEW_HEIGHT_MM, MAX_SMALL_PICTURE_HEIGHT_MM = 52.0, 38.0
"""Largest heights on the page, millimetres; an overview and three planes fit on a letter page."""


def shortened_notes(notes: Sequence[str]) -> tuple[str, ...]:
    """The first notes, and a sentence with the number of the others."""
    if len(notes) <= MAX_NOTES:
        return tuple(notes)
    kept = notes[: MAX_NOTES - 1]
    omitted = gettext(
        "{count:n} more notes are in the full report only.", count=len(notes) - len(kept)
    )
    return (*kept, omitted)


def summary_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the angles, the validation and the acceptance."""
    # Angles need their signs beside them: those of the other program, or those of the body frame.
    angles: list[Block] = (
        [convention_paragraph(content)]
        if content.in_convention is None
        else angle_tables(content.in_convention)
    )
    return [
        *sections.angle_blocks(content),
        *angles,
        *_validation(content, _planes_to_show(content, MAX_PLANES)),
    ]


def short_sections(content: ReportContent, pictures: Sequence[Picture]) -> list[Section]:
    """The sections after the signatures.

    Parameters
    ----------
    pictures : views before and after, alternately; those of the whole survey are first
    """
    rules: list[Block] = []
    if content.in_convention is not None:
        rules = [*rule_tables(content.in_convention), convention_paragraph(content)]
    remainder = gettext(
        "The full report also contains residuals, all cross-checks, all settings and the input "
        "files."
    )
    system = (
        sections.measuring_system_table(content),
        *rules,
        Paragraph(remainder),
    )
    adjustment = content.adjustment
    used = () if adjustment is None else tuple(_fit_blocks(content, adjustment))
    return [
        Section(gettext("Targets, lines and fit"), used),
        Section(gettext("System and conventions"), system),
        Section(gettext("Pictures"), tuple(_figures(content, pictures))),
    ]


def _fit_blocks(content: ReportContent, adjustment: AdjustmentValues) -> list[Block]:
    """Tables of the targets used, and of the fit with the standard deviations used."""
    facts = [Fact(gettext("Lines used"), _lines_text(content, adjustment))]
    facts += chi_square_facts(adjustment)
    if content.cross_checks is not None:
        facts.append(Fact(gettext("Cross-checks"), agreement_text(content.cross_checks)))
    facts += method_facts(content.methods)
    used = content.settings
    facts += sigma_facts(used.standard_deviations, used.lever_arm_sigma_m, adjustment.sightings)
    table = TARGETS_TABLE
    for title in ("Shape", "Noise\nfactor", "Largest w\nof a sighting", "Finding"):
        table = table.without(title)
    surfaces = planes_table(len(content.lines)).without("Threshold")
    validated = {plane.name for plane in content.validation}
    omitted = validated - {plane.name for plane in _planes_to_show(content, MAX_PLANES)}
    planes = [plane for plane in content.planes if plane.name not in omitted]
    return [
        *control_comparison(content),
        *sections.surface_blocks(surfaces, planes),
        report_table(table, adjustment.targets),
        facts_table(gettext("Fit and standard deviations used"), facts),
    ]


def _lines_text(content: ReportContent, adjustment: AdjustmentValues) -> str:
    """Names of the lines used with their headings, or the number of many lines."""
    used = {sighting.line for sighting in adjustment.sightings}
    lines = [line for line in content.lines if line.name in used]
    if len(lines) > MAX_LISTED_LINES:
        return gettext("{count:n} of {total:n}", count=len(lines), total=len(content.lines))
    return ", ".join(
        line.name
        if line.heading_deg is None
        else gettext(
            "{line} (heading {heading}°)",
            line=line.name, heading=fixed_number(line.heading_deg % 360, 0),
        )
        for line in lines
    )  # fmt: skip


def _validation(content: ReportContent, planes: Sequence[ValidationPlane]) -> list[Block]:
    blocks = sections.validation_summary(content, planes)
    if len(planes) < len(content.validation):
        omitted = gettext(
            "{shown:n} of {total:n} planes are shown: first those that fail, then those with the "
            "largest RMS after the calibration. The full report contains all.",
            shown=len(planes), total=len(content.validation),
        )  # fmt: skip
        blocks.insert(1, Paragraph(omitted))
    return blocks


def _planes_to_show(content: ReportContent, count: int) -> list[ValidationPlane]:
    """Up to ``count`` validation planes in their order; see `planes_to_show`."""
    failed = {each.plane for each in content.acceptance.planes if each.verdict == "fail"}
    names = planes_to_show({p.name: p.after.rms_m for p in content.validation}, failed, count)
    return [plane for plane in content.validation if plane.name in names]


def _figures(content: ReportContent, pictures: Sequence[Picture]) -> list[Block]:
    """Views of the whole survey or the site plan, then the validation planes before and after."""
    whole, small = tuple(pictures[:2]), pictures[2 : 2 + 2 * MAX_PICTURED_PLANES]
    planes = _planes_to_show(content, MAX_PICTURED_PLANES)
    histograms = _histograms(planes, is_narrow=not whole)
    beside = [_histogram(plane) for plane in planes] if len(small) == 2 * len(planes) else []
    blocks: list[Block] = []
    if whole:
        legend = sections.line_colours_paragraph(content)
        blocks += [legend, _overview(whole, is_alone=not small)]
    if not whole and (row := (*_site_plan(content), *histograms)):
        blocks.append(PictureRow(row, columns=2, tallest=MAX_PLAN_HEIGHT_MM))
    mapped = [plane for plane in content.validation if plane.maps]
    shown = [plane for plane in planes if plane.maps]
    are_same = len(small) == 2 * len(shown) and len(mapped) == len(content.validation)
    if small and len(small) < 2 * len(content.validation):
        pictured = (
            gettext(
                "Pictures and maps of {shown:n} of {total:n} validation planes are shown: first "
                "those that fail, then those with the largest RMS after the calibration. The full "
                "report contains all maps.",
                shown=len(shown), total=len(mapped),
            )
            if are_same
            else gettext(
                "Pictures of {shown:n} of {total:n} validation planes are shown: first those that "
                "fail, then those with the largest RMS after the calibration.",
                shown=len(small) // 2, total=len(content.validation),
            )
        )  # fmt: skip
        blocks.append(Paragraph(pictured))
    rows = [
        PictureRow(
            (*small[k : k + 2], *beside[k // 2 : k // 2 + 1]),
            columns=3 if beside else 2,
            tallest=MAX_SMALL_PICTURE_HEIGHT_MM,
        )
        for k in range(0, len(small), 2)
    ]
    if not beside:
        blocks += rows
    if whole and histograms and not beside:
        blocks.append(PictureRow(tuple(histograms), tallest=MAX_HISTOGRAM_HEIGHT_MM))
    sections_across = _sections(content, _section_count(content, has_views=bool(small)))
    if sections_across:
        blocks.append(section_explanation())
    if shown:
        explained = gettext(MAP_LEGEND_TEXT)
        if len(shown) < len(mapped) and not are_same:
            omitted = gettext(
                "Maps of {shown:n} of {total:n} validation planes are shown: first those that "
                "fail, then those with the largest RMS after the calibration. The full report "
                "contains all.",
                shown=len(shown), total=len(mapped),
            )  # fmt: skip
            explained = f"{explained} {omitted}"
        blocks.append(Paragraph(explained))
    figures = [
        {plane.name: row for plane, row in zip(planes, rows, strict=True)} if beside else {},
        sections_across,
        {plane.name: PictureRow((_map(plane),), tallest=MAX_MAP_HEIGHT_MM) for plane in shown},
    ]
    for plane in planes:
        own = tuple(each[plane.name] for each in figures if plane.name in each)
        if own:
            blocks.append(Group(own))
    return blocks


def _overview(pictures: tuple[Picture, ...], *, is_alone: bool) -> PictureRow:
    """Views of the whole survey, lower if pictures of planes follow."""
    if is_alone:
        return PictureRow(pictures)
    return PictureRow(pictures, tallest=MAX_OVERVIEW_HEIGHT_MM)


def _site_plan(content: ReportContent) -> list[UndrawnPictures]:
    from lispac.report.figures import site_figure_of

    if not any(line.track_local_m for line in content.lines) and not content.planes:
        return []
    return [
        UndrawnPictures(
            gettext(sections.SITE_PLAN_CAPTION),
            partial(site_figure_of, size=PLAN_SIZE_INCHES),
            (content.lines, content.planes),
        )
    ]


def _histograms(planes: Sequence[ValidationPlane], *, is_narrow: bool) -> list[UndrawnPictures]:
    from lispac.report.histograms import small_histograms_figure_of

    if not planes:
        return []
    caption = gettext("Distances between lines; the last bin includes larger values.")
    draw = partial(small_histograms_figure_of, is_narrow=is_narrow)
    return [UndrawnPictures(caption, draw, (tuple(planes),))]


def _histogram(plane: ValidationPlane) -> UndrawnPictures:
    """Histogram of one plane, beside its pictures before and after."""
    from lispac.report.histograms import small_histograms_figure_of

    caption = gettext(
        "{plane}: distances between lines before and after the calibration.", plane=plane.name
    )
    draw = partial(small_histograms_figure_of, is_narrow=True)
    return UndrawnPictures(caption, draw, ((plane,),))


def _section_count(content: ReportContent, *, has_views: bool) -> int:
    """Number of sections for which there is space, beside views and a table of many planes."""
    has_space = len(content.validation) <= MAX_PLANES_BESIDE_SECTIONS
    if has_views:
        return 1 if has_space else 0
    return MAX_PICTURED_PLANES if has_space else 1


def _sections(content: ReportContent, count: int) -> dict[str, PictureRow]:
    """Sections across up to ``count`` planes that fail or have the largest RMS, by their names."""
    shown = {plane.name for plane in _planes_to_show(content, count)}
    return {
        each.plane: PictureRow((section_picture(each),), tallest=MAX_SECTION_HEIGHT_MM)
        for each in content.plane_sections
        if each.plane in shown
    }


def _map(plane: ValidationPlane) -> UndrawnPictures:
    from lispac.report.distance_maps import MAX_MAPS_IN_ROW, map_caption, map_row_figure_of

    return UndrawnPictures(map_caption(plane, MAX_MAPS_IN_ROW), map_row_figure_of, (plane,))
