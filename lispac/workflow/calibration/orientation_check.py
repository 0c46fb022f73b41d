"""Check that the picked targets do not all face one way, before the estimation."""

import numpy as np

from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.errors import PlaneNotFound
from lispac.geometry.planes import fit_plane
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.workflow.project.survey import Survey

MAX_POINTS = 500
"""Points of a target used for its orientation."""


def do_targets_face_one_way(project: Project, survey: Survey) -> bool:
    """True if several planes are in use that all face one way, and the user has not accepted it.

    Judged by the sighting with most points of each, as the lines lie before the calibration; the
    estimate judges by the adjusted planes.
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
        sample = sighting.indices[:: -(-len(sighting.indices) // MAX_POINTS)]
        try:
            normals.append(fit_plane(cloud[sample]).normal)
        except PlaneNotFound:
            return False  # its quality shows this
    return have_one_orientation(np.array(normals), np.zeros(len(normals), dtype=bool))
