"""``lispac check``: distances of the lines from a reference."""

import math
from argparse import Namespace

from lispac.cli.console import ConsoleProgress, opened_project, print_json
from lispac.cli.messages import print_messages
from lispac.message_texts import message_text
from lispac.present.absolute import AbsoluteCheckValues, ReferenceDistances
from lispac.present.json_values import json_values
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.project.projects import save_project
from lispac.workflow.project.survey import load_survey


def check(arguments: Namespace) -> None:
    """Compare the lines with a reference, and save the figures."""
    with opened_project(arguments.project, change=True) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=progress)
            project, notes = check_absolute(
                project, survey, arguments.reference, crs=arguments.crs, height=arguments.height,
                trajectory_datum=arguments.trajectory_datum, epoch=arguments.epoch,
                sigma=arguments.reference_sigma, reach=arguments.search_distance, progress=progress,
            )  # fmt: skip
        save_project(project)
    assert project.absolute is not None
    found = AbsoluteCheckValues.of(project.absolute)
    print_messages(notes)
    if arguments.json:
        print_json(json_values(found))
        return
    heads = "".join(
        f"{f'mean {state}':>12s}{'95 %':>9s}{f'RMS {state}':>11s}" for state in ("before", "after")
    )
    print(f"{'line':14s}{'places':>8s}{heads}  mm, positive towards the vessel")
    for line in (*found.lines, found.all_lines):
        print(
            f"{line.line:14s}{line.after.distances.n:8,}{_statistics_cells(line.before)}{_statistics_cells(line.after)}"
        )
    if found.points:
        heads = f"{'sigma':>9s}{'before':>10s}{'after':>10s}{'95 %':>9s}"
        print(f"\n{'surveyed':14s}{'lines':>8s}{heads}  mm")
        for point in found.points:
            print(
                f"{point.name:14s}{point.lines:8}{1000 * point.sigma_m:9.1f}"
                f"{1000 * point.before_m:+10.1f}{1000 * point.after_m:+10.1f}"
                f"{1000 * (point.after_interval95_m or math.nan):9.1f}"
            )
    print()
    for message in found.messages:
        print(message_text(message))
    for reason in found.not_compared:
        print(f"not compared: {message_text(reason)}")


def _statistics_cells(distances: ReferenceDistances) -> str:
    return (
        f"{1000 * distances.signed.mean_m:+12.1f}{1000 * distances.mean_interval95_m:9.1f}"
        f"{1000 * distances.distances.rms_m:11.1f}"
    )
