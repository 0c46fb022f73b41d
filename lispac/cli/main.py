"""Entry point of ``lispac``.

Exit codes: 0 success; 1 error, with one line on stderr; 2 wrong usage. The exit code is also 1 if
no target was found for some seeds of a list; the targets of the other seeds are saved.
"""

import gc
import os
import re
import sys
from collections.abc import Sequence
from io import TextIOWrapper

from lispac import caches
from lispac.cli.argument_types import without_exponents
from lispac.cli.console import UsageError
from lispac.cli.former_options import with_new_names
from lispac.cli.messages import option_hint, print_messages
from lispac.cli.parser import build_parser
from lispac.errors import Cancelled, LispacError

CONTROL_CHARACTERS = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]"
)
"""Control characters other than tab and end of line, and those that set the writing direction."""

NEW_OBJECTS_BEFORE_COLLECTION = 20_000
"""Number of new objects at which garbage is collected. With the number of Python, 700, the
collections while libraries are imported take 0.2 s."""


def run(argv: Sequence[str] | None = None) -> None:
    """Run one command of the command line.

    Raises
    ------
    LispacError
        If the command fails; the exception contains the message.
    UsageError
        If options are missing or contradict each other.
    """
    words = without_exponents(with_new_names(sys.argv[1:] if argv is None else argv))
    arguments = build_parser(words).parse_args(words)
    # Set before the command imports Numba, which reads these environment variables.
    if (message := caches.set_cache_variables(os.environ)) is not None:
        print_messages([message])
    arguments.run(arguments)


def _escape_control_characters(stream: TextIOWrapper) -> None:
    """Escape control characters in the output; file names may contain them."""
    write = stream.write
    stream.write = lambda text: write(CONTROL_CHARACTERS.sub(_escape_match, text))  # type: ignore[method-assign]


def _escape_match(match: re.Match[str]) -> str:
    return match.group().encode("unicode_escape").decode()


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return the exit code; an expected error is one line on stderr."""
    gc.set_threshold(NEW_OBJECTS_BEFORE_COLLECTION)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):  # the encoding may lack some characters
            stream.reconfigure(errors="backslashreplace")
            if stream.isatty():
                _escape_control_characters(stream)
    try:
        run(argv)
    except UsageError as error:
        print(f"lispac: {error}", file=sys.stderr)
        return 2
    except LispacError as error:
        hint = option_hint(error.message)
        print(f"lispac: {error}{hint and f' ({hint})'}", file=sys.stderr)
        return 1
    except (KeyboardInterrupt, Cancelled):
        print("lispac: interrupted.", file=sys.stderr)
        return 1
    except BrokenPipeError:
        return 1
    except MemoryError:
        print("lispac: not enough memory; use shorter lines.", file=sys.stderr)
        return 1
    except OSError as error:
        file, reason = error.filename or "a file", error.strerror or error
        check = "Check the path, the disk and the permissions."
        print(f"lispac: {file}: {reason}. {check}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
