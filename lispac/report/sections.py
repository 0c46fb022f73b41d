"""The sections of the report: a content's numbers put into tables and sentences.

Angles have four decimals in degrees, distances one in millimetres.
"""

from collections.abc import Iterable, Sequence

from lispac.report.blocks import Block, Bullets, Column, Paragraph, Picture, Table
from lispac.report.values import Adjustment, Distances, ReportContent, ValidationPlane
from lispac.report.wording import angle, count, heading, known, minus, mm, origin, signed, triple


def summary(content: ReportContent) -> list[Block]:
    blocks: list[Block] = [_angle_table(content)]
    adjustment = content.adjustment
    if adjustment is not None:
        targets = count(len(adjustment.targets), "target")
        blocks.append(
            Paragraph(
                f"From {adjustment.points:,} points of {targets} in "
                f"{count(len(adjustment.sightings), 'sighting')} on "
                f"{count(len({s.line for s in adjustment.sightings}), 'line')}: RMS distance to "
                f"the targets' planes {mm(adjustment.rms_before_m)}\u00a0mm before, "
                f"{mm(adjustment.rms_after_m)}\u00a0mm after."
            )
        )
    if content.validation:
        blocks.append(
            _distance_table(
                "Validation: distances between lines on planes that took no part (mm)",
                [Column("Plane", "left")],
                [((plane.name,), plane.before, plane.after) for plane in content.validation],
            )
        )
    blocks.append(Paragraph(content.settings.convention.replace(" = ", "\u00a0=\u00a0")))
    return blocks


def _angle_table(content: ReportContent) -> Table:
    columns = [Column("Angle", "left"), Column("Prior\n(deg)")]
    rows = [[a.name.capitalize(), angle(a.prior_deg)] for a in content.angles]
    if content.calibrated:
        columns += [
            Column("Estimated\n(deg)"), Column("1 sigma\n(deg)"), Column("95 % interval\n(deg)"),
        ]  # fmt: skip
        for row, a in zip(rows, content.angles, strict=True):
            row += [
                known(a.estimated_deg, angle),
                known(a.sigma_deg, lambda v: f"{v:.4f}"),
                known(a.interval95_deg, lambda v: f"\u00b1 {v:.4f}"),
            ]
    if content.simulated:
        columns.append(Column("Truth\n(deg)"))
        for row, a in zip(rows, content.angles, strict=True):
            row.append(known(a.truth_deg, angle))
        if content.calibrated:
            columns.append(Column("Error\n(deg)"))
            for row, a in zip(rows, content.angles, strict=True):
                row.append(known(a.error_deg, angle))
    return Table("Boresight", tuple(columns), _rows(rows))


def boresight(content: ReportContent) -> list[Block]:
    adjustment = content.adjustment
    if adjustment is None:
        return [Paragraph("No boresight has been estimated yet.")]
    names = [angle.name for angle in content.angles]
    correlation = Table(
        "Correlations",
        (Column("", "left"), *(Column(name.capitalize()) for name in names)),
        _rows(
            [name.capitalize(), *(signed(value, 3) for value in row)]
            for name, row in zip(names, adjustment.correlation, strict=True)
        ),
    )
    test = adjustment.chi_square
    bounds = (
        f", bounds {test.lower:,.1f} to {test.upper:,.1f}"
        if test.lower is not None and test.upper is not None
        else ""
    )
    fit = _facts(
        "Fit",
        [
            ("Points", f"{adjustment.points:,}"),
            ("Iterations", str(adjustment.iterations)),
            ("Degrees of freedom", f"{adjustment.degrees_of_freedom:,}"),
            ("Variance factor", known(adjustment.variance_factor, lambda v: f"{v:.4f}")),
            ("Chi-square test at 95 %", f"statistic {test.statistic:,.1f}{bounds}"),
            ("", test.in_words),
            ("RMS before", f"{mm(adjustment.rms_before_m)} mm"),
            ("RMS after", f"{mm(adjustment.rms_after_m)} mm"),
            ("Model of the POS errors", content.settings.pos_errors_in_words),
        ],
    )
    effects = Table(
        "Displacement of a point by 1 sigma of the boresight (cm)",
        (
            Column("Angle", "left"),
            *(Column(f"at {distance:.0f} m") for distance in adjustment.effect_distances_m),
        ),
        _rows(
            [_effect_name(e.angle), *(f"{100 * value:.2f}" for value in e.displacement_m)]
            for e in adjustment.effects
        ),
    )
    return [fit, correlation, effects]


