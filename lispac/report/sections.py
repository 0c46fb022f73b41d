"""The sections of the report: a content's numbers put into tables and sentences.

Angles have four decimals in degrees, distances one in millimetres.
"""

from collections.abc import Sequence

from lispac.messages import note
from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, rows
from lispac.report.trajectory_values import TrajectoryOnLine
from lispac.report.validation_section import distance_table
from lispac.report.values import (
    Adjustment,
    ExtraParameter,
    PickedPlane,
    ReportContent,
)
from lispac.report.wording import (
    angle,
    count,
    heading,
    known,
    listed,
    minus,
    mm,
    parameter,
    quantity,
    signed,
)
from lispac.reverse_translation.messages import translated_text


def summary(content: ReportContent) -> list[Block]:
    """The answer on page one."""
    blocks: list[Block] = [_angle_table(content)]
    adjustment = content.adjustment
    if adjustment is not None:
        if adjustment.rotation_in_words:
            blocks.append(Paragraph(adjustment.rotation_in_words))
        targets = count(len(adjustment.targets), "target")
        blocks.append(
            Paragraph(
                f"From {adjustment.points:,} points of {targets} in "
                f"{count(len(adjustment.sightings), 'sighting')} on "
                f"{count(len({s.line for s in adjustment.sightings}), 'line')}: RMS distance to "
                f"the targets' surfaces {mm(adjustment.rms_before_m)}\u00a0mm before, "
                f"{mm(adjustment.rms_after_m)}\u00a0mm after."
            )
        )
        extra = [_with_sigma(p) for p in adjustment.parameters if p.value is not None]
        if extra:
            blocks.append(
                Paragraph(
                    f"The boresight goes with these values, estimated with it: {listed(extra)}."
                )
            )
    if content.validation:
        blocks.append(
            distance_table(
                "Validation: distances between lines on planes not used in the adjustment (mm)",
                [Column("Plane", "left")],
                [((plane.name,), plane.before, plane.after) for plane in content.validation],
            )
        )
    against = content.absolute
    if against is not None and not against.together.after.mean_significant:
        blocks.append(Paragraph(f"Checked against {against.reference}: {against.in_words[0]}"))
    # The formula breaks between its factors alone
    convention = content.settings.convention.replace(" = ", "\u00a0=\u00a0")
    blocks.append(Paragraph(convention.replace("·", "·\u200b")))
    return blocks


def _with_sigma(found: ExtraParameter) -> str:
    assert found.value is not None
    assert found.sigma is not None
    value = quantity(found.name, found.value, sign=True)
    return f"{parameter(found.name)} {value} (1\u00a0sigma {quantity(found.name, found.sigma)})"


def _angle_table(content: ReportContent) -> Table:
    columns = [Column("Angle", "left"), Column("Prior\n(deg)")]
    cells = [[a.name.capitalize(), angle(a.prior_deg)] for a in content.angles]
    if content.calibrated:
        columns += [
            Column("Estimated\n(deg)"), Column("1 sigma\n(deg)"), Column("95 % interval\n(deg)"),
        ]  # fmt: skip
        for row, a in zip(cells, content.angles, strict=True):
            row += [
                known(a.estimated_deg, angle),
                known(a.sigma_deg, lambda v: f"{v:.4f}"),
                known(a.interval95_deg, lambda v: f"\u00b1 {v:.4f}"),
            ]
    if content.simulated:
        columns.append(Column("Truth\n(deg)"))
        for row, a in zip(cells, content.angles, strict=True):
            row.append(known(a.truth_deg, angle))
        if content.calibrated:
            columns.append(Column("Error\n(deg)"))
            for row, a in zip(cells, content.angles, strict=True):
                row.append(known(a.error_deg, angle))
    return Table("Boresight", tuple(columns), rows(cells))


def residuals(content: ReportContent) -> list[Block]:
    """What was picked, and how far the points lie from it."""
    blocks: list[Block] = []
    if content.planes:
        blocks.append(_planes_table(content))
    reasons = tuple(
        translated_text(
            note("project.not_found_on_line", target=plane.name, line=line, reason=reason)
        )
        for plane in content.planes
        for line, reason in plane.missing.items()
    )
    if reasons:
        blocks += [Paragraph("Not found:"), Bullets(reasons)]
    if content.adjustment is not None:
        blocks += _fit_tables(content.adjustment, content.settings.pos_errors == "correlated")
    return blocks or [Paragraph("No target has been picked yet.")]


def _planes_table(content: ReportContent) -> Table:
    return Table(
        "Targets and validation planes as picked (seed in the local frame)",
        (
            Column("Name", "left"),
            Column("Role", "left"),
            Column("Shape", "left"),
            Column("North\n(m)"),
            Column("West\n(m)"),
            Column("Up\n(m)"),
            Column("Threshold\n(mm)"),
            Column("Lines"),
        ),
        rows(
            [
                plane.name,
                plane.role if plane.used else f"{plane.role}, left out",
                _picked_shape(plane),
                *(minus(f"{value:.2f}") for value in plane.seed_local_m),
                mm(plane.threshold_m),
                f"{len(plane.lines)} of {len(content.lines)}",
            ]
            for plane in content.planes
        ),
    )


