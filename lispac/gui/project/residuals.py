"""Colours of the points of sightings by their distance from the surface.

The surface of a target is the adjusted one. The surface of a validation plane, which is not used in
the adjustment, is the plane fitted to the points of all lines as displayed: the lines differ in
colour before the calibration and have about the same colour after it.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, fit_plane
from lispac.geometry.spheres import Sphere
from lispac.gui.appearance import units
from lispac.gui.viewport.base import Array, PointColouring
from lispac.language import N_, gettext
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.workflow.project.survey import Survey

LEGEND_TITLE = N_("Residual (mm), positive: nearer to the vessel")
OTHER_POINTS_COLOUR = (188, 194, 200)
"""Colour of points that belong to no target."""
PERCENT_BEYOND_SCALE, PERCENT_OFFSETS_BEYOND_SCALE = 2.0, 5.0
"""Percentage of the points, and of the sightings by the median of their points, beyond the ends of
the scale. Neither single points nor a single wrong sighting determine them."""
MIN_COLOUR_LIMIT_M = 0.005
"""Smallest distance at the end of the colour scale, metres."""

SightingKey = tuple[str, str]


def residuals(project: Project, survey: Survey) -> dict[SightingKey, Array]:
    """Signed distances of all points of the adjusted sightings, positive towards the vessel.

    Returns
    -------
    ndarray of shape (n,), metres, by target and line
        Distances from the surfaces after the adjustment.

    Raises
    ------
    ValueError
        If nothing has been adjusted yet; the text is in the language of the window.
    """
    if project.result is None:
        raise ValueError(
            gettext("There are no residuals before an adjustment. Estimate the boresight first.")
        )
    clouds = survey.placed(project, "estimated")
    found = {}
    for fit in project.result.targets:
        values = fit.plane
        surface = Sphere(values[:3], float(values[3])) if fit.sphere else None
        plane = Plane(values[:3], float(values[3]))
        if fit.vessel_side is None:  # a result of an earlier version
            plane = _facing_vessel(plane, survey)
        elif fit.vessel_side < 0:
            plane = plane.flipped()
        target = next((each for each in project.targets if each.name == fit.target), None)
        for sighting in target.used_sightings if target is not None else ():
            points = clouds[sighting.line][sighting.indices]
            distances = plane.distances(points) if surface is None else surface.distances(points)
            found[fit.target, sighting.line] = distances
    return found


def _facing_vessel(plane: Plane, survey: Survey) -> Plane:
    """The same plane, with its normal on the side of the vessel."""
    distance = plane.distances(survey.trajectory.position.mean(axis=0))
    return plane if distance >= 0.0 else plane.flipped()


def validation_distances(
    project: Project, survey: Survey, clouds: Mapping[str, Cloud]
) -> dict[SightingKey, Array]:
    """Signed distances of the points on validation planes from the plane through all lines.

    They are positive towards the vessel.

    Parameters
    ----------
    clouds : points of each line, as displayed

    Returns
    -------
    ndarray of shape (n,), metres, by plane and line
    """
    found = {}
    for target in project.targets_of_role("validation"):
        points = {
            sighting.line: clouds[sighting.line][sighting.indices]
            for sighting in (target.used_sightings if target.used else ())
            if sighting.line in clouds
        }
        if len(points) > 1:
            plane = _facing_vessel(fit_plane(np.concatenate(list(points.values()))), survey)
            found |= {(target.name, line): plane.distances(own) for line, own in points.items()}
    return found


def colour_limit_for(residuals_by_sighting: Mapping[SightingKey, Array]) -> float:
    """Distance at the end of the colour scale, metres: 1, 2 or 5 times a power of ten."""
    parts = [values for values in residuals_by_sighting.values() if len(values)]
    points = np.abs(np.concatenate(parts))
    offsets = np.abs([np.median(values) for values in parts])
    needed = max(
        float(np.percentile(points, 100 - PERCENT_BEYOND_SCALE)),
        float(np.percentile(offsets, 100 - PERCENT_OFFSETS_BEYOND_SCALE)),
        MIN_COLOUR_LIMIT_M,
    )
    power = 10.0 ** np.floor(np.log10(needed))
    return float(next(step * power for step in (1, 2, 5, 10) if step * power >= needed * 0.999))


def residual_shading(
    project: Project,
    survey: Survey,
    clouds: Mapping[str, Cloud],
    *,
    colour_limit: float | None = None,
) -> tuple[PointColouring, dict[SightingKey, NDArray[np.uint8]]]:
    """Grey lines with a legend, and colours of the points of the sightings.

    Red points are nearer to the vessel than the surface, blue ones farther away.

    Parameters
    ----------
    clouds : points of each line, as displayed
    colour_limit : float or None, metres
        Distance at the end of the colour scale; None to compute it from these clouds.

    Raises
    ------
    ValueError
        If nothing has been adjusted yet; the text is in the language of the window.
    """
    from matplotlib import colormaps

    found = residuals(project, survey) | validation_distances(project, survey, clouds)
    colour_limit = colour_limit_for(found) if colour_limit is None else colour_limit
    scale = np.asarray(
        np.round(255 * colormaps["coolwarm"](np.linspace(0, 1, 255))[:, :3]), dtype=np.uint8
    )
    colours = {
        key: scale[np.clip(np.round(127 * (1 + values / colour_limit)), 0, 254).astype(np.int64)]
        for key, values in found.items()
    }
    grey = {
        line: np.broadcast_to(np.array(OTHER_POINTS_COLOUR, np.uint8), (len(cloud.sample), 3))
        for line, cloud in clouds.items()
    }
    low, high = _legend_ends(colour_limit)
    with units.standard_units():
        metric = _legend_ends(colour_limit)
    return PointColouring(grey, gettext(LEGEND_TITLE), low, high, scale, metric), colours


def _legend_ends(colour_limit: float) -> tuple[str, str]:
    end = units.local_figure(1000 * colour_limit, "mm", ".0f")
    return f"\N{MINUS SIGN}{end}", f"+{end}"
