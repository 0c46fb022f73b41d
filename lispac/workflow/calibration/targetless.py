"""Targetless estimation of the boresight from surfaces of the scene.

Patches of natural surfaces are used as targets in the same adjustment: their points are averaged,
weighted and tested like those of boards. The scene is divided into patches again with each new
boresight until the angles converge, at most as many times as `ITERATION_THRESHOLDS` has values.
"""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.excess_scatter import raise_sigmas_by_scatter
from lispac.adjustment.diagnostics.line_shifts import LineShiftScores
from lispac.adjustment.diagnostics.observability import assess_observability
from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.result import AdjustmentResult
from lispac.computing_time import computing_time
from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.natural.patch_choice import MAX_PATCHES, PatchChoice, choose_patches
from lispac.natural.patches import Patches, find_patches
from lispac.progress import Progress, no_progress, sub_progress
from lispac.project import PickedSighting, Project, Target
from lispac.survey.cloud import Cloud, place_clouds
from lispac.survey.georeferencing import Mounting
from lispac.workflow.calibration.estimation import observations_of, reselect_points
from lispac.workflow.calibration.method_errors import replace_suggested_actions
from lispac.workflow.project.survey import Survey

Indices = NDArray[np.int64]

ITERATION_THRESHOLDS = (0.06, 0.03, 0.03, 0.03, 0.03)
"""Largest distance of a point of any line from its region in each iteration, metres, as in
`find_patches`. The threshold of the project is used if it is larger. The first value is the
displacement of a point by a boresight error of 0.1 deg at a range of 34 m."""
COARSE_SPACING = 0.3
"""Distance over which points are averaged in the iterations before the final adjustment, metres."""
CONVERGENCE_LIMIT = 0.1
"""Change of an angle, as a share of its predicted sigma, below which the iteration ends."""
MIN_PATCHES = 4
"""Smallest number of chosen patches; with fewer the result could not be checked."""
MAX_REJECTED_SHARE = 0.3
"""Share of rejected sightings from which a line is reported as disagreeing, if there are at least
two."""


@dataclass(frozen=True, eq=False)
class TargetlessResult:
    """Result of the targetless method.

    Attributes
    ----------
    project : Project
        Project whose targets are the chosen patches, with the project's own targets if these were
        adjusted together with them, and the result.
    iterations : int
        Number of times that the scene was divided into patches.
    converged : bool
        Whether each angle changed by less than `CONVERGENCE_LIMIT` of its sigma in the last
        iteration.
    candidates : int
        Number of patches found in the last iteration, of which the best were chosen.
    disagreeing_lines : tuple of str
        Lines that share no surface with the others or disagree with them; see
        `disagreeing_lines`.
    targets : int
        Number of the project's own targets that were adjusted with the patches.
    raised : float
        Largest factor on the sigma of an angle for scatter that the stochastic model does not
        predict.
    """

    project: Project
    iterations: int
    converged: bool
    candidates: int
    disagreeing_lines: tuple[str, ...]
    targets: int = 0
    raised: float = 1.0

    @property
    def result(self) -> AdjustmentResult:
        """Result of the adjustment."""
        assert self.project.result is not None
        return self.project.result

    @property
    def messages(self) -> tuple[Message, ...]:
        """Messages on the data used and the limits of the result."""
        used = len(self.project.targets) - self.targets
        found = [note("targetless.basis", used=used, total=self.candidates, rounds=self.iterations)]
        if self.targets:
            found.append(note("targetless.with_targets", targets=self.targets))
        if not self.converged:
            found.append(note("targetless.not_converged", share=CONVERGENCE_LIMIT))
        if self.disagreeing_lines:
            found.append(note("targetless.lines_disagree", lines=self.disagreeing_lines))
        return tuple(found)


