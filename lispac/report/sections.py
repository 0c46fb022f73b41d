"""The first page, and the sections on targets, residuals, quality, site, lines and settings.

Boresight angles have four decimals in degrees, residuals one decimal in millimetres.
"""

from collections.abc import Sequence
from math import degrees

from lispac.geometry.planes import LEVEL_LIMIT_RAD
from lispac.identity import FIELD_LABELS, FIELD_NAMES, SIGNATURE_FIELDS, TITLE_FIELDS
from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.calibration.adjustment import (
    MIN_REPORTED_NOISE_FACTOR,
    AdjustmentValues,
    boresight_table,
)
from lispac.present.calibration.adjustment_fit import points_used_text
from lispac.present.calibration.parameters import VARIANCE_COMPONENTS_TABLE, ParameterValues
from lispac.present.calibration.settings import model_facts, system_facts
from lispac.present.checking.acceptance import AcceptanceValues, criteria_table, criterion_results
from lispac.present.checking.validation import (
    ValidationPlane,
    judged_distances_table,
)
from lispac.present.line_colours import LINE_COLOURS
from lispac.present.survey.survey_data import (
    FILES_TABLE,
    LINES_TABLE,
    TRAJECTORY_TABLE,
    PickedPlane,
    planes_table,
)
from lispac.present.tables import Fact
from lispac.present.tables import Table as ResultTable
from lispac.present.targets.sighting_quality import QUALITY_TABLE
from lispac.present.targets.sightings import SIGHTING_FIT_TABLE
from lispac.present.targets.targets import TARGETS_TABLE, target_finding
from lispac.present.text_format import (
    fixed_number,
    parameter_name,
    quantity_text,
    sentence_text,
)
from lispac.report.boresight_section import angle_tables
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    SignatureLines,
    Table,
    UndrawnPictures,
    facts_table,
    form_table,
    report_table,
)
from lispac.report.report_values import ReportContent
from lispac.report.section_summaries import quality_summary, residuals_summary
from lispac.report.validation_section import reciprocal_pairs_note

SYSTEM_FIELDS = (
    "scanner", "scanner_serial", "pos", "pos_serial", "lever_arm_origin", "processing_software",
)  # fmt: skip
"""Fields of the equipment, which the short report gives with the lever arm."""
COMMON_SURFACE_TEXT = N_(
    "RMS and mean are distances from the common surface of all lines; a mean is positive if the "
    "line is nearer to the vessel. After the adjustment they "
    "still contain the POS error of each sighting, which the boresight cannot correct."
)
NOISE_FACTOR_TEXT = N_(
    "Noise factor: LiDAR noise of a target, estimated from the residuals without POS errors, "
    "divided by the LiDAR noise of all targets, which is given or a variance component. If it is "
    "above 1, the sigmas of the angles are computed with the noise of the target. Notes and "
    "settings name targets with a factor of {limit} or more."
)
LARGEST_W_TEXT = N_(
    "Largest w: largest shift of a sighting divided by its sigma; see the section on reliability."
)
TRAJECTORY_COLUMNS_TEXT = N_(
    "Roll and pitch: motion of the vessel (standard deviation). The last four columns give the "
    "largest 1 sigma of the POS on the line; horizontal: north and east together."
)
COLUMNS_TEXT = N_(
    "Points: all points of the sighting, before averaging or thinning. RMS: distance of the points "
    "from the surface fitted to this sighting alone. Incidence: angle between the beams and the "
    "normal of the surface. Coverage: share of the cells within the outline of the sighting that "
    "contain points; on a sphere, share of the surface."
)
EXTENT_TEXT = N_(
    "Extent observed: size of the sighting, in percent of the size observed on all other lines "
    "together. A dash means that it cannot be compared, for instance because the search radius "
    "cuts the surface."
)
FOUND_AGAIN_TEXT = N_(
    "The points of targets are found again with the estimated boresight; their number can differ "
    "slightly from that of the pick."
)
BEFORE_CALIBRATION_TEXT = N_(
    "Before the calibration, the boresight error distorts the points measured from a moving "
    "vessel. Therefore only the part of RMS, curvature and flatness that this error does not "
    "explain is assessed."
)
SITE_PLAN_CAPTION = N_(
    "Site plan in the local frame. Arrows show the direction of the lines; the name of a line is "
    "at its start."
)
GEOMETRY_TEXT = N_(
    "Position: middle of the points. Width is horizontal and height up the slope; of a horizontal "
    "surface, they are east and north. The normal points towards the vessel; its azimuth is given "
    "for inclinations above {limit}° (90° is vertical)."
)
SURFACE_SIGMA_TEXT = N_(
    "Form error of the targets: standard deviation of the offset of a whole sighting from the "
    "common surface of all lines. Roughness and curvature that are the same on all lines are not "
    "part of it; they increase the noise of the target."
)
VARIANCE_COMPONENTS_TEXT = N_(
    "Variance components are estimated from the residuals and the estimated POS errors by "
    "restricted maximum likelihood. A sigma is increased if the data show a larger one, and "
    "decreased only if the whole interval is below the given value; otherwise the given value is "
    "used. Few sightings give little information on the POS: if the interval is wide, the given "
    "sigma may be as reliable as the estimated one."
)


