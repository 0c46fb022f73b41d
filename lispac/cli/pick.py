"""The command that picks a target."""

from argparse import Namespace
from math import degrees, radians
from typing import Any

import numpy as np

from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json
from lispac.cli.messages import print_messages
from lispac.cli.pick_list import pick_list
from lispac.duplicate_targets import find_overlap, overlap_warning
from lispac.message_texts import english_text, message_text
from lispac.messages import Message, note
from lispac.present.json_values import json_values
from lispac.present.sighting_quality import sighting_quality_values
from lispac.project import Project, Target
from lispac.targets.expected_target import ExpectedTarget
from lispac.targets.finder_settings import FinderChoices
from lispac.targets.sighting_quality import SightingQuality
from lispac.targets.sphere_finder import SpherePatch
from lispac.workflow.calibration import picking
from lispac.workflow.calibration.sighting_assessment import assess_target
from lispac.workflow.calibration.target_search import thinned_notes
from lispac.workflow.output.export_request import output_system_of
from lispac.workflow.output.output_crs import LOCAL
from lispac.workflow.project import projects
from lispac.workflow.project.coordinates import require_near_trajectory
from lispac.workflow.project.survey import load_survey


def pick(arguments: Namespace) -> None:
    """Find planes or spheres in every line and save them."""
    _require_matching_options(arguments)
    how = _search_arguments(arguments)
    with opened_project(arguments.project, change=True) as project:
        _pick_in_project(arguments, project, how)


def _pick_in_project(arguments: Namespace, project: Project, how: dict[str, Any]) -> None:
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    system = output_system_of(
        project, survey.trajectory, arguments.crs or LOCAL, arguments.height,
        arguments.trajectory_datum, arguments.epoch,
    )  # fmt: skip
    if arguments.seeds is not None:
        pick_list(arguments, project, survey, system, how)
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
    double = overlap_warning(target, project.targets)
    notes = (
        *(() if system is None else system.assumptions), *search_notes(target, how["radius"]),
        *(() if double is None else (double,)),
    )  # fmt: skip
    print_messages(notes)
    if arguments.json:
        print_json(
            target_values(target, spheres, found)
            | {"same_points_as": _shared_points_values(project, target)}
        )
    else:
        _print_target(target, spheres, found)


def _shared_points_values(project: Project, target: Target) -> dict[str, Any] | None:
    """Values of the target with the most points in common; None if there is none."""
    found = find_overlap(target, project.targets)
    if found is None:
        return None
    return {"name": found.other, "line": found.line, "share_of_the_smaller": found.share}


def _require_matching_options(arguments: Namespace) -> None:
    """Refuse options that do not go together.

    Raises
    ------
    UsageError
        If options exclude each other or a value is out of range.
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
    """Search arguments for `lispac.workflow.calibration.picking.find_target`, from the options."""
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
    """Notes on how a target was searched for; ``radius``, metres, is the one given."""
    usual = picking.DEFAULT_RADII[target.role][0]
    widened: tuple[Message, ...] = ()
    if radius is None and target.shape == "plane" and target.radius > usual:
        widened = (
            note("finder.radius_increased", target=target.name, usual=usual, radius=target.radius),
        )
    return (*widened, *thinned_notes(target))


def target_values(
    target: Target, spheres: dict[str, SpherePatch], qualities: dict[str, SightingQuality]
) -> dict[str, Any]:
    """A target with its sightings as ``pick --json`` prints it; lengths in metres."""
    lines: dict[str, dict[str, Any]] = {
        s.line: {
            "points": len(s.indices),
            "rms_m": s.rms,
            "quality": json_values(sighting_quality_values(target.name, s.line, qualities[s.line])),
        }
        for s in target.sightings
    }
    for line, patch in spheres.items():
        lines[line] |= {
            "centre_m": patch.centre.tolist(),
            "sphere_radius_m": patch.sphere.radius,
            "visible_share": patch.share,
        }
    return {
        "name": target.name,
        "role": target.role,
        "shape": target.shape,
        "sphere_radius_m": target.sphere_radius,
        "radius_m": target.radius,
        "threshold_m": target.threshold,
        "min_points": target.choices.min_points,
        "max_tilt_deg": degrees(target.choices.max_tilt),
        "stop": target.choices.stop,
        "random_seed": target.choices.seed,
        "lines": lines,
        "missing": {line: english_text(reason) for line, reason in target.missing.items()},
    }


def _print_target(
    target: Target, spheres: dict[str, SpherePatch], qualities: dict[str, SightingQuality]
) -> None:
    for sighting in target.sightings:
        print(
            f"{target.name} on {sighting.line:20s} {len(sighting.indices):8,} points, "
            f"RMS {sighting.rms * 1000:.1f} mm, {qualities[sighting.line].rating}"
        )
        for reason in qualities[sighting.line].reasons:
            print(f"    {message_text(reason)}")
        if sighting.line in spheres:
            patch = spheres[sighting.line]
            north, west, up = patch.centre
            known = "given" if target.sphere_radius is not None else "estimated"
            print(
                f"    centre {north:.3f} {west:.3f} {up:.3f} m, "
                f"radius {patch.sphere.radius:.3f} m ({known}), "
                f"{100 * patch.share:.0f} % of the surface seen"
            )
    for line, missing in target.missing.items():
        print(f"{target.name} on {line:20s} not found: {message_text(missing)}")
