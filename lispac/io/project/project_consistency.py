"""Consistency checks of a project after reading."""

from collections.abc import Iterator

import numpy as np

from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.message_texts import has_text
from lispac.messages import Message, error
from lispac.project import ROLES, SHAPES, Project, require_valid_target
from lispac.targets.finder_settings import is_possible_search
from lispac.untrusted_values import INTEGER_LIMIT, InvalidContentError

MAX_COORDINATE_M, MAX_RMS_M, MAX_ANGLE_DEG = 1e8, 1e6, 360.0
"""Limits: coordinates in a local frame, metres; RMS of a sighting about its plane, metres; angles,
degrees."""


def require_consistent(project: Project) -> None:
    """Refuse values that the program cannot have written.

    Raises
    ------
    InvalidContentError
        If a value, name or stored message is impossible, or contradicts another one.
    """
    project.settings.require_sound()
    project.identity.require_sound()
    project.acceptance.require_sound()
    lines = {line.name for line in project.lines}
    require_unique_names(project)
    if project.truth_deg is not None and not np.abs(project.truth_deg).max() <= MAX_ANGLE_DEG:
        raise InvalidContentError(error("content.invalid_truth"))
    for target in project.targets:
        if target.role not in ROLES:
            raise InvalidContentError(
                error("content.unknown_role", target=target.name, role=str(target.role))
            )
        if target.shape not in SHAPES:
            raise InvalidContentError(
                error("content.unknown_shape", target=target.name, shape=str(target.shape))
            )
        require_valid_target(target)
        is_near = np.abs(target.seed).max() <= MAX_COORDINATE_M
        if not (is_near and is_possible_search(target.threshold, target.radius)):
            raise InvalidContentError(error("content.invalid_search", target=target.name))
        for sighting in target.sightings:
            if sighting.line not in lines:
                raise InvalidContentError(
                    error("content.unknown_line", target=target.name, line=sighting.line)
                )
            if not (0 <= sighting.rms <= MAX_RMS_M and 1 <= sighting.one_in < INTEGER_LIMIT):
                raise InvalidContentError(
                    error("content.invalid_sighting", target=target.name, line=sighting.line)
                )
    names = [file.path.name for file in project.control]
    for file in project.control:
        file.require_sound()
        if names.count(file.path.name) > 1:
            raise InvalidContentError(error("content.duplicate_control", name=file.path.name))
    if project.result is not None:
        _require_consistent_result(project.result)
    for alternative in project.alternative_results:
        if not alternative.is_sound():
            raise InvalidContentError(error("content.invalid_angles", method=alternative.method))
    for message in _stored_messages(project):
        if not has_text(message):
            raise InvalidContentError(error("content.unknown_message", code=message.code))


def _require_consistent_result(result: AdjustmentResult) -> None:
    """Refuse a result whose parts name different angles, targets or sightings.

    Raises
    ------
    InvalidContentError
        If they do.
    """
    sightings = {each.sighting for each in result.sightings}
    targets = {each.target for each in result.targets}
    without_line = result.observability.sigma_without_line if result.observability else {}
    if (
        len(result.covariance_all) != len(result.estimated)
        or len(result.estimated) < len(ANGLES)
        or not {each.target for each in sightings} <= targets
        or not {each.sighting for each in result.reliability} <= sightings
        or any(
            each is not None and not (each.shape == (3,) and (each >= 0).all())
            for each in without_line.values()
        )
        or not (np.diagonal(result.covariance_all) >= 0).all()
        or not (result.pos_corrections is None or result.pos_corrections.is_sound)
    ):
        raise InvalidContentError(error("content.inconsistent_result"))


def _stored_messages(project: Project) -> Iterator[Message]:
    """Messages stored with the targets and results of a project."""
    for target in project.targets:
        yield from target.missing.values()
    for file in project.control:
        yield from (point.reason for point in file.points if point.reason is not None)
    yield from project.not_compared.values()
    result, checks = project.result, project.cross_checks
    reasons: list[Message | None] = []
    if result is not None:
        reasons += [each.reason for each in result.parameters]
        yield from result.messages
        yield from () if result.observability is None else result.observability.messages
    if checks is not None:
        reasons += [part.reason for part in checks.parts]
    yield from (reason for reason in reasons if reason is not None)
    yield from () if project.absolute is None else project.absolute.not_compared
    for alternative in project.alternative_results:
        yield from alternative.messages


def require_unique_names(project: Project) -> None:
    """Refuse two targets or two lines with the same name.

    Raises
    ------
    InvalidContentError
        If a name occurs twice.
    """
    lines, targets = (
        [each.name for each in named_items] for named_items in (project.lines, project.targets)
    )
    for line in lines:
        if lines.count(line) > 1:
            raise InvalidContentError(error("content.duplicate_line", line=line))
    for target in targets:
        if targets.count(target) > 1:
            raise InvalidContentError(error("content.duplicate_target", target=target))