def summary_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the results, for the first page."""
    converted = content.in_convention
    return [
        *angle_blocks(content),
        *([] if converted is None else angle_tables(converted)),
        *validation_summary(content, content.validation),
    ]


def angle_blocks(content: ReportContent) -> list[Block]:
    """Table of the angles, and what was estimated with them."""
    blocks: list[Block] = [
        report_table(
            boresight_table(calibrated=content.calibrated, simulated=content.simulated),
            content.angles,
        )
    ]
    adjustment = content.adjustment
    if adjustment is not None:
        if rotation := str(adjustment.rotation_text):
            blocks.append(Paragraph(rotation))
        blocks.append(Paragraph(_fit_text(adjustment)))
        extra = [_value_with_sigma(p) for p in adjustment.parameters if p.value is not None]
        if extra:
            blocks.append(
                Paragraph(
                    gettext(
                        "Estimated together with the boresight: {values:names}. The boresight is "
                        "valid with these values only.",
                        values=extra,
                    )
                )
            )
    return blocks


def validation_summary(content: ReportContent, planes: Sequence[ValidationPlane]) -> list[Block]:
    """Blocks on the distances on ``planes``, the acceptance, and the check against a reference."""
    blocks: list[Block] = []
    if planes:
        distances = report_table(judged_distances_table(content.acceptance), planes)
        blocks.append(distances)
        if distances.marked:
            blocks.append(Paragraph(gettext("* Beyond the limit of its acceptance criterion.")))
        blocks += reciprocal_pairs_note(planes)
    if content.calibrated:
        blocks.append(_acceptance_block(content.acceptance))
    against = content.absolute
    if against is not None and not against.all_lines.after.mean_significant:
        finding = sentence_text(against.messages[0])
        checked = gettext(
            "Checked against {reference}: {finding}", reference=against.reference, finding=finding
        )
        blocks.append(Paragraph(checked))
    return blocks


def _acceptance_block(acceptance: AcceptanceValues) -> Block:
    """Table of the acceptance criteria, or why it is missing."""
    if not acceptance.checks:
        return Paragraph(gettext("Acceptance not judged: no acceptance criteria are given."))
    return report_table(criteria_table(acceptance.criteria.source), criterion_results(acceptance))


def _fit_text(adjustment: AdjustmentValues) -> str:
    return gettext(
        "Targets: {targets:n}; their sightings (a target on one line): {sightings:n}, on {lines:n} "
        "lines. Points used: "
        "{points}. RMS distance of these points from the surfaces of the targets: "
        "{before:mm.1}\u00a0mm before, {after:mm.1}\u00a0mm after.",
        points=points_used_text(adjustment), before=adjustment.rms_before_m,
        after=adjustment.rms_after_m, targets=len(adjustment.targets),
        sightings=len(adjustment.sightings), lines=len({s.line for s in adjustment.sightings}),
    )  # fmt: skip


def _value_with_sigma(parameter: ParameterValues) -> str:
    assert parameter.value is not None
    assert parameter.sigma is not None
    return gettext(
        "{name} {value} (1\u00a0sigma {sigma})",
        name=parameter_name(parameter.name),
        value=quantity_text(parameter.name, parameter.value, sign=True),
        sigma=quantity_text(parameter.name, parameter.sigma),
    )


def residual_blocks(content: ReportContent) -> list[Block]:
    """Blocks on targets, validation planes and residuals."""
    blocks: list[Block] = []
    if content.adjustment is not None:
        blocks += residuals_summary(content.adjustment)
    blocks += surface_blocks(planes_table(len(content.lines)), content.planes)
    if content.adjustment is not None:
        blocks += _fit_tables(content.adjustment, content.settings.pos_errors == "correlated")
    return blocks or [Paragraph(gettext("No target has been picked yet."))]


def surface_blocks(table: ResultTable[PickedPlane], planes: Sequence[PickedPlane]) -> list[Block]:
    """Table of the targets and validation planes, and its explanation; none without any."""
    if not planes:
        return []
    if all(plane.shape == "plane" for plane in planes):
        table = table.without("Shape")
    return [Paragraph(_geometry_text()), report_table(table, planes)]


def _geometry_text() -> str:
    return gettext(GEOMETRY_TEXT, limit=fixed_number(degrees(LEVEL_LIMIT_RAD), 0))


def _fit_tables(adjustment: AdjustmentValues, correlated: bool) -> list[Block]:
    from lispac.report.figures import residual_figures_of

    are_planes = all(target.shape == "plane" for target in adjustment.targets)
    table = TARGETS_TABLE.without("Shape") if are_planes else TARGETS_TABLE
    if not any(map(target_finding, adjustment.targets)):
        table = table.without("Finding")
    targets = report_table(table, adjustment.targets)
    sightings = report_table(SIGHTING_FIT_TABLE, adjustment.sightings)
    bars = UndrawnPictures(
        gettext(
            "RMS distance of each sighting from the surface of its target before and after the "
            "calibration. Each panel has its own scale."
        ),
        residual_figures_of,
        (adjustment.sightings,),
    )
    columns: list[Block] = []
    if correlated:
        limit = fixed_number(MIN_REPORTED_NOISE_FACTOR, 2)
        noise_factor = gettext(NOISE_FACTOR_TEXT, limit=limit)
        columns = [Paragraph(noise_factor), Paragraph(gettext(LARGEST_W_TEXT))]
    return [*columns, targets, Paragraph(gettext(COMMON_SURFACE_TEXT)), sightings, bars]


def site_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the site plan, the lines, and the trajectory of each line."""
    from lispac.report.figures import site_figure_of

    blocks: list[Block] = [report_table(LINES_TABLE, content.lines)]
    if content.trajectory:
        blocks += [
            Paragraph(gettext(TRAJECTORY_COLUMNS_TEXT)),
            report_table(TRAJECTORY_TABLE, content.trajectory),
        ]
    # The plan is last: it is high, and tables fill the page before it.
    if any(line.track_local_m for line in content.lines) or content.planes:
        values = (content.lines, content.planes)
        blocks.append(UndrawnPictures(gettext(SITE_PLAN_CAPTION), site_figure_of, values))
    return blocks


