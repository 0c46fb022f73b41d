"""Every table of the report as CSV, in one ZIP file, for a spreadsheet or a script.

The numbers are rounded as in the signed report. A cell that contains only a number is written with
a decimal point, a hyphen as minus sign and no separators between groups of digits; the plus-minus
sign of a cell that contains only half the width of an interval is omitted. Unknown values are
empty.
"""

import csv
import re
import unicodedata
import zipfile
from io import StringIO
from pathlib import Path

from lispac.language import N_, gettext, in_language
from lispac.present.text_format import UNKNOWN_TEXT, decimal_sign, group_sign
from lispac.present.validation import DistancesBySteps
from lispac.report.document import report_document
from lispac.report.document_blocks import Block, Column, Table, as_rows
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.report.report_values import ReportContent
from lispac.untrusted_values import as_csv_cell

_ARCHIVE_TIME = (1980, 1, 1, 0, 0, 0)
"""Fixed time of every file in the archive, so that the same report gives the same bytes."""


def write_tables(
    content: ReportContent, path: Path, options: ReportOptions = DEFAULT_OPTIONS
) -> None:
    """Write one ZIP file with a CSV file (UTF-8) for each table, in the report's order.

    The last files contain the values of the histograms, profiles and maps of the validation planes.
    """
    document = report_document(content, {}, options)
    blocks: list[Block] = [document.identity, *document.summary]
    for section in document.sections:
        blocks += section.blocks
    tables = [block for block in blocks if isinstance(block, Table)]
    with in_language(options.language), zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        tables += [*histogram_tables(content), *map_tables(content)]
        for k, table in enumerate(tables, start=1):
            entry = zipfile.ZipInfo(f"{k:02d}-{_file_stem(table.title)}.csv", _ARCHIVE_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, csv_text(table))


def histogram_tables(content: ReportContent) -> list[Table]:
    """Tables of the histogram of each validation plane, and of distances by height and range."""
    made = []
    for plane in content.validation:
        edges = [1000 * edge for edge in plane.bin_edges_m]
        ends = [*(f"{edge:.4f}" for edge in edges[1:-1]), gettext("and beyond")]
        bins = zip(edges[:-1], ends, plane.counts_before, plane.counts_after, strict=True)
        made.append(
            Table(
                gettext("Histogram of {plane}", plane=plane.name),
                tuple(
                    Column(gettext(each))
                    for each in (
                        N_("From (mm)"), N_("To (mm)"), N_("Points before calibration"),
                        N_("Points after calibration"),
                    )
                ),
                as_rows([f"{low:.4f}", end, f"{b}", f"{a}"] for low, end, b, a in bins),
            )
        )  # fmt: skip
        for template, profile in (
            (N_("Distances on {plane} by height"), plane.by_height),
            (N_("Distances on {plane} by range"), plane.by_range),
        ):
            if profile is not None:
                made.append(_profile_table(gettext(template, plane=plane.name), profile))
    return made


def _profile_table(title: str, profile: DistancesBySteps) -> Table:
    heads = (
        N_("From (m)"), N_("To (m)"), N_("Distances"), N_("Median before (mm)"),
        N_("Median after (mm)"), N_("95 % before (mm)"), N_("95 % after (mm)"),
    )  # fmt: skip
    statistics = (
        profile.median_before_m, profile.median_after_m, profile.p95_before_m,
        profile.p95_after_m,
    )  # fmt: skip
    return Table(
        title,
        tuple(Column(gettext(each)) for each in heads),
        as_rows(
            [
                f"{low:.3f}", f"{high:.3f}", str(n),
                *("" if v is None else f"{1000 * v:.3f}" for v in values),
            ]
            for low, high, n, *values in zip(
                profile.edges_m[:-1], profile.edges_m[1:], profile.n, *statistics, strict=True
            )
        ),
    )  # fmt: skip


def map_tables(content: ReportContent) -> list[Table]:
    """Tables of the cells of every map of distances, which the report shows as pictures only."""
    heads = (N_("Horizontal (m)"), N_("Up (m)"), N_("Before (mm)"), N_("After (mm)"))
    columns = tuple(Column(gettext(each)) for each in heads)
    return [
        Table(
            gettext(
                "Map of {plane}: {line} relative to {other}",
                plane=plane.name, line=each.line_a, other=each.line_b,
            ),
            columns,
            as_rows(
                [f"{across:.3f}", f"{up:.3f}", f"{1000 * before:.2f}", f"{1000 * after:.2f}"]
                for across, up, before, after in zip(
                    each.across_m, each.up_m, each.before_m, each.after_m, strict=True
                )
            ),
        )
        for plane in content.validation
        for each in plane.maps
    ]  # fmt: skip


def csv_text(table: Table) -> str:
    """Convert a table to CSV; the first row contains the titles of the columns, if there are any.

    Numbers are recognised in the notation of the language in use and in that of Python.
    """
    stream = StringIO()
    # The byte order mark makes a spreadsheet read the file as UTF-8.
    stream.write("\ufeff")
    writer = csv.writer(stream)
    heads = [column.title.replace("\n", " ") for column in table.columns]
    if any(heads):
        writer.writerow(map(as_csv_cell, heads))
    numbers = _number_pattern()
    for row in table.rows:
        # Texts typed by the user are not converted, since a serial number may look like a number.
        writer.writerow(
            as_csv_cell(cell if table.form else _plain_cell(cell, numbers)) for cell in row
        )
    return stream.getvalue()


def _number_pattern() -> re.Pattern[str]:
    """Pattern of one number, or of half an interval; its groups are sign, integer and decimals."""
    groups, decimal = re.escape(group_sign()), re.escape(decimal_sign())
    return re.compile(
        rf"(?:\u00b1 ?)?([+-]?)(\d{{1,3}}(?:{groups}\d{{3}})+|\d+)(?:[{decimal}.](\d+))?"
    )


def _plain_cell(cell: str, numbers: re.Pattern[str]) -> str:
    if cell == UNKNOWN_TEXT:
        return ""
    text = cell.replace("\u2212", "-").replace("\u200b", "").strip()
    found = [numbers.fullmatch(part) for part in text.split(" \u00b1 ")]  # value and interval
    plain = [_plain_number(each) for each in found if each is not None]
    if len(plain) < len(found):
        return re.sub("[\u00a0\u202f]", " ", text)
    return " \u00b1 ".join(plain)


def _plain_number(match: re.Match[str]) -> str:
    sign, whole, decimals = match.groups()
    return f"{sign}{re.sub('[^0-9]', '', whole)}{f'.{decimals}' if decimals else ''}"


def _file_stem(title: str) -> str:
    """File name from a title, valid on every system."""
    bare = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode()
    words = re.sub(r"[^a-z0-9]+", "-", bare.lower()).strip("-")
    return words[:60].rstrip("-") or "table"
