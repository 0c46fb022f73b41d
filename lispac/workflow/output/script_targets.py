"""Targets in a project's script: by their seeds where these lead to them, else by their points."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from lispac.errors import LispacError
from lispac.progress import Progress
from lispac.project import PickedSighting, Project, Target
from lispac.targets.finder_settings import USUAL
from lispac.targets.line_search import CLICK_GAP
from lispac.workflow.calibration.picking import find_target
from lispac.workflow.calibration.point_numbers import numbers_text
from lispac.workflow.calibration.target_search import TargetSearch
from lispac.workflow.output.script_text import PythonCode, call_text, rows, split_text_code
from lispac.workflow.project.survey import Survey

BY_HAND = "its points were edited manually"
OTHERWISE = (
    "the search from its seed now gives other points, because it was found with other lines or "
    "another prior boresight, or proposed automatically"
)


def target_steps(
    project: Project, survey: Survey, target: Target, progress: Progress
) -> Iterator[str]:
    """Steps of a script that give a project this target."""
    by_hand = any(sighting.by_hand for sighting in target.sightings)
    seeded = None if by_hand else _seed_arguments(project, survey, target, progress)
    if seeded is not None:
        yield call_text("project.seed", target.name, target.seed, **seeded)
    else:
        yield f"# {target.name}: {BY_HAND if by_hand else OTHERWISE}."
        yield call_text("project.put", _target_code(target))
    for sighting in target.sightings:
        if not sighting.used:
            yield call_text("project.reject", target.name, sighting.line)
    if not target.used:
        yield call_text("project.reject", target.name)


def _seed_arguments(
    project: Project, survey: Survey, target: Target, progress: Progress
) -> dict[str, Any] | None:
    """Arguments with which the seed leads to the target; None where there are none."""
    search = TargetSearch.for_target(target)
    named: dict[str, Any] = {
        "role": (target.role, "target"),
        "shape": (target.shape, "plane"),
        "sphere_radius": (target.sphere_radius, None),
        "threshold": (target.threshold, search.threshold(project.settings.threshold)),
        "radius": (target.radius, search.search_radii(target.role)[0]),
        "expected": (target.expected, None),
        "choices": (target.choices, USUAL),
    }
    given = {name: value for name, (value, usual) in named.items() if value != usual}
    # Where lines meet at the seed, or none has a point there, it counts which of them was clicked.
    place = np.array(target.seed)
    clicked = [
        line for line in survey.lines if len(survey.clouds[line].within(place, CLICK_GAP).points)
    ]
    for line in (None, *(clicked or [sighting.line for sighting in target.sightings])):
        try:
            found = find_target(
                project, survey, target.seed, name=target.name, first_line=line,
                progress=progress, **given,
            )  # fmt: skip
        except LispacError:
            continue
        if _is_same_target(found, target):
            return given if line is None else {**given, "clicked_on": line}
    return None


def _is_same_target(picked: Target, target: Target) -> bool:
    def properties(each: Target) -> tuple[object, ...]:
        return each.threshold, each.radius, dict(each.missing), len(each.sightings)

    return properties(picked) == properties(target) and all(
        (one.line, one.rms, one.one_in) == (other.line, other.rms, other.one_in)
        and np.array_equal(one.indices, other.indices)
        for one, other in zip(picked.sightings, target.sightings, strict=True)
    )


def _target_code(target: Target) -> PythonCode:
    """A target with all its points, all of which take part."""
    named: dict[str, Any] = {
        "name": target.name, "role": target.role, "seed": target.seed,
        "threshold": target.threshold, "radius": target.radius,
        "sightings": rows([_sighting_code(sighting) for sighting in target.sightings]),
    }  # fmt: skip
    if target.missing:
        named["missing"] = dict(target.missing)
    if target.shape != "plane":
        named |= {"shape": target.shape, "sphere_radius": target.sphere_radius}
    if target.expected is not None:
        named["expected"] = target.expected
    if target.choices != USUAL:
        named["choices"] = target.choices
    return PythonCode(call_text("lispac.Target", **named))


def _sighting_code(sighting: PickedSighting) -> PythonCode:
    points = PythonCode(
        call_text("lispac.point_numbers", split_text_code(numbers_text(sighting.indices)))
    )
    named: dict[str, Any] = {"rms": sighting.rms, "fingerprint": sighting.fingerprint}
    if sighting.one_in != 1:
        named["one_in"] = sighting.one_in
    if sighting.by_hand:
        named["by_hand"] = True
    return PythonCode(call_text("lispac.PickedSighting", sighting.line, points, **named))
