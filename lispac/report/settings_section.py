"""The section on settings: system, points, stochastic model and input files."""

from collections.abc import Mapping

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.present.adjustment import AdjustmentValues
from lispac.present.parameters import VARIANCE_COMPONENTS_TABLE
from lispac.present.survey_data import FILES_TABLE
from lispac.present.text_format import (
    fixed_number,
    millimetres,
    origin_text,
    parameter_name,
    quantity_text,
    shortest_number,
    triple_text,
)
from lispac.report.document_blocks import (
    Block,
    Bullets,
    Paragraph,
    facts_table,
    report_table,
)
from lispac.report.report_values import ReportContent, SettingsUsed

MIN_REPORTED_NOISE_FACTOR = 1.05
"""Smallest noise factor of a target (estimated divided by given LiDAR noise) that is reported."""

POS_ERROR_TEXTS: Mapping[str, str] = {
    "correlated": N_("Correlated in time."),
    "independent": N_("Uncorrelated."),
}
LOSS_TEXTS: Mapping[str, str] = {
    "none": N_("No robust estimation."),
    "huber": N_("Loss function: Huber."),
    "tukey": N_("Loss function: Tukey."),
}
OFFSET_TITLES: Mapping[str, str] = {
    "range_offset": N_("Given range offset"),
    "scan_angle_offset": N_("Given scan-angle offset"),
    "latency": N_("Given latency"),
}
"""Titles of the offsets, by the name of the value."""

CORRELATION_TIMES_TEXT = N_(
    "{position} s and {attitude} s: time over which a POS error persists. Use the values of the "
    "processing report if it gives them. Too short a time is safer than too long a time."
)
SURFACE_SIGMA_TEXT = N_(
    "Form error of the targets: standard deviation of the offset of a whole sighting from the "
    "common surface of all lines."
)
VARIANCE_COMPONENTS_TEXT = N_(
    "Variance components are estimated from the residuals and the estimated POS errors by "
    "restricted maximum likelihood. A sigma is increased if the data show a larger one, and "
    "decreased only if the whole interval is below the given value; otherwise the given value is "
    "used. Few sightings give little information on the POS: if the interval is wide, the given "
    "sigma may be as reliable as the estimated one."
)


def settings_blocks(content: ReportContent) -> list[Block]:
    """Blocks on the settings of system, points and stochastic model, and on the input files."""
    used, adjustment = content.settings, content.adjustment
    blocks: list[Block] = [
        facts_table(gettext("System and points"), _system_rows(used, adjustment)),
        facts_table(gettext("Stochastic model"), _model_rows(used, adjustment)),
    ]
    if used.surface_from_data is not None:
        blocks.append(Paragraph(gettext(SURFACE_SIGMA_TEXT)))
    if adjustment is not None and adjustment.components:
        blocks += _component_tables(adjustment)
    blocks.append(report_table(FILES_TABLE, content.files))
    if content.notes:
        blocks += [
            Paragraph(gettext("Input assumptions:")),
            Bullets(tuple(map(message_text, content.notes))),
        ]
    return blocks


def _system_rows(used: SettingsUsed, adjustment: AdjustmentValues | None) -> list[tuple[str, str]]:
    names = [p.name for p in adjustment.parameters] if adjustment else []
    lever_arm = gettext("{values} m", values=triple_text(used.lever_arm_m, 4))
    if any(name.startswith("lever") for name in names):
        values = [(gettext("Prior lever arm (forward, left, up)"), lever_arm)]
    else:
        values = [(gettext("Lever arm (forward, left, up)"), lever_arm)]
    values.append((gettext("Origin of the local frame"), origin_text(used.origin_deg_m)))
    for name, value in (
        ("range_offset", used.range_offset_m),
        ("scan_angle_offset", used.scan_angle_offset_deg),
        ("latency", used.latency_s),
    ):
        if value:
            values.append((gettext(OFFSET_TITLES[name]), quantity_text(name, value, sign=True)))
    if names:
        estimated = [gettext("boresight"), *map(parameter_name, names)]
        values.append(
            (
                gettext("Parameters selected for estimation"),
                gettext("{names:names}", names=estimated),
            )
        )
    if used.accept_single_orientation:
        values.append((gettext("Targets of a single orientation"), gettext("accepted")))
    return [*values, (gettext("Point spacing"), _subsampling_text(used))]


def _subsampling_text(used: SettingsUsed) -> str:
    if not used.subsample_m:
        return gettext("none: all points are used")
    spacing = fixed_number(used.subsample_m, 3)
    if used.averaged:
        return gettext(
            "averaged: the points of a plane within a square of {spacing} m are replaced by their "
            "mean; points of spheres are not averaged",
            spacing=spacing,
        )
    return gettext(
        "thinned: where points are closer than {spacing} m to each other, one is kept",
        spacing=spacing,
    )


