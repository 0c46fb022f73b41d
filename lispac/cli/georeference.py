"""``lispac georeference``: georeferenced point clouds of the lines."""

from argparse import Namespace

from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages
from lispac.message_texts import message_text
from lispac.workflow.output.georeferencing import georeference_project
from lispac.workflow.project.projects import open_project


def georeference(arguments: Namespace) -> None:
    """Write the lines as LAS or LAZ with all their attributes."""
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        written = georeference_project(
            project,
            arguments.output,
            arguments.boresight,
            system=arguments.crs,
            height=arguments.height,
            trajectory_datum=arguments.trajectory_datum,
            epoch=arguments.epoch,
            lines=arguments.lines or (),
            ending=arguments.format,
            progress=progress,
        )
    found = dict.fromkeys(each for done in written for each in done.notes)
    print_messages(found)
    if arguments.json:
        lines = [
            {
                "file": str(done.path), "points": done.points, "outside": done.outside,
                "in_gaps": done.in_gaps,
            }
            for done in written
        ]  # fmt: skip
        print_json({"lines": lines, "notes": list(map(message_text, found))})
        return
    for done in written:
        print(f"{done.path}  {done.points:,} points")
