"""Texts of a report's content that other parts of the program make in English, translated."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TypeVar

from lispac.adjustment.shown import capitalised
from lispac.report.budget_values import Budget
from lispac.report.convention_values import InConvention
from lispac.report.values import Adjustment, ReportContent
from lispac.report.wording import HYPHEN, MINUS, with_minus
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.messages import translated_text
from lispac.reverse_translation.translation import Translator

FACTORS = " · "
"""Between the rotations of a formula."""

Say = Callable[[str], str]
Part = TypeVar("Part")


def translator(content: ReportContent, language: str) -> Translator:
    """Translates English sentences of a content, and leaves its names as they are."""
    return Translator(catalogue_of(language), names_of(content), spoken_numbers=True)


def names_of(content: ReportContent) -> Iterator[str]:
    """Names of targets, lines, files and the like, which are the same in every language."""
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


def warnings_and_notes(content: ReportContent, say: Say) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Texts of the warnings, and of the notes."""
    names = tuple(name for name in names_of(content) if HYPHEN.search(name))
    serious, notes = (
        tuple(
            with_minus(translated_text(each, say), names)
            for each in content.cautions
            if each.is_serious == wanted
        )
        for wanted in (True, False)
    )
    return serious, notes


def translated(content: ReportContent, say: Say) -> ReportContent:
    """The content with its English sentences translated; numbers, names and codes stay."""
    return replace(
        content,
        adjustment=_if_known(content.adjustment, lambda found: _adjustment(found, say)),
        notes=tuple(map(say, content.notes)),
        qualities=tuple(
            replace(each, reasons=tuple(map(say, each.reasons))) for each in content.qualities
        ),
        in_convention=_if_known(content.in_convention, lambda found: _convention(found, say)),
        matrix=_if_known(
            content.matrix,
            lambda found: replace(found, body_axes=tuple(map(say, found.body_axes))),
        ),
        budget=_if_known(content.budget, lambda found: _budget(found, say)),
    )


def _if_known(found: Part | None, change: Callable[[Part], Part]) -> Part | None:
    return None if found is None else change(found)


def _adjustment(found: Adjustment, say: Say) -> Adjustment:
    return replace(found, rotation_in_words=say(found.rotation_in_words))


def _convention(found: InConvention, say: Say) -> InConvention:
    if not found.angles:
        found = replace(found, formula="")  # it is a matrix only, which the section says
    return replace(
        found,
        status_in_words=say(found.status_in_words),
        source=say(found.source),
        assumption=say(found.assumption),
        check_first=say(found.check_first),
        angles=tuple(
            replace(each, name=say(capitalised(each.name)), meaning=say(each.meaning))
            for each in found.angles
        ),
        note=say(found.note),
        caution=say(found.caution),
        formula=FACTORS.join(map(say, found.formula.replace("-", MINUS).split(FACTORS))),
        body_axes=tuple(map(say, found.body_axes)),
        scanner_in_words=say(found.scanner_in_words),
        offsets_in_words=say(found.offsets_in_words),
    )


def _budget(found: Budget, say: Say) -> Budget:
    return replace(
        found,
        beams=tuple(
            replace(
                each,
                beam=say(each.beam),
                sources=tuple(
                    replace(source, source=say(source.source)) for source in each.sources
                ),
                before=replace(each.before, source=say(each.before.source)),
                after=replace(each.after, source=say(each.after.source)),
            )
            for each in found.beams
        ),
        in_words=tuple(map(say, found.in_words)),
    )
