"""Table of the pairs of lines on a validation plane: distances, offsets and angles."""

from lispac.gui.appearance import quantities
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable, Row
from lispac.gui.widgets.result_tables import window_columns, window_rows
from lispac.language import gettext
from lispac.present.tables import title_text
from lispac.present.validation import WINDOW_PAIRS_TABLE, PairValues
from lispac.validation.comparison_results import PlaneComparison


def create_pairs_table() -> DiagnosticsTable:
    """Create the empty table."""
    title = title_text(WINDOW_PAIRS_TABLE.title)
    return DiagnosticsTable("pairs_table", title, window_columns(WINDOW_PAIRS_TABLE))


def pair_rows(comparison: PlaneComparison) -> list[Row]:
    """One row for each pair of lines on the plane."""
    return window_rows(WINDOW_PAIRS_TABLE, map(PairValues.of, comparison.pairs), tip=_pair_tip)


def _millimetres(metres: float, *, sign: bool = False) -> str:
    return quantities.amount(1000 * metres, "mm", 1, sign=sign)


def _pair_tip(pair: PairValues) -> str:
    lines = []
    signed, planes = pair.after.signed, pair.after.planes
    if signed is not None:
        lines.append(
            gettext(
                "After: M3C2 distances at {count:n} places, 95 % confidence interval of one "
                "distance ± {half_width}; {share:percent.0} % differ significantly from zero",
                count=signed.places,
                half_width=_millimetres(signed.interval95_m),
                share=signed.significant_share,
            )
        )
    if planes is not None:
        lines.append(
            gettext(
                "Plane offset after calibration: {offset} ± {half_width} (95 % confidence "
                "interval)",
                offset=_millimetres(planes.offset_m, sign=True),
                half_width=_millimetres(planes.offset_interval95_m),
            )
        )
    return "\n".join(lines)
