"""Sections through the lines of a survey, before and after the calibration."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import ProjectError
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress
from lispac.project import BoresightChoice, Project, Target
from lispac.survey.cloud import Cloud, Line
from lispac.targets.cross_section import (
    Section,
    common_normal,
    section_across_target,
    section_between,
)
from lispac.workflow.project.survey import Survey

Array = NDArray[np.float64]


EXAGGERATIONS = (1.0, 2.0, 5.0, 10.0, 20.0, 50.0)
"""Factors by which the direction across a surface may be exaggerated."""
MIN_HALF_WIDTH_M = 0.02
"""Smallest half width of a picture of lines that agree, metres: some standard deviations of the
points."""


MIN_NORMAL_IN_PICTURE = 0.5
"""Smallest part of a unit normal in the picture with which distances across the plane are shown."""


@dataclass(frozen=True, eq=False)
class SectionPoints:
    """A section through the lines, placed with the prior or the estimated boresight.

    Attributes
    ----------
    section : Section
        Position and size of the section.
    points : mapping of line name to ndarray of shape (n, 2), metres
        Positions to the right of the centre and above it.
    spread : float or None, metres
        Range of the means of the points of each line on a target, along its normal, which the
        picture must contain; None without a plane.
    normal : ndarray of shape (2,) or None
        Part of the unit normal of the plane in the picture, towards the vessel; None without a
        plane, and if the plane is nearly parallel to the picture.
    """

    which: BoresightChoice
    section: Section
    points: Mapping[str, Array]
    spread: float | None = None
    normal: Array | None = None

    @property
    def needed_half_width(self) -> float | None:
        """Half width across the surface that shows all lines, metres; None without a plane."""
        if self.spread is None or self.normal is None:
            return None
        seen = self.spread / float(np.linalg.norm(self.normal))
        return 0.6 * seen + MIN_HALF_WIDTH_M  # more than half, for points at the edges

    def automatic_exaggeration(self, proportion: float = 1.0) -> float:
        """Factor across the surface that makes the distances between the lines visible.

        The largest of `EXAGGERATIONS` with which all lines are still in a picture of the whole
        section; 1 without a plane.

        Parameters
        ----------
        proportion : length of the picture across the surface divided by that along it
        """
        needed = self.needed_half_width
        if needed is None:
            return 1.0
        half = 0.5 * min(self.section.width, self.section.height) * proportion
        return max((each for each in EXAGGERATIONS if needed * each <= half), default=1.0)


def section_at_target(
    project: Project,
    survey: Survey,
    name: str,
    *,
    level: bool = False,
    size: float = 2.0,
    thickness: float = 0.2,
    offset: float = 0.0,
    progress: Progress = no_progress,
) -> tuple[SectionPoints, ...]:
    """Cut a section through a target before and, if there is a result, after the calibration.

    Both sections have the same directions, and each passes through the centre of the target in its
    placement. A common displacement of all lines is therefore not visible.

    Parameters
    ----------
    level, size, thickness : see `section_across_target`
    offset : float, metres
        Distance of the section from the centre of the target, along its thickness.

    Raises
    ------
    ProjectError
        If there is no such target, or it has no points.
    """
    target = project.target(name)
    groups = {
        which: _sighting_points(target, clouds) for which, clouds in _placements(project, survey)
    }
    latest = list(groups.values())[-1]
    if not latest:
        raise ProjectError(error("section.no_points", target=name))
    normal = common_normal(latest.values())
    ends = np.concatenate([_end_times(survey.scans[line]) for line in latest])
    viewpoint = survey.trajectory.at(ends).position.mean(axis=0)
    middle = np.mean([points.mean(axis=0) for points in latest.values()], axis=0)
    normal = normal if normal @ (viewpoint - middle) >= 0 else -normal  # towards the vessel
    cuts = []
    for which, clouds in _placements(project, survey):
        middles = {line: points.mean(axis=0) for line, points in groups[which].items()}
        centre = np.mean(list(middles.values()), axis=0)
        section = section_across_target(
            centre, normal, viewpoint, level=level, size=size, thickness=thickness
        )
        section = replace(section, centre=section.centre + offset * section.across)
        cut = _section_points(which, clouds, section, progress)
        if target.shape == "plane":
            offsets = [float((middle - centre) @ normal) for middle in middles.values()]
            cut = replace(
                cut, spread=float(np.ptp(offsets)), normal=normal_in_picture(normal, section)
            )
        cuts.append(cut)
    return tuple(cuts)


def normal_in_picture(normal: Array, section: Section) -> Array | None:
    """Part of a unit normal in a picture, shape (2,); None if the plane is nearly parallel."""
    seen = np.array([normal @ section.right, normal @ section.up])
    return seen if np.linalg.norm(seen) > MIN_NORMAL_IN_PICTURE else None


def cut_between_points(
    project: Project,
    survey: Survey,
    first: Array,
    second: Array,
    *,
    height: float | None = None,
    thickness: float = 0.2,
    progress: Progress = no_progress,
) -> tuple[SectionPoints, ...]:
    """Cut a vertical section from one point to another, at the same position before and after.

    Parameters
    ----------
    first, second, height, thickness : see `section_between`

    Raises
    ------
    InputError
        If one point is vertically above the other.
    """
    section = section_between(first, second, height=height, thickness=thickness)
    return tuple(
        _section_points(which, clouds, section, progress)
        for which, clouds in _placements(project, survey)
    )


def _placements(
    project: Project, survey: Survey
) -> list[tuple[BoresightChoice, Mapping[str, Cloud]]]:
    placements: list[tuple[BoresightChoice, Mapping[str, Cloud]]] = [("prior", survey.clouds)]
    if project.result is not None:
        placements.append(("estimated", survey.placed(project, "estimated")))
    return placements


def _sighting_points(target: Target, clouds: Mapping[str, Cloud]) -> dict[str, Array]:
    return {s.line: clouds[s.line][s.indices] for s in target.sightings if len(s.indices)}


def _end_times(line: Line) -> Array:
    return np.array([line.first_time, line.last_time])


def _section_points(
    which: BoresightChoice, clouds: Mapping[str, Cloud], section: Section, progress: Progress
) -> SectionPoints:
    points = {}
    for k, (line, cloud) in enumerate(clouds.items()):
        progress(k / len(clouds), gettext_lazy("Computing the section of {line}", line=line))
        points[line] = section.cut_points(cloud)
    return SectionPoints(which, section, points)
