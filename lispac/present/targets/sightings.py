"""Sightings: fit to the surfaces of their targets, tests, POS errors, as values and tables.

Field names are the keys of ``sightings`` in JSON, with the unit of their values at the end.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter
from statistics import fmean
from typing import Literal

import numpy as np

from lispac.adjustment.diagnostics.findings import (
    MAX_DETECTABLE_BIAS,
    critical_test_value,
    sighting_status,
)
from lispac.adjustment.diagnostics.reliability import CRITICAL_VALUE
from lispac.adjustment.model.pos_corrections import MAX_DETERMINED_SIGMA_RATIO
from lispac.adjustment.result import (
    AdjustmentResult,
    SightingReliability,
    SightingResidual,
)
from lispac.language import N_, gettext, gettext_lazy
from lispac.present.angles import Angles, degrees, finite_or_none, floats
from lispac.present.tables import (
    COUNT,
    DEGREES,
    MILLIDEGREES,
    MILLIMETRES,
    SECONDS,
    Column,
    Format,
    Table,
    ratio,
)

MANY_OUTLIERS_SHARE = 0.05
"""Share of outliers above which a sighting that agrees has the status "many outliers"."""

SightingStatus = Literal[
    "rejected", "not tested", "not checked", "disagrees", "many outliers", "agrees"
]
STATUS_TEXTS: Mapping[SightingStatus, str] = {
    "rejected": N_("rejected"),
    "not tested": N_("not tested"),
    "not checked": N_("not checked"),
    "disagrees": N_("disagrees"),
    "many outliers": N_("many outliers"),
    "agrees": N_("agrees"),
}


@dataclass(frozen=True)
class PosErrorValues:
    """Estimated POS error at the middle of a sighting, reported minus true value, and its sigmas.

    ``sigma_m`` and ``sigma_deg`` are the prior sigmas, ``sigma_after_m`` and ``sigma_after_deg``
    those after the adjustment. The values in metres are north, west, up; those in degrees are roll,
    pitch, heading.
    """

    error_m: tuple[float, ...]
    sigma_m: tuple[float, ...]
    sigma_after_m: tuple[float, ...]
    error_deg: tuple[float, ...]
    sigma_deg: tuple[float, ...]
    sigma_after_deg: tuple[float, ...]


@dataclass(frozen=True)
class SightingValues:
    """Fit of a sighting to the surface of its target, and its test against all other sightings.

    Mean and shift, and therefore w and the effect, are positive if the sighting is nearer to the
    vessel than the surface. They are None in results of earlier versions, which do not contain the
    side of the vessel.

    The values of the test are None with uncorrelated POS errors. Shift, w, detectable shift and its
    effect are also None if no other data check the sighting. ``largest_w`` is the largest test
    value of a point, measured at ``largest_w_time_s``, which is None in results of earlier
    versions.
    """

    target: str
    line: str
    heading_deg: float | None
    points: int
    rms_before_m: float
    rms_after_m: float
    mean_after_m: float | None
    incidence_deg: float | None
    status: SightingStatus
    shift_m: float | None = None
    w: float | None = None
    detectable_m: float | None = None
    effect_deg: Angles | None = None
    redundancy: float | None = None
    outliers: int | None = None
    largest_w: float | None = None
    largest_w_time_s: float | None = None
    point_detectable_m: float | None = None
    weight: float | None = None
    pos_error: PosErrorValues | None = None

    @property
    def is_tested(self) -> bool:
        """Whether the sighting was tested; there is no test with uncorrelated POS errors."""
        return self.status != "not tested"

    @property
    def is_marked(self) -> bool:
        """Whether the sighting was rejected or disagrees with the others."""
        return self.status in ("rejected", "disagrees")


def sighting_values(
    result: AdjustmentResult, headings_deg: Mapping[str, float] | None = None
) -> tuple[SightingValues, ...]:
    """Fit and test of every sighting.

    Parameters
    ----------
    headings_deg : degrees by name of the line, where they are known
    """
    critical = critical_test_value(result) or math.inf
    tests = {(r.sighting.target, r.sighting.line): r for r in result.reliability}
    sides = {target.target: target.vessel_side for target in result.targets}
    return tuple(
        _sighting_values(
            each,
            tests.get((each.sighting.target, each.sighting.line)),
            (headings_deg or {}).get(each.sighting.line),
            critical,
            sides.get(each.sighting.target),
        )
        for each in result.sightings
    )


def _sighting_values(
    fit: SightingResidual,
    test: SightingReliability | None,
    heading: float | None,
    critical: float,
    vessel_side: int | None,
) -> SightingValues:
    sighting = fit.sighting
    values = SightingValues(
        target=sighting.target,
        line=sighting.line,
        heading_deg=heading,
        points=fit.points,
        rms_before_m=fit.rms_before,
        rms_after_m=fit.rms_after,
        mean_after_m=None if vessel_side is None else vessel_side * fit.mean_after,
        incidence_deg=None if fit.incidence is None else math.degrees(fit.incidence),
        status="not tested",
    )
    if test is None:
        return values
    status: SightingStatus = sighting_status(test, critical)
    if status == "agrees" and test.outliers > MANY_OUTLIERS_SHARE * fit.points:
        status = "many outliers"
    is_checked = bool(test.detectable < MAX_DETECTABLE_BIAS)
    if is_checked and vessel_side is not None:
        towards_vessel = -vessel_side  # the test is positive against the direction of the normal
        values = replace(
            values,
            shift_m=towards_vessel * test.shift,
            w=towards_vessel * test.w,
            effect_deg=degrees(towards_vessel * test.effect),
        )
    return replace(
        values,
        status=status,
        detectable_m=test.detectable if is_checked else None,
        redundancy=test.redundancy,
        outliers=test.outliers,
        largest_w=test.largest_w,
        largest_w_time_s=test.largest_at,
        point_detectable_m=finite_or_none(test.point_detectable),
        weight=test.weight,
        pos_error=PosErrorValues(
            floats(test.pos_error[:3]),
            floats(test.pos_sigma[:3]),
            floats(test.pos_sigma_after[:3]),
            floats(np.degrees(test.pos_error[3:])),
            floats(np.degrees(test.pos_sigma[3:])),
            floats(np.degrees(test.pos_sigma_after[3:])),
        ),
    )


def _pos_length(sighting: SightingValues, name: str) -> float | None:
    """Length of a vector of the POS error; ``name`` is a field of `PosErrorValues`."""
    error = sighting.pos_error
    return None if error is None else math.hypot(*getattr(error, name))


TARGET_COLUMN = Column[SightingValues]("target", N_("Target"), tip=N_("Target"))
LINE_COLUMN = Column[SightingValues]("line", N_("Line"), tip=N_("Line"))
HEADING_COLUMN = Column[SightingValues](
    lambda s: None if s.heading_deg is None else s.heading_deg % 360, N_("Heading"),
    Format("deg", 1),
)  # fmt: skip
POINTS_COLUMN = Column[SightingValues](
    "points", N_("Points\nused"), COUNT, N_("Points used, after averaging or thinning")
)
INCIDENCE_COLUMN = Column[SightingValues](
    "incidence_deg", N_("Incidence"), Format("deg", 0),
    N_("Mean angle between the beams and the normal of the surface"),
)  # fmt: skip
RMS_BEFORE_COLUMN = Column[SightingValues](
    "rms_before_m", N_("RMS\nbefore"), MILLIMETRES,
    N_(
        "RMS distance to the surface with the prior boresight. It contains the POS error of the "
        "line, which Shift does not."
    ),
)  # fmt: skip
RMS_AFTER_COLUMN = Column[SightingValues](
    "rms_after_m", N_("RMS\nafter"), MILLIMETRES,
    N_(
        "RMS distance to the adjusted surface. It contains the POS error of the line, which Shift "
        "does not, and may be larger than before."
    ),
)  # fmt: skip
MEAN_AFTER_COLUMN = Column[SightingValues](
    "mean_after_m", N_("Mean\nafter"), MILLIMETRES.signed,
    N_("Mean distance from the adjusted surface; positive if nearer to the vessel"),
)  # fmt: skip
SHIFT_COLUMN = Column[SightingValues](
    "shift_m", N_("Shift"), MILLIMETRES.signed,
    N_(
        "Shift of the sighting from the surface fitted to all other sightings, without the "
        "estimated POS error of the line; positive if nearer to the vessel. RMS contains this "
        "error, so it may be large although the shift is zero."
    ),
)  # fmt: skip
W_COLUMN = Column[SightingValues](
    "w", "w", ratio(2).signed, N_("Shift divided by its standard deviation (Baarda's test)")
)
DETECTABLE_SHIFT_COLUMN = Column[SightingValues](
    "detectable_m", N_("Detectable\nshift"), MILLIMETRES,
    N_("Smallest shift that the test detects with a power of 80 %"),
)  # fmt: skip
EFFECT_COLUMNS = (
    Column[SightingValues]("effect_deg.roll", N_("Effect on\nroll"), DEGREES.signed),
    Column[SightingValues]("effect_deg.pitch", N_("Pitch"), DEGREES.signed),
    Column[SightingValues]("effect_deg.yaw", N_("Yaw"), DEGREES.signed),
)
LARGEST_EFFECT_COLUMN = Column[SightingValues](
    lambda s: None if s.effect_deg is None else max(map(abs, s.effect_deg)),
    N_("Effect on\nangles"), MILLIDEGREES,
    N_("Largest change of an angle that an undetected shift of this size can cause"),
)  # fmt: skip
OUTLIERS_COLUMN = Column[SightingValues](
    "outliers", N_("Outliers"), COUNT,
    gettext_lazy("Number of points with a test value beyond {limit:x.2}", limit=CRITICAL_VALUE),
)  # fmt: skip
LARGEST_W_COLUMN = Column[SightingValues](
    "largest_w", N_("Largest w\nof a point"), ratio(1), N_("Largest test value of a point")
)
LARGEST_W_TIME_COLUMN = Column[SightingValues](
    "largest_w_time_s", N_("Time of\nlargest w"), SECONDS,
    N_("Time of this point in the line. For averaged points: the mean of their times."),
)  # fmt: skip
REDUNDANCY_COLUMN = Column[SightingValues](
    "redundancy", N_("Redundancy"), ratio(2),
    N_("Mean redundancy number of the points, from 0 (not checked) to 1"),
)  # fmt: skip
POS_POSITION_COLUMN = Column[SightingValues](
    lambda s: _pos_length(s, "error_m"), N_("POS position"), MILLIMETRES,
    N_("Estimated position error and its prior σ (3D lengths)"),
    sigma=lambda s: _pos_length(s, "sigma_m"),
)  # fmt: skip
POS_ATTITUDE_COLUMN = Column[SightingValues](
    lambda s: _pos_length(s, "error_deg"), N_("POS attitude"), MILLIDEGREES,
    N_("Estimated attitude error and its prior σ (3D lengths)"),
    sigma=lambda s: _pos_length(s, "sigma_deg"),
)  # fmt: skip
FINDING_COLUMN = Column[SightingValues](
    "status", N_("Finding"), texts=STATUS_TEXTS, tip=N_("Result of the test")
)

SIGHTINGS_TABLE = Table[SightingValues](
    N_("Sightings"),
    (
        TARGET_COLUMN, LINE_COLUMN, FINDING_COLUMN, POINTS_COLUMN, INCIDENCE_COLUMN,
        RMS_BEFORE_COLUMN,
        RMS_AFTER_COLUMN, SHIFT_COLUMN, W_COLUMN,
        DETECTABLE_SHIFT_COLUMN, LARGEST_EFFECT_COLUMN, OUTLIERS_COLUMN, LARGEST_W_COLUMN,
        LARGEST_W_TIME_COLUMN, REDUNDANCY_COLUMN, POS_POSITION_COLUMN, POS_ATTITUDE_COLUMN,
    ),
)  # fmt: skip
"""Table of the window with all values of a sighting; the report has the following tables."""
SIGHTING_FIT_TABLE = Table[SightingValues](
    N_("Fit of each sighting to the surface of its target"),
    (
        TARGET_COLUMN, LINE_COLUMN, HEADING_COLUMN, POINTS_COLUMN,
        RMS_BEFORE_COLUMN,
        RMS_AFTER_COLUMN, MEAN_AFTER_COLUMN,
    ),
)  # fmt: skip
SIGHTING_TESTS_TABLE = Table[SightingValues](
    N_("Agreement of the sightings"),
    (
        TARGET_COLUMN,
        LINE_COLUMN,
        SHIFT_COLUMN,
        W_COLUMN,
        DETECTABLE_SHIFT_COLUMN,
        *EFFECT_COLUMNS,
        FINDING_COLUMN,
    ),
)
POINT_TESTS_TABLE = Table[SightingValues](
    N_("Tests of single points"),
    (
        TARGET_COLUMN,
        LINE_COLUMN,
        POINTS_COLUMN,
        REDUNDANCY_COLUMN,
        OUTLIERS_COLUMN,
        LARGEST_W_COLUMN,
        LARGEST_W_TIME_COLUMN,
    ),
)
POS_ERROR_WITHIN_CAPTION = N_(
    "Estimated POS error of each sighting (reported minus true value) with its 2 sigma interval "
    "(bar); grey: the prior 2 sigma interval."
)
POS_ERROR_CAPTION = N_(
    "Estimated POS error of each sighting (reported minus true value) with its 2 sigma interval "
    "(bar); grey: the prior 2 sigma interval. Red: the error is outside the prior interval; the "
    "POS was less accurate than given, or another error was attributed to it."
)
"""Explanations of the figure of the POS errors: without and with red errors."""


@dataclass(frozen=True)
class PosComponent:
    """Component of the POS error as it is presented: positions are east, north, up.

    Attributes
    ----------
    place : place in the order of `SightingReliability.pos_error`
    sign : -1 if the presented component has the opposite direction
    """

    title: str
    place: int
    sign: float = 1.0

    def error_of(self, sighting: SightingValues) -> float | None:
        """Error in metres or degrees; None if the data do not determine it."""
        error = sighting.pos_error
        if error is None:
            return None
        prior = (*error.sigma_m, *error.sigma_deg)[self.place]
        after = (*error.sigma_after_m, *error.sigma_after_deg)[self.place]
        is_determined = after < MAX_DETERMINED_SIGMA_RATIO * prior
        found = self.sign * (*error.error_m, *error.error_deg)[self.place]
        return found if is_determined else None


POS_COMPONENTS = (
    PosComponent(N_("East"), 1, -1.0), PosComponent(N_("North"), 0), PosComponent(N_("Up"), 2),
    PosComponent(N_("Roll"), 3), PosComponent(N_("Pitch"), 4), PosComponent(N_("Heading"), 5),
)  # fmt: skip
"""Components of the POS error, as in tables and figures."""

UNDETERMINED_POS_ERRORS_TEXT = N_(
    "A component without a value or a point is not determined by the data, for instance because "
    "no surface of a target faces it."
)
"""Explanation of gaps in the table and the figure of the POS errors."""


def has_undetermined_pos_errors(sightings: Sequence[SightingValues]) -> bool:
    """Whether the data do not determine a component of the POS error of a sighting."""
    return any(part.error_of(each) is None for each in sightings for part in POS_COMPONENTS)


def pos_error_caption(sightings: Sequence[SightingValues]) -> str:
    """Explanation of the figure of the POS errors, with that of red errors if there are any."""
    errors = [
        (each, (*each.pos_error.sigma_m, *each.pos_error.sigma_deg))
        for each in sightings
        if each.pos_error is not None
    ]
    beyond = any(
        abs(error) > 2.0 * sigma[part.place]
        for each, sigma in errors
        for part in POS_COMPONENTS
        if (error := part.error_of(each)) is not None
    )
    return gettext(POS_ERROR_CAPTION if beyond else POS_ERROR_WITHIN_CAPTION)


def mean_pos_sigmas(sightings: Sequence[SightingValues]) -> tuple[float, ...]:
    """Mean prior sigma of each component, in the order of `SightingReliability.pos_error`."""
    errors = [each.pos_error for each in sightings if each.pos_error is not None]
    components = zip(*((*each.sigma_m, *each.sigma_deg) for each in errors), strict=True)
    return tuple(map(fmean, components))


POS_ERRORS_TABLE = Table[SightingValues](
    N_("Estimated POS error at the middle of each sighting"),
    (
        TARGET_COLUMN,
        LINE_COLUMN,
        *(
            Column(each.error_of, each.title, (MILLIMETRES if each.place < 3 else DEGREES).signed)
            for each in POS_COMPONENTS
        ),
    ),
)
MEAN_POS_SIGMAS_TABLE = Table[tuple[float, ...]](
    "",
    (
        Column(lambda sigmas: gettext("Given 1 σ"), ""),
        Column(lambda sigmas: gettext("mean"), ""),
        *(
            Column[tuple[float, ...]](
                itemgetter(each.place), each.title, MILLIMETRES if each.place < 3 else DEGREES
            )
            for each in POS_COMPONENTS
        ),
    ),
)
"""Row of `mean_pos_sigmas` below `POS_ERRORS_TABLE`."""
