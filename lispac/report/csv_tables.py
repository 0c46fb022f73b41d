"""Every table of the report as CSV, in one ZIP file, for a spreadsheet or a script.

The numbers are rounded as in the signed report and written with a decimal point, a hyphen as minus
sign and no separators between groups of digits, without the plus-minus sign before half the width
of an interval. Unknown values are empty. The title of each column contains its unit.
"""

import re
import unicodedata
import zipfile
from dataclasses import replace
from pathlib import Path

from lispac.language import N_, gettext, in_language
from lispac.present.checking.distance_bins import (
    DISTANCE_STEPS_TABLE,
    HISTOGRAM_TABLE,
    distance_steps,
    histogram_bins,
)
from lispac.present.checking.distance_maps import map_cells, map_cells_table
from lispac.present.csv_text import BYTE_ORDER_MARK, csv_text
from lispac.present.text_format import MINUS_SIGN
from lispac.report.document import report_document
from lispac.report.document_blocks import Block, Table, report_table
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.report.report_values import ReportContent
from lispac.report.sections import identity_table

_ARCHIVE_TIME = (1980, 1, 1, 0, 0, 0)
"""Fixed time of every file in the archive, so that the same report gives the same bytes."""


def write_tables(
    content: ReportContent, path: Path, options: ReportOptions = DEFAULT_OPTIONS
) -> None:
    """Write one ZIP file with a CSV file (UTF-8) for each table, in the report's order.

    The last files contain the values of the histograms, profiles and maps of the validation planes.
    """
    document = report_document(content, {}, replace(options, extent="full"))
    with in_language(options.language):
        blocks: list[Block] = [identity_table(content), *document.summary]
    for section in document.sections:
        blocks += section.blocks
    tables = [block for block in blocks if isinstance(block, Table)]
    with in_language(options.language), zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        tables += [*histogram_tables(content), *map_tables(content)]
        for k, table in enumerate(tables, start=1):
            entry = zipfile.ZipInfo(f"{k:02d}-{_file_stem(table.title)}.csv", _ARCHIVE_TIME)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, table_csv_text(table))


def histogram_tables(content: ReportContent) -> list[Table]:
    """Tables of the histogram of each validation plane, and of distances by height and range."""
    made = []
    for plane in content.validation:
        title = gettext("Histogram of {plane}", plane=plane.name)
        bins = histogram_bins(plane.bin_edges_m, plane.counts_before, plane.counts_after)
        made.append(replace(report_table(HISTOGRAM_TABLE, bins), title=title))
        for template, steps in (
            (N_("Distances on {plane} by height"), distance_steps("height", plane.by_height)),
            (N_("Distances on {plane} by range"), distance_steps("range", plane.by_range)),
        ):
            if steps:
                title = gettext(template, plane=plane.name)
                made.append(replace(report_table(DISTANCE_STEPS_TABLE, steps), title=title))
    return made


def map_tables(content: ReportContent) -> list[Table]:
    """Tables of the cells of every map of distances, which the report shows as pictures only."""
    made = []
    for plane in content.validation:
        for each in plane.maps:
            title = gettext(
                "Map of {plane}: {line} relative to {other}",
                plane=plane.name, line=each.line_a, other=each.line_b,
            )  # fmt: skip
            made.append(replace(report_table(map_cells_table(each), map_cells(each)), title=title))
    return made


def table_csv_text(table: Table) -> str:
    """Convert a table to CSV; the first row contains the titles of its columns, if it has any."""
    heads = [each.plain_title or each.title.replace("\n", " ") for each in table.columns]
    # Texts typed by the user are not changed.
    rows = table.rows if table.form else [map(_plain_text, row) for row in table.plain_rows]
    return BYTE_ORDER_MARK + csv_text([*([heads] if any(heads) else []), *rows])


def _plain_text(text: str) -> str:
    return re.sub("[\u00a0\u202f]", " ", text.replace(MINUS_SIGN, "-").replace("\u200b", ""))


def _file_stem(title: str) -> str:
    """File name from a title, valid on every system."""
    bare = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode()
    words = re.sub(r"[^a-z0-9]+", "-", bare.lower()).strip("-")
    return words[:60].rstrip("-") or "table"
