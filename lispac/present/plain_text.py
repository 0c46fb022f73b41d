"""Tables and facts as plain text in columns, for the terminal and for text files."""

import textwrap
from collections.abc import Sequence

from lispac.language import to_plain_text
from lispac.present.tables import Fact, Row, Table, cell_text, title_text, unit_text

TEXT_WIDTH = 100
"""Number of characters in a line of running text."""


def table_as_text(table: Table[Row], rows: Sequence[Row]) -> str:
    """Table of results: title, headings with units, and rows in aligned columns."""
    heads = [
        " ".join(
            [
                *title_text(column.title).split(),
                *([f"({unit_text(column.unit)})"] if column.unit else []),
            ]
        )
        for column in table.columns
    ]
    lines = [heads, *([cell_text(column, row) for column in table.columns] for row in rows)]
    lines = [[to_plain_text(cell) for cell in line] for line in lines]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    texts = [to_plain_text(title_text(table.title))]
    for line in lines:
        cells = (
            cell.ljust(width) if column.is_text else cell.rjust(width)
            for cell, width, column in zip(line, widths, table.columns, strict=True)
        )
        texts.append(f"  {'  '.join(cells).rstrip()}")
    return "\n".join(texts)


def facts_as_text(title: str, facts: Sequence[Fact]) -> str:
    """Names and values below a title, one in each row."""
    texts = [title]
    width = max(len(fact.name) for fact in facts)
    for fact in facts:
        label = f"  {fact.name:{width}s}  "
        text = f"{label}{to_plain_text(fact.text)}"
        texts.append(textwrap.fill(text, TEXT_WIDTH, subsequent_indent=" " * len(label)))
    return "\n".join(texts)
