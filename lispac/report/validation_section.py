"""The section on validation: how far apart the lines are on planes not used in the adjustment."""

from collections.abc import Sequence

from lispac.report.blocks import Block, Bullets, Column, Drawing, Paragraph, Table, rows
from lispac.report.validation_values import Distances, Pair, ValidationPlane
from lispac.report.values import ReportContent
from lispac.report.wording import UNKNOWN, known, mm, signed

PLACES = "Signed distances along the normal, reciprocal pairs (mm)"
PLANES = "Planes of the two lines against each other, reciprocal pairs"


def validation(content: ReportContent) -> list[Block]:
    """How far apart the lines were on planes not used in the adjustment, and are."""
    from lispac.report.histograms import validation_figure
    from lispac.report.maps import map_figure_of
    from lispac.report.profiles import profile_figure_of

    if not content.validation:
        return [Paragraph("No plane outside the adjustment has been compared between the lines.")]
    sources = " and ".join(sorted({plane.pooled_from for plane in content.validation}))
    models = " and ".join(sorted({plane.measured_to for plane in content.validation}))
    blocks: list[Block] = [
        Paragraph(
            f"Distances from each point of one line to the surface of the other ({models}), both "
            "directions, only where both lines saw the plane, before and after the calibration. "
            f"The histograms and the totals are of {sources}; the same points stand in both "
            "states. What remains after the calibration is the POS error of each line, which no "
            "boresight removes."
        ),
        _figures_table(content.validation),
        Paragraph(
            "Robust sigma: 1.4826 times the median absolute deviation from the median. Outliers: "
            "distances more than three of these above the median; they stay in all other figures."
        ),
    ]
    for plane in content.validation:
        caption = f"{plane.name}: distances between lines before and after the calibration."
        blocks.append(Drawing(caption, validation_figure, (plane,)))
        if plane.by_height is not None or plane.by_range is not None:
            words = " and ".join(
                name
                for name, profile in (("height", plane.by_height), ("range", plane.by_range))
                if profile is not None
            )
            caption = f"{plane.name}: median and 95th percentile of the distances against {words}."
            blocks.append(Drawing(caption, profile_figure_of, (plane,)))
        if plane.maps:
            caption = (
                f"{plane.name}: distance of the first line from the second along the normal, over "
                "the plane as seen from the vessel; red where the first is nearer, blue where it "
                "is farther, grey where one of them has too few points."
            )
            blocks.append(Drawing(caption, map_figure_of, (plane,)))
    blocks.append(
        distance_table(
            "Every pair of lines (mm)",
            [Column("Plane", "left"), Column("Lines", "left"), Column("Reciprocal", "left")],
            [
                (
                    (*_named(plane, pair), "yes" if pair.reciprocal else "no"),
                    pair.before.distances,
                    pair.after.distances,
                )
                for plane in content.validation
                for pair in plane.pairs
            ],
        )
    )
    blocks += _signed(content.validation)
    apart = tuple(_not_compared(plane) for plane in content.validation if plane.not_compared)
    if apart:
        blocks += [
            Paragraph("Not compared, for want of a part seen by both lines:"),
            Bullets(apart),
        ]
    return blocks


def _figures_table(planes: Sequence[ValidationPlane]) -> Table:
    """Every figure of the pooled distances, one row a state."""
    columns = (
        Column("Plane", "left"), Column("State", "left"), Column("Points"), Column("Mean"),
        Column("Median"), Column("RMS"), Column("68 %"), Column("95 %"), Column("99 %"),
        Column("Robust\nsigma"), Column("Outliers"),
    )  # fmt: skip
    cells = []
    for plane in planes:
        for state, d in (("before", plane.before), ("after", plane.after)):
            cells.append(
                [
                    plane.name, state, f"{d.n:,}", mm(d.mean_m), mm(d.median_m), mm(d.rms_m),
                    mm(d.p68_m), mm(d.p95_m), mm(d.p99_m), known(d.robust_sigma_m, mm),
                    known(d.outliers, _whole),
                ]
            )  # fmt: skip
    return Table("Distances between lines on each plane (mm)", columns, rows(cells))


