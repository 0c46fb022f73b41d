"""Acceptance of proposed targets into a project."""

from collections.abc import Collection
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.duplicate_targets import find_overlap
from lispac.messages import Message
from lispac.project import Project, ProposalPrediction, Target
from lispac.workflow.calibration.picking import next_name
from lispac.workflow.calibration.proposals import MAX_SHARED_POINT_SHARE, Proposal


def remove_picked_surfaces(project: Project, proposal: Proposal) -> Proposal:
    """Remove the surfaces that the project already has from a proposal, and use free names."""
    targets: list[Target] = []
    reasons: dict[str, Message] = {}
    picked: list[str] = []
    former_names: dict[str, str] = {}
    numbered = project
    for target in proposal.targets:
        own = _same_picked_target(target, project)
        if own is not None:
            picked += [own] if target.role == "target" else []
            former_names[own] = target.name
            continue
        if target.role == "validation" and _shares_points(target, project):
            continue  # it would not be independent of the adjustment
        name = next_name(numbered, target.role)
        targets.append(replace(target, name=name))
        reasons[name] = proposal.reasons[target.name]
        former_names[name] = target.name
        numbered = numbered.with_target(targets[-1])

    def predict(names: Collection[str]) -> NDArray[np.float64]:
        return proposal.predict([former_names[name] for name in names])

    return Proposal(tuple(targets), reasons, predict, tuple(picked), proposal.warnings)


def with_accepted_targets(
    project: Project, proposal: Proposal, names: Collection[str]
) -> tuple[Project, tuple[str, ...]]:
    """Add the proposed targets with given names; returns the project and their names in it.

    If a name is taken, the next free one is used. The predicted sigma is kept if the project uses
    no other targets.
    """
    new_names: list[str] = []
    targets = set(proposal.picked)
    for target in proposal.targets:
        if target.name not in names:
            continue
        is_used = any(picked.name == target.name for picked in project.targets)
        name = next_name(project, target.role) if is_used else target.name
        project = project.with_target(replace(target, name=name))
        new_names.append(name)
        targets |= {name} if target.role == "target" else set()
    used = {target.name for target in project.targets_of_role("target") if target.used}
    sigma = proposal.predicted_sigma(names)
    if used == targets and np.isfinite(sigma).all():
        project = project.with_prediction(ProposalPrediction(tuple(sorted(used)), sigma))
    return project, tuple(new_names)


def _shares_points(plane: Target, project: Project) -> bool:
    """Whether a plane has points in common with a target of the project."""
    return any(
        own.line == other.line
        and np.isin(own.indices, other.indices).mean() > MAX_SHARED_POINT_SHARE
        for target in project.targets_of_role("target")
        for own in plane.sightings
        for other in target.sightings
    )


def _same_picked_target(target: Target, project: Project) -> str | None:
    """Name of the project's target on the same surface; None if there is none."""
    # A proposed target may have the name of another, picked one.
    found = find_overlap(replace(target, name=""), project.targets)
    return found.other if found is not None and found.is_same_surface else None
