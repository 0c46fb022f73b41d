"""What the program says in other languages: one folder of Qt Linguist files for each.

``resources/i18n/fr/*.ts`` pair each English text with its translation, ``language.toml`` beside
them holds what is true of all. Placeholders stand for what changes:
``{target} is the only target``. A kind after the colon says what may stand there:

- ``{x}``: a text that is translated itself, or a name of the project
- ``{x:kept}``: anything, and it stays as it is
- ``{x:name}``: a name of the project and nothing else
- ``{x:n}``: a number
- ``{x:list}``: texts as in a sentence: a, b and c
- ``{x:either}``: the same of a choice: a or b
- ``{x:codes}``: words of options to choose from, which stay: a or b
- ``{x:foreign}``: words of another program, which stay unless they are known themselves
- ``{x:file}``: a file or folder, and it stays as it is; where a sentence begins with it, ``:``
  or ``,`` after it, the sentence is also known without it, as it stands beside a file's name
"""

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import chain
from pathlib import Path
from xml.etree import ElementTree

from lispac.errors import InputError
from lispac.installed import resource
from lispac.language import LANGUAGES, Plural, in_language, raw_text
from lispac.message_texts import adjustment, checking, program, targets

_NUMBER = r"[+\-\u2212\u00b1]?\d(?:[\d,]*\d)?(?:\.\d+)?(?:e[+-]?\d+)?"
_PLACE = re.compile(r"\{(\w+)(?::(\w+))?\}")
_PLAIN = re.compile(r"[^.:;{}]*(?:, | and | or )[^.:;{}]*")
MOST_PARTING = 60
"""Letters of a text that may be one of a list though it looks like a list itself."""
_KINDS = frozenset({"", "kept", "name", "n", "list", "either", "codes", "foreign", "file"})
_ABOUT_FILE = re.compile(r"\{(\w+):file\}[:,] ")


@dataclass(frozen=True)
class Template:
    """An English text with places, and its translation."""

    english: str
    translation: str

    def __post_init__(self) -> None:
        names = [name for name, _ in self.places]
        asked = {name for name, _ in _PLACE.findall(self.translation)}
        if len(set(names)) < len(names) or asked != set(names):
            raise ValueError(f"The places of {self.english!r} and its translation differ.")
        if not {kind for _, kind in self.places} <= _KINDS:
            raise ValueError(f"{self.english!r} has a place of no known kind.")

    @cached_property
    def places(self) -> tuple[tuple[str, str], ...]:
        """Name and kind of each place."""
        return tuple(_PLACE.findall(self.english))

    @cached_property
    def literals(self) -> tuple[str, ...]:
        """What stands around the places, the longest first."""
        parts = _PLACE.sub("\0", self.english).split("\0")
        return tuple(sorted((part for part in parts if part), key=len, reverse=True))

    def matches(self, text: str) -> Iterator[tuple[str, ...]]:
        """What a text has in the places; where names hold literals, there are two ways."""
        found = self._shortest.fullmatch(text)
        if found is not None:
            yield found.groups()
            other = self._longest.fullmatch(text) if len(self.places) > 1 else None
            if other is not None and other.groups() != found.groups():
                yield other.groups()

    @cached_property
    def _shortest(self) -> re.Pattern[str]:
        return self._pattern("(.+?)")

    @cached_property
    def _longest(self) -> re.Pattern[str]:
        return self._pattern("(.+)")

    def _pattern(self, anything: str) -> re.Pattern[str]:
        """Of a whole text; a blank matches a fixed one as well."""
        found, end = [], 0
        for place in _PLACE.finditer(self.english):
            found.append(_escaped(self.english[end : place.start()]))
            found.append(f"({_NUMBER})" if place.group(2) == "n" else anything)
            end = place.end()
        return re.compile("".join(found) + _escaped(self.english[end:]), re.DOTALL)

    def filled(self, values: Mapping[str, str]) -> str:
        """The translation with values in its places."""
        return _PLACE.sub(lambda place: values[place.group(1)], self.translation)


def _escaped(text: str) -> str:
    return re.escape(text).replace(r"\ ", "[ \u00a0]")


@dataclass(frozen=True)
class Catalogue:
    """The sentences of one language.

    Attributes
    ----------
    code : as that of the folder: ``fr``
    thousands : sign between groups of three digits
    decimal : sign before the decimals, where numbers are written as the language does
    conjunction : between the last two of a list
    alternative : between two of which one is true
    exact : translation by English text
    templates : the one with most letters first
    """

    code: str
    thousands: str
    decimal: str
    conjunction: str
    alternative: str
    exact: Mapping[str, str]
    templates: tuple[Template, ...]

    @cached_property
    def parting(self) -> tuple[str, ...]:
        """Short texts that look like a list: ``latitude and longitude (or ...)``."""
        return tuple(
            text for text in self.exact
            if len(text) < MOST_PARTING and _PLAIN.fullmatch(text)
        )  # fmt: skip


