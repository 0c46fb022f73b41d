"""The values a report is made of.

Nothing here is formatted. Names carry the unit of their values and are the keys of the JSON
report as well, so every document shows the same figures.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Caution:
    """Something the reader must know; ``code`` names the rule, whatever the language."""

    code: str
    severity: Literal["serious", "caution"]
    text: str


@dataclass(frozen=True)
class InputFile:
    """A file the answer rests on; size and digest are None where it could not be found."""

    role: str
    name: str
    size_bytes: int | None
    sha256: str | None


@dataclass(frozen=True)
class SettingsUsed:
    """Settings; the typed POS sigmas are None where an accuracy file was given."""

    lever_arm_m: tuple[float, ...]
    origin_deg_m: tuple[float, ...] | None
    position_sigma_m: tuple[float, ...] | None
    attitude_sigma_deg: tuple[float, ...] | None
    lidar_sigma_m: float
    subsample_m: float
    pos_errors: str
    position_correlation_time_s: float | None
    attitude_correlation_time_s: float | None
    pos_errors_in_words: str
    convention: str


@dataclass(frozen=True)
class Angle:
    """One boresight angle; what is not known is None."""

    name: str
    prior_deg: float
    estimated_deg: float | None
    sigma_deg: float | None
    interval95_deg: float | None
    truth_deg: float | None
    error_deg: float | None


@dataclass(frozen=True)
class Chi2:
    """Two-sided test of the variance factor at 95 %; bounds are None without redundancy."""

    statistic: float
    lower: float | None
    upper: float | None
    passed: bool | None
    in_words: str


@dataclass(frozen=True)
class Effect:
    """Displacement of a point caused by one sigma of an angle, or of all in the worst direction."""

    angle: str
    displacement_m: tuple[float, ...]


@dataclass(frozen=True)
class TargetFit:
    """Fit of one target's points, over all lines, to their joint plane."""

    target: str
    sightings: int
    points: int
    rms_before_m: float
    rms_after_m: float


@dataclass(frozen=True)
class SightingFit:
    """Fit of one sighting's points to the adjusted plane of its target."""

    target: str
    line: str
    heading_deg: float | None
    points: int
    rms_before_m: float
    rms_after_m: float
    mean_after_m: float


@dataclass(frozen=True)
class Adjustment:
    """How well the adjustment went."""

    correlation: tuple[tuple[float, ...], ...]
    variance_factor: float | None
    degrees_of_freedom: int
    chi_square: Chi2
    iterations: int
    points: int
    rms_before_m: float
    rms_after_m: float
    effect_distances_m: tuple[float, ...]
    effects: tuple[Effect, ...]
    targets: tuple[TargetFit, ...]
    sightings: tuple[SightingFit, ...]


@dataclass(frozen=True)
class Distances:
    """Statistics of the unsigned distances between lines."""

    n: int
    mean_m: float
    median_m: float
    rms_m: float
    p68_m: float
    p95_m: float
    p99_m: float
    maximum_m: float


@dataclass(frozen=True)
class Pair:
    """Two lines compared on one validation plane."""

    line_a: str
    line_b: str
    reciprocal: bool
    before: Distances
    after: Distances


@dataclass(frozen=True)
class ValidationPlane:
    """Distances between the lines on one validation plane, with their histogram.

    The last bin also holds the distances beyond it.
    """

    name: str
    pooled_from: str
    before: Distances
    after: Distances
    pairs: tuple[Pair, ...]
    not_compared: tuple[tuple[str, str], ...]
    bin_edges_m: tuple[float, ...]
    counts_before: tuple[int, ...]
    counts_after: tuple[int, ...]


@dataclass(frozen=True)
class PickedPlane:
    """A target or validation plane as picked."""

    name: str
    role: str
    used: bool
    seed_local_m: tuple[float, ...]
    threshold_m: float
    radius_m: float
    lines: tuple[str, ...]
    left_out: tuple[str, ...]
    missing: Mapping[str, str]


@dataclass(frozen=True)
class Line:
    """One pass of the vessel."""

    name: str
    file: str
    heading_deg: float | None
    points: int | None
    track_local_m: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class ReportContent:
    """Everything a report says."""

    program: str
    generated: str
    project: str
    calibrated: bool
    simulated: bool
    cautions: tuple[Caution, ...]
    angles: tuple[Angle, ...]
    adjustment: Adjustment | None
    validation: tuple[ValidationPlane, ...]
    not_compared: tuple[str, ...]
    planes: tuple[PickedPlane, ...]
    lines: tuple[Line, ...]
    settings: SettingsUsed
    files: tuple[InputFile, ...]
    notes: tuple[str, ...]
