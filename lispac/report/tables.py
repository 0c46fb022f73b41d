"""Every table of the report as CSV, in one ZIP file, for a spreadsheet or a script.

The texts are those of the report, so each number is the one that was signed; numbers alone in a
cell are written as numbers: no thousands separators, a plain minus, no plus-minus sign before half
an interval.
"""

import csv
import re
import unicodedata
import zipfile
from io import StringIO
from pathlib import Path

from lispac.foreign_values import as_cell
from lispac.report.blocks import Block, Column, Table, rows
from lispac.report.document import document_of
from lispac.report.options import USUAL, ReportOptions
from lispac.report.translated import said, translator
from lispac.report.validation_values import Against
from lispac.report.values import ReportContent
from lispac.validation.bins import BEYOND

_NUMBER = re.compile(r"(?:\u00b1 ?)?([+-]?)(\d{1,3}(?:[,\u202f]\d{3})+|\d+)(\.\d+)?")
_EPOCH = (1980, 1, 1, 0, 0, 0)
"""Time of every file within: the same report gives the same bytes."""


def write_tables(content: ReportContent, path: Path, options: ReportOptions = USUAL) -> None:
    """Write one ZIP file with a CSV file (UTF-8) for each table, in the report's order.

    What the figures of the validation planes are drawn from comes last.
    """
    document = document_of(content, {}, options)
    blocks: list[Block] = [document.identity, *document.summary]
    for section in document.sections:
        blocks += section.blocks
    tables = [block for block in blocks if isinstance(block, Table)]
    say = translator(content, options.language)
    tables += [said(table, say) for table in [*histogram_tables(content), *map_tables(content)]]
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for k, table in enumerate(tables, start=1):
            entry = zipfile.ZipInfo(f"{k:02d}-{_slug(table.title)}.csv", _EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, csv_text(table))


def histogram_tables(content: ReportContent) -> list[Table]:
    """The bins of every histogram, and the distances against height and range."""
    made = []
    for plane in content.validation:
        edges = [1000 * edge for edge in plane.bin_edges_m]
        ends = [*(f"{edge:.4f}" for edge in edges[1:-1]), BEYOND]
        bins = zip(edges[:-1], ends, plane.counts_before, plane.counts_after, strict=True)
        made.append(
            Table(
                f"Histogram of {plane.name}",
                tuple(map(Column, ("From (mm)", "To (mm)", "Points before", "Points after"))),
                rows([f"{low:.4f}", end, f"{b}", f"{a}"] for low, end, b, a in bins),
            )
        )
        for what, profile in (("height", plane.by_height), ("range", plane.by_range)):
            if profile is not None:
                made.append(_profile_table(f"{plane.name} against {what}", profile))
    return made


def _profile_table(title: str, profile: Against) -> Table:
    heads = (
        "From (m)", "To (m)", "Distances", "Median before (mm)", "Median after (mm)",
        "95 % before (mm)", "95 % after (mm)",
    )  # fmt: skip
    figures = (
        profile.median_before_m, profile.median_after_m, profile.p95_before_m,
        profile.p95_after_m,
    )  # fmt: skip
    return Table(
        title,
        tuple(map(Column, heads)),
        rows(
            [
                f"{low:.3f}", f"{high:.3f}", str(n),
                *("" if v is None else f"{1000 * v:.3f}" for v in values),
            ]
            for low, high, n, *values in zip(
                profile.edges_m[:-1], profile.edges_m[1:], profile.n, *figures, strict=True
            )
        ),
    )  # fmt: skip


def map_tables(content: ReportContent) -> list[Table]:
    """The cells of every map of distances, which the report shows as pictures alone."""
    columns = tuple(map(Column, ("Across (m)", "Up (m)", "Before (mm)", "After (mm)")))
    return [
        Table(
            f"Map of {plane.name}, {each.line_a} from {each.line_b}",
            columns,
            rows(
                [f"{across:.3f}", f"{up:.3f}", f"{1000 * before:.2f}", f"{1000 * after:.2f}"]
                for across, up, before, after in zip(
                    each.across_m, each.up_m, each.before_m, each.after_m, strict=True
                )
            ),
        )
        for plane in content.validation
        for each in plane.maps
    ]


def csv_text(table: Table) -> str:
    """One table as CSV; the first row holds the heads where it has any."""
    stream = StringIO()
    # A spreadsheet takes the file for UTF-8 by its mark.
    stream.write("\ufeff")
    writer = csv.writer(stream)
    heads = [column.title.replace("\n", " ") for column in table.columns]
    if any(heads):
        writer.writerow(map(as_cell, heads))
    for row in table.rows:
        # What was typed stays as it was typed: a serial number is no number.
        writer.writerow(as_cell(cell if table.form else _plain(cell)) for cell in row)
    return stream.getvalue()


def _plain(cell: str) -> str:
    text = cell.replace("\u2212", "-").replace("\u200b", "").strip()
    number = _NUMBER.fullmatch(text)
    if number is None:
        return re.sub("[\u00a0\u202f]", " ", text)
    sign, whole, decimals = number.groups()
    return f"{sign}{re.sub('[^0-9]', '', whole)}{decimals or ''}"


def _slug(title: str) -> str:
    """A file name that every system takes."""
    bare = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode()
    words = re.sub(r"[^a-z0-9]+", "-", bare.lower()).strip("-")
    return words[:60].rstrip("-") or "table"
