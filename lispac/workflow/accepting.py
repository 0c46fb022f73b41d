"""What of a proposal goes into a project."""

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from lispac.project import Project, Target
from lispac.workflow.picking import next_name
from lispac.workflow.proposing import Proposal

SAME = 0.3
"""Share of a sighting's points that another has too, from which both are the same surface."""


def not_picked(project: Project, proposal: Proposal) -> Proposal:
    """The proposal without the surfaces that the project has already."""
    kept = tuple(
        target
        for target in proposal.targets
        if not any(same_surface(target, picked) for picked in project.targets)
    )
    return replace(
        proposal,
        targets=kept,
        reasons={target.name: proposal.reasons[target.name] for target in kept},
    )


def with_accepted(
    project: Project, proposal: Proposal, names: Collection[str]
) -> tuple[Project, tuple[str, ...]]:
    """The project with the proposed targets of these names, and the names they have there.

    A name that is taken gives way to the next free one.
    """
    given = []
    for target in proposal.targets:
        if target.name not in names:
            continue
        taken = any(picked.name == target.name for picked in project.targets)
        name = next_name(project, target.role) if taken else target.name
        project = project.with_target(replace(target, name=name))
        given.append(name)
    return project, tuple(given)


def same_surface(one: Target, other: Target) -> bool:
    """Whether two targets have a good part of their points in common on some line."""
    for sighting in one.sightings:
        seen = other.sighting(sighting.line)
        if seen is None or not len(seen.indices) or not len(sighting.indices):
            continue
        shared = np.isin(sighting.indices, seen.indices, kind="sort").sum()
        if shared > SAME * min(len(sighting.indices), len(seen.indices)):
            return True
    return False
