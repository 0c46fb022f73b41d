"""Result of an adjustment as values: boresight, fit, tests.

Field names end with the unit of their values. They are the keys of ``lispac estimate --json`` and
of the JSON report.
"""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from lispac.adjustment.diagnostics.findings import critical_test_value
from lispac.adjustment.diagnostics.warnings import (
    has_form_errors,
    has_raised_sigmas,
    wrong_value_of,
)
from lispac.adjustment.model.parameters import OUTPUT_UNITS, mounting_value_name
from lispac.adjustment.result import (
    ANGLES,
    AdjustmentResult,
    FitOutcome,
    Observability,
    PossibleCause,
    TargetResidual,
    VarianceComponent,
)
from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.language import (
    N_,
    Advised,
    LazyText,
    Template,
    gettext,
    gettext_lazy,
    join_sentences,
)
from lispac.message_texts import TEXTS
from lispac.message_texts.report_warnings import NOISE_DIFFERS_GIVEN_TEXT, NOISE_DIFFERS_TEXT
from lispac.messages import Message
from lispac.present.angles import (
    Angles,
    AnglesRow,
    angle_columns,
    angles,
    degrees,
    degrees_or_none,
    finite_or_none,
    floats,
    matrix,
)
from lispac.present.calibration.displacement import (
    EFFECT_DISTANCES_M,
    DisplacementByAngle,
    S44Contribution,
    angle_displacements,
    s44_contributions,
)
from lispac.present.calibration.parameters import (
    ParameterValues,
    VarianceComponentValues,
    component_values,
    parameter_values,
)
from lispac.present.tables import (
    DEGREES,
    Column,
    Table,
)
from lispac.present.targets.sightings import SightingValues, sighting_values
from lispac.present.targets.targets import TargetValues, target_values
from lispac.present.text_format import VALUE_TITLES
from lispac.survey.conventions.mounting_texts import orientation_text

NORMAL_FACTOR_95 = 1.96
"""Half width of the 95 % interval of a normal variable, in standard deviations."""


@dataclass(frozen=True)
class ObservabilityValues:
    """Observability of the angles with the lines and targets of the adjustment.

    The directions are combinations of roll, pitch and yaw, the one with the largest sigma first.
    The sigmas without a line are None if the other lines do not determine the angles.
    """

    direction_sigma_deg: tuple[float, ...]
    directions: tuple[Angles, ...]
    condition: float | None
    sigma_without_line_deg: Mapping[str, Angles | None]
    messages: tuple[Message, ...]


def observability_values(observability: Observability | None) -> ObservabilityValues | None:
    """Observability of the angles as values; None if it is unknown."""
    if observability is None:
        return None
    return ObservabilityValues(
        direction_sigma_deg=floats(np.degrees(observability.eigenvalues**-0.5)),
        directions=tuple(angles(column) for column in observability.directions.T),
        condition=finite_or_none(observability.condition),
        sigma_without_line_deg={
            line: degrees_or_none(sigma) for line, sigma in observability.sigma_without_line.items()
        },
        messages=observability.messages,
    )


MIN_REPORTED_NOISE_FACTOR = 1.05
"""Smallest noise factor that is named; smaller ones are within the uncertainty of the estimate."""
NOT_TESTED_TEXT = N_("Not tested: there are no more points than unknowns.")
PASSED_TEXT = N_("Passed.")
AGREE_TEXT = N_("The residuals agree with the given standard deviations.")
AGREE_ESTIMATED_TEXT = N_(
    "The residuals agree with the standard deviations used, which were partly estimated from them."
)
NOT_JUDGED_TEXT = N_("Not judged: the LiDAR noise was estimated from the same residuals.")
TOO_LARGE_TEXT = N_(
    "Failed: the residuals are larger than the standard deviations used allow. Possible causes: "
    "standard deviations are too small, a target is rough, or there are outliers."
)
TOO_LARGE_NOISE_TEXT = N_(
    "Failed: the residuals are larger than the standard deviations used allow. Possible causes: "
    "the LiDAR sigma is too small, a target is rough, or there are outliers. The sigmas of the "
    "angles are computed with the noise found in the residuals."
)
TOO_LARGE_CLASSICAL_TEXT = N_(
    "Failed: the residuals are larger than the given sigmas allow. Possible causes: the given "
    "sigmas are too small, or a target is not the same plane on all lines. The sigmas of the "
    "angles are then too small as well."
)
TOO_LARGE_WRONG_VALUE_TEXT = N_(
    "The residuals are larger than the standard deviations used allow, because the given "
    "{parameter} disagrees with the data."
)
TOO_LARGE_ASSUMED_TEXT = Advised(
    N_("The residuals are larger than the assumed sigmas allow."),
    N_("Give the sigmas of the data sheet or of the processing report."),
)
_TOO_SMALL_STATEMENT = N_(
    "Conservative: the residuals are smaller than the standard deviations used predict, so the "
    "tests detect errors less well."
)
TOO_SMALL_TEXT = _TOO_SMALL_STATEMENT
TOO_SMALL_NOISE_TEXT = Advised(
    _TOO_SMALL_STATEMENT, N_("Use the LiDAR noise of the residuals and estimate again.")
)
TOO_SMALL_ESTIMATED_TEXT = N_(
    "Conservative: the LiDAR noise was estimated from all targets and then increased for targets "
    "with a noise factor above 1. The residuals are therefore smaller than predicted."
)
TOO_SMALL_RAISED_TEXT = N_(
    "Conservative: the residuals are smaller than the standard deviations used predict. The sigmas "
    "of the angles were increased nevertheless, because angles computed from subsets of the data "
    "scatter more than predicted."
)


