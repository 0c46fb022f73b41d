"""Picking of many targets from a list of target coordinates."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from lispac.duplicate_targets import overlap_warning
from lispac.errors import ProjectError, TargetNotFound
from lispac.io.text.seed_file import PointList, read_point_list
from lispac.language import gettext_lazy
from lispac.messages import Message, as_message, error, note
from lispac.present.targets.seeds import SeedOutcomeRow, seed_outcome_row
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import Project, Role, Target, Triple
from lispac.survey.crs import CoordinateSystem
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.calibration.picking import find_target, next_name
from lispac.workflow.project.coordinates import columns_note, is_local, require_near_trajectory
from lispac.workflow.project.survey import Survey

PLANE_OPTIONS = {"shape": "plane", "sphere_radius": None, "expected": None}
"""Arguments of `find_target` for a validation plane: any plane, without an expected size."""


@dataclass(frozen=True)
class ListedSeed:
    """Seed of a target from a list.

    Attributes
    ----------
    row : int
        Row number in the list.
    place : metres, local frame
    exists : bool
        Whether the project has a target of that name.
    """

    row: int
    name: str
    role: Role
    place: Triple
    exists: bool = False


@dataclass(frozen=True)
class SeedOutcome:
    """Result of a seed: the target with a warning, or the reason why none was found."""

    seed: ListedSeed
    target: Target | None
    message: Message | None = None

    def row(self, lines: int) -> SeedOutcomeRow:
        """Row of the table of results, for a project with a number of lines."""
        seed = self.seed
        return seed_outcome_row(seed.row, seed.name, seed.role, self.target, self.message, lines)


@dataclass(frozen=True)
class SeedList:
    """Seeds read from a list, with notes.

    Attributes
    ----------
    notes : tuple of Message
        Assumptions about the coordinates.
    """

    points: PointList
    seeds: tuple[ListedSeed, ...]
    notes: tuple[Message, ...]


def read_seeds(
    path: Path,
    project: Project,
    trajectory: LocalTrajectory,
    system: CoordinateSystem | None = None,
    *,
    columns: Sequence[str] = (),
    role: Role | None = None,
) -> SeedList:
    """Read the seeds of targets from a list of coordinates.

    Parameters
    ----------
    system : CoordinateSystem or None
        Coordinate system of the list; None for the local frame.
    columns : sequence of str
        As for `lispac.io.text.seed_file.read_point_list`.
    role : {"target", "validation"}, optional
        Role of points without a role in the list; by default, points whose name begins with V are
        validation planes.

    Raises
    ------
    InputError
        If the list is not valid; the message names the row.
    """
    geographic = system is not None and system.is_geographic
    metres = (1.0, 1.0, 1.0) if system is None else system.metres
    points = read_point_list(
        path, columns=columns, local=is_local(system), degrees=geographic, metres=metres
    )
    used_names = {target.name for target in project.targets}
    # Points without a name in the list get the next free names.
    numbered = project
    seeds = []
    for point in points.points:
        own = point.role or role or role_by_name(point.name)
        name = point.name
        if not name:
            name = next_name(numbered, own)
            numbered = replace(
                numbered, targets=(*numbered.targets, _placeholder_target(name, own))
            )
        where = note("item.list_row", file=str(points.path), row=point.row, name=name)
        north, west, up = require_near_trajectory(
            np.array(point.coordinates), system, trajectory, where
        )
        place = (float(north), float(west), float(up))
        seeds.append(ListedSeed(point.row, name, own, place, name in used_names))
    return SeedList(points, tuple(seeds), _list_notes(points, system))


def role_by_name(name: str) -> Role:
    """Role by the name: a name that begins with V means a validation plane."""
    return "validation" if name[:1] in ("V", "v") else "target"


def require_free_names(seeds: SeedList) -> None:
    """Refuse names that are already used by targets of the project.

    Raises
    ------
    ProjectError
        If a name of the list is already used.
    """
    for seed in seeds.seeds:
        if seed.exists:
            raise ProjectError(
                error(
                    "pick.name_taken", file=str(seeds.points.path), row=seed.row, target=seed.name
                )
            )


def pick_seeds(
    project: Project,
    survey: Survey,
    seeds: Collection[ListedSeed],
    how: Mapping[str, Any],
    *,
    progress: Progress = no_progress,
) -> tuple[Project, tuple[SeedOutcome, ...]]:
    """Find the target at every seed, and add those found to the project.

    Parameters
    ----------
    how : mapping
        Further arguments of `picking.find_target`: threshold, radius, shape.
        Shape and expected size apply to targets; a validation plane is a plane of any size.

    Raises
    ------
    InputError
        If a search setting is not valid; then no target is picked.
    ProjectError
        If a seed is not valid for a search; then no target is picked.
    """
    outcomes = []
    for k, seed in enumerate(seeds):
        step = sub_progress(progress, k / len(seeds), (k + 1) / len(seeds))
        step(
            0.0,
            gettext_lazy(
                "Searching for {target} ({number:n} of {count:n})",
                target=seed.name,
                number=k + 1,
                count=len(seeds),
            ),
        )
        options = dict(how) if seed.role == "target" else {**how, **PLANE_OPTIONS}
        try:
            target = find_target(
                project,
                survey,
                seed.place,
                name=seed.name,
                role=seed.role,
                progress=step,
                **options,
            )
        except TargetNotFound as failure:
            outcomes.append(SeedOutcome(seed, None, as_message(failure.reason)))
            continue
        outcomes.append(SeedOutcome(seed, target, overlap_warning(target, project.targets)))
        project = project.with_target(target)
    return project, tuple(outcomes)


def require_any_found(seeds: SeedList, outcomes: Sequence[SeedOutcome]) -> None:
    """Raise an error if no seed of a list led to a target.

    Raises
    ------
    TargetNotFound
        If the list has seeds, and no target was found at any of them.
    """
    if outcomes and all(outcome.target is None for outcome in outcomes):
        first = outcomes[0]
        raise TargetNotFound(
            error(
                "pick.none_found",
                file=str(seeds.points.path),
                count=len(outcomes),
                target=first.seed.name,
                row=first.seed.row,
                reason="" if first.message is None else first.message,
            )
        )


def require_all_found(seeds: SeedList, outcomes: Sequence[SeedOutcome]) -> None:
    """Raise an error if some seed of a list led to no target.

    Raises
    ------
    TargetNotFound
        If there are such seeds; the message names them with the reasons.
    """
    failed = [outcome.seed for outcome in outcomes if outcome.target is None]
    if failed:
        raise TargetNotFound(
            error(
                "pick.some_not_found",
                file=str(seeds.points.path),
                count=len(failed),
                total=len(outcomes),
                seeds=[seed.name for seed in failed],
                rows=[str(seed.row) for seed in failed],
            )
        )


def _placeholder_target(name: str, role: Role) -> Target:
    return Target(name, role, (0.0, 0.0, 0.0), 1.0, 1.0, ())


def _list_notes(points: PointList, system: CoordinateSystem | None) -> tuple[Message, ...]:
    order = columns_note(points, system)
    if system is None:
        return order, note("assumed.local_frame")
    return order, note("assumed.list_system", system=system.name), *system.assumptions
