"""Texts of a report's content that other parts of the program make in English, translated."""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import TypeVar

from lispac.report.absolute_values import Absolute
from lispac.report.opinion_values import MethodAnswer
from lispac.report.values import Adjustment, CrossChecked, ReportContent
from lispac.report.wording import MINUS
from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.messages import translated_text
from lispac.reverse_translation.translation import Translator

HYPHEN = re.compile(r"(?<![^\s(])-(?=\d)")
"""A hyphen before a number."""
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


def with_minus(text: str, names: Iterable[str] = ()) -> str:
    """The text of a message with true minus signs, as the tables have them; names stay."""
    whole = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    pattern = re.compile(f"{whole}|{HYPHEN.pattern}" if whole else HYPHEN.pattern)
    return pattern.sub(lambda found: MINUS if found.group() == "-" else found.group(), text)


def translated(content: ReportContent, say: Say) -> ReportContent:
    """The content with its English sentences translated; numbers, names and codes stay."""
    return replace(
        content,
        adjustment=_if_known(content.adjustment, lambda found: _adjustment(found, say)),
        cross_checks=_if_known(content.cross_checks, lambda found: _cross_checks(found, say)),
        validation=tuple(
            replace(plane, measured_to=say(plane.measured_to)) for plane in content.validation
        ),
        absolute=_if_known(content.absolute, lambda found: _absolute(found, say)),
        methods=tuple(_method(each, say) for each in content.methods),
        methods_in_words=tuple(map(say, content.methods_in_words)),
    )


def _if_known(found: Part | None, change: Callable[[Part], Part]) -> Part | None:
    return None if found is None else change(found)


def _adjustment(found: Adjustment, say: Say) -> Adjustment:
    seen = found.observability
    return replace(
        found,
        observability=_if_known(
            seen, lambda seen: replace(seen, in_words=tuple(map(say, seen.in_words)))
        ),
        parameters=tuple(replace(each, reason=say(each.reason)) for each in found.parameters),
        components=tuple(replace(each, in_words=say(each.in_words)) for each in found.components),
    )


def _cross_checks(found: CrossChecked, say: Say) -> CrossChecked:
    return replace(
        found, parts=tuple(replace(part, reason=say(part.reason)) for part in found.parts)
    )


def _absolute(found: Absolute, say: Say) -> Absolute:
    return replace(
        found,
        not_compared=tuple(map(say, found.not_compared)),
        in_words=tuple(map(say, found.in_words)),
    )


def _method(found: MethodAnswer, say: Say) -> MethodAnswer:
    return replace(found, remarks=tuple(map(say, found.remarks)))
