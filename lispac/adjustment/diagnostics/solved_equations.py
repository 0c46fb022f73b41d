"""Normal equations at an earlier solution, computed again for later diagnostics."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.crosscheck import apply_rejections_and_surfaces
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.target_shapes import fit_shapes, relative_to_origins, target_centroids
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.iteration import iterate
from lispac.errors import AdjustmentError
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SolvedEquations:
    """A solution of the correlated model with its normal equations.

    Attributes
    ----------
    linearised : LinearisedProblem
        Equations without the rejected sightings. Their covariance is that of the result before its
        sigmas were raised.
    origins : ndarray of shape (targets, 3), metres, local frame
        Origin of the coordinates of each target, its mean point.
    """

    linearised: LinearisedProblem
    origins: Array

    @classmethod
    def of(
        cls,
        result: AdjustmentResult,
        observations: Observations,
        mounting: Mounting,
        parameters: tuple[Parameter, ...] = (),
        *,
        progress: Progress = no_progress,
    ) -> Self | None:
        """Solve again with the settings of the result.

        Return None if the model is not the correlated one, or if there is no solution.

        Parameters
        ----------
        mounting : Mounting
            Mounting that was given to the adjustment of ``result``.
        parameters : tuple of Parameter
            Values that were estimated besides the boresight.
        """
        if not result.model.correlated:
            return None
        observations, result = apply_rejections_and_surfaces(observations, result)
        own = tuple(each for each in parameters if each.name in result.estimated)
        origins = target_centroids(observations, result.mounting)
        relative = relative_to_origins(observations, origins)
        problem = AdjustmentProblem.of(relative, mounting, result.model, own)
        problem = problem.with_known_noise(result.noise_factors)
        start = problem.start(result.mounting, fit_shapes(relative, result.mounting))
        try:
            with single_blas_thread():
                end = iterate(problem, start, progress).linearised
                return cls(end.problem.linearised(end.state, end.loss), origins)
        except (AdjustmentError, np.linalg.LinAlgError):
            return None
