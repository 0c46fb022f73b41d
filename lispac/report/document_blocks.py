"""Parts of a report: sections with paragraphs, lists, tables and pictures."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from lispac.present.tables import Column as ResultColumn
from lispac.present.tables import (
    Fact,
    Format,
    Row,
    cell_text,
    plain_cell_text,
    title_text,
    unit_text,
)
from lispac.present.tables import Table as ResultTable
from lispac.present.text_format import title_with_unit
from lispac.report.options import Extent, Page

Status = Literal["bad", "fair", "good"]


@dataclass(frozen=True)
class Paragraph:
    """Running text, and names with the colours that they have in pictures (hexadecimal)."""

    text: str
    colours: tuple[tuple[str, str], ...] = ()
    kind: str = "paragraph"


@dataclass(frozen=True)
class Bullets:
    """A list of short texts."""

    items: tuple[str, ...]
    kind: str = "bullets"


@dataclass(frozen=True)
class Column:
    """Title and alignment of a column of a `Table`.

    A ``wide`` column contains sentences; a ``code`` column contains digests in a fixed-width font.
    ``plain_title`` is the title for other programs, which do not have the title of the table; it
    always contains the unit.
    """

    title: str
    align: Literal["left", "right"] = "right"
    wide: bool = False
    code: bool = False
    plain_title: str = ""


@dataclass(frozen=True)
class Table:
    """Table of texts with titled columns.

    ``plain_rows`` are the rows for other programs, with numbers as Python writes them. A ``form``
    is a table of names and values; an empty value is printed as a line to be filled in by hand.
    ``marked`` has the row and the column of each value that is printed bold and with an asterisk.
    """

    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[str, ...], ...]
    plain_rows: tuple[tuple[str, ...], ...]
    kind: str = "table"
    form: bool = False
    marked: tuple[tuple[int, int], ...] = ()


def as_rows(cells: Iterable[Sequence[str]]) -> tuple[tuple[str, ...], ...]:
    """Convert rows to the tuples that a `Table` contains."""
    return tuple(tuple(row) for row in cells)


def report_table(table: ResultTable[Row], rows: Sequence[Row]) -> Table:
    """Table of results as texts in the language in use."""
    columns = []
    for each in table.columns:
        title = title_text(each.title)
        if each.unit and "\n" in title:
            title = f"{title} ({unit_text(each.unit)})"
        elif each.unit:
            title = title_with_unit(title, unit_text(each.unit))
        side: Literal["left", "right"] = "left" if each.is_text else "right"
        bare = _plain_title(title, each)
        columns.append(Column(title, side, wide=each.is_wide, code=each.is_code, plain_title=bare))
    cells, plain = (
        as_rows([text_of(each, row) for each in table.columns] for row in rows)
        for text_of in (cell_text, plain_cell_text)
    )
    marked = tuple(
        (row, column)
        for row, values in enumerate(rows)
        for column, each in enumerate(table.columns)
        if each.is_marked is not None and each.is_marked(values)
    )
    return Table(title_text(table.title), tuple(columns), cells, plain, marked=marked)


def _plain_title(title: str, column: ResultColumn[Row]) -> str:
    """Title of a column in one line, with its unit also if only the title of the table has it."""
    line = title.replace("\n", " ")
    unit = unit_text(column.format.title_unit) if isinstance(column.format, Format) else ""
    return f"{line} ({unit})" if unit and f"({unit})" not in line else line


def with_rows_below(table: Table, other: Table) -> Table:
    """Table with the rows of another table with the same columns at its end."""
    return replace(
        table, rows=table.rows + other.rows, plain_rows=table.plain_rows + other.plain_rows
    )


def facts_table(title: str, facts: Sequence[Fact]) -> Table:
    """Table of names and values without column titles."""
    return Table(
        title,
        (Column("", "left"), Column("", "left", wide=True)),
        tuple((fact.name, fact.text) for fact in facts),
        tuple((fact.name, fact.plain_text) for fact in facts),
    )


def form_table(title: str, facts: Sequence[Fact]) -> Table:
    """Table of names and values as a form: a line to fill in by hand for each empty value."""
    return replace(facts_table(title, facts), form=True)


@dataclass(frozen=True)
class Picture:
    """An image with its caption.

    Attributes
    ----------
    caption, data, suffix
    width : share of the width of the text
    tallest : largest height on the page, millimetres
    """

    caption: str
    data: bytes
    suffix: str
    width: float = 1.0
    tallest: float = 215.0
    kind: str = "picture"


@dataclass(frozen=True)
class SignatureLines:
    """Lines to be filled in by hand, three a row, except those whose ``values`` are known."""

    fields: tuple[str, ...]
    values: tuple[str, ...]
    kind: str = "signature"


@dataclass(frozen=True)
class UndrawnPictures:
    """Pictures that ``draw`` creates from ``values`` later, in the language in use.

    Attributes
    ----------
    width : share of the width of the text
    """

    caption: str
    draw: Callable[..., Any]
    values: tuple[object, ...]
    width: float = 1.0
    kind: str = "drawing"


@dataclass(frozen=True)
class PictureRow:
    """Pictures side by side, equally wide.

    Attributes
    ----------
    pictures
    columns : smallest number of columns; fewer pictures leave the others empty
    tallest : largest height of a picture on the page, millimetres
    """

    pictures: tuple[Picture | UndrawnPictures, ...]
    columns: int = 1
    tallest: float = 215.0
    kind: str = "pictures"


@dataclass(frozen=True)
class Group:
    """Blocks that are on one page."""

    blocks: tuple["Block", ...]
    kind: str = "group"


Block = (
    Paragraph | Bullets | Table | Picture | UndrawnPictures | PictureRow | SignatureLines | Group
)


@dataclass(frozen=True)
class PageTexts:
    """Footer texts, and titles of the parts that are not in a section."""

    made: str = "Created {when} with {program}"
    page: str = "Page {page} of {pages}"
    warnings: str = "Errors and warnings"
    notes: str = "Notes"
    contents: str = "Contents"


@dataclass(frozen=True)
class Section:
    """A numbered part of the report."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Letterhead:
    """Letterhead of a company on page one: logo and name above the title, text below the title."""

    logo: Picture | None = None
    company: str = ""
    heading: str = ""


NO_LETTERHEAD = Letterhead()


@dataclass(frozen=True)
class Document:
    """Complete report.

    Page one has ``identity``, ``warnings``, ``summary``, ``conclusion`` and ``notes`` in this
    order; the conclusion is the closing text and the signatures. ``header`` has the texts at the
    left and at the right of the top of each further page. ``furniture`` has the texts that do not
    depend on the project.
    """

    title: str
    project: str
    program: str
    generated: str
    status: Status
    verdict: str
    identity: Table
    warnings: tuple[str, ...]
    summary: tuple[Block, ...]
    conclusion: tuple[Block, ...]
    notes: tuple[str, ...]
    sections: tuple[Section, ...]
    page: Page = "a4"
    letterhead: Letterhead = NO_LETTERHEAD
    language: str = "en"
    extent: Extent = "full"
    header: tuple[str, str] = ("", "")
    furniture: PageTexts = PageTexts()