def _effect_name(angle: str) -> str:
    together = "All three together, in the direction where they show most"
    return together if angle == "worst direction" else angle.capitalize()


def residuals(content: ReportContent) -> list[Block]:
    blocks: list[Block] = []
    if content.planes:
        blocks.append(_planes_table(content))
    reasons = tuple(
        f"{plane.name} on {line}: {reason}"
        for plane in content.planes
        for line, reason in plane.missing.items()
    )
    if reasons:
        blocks += [Paragraph("Not found:"), Bullets(reasons)]
    if content.adjustment is not None:
        blocks += _fit_tables(content.adjustment)
    return blocks or [Paragraph("No target has been picked yet.")]


def _planes_table(content: ReportContent) -> Table:
    return Table(
        "Targets and validation planes as picked (seed in the local frame)",
        (
            Column("Name", "left"),
            Column("Role", "left"),
            Column("North\n(m)"),
            Column("West\n(m)"),
            Column("Up\n(m)"),
            Column("Threshold\n(mm)"),
            Column("Lines"),
        ),
        _rows(
            [
                plane.name,
                plane.role if plane.used else f"{plane.role}, left out",
                *(minus(f"{value:.2f}") for value in plane.seed_local_m),
                mm(plane.threshold_m),
                f"{len(plane.lines)} of {len(content.lines)}",
            ]
            for plane in content.planes
        ),
    )


