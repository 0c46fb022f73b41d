"""A finished text in another language.

Texts are made in English all over the program, and some are kept in project files; what is
translated is therefore the finished text, where it is shown. One that the catalogue does not know
stays English, and is counted.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from lispac.language import is_translated
from lispac.reverse_translation.catalogue import Catalogue, Template

MOST_KEPT = 20_000
"""Texts remembered with what was said: a window shows new numbers all day long."""

Say = Callable[[str], str]
"""Says an English text in another language."""

_LETTER = re.compile(r"[^\W\d_]")
_THOUSANDS = re.compile(r"(?<=\d),(?=\d{3}(?!\d))")
_DECIMAL = re.compile(r"(?<=\d)\.(?=\d)")
_SENTENCE = re.compile(r"(?<=[.?!])[ \u00a0](?=[^\W_])")

_FILE = re.compile(r"(?!.*[:;] )(?=.*[./\\]).*", re.DOTALL)
_CLAUSE = re.compile(r"[.;:?!] ")


def unchanged(text: str) -> str:
    """The text as it is made, in English."""
    return text


@dataclass(frozen=True)
class _Said:
    """A text in the other language, and what of it is not."""

    text: str
    unknown: tuple[str, ...] = ()


class Translator:
    """Says English texts in another language.

    Parameters
    ----------
    catalogue : the language
    names : of targets, lines, files and the like, which stay as they are
    spoken_numbers : whether the decimal sign is the language's; else it stays a point, as other
        programs take it
    """

    def __init__(
        self, catalogue: Catalogue, names: Iterable[str] = (), *, spoken_numbers: bool = False
    ) -> None:
        self.catalogue = catalogue
        self._decimal = catalogue.decimal if spoken_numbers else "."
        self._unknown: dict[str, None] = {}
        self.names = frozenset(names)
        self._most = max((len(_SENTENCE.split(each)) for each in catalogue.exact), default=1)

    @property
    def names(self) -> frozenset[str]:
        """Texts that stay as they are."""
        return self._names

    @names.setter
    def names(self, names: frozenset[str]) -> None:
        self._names = names
        self._parting = [
            name for name in names if any(sign in name for sign in (", ", " and ", " or "))
        ]
        self._said: dict[str, str] = {}

    @property
    def unknown(self) -> tuple[str, ...]:
        """Texts that stayed English, in the order they were met."""
        return tuple(self._unknown)

    def missed(self, texts: Iterable[str]) -> None:
        """Count texts that stayed English elsewhere."""
        self._unknown.update(dict.fromkeys(texts))

    def __call__(self, text: str) -> str:
        """The text in the other language; what is a name besides counts as a text."""
        if not self.catalogue.exact or is_translated(text):
            return text
        if text not in self._said:
            said = self._whole(text.replace("\u200b", ""))
            self.missed(said.unknown)
            if len(self._said) >= MOST_KEPT:
                self._said.clear()
            self._said[text] = said.text
        return self._said[text]

    def cell(self, text: str) -> str:
        """The same of what may be a name."""
        return text if text in self._names else self(text)

    def with_its_lines(self, text: str) -> str | None:
        """A text of several lines by an entry that has them; None where none says all of it."""
        if text in self.catalogue.exact:
            return self.catalogue.exact[text]
        count = text.count("\n")
        for template in self.catalogue.templates:
            if count and template.english.count("\n") == count:
                for values in template.matches(text):
                    said = self._filled(template, values)
                    if said is not None and not said.unknown:
                        return said.text
        return None

    def _whole(self, text: str) -> _Said:
        """The text said, or kept and counted as unknown."""
        return self._known(text) or _Said(text, (text,))

    def _known(self, text: str) -> _Said | None:
        """The text said, in part at least; None where nothing of it is known."""
        if not _LETTER.search(text):
            return self._number(text)
        whole = self._as_one(text)
        if whole is not None and not whole.unknown:
            return whole
        sentences = _SENTENCE.split(text)
        parts = self._one_by_one(sentences) if len(sentences) > 1 else None
        found = [said for said in (whole, parts) if said is not None]
        return min(found, key=lambda said: len(said.unknown), default=None)

    def _number(self, text: str) -> _Said:
        grouped = _THOUSANDS.sub("\0", text)
        spoken = _DECIMAL.sub(self._decimal, grouped)
        return _Said(spoken.replace("\0", self.catalogue.thousands))

    def _as_one(self, text: str) -> _Said | None:
        """The text by one entry of the catalogue."""
        plain = text.replace("\u00a0", " ")
        if plain in self.catalogue.exact:
            return _Said(self.catalogue.exact[plain])
        partly = []
        for template in self.catalogue.templates:
            # Few texts hold even the longest literal of a template
            if not template.literals or template.literals[0] in plain:
                for values in template.matches(text):
                    said = self._filled(template, values)
                    if said is not None and not said.unknown:
                        return said
                    if said is not None:
                        partly.append(said)
        return min(partly, key=lambda said: len(said.unknown), default=None)

    def _one_by_one(self, sentences: list[str]) -> _Said | None:
        """Sentences said in as long pieces as one entry says; None where no piece is known."""
        said: list[_Said] = []
        at, known = 0, False
        while at < len(sentences):
            for end in range(min(len(sentences), at + self._most), at, -1):
                found = self._as_one(" ".join(sentences[at:end]))
                if found is not None and (not found.unknown or end == at + 1):
                    known = True
                    break
            else:
                found = _Said(sentences[at], (sentences[at],))
            said.append(found)
            at = end
        text = " ".join(each.text for each in said)
        return _Said(text, tuple(u for each in said for u in each.unknown)) if known else None

    def _filled(self, template: Template, values: Iterable[str]) -> _Said | None:
        """The template with what stands in its places; None where it cannot stand there."""
        said = {}
        for (name, kind), value in zip(template.places, values, strict=True):
            in_place = self._in_place(kind, value)
            if in_place is None:
                return None
            said[name] = in_place
        text = template.filled({name: each.text for name, each in said.items()})
        return _Said(text, tuple(u for each in said.values() for u in each.unknown))

    def _in_place(self, kind: str, value: str) -> _Said | None:
        if value in self._names:
            return _Said(value)
        if kind == "name":
            return None
        if kind == "n":
            return self._number(value)
        if kind == "kept":  # what holds the end of a clause is more than belongs there
            return None if _CLAUSE.search(value) else _Said(value)
        if kind == "file":  # a name may hold the end of a sentence
            return _Said(value) if _FILE.fullmatch(value) else None
        if kind == "foreign":
            return _Said(self.catalogue.exact.get(value, value))
        if kind == "codes":
            if _CLAUSE.search(value):
                return None
            return _Said(value.replace(" or ", f" {self.catalogue.alternative} "))
        if kind in ("list", "either"):
            return self._list(value, " or " if kind == "either" else " and ")
        # What is not known and holds the end of a sentence is more than belongs there
        bare = value.strip(" ")
        said = self._known(bare)
        if said is not None:
            return _Said(value.replace(bare, said.text), said.unknown)
        return None if _SENTENCE.search(value) else _Said(value, (value,))

    def _list(self, value: str, last: str) -> _Said:
        words = {" and ": self.catalogue.conjunction, " or ": self.catalogue.alternative}
        text, unknown = "", list[str]()
        for part, sign in _parted(value, (*self._parting, *self.catalogue.parting), last):
            said = _Said(part) if part in self._names else self._whole(part)
            joint = f" {words[last]} " if sign == last else sign
            text += said.text + joint
            unknown += said.unknown
        return _Said(text, tuple(unknown))


def _parted(text: str, whole: Iterable[str], last: str) -> Iterator[tuple[str, str]]:
    """The parts of ``a, b and c`` with what follows each; ``last`` is " and " or " or ".

    What stands in brackets stays whole, as do names that could be parted.
    """
    start = depth = k = 0
    while k < len(text):
        if k == start:
            k += max((len(name) for name in whole if text.startswith(name, k)), default=0)
        if k == len(text):
            break
        depth += (text[k] == "(") - (text[k] == ")")
        sign = next((s for s in (", ", last) if not depth and text.startswith(s, k)), None)
        if sign is None:
            k += 1
        else:
            yield text[start:k], sign
            start = k = k + len(sign)
    yield text[start:], ""
