"""Normal equations at a stored solution, for later computations."""

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.blas import one_thread
from lispac.adjustment.crosscheck import as_judged
from lispac.adjustment.iteration import iterate
from lispac.adjustment.observations import Observations
from lispac.adjustment.parameters import Parameter
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.shapes import about, fit_shapes, middles
from lispac.errors import AdjustmentError
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Solved:
    """An answer of the correlated model with its equations.

    Attributes
    ----------
    here : Linearised
        Without the rejected sightings. Weights follow the solution (Newton): if they were fixed,
        the answers of parts would scatter too little.
    origins : ndarray of shape (targets, 3), metres, local frame
        Middles that the coordinates of each target are counted from.
    """

    here: Linearised
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
        """Solve again as the whole was judged; None where the model of it is another.

        Parameters
        ----------
        mounting : Mounting
            As it went into the adjustment of ``result``.
        parameters : tuple of Parameter
            Estimated besides the boresight.
        """
        if not result.model.correlated:
            return None
        observations, result = as_judged(observations, result)
        own = tuple(each for each in parameters if each.name in result.estimated)
        origins = middles(observations, result.mounting)
        few = about(observations, origins)
        problem = Problem.of(few, mounting, result.model, own)
        start = problem.start(result.mounting, fit_shapes(few, result.mounting))
        try:
            with one_thread():
                end = iterate(problem, start, progress).linearised
                return cls(end.problem.linearised(end.state, end.loss, tangent=True), origins)
        except (AdjustmentError, np.linalg.LinAlgError):
            return None  # what a part is to be compared with is not known
