"""Fit of each target to one surface for all lines, as values and table."""

from dataclasses import dataclass

from lispac.adjustment.diagnostics.reliability import CRITICAL_VALUE
from lispac.adjustment.diagnostics.sighting_warnings import NOISE_FACTOR_LIMIT
from lispac.adjustment.result import (
    AdjustmentResult,
)
from lispac.language import N_, gettext, gettext_lazy
from lispac.present.tables import (
    COUNT,
    MILLIMETRES,
    Column,
    Table,
    ratio,
)


@dataclass(frozen=True)
class TargetValues:
    """Fit of the points of one target on all lines to their common surface.

    ``noise_factor`` is the ratio of the LiDAR noise estimated from the residuals to that of all
    targets, at least 1. It is None with uncorrelated POS errors. ``largest_w`` and ``outliers`` are
    None if the sightings were not tested.
    """

    target: str
    shape: str
    radius_m: float | None
    sightings: int
    points: int
    rms_before_m: float
    rms_after_m: float
    noise_factor: float | None
    largest_w: float | None
    outliers: int | None
    rejected_lines: tuple[str, ...]


def target_values(result: AdjustmentResult) -> tuple[TargetValues, ...]:
    """Fit of every target."""
    lines = [each.sighting.target for each in result.sightings]
    found = []
    for target in result.targets:
        tests = [r for r in result.reliability if r.sighting.target == target.target]
        found.append(
            TargetValues(
                target=target.target,
                shape="sphere" if target.sphere else "plane",
                radius_m=float(target.plane[3]) if target.sphere else None,
                sightings=lines.count(target.target),
                points=target.points,
                rms_before_m=target.rms_before,
                rms_after_m=target.rms_after,
                noise_factor=target.noise if result.model.correlated else None,
                largest_w=max((abs(r.w) for r in tests if not r.rejected), default=None),
                outliers=sum(r.outliers for r in tests) if tests else None,
                rejected_lines=tuple(r.sighting.line for r in tests if r.rejected),
            )
        )
    return tuple(found)


RMS_INCREASE_LIMIT = 1.5
"""Ratio of the RMS after the calibration to that before it, above which a target is pointed out:
more than averages of correlated errors change."""


def shape_text(shape: str, radius_m: float | None) -> str:
    """Shape of a surface with its radius, in the language in use."""
    if shape != "sphere":
        return gettext("plane")
    if radius_m is None:
        return gettext("sphere")
    return gettext("sphere, radius\u00a0{radius:mm.1}\u00a0mm", radius=radius_m)


def target_finding(target: TargetValues) -> str:
    """Finding about a target in the language in use; empty if there is none."""
    if target.rejected_lines:
        return gettext("rejected in {lines:names}", lines=target.rejected_lines)
    if target.rms_after_m > RMS_INCREASE_LIMIT * target.rms_before_m:
        return gettext("RMS larger than before")
    if target.noise_factor is not None and target.noise_factor > NOISE_FACTOR_LIMIT:
        return gettext("noise larger than given")
    return ""


TARGETS_TABLE = Table[TargetValues](
    N_("Fit of each target to one surface, all lines together"),
    (
        Column("target", N_("Target"), tip=N_("Target")),
        Column(lambda t: shape_text(t.shape, t.radius_m), N_("Shape"), tip=N_("Plane or sphere")),
        Column(
            "sightings", N_("Lines"), COUNT, N_("Number of lines with a sighting of the target")
        ),
        Column(
            "points", N_("Points\nused"), COUNT, N_("Points used, after averaging or thinning")
        ),
        Column(
            "rms_before_m", N_("RMS\nbefore"), MILLIMETRES,
            N_("RMS distance to the best-fitting surface with the prior boresight"),
        ),
        Column(
            "rms_after_m", N_("RMS\nafter"), MILLIMETRES,
            N_("RMS distance to the adjusted surface"),
        ),
        Column(
            "noise_factor", N_("Noise\nfactor"), ratio(2),
            N_("Noise of the residuals divided by the LiDAR noise of all targets, at least 1"),
        ),
        Column(
            "largest_w", N_("Largest w\nof a sighting"), ratio(2),
            N_("Largest test value w of the sightings of the target"),
        ),
        Column(
            "outliers", N_("Outliers"), COUNT,
            gettext_lazy(
                "Number of points with a test value beyond {limit:x.2}", limit=CRITICAL_VALUE
            ),
        ),
        Column(target_finding, N_("Finding"), tip=N_("Finding that should be checked")),
    ),
)  # fmt: skip
