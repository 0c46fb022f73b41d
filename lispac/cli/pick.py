"""The command that picks a target."""

import sys
from argparse import Namespace
from math import radians
from typing import Any

from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.cli.qualities import as_values
from lispac.project import Target
from lispac.targets.expected import ExpectedTarget
from lispac.targets.quality import SightingQuality
from lispac.targets.sphere_finder import SpherePatch
from lispac.workflow import picking, projects
from lispac.workflow.qualities import judge_target
from lispac.workflow.seeking import thinned_words
from lispac.workflow.survey import load_survey


def pick(arguments: Namespace) -> None:
    """Find a plane or a sphere in every line and save it."""
    if arguments.sphere_radius is not None and arguments.shape != "sphere":
        raise UsageError("--sphere-radius is for spheres; add --shape sphere or leave it out")
    if arguments.expected is not None and arguments.shape != "plane":
        raise UsageError("--expected is for planes; leave it out")
    expected = None
    if arguments.expected is not None:
        width, height, tilt_deg = arguments.expected
        expected = ExpectedTarget(width, height, radians(tilt_deg))
    project = projects.open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    with ConsoleProgress() as progress:
        project = picking.pick(
            project,
            survey,
            tuple(arguments.seed),
            name=arguments.name,
            role=arguments.role,
            shape=arguments.shape,
            sphere_radius=arguments.sphere_radius,
            line=arguments.line,
            threshold=arguments.threshold,
            radius=arguments.radius,
            expected=expected,
            progress=progress,
        )
    projects.save_project(project)
    target = project.target(arguments.name)
    spheres = picking.spheres_of(target, survey) if target.shape == "sphere" else {}
    found = judge_target(project, survey, target)
    usual = picking.DEFAULT_RADII[target.role][0]
    if arguments.radius is None and target.shape == "plane" and target.radius > usual:
        print(
            f"note: {target.name}: fewer than two lines have a plane within {usual:g} m of the "
            f"seed; sought within {target.radius:g} m",
            file=sys.stderr,
        )
    for words in thinned_words(target):
        print(f"note: {words}", file=sys.stderr)
    if arguments.json:
        print_json(_as_json(target, spheres, found))
    else:
        _print(target, spheres, found)


def _as_json(
    target: Target, spheres: dict[str, SpherePatch], found: dict[str, SightingQuality]
) -> dict[str, Any]:
    lines: dict[str, dict[str, Any]] = {
        s.line: {"points": len(s.indices), "rms_m": s.rms, "quality": as_values(found[s.line])}
        for s in target.sightings
    }
    for line, patch in spheres.items():
        lines[line] |= {
            "centre_m": patch.centre.tolist(),
            "sphere_radius_m": patch.sphere.radius,
            "share_seen": patch.share,
        }
    return {
        "name": target.name,
        "role": target.role,
        "shape": target.shape,
        "sphere_radius_m": target.sphere_radius,
        "radius_m": target.radius,
        "lines": lines,
        "missing": dict(target.missing),
    }


def _print(
    target: Target, spheres: dict[str, SpherePatch], found: dict[str, SightingQuality]
) -> None:
    for sighting in target.sightings:
        print(
            f"{target.name} on {sighting.line:20s} {len(sighting.indices):8,} points, "
            f"RMS {sighting.rms * 1000:.1f} mm, {found[sighting.line].light}"
        )
        for reason in found[sighting.line].reasons:
            print(f"    {reason}")
        if sighting.line in spheres:
            patch = spheres[sighting.line]
            north, west, up = patch.centre
            known = "known" if target.sphere_radius is not None else "found"
            print(
                f"    centre {north:.3f} {west:.3f} {up:.3f} m, "
                f"radius {patch.sphere.radius:.3f} m ({known}), "
                f"{100 * patch.share:.0f} % of the surface seen"
            )
    for line, reason in target.missing.items():
        print(f"{target.name} on {line:20s} not found: {reason}")
