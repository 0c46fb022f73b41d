"""``lispac patchtest``: LiDAR patch test on objects that several lines have in common."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, get_args

from lispac.cli.argument_types import add_json_option, split_named_value, whole_number_from
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.messages import console_text

if TYPE_CHECKING:
    from lispac.patchtest.line_pairs import LinePair
    from lispac.patchtest.object_boxes import PatchObject
    from lispac.present.calibration.patch_test import PatchTestValues
    from lispac.workflow.project.survey import Survey

BOX_NUMBER_COUNTS = (6, 7)
"""Numbers of values that define a box, without and with a rotation."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--object", type=split_named_value, nargs="+", action="extend", metavar="NAME=N,W,U,A,L,H",
        help="box around an object (a pole, a pillar, an edge): north, west and up of its centre "
             "in the local frame (N, W, U), then its size northwards, westwards and upwards (A, L, "
             "H; m); an optional seventh number rotates the box clockwise (deg)",
    )  # fmt: skip
    parser.add_argument(
        "--count", type=whole_number_from(0), metavar="N",
        help="number of objects to detect automatically (default 30; 0 if --object is given)",
    )  # fmt: skip
    parser.add_argument(
        "--pairs", choices=("reciprocal", "crossing", "oblique", "same"), nargs="+",
        help="pairs of lines to use: in opposite directions (reciprocal), about at right angles "
             "(crossing), at other angles (oblique) or in the same direction (default: all)",
    )  # fmt: skip
    parser.add_argument(
        "--lines", nargs="+", metavar="NAME", help="use only pairs of these lines (default: all)"
    )
    parser.add_argument(
        "--save",
        action="store_true",
        help="save the result in the project, beside that of the targets",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Run the patch test of a project; ``--save`` stores the result.

    Raises
    ------
    UsageError
        If a box is invalid or a line is unknown.
    """
    from lispac.patchtest.object_proposal import MAX_OBJECTS
    from lispac.present.calibration.patch_test import PatchTestValues
    from lispac.progress import sub_progress
    from lispac.workflow.calibration import patch_test as workflow
    from lispac.workflow.calibration.method_runs import patch_test_result
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    given_objects = [_parse_object(name, text) for name, text in arguments.object or ()]
    if len({each.name for each in given_objects}) < len(given_objects):
        raise UsageError("patchtest: two objects have the same name.")
    count = arguments.count if arguments.count is not None else 0 if given_objects else MAX_OBJECTS
    if not given_objects and not count:
        raise UsageError("patchtest: give objects with --object, or detect some with --count.")
    with opened_project(arguments.project, change=arguments.save) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.3))
            pairs = _selected_pairs(survey, arguments.pairs or (), arguments.lines)
            if count:
                step = sub_progress(progress, 0.3, 0.6)
                placed = workflow.propose_objects(project, survey, count=count, progress=step)
                if given_objects:
                    objects = (*given_objects, *placed.objects)
                    placed = workflow.place_objects(project, survey, objects, placed.boresight)
            else:
                placed = workflow.place_objects(
                    project, survey, given_objects, survey.alignment.mounting.boresight
                )
            found = workflow.find_boresight(
                project, survey, placed, pairs=pairs, progress=sub_progress(progress, 0.6, 1.0)
            )
        if arguments.save:
            save_project(project.with_alternative_result(patch_test_result(found)))
    values = PatchTestValues.of(found)
    if arguments.json:
        print_json(values)
    else:
        print_patch_test(values)


def print_patch_test(values: PatchTestValues) -> None:
    """Print the angles with their sigmas, the objects and the messages."""
    from lispac.present.calibration.patch_test import PATCH_OBJECTS_TABLE, PATCH_TEST_TABLES

    for table in PATCH_TEST_TABLES:
        print_table(table, [values])
    print_table(PATCH_OBJECTS_TABLE, values.objects)
    for message in values.messages:
        print(console_text(message))


def _parse_object(name: str, text: str) -> PatchObject:
    import numpy as np

    from lispac.patchtest.object_boxes import ObjectBox, object_of_box

    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        values = []
    if len(values) not in BOX_NUMBER_COUNTS:
        raise UsageError(
            f"patchtest: {name}={text} is not NAME=N,W,U,A,L,H or NAME=N,W,U,A,L,H,TURN."
        )
    turn = np.radians(values[6]) if len(values) == BOX_NUMBER_COUNTS[1] else 0.0
    return object_of_box(name, ObjectBox(np.array(values[:3]), np.array(values[3:6]), float(turn)))


def _selected_pairs(
    survey: Survey, kinds: Iterable[str], lines: list[str] | None
) -> tuple[LinePair, ...]:
    from lispac.patchtest.line_pairs import Kind
    from lispac.workflow.calibration import patch_test as workflow

    for line in lines or ():
        if line not in survey.clouds:
            raise UsageError(
                f"patchtest: there is no line {line}; the lines are {', '.join(survey.lines)}."
            )
    selected = {kind for kind in get_args(Kind) if kind.split()[0] in kinds}
    found = workflow.line_pairs(survey, selected)
    return tuple(pair for pair in found if lines is None or set(pair.lines) <= set(lines))
