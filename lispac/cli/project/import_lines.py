"""``lispac import``: store the points of the lines in the project folder."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages
from lispac.errors import Cancelled
from lispac.language import gettext_lazy
from lispac.message_texts import message_text

if TYPE_CHECKING:
    from lispac.cli.json_outputs import ImportedLineOutput
    from lispac.progress import Progress
    from lispac.workflow.importing.line_import import ImportedLine


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--lines", nargs="+", default=[], metavar="NAME", help="use only these lines (default: all)"
    )
    parser.add_argument(
        "--again", action="store_true", help="import again lines that are already imported"
    )
    parser.add_argument(
        "--check", action="store_true", help="read all imported data and compare checksums"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Import the lines of a project: those not imported yet or, with ``--again``, all.

    Raises
    ------
    KeyboardInterrupt
        If the user interrupts the import; the points read so far are kept.
    Cancelled
        If the import is cancelled; the points read so far are kept.
    """
    from lispac.workflow.importing.line_import import assumptions_of
    from lispac.workflow.importing.line_import import import_lines as imported_lines
    from lispac.workflow.project.projects import open_project

    project = open_project(arguments.project)
    try:
        with ConsoleProgress() as progress:
            found = imported_lines(
                project, arguments.lines, again=arguments.again, progress=progress
            )
            if arguments.check:
                _check_imported(found, progress)
    except (KeyboardInterrupt, Cancelled):
        print(
            "lispac: import interrupted; the points read so far are kept. Run lispac import again "
            "to continue.",
            file=sys.stderr,
        )
        raise
    if arguments.json:
        from lispac.cli.json_outputs import ImportOutput

        print_json(ImportOutput({item.stored.name: _imported_line(item) for item in found}))
        return
    for item in found:
        _print_imported(item)
    print_messages(item.reason for item in found if item.reason)
    print_messages(dict.fromkeys(each for item in found for each in assumptions_of(item.stored)))


def _check_imported(imported: list[ImportedLine], progress: Progress) -> None:
    from lispac.workflow.importing.line_import import is_header_damaged

    for item in imported:
        words = gettext_lazy("Checking {line}", line=item.stored.name)
        item.stored.require_sound(lambda done, words=words: progress(done, words))  # type: ignore[misc]
        if is_header_damaged(item.stored):
            print(
                f"note: {item.stored.name}: the imported points are undamaged, but the header "
                "records stored with them are damaged. Import the line again to keep these "
                "records in exported clouds.",
                file=sys.stderr,
            )


def _print_imported(item: ImportedLine) -> None:
    from lispac.present.survey.survey_data import FILE_MEGABYTES, IMPORT_RATE, IMPORT_SECONDS
    from lispac.present.tables import COUNT

    manifest = item.stored.manifest
    how = "imported already"
    if item.seconds:
        rate = IMPORT_RATE.text(manifest.points / item.seconds)
        how = f"{IMPORT_SECONDS.text(item.seconds)} s, {rate} M points/s"
    points, size = COUNT.text(manifest.points), FILE_MEGABYTES.text(manifest.bytes)
    print(f"{manifest.line:20s} {points:>12s} points, {size:>10s} MB, {how}")


def _imported_line(item: ImportedLine) -> ImportedLineOutput:
    from lispac.cli.json_outputs import ImportedLineOutput
    from lispac.workflow.importing.line_import import assumptions_of

    manifest = item.stored.manifest
    return ImportedLineOutput(
        item.stored.folder, manifest.points, manifest.excluded_points, manifest.bytes,
        item.seconds, tuple(map(message_text, assumptions_of(item.stored))),
    )  # fmt: skip
