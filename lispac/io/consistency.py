"""Whether a project that was read is one that the program can have written."""

import numpy as np

from lispac.foreign_values import InvalidContentError
from lispac.messages import error
from lispac.project import ROLES, SHAPES, Project, require_target


def require_consistent(project: Project) -> None:
    """Refuse values that only an edit by hand can have brought in.

    Raises
    ------
    InvalidContentError
    """
    project.settings.require_sound()
    project.identity.require_sound()
    lines = {line.name for line in project.lines}
    for target in project.targets:
        if target.role not in ROLES:
            raise InvalidContentError(
                error("content.unknown_role", target=target.name, role=str(target.role))
            )
        if target.shape not in SHAPES:
            raise InvalidContentError(
                error("content.unknown_shape", target=target.name, shape=str(target.shape))
            )
        require_target(target)
        if not (np.isfinite(target.seed).all() and target.threshold > 0 and target.radius > 0):
            raise InvalidContentError(error("content.invalid_search", target=target.name))
        for sighting in target.sightings:
            if sighting.line not in lines:
                raise InvalidContentError(
                    error("content.unknown_line", target=target.name, line=sighting.line)
                )
    for opinion in project.opinions:
        if not opinion.is_sound():
            raise InvalidContentError(error("content.invalid_angles", method=opinion.method))