def _signed(planes: Sequence[ValidationPlane]) -> list[Block]:
    """Offsets and turns with their confidence, of the pairs where the boresight shows most."""
    listed = [
        (plane, pair)
        for plane in planes
        for pair in plane.pairs
        if pair.reciprocal or plane.pooled_from == "all pairs"
    ]
    blocks: list[Block] = []
    if any(pair.after.signed is not None for _, pair in listed):
        blocks += [
            Table(
                PLACES,
                (
                    Column("Plane", "left"), Column("Lines", "left"), Column("Places"),
                    *_twice("Median", "95 % of\na place", "Differ\nfrom 0"),
                ),
                rows([*_named(plane, pair), *_place_cells(pair)] for plane, pair in listed),
            ),
            Paragraph(
                "How far the first line lies off the second, positive towards the vessel: means "
                "within cylinders along the local normal (M3C2), so that the noise of single "
                "points averages out. The interval is that of one place by the scatter of its "
                "points; the last columns tell at how many places the lines differ from each other "
                "beyond it."
            ),
        ]  # fmt: skip
    if any(pair.after.planes is not None for _, pair in listed):
        blocks += [
            Table(
                PLANES,
                (
                    Column("Plane", "left"), Column("Lines", "left"),
                    *_twice("Offset\n(mm)", "Turn, level\naxis (deg)", "Upright\naxis (deg)"),
                ),
                rows([*_named(plane, pair), *_plane_cells(pair)] for plane, pair in listed),
            ),
            Paragraph(
                "The plane through the first line's points against that through the second's, with "
                "95 % intervals by the scatter of the points. Offsets are positive where the first "
                "line is nearer to the vessel; turns where its upper edge (level axis), or its "
                "right edge as seen from the vessel (upright axis), comes nearer."
            ),
        ]  # fmt: skip
    return blocks


def _named(plane: ValidationPlane, pair: Pair) -> tuple[str, str]:
    return plane.name, f"{pair.line_a} / {pair.line_b}"


def _twice(*names: str) -> tuple[Column, ...]:
    """Each figure before, then each after."""
    return tuple(Column(f"{name}\n{state}") for state in ("before", "after") for name in names)


def _place_cells(pair: Pair) -> list[str]:
    cells = [known(None if pair.after.signed is None else pair.after.signed.places, _whole)]
    for state in (pair.before, pair.after):
        s = state.signed
        cells += (
            [UNKNOWN] * 3
            if s is None
            else [
                signed(1000 * s.median_m, 1), f"\u00b1 {mm(s.interval95_m)}",
                f"{100 * s.significant_share:.0f}\u00a0%",
            ]
        )  # fmt: skip
    return cells


def _plane_cells(pair: Pair) -> list[str]:
    cells: list[str] = []
    for state in (pair.before, pair.after):
        p = state.planes
        cells += (
            [UNKNOWN] * 3
            if p is None
            else [
                f"{signed(1000 * p.offset_m, 1)} \u00b1 {mm(p.offset_interval95_m)}",
                _turn(p.turn_level_deg, p.turn_level_interval95_deg),
                _turn(p.turn_upright_deg, p.turn_upright_interval95_deg),
            ]
        )
    return cells


def _turn(value: float, half: float) -> str:
    return f"{signed(value, 3)} \u00b1 {half:.3f}"


def _whole(value: float) -> str:
    return f"{value:,.0f}"


def _not_compared(plane: ValidationPlane) -> str:
    return f"{plane.name}: {', '.join(f'{a} / {b}' for a, b in plane.not_compared)}"


def distance_table(
    title: str,
    head: Sequence[Column],
    compared: Sequence[tuple[tuple[str, ...], Distances, Distances]],
) -> Table:
    """Median, RMS and 95 % of distances, before and after."""
    statistics = ("Median", "RMS", "95 %")
    columns = (
        *head,
        Column("Points"),
        *(Column(f"{name}\n{state}") for name in statistics for state in ("before", "after")),
    )
    return Table(
        title,
        columns,
        rows(
            [
                *names,
                f"{before.n:,}",
                mm(before.median_m), mm(after.median_m),
                mm(before.rms_m), mm(after.rms_m),
                mm(before.p95_m), mm(after.p95_m),
            ]
            for names, before, after in compared
        ),
    )  # fmt: skip