@dataclass(frozen=True)
class VarianceFactorTest:
    """Two-sided test of the variance factor at 95 %; bounds are None without redundancy.

    ``outcome`` is "not judged" and ``passed`` None if the statistic is within its bounds because
    the LiDAR noise was estimated from the same residuals. ``lidar_noise_ratio`` is that of
    `AdjustmentResult`; ``has_assumed_sigmas`` is True if sigmas were used that nobody gave and that
    were not estimated.
    """

    statistic: float
    lower: float | None
    upper: float | None
    passed: bool | None
    text: LazyText
    outcome: FitOutcome | Literal["not judged"] | None = None
    lidar_noise_ratio: float | None = None
    has_assumed_sigmas: bool = False


def agrees_by_construction(result: AdjustmentResult) -> bool:
    """Whether standard deviations were estimated from the residuals that the test compares."""
    return (
        result.lidar_noise_from_residuals
        or any(c.applied for c in result.components)
        or has_form_errors(result)
    )


def is_lidar_noise_from_residuals(result: AdjustmentResult) -> bool:
    """Whether the LiDAR noise was estimated from the residuals, in this or in a former adjustment.

    The chi-square test then agrees with it and confirms nothing.
    """
    return result.lidar_noise_from_residuals or is_lidar_noise_estimated(result.components)


def has_passed(result: AdjustmentResult) -> bool | None:
    """Whether the chi-square test is passed; None if it is not judged or not tested."""
    test = result.chi_square
    if result.degrees_of_freedom <= 0 or (test.passed and is_lidar_noise_from_residuals(result)):
        return None
    return test.passed


def agreement_template(result: AdjustmentResult) -> Template:
    """Text of a chi-square test whose statistic lies within its bounds."""
    if is_lidar_noise_from_residuals(result):
        return NOT_JUDGED_TEXT
    return AGREE_ESTIMATED_TEXT if agrees_by_construction(result) else AGREE_TEXT


def small_residuals_template(result: AdjustmentResult) -> Template:
    """Text of residuals that are smaller than predicted.

    The points determine the variance factor, and POS errors contribute little to it. A LiDAR noise
    estimated from all points makes it 1, unless the noise of some targets was raised above it.
    """
    if has_raised_sigmas(result):
        return TOO_SMALL_RAISED_TEXT
    if is_lidar_noise_estimated(result.components):
        return TOO_SMALL_ESTIMATED_TEXT
    return TOO_SMALL_TEXT if result.lidar_noise_ratio is None else TOO_SMALL_NOISE_TEXT


def large_residuals_text(result: AdjustmentResult) -> LazyText:
    """Text of residuals that are larger than predicted."""
    if (wrong := wrong_value_of(result)) is not None:
        assert wrong.subject is not None
        name = gettext_lazy(TEXTS[mounting_value_name(wrong.subject.name).code])
        return gettext_lazy(TOO_LARGE_WRONG_VALUE_TEXT, parameter=name)
    if result.unestimated_sigmas:
        return gettext_lazy(TOO_LARGE_ASSUMED_TEXT)
    if not result.model.correlated:
        return gettext_lazy(TOO_LARGE_CLASSICAL_TEXT)
    if noisy := targets_with_larger_noise(result):
        is_estimated = is_lidar_noise_estimated(result.components)
        return gettext_lazy(
            NOISE_DIFFERS_TEXT if is_estimated else NOISE_DIFFERS_GIVEN_TEXT,
            targets=noisy, factor=result.noise_factors[noisy[0]],
        )  # fmt: skip
    is_raised = any(target.noise > 1 for target in result.targets)
    return gettext_lazy(TOO_LARGE_NOISE_TEXT if is_raised else TOO_LARGE_TEXT)


