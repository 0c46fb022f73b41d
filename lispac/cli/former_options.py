"""Former names of options, accepted for one version with a note."""

import sys
from collections.abc import Sequence

from lispac.message_texts import message_text
from lispac.messages import note

FORMER_OPTIONS = {
    "angles": {"--lever": "--lever-arm"},
    "budget": {"--lever-sigma": "--lever-arm-sigma"},
    "check": {"--reach": "--search-distance"},
    "estimate": {
        "--accept-one-facing": "--accept-single-orientation",
        "--no-accept-one-facing": "--no-accept-single-orientation",
    },
    "patchtest": {"--keep": "--save"},
    "quality": {"--reach": "--search-distance", "--with": "--boresight"},
    "simulate": {"--lever-error": "--lever-arm-error"},
    "targetless": {"--keep": "--save"},
    "visibility": {"--struck": "--hit-beams"},
}
"""New names of options by the former ones, by command."""


def with_new_options(words: Sequence[str]) -> list[str]:
    """Words of a command line with former options replaced; a note on stderr names each."""
    former = FORMER_OPTIONS.get(words[0], {}) if words else {}
    return [_with_new_option(word, former) for word in words]


def _with_new_option(word: str, former: dict[str, str]) -> str:
    option, *value = word.split("=", 1)
    if option not in former:
        return word
    message = note("former_name.option", former=option, name=former[option])
    print(f"note: {message_text(message)}", file=sys.stderr)
    return "=".join([former[option], *value])
