"""Table of the pairs of lines on a validation plane: distances, offsets and angles."""

from dataclasses import replace

from lispac.gui.features.validate.planes_table import ROW_HEIGHT_PX
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable, Row
from lispac.gui.widgets.result_tables import local_amount, window_columns, window_rows
from lispac.language import gettext
from lispac.present.checking.acceptance import AcceptanceCriteriaValues
from lispac.present.checking.validation import WINDOW_PAIRS_TABLE, PairValues
from lispac.present.tables import MILLIMETRES, title_text
from lispac.validation.comparison_results import PlaneComparison

RMS_AFTER, OFFSET_AFTER = 2, 4
"""Columns of the values after the calibration that may be highlighted."""
LEAST_CHANGE_M = 1e-4
"""Increase of the RMS that counts as worse: one unit of the last digit in millimetres."""


def create_pairs_table() -> DiagnosticsTable:
    """Create the empty table."""
    title = title_text(WINDOW_PAIRS_TABLE.title)
    table = DiagnosticsTable("pairs_table", title, window_columns(WINDOW_PAIRS_TABLE))
    table.verticalHeader().setMinimumSectionSize(ROW_HEIGHT_PX)
    table.verticalHeader().setDefaultSectionSize(ROW_HEIGHT_PX)
    return table


def pair_rows(comparison: PlaneComparison, criteria: AcceptanceCriteriaValues) -> list[Row]:
    """One row for each pair of lines on the plane; values that exceed a limit are highlighted."""
    pairs = [PairValues.of(each) for each in comparison.pairs]
    rows = window_rows(WINDOW_PAIRS_TABLE, pairs, tip=_pair_tip)
    return [_marked_row(row, pair, criteria) for row, pair in zip(rows, pairs, strict=True)]


def _marked_row(row: Row, pair: PairValues, criteria: AcceptanceCriteriaValues) -> Row:
    """Row with an icon, highlighted values and their reasons if the pair should be checked."""
    before, rms = pair.before.distances.rms_m, pair.after.distances.rms_m
    reasons, colours = [], {}
    if rms - before >= LEAST_CHANGE_M:
        colours[RMS_AFTER] = "warning"
        reasons.append(
            gettext(
                "Worse than before the calibration: RMS {before} → {after}",
                before=local_amount(before, MILLIMETRES), after=local_amount(rms, MILLIMETRES),
            )
        )  # fmt: skip
    offset, limit = pair.absolute_offset_m, criteria.offset_m
    if offset is not None and limit is not None and offset > limit:
        colours[OFFSET_AFTER] = "error"
        reasons.append(
            gettext(
                "Offset {value}, limit {limit}",
                value=local_amount(offset, MILLIMETRES), limit=local_amount(limit, MILLIMETRES),
            )
        )  # fmt: skip
    if not reasons:
        return row
    cells = [replace(cell, colour=colours.get(k, "")) for k, cell in enumerate(row.cells)]
    quality = "poor" if "error" in colours.values() else "doubtful"
    return replace(row, cells=cells, quality=quality, tip="\n".join([*reasons, row.tip]).strip())


def _pair_tip(pair: PairValues) -> str:
    lines = []
    signed, planes = pair.after.signed, pair.after.planes
    if signed is not None:
        lines.append(
            gettext(
                "After: M3C2 distances at {count:n} places, 95 % confidence interval of one "
                "distance ± {half_width}; {share:percent.0} % differ significantly from zero",
                count=signed.places,
                half_width=local_amount(signed.interval95_m, MILLIMETRES),
                share=signed.significant_share,
            )
        )
    if planes is not None:
        lines.append(
            gettext(
                "Plane offset after calibration: {offset} ± {half_width} (95 % confidence "
                "interval)",
                offset=local_amount(planes.offset_m, MILLIMETRES.signed),
                half_width=local_amount(planes.offset_interval95_m, MILLIMETRES),
            )
        )
    return "\n".join(lines)