def targetless(
    project: Project,
    survey: Survey,
    *,
    count: int = MAX_PATCHES,
    with_targets: bool = False,
    progress: Progress = no_progress,
) -> TargetlessResult:
    """Find the boresight from surfaces of the scene that the lines share.

    Parameters
    ----------
    count : int
        Largest number of surfaces that are adjusted.
    with_targets : bool
        Whether to adjust the project's targets together with the surfaces.

    Raises
    ------
    AdjustmentError
        If there is only one line, the lines share too few surfaces, or these do not determine the
        boresight; with targets also if none of these is used on two lines.
    """
    settings = project.settings
    settings.require_sound()
    if len(survey.clouds) < 2:
        raise AdjustmentError(error("targetless.single_line", project=project.name))
    own = _targets_only(project) if with_targets else None
    started = computing_time()
    progress(0.0, gettext_lazy("Aligning the lines"))
    matched = _match_lines(project, survey, count, progress)
    picked, mixed = matched.picked, 0
    if own is not None:
        mine = reselect_points(own, survey, progress=sub_progress(progress, 0.4, 0.5)).targets
        picked = replace(picked, targets=(*mine, *_surfaces_off_targets(picked.targets, mine)))
        mixed = len(mine)
    observations = observations_of(picked, survey, mounting=matched.mounting)
    with replace_suggested_actions(project.name, "targetless"):
        result = adjust(
            observations,
            project.mounting("prior"),
            settings.stochastic_model,
            parameters=settings.parameters,
            components=settings.variance_components,
            assumed=project.assumed_sigmas,
            accept_single_orientation=settings.accept_single_orientation,
            test_model=False,  # parts of the scene and of the lines test it better
            progress=sub_progress(progress, 0.5, 0.9),
        )
    raised_result, shifted = _raise_sigmas(
        project, observations, result, progress=sub_progress(progress, 0.9, 1.0)
    )
    raised = float((raised_result.sigma / result.sigma).max())
    final = replace(picked, result=replace(raised_result, elapsed=computing_time() - started))
    named = disagreeing_lines(result, survey.clouds, shifted)
    return TargetlessResult(
        final, matched.iterations, matched.converged, matched.candidates, named, mixed, raised
    )


@dataclass(frozen=True, eq=False)
class _MatchedLines:
    """Patches of the last iteration as targets of a project, and the boresight found with them.

    Attributes
    ----------
    iterations, converged, candidates : see `TargetlessResult`
    """

    picked: Project
    mounting: Mounting
    iterations: int
    converged: bool
    candidates: int


def _match_lines(project: Project, survey: Survey, count: int, progress: Progress) -> _MatchedLines:
    """Divide the scene into patches and adjust them, until the boresight converges.

    Raises
    ------
    AdjustmentError
        If the lines share too few surfaces, or these do not determine the boresight.
    """
    settings = project.settings
    # The initial boresight does not depend on the error of the prior boresight.
    mounting = survey.alignment.mounting
    coarse = replace(settings, subsample=max(settings.subsample, COARSE_SPACING), parameters=())
    coarse_model = replace(
        settings.stochastic_model, pos_errors="independent", loss="huber", lever_arm_sigma=None
    )
    picked, found, iterations, converged = project, 0, 0, False
    for iterations, threshold in enumerate(ITERATION_THRESHOLDS, 1):
        step = sub_progress(progress, 0.1 * iterations, 0.1 * iterations + 0.1)
        step(0.0, gettext_lazy("Matching the lines: iteration {number:n}", number=iterations))
        clouds = place_clouds(survey.clouds, mounting)
        patches = find_patches(
            clouds, survey.lidar_sigma(settings), max(threshold, settings.threshold),
            progress=sub_progress(step, 0.0, 0.6),
        )  # fmt: skip
        choice = choose_patches(patches, clouds, survey.accuracy, count)
        found = len(patches)
        if len(choice.rows) < MIN_PATCHES:
            raise AdjustmentError(
                error(
                    "targetless.few_surfaces",
                    project=project.name,
                    count=len(choice.rows),
                    least=MIN_PATCHES,
                )
            )
        picked = replace(
            project, targets=_targets_of_patches(patches, choice, clouds, survey), result=None
        )
        observations = observations_of(picked, survey, settings=coarse, mounting=mounting)
        with replace_suggested_actions(project.name, "targetless"):
            result = adjust(
                observations, mounting, coarse_model,
                accept_single_orientation=settings.accept_single_orientation, diagnostics=False,
                progress=sub_progress(step, 0.7, 1.0),
            )  # fmt: skip
        changes = np.abs(result.boresight - mounting.boresight)
        mounting = mounting.with_boresight(result.boresight)
        # The sigmas of the coarse model are far too small to be used as a tolerance.
        converged = iterations > 1 and bool((changes < CONVERGENCE_LIMIT * choice.sigma).all())
        if converged:
            break
    return _MatchedLines(picked, mounting, iterations, converged, found)


