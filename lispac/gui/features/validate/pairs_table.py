"""Table of the pairs of lines on a validation plane: distances, offsets and angles."""

from collections.abc import Sequence
from math import degrees

from lispac.gui.appearance import quantities
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number_cell
from lispac.language import N_, gettext
from lispac.validation.comparison_results import PairComparison, PairState, PlaneComparison
from lispac.validation.plane_offset import PlaneOffset

_COLUMNS: tuple[tuple[str, str, Base], ...] = (
    (N_("RMS before (mm)"),
     N_("RMS of the distances between the lines before the calibration"), "mm"),
    (N_("RMS after (mm)"),
     N_("RMS of the distances between the lines after the calibration"), "mm"),
    (N_("Offset before (mm)"),
     N_("Median distance of the first line from the second along the normal (M3C2) before the "
        "calibration, positive towards the vessel"), "mm"),
    (N_("Offset after (mm)"),
     N_("Median distance of the first line from the second along the normal (M3C2) after the "
        "calibration, positive towards the vessel"), "mm"),
    (N_("Plane offset before calibration (mm)"),
     N_("Distance between the planes fitted to the first and the second line before the "
        "calibration; positive if the first is nearer to the vessel"), "mm"),
    (N_("Plane offset after calibration (mm)"),
     N_("Distance between the planes fitted to the first and the second line after the "
        "calibration; positive if the first is nearer to the vessel"), "mm"),
    (N_("Tilt before calibration (deg)"),
     N_("Angle between the planes fitted to the two lines before the calibration"), "°"),
    (N_("Tilt after calibration (deg)"),
     N_("Angle between the planes fitted to the two lines after the calibration"), "°"),
)  # fmt: skip
"""Title, tip and unit of the columns of a pair's values."""


def create_pairs_table() -> DiagnosticsTable:
    """Create the empty table."""
    columns = [
        Column(
            gettext("Lines"),
            gettext("The two lines; ⇄: surveyed in opposite directions"),
            is_text=True,
        ),
        Column(
            gettext("Points"),
            gettext(
                "Number of distances from the first line to the "
                "second and from the second to the first"
            ),
        ),
        *(Column(gettext(title), gettext(tip), base=base) for title, tip, base in _COLUMNS),
    ]
    return DiagnosticsTable("pairs_table", gettext("Pairs of lines before and after"), columns)


def pair_rows(comparison: PlaneComparison) -> list[Row]:
    """One row for each pair of lines on the plane."""
    return [_pair_row(pair) for pair in comparison.pairs]


def _pair_row(pair: PairComparison) -> Row:
    arrow = " ⇄ " if pair.reciprocal else " / "
    states = (pair.before, pair.after)
    figures = [
        *(number_cell(state.distances.rms, ".1f", 1000.0) for state in states),
        *(number_cell(_median_offset(state), "+.1f", 1000.0) for state in states),
        *(
            number_cell(None if p is None else p.offset, "+.1f", 1000.0)
            for p in _plane_offsets(states)
        ),
        *(
            number_cell(None if p is None else degrees(p.angle), ".3f")
            for p in _plane_offsets(states)
        ),
    ]
    return Row(
        (
            Cell(f"{pair.line_a}{arrow}{pair.line_b}"),
            number_cell(pair.after.distances.n, ",.0f"),
            *figures,
        ),
        tip=_pair_tip(pair),
    )


def _millimetres(metres: float, *, sign: bool = False) -> str:
    return quantities.amount(1000 * metres, "mm", 1, sign=sign)


def _median_offset(state: PairState) -> float | None:
    return None if state.signed is None else state.signed.median


def _plane_offsets(states: Sequence[PairState]) -> list[PlaneOffset | None]:
    return [state.planes for state in states]


def _pair_tip(pair: PairComparison) -> str:
    lines = []
    signed, planes = pair.after.signed, pair.after.planes
    if signed is not None:
        lines.append(
            gettext(
                "After: M3C2 distances at {count:n} places, 95 % confidence interval of one "
                "distance ± {half_width}; {share:percent.0} % differ significantly from zero",
                count=signed.n,
                half_width=_millimetres(signed.half_width),
                share=signed.significant,
            )
        )
    if planes is not None:
        lines.append(
            gettext(
                "Plane offset after calibration: {offset} ± {half_width} (95 % confidence "
                "interval)",
                offset=_millimetres(planes.offset, sign=True),
                half_width=_millimetres(planes.offset_95),
            )
        )
    return "\n".join(lines)
