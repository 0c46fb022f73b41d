"""Former names of commands and options, accepted for one version with a note."""

from collections.abc import Sequence

from lispac.cli.argument_types import split_named_value
from lispac.cli.messages import print_messages
from lispac.former_names import NEW_READING_OPTIONS
from lispac.messages import note

FORMER_COMMANDS = {"look": "inspect", "replay": "compare-plan"}
"""New name of each former command."""
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
"""New name of each former option, by command."""


def with_new_names(words: Sequence[str]) -> list[str]:
    """Replace former names in the words of a command line, with a note on stderr for each."""
    if not words:
        return []
    former = FORMER_OPTIONS.get(words[0], {})
    return [_with_new_command(words[0]), *(_with_new_option(word, former) for word in words[1:])]


def split_reading_option(text: str) -> tuple[str, str]:
    """Split ``NAME=VALUE`` of a reading option; a former name is replaced with a note.

    Raises
    ------
    ArgumentTypeError
        If the text does not have the form ``NAME=VALUE``.
    """
    name, value = split_named_value(text)
    if name not in NEW_READING_OPTIONS:
        return name, value
    print_messages([note("former_name.option", former=name, name=NEW_READING_OPTIONS[name])])
    return NEW_READING_OPTIONS[name], value


def _with_new_command(word: str) -> str:
    if word not in FORMER_COMMANDS:
        return word
    print_messages([note("former_name.command", former=word, name=FORMER_COMMANDS[word])])
    return FORMER_COMMANDS[word]


def _with_new_option(word: str, former: dict[str, str]) -> str:
    option, *value = word.split("=", 1)
    if option not in former:
        return word
    print_messages([note("former_name.option", former=option, name=former[option])])
    return "=".join([former[option], *value])
