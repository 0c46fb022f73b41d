"""Result of an adjustment of point correspondences, as values and tables."""

from dataclasses import dataclass

import numpy as np

from lispac.correspondences.adjustment import CorrespondenceEstimate
from lispac.language import N_
from lispac.messages import Message
from lispac.present.angles import Angles, degrees, matrix
from lispac.present.calibration.calibrations import ESTIMATE_COLUMNS
from lispac.present.tables import Table


@dataclass(frozen=True)
class CorrespondenceValues:
    """Result of an adjustment of point correspondences.

    ``noise_m``: standard deviation of a coordinate difference of a pair, estimated if
    ``is_noise_estimated``; ``variance_factor``: that of a given noise; ``rms_before_m`` and
    ``rms_after_m``: RMS distance of the points of the used pairs with the prior and the estimated
    boresight.
    """

    boresight_deg: Angles
    sigma_deg: Angles
    covariance_deg2: tuple[tuple[float, ...], ...]
    pairs: int
    pairs_used: int
    noise_m: float
    is_noise_estimated: bool
    variance_factor: float
    rms_before_m: float
    rms_after_m: float
    lines: tuple[str, ...]
    messages: tuple[Message, ...]

    @classmethod
    def of(
        cls, found: CorrespondenceEstimate, lines: tuple[str, ...], messages: tuple[Message, ...]
    ) -> "CorrespondenceValues":
        """Values of a result; ``lines`` were measured during the used pairs."""
        return cls(
            boresight_deg=degrees(found.boresight),
            sigma_deg=degrees(found.sigma),
            covariance_deg2=matrix(np.degrees(1.0) ** 2 * found.covariance),
            pairs=len(found.used),
            pairs_used=int(found.used.sum()),
            noise_m=found.noise,
            is_noise_estimated=found.is_noise_estimated,
            variance_factor=found.variance_factor,
            rms_before_m=found.rms_before,
            rms_after_m=found.rms_after,
            lines=lines,
            messages=messages,
        )


CORRESPONDENCES_TABLE = Table[CorrespondenceValues](
    N_("Boresight from point correspondences"), ESTIMATE_COLUMNS
)
