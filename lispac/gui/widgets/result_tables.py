"""Tables of results in the window, in the units and language of the user."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from datetime import date

from lispac.gui.appearance import units
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.diagnostics_table import (
    Cell,
    Column,
    Key,
    Row,
    number_cell,
    spreadsheet_number,
)
from lispac.language import degree_signs, gettext, short_date
from lispac.present.csv_text import csv_text
from lispac.present.tables import ARROW, Fact, Format, Table, Unit, cell_text, title_text
from lispac.present.tables import Column as ResultColumn
from lispac.present.tables import Row as ResultRow
from lispac.present.text_format import with_unit

BASE_OF_UNIT: Mapping[Unit, Base] = {"m": "m", "mm": "mm", "deg": "°", "mdeg": "m°"}


def window_columns(table: Table[ResultRow]) -> tuple[Column, ...]:
    """Columns of a table of results."""
    with degree_signs():
        return tuple(_window_column(each) for each in table.columns)


def _window_column(column: ResultColumn[ResultRow]) -> Column:
    title = title_text(column.title)
    tip = title_text(column.tip) or title
    if not column.unit:
        return Column(title, tip, column.is_text)
    base = BASE_OF_UNIT.get(column.unit)
    sign = column.unit if base is None else units.local_sign(base)
    return Column(f"{title} ({sign})", tip, column.is_text, base)


def window_rows(
    table: Table[ResultRow],
    rows: Iterable[ResultRow],
    *,
    key: Callable[[ResultRow], Key | None] = lambda row: None,
    marked: Callable[[ResultRow], bool] = lambda row: False,
    tip: Callable[[ResultRow], str] = lambda row: "",
    current: Callable[[ResultRow], bool] = lambda row: False,
) -> list[Row]:
    """Rows of a table of results, with their target and line, marks and tooltips."""
    return [
        Row(
            [_cell(column, row) for column in table.columns], key(row), marked(row), tip(row),
            current=current(row),
        )
        for row in rows
    ]  # fmt: skip


def _cell(column: ResultColumn[ResultRow], row: ResultRow) -> Cell:
    value, form = column.value_of(row), column.format_of(row)
    if value is None:
        return Cell(column.unknown_text())
    if form is None:
        return Cell(str(value), shown=short_date(value) if isinstance(value, date) else "")
    if column.has_unit_in_cells:
        return Cell(local_amount(value, form), value)
    before, sigma = column.before_of(row), column.sigma_of(row)
    if before is not None:
        text = f"{local_number(before, form)} {ARROW} {local_number(value, form)}"
        return Cell(text, value)
    if sigma is not None:
        text = gettext(
            "{error} (σ {sigma})", error=local_number(value, form), sigma=local_number(sigma, form)
        )
        return Cell(text, value)
    if form.unit not in BASE_OF_UNIT:
        return Cell(form.text(value), value)
    return number_cell(value, _python_form(form), form.factor)


def local_cell_text(column: ResultColumn[ResultRow], row: ResultRow) -> str:
    """Text of a cell in the units and the language of the user."""
    value, form, cell = column.value_of(row), column.format_of(row), _cell(column, row)
    return cell.text if cell.figure is None or form is None else local_number(value, form)


def spreadsheet_text(table: Table[ResultRow], rows: Iterable[ResultRow]) -> str:
    """Table of results in standard units as text for a spreadsheet in the user's language."""
    columns = [_without_groups(column) for column in table.columns]
    heads = [title_text(column.title) for column in columns]
    cells = [[cell_text(column, row) for column in columns] for row in rows]
    return csv_text(
        ([spreadsheet_number(cell) for cell in row] for row in (heads, *cells)),
        separator="\t", line_end="\n",
    )  # fmt: skip


def _without_groups(column: ResultColumn[ResultRow]) -> ResultColumn[ResultRow]:
    if isinstance(column.format, Format):
        return replace(column, format=replace(column.format, is_grouped=False))
    return column


def _python_form(form: Format) -> str:
    sign, group = "+" if form.is_signed else "", "," if form.is_grouped else ""
    return f"{sign}{group}.{form.decimals}f"


def _fitted(value: float, form: Format) -> Format:
    """Format of this value: half an interval is not written as zero."""
    return form.nonzero(value) if form.is_half_interval else form


def local_number(value: float, form: Format) -> str:
    """The number in the unit and the language of the user, without its unit."""
    base = BASE_OF_UNIT.get(form.unit)
    if base is None:
        return form.text(value)
    return units.local_figure(form.factor * value, base, _python_form(_fitted(value, form)))


def fact_text(fact: Fact) -> str:
    """Value of a fact with its unit, in the unit and the language of the user."""
    if fact.value is None or isinstance(fact.value, str) or not fact.format.unit:
        return fact.text
    return local_amount(fact.value, fact.format)


def local_amount(value: float, form: Format) -> str:
    """The number with its unit, in the unit and the language of the user."""
    base = BASE_OF_UNIT.get(form.unit)
    if base is None:
        return with_unit(form.text(value), form.unit)
    return units.local_amount(form.factor * value, base, _python_form(_fitted(value, form)))


def html_table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Table as rich text; the cells are rich text too."""
    lines = [[f"<b>{head}</b>" if head else "" for head in heads], *rows]
    return "<table>" + "".join(map(_html_row, lines)) + "</table>"


def _html_row(cells: Iterable[str]) -> str:
    first, *others = cells
    numbers = "".join(f"<td align='right' style='padding-left:10px'>{each}</td>" for each in others)
    return f"<tr><td>{first}</td>{numbers}</tr>"