def line_colours_paragraph(content: ReportContent) -> Paragraph:
    """Colours of the lines in the views."""
    colours = (LINE_COLOURS[k % len(LINE_COLOURS)] for k in range(len(content.lines)))
    return Paragraph(
        gettext("Colours of the lines in the views:"),
        tuple(
            (line.name, "#{:02x}{:02x}{:02x}".format(*colour))
            for line, colour in zip(content.lines, colours, strict=True)
        ),
    )


def identity_table(content: ReportContent) -> Table:
    """All details of the survey, as a form."""
    return _details_form(content, FIELD_NAMES)


def identity_form(content: ReportContent, letterhead: str, *, blank: bool) -> Table:
    """Details of the survey that are not elsewhere in the report, as a form.

    The others are in the letterhead, below the title, beside the signatures, or in
    `measuring_system_table`.

    Parameters
    ----------
    letterhead : text of the letterhead
    blank : whether to print empty fields, as lines to fill in by hand, and all those of the
        equipment; the short report has neither
    """
    known = content.identity
    elsewhere = {*SIGNATURE_FIELDS} if blank else {*SIGNATURE_FIELDS, *SYSTEM_FIELDS}
    elsewhere |= {name for name in TITLE_FIELDS if getattr(known, name)}
    if letterhead and (not known.company or known.company in letterhead.splitlines()):
        elsewhere.add("company")
    return _details_form(
        content,
        [name for name in FIELD_NAMES if name not in elsewhere and (blank or getattr(known, name))],
    )