def is_lidar_noise_estimated(
    components: Iterable[VarianceComponent | VarianceComponentValues],
) -> bool:
    """Whether the LiDAR noise used was estimated from all targets."""
    return any(each.applied and each.name == "LiDAR" for each in components)


def noisier_targets(factors: Mapping[str, float]) -> list[str]:
    """Targets with more noise than used, the noisiest first, by noise factors by target."""
    found = [name for name, factor in factors.items() if factor >= MIN_REPORTED_NOISE_FACTOR]
    return sorted(found, key=lambda name: -factors[name])


def _variance_factor_test(result: AdjustmentResult) -> VarianceFactorTest:
    test = result.chi_square
    if result.degrees_of_freedom <= 0:
        return VarianceFactorTest(test.statistic, None, None, None, gettext_lazy(NOT_TESTED_TEXT))
    sentences = []
    outcome: FitOutcome | Literal["not judged"] = test.outcome
    if test.outcome == "passed":
        if has_passed(result):
            sentences = [gettext_lazy(PASSED_TEXT)]
        else:
            outcome = "not judged"
        finding = gettext_lazy(agreement_template(result))
    elif test.outcome == "conservative":
        finding = gettext_lazy(small_residuals_template(result))
    else:
        finding = large_residuals_text(result)
    return VarianceFactorTest(
        test.statistic, test.lower, test.upper, has_passed(result),
        join_sentences([*sentences, finding]), outcome,
        result.lidar_noise_ratio, bool(result.unestimated_sigmas),
    )  # fmt: skip


@dataclass(frozen=True)
class CauseValues:
    """Possible cause of residuals that contradict the model.

    ``size`` and ``sigma`` are in ``unit``. Their components are north, west and up for the position
    of a line; roll, pitch and yaw for its boresight; two tilts and the offset for a surface.
    ``evidence`` is twice the logarithm of the Bayes factor.
    """

    kind: str
    target: str | None
    line: str | None
    unit: str
    size: tuple[float, ...]
    sigma: tuple[float, ...]
    angle_change_deg: Angles
    effect_m: float
    evidence: float


def _cause_values(cause: PossibleCause) -> CauseValues:
    factor, unit = OUTPUT_UNITS.get(cause.kind, (1.0, "m"))
    if cause.kind == "line_time":
        factor, unit = OUTPUT_UNITS["latency"]
    elif cause.kind == "line_boresight":
        factor, unit = math.degrees(1.0), "deg"
    return CauseValues(
        cause.kind, cause.target or None, cause.line or None, unit, floats(factor * cause.size),
        floats(factor * cause.sigma), degrees(cause.angle_change), cause.effect, cause.evidence,
    )  # fmt: skip


@dataclass(frozen=True)
class AdjustmentValues:
    """Boresight, fit, reliability and all other results of an adjustment.

    ``sigma_about``: the standard deviations are those of roll, pitch, yaw, or, if the pitch is
    steep, of small rotations about the body axes; ``rotation_text`` is empty unless the pitch is
    steep. ``correlation`` is the correlation matrix of the three angles, ``correlation_all`` that
    of all ``estimated`` values.
    ``points`` are those used, after averaging or thinning the ``picked_points`` of the targets; the
    latter is None if the number is unknown. ``excluded_outliers`` are points excluded before the
    averaging; the outliers of targets and sightings are points used, with test values above
    ``critical_w``.
    ``critical_w`` is the test value beyond which a sighting disagrees. ``single_orientation``: all
    targets are planes with the same normal.
    """

    boresight_deg: Angles
    sigma_deg: Angles
    interval95_deg: Angles
    prior_boresight_deg: Angles
    rotation_body_lidar: tuple[tuple[float, ...], ...]
    sigma_about: str
    rotation_text: LazyText
    correlation: tuple[tuple[float, ...], ...]
    estimated: tuple[str, ...]
    correlation_all: tuple[tuple[float, ...], ...]
    parameters: tuple[ParameterValues, ...]
    observability: ObservabilityValues | None
    pos_errors: str
    loss: str
    components: tuple[VarianceComponentValues, ...]
    surface_sigma_m: float
    offset_sigma_m: float | None
    variance_factor: float | None
    degrees_of_freedom: int
    chi_square: VarianceFactorTest
    iterations: int
    points: int
    picked_points: int | None
    excluded_outliers: int
    rms_before_m: float
    rms_after_m: float
    effect_distances_m: tuple[float, ...]
    effects: tuple[DisplacementByAngle, ...]
    s44: tuple[S44Contribution, ...]
    targets: tuple[TargetValues, ...]
    single_orientation: bool
    critical_w: float | None
    sightings: tuple[SightingValues, ...]
    causes: tuple[tuple[CauseValues, ...], ...]

    @property
    def are_sightings_tested(self) -> bool:
        """Whether sightings were tested against each other."""
        return self.critical_w is not None and any(each.is_tested for each in self.sightings)


