"""Check before the estimation that the picked targets do not all have the same orientation."""

import numpy as np

from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.errors import PlaneNotFound
from lispac.geometry.planes import fit_plane
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.workflow.project.survey import Survey

MAX_POINTS_PER_TARGET = 500
"""Largest number of points of a target used for its orientation."""


def have_targets_single_orientation(project: Project, survey: Survey) -> bool:
    """True if several planes are used, all of one orientation that the user has not accepted.

    The sighting with the most points of each plane is used, placed with the prior boresight. The
    estimation repeats the check with the adjusted planes.
    """
    used = [
        target
        for target in project.targets_of_role("target")
        if target.used and target.used_sightings
    ]
    if len(used) < 2 or project.settings.accept_single_orientation:
        return False
    if any(target.shape == "sphere" for target in used):
        return False
    normals = []
    for target in used:
        sighting = max(target.used_sightings, key=lambda each: len(each.indices))
        cloud: Cloud | None = survey.clouds.get(sighting.line)
        if cloud is None:
            return False
        sample = sighting.indices[:: -(-len(sighting.indices) // MAX_POINTS_PER_TARGET)]
        try:
            normals.append(fit_plane(cloud[sample]).normal)
        except PlaneNotFound:
            return False  # the quality of the sighting reports this
    return have_one_orientation(np.array(normals), np.zeros(len(normals), dtype=bool))