def _model_rows(used: SettingsUsed, adjustment: AdjustmentValues | None) -> list[tuple[str, str]]:
    from_file = gettext("from the trajectory accuracy file")
    values = [
        (
            gettext("POS errors"),
            f"{gettext(POS_ERROR_TEXTS[used.pos_errors])} {gettext(used.pos_errors_text)}",
        ),
        (
            gettext("Position sigma (north, east, down)"),
            gettext("{values} m", values=triple_text(used.position_sigma_m, 3))
            if used.position_sigma_m
            else from_file,
        ),
        (
            gettext("Attitude sigma (roll, pitch, heading)"),
            gettext("{values} deg", values=triple_text(used.attitude_sigma_deg, 4))
            if used.attitude_sigma_deg
            else from_file,
        ),
    ]
    if used.position_correlation_time_s and used.attitude_correlation_time_s:
        times = gettext(
            CORRELATION_TIMES_TEXT,
            position=shortest_number(used.position_correlation_time_s),
            attitude=shortest_number(used.attitude_correlation_time_s),
        )
        values.append((gettext("Correlation times (position, attitude)"), times))
    values.append((gettext("LiDAR noise, 1 sigma"), _lidar_noise_text(used)))
    if adjustment is not None and used.pos_errors == "correlated":
        values.append((gettext("Estimated LiDAR noise"), _noise_factor_text(adjustment)))
    if used.surface_from_data is not None:
        values.append((gettext("Form error of the targets (1 sigma)"), _surface_sigma_text(used)))
    loss = f"{gettext(LOSS_TEXTS[used.loss])} {gettext(used.loss_text)}"
    return [*values, (gettext("Outliers"), loss)]


def _lidar_noise_text(used: SettingsUsed) -> str:
    if used.lidar_range_sigma_m is not None and used.lidar_angle_sigma_deg is not None:
        return gettext(
            "range {range:mm.1} mm, beam direction {angle} deg",
            range=used.lidar_range_sigma_m, angle=fixed_number(used.lidar_angle_sigma_deg, 4),
        )  # fmt: skip
    if used.lidar_sigma_xyz_m is not None:
        x, y, z = used.lidar_sigma_xyz_m
        return gettext("x {x:mm.1} mm, y {y:mm.1} mm, z {z:mm.1} mm", x=x, y=y, z=z)
    return gettext("{sigma:mm.1} mm on each axis", sigma=used.lidar_sigma_m)


def _noise_factor_text(adjustment: AdjustmentValues) -> str:
    larger = [t for t in adjustment.targets if (t.noise_factor or 1.0) >= MIN_REPORTED_NOISE_FACTOR]
    applied = any(c.applied and c.name == "LiDAR" for c in adjustment.components)
    if not larger:
        if applied:
            return gettext("not larger than the sigma from the variance components on any target")
        return gettext("not larger than the given noise on any target")
    found = [
        gettext(
            "{target}: {factor}\u00a0times",
            factor=fixed_number(t.noise_factor or 1.0, 1),
            target=t.target,
        )
        for t in larger
    ]
    if applied:
        return gettext(
            "{factors:names} the sigma from the variance components; the sigmas of the angles are "
            "computed with this noise",
            factors=found,
        )
    return gettext(
        "{factors:names} the given noise; the sigmas of the angles are computed with this noise",
        factors=found,
    )


def _surface_sigma_text(used: SettingsUsed) -> str:
    if used.surface_sigma_m is None:
        return gettext("to be estimated from the data")
    if used.surface_sigma_m == 0:
        return gettext("zero: all sightings of a target lie on the same surface")
    if used.offset_sigma_m is None:
        sigmas = gettext("{surface}\u00a0mm", surface=_tenths_of_millimetre(used.surface_sigma_m))
    else:
        sigmas = gettext(
            "offsets {offset}\u00a0mm, tilts {surface}\u00a0mm",
            offset=_tenths_of_millimetre(used.offset_sigma_m),
            surface=_tenths_of_millimetre(used.surface_sigma_m),
        )
    if used.surface_from_data:
        return gettext("{sigmas}, estimated from the data", sigmas=sigmas)
    return gettext("{sigmas}, as given", sigmas=sigmas)


def _tenths_of_millimetre(metres: float) -> str:
    if round(1000 * metres, 1) == 0.0:
        return gettext("below {limit}", limit=fixed_number(0.1, 1))
    return millimetres(metres)


def _component_tables(adjustment: AdjustmentValues) -> list[Block]:
    return [
        report_table(VARIANCE_COMPONENTS_TABLE, adjustment.components),
        Paragraph(gettext(VARIANCE_COMPONENTS_TEXT)),
    ]
