"""Texts, tables and figures of a report, the same for PDF, HTML and CSV files."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from lispac.errors import InputError, system_reason
from lispac.identity import FIELD_LABELS, TITLE_FIELDS
from lispac.language import LazyText, gettext, in_language, without_advice
from lispac.message_texts import CAUSE_PREFIX, message_text
from lispac.messages import Message, error
from lispac.present.checking.acceptance import verdict_scope_text
from lispac.present.text_format import MINUS_PATTERN, time_text, with_minus_signs
from lispac.report import sections, short_report
from lispac.report.boresight_section import boresight_blocks, convention_blocks
from lispac.report.checks_section import (
    control_blocks,
    cross_check_blocks,
    method_blocks,
    reliability_blocks,
)
from lispac.report.document_blocks import (
    Block,
    Document,
    Group,
    Letterhead,
    PageTexts,
    Paragraph,
    Picture,
    PictureRow,
    Section,
    Status,
    UndrawnPictures,
)
from lispac.report.options import DEFAULT_OPTIONS, ReportOptions
from lispac.report.report_values import ReportContent
from lispac.report.sections import identity_form, quality_blocks, settings_blocks
from lispac.report.validation_section import (
    absolute_check_blocks,
    standards_blocks,
    validation_blocks,
)


def report_document(
    content: ReportContent,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
) -> Document:
    """The texts, tables and figures of a report.

    Parameters
    ----------
    pictures : file of a PNG or SVG picture by its caption
    options : language, page, letterhead and closing text; the convention is already part of the
        content

    Raises
    ------
    InputError
        If a picture or the logo cannot be read.
    ValueError
        If there is no such language.
    """
    with in_language(options.language):
        return drawn_document(undrawn_document(content, pictures, options))


@without_advice()
def undrawn_document(
    content: ReportContent,
    pictures: Mapping[str | LazyText, Path],
    options: ReportOptions = DEFAULT_OPTIONS,
) -> Document:
    """Report in the language in use, with figures that `drawn_document` draws later."""
    serious, notes = (_message_texts(content, each) for each in _page_one_messages(content))
    status, verdict = _status_text(content)
    closing = [Paragraph(text) for text in options.closing.split("\n\n") if text]
    views = [_make_picture(*each) for each in pictures.items()]
    summary: list[Block]
    if options.extent == "short":
        notes = short_report.shortened_notes(notes)
        summary = short_report.summary_blocks(content)
        parts = short_report.short_sections(content, views)
    else:
        summary = sections.summary_blocks(content)
        parts = _full_sections(content, views)
    letterhead = options.company or content.identity.company
    return Document(
        title=gettext("Boresight calibration report"),
        project=_subject_text(content),
        program=content.program,
        generated=time_text(content.generated),
        status=status,
        verdict=verdict,
        identity=identity_form(content, letterhead, blank=options.extent == "full"),
        warnings=serious,
        summary=tuple(summary),
        conclusion=(*closing, sections.signature_lines(content)),
        notes=notes,
        sections=tuple(section for section in parts if section.blocks),
        page=options.page,
        letterhead=Letterhead(
            None if options.logo is None else _make_picture("", options.logo),
            letterhead,
            options.heading,
        ),
        language=options.language,
        extent=options.extent,
        header=_header_texts(content),
        furniture=PageTexts(
            made=gettext("Created {when} with {program}"),
            page=gettext("Page {page} of {pages}"),
            warnings=gettext("Errors and warnings"),
            notes=gettext("Notes"),
            contents=gettext("Contents"),
        ),
    )


def _full_sections(content: ReportContent, views: Sequence[Picture]) -> list[Section]:
    return [
        _make_section(gettext("Boresight and its uncertainty"), boresight_blocks(content)),
        _make_section(
            gettext("Uncertainty in standard terms (IHO S-44, USGS)"), standards_blocks(content)
        ),
        _make_section(gettext("Values for other programs"), convention_blocks(content)),
        _make_section(gettext("Targets and residuals"), sections.residual_blocks(content)),
        _make_section(gettext("Quality of the sightings"), quality_blocks(content)),
        _make_section(gettext("Reliability of the sightings"), reliability_blocks(content)),
        _make_section(gettext("Cross-checks"), cross_check_blocks(content)),
        _make_section(gettext("Surveyed control"), control_blocks(content)),
        _make_section(gettext("Validation"), validation_blocks(content)),
        _make_section(gettext("Alternative methods"), method_blocks(content)),
        _make_section(gettext("Check against the reference"), absolute_check_blocks(content)),
        _make_section(gettext("Site and lines"), sections.site_blocks(content)),
        _make_section(gettext("Settings and input files"), settings_blocks(content)),
        _make_section(gettext("Pictures"), _view_pictures(content, views)),
    ]


def _subject_text(content: ReportContent) -> str:
    """Vessel, site and project, below the title; the project only if its name differs."""
    fields = {name: getattr(content.identity, name) for name in TITLE_FIELDS}
    known = [
        gettext("{label}: {text}", label=gettext(FIELD_LABELS[name]), text=text)
        for name, text in fields.items()
        if text
    ]
    return " · ".join(known if content.project in fields.values() else (*known, content.project))


def _header_texts(content: ReportContent) -> tuple[str, str]:
    """Report and revision, and project, vessel and company, at the top of each further page."""
    known = content.identity
    title = gettext("Boresight calibration report")
    if known.report_number:
        title = f"{title} {known.report_number}"
    if known.revision:
        revision = gettext("revision {revision}", revision=known.revision)
        title = f"{title}, {revision}"
    names = dict.fromkeys((content.project, known.vessel, known.company))
    return title, " · ".join(name for name in names if name)


def _page_one_messages(content: ReportContent) -> tuple[list[Message], list[Message]]:
    """Errors and warnings, with the causes below the criteria that are not met, and notes."""
    causes = [each for each in content.warnings if each.code.startswith(CAUSE_PREFIX)]
    serious: list[Message] = []
    for message in content.warnings:
        if message.is_serious:
            serious.append(message)
        if message.code == "acceptance.not_met":
            serious += causes
    notes = [each for each in content.warnings if each not in serious]
    return serious, notes


def _message_texts(content: ReportContent, messages: Sequence[Message]) -> tuple[str, ...]:
    """Texts of messages, with minus signs instead of hyphens."""
    names = tuple(name for name in _proper_names(content) if MINUS_PATTERN.search(name))
    return tuple(with_minus_signs(message_text(each), names) for each in messages)


def _proper_names(content: ReportContent) -> Iterator[str]:
    """Names of project, targets, lines and files; their hyphens are no minus signs."""
    yield from (content.project, content.program)
    yield from (plane.name for plane in content.planes)
    yield from (plane.name for plane in content.validation)
    for line in content.lines:
        yield from (line.name, line.file)
    yield from (file.name for file in content.files)
    if content.absolute is not None:
        yield from (point.name for point in content.absolute.points)
    yield from (point.name for point in content.control.points)
    yield from (file.file for file in content.control.files)
    if content.adjustment is not None:
        for sighting in content.adjustment.sightings:
            yield from (sighting.target, sighting.line)


def drawn_document(document: Document) -> Document:
    """Copy of a document with its figures drawn in the language in use."""
    return replace(
        document,
        summary=_draw_pictures(document.summary),
        sections=tuple(
            Section(section.title, _draw_pictures(section.blocks)) for section in document.sections
        ),
    )


def _draw_pictures(blocks: Iterable[Block]) -> tuple[Block, ...]:
    from lispac.report.figures import svg_pictures

    def drawn(block: UndrawnPictures) -> list[Picture]:
        svgs = svg_pictures(block.draw, *block.values)
        captions = [block.caption] * len(svgs)
        if len(svgs) > 1:
            captions = [
                gettext(
                    "{caption} Part {part:n} of {count:n}.",
                    caption=block.caption, part=k + 1, count=len(svgs),
                )
                for k in range(len(svgs))
            ]  # fmt: skip
        return [
            Picture(caption, svg, ".svg", block.width)
            for caption, svg in zip(captions, svgs, strict=True)
        ]

    made: list[Block] = []
    for block in blocks:
        if isinstance(block, UndrawnPictures):
            made += drawn(block)
        elif isinstance(block, Group):
            made.append(Group(_draw_pictures(block.blocks)))
        elif isinstance(block, PictureRow):
            pictures = tuple(
                picture
                for each in block.pictures
                for picture in ([each] if isinstance(each, Picture) else drawn(each))
            )
            made.append(replace(block, pictures=pictures))
        else:
            made.append(block)
    return tuple(made)


def _status_text(content: ReportContent) -> tuple[Status, str]:
    """Colour and text of the verdict: the state of the calibration, and its acceptance."""
    if not content.calibrated:
        return "bad", gettext("NOT CALIBRATED")
    status: Status
    if any(each.is_serious for each in content.warnings):
        status, text = "bad", gettext("CALIBRATED, WITH WARNINGS")
    elif content.warnings:
        status, text = "good", gettext("CALIBRATED, WITH NOTES")
    else:
        status, text = "good", gettext("CALIBRATED")
    verdict = content.acceptance.verdict
    if verdict == "fail":
        return "bad", gettext("NOT ACCEPTED: ACCEPTANCE CRITERIA NOT MET")
    if verdict == "pass":
        text = gettext("{calibrated} – ACCEPTANCE CRITERIA MET", calibrated=text)
        if content.acceptance.excluded_planes and status == "good":
            status = "fair"  # an excluded plane may be one that failed
        scope = verdict_scope_text(content.acceptance).upper()
        return status, gettext("{verdict} ({given})", verdict=text, given=scope) if scope else text
    # Without a verdict, green would look like a pass.
    status = "fair" if status == "good" else status
    if not content.validation:
        return status, gettext("{calibrated} – NOT VALIDATED", calibrated=text)
    return status, gettext("{calibrated} – ACCEPTANCE NOT JUDGED", calibrated=text)


VIEW_HEIGHT_MM = 57.0
"""Largest height of a view; three rows of views fit on a page."""


def _view_pictures(content: ReportContent, views: Sequence[Picture]) -> list[Block]:
    """Pictures of the 3D view with their captions: before and after side by side."""
    rows = [tuple(views[k : k + 2]) for k in range(0, len(views), 2)]
    legend = [sections.line_colours_paragraph(content)] if views else []
    return [*legend, *(PictureRow(row, tallest=VIEW_HEIGHT_MM) for row in rows)]


def _make_picture(caption: str | LazyText, path: Path) -> Picture:
    suffix = path.suffix.lower()
    if suffix not in (".png", ".svg"):
        raise InputError(error("report.picture_format", file=str(path)))
    text = gettext(caption) if isinstance(caption, str) else str(caption)
    try:
        return Picture(text, path.read_bytes(), suffix)
    except OSError as failure:
        reason = system_reason(failure)
        raise InputError(
            error("report.picture_unreadable", file=str(path), reason=reason)
        ) from failure


def _make_section(title: str, blocks: Sequence[Block]) -> Section:
    return Section(title, tuple(blocks))
