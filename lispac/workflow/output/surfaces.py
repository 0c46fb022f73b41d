"""Geometry of the targets and sections of the validation planes of a survey, for the report."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound, SphereNotFound
from lispac.present.checking.distance_maps import HORIZONTAL_MAP_AXES, MAP_AXES
from lispac.present.targets.surface_geometry import PlaneSection, plane_section
from lispac.project import Project, Target
from lispac.survey.cloud import Cloud
from lispac.targets.surface_geometry import (
    SurfaceGeometry,
    plane_geometry,
    section_axis,
    section_points,
    sphere_geometry,
)
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]
MIN_POINTS = 3
"""Smallest number of points of a line that is used."""


def surface_geometries(project: Project, survey: Survey) -> dict[str, SurfaceGeometry]:
    """Geometry of each target and validation plane with the best known boresight, by name."""
    clouds = survey.placed(project, "prior" if project.result is None else "estimated")
    found = {}
    for target in project.targets:
        groups = _used_points(target, clouds)
        if not groups:
            continue
        scans = [survey.scans[line] for line in groups]
        ends = np.array([time for scan in scans for time in (scan.first_time, scan.last_time)])
        try:
            found[target.name] = (
                sphere_geometry(groups, target.sphere_radius)
                if target.shape == "sphere"
                else plane_geometry(groups, survey.trajectory.at(ends).position.mean(axis=0))
            )
        except (PlaneNotFound, SphereNotFound):
            continue
    return found


def plane_sections(
    project: Project, survey: Survey, geometries: Mapping[str, SurfaceGeometry]
) -> tuple[PlaneSection, ...]:
    """Sections of the validation planes on which the lines were compared."""
    if project.result is None:
        return ()
    placed = [survey.placed(project, which) for which in ("prior", "estimated")]
    places = {line.name: k for k, line in enumerate(project.lines)}
    sections = []
    for plane in project.validation:
        geometry = geometries.get(plane.name)
        if geometry is None or geometry.normal is None:
            continue
        target = project.target(plane.name)
        before, after = (
            section_points(_used_points(target, clouds), geometry) for clouds in placed
        )
        axes = HORIZONTAL_MAP_AXES if geometry.is_horizontal else MAP_AXES
        title = axes[section_axis(geometry)]
        sections.append(plane_section(plane.name, title, places, before, after))
    return tuple(sections)


def _used_points(target: Target, clouds: Mapping[str, Cloud]) -> dict[str, Array]:
    """Points (n, 3) of a target on each line on which it is used."""
    sightings = [each for each in target.sightings if each.used and each.line in clouds]
    return {
        each.line: clouds[each.line][each.indices]
        for each in sightings
        if len(each.indices) >= MIN_POINTS
    }
