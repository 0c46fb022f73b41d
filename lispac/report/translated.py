"""The finished report in its language: its figures are drawn, its texts translated."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from lispac.report.blocks import (
    Block,
    Bullets,
    Document,
    Drawing,
    Furniture,
    Paragraph,
    Picture,
    Section,
    Signature,
    Table,
)
from lispac.report.values import ReportContent
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.translation import Translator

POINT = "Numbers are written with a decimal point, as other programs take them, except in warnings."


def translator(content: ReportContent, language: str) -> Translator:
    """Says what a report says in a language, and leaves the names of its content alone."""
    return Translator(catalogue_of(language), names_of(content))


def names_of(content: ReportContent) -> Iterator[str]:
    """What people or files are called by, and no language changes."""
    yield from (content.project, content.program)
    yield from (plane.name for plane in content.planes)
    yield from (plane.name for plane in content.validation)
    for line in content.lines:
        yield from (line.name, line.file)
    yield from (file.name for file in content.files)
    if content.absolute is not None:
        yield from (point.name for point in content.absolute.points)
    if content.adjustment is not None:
        for sighting in content.adjustment.sightings:
            yield from (sighting.target, sighting.line)


def drawn(document: Document, say: Translator) -> Document:
    """The document with its figures drawn in the translator's language."""
    return replace(
        document,
        summary=_drawn(document.summary, say),
        sections=tuple(
            Section(section.title, _drawn(section.blocks, say)) for section in document.sections
        ),
    )


def _drawn(blocks: Iterable[Block], say: Translator) -> tuple[Block, ...]:
    from lispac.report.figures import pictures_of

    made: list[Block] = []
    for block in blocks:
        if isinstance(block, Drawing):
            svgs = pictures_of(block.draw, *block.values, say=say)
            made += [Picture(block.caption, svg, ".svg", block.width) for svg in svgs]
        else:
            made.append(block)
    return tuple(made)


def translated(document: Document, say: Translator) -> Document:
    """The document in the translator's language; how much of it stayed English is a remark."""
    summary = tuple(_block(block, say) for block in document.summary)
    sections = tuple(
        Section(say(section.title), tuple(_block(block, say) for block in section.blocks))
        for section in document.sections
    )
    made = replace(
        document,
        title=say(document.title),
        verdict=say(document.verdict),
        serious=tuple(map(say, document.serious)),
        cautions=tuple(map(say, document.cautions)),
        identity=said(document.identity, say),
        summary=_with_point(summary, say),
        sections=sections,
        language=say.catalogue.code,
        furniture=_furniture(document.furniture, say),
    )
    if not say.unknown:
        return made
    return replace(made, cautions=(*made.cautions, say(_left(len(say.unknown)))))


def _with_point(summary: tuple[Block, ...], say: Translator) -> tuple[Block, ...]:
    """What is said of numbers goes before the user's own words and the signature."""
    ends = (k for k, block in enumerate(summary) if getattr(block, "own", False))
    at = next(ends, len(summary) - 1)
    return (*summary[:at], Paragraph(say(POINT)), *summary[at:])


def _left(count: int) -> str:
    if count == 1:
        return "1 text of this report stands in English: its translation is not known."
    return f"{count} texts of this report stand in English: their translation is not known."


def _furniture(words: Furniture, say: Translator) -> Furniture:
    return Furniture(*(say(word) for word in vars(words).values()))


def _block(block: Block, say: Translator) -> Block:
    match block:
        case Paragraph():
            return block if block.own else Paragraph(say(block.text))
        case Bullets():
            return Bullets(tuple(map(say, block.items)))
        case Table():
            return said(block, say)
        case Picture() | Drawing():
            return replace(block, caption=say(block.caption))
        case Signature():
            return replace(block, fields=tuple(map(say, block.fields)))


def said(table: Table, say: Translator) -> Table:
    """The table in the translator's language; what the user typed into a form stays."""
    columns = tuple(replace(column, title=say(column.title)) for column in table.columns)
    rows = tuple(
        tuple(
            cell if column.code or (table.form and k > 0) else say.cell(cell)
            for k, (column, cell) in enumerate(zip(table.columns, row, strict=True))
        )
        for row in table.rows
    )
    return replace(table, title=say(table.title), columns=columns, rows=rows)