def _fit_tables(adjustment: Adjustment) -> list[Block]:
    from lispac.report.figures import residual_figures_of, svg_of

    targets = Table(
        "Fit of each target, all lines together, to one plane",
        (
            Column("Target", "left"),
            Column("Sightings"),
            Column("Points"),
            Column("RMS\nbefore (mm)"),
            Column("RMS\nafter (mm)"),
        ),
        _rows(
            [t.target, str(t.sightings), f"{t.points:,}", mm(t.rms_before_m), mm(t.rms_after_m)]
            for t in adjustment.targets
        ),
    )
    sightings = Table(
        "Fit of each sighting to its target's plane",
        (
            Column("Target", "left"),
            Column("Line", "left"),
            Column("Heading\n(deg)"),
            Column("Points"),
            Column("RMS\nbefore (mm)"),
            Column("RMS\nafter (mm)"),
            Column("Mean\nafter (mm)"),
        ),
        _rows(
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
    figures = [
        Picture("RMS of each sighting, before and after.", svg_of(figure), ".svg")
        for figure in residual_figures_of(adjustment.sightings)
    ]
    return [targets, sightings, *figures]


def validation(content: ReportContent) -> list[Block]:
    from lispac.report.figures import svg_of, validation_figure

    if not content.validation:
        return [Paragraph("No plane outside the adjustment has been compared between the lines.")]
    sources = " and ".join(sorted({plane.pooled_from for plane in content.validation}))
    blocks: list[Block] = [
        Paragraph(
            "Distances from each point of one line to a local plane through the points of the "
            "other, both directions, only where both lines saw the plane, before and after the "
            f"calibration. The histograms and the totals on page one are of {sources}; the same "
            "points stand in both states. What remains after the calibration is the POS error of "
            "each line, which no boresight removes."
        )
    ]
    for plane in content.validation:
        caption = f"{plane.name}: distances between lines before and after the calibration."
        blocks.append(Picture(caption, svg_of(validation_figure(plane)), ".svg"))
    blocks.append(
        _distance_table(
            "Every pair of lines (mm)",
            [Column("Plane", "left"), Column("Lines", "left"),
             Column("Reciprocal", "left")],
            [
                ((plane.name, f"{pair.line_a} / {pair.line_b}", "yes" if pair.reciprocal else "no"),
                 pair.before, pair.after)
                for plane in content.validation
                for pair in plane.pairs
            ],
        )
    )  # fmt: skip
    apart = tuple(_not_compared(plane) for plane in content.validation if plane.not_compared)
    if apart:
        blocks += [
            Paragraph("Not compared, for want of a part seen by both lines:"),
            Bullets(apart),
        ]
    return blocks


def _not_compared(plane: ValidationPlane) -> str:
    return f"{plane.name}: {', '.join(f'{a} / {b}' for a, b in plane.not_compared)}"


def _distance_table(
    title: str,
    head: Sequence[Column],
    rows: Sequence[tuple[tuple[str, ...], Distances, Distances]],
) -> Table:
    statistics = ("Median", "RMS", "95 %")
    columns = (
        *head,
        Column("Points"),
        *(Column(f"{name}\n{state}") for name in statistics for state in ("before", "after")),
    )
    return Table(
        title,
        columns,
        _rows(
            [
                *names,
                f"{before.n:,}",
                mm(before.median_m), mm(after.median_m),
                mm(before.rms_m), mm(after.rms_m),
                mm(before.p95_m), mm(after.p95_m),
            ]
            for names, before, after in rows
        ),
    )  # fmt: skip


def site(content: ReportContent) -> list[Block]:
    from lispac.report.figures import site_figure_of, svg_of

    blocks: list[Block] = []
    if any(line.track_local_m for line in content.lines) or content.planes:
        figure = site_figure_of(content.lines, content.planes)
        blocks.append(Picture("Plan of the site, local frame.", svg_of(figure), ".svg"))
    blocks.append(
        Table(
            "Lines",
            (
                Column("Line", "left"),
                Column("File", "left"),
                Column("Heading\n(deg)"),
                Column("Points"),
            ),
            _rows(
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
    return blocks


def settings(content: ReportContent) -> list[Block]:
    used = content.settings
    facts = [
        ("Lever arm, forward, left, up", f"{triple(used.lever_arm_m, 4)} m"),
        ("Origin of the local frame", origin(used.origin_deg_m)),
        ("LiDAR sigma on each axis", f"{mm(used.lidar_sigma_m)} mm"),
        (
            "Position sigma, north, east, down",
            f"{triple(used.position_sigma_m, 3)} m"
            if used.position_sigma_m
            else "from the trajectory accuracy file",
        ),
        (
            "Attitude sigma, roll, pitch, heading",
            f"{triple(used.attitude_sigma_deg, 4)} deg"
            if used.attitude_sigma_deg
            else "from the trajectory accuracy file",
        ),
        ("Distance between the points kept", f"{used.subsample_m:.3f} m" if used.subsample_m else
         "all points kept"),
        ("POS errors", used.pos_errors),
    ]  # fmt: skip
    if used.position_correlation_time_s and used.attitude_correlation_time_s:
        facts.append(
            (
                "Correlation times, position, attitude",
                f"{used.position_correlation_time_s:g} s, {used.attitude_correlation_time_s:g} s",
            )
        )
    files = Table(
        "Input files",
        (
            Column("Use", "left"),
            Column("File", "left"),
            Column("Bytes"),
            Column("SHA-256", "left", code=True),
        ),
        _rows(
            [
                file.role,
                file.name,
                known(file.size_bytes, lambda v: f"{v:,.0f}"),
                file.sha256 or "not readable",
            ]
            for file in content.files
        ),
    )
    blocks: list[Block] = [_facts("Settings", facts), files]
    if content.notes:
        blocks += [Paragraph("Assumed while reading:"), Bullets(content.notes)]
    return blocks


def _facts(title: str, facts: Sequence[tuple[str, str]]) -> Table:
    return Table(title, (Column("", "left"), Column("", "left", wide=True)), tuple(facts))


def _rows(rows: Iterable[Sequence[str]]) -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(row) for row in rows)