def targets_with_larger_noise(result: AdjustmentResult | AdjustmentValues) -> list[str]:
    """Targets whose noise explains residuals larger than predicted, the noisiest first.

    The other targets must agree with the LiDAR noise used. They do so if it was estimated from all
    targets; a given noise must explain the variance factor with the noise factors of the targets.
    """
    factors = {
        each.target: (each.noise if isinstance(each, TargetResidual) else each.noise_factor) or 1.0
        for each in result.targets
    }
    noisy = noisier_targets(factors)
    if is_lidar_noise_estimated(result.components):
        return noisy
    if len(noisy) == len(factors) or result.variance_factor is None:
        return []
    squares = sum(each.points * factors[each.target] ** 2 for each in result.targets)
    points = sum(each.points for each in result.targets)
    return noisy if result.variance_factor * points <= squares else []


def adjustment_values(
    result: AdjustmentResult,
    headings_deg: Mapping[str, float] | None = None,
    picked_points: int | None = None,
) -> AdjustmentValues:
    """Result of an adjustment as values.

    Parameters
    ----------
    headings_deg : degrees by name of the line, where they are known
    picked_points : number of points of all sightings used, before averaging or thinning
    """
    is_steep = result.mounting.axes is not None
    return AdjustmentValues(
        boresight_deg=degrees(result.angles),
        sigma_deg=degrees(result.sigma),
        interval95_deg=degrees(NORMAL_FACTOR_95 * result.sigma),
        prior_boresight_deg=degrees(result.prior_angles),
        rotation_body_lidar=matrix(result.mounting.rotation_body_lidar),
        sigma_about="body axes" if is_steep else "roll, pitch, yaw",
        rotation_text=orientation_text(result.angles) if is_steep else LazyText(""),
        correlation=matrix(result.correlation),
        estimated=result.estimated,
        correlation_all=matrix(result.correlation_all),
        parameters=parameter_values(result),
        observability=observability_values(result.observability),
        pos_errors=result.model.pos_errors,
        loss=result.model.loss,
        components=component_values(result),
        surface_sigma_m=result.surface,
        offset_sigma_m=result.offset,
        variance_factor=finite_or_none(result.variance_factor),
        degrees_of_freedom=result.degrees_of_freedom,
        chi_square=_variance_factor_test(result),
        iterations=result.iterations,
        points=result.points,
        picked_points=picked_points,
        excluded_outliers=result.excluded_outliers,
        rms_before_m=result.rms_before,
        rms_after_m=result.rms_after,
        effect_distances_m=EFFECT_DISTANCES_M,
        effects=angle_displacements(result),
        s44=s44_contributions(result),
        targets=target_values(result),
        single_orientation=have_one_orientation(
            np.array([t.plane[:3] for t in result.targets]),
            np.array([t.sphere for t in result.targets]),
        ),
        critical_w=critical_test_value(result),
        sightings=sighting_values(result, headings_deg),
        causes=tuple(tuple(map(_cause_values, group)) for group in result.causes or ()),
    )


SIGMAS_WITHOUT_LINE_TABLE = Table[AnglesRow](
    N_("1 sigma of the angles with one line omitted"),
    (Column("name", ""), *angle_columns("values", DEGREES)),
)


