"""Steps that a page of the manual describes, in the order of the page.

The markup of the page gives the kind of step: ``{guilabel}`` is clicked, ``{menuselection}``
chosen, ``{kbd}`` pressed, ``{typed}`` typed, ``**bold**`` must be visible, and pictures are taken.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from lispac.installation_paths import resource_path

Kind = Literal["click", "menu", "press", "type", "see", "look"]
_ROLES: dict[str, Kind] = {
    "guilabel": "click", "menuselection": "menu", "kbd": "press", "typed": "type",
}  # fmt: skip
_MARK = re.compile(
    r"\{(?P<role>\w+)\}`(?P<name>[^`]+)`|\*\*(?P<bold>[^*]+)\*\*|"
    r"!\[[^\]]*\]\((?P<picture>[^)]+)\)",
)


@dataclass(frozen=True)
class Step:
    """One thing to do.

    Attributes
    ----------
    text : name of what is clicked, the keys, the text to type, or the picture's path on the page
    line : of the page, from 1
    """

    kind: Kind
    text: str
    line: int


def page(language: str, name: str) -> Path:
    """Source text of a page."""
    return resource_path("manual") / language / f"{name}.md"


def steps_of(text: str) -> list[Step]:
    """Steps of a page.

    Raises
    ------
    ValueError
        For a role that is not a step, so that typing errors are not skipped.
    """
    found = []
    for mark in _MARK.finditer(text):
        line = text.count("\n", 0, mark.start()) + 1
        role, name = mark["role"], mark["name"]
        if role is not None and role not in _ROLES:
            raise ValueError(f"line {line}: {role} is none of {', '.join(_ROLES)}")
        kind: Kind = _ROLES[role] if role else "see" if mark["bold"] else "look"
        words = name or mark["bold"] or mark["picture"]
        found.append(Step(kind, re.sub(r"\s+", " ", words), line))
    return found