def _picked_shape(plane: PickedPlane) -> str:
    if plane.shape != "sphere":
        return plane.shape
    return "sphere" + known(plane.sphere_radius_m, lambda v: f", radius\u00a0{mm(v)}\u00a0mm", "")


def _fit_tables(adjustment: Adjustment, correlated: bool) -> list[Block]:
    from lispac.report.figures import residual_figures_of

    targets = Table(
        "Fit of each target, all lines together, to one surface",
        (
            Column("Target", "left"),
            Column("Surface", "left"),
            Column("Sightings"),
            Column("Points"),
            Column("RMS\nbefore (mm)"),
            Column("RMS\nafter (mm)"),
            Column("Noise\nfactor"),
        ),
        rows(
            [
                t.target,
                "sphere" + known(t.radius_m, lambda v: f", radius\u00a0{mm(v)}\u00a0mm", "")
                if t.shape == "sphere"
                else t.shape,
                str(t.sightings),
                f"{t.points:,}",
                mm(t.rms_before_m),
                mm(t.rms_after_m),
                f"{t.noise_factor:.2f}",
            ]
            for t in adjustment.targets
        ),
    )
    sightings = Table(
        "Fit of each sighting to its target's surface",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            Column("Heading\n(deg)"),
            Column("Points"),
            Column("RMS\nbefore (mm)"),
            Column("RMS\nafter (mm)"),
            Column("Mean\nafter (mm)"),
        ),
        rows(
            [
                s.target,
                s.line,
                known(s.heading_deg, heading),
                f"{s.points:,}",
                mm(s.rms_before_m),
                mm(s.rms_after_m),
                signed(1000 * s.mean_after_m, 1),
            ]
            for s in adjustment.sightings
        ),
    )
    caption = "RMS of each sighting, before and after."
    bars = Drawing(caption, residual_figures_of, (adjustment.sightings,))
    told = Paragraph(
        "RMS and mean are distances from the surface that all lines have in common. After the "
        "adjustment they still hold the POS error of each sighting, which no boresight removes. "
        "The noise factor is the LiDAR noise found in the residuals, with POS errors taken off, "
        "over the stated one; where it is above 1 the sigmas of the angles are computed with it."
        if correlated
        else "RMS and mean are distances from the surface that all lines have in common. After the "
        "adjustment they still hold the POS error of each sighting, which no boresight removes."
    )
    return [targets, sightings, told, bars]


def site(content: ReportContent) -> list[Block]:
    """Plan of the site, its lines, and the trajectory on each."""
    from lispac.report.figures import site_figure_of

    blocks: list[Block] = []
    if any(line.track_local_m for line in content.lines) or content.planes:
        drawn = (content.lines, content.planes)
        blocks.append(Drawing("Plan of the site, local frame.", site_figure_of, drawn))
    blocks.append(
        Table(
            "Lines",
            (
                Column("Line", "left"),
                Column("File", "left"),
                Column("Heading\n(deg)"),
                Column("Points"),
            ),
            rows(
                [
                    line.name,
                    line.file,
                    known(line.heading_deg, heading),
                    known(line.points, lambda v: f"{v:,.0f}"),
                ]
                for line in content.lines
            ),
        )
    )
    if content.trajectory:
        blocks += _trajectory(content.trajectory)
    return blocks


def _trajectory(lines: Sequence[TrajectoryOnLine]) -> list[Block]:
    return [
        Table(
            "Trajectory on each line",
            (
                Column("Line", "left"),
                Column("Duration\n(s)"),
                Column("Speed\n(m/s)"),
                Column("Interval\n(s)"),
                Column("Longest\ngap (s)"),
                Column("Roll\n(deg)"),
                Column("Pitch\n(deg)"),
                Column("Horizontal\n(mm)"),
                Column("Vertical\n(mm)"),
                Column("Roll, pitch\n(deg)"),
                Column("Heading\n(deg)"),
            ),
            rows(
                [
                    each.line,
                    f"{each.duration_s:.1f}",
                    f"{each.speed_m_s:.2f}",
                    f"{each.interval_s:.3f}",
                    f"{each.longest_gap_s:.3f}",
                    f"{each.motion_deg[0]:.2f}",
                    f"{each.motion_deg[1]:.2f}",
                    mm(each.sigma_horizontal_m),
                    mm(each.sigma_vertical_m),
                    f"{each.sigma_roll_pitch_deg:.4f}",
                    f"{each.sigma_heading_deg:.4f}",
                ]
                for each in lines
            ),
        ),
        Paragraph(
            "Roll and pitch: by how much the vessel moved (standard deviation). The last four "
            "columns are the largest stated 1 sigma of the POS on the line."
        ),
    ]
