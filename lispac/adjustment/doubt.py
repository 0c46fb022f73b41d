"""Something to know before using the angles, and where its cause lies."""

from dataclasses import dataclass

from lispac.adjustment.shown import listed, plain
from lispac.causes import RESULT, Cause

MOST_NAMED = 4
"""Sightings, parts or targets named one by one; more are counted."""


@dataclass(frozen=True)
class Doubt:
    """Something to know before using the angles.

    Attributes
    ----------
    code : str
        Names the rule, whatever the words.
    serious : bool
        Whether it makes the answer doubtful, or is to be kept in mind.
    text : str
        One or two sentences, with true minus signs and fixed spaces.
    cause : Cause
        Where to look; the worst place where there are several.
    effect : float or None, metres
        By how much what it warns of displaces points, where that is known.
    """

    code: str
    serious: bool
    text: str
    cause: Cause = RESULT
    effect: float | None = None

    @property
    def plain(self) -> str:
        """The text in plain characters, for a terminal."""
        return plain(self.text)


def some(named: list[str]) -> str:
    """The first few, and how many more there are."""
    rest = len(named) - MOST_NAMED
    return listed([*named[:MOST_NAMED], f"{rest} more"] if rest > 0 else named)