def _details_form(content: ReportContent, names: Sequence[str]) -> Table:
    return form_table(
        gettext("Details of the survey"),
        [Fact(gettext(FIELD_LABELS[name]), getattr(content.identity, name)) for name in names],
    )


def measuring_system_table(content: ReportContent) -> Table:
    """Scanner, INS/GNSS, lever arm and point spacing, for the short report."""
    known = content.identity
    facts = [
        Fact(gettext(FIELD_LABELS[name]), _instrument_text(*instrument))
        for name, instrument in (
            ("scanner", (known.scanner, known.scanner_serial)),
            ("pos", (known.pos, known.pos_serial)),
        )
    ]
    lever_arm, *others = system_facts(content.settings, content.adjustment)
    facts += [
        lever_arm,
        *_given_details(content, "lever_arm_origin"),
        *others,
        *_given_details(content, "processing_software"),
    ]
    return facts_table(gettext("Measuring system and processing"), facts)


def _given_details(content: ReportContent, name: str) -> list[Fact]:
    """One of the details of the survey; none if it is empty."""
    text = getattr(content.identity, name)
    return [Fact(gettext(FIELD_LABELS[name]), text)] if text else []


def _instrument_text(model: str, serial: str) -> str:
    if not serial:
        return model or gettext("not given")
    if not model:
        return gettext("serial number {serial}", serial=serial)
    return gettext("{model}, serial number {serial}", model=model, serial=serial)


def signature_lines(content: ReportContent) -> SignatureLines:
    """Lines for name, place and date, and signature of each person, with the known names."""
    fields: list[str] = []
    values: list[str] = []
    for name in SIGNATURE_FIELDS:
        fields += [
            gettext(FIELD_LABELS[name]), gettext("Place and date"), gettext("Signature"),
        ]  # fmt: skip
        values += [getattr(content.identity, name), "", ""]
    return SignatureLines(tuple(fields), tuple(values))


def quality_blocks(content: ReportContent) -> list[Block]:
    """Table of all sightings with statistics and rating, and explanations; none without ratings."""
    if not content.qualities:
        return []
    explained = [COLUMNS_TEXT]
    if any(each.visible_share is not None for each in content.qualities):
        explained.append(EXTENT_TEXT)
    if not content.calibrated:
        explained.append(BEFORE_CALIBRATION_TEXT)
    else:
        explained.append(FOUND_AGAIN_TEXT)
    return [
        *quality_summary(content),
        *(Paragraph(gettext(each)) for each in explained),
        report_table(QUALITY_TABLE, content.qualities),
    ]


def settings_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the settings of system, points and stochastic model, and on the input files."""
    used, adjustment = content.settings, content.adjustment
    blocks: list[Block] = [
        facts_table(gettext("System and points"), system_facts(used, adjustment)),
        facts_table(gettext("Stochastic model"), model_facts(used, adjustment)),
    ]
    if used.surface_from_data is not None:
        blocks.append(Paragraph(gettext(SURFACE_SIGMA_TEXT)))
    if adjustment is not None and adjustment.components:
        blocks += [
            Paragraph(gettext(VARIANCE_COMPONENTS_TEXT)),
            report_table(VARIANCE_COMPONENTS_TABLE, adjustment.components),
        ]
    blocks.append(report_table(FILES_TABLE, content.files))
    if content.notes:
        blocks += [
            Paragraph(gettext("Input assumptions:")),
            Bullets(tuple(map(message_text, content.notes))),
        ]
    return blocks
