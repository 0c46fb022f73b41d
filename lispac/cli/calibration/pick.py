"""``lispac pick``: search for a target in all lines, or for all targets of a list."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from math import degrees, radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import (
    add_crs_options,
    add_json_option,
    add_triple_option,
    finite_number,
    number_within,
    positive_number,
    whole_number_from,
)
from lispac.cli.console import (
    ConsoleProgress,
    UsageError,
    opened_project,
    print_json,
    print_table,
)
from lispac.cli.messages import console_text, print_messages
from lispac.messages import Message, note
from lispac.targets.finder_settings import RADIUS_LIMITS, THRESHOLD_LIMITS, FinderChoices

if TYPE_CHECKING:
    from lispac.cli.json_outputs import (
        PickOutput,
        SeedOutput,
        SharedPointsOutput,
    )
    from lispac.present.targets.sighting_quality import PickedSightingValues
    from lispac.project import Project, Target
    from lispac.survey.crs import CoordinateSystem
    from lispac.targets.sighting_quality import SightingQuality
    from lispac.targets.sphere_finder import SpherePatch
    from lispac.workflow.calibration.seed_lists import SeedOutcome
    from lispac.workflow.project.survey import Survey


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    seeds = parser.add_mutually_exclusive_group(required=True)
    seeds.add_argument(
        "--seed", type=finite_number, nargs=3, metavar=("X", "Y", "Z"),
        help="coordinates of the seed: north, west, up (m); with --crs easting or longitude, "
             "northing or latitude, height",
    )  # fmt: skip
    seeds.add_argument(
        "--seeds", type=Path, metavar="FILE",
        help="list of seeds: text file with name, x, y, z (north, west, up in the local frame) and "
             "optionally the role in each row, or with a header row",
    )  # fmt: skip
    parser.add_argument("--name", help="with --seed: name of the target, e.g. T1")
    parser.add_argument(
        "--columns", metavar="NAMES",
        help="with --seeds: columns of the list from the left, e.g. name,y,x,z,- (- skips a "
             "column)",
    )  # fmt: skip
    parser.add_argument(
        "--replace", action="store_true",
        help="with --seeds: replace existing targets of the same names",
    )  # fmt: skip
    parser.add_argument(
        "--role", choices=("target", "validation"),
        help="role of the target (default target; in a list as given there, otherwise validation "
             "if the name begins with V)",
    )  # fmt: skip
    add_crs_options(parser, "local")
    parser.add_argument(
        "--shape",
        choices=("plane", "sphere"),
        default="plane",
        help="shape of the target (default plane)",
    )
    parser.add_argument(
        "--sphere-radius",
        type=positive_number,
        metavar="METRES",
        help="with --shape sphere: radius of the sphere (m), if known (default: estimated between "
        "0.05 and 0.5 m)",
    )
    parser.add_argument("--line", help="with --seed: search in this line only")
    _add_search_options(parser)
    add_triple_option(
        parser, "--expected", ("WIDTH", "HEIGHT", "TILT"),
        "expected width and height of the plane (m) and its inclination (deg; 0 level, 90 "
        "vertical), for comparison; 1.23 1.22 90 is the usual board",
    )  # fmt: skip
    add_json_option(parser)


def _add_search_options(parser: ArgumentParser) -> None:
    """Add the options of the search for planes and spheres."""
    parser.add_argument(
        "--threshold",
        type=number_within(*THRESHOLD_LIMITS),
        metavar="METRES",
        help="RANSAC distance threshold (m; default 0.01, or 3 LiDAR sigma if larger; for spheres "
        "at least 0.03, or 0.3 of a known radius if smaller)",
    )
    parser.add_argument(
        "--radius",
        type=number_within(*RADIUS_LIMITS),
        metavar="METRES",
        help="search radius about the seed (m; default 2 for targets, 4 to 20 for validation "
        "planes)",
    )
    parser.add_argument(
        "--min-points", type=whole_number_from(3), metavar="N", default=30,
        help="minimum number of points of a plane or sphere in a line (default 30)",
    )  # fmt: skip
    parser.add_argument(
        "--max-tilt", type=positive_number, metavar="DEG", default=15.0,
        help="largest angle between a target's normals in two lines (deg; default 15)",
    )  # fmt: skip
    parser.add_argument(
        "--stop", type=positive_number, metavar="P", default=0.98,
        help="RANSAC confidence: probability that at least one sample is free of outliers "
             "(default 0.98)",
    )  # fmt: skip
    parser.add_argument(
        "--random-seed", type=whole_number_from(0), metavar="N", default=0,
        help="seed of the random samples: the same seed gives the same points (default 0)",
    )  # fmt: skip


def run(arguments: Namespace) -> None:
    """Find a target, or all targets of a list, in every line and save them."""
    _require_matching_options(arguments)
    how = _search_arguments(arguments)
    with opened_project(arguments.project, change=True) as project:
        _pick_in_project(arguments, project, how)


def _pick_in_project(arguments: Namespace, project: Project, how: dict[str, Any]) -> None:
    import numpy as np

    from lispac.duplicate_targets import overlap_warning
    from lispac.workflow.calibration import picking
    from lispac.workflow.calibration.sighting_assessment import assess_target
    from lispac.workflow.project import projects
    from lispac.workflow.project.coordinates import require_near_trajectory
    from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of
    from lispac.workflow.project.survey import load_survey

    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    system = output_system_of(
        project, survey.trajectory, arguments.crs or LOCAL_FRAME, arguments.height,
        arguments.trajectory_datum, arguments.epoch,
    )  # fmt: skip
    if arguments.seeds is not None:
        _pick_list(arguments, project, survey, system, how)
        return
    place = require_near_trajectory(
        np.array(arguments.seed), system, survey.trajectory, arguments.name
    )
    with ConsoleProgress() as progress:
        project = picking.pick_target(
            project, survey, place, name=arguments.name, role=arguments.role or "target",
            line=arguments.line, progress=progress, **how,
        )  # fmt: skip
    projects.save_project(project)
    target = project.target(arguments.name)
    spheres = picking.spheres_of(target, survey) if target.shape == "sphere" else {}
    found = assess_target(project, survey, target)
    overlap = overlap_warning(target, project.targets)
    notes = (
        *(() if system is None else system.assumptions), *search_notes(target, how["radius"]),
        *(() if overlap is None else (overlap,)),
    )  # fmt: skip
    print_messages(notes)
    if arguments.json:
        print_json(_target_output(project, target, spheres, found))
    else:
        _print_target(target, spheres, found)


def _shared_points(project: Project, target: Target) -> SharedPointsOutput | None:
    """Target with the largest share of common points; None if there is none."""
    from lispac.cli.json_outputs import SharedPointsOutput
    from lispac.duplicate_targets import find_overlap

    found = find_overlap(target, project.targets)
    return None if found is None else SharedPointsOutput(found.other, found.line, found.share)


def _require_matching_options(arguments: Namespace) -> None:
    """Refuse options that cannot be combined.

    Raises
    ------
    UsageError
        If an option is missing, options exclude each other or a value is out of range.
    """
    if arguments.sphere_radius is not None and arguments.shape != "sphere":
        raise UsageError("--sphere-radius requires --shape sphere")
    if arguments.expected is not None and arguments.shape != "plane":
        raise UsageError("--expected applies to planes only; omit it")
    if arguments.max_tilt > 90:
        raise UsageError("--max-tilt must be at most 90 deg")
    if arguments.stop >= 1:
        raise UsageError("--stop must be a probability between 0 and 1")
    one = arguments.seeds is None
    if one and not arguments.name:
        raise UsageError("--seed requires --name, the name of the target")
    for option, given, needed in (
        ("--name", arguments.name, not one), ("--line", arguments.line, not one),
        ("--columns", arguments.columns, one), ("--replace", arguments.replace, one),
    ):  # fmt: skip
        if given and needed:
            raise UsageError(f"{option} requires --{'seeds' if one else 'seed'}; omit it")


def _search_arguments(arguments: Namespace) -> dict[str, Any]:
    """Convert the options to arguments of `lispac.workflow.calibration.picking.find_target`."""
    from lispac.targets.expected_target import ExpectedTarget

    expected = None
    if arguments.expected is not None:
        width, height, tilt_deg = arguments.expected
        expected = ExpectedTarget(width, height, radians(tilt_deg))
    return {
        "shape": arguments.shape, "sphere_radius": arguments.sphere_radius,
        "threshold": arguments.threshold, "radius": arguments.radius, "expected": expected,
        "choices": FinderChoices(
            arguments.min_points, radians(arguments.max_tilt), arguments.stop, arguments.random_seed
        ),
    }  # fmt: skip


def search_notes(target: Target, radius: float | None) -> tuple[Message, ...]:
    """Notes on the search for a target; ``radius`` is the given radius, metres, or None."""
    from lispac.workflow.calibration import picking
    from lispac.workflow.calibration.target_search import thinned_notes

    usual = picking.DEFAULT_RADII[target.role][0]
    widened: tuple[Message, ...] = ()
    if radius is None and target.shape == "plane" and target.radius > usual:
        widened = (
            note("finder.radius_increased", target=target.name, usual=usual, radius=target.radius),
        )
    return (*widened, *thinned_notes(target))


def _target_output(
    project: Project,
    target: Target,
    spheres: dict[str, SpherePatch],
    qualities: dict[str, SightingQuality],
) -> PickOutput:
    """A target and its sightings for ``pick --json``."""
    from lispac.cli.json_outputs import PickOutput

    return PickOutput(
        name=target.name,
        role=target.role,
        shape=target.shape,
        sphere_radius_m=target.sphere_radius,
        radius_m=target.radius,
        threshold_m=target.threshold,
        min_points=target.choices.min_points,
        max_tilt_deg=degrees(target.choices.max_tilt),
        stop=target.choices.stop,
        random_seed=target.choices.seed,
        lines=_sighting_values(target, spheres, qualities),
        missing=target.missing,
        same_points_as=_shared_points(project, target),
    )


def _sighting_values(
    target: Target, spheres: dict[str, SpherePatch], qualities: dict[str, SightingQuality]
) -> dict[str, PickedSightingValues]:
    """Sightings of a target by line."""
    from lispac.present.angles import floats
    from lispac.present.targets.sighting_quality import (
        PickedSightingValues,
        sighting_quality_values,
    )

    found = {}
    for sighting in target.sightings:
        line = sighting.line
        values = sighting_quality_values(target.name, line, qualities[line])
        output = PickedSightingValues(len(sighting.indices), sighting.rms, values)
        if line in spheres:
            patch = spheres[line]
            output = replace(
                output, centre_m=floats(patch.centre), sphere_radius_m=patch.sphere.radius,
                visible_share=patch.share,
            )  # fmt: skip
        found[line] = output
    return found


def _print_target(
    target: Target, spheres: dict[str, SpherePatch], qualities: dict[str, SightingQuality]
) -> None:
    from lispac.present.targets.sighting_quality import PICKED_SIGHTINGS_TABLE, PICKED_SPHERES_TABLE

    found = _sighting_values(target, spheres, qualities)
    print_table(PICKED_SIGHTINGS_TABLE, list(found.values()))
    if spheres:
        known = "given" if target.sphere_radius is not None else "estimated"
        table = replace(PICKED_SPHERES_TABLE, title=f"Sphere in each line, radius {known}")
        print_table(table, [found[line] for line in spheres])
    for line, values in found.items():
        for reason in values.quality.reasons:
            print(f"{target.name} on {line}: {console_text(reason)}")
    for line, missing in target.missing.items():
        print(f"{target.name} on {line} not found: {console_text(missing)}")


def _pick_list(
    arguments: Namespace,
    project: Project,
    survey: Survey,
    system: CoordinateSystem | None,
    how: dict[str, Any],
) -> None:
    """Search for the targets of a list of seeds, save the targets found and print a table.

    Raises
    ------
    TargetNotFound
        If no target was found for a seed; the targets of the other seeds are saved.
    """
    from lispac.workflow.calibration.seed_lists import (
        pick_seeds,
        read_seeds,
        require_all_found,
        require_any_found,
        require_free_names,
    )
    from lispac.workflow.calibration.target_search import thinned_notes
    from lispac.workflow.project import projects

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
        from lispac.cli.json_outputs import SeedListOutput

        print_json(SeedListOutput(tuple(_seed_output(project, survey, each) for each in outcomes)))
    else:
        _print_outcomes(outcomes, len(survey.lines))
    sys.stdout.flush()  # print the table before the messages on stderr
    require_all_found(seeds, outcomes)


def _seed_output(project: Project, survey: Survey, outcome: SeedOutcome) -> SeedOutput:
    from lispac.cli.json_outputs import SeedOutput
    from lispac.workflow.calibration import picking
    from lispac.workflow.calibration.sighting_assessment import assess_target

    seed, target = outcome.seed, outcome.target
    output = SeedOutput(
        row=seed.row, name=seed.name, role=seed.role, seed_m=seed.place, found=target is not None,
        reason=outcome.message, lines={}, missing={},
    )  # fmt: skip
    if target is None:
        return output
    spheres = picking.spheres_of(target, survey) if target.shape == "sphere" else {}
    lines = _sighting_values(target, spheres, assess_target(project, survey, target))
    return replace(output, lines=lines, missing=target.missing)


def _print_outcomes(outcomes: tuple[SeedOutcome, ...], lines: int) -> None:
    """Print a row for each seed, and the reasons why seeds or lines gave no target."""
    from lispac.present.targets.seeds import SEED_OUTCOMES_TABLE

    rows = [outcome.row(lines) for outcome in outcomes]
    print_table(SEED_OUTCOMES_TABLE, rows)
    for row in rows:
        for text in row.notes:
            print(f"{row.name}: {text}")
    count = sum(outcome.target is not None for outcome in outcomes)
    print(f"Targets found for {count} of {len(outcomes)} seeds")
