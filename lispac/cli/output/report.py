"""``lispac report``: calibration report as PDF, HTML, JSON or CSV tables."""

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.console import ConsoleProgress, UsageError
from lispac.language import LANGUAGES

NO_PICTURES_TEXT = (
    "reports of the command line have no pictures of the 3D view. Export the report in the window "
    "to include them."
)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, nargs="?", metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FILE",
        help="report file: .pdf, .html, .json, or .zip for all tables as CSV",
    )
    parser.add_argument(
        "--language",
        choices=tuple(LANGUAGES),
        help="language of the report (default en; JSON is always English)",
    )
    extent = parser.add_mutually_exclusive_group()
    extent.add_argument(
        "--full", dest="extent", action="store_const", const="full", default="",
        help="full report; JSON and CSV tables are always complete",
    )  # fmt: skip
    extent.add_argument(
        "--short", dest="extent", action="store_const", const="short",
        help="short report of at most a few pages to sign (default)",
    )  # fmt: skip
    parser.add_argument("--page", choices=("a4", "letter"), help="paper size (default a4)")
    parser.add_argument(
        "--convention", metavar="SYSTEM",
        help="also give the boresight in the convention of another program; `lispac angles` lists "
             "the programs",
    )  # fmt: skip
    parser.add_argument(
        "--template", type=Path, metavar="FILE",
        help="TOML file with defaults for the report: logo (PNG or SVG file beside it), company, "
             "heading, closing, page, convention, language, extent; options of the command line "
             "override it",
    )  # fmt: skip
    parser.add_argument(
        "--schema", action="store_true", help="print the JSON schema of the report and exit"
    )


def run(arguments: Namespace) -> None:
    """Write the report, or print the schema of its JSON.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.report.json_report import schema_text
    from lispac.workflow.output.export import write_report
    from lispac.workflow.output.report_options import report_options
    from lispac.workflow.project import projects
    from lispac.workflow.project.survey import load_survey

    if arguments.schema:
        print(schema_text(), end="")
        return
    if arguments.project is None or arguments.output is None:
        raise UsageError("report: give a project and --output FILE, or only --schema.")
    options = report_options(
        arguments.template,
        arguments.page or "",
        arguments.convention or "",
        arguments.language or "",
        arguments.extent,
    )
    project = projects.open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        write_report(project, survey, arguments.output, options=options, progress=progress)
    print(arguments.output)
    sys.stdout.flush()  # print the file before the note on stderr
    if arguments.output.suffix.lower() in (".pdf", ".html"):
        print(f"note: {NO_PICTURES_TEXT}", file=sys.stderr)
