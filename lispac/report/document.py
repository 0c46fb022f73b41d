"""The report in words, the same for every kind of file it is written to."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from lispac.errors import InputError
from lispac.language import in_language
from lispac.messages import error
from lispac.report import sections
from lispac.report.absolute_section import absolute
from lispac.report.blocks import (
    Block,
    Document,
    Letterhead,
    Paragraph,
    Picture,
    Section,
    Status,
)
from lispac.report.boresight_section import boresight
from lispac.report.checks_section import cross_checks, reliability
from lispac.report.convention_section import other_programs
from lispac.report.identity_section import identity, signature
from lispac.report.opinion_section import second_opinions
from lispac.report.options import USUAL, ReportOptions
from lispac.report.quality_section import quality_of_sightings
from lispac.report.settings_section import settings
from lispac.report.standards_section import standards
from lispac.report.translated import drawn, translated, translator
from lispac.report.validation_section import validation
from lispac.report.values import ReportContent
from lispac.report.wording import moment
from lispac.reverse_translation.messages import translated_text

TWO_ON_A_PAGE = 92.0
"""Height of a picture, mm, of which two with their captions fit on the smaller page."""


def document_of(
    content: ReportContent, pictures: Mapping[str, Path], options: ReportOptions = USUAL
) -> Document:
    """Put a report's content into words.

    Parameters
    ----------
    pictures : file of a PNG or SVG picture by its caption
    options : its language, page and letterhead; the convention is a matter of the content

    Raises
    ------
    InputError
        Where a picture or the logo cannot be read, or there is no report in this language.
    """
    say = translator(content, options.language)
    with in_language(options.language):
        document = drawn(in_english(content, pictures, options, say), say)
        return document if options.language == "en" else translated(document, say)


def in_english(
    content: ReportContent,
    pictures: Mapping[str, Path],
    options: ReportOptions = USUAL,
    say: Callable[[str], str] = str,
) -> Document:
    """The report as it is made, its figures not drawn yet; messages are in the language in use.

    Parameters
    ----------
    say : translates English sentences within messages
    """
    serious = tuple(translated_text(each, say) for each in content.cautions if each.is_serious)
    status, verdict = _verdict(content, bool(serious))
    parts = [
        _section("Boresight and its uncertainty", boresight(content)),
        _section("Uncertainty in standard terms", standards(content)),
        _section("Values for other programs", other_programs(content)),
        _section("Targets and residuals", sections.residuals(content)),
        _section("Quality of the sightings", quality_of_sightings(content)),
        _section("Reliability of the sightings", reliability(content)),
        _section("Cross-checks", cross_checks(content)),
        _section("Validation", validation(content)),
        _section("Alternative methods", second_opinions(content)),
        _section("Absolute check", absolute(content)),
        _section("Site and lines", sections.site(content)),
        _section("Settings and input files", settings(content)),
        _section("Pictures", _views(pictures)),
    ]
    return Document(
        title="Boresight calibration report",
        project=content.project,
        program=content.program,
        generated=moment(content.generated),
        status=status,
        verdict=verdict,
        identity=identity(content),
        serious=serious,
        cautions=tuple(
            translated_text(each, say) for each in content.cautions if not each.is_serious
        ),
        summary=(
            *sections.summary(content),
            *(Paragraph(text, own=True) for text in options.closing.split("\n\n") if text),
            signature(content),
        ),
        sections=tuple(section for section in parts if section.blocks),
        page=options.page,
        letterhead=Letterhead(
            None if options.logo is None else _picture("", options.logo),
            options.company,
            options.heading,
        ),
    )


def _verdict(content: ReportContent, serious: bool) -> tuple[Status, str]:
    if not content.calibrated:
        return "bad", "NOT CALIBRATED"
    if serious:
        return "bad", "CALIBRATED WITH SERIOUS WARNINGS"
    if content.cautions:
        return "fair", "CALIBRATED, WITH REMARKS"
    return "good", "CALIBRATED"


def _views(pictures: Mapping[str, Path]) -> list[Picture]:
    """Before and after are compared: both on one page."""
    tallest = TWO_ON_A_PAGE if len(pictures) > 1 else Picture.tallest
    return [replace(_picture(*each), tallest=tallest) for each in pictures.items()]


def _picture(caption: str, path: Path) -> Picture:
    suffix = path.suffix.lower()
    if suffix not in (".png", ".svg"):
        raise InputError(error("report.picture_format", file=str(path)))
    try:
        return Picture(caption, path.read_bytes(), suffix)
    except OSError as failure:
        reason = failure.strerror or str(failure)
        raise InputError(
            error("report.picture_unreadable", file=str(path), reason=reason)
        ) from failure


def _section(title: str, blocks: Sequence[Block]) -> Section:
    return Section(title, tuple(blocks))