@lru_cache
def catalogue_of(code: str) -> Catalogue:
    """The sentences of a language.

    Raises
    ------
    InputError
        Where there are none.
    """
    if code not in LANGUAGES:
        raise InputError(
            f"There is no translation into {code!r}; choose one of {', '.join(LANGUAGES)}."
        )
    if code == "en":
        return Catalogue("en", ",", ".", "and", "or", {}, ())
    folder = resource(f"i18n/{code}")
    rules = (folder / "language.toml").read_text(encoding="utf-8")
    files = sorted(folder.glob("*.ts"))
    texts = dict(of_messages(code))
    texts |= dict(chain.from_iterable(map(messages, files)))
    return made(code, rules, texts.items())


KEPT_IN_PROJECTS = (adjustment, checking, program, targets)
"""Topics of messages whose texts projects keep, as reasons why something is missing."""
FEWEST_LETTERS = 20
"""Characters besides its places of a template with names: shorter ones fit everything."""
_KIND_OF_SPECIFICATION = {"": "", "names": "list", "choices": "either"}
_SPECIFIED = re.compile(r"\{(\w+)(?::([^}]*))?\}")


def of_messages(code: str) -> Iterator[tuple[str, str]]:
    """Texts of messages: projects keep some of them in English without their codes."""
    pairs = []
    texts = (text for topic in KEPT_IN_PROJECTS for text in topic.TEXTS.values())
    with in_language(code):
        for text in texts:
            if isinstance(text, Plural):
                pairs.append((text.plural, raw_text(text, {"count": 2})))
                pairs.append((text.singular, raw_text(text, {"count": 1})))
            else:
                pairs.append((text, raw_text(text, {})))
    for english, translation in pairs:
        names = [name for name, _ in _SPECIFIED.findall(english)]
        said = [name for name, _ in _SPECIFIED.findall(translation)]
        template = _SPECIFIED.sub(_place_of, english)
        is_distinct = len(_PLACE.sub("", template)) >= FEWEST_LETTERS or all(
            kind == "n" for _, kind in _PLACE.findall(template)
        )
        # A template has each place once, and the same in both languages.
        if is_distinct and len(set(names)) == len(names) and set(names) == set(said):
            yield (
                template,
                _SPECIFIED.sub(lambda found: f"{{{found.group(1)}}}", translation),
            )


def _place_of(found: re.Match[str]) -> str:
    name, specification = found.group(1), found.group(2) or ""
    kind = _KIND_OF_SPECIFICATION.get(specification, "n")
    return f"{{{name}:{kind}}}" if kind else f"{{{name}}}"


def messages(file: Path) -> Iterator[tuple[str, str]]:
    """English text and translation of each message of a Qt Linguist file, as far as it has one."""
    for message in ElementTree.parse(file).iter("message"):
        said = message.find("translation")
        if said is not None and said.text and said.get("type") not in _GIVEN_UP:
            yield message.findtext("source", ""), said.text


_GIVEN_UP = ("obsolete", "vanished")


def without_file(english: str, translation: str) -> tuple[str, str] | None:
    """Text and translation as they stand beside the name of the file they begin with."""
    found = _ABOUT_FILE.match(english)
    if found is None or not _PLACE.sub("", english[found.end() :]):
        return None
    said = re.sub(rf"\{{{found.group(1)}\}}[\u00a0 ]?[:,] ", "", translation, count=1)
    return _capital(english[found.end() :]), _capital(said)


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]


def made(code: str, rules: str, pairs: Iterable[tuple[str, str]]) -> Catalogue:
    """The catalogue of a language from its rules (TOML) and its texts, in any order.

    Raises
    ------
    ValueError
        Where a text stands twice.
    """
    tables = tomllib.loads(rules)
    language = tables["language"]
    typography = [(re.compile(rule), by) for rule, by in tables["typography"].items()]
    exact: dict[str, str] = {}
    for english, translation in pairs:
        if english in exact:
            raise ValueError(f"{english!r} stands twice.")
        for rule, by in typography:
            translation = rule.sub(by, translation)
        exact[english] = translation
    for english, translation in tuple(exact.items()):
        bare = without_file(english, translation)
        if bare is not None:
            exact.setdefault(*bare)
    templates = [Template(english, said) for english, said in exact.items() if "{" in english]
    templates.sort(key=lambda each: -sum(map(len, each.literals)))
    return Catalogue(
        code, language["thousands"], language["decimal"], language["conjunction"],
        language["alternative"], exact, tuple(templates),
    )  # fmt: skip
