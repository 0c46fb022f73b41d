"""Every pair of lines on a validation plane: distances, offset and turn, before and after."""

from collections.abc import Sequence
from math import degrees

from lispac.gui import units
from lispac.gui.panels.diagnostics_table import Cell, Column, DiagnosticsTable, Row, number
from lispac.validation.plane_offset import PlaneOffset
from lispac.validation.results import PairComparison, PairState, PlaneComparison

_TWICE = (
    ("RMS", "(mm)", "Root mean square distance between the lines"),
    ("Off", "(mm)", "How far the first line lies off the second along the normal, in the median "
     "of places (M3C2), positive towards the vessel"),
    ("Plane off", "(mm)", "The first line's plane off the second's, positive towards the vessel"),
    ("Turned", "(deg)", "Angle between the planes of the two lines"),
)  # fmt: skip
COLUMNS = (
    Column("Lines", "The two lines; ⇄ where they were run in opposite directions", words=True),
    Column("Points", "Distances, both directions together"),
    *(
        Column(
            f"{name} {state} {unit}",
            f"{tip}, {state} the calibration",
            base="°" if unit == "(deg)" else "mm",
        )
        for name, unit, tip in _TWICE
        for state in ("before", "after")
    ),
)


def pairs_table() -> DiagnosticsTable:
    """The table, empty."""
    return DiagnosticsTable("pairs_table", "Pairs of lines before and after", COLUMNS)


def pair_rows(comparison: PlaneComparison) -> list[Row]:
    """A row for each pair of the plane."""
    return [_row(pair) for pair in comparison.pairs]


def _row(pair: PairComparison) -> Row:
    arrow = " ⇄ " if pair.reciprocal else " / "
    states = (pair.before, pair.after)
    figures = [
        *(number(state.distances.rms, ".1f", 1000.0) for state in states),
        *(number(_off(state), "+.1f", 1000.0) for state in states),
        *(number(None if p is None else p.offset, "+.1f", 1000.0) for p in _planes(states)),
        *(number(None if p is None else degrees(p.angle), ".3f") for p in _planes(states)),
    ]
    return Row(
        (
            Cell(f"{pair.line_a}{arrow}{pair.line_b}"),
            number(pair.after.distances.n, ",.0f"),
            *figures,
        ),
        tip=_tip(pair),
        bases=("mm",),
    )


def _mm(metres: float, form: str = ".1f") -> str:
    return units.figure(1000 * metres, "mm", form)


def _off(state: PairState) -> float | None:
    return None if state.signed is None else state.signed.median


def _planes(states: Sequence[PairState]) -> list[PlaneOffset | None]:
    return [state.planes for state in states]


def _tip(pair: PairComparison) -> str:
    said = []
    signed, planes = pair.after.signed, pair.after.planes
    if signed is not None:
        said.append(
            f"After: at {signed.n:,} places the 95 % interval of one is ± "
            f"{_mm(signed.half_width)} mm; {100 * signed.significant:.0f} % of them differ "
            "from zero."
        )
    if planes is not None:
        said.append(
            f"Planes after: {_mm(planes.offset, '+.1f')} ± {_mm(planes.offset_95)} mm (95 %)."
        )
    return "\n".join(said).replace("-", "−")