def _raise_sigmas(
    project: Project, observations: Observations, result: AdjustmentResult, *, progress: Progress
) -> tuple[AdjustmentResult, tuple[str, ...]]:
    """Raise the standard deviations by scatter that the stochastic model does not predict.

    Returns
    -------
    result : AdjustmentResult
    lines : tuple of str
        Lines that are shifted relative to the others.
    """
    settings = project.settings
    solved = SolvedEquations.of(
        result,
        observations.with_scaled_sigmas(*result.sigma_factors),
        project.mounting("prior"),
        settings.parameters,
        progress=sub_progress(progress, 0.0, 0.5),
    )
    if solved is None:
        return result, ()
    raised = raise_sigmas_by_scatter(
        result, solved.linearised, solved.origins, progress=sub_progress(progress, 0.5, 1.0)
    )
    if raised.observability is not None and raised.angle_sigma_factors is not None:
        seen = assess_observability(
            solved.linearised,
            angle_sigma_factors=raised.angle_sigma_factors,
            covariance=raised.covariance,
            added_variance=np.diag(raised.lever_arm_covariance)[:3],
            origins=solved.origins,
        )
        raised = replace(raised, observability=seen)
    return raised, LineShiftScores.of(solved.linearised).shifted_lines()


def _targets_only(project: Project) -> Project:
    targets = tuple(target for target in project.targets_of_role("target") if target.used)
    if not targets:
        raise AdjustmentError(error("targetless.no_target", project=project.name))
    return replace(project, targets=targets, result=None)


def _surfaces_off_targets(
    surfaces: tuple[Target, ...], targets: tuple[Target, ...]
) -> tuple[Target, ...]:
    """Surfaces of the scene that contain no points of the targets, with names that are not taken.

    The points of a board would otherwise be used twice.
    """
    on: dict[str, list[Indices]] = {}
    for target in targets:
        for sighting in target.sightings:
            on.setdefault(sighting.line, []).append(sighting.indices)
    used_points = {line: np.concatenate(parts) for line, parts in on.items()}
    names = {target.name for target in targets}

    def is_free(surface: Target) -> bool:
        return not any(
            np.isin(each.indices, used_points[each.line]).any()
            for each in surface.sightings
            if each.line in used_points
        )

    return tuple(
        replace(each, name=f"{each.name}*") if each.name in names else each
        for each in surfaces
        if is_free(each)
    )


def _targets_of_patches(
    patches: Patches, choice: PatchChoice, clouds: Mapping[str, Cloud], survey: Survey
) -> tuple[Target, ...]:
    """Targets from the chosen patches, with the points of each line; see `Patches.points_on`."""
    planes, names = patches.planes, list(clouds)
    found = []
    for k, rows in enumerate(choice.rows):
        sightings = []
        for row in rows:
            line = names[planes.line[row]]
            numbers, one_in = patches.points_on(row, clouds[line])
            sightings.append(
                PickedSighting(
                    line,
                    numbers,
                    float(planes.roughness[row]),
                    fingerprint=survey.scans[line].fingerprint,
                    one_in=one_in,
                )
            )
        lead = rows[np.argmax(planes.count[rows])]
        found.append(
            Target(
                name=f"N{k + 1:03d}",
                role="target",
                seed=tuple(planes.centre[lead].tolist()),
                threshold=float(planes.max_distance[rows].max()),
                radius=float(planes.reach[rows].max()),
                sightings=tuple(sightings),
            )
        )
    return tuple(found)


def disagreeing_lines(
    result: AdjustmentResult, lines: Iterable[str], shifted: Collection[str]
) -> tuple[str, ...]:
    """Lines without a sighting, with many rejected sightings, or shifted as a whole.

    If the displacement of a line exceeds its POS errors, no patches are found in it, or its
    sightings disagree with those of the other lines and are rejected.

    Parameters
    ----------
    lines : iterable of str
        All lines.
    shifted : collection of str
        Lines shifted as a whole; see `LineShiftScores`.
    """
    count = Counter(residual.sighting.line for residual in result.sightings)
    rejected = Counter(sighting.line for sighting in result.rejected_sightings)
    return tuple(
        line
        for line in lines
        if not count[line]
        or line in shifted
        or rejected[line] >= max(2.0, MAX_REJECTED_SHARE * count[line])
    )
