"""CSV of results, for spreadsheets and scripts."""

import csv
from collections.abc import Iterable
from io import StringIO

from lispac.present.tables import Row, Table, plain_cell_text
from lispac.untrusted_values import as_csv_cell

BYTE_ORDER_MARK = "\ufeff"
"""First character of a file that a spreadsheet is to read as UTF-8."""


def csv_text(
    rows: Iterable[Iterable[object]], *, line_end: str = "\r\n", separator: str = ","
) -> str:
    """Rows as CSV; None gives an empty cell, and no text is a formula for a spreadsheet."""
    stream = StringIO()
    writer = csv.writer(stream, lineterminator=line_end, delimiter=separator)
    writer.writerows(map(as_csv_cell, row) for row in rows)
    return stream.getvalue()


def keyed_csv_text(table: Table[Row], rows: Iterable[Row], *, line_end: str = "\n") -> str:
    """Rows as CSV for scripts; the titles of the columns are keys, which are not translated."""
    cells = [[plain_cell_text(column, row) for column in table.columns] for row in rows]
    return csv_text([[column.title for column in table.columns], *cells], line_end=line_end)
