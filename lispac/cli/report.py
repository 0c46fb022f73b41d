"""``lispac report``: calibration report as PDF, HTML, JSON or CSV tables."""

from argparse import Namespace

from lispac.cli.console import ConsoleProgress, UsageError
from lispac.report.json_report import schema_text
from lispac.workflow.output.export import write_report
from lispac.workflow.output.report_options import report_options
from lispac.workflow.project import projects
from lispac.workflow.project.survey import load_survey


def report(arguments: Namespace) -> None:
    """Write the report, or print the schema of its JSON.

    Raises
    ------
    UsageError
        Where options do not go together.
    """
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
    )
    project = projects.open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        write_report(project, survey, arguments.output, options=options, progress=progress)
    print(arguments.output)
