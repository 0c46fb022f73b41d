"""Whether an English text can be said in French."""

import re

from lispac.reverse_translation.catalogue import catalogue_of
from lispac.reverse_translation.translation import Translator

FRENCH = catalogue_of("fr")
KEYS = [re.sub(r"\{\w+(:\w+)?\}", "\0", english) for english in FRENCH.exact]


def covered(text: str) -> bool:
    """Whether the text is known, or each of its sentences a part of one that is."""
    text = re.sub(r"\{\w+(:[\w.]+)?\}", "7", text)  # the places of a message text
    say = Translator(FRENCH, {"7"})
    say(text)
    if not say.unknown:
        return True
    return all(_part(sentence) for sentence in re.split(r"(?<=[.?!]) ", text))


def _part(sentence: str) -> bool:
    say = Translator(FRENCH, {"7"})
    say(sentence)
    pieces = [p.strip() for p in sentence.split("7") if re.search(r"[^\W\d_]{2}", p)]
    pattern = re.compile(".*".join(map(re.escape, pieces)), re.DOTALL)
    return not say.unknown or any(pattern.search(key) for key in KEYS)