def sigma_without_line_rows(result: "AdjustmentValues") -> list[AnglesRow]:
    """Rows with the standard deviations for all lines, and with each line omitted in turn."""
    without = {} if result.observability is None else result.observability.sigma_without_line_deg
    return [
        AnglesRow(gettext("All lines"), result.sigma_deg),
        *(
            AnglesRow(gettext("Without line {name}", name=line), sigma)
            for line, sigma in without.items()
        ),
    ]


@dataclass(frozen=True)
class AngleValues:
    """Prior, estimated and true value of one boresight angle; None for unknown values."""

    name: str
    prior_deg: float
    estimated_deg: float | None
    sigma_deg: float | None
    interval95_deg: float | None
    true_deg: float | None
    error_deg: float | None


def angle_errors(result: AdjustmentValues, true_deg: Angles) -> Angles:
    """Estimated boresight minus the true one, degrees."""
    return angles(np.subtract([*result.boresight_deg], [*true_deg]))


def angle_values(
    prior: Angles,
    result: AdjustmentValues | None = None,
    true: Angles | None = None,
) -> tuple[AngleValues, ...]:
    """Values of each boresight angle; the error is the estimated value minus the true one."""
    error = None if true is None or result is None else angle_errors(result, true)

    estimated: tuple[Angles | None, ...] = (None, None, None)
    if result is not None:
        estimated = (result.boresight_deg, result.sigma_deg, result.interval95_deg)
    return tuple(
        AngleValues(
            name,
            getattr(prior, name),
            *(
                None if values is None else getattr(values, name)
                for values in (*estimated, true, error)
            ),
        )
        for name in ANGLES
    )


_ANGLE_SIGNS = {
    "roll": N_("positive port side up"), "pitch": N_("positive bow down"),
    "yaw": N_("positive clockwise seen from above"),
}  # fmt: skip
SHORT_ANGLE_SIGNS = (N_("+ port up"), N_("+ bow down"), N_("+ clockwise"))
"""Directions of positive angles, below the names of the angles."""
_NAME_COLUMN = Column[AngleValues]("name", N_("Angle"), texts=VALUE_TITLES)
_PRIOR_COLUMN = Column[AngleValues](
    "prior_deg", N_("Prior"), DEGREES.signed, N_("Angle before the adjustment")
)
ESTIMATED_COLUMN = Column[AngleValues](
    "estimated_deg", N_("Estimated"), DEGREES.signed, N_("Angle after the adjustment")
)
_SIGMA_COLUMN = Column[AngleValues]("sigma_deg", N_("1 sigma"), DEGREES, N_("Standard deviation"))
_INTERVAL_COLUMN = Column[AngleValues](
    "interval95_deg", N_("95 % interval"), DEGREES.half_interval,
    N_("Half width of the 95 % confidence interval: 1.96 σ"),
)  # fmt: skip
_TRUE_COLUMN = Column[AngleValues](
    "true_deg", N_("True value"), DEGREES.signed, N_("Angle used to simulate the survey")
)
ERROR_FORMAT = DEGREES.signed
"""Format of an estimated minus a true angle."""
_ERROR_COLUMN = Column[AngleValues]("error_deg", N_("Error"), ERROR_FORMAT)
_SIGN_COLUMN = Column[AngleValues]("name", N_("Sign"), texts=_ANGLE_SIGNS)


def boresight_table(*, calibrated: bool, simulated: bool) -> Table[AngleValues]:
    """Table of the boresight, with columns for the values that are available."""
    columns = [_NAME_COLUMN, _PRIOR_COLUMN]
    if calibrated:
        columns += [ESTIMATED_COLUMN, _SIGMA_COLUMN, _INTERVAL_COLUMN]
    if simulated:
        columns += [_TRUE_COLUMN, _ERROR_COLUMN] if calibrated else [_TRUE_COLUMN]
    return Table(N_("Boresight"), (*columns, _SIGN_COLUMN))


def window_boresight_table(*, simulated: bool) -> Table[AngleValues]:
    """Table of the window, whose columns are shown as rows; the report has `boresight_table`."""
    columns = (
        _PRIOR_COLUMN, ESTIMATED_COLUMN, _SIGMA_COLUMN.with_title(N_("± 1 σ")),
        replace(_INTERVAL_COLUMN, title=N_("± 95 %"), format=DEGREES),
    )  # fmt: skip
    return Table(N_("Boresight angles"), (*columns, _TRUE_COLUMN) if simulated else columns)
