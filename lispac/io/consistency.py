"""Whether a project that was read is one that the program can have written."""

import numpy as np

from lispac.io.values import Unfit
from lispac.project import ROLES, SHAPES, Project, require_target


def require_consistent(project: Project) -> None:
    """Refuse values that only an edit by hand can have brought in.

    Raises
    ------
    Unfit
    """
    project.settings.require_sound()
    project.identity.require_sound()
    lines = {line.name for line in project.lines}
    for target in project.targets:
        if target.role not in ROLES:
            raise Unfit(f"{target.name} has the role {target.role!r}")
        if target.shape not in SHAPES:
            raise Unfit(f"{target.name} has the shape {target.shape!r}")
        require_target(target)
        if not (np.isfinite(target.seed).all() and target.threshold > 0 and target.radius > 0):
            raise Unfit(f"seed, threshold or radius of {target.name}")
        for sighting in target.sightings:
            if sighting.line not in lines:
                raise Unfit(f"{target.name} is on a line {sighting.line} that is not listed")
    for opinion in project.opinions:
        if not opinion.is_sound():
            raise Unfit(f"the answer of {opinion.method}")
