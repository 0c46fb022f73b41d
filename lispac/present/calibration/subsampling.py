"""Results with several point spacings, as values and table."""

from dataclasses import dataclass

from lispac.language import N_
from lispac.present.angles import Angles
from lispac.present.calibration.calibrations import ESTIMATE_COLUMNS
from lispac.present.tables import COMPUTING_SECONDS, COUNT, Column, Format, Table


@dataclass(frozen=True)
class SubsamplingValues:
    """Result with one point spacing, which is 0 if all points are used.

    ``points``: number of points used, of which averaged points count as one; ``elapsed_s``:
    computing time of the adjustment, without the selection of the points, which is common to all.
    """

    distance_m: float
    points: int
    boresight_deg: Angles
    sigma_deg: Angles
    elapsed_s: float


SUBSAMPLING_TABLE = Table[SubsamplingValues](
    N_("Point spacing study"),
    (
        Column(
            lambda row: row.distance_m or None, N_("Point spacing"), Format("m", 2),
            N_("Points of a sighting that are closer together than this distance are averaged"),
            unknown=N_("all points"),
        ),
        Column(
            "points", N_("Points"), COUNT,
            N_("Number of points used; averaged points count as one point"),
        ),
        *ESTIMATE_COLUMNS,
        Column(
            "elapsed_s", N_("Computing time"), COMPUTING_SECONDS,
            N_("Computing time of the adjustment, without the selection of points"),
        ),
    ),
)  # fmt: skip
