"""Many targets picked from a list of coordinates."""

import sys
from argparse import Namespace
from typing import Any

from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages
from lispac.message_texts import english_text, message_text
from lispac.present.json_values import json_values
from lispac.present.sighting_quality import sighting_quality_values
from lispac.project import Project
from lispac.survey.crs import CoordinateSystem
from lispac.workflow.calibration.seed_lists import (
    SeedOutcome,
    pick_seeds,
    read_seeds,
    require_all_found,
    require_any_found,
    require_free_names,
)
from lispac.workflow.calibration.sighting_assessment import assess_target
from lispac.workflow.calibration.target_search import thinned_notes
from lispac.workflow.project import projects
from lispac.workflow.project.survey import Survey


def pick_list(
    arguments: Namespace,
    project: Project,
    survey: Survey,
    system: CoordinateSystem | None,
    how: dict[str, Any],
) -> None:
    """Pick all seeds of a list, save what was found, and print a table of it.

    Raises
    ------
    TargetNotFound
        Where a seed led to no target; the others are saved all the same.
    """
    columns = arguments.columns.replace(",", " ").split() if arguments.columns else ()
    seeds = read_seeds(
        arguments.seeds, project, survey.trajectory, system, columns=columns, role=arguments.role
    )
    if not arguments.replace:
        require_free_names(seeds)
    with ConsoleProgress() as progress:
        project, outcomes = pick_seeds(project, survey, seeds.seeds, how, progress=progress)
    require_any_found(seeds, outcomes)
    projects.save_project(project)
    notes = list(seeds.notes)
    for outcome in outcomes:
        notes += thinned_notes(outcome.target) if outcome.target is not None else ()
    print_messages(notes)
    if arguments.json:
        print_json({"seeds": [_outcome_values(project, survey, outcome) for outcome in outcomes]})
    else:
        _print_outcomes(outcomes, len(survey.lines))
    sys.stdout.flush()  # the table comes before the messages about it
    require_all_found(seeds, outcomes)


def _outcome_values(project: Project, survey: Survey, outcome: SeedOutcome) -> dict[str, Any]:
    seed, target = outcome.seed, outcome.target
    content = {
        "row": seed.row, "name": seed.name, "role": seed.role, "seed_m": list(seed.place),
        "found": target is not None, "reason": _message_text(outcome),
    }  # fmt: skip
    if target is None:
        return content | {"lines": {}, "missing": {}}
    judged = assess_target(project, survey, target)
    lines = {
        s.line: {
            "points": len(s.indices),
            "rms_m": s.rms,
            "quality": json_values(sighting_quality_values(target.name, s.line, judged[s.line])),
        }
        for s in target.sightings
    }
    missing = {line: english_text(reason) for line, reason in target.missing.items()}
    return content | {"lines": lines, "missing": missing}


def _message_text(outcome: SeedOutcome) -> str:
    return "" if outcome.message is None else english_text(outcome.message)


def _print_outcomes(outcomes: tuple[SeedOutcome, ...], lines: int) -> None:
    """Print one row per seed: lines, points and RMS, or the reason why it was not found."""
    width = max(len("name"), *(len(outcome.seed.name) for outcome in outcomes))
    print(f"{'row':>4}  {'name':{width}}  {'role':10}  {'lines':>7}  {'points':>9}  RMS (mm)")
    for outcome in outcomes:
        seed, target = outcome.seed, outcome.target
        head = f"{seed.row:4}  {seed.name:{width}}  {seed.role:10}"
        if target is None:
            print(f"{head}  {'none':>7}  {_message_text(outcome)}")
            continue
        found = target.sightings
        points = sum(len(sighting.indices) for sighting in found)
        rms = 1000 * max(sighting.rms for sighting in found)
        print(f"{head}  {f'{len(found)} of {lines}':>7}  {points:9,}  {rms:8.1f}")
        if outcome.message is not None:
            print(f"      {_message_text(outcome)}")
        for line, reason in target.missing.items():
            print(f"      not on {line}: {message_text(reason)}")
    count = sum(outcome.target is not None for outcome in outcomes)
    print(f"Targets found for {count} of {len(outcomes)} seeds")
