"""Settings of a result: mounting, points and stochastic model, as values and facts.

Field names of `SettingsUsed` are the keys of ``settings`` in JSON.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from lispac.adjustment.model.stochastic_model import MAX_KNOT_INTERVAL, PosErrors
from lispac.language import N_, gettext
from lispac.present.calibration.adjustment import AdjustmentValues, noisier_targets
from lispac.present.calibration.sigmas import (
    SigmaValues,
    lever_arm_decimals,
    sigma_facts,
    sigmas_used,
)
from lispac.present.tables import Fact
from lispac.present.text_format import (
    fixed_number,
    millimetres,
    origin_text,
    parameter_name,
    quantity_text,
    shortest_number,
    triple_text,
)
from lispac.project import Project, Settings

CONVENTION_TEXT = N_(
    "Convention: LISPAC (as iXblue). Body frame: forward, left, up. Roll is positive with"
    " the left side up, pitch positive with the bow down, yaw positive clockwise seen from "
    "above. The boresight rotates LiDAR axes into body axes: R = Rz(−yaw)·Ry(pitch)·Rx(roll). "
    "Other programs use other signs and orders: convert these angles before entering them in "
    "another program."
)

POS_ERROR_MODEL_NAMES: Mapping[PosErrors, str] = {
    "correlated": N_("correlated POS errors"),
    "independent": N_("uncorrelated POS errors (classical)"),
}
"""Names of the models of the POS errors in figures and forms of the survey design."""

POS_ERROR_TEXTS: Mapping[str, str] = {
    "correlated": N_("Correlated in time."),
    "independent": N_("Uncorrelated."),
}
POS_ERROR_MEANINGS: Mapping[str, str] = {
    "correlated": N_(
        "All points of one sighting share the errors of position and attitude at the time of the "
        "sighting, and sightings close in time share part of them (first-order Gauss-Markov "
        "process)."
    ),
    "independent": N_(
        "Every point has its own errors of position and attitude, independent of all others."
    ),
}
LOSS_TEXTS: Mapping[str, str] = {
    "none": N_("No robust estimation."),
    "huber": N_("Loss function: Huber."),
    "tukey": N_("Loss function: Tukey."),
}
LOSS_MEANINGS: Mapping[str, str] = {
    "none": N_("All points have the same weight, including outliers."),
    "huber": N_(
        "Points farther than 1.3 standard deviations from the surface have a smaller "
        "weight; outliers have little effect."
    ),
    "tukey": N_(
        "The weight of a point decreases with its distance from the surface; beyond 4.7 standard "
        "deviations it is zero."
    ),
}
OFFSET_TITLES: Mapping[str, str] = {
    "range_offset": N_("Given range offset"),
    "scan_angle_offset": N_("Given scan-angle offset"),
    "latency": N_("Given latency"),
}
"""Titles of the offsets, by the name of the value."""

DEFAULT_CORRELATION_TIMES_TEXT = N_("{position} s, {attitude} s (default values)")
CORRELATION_TIMES_TEXT = N_("{position} s, {attitude} s (given)")


@dataclass(frozen=True)
class SettingsUsed:
    """Settings of a result; the POS sigmas are None if an accuracy file was given.

    The LiDAR noise is that along x, y, z, or of range and angle; if both are None,
    ``lidar_sigma_m`` applies to each axis. ``standard_deviations`` contains the source of each,
    and the values after the estimate of variance components. ``averaged``: close points are
    averaged, not thinned.
    ``origin_deg_m`` contains latitude, longitude and ellipsoidal height of the origin of the local
    frame; it is None if it is not given and the trajectory has not been read.
    ``surface_sigma_m`` is the value used; it is None before it is estimated and with uncorrelated
    POS errors. ``surface_from_data`` is None with uncorrelated POS errors. ``offset_sigma_m`` is
    None if it equals the surface sigma.
    """

    lever_arm_m: tuple[float, ...]
    lever_arm_sigma_m: tuple[float, ...] | None
    origin_deg_m: tuple[float, ...] | None
    origin_is_given: bool
    position_sigma_m: tuple[float, ...] | None
    attitude_sigma_deg: tuple[float, ...] | None
    lidar_sigma_m: float
    lidar_sigma_xyz_m: tuple[float, ...] | None
    lidar_range_sigma_m: float | None
    lidar_angle_sigma_deg: float | None
    range_offset_m: float
    scan_angle_offset_deg: float
    latency_s: float
    subsample_m: float
    accept_single_orientation: bool
    averaged: bool
    pos_errors: str
    position_correlation_time_s: float | None
    attitude_correlation_time_s: float | None
    pos_errors_text: str
    standard_deviations: tuple[SigmaValues, ...]
    surface_sigma_m: float | None
    offset_sigma_m: float | None
    surface_from_data: bool | None
    loss: str
    loss_text: str
    convention: str


def settings_used(project: Project, origin_deg_m: tuple[float, ...] | None = None) -> SettingsUsed:
    """Settings of the result, or of the project if it has no result yet.

    Parameters
    ----------
    origin_deg_m : tuple of float, degrees and metres, optional
        Origin of the local frame of the loaded trajectory.
    """
    settings, result = project.settings, project.result
    typed = project.accuracy is None
    model = result.model if result else settings.stochastic_model
    beam = settings.lidar_beam_sigma
    found = result.surface if result else model.surface
    return SettingsUsed(
        lever_arm_m=settings.lever_arm,
        lever_arm_sigma_m=model.lever_arm_sigma,
        origin_deg_m=origin_deg_m or settings.origin_deg_m,
        origin_is_given=settings.origin_deg_m is not None,
        position_sigma_m=settings.used_position_sigma if typed else None,
        attitude_sigma_deg=settings.used_attitude_sigma_deg if typed else None,
        lidar_sigma_m=settings.used_lidar_sigma,
        lidar_sigma_xyz_m=settings.lidar_sigma_xyz,
        lidar_range_sigma_m=beam[0] if beam else None,
        lidar_angle_sigma_deg=beam[1] if beam else None,
        range_offset_m=settings.range_offset,
        scan_angle_offset_deg=settings.scan_angle_offset_deg,
        latency_s=settings.latency,
        subsample_m=settings.subsample,
        accept_single_orientation=settings.accept_single_orientation,
        averaged=model.correlated,
        pos_errors=model.pos_errors,
        position_correlation_time_s=model.position_time if model.correlated else None,
        attitude_correlation_time_s=model.attitude_time if model.correlated else None,
        pos_errors_text=POS_ERROR_MEANINGS[model.pos_errors],
        standard_deviations=sigmas_used(project),
        surface_sigma_m=found if model.correlated else None,
        offset_sigma_m=result.offset if result else None,
        surface_from_data=model.surface is None if model.correlated else None,
        loss=model.loss,
        loss_text=LOSS_MEANINGS[model.loss],
        convention=CONVENTION_TEXT,
    )


def system_facts(used: SettingsUsed, adjustment: AdjustmentValues | None) -> list[Fact]:
    """Lever arm first, local frame, estimated parameters and point spacing, as texts."""
    names = [p.name for p in adjustment.parameters] if adjustment else []
    is_estimated = any(name.startswith("lever") for name in names)
    decimals = 4 if is_estimated else lever_arm_decimals(used.lever_arm_m)
    lever_arm = gettext("{values} m", values=triple_text(used.lever_arm_m, decimals))
    if is_estimated:
        values = [Fact(gettext("Prior lever arm (forward, left, up)"), lever_arm)]
    else:
        values = [Fact(gettext("Lever arm (forward, left, up)"), lever_arm)]
    values.append(origin_fact(used.origin_deg_m, is_given=used.origin_is_given))
    for name, value in (
        ("range_offset", used.range_offset_m),
        ("scan_angle_offset", used.scan_angle_offset_deg),
        ("latency", used.latency_s),
    ):
        if value:
            values.append(Fact(gettext(OFFSET_TITLES[name]), quantity_text(name, value, sign=True)))
    if names:
        estimated = [gettext("boresight"), *map(parameter_name, names)]
        values.append(
            Fact(
                gettext("Parameters selected for estimation"),
                gettext("{names:names}", names=estimated),
            )
        )
    if used.accept_single_orientation:
        values.append(Fact(gettext("Targets of a single orientation"), gettext("accepted")))
    has_spheres = adjustment is None or any(t.shape == "sphere" for t in adjustment.targets)
    return [*values, Fact(gettext("Point spacing"), _subsampling_text(used, has_spheres))]


def origin_fact(origin_deg_m: tuple[float, ...] | None, *, is_given: bool) -> Fact:
    """Position of the origin of the local frame, in the language in use."""
    text = gettext(
        "{origin}; east, north and up are measured from it",
        origin=origin_text(origin_deg_m, is_given=is_given),
    )
    return Fact(gettext("Origin of the local frame"), text)


def _subsampling_text(used: SettingsUsed, has_spheres: bool) -> str:
    if not used.subsample_m:
        return gettext("none: all points are used")
    spacing, duration = fixed_number(used.subsample_m, 3), fixed_number(MAX_KNOT_INTERVAL, 2)
    if used.averaged and not has_spheres:
        return gettext(
            "averaged: the points of a plane within a square of {spacing} m, measured within at "
            "most {duration} s, are replaced by their mean",
            spacing=spacing,
            duration=duration,
        )
    if used.averaged:
        return gettext(
            "averaged: the points of a plane within a square of {spacing} m, measured within at "
            "most {duration} s, are replaced by their mean; points of spheres are not averaged",
            spacing=spacing,
            duration=duration,
        )
    return gettext(
        "thinned: where points are closer than {spacing} m to each other, one is kept",
        spacing=spacing,
    )


def model_facts(used: SettingsUsed, adjustment: AdjustmentValues | None) -> list[Fact]:
    """Stochastic model, in the language in use."""
    sightings = () if adjustment is None else adjustment.sightings
    lidar, position, attitude, lever_arm = sigma_facts(
        used.standard_deviations, used.lever_arm_sigma_m, sightings
    )
    values = [
        Fact(
            gettext("POS errors"),
            f"{gettext(POS_ERROR_TEXTS[used.pos_errors])} {gettext(used.pos_errors_text)}",
        ),
        position,
        attitude,
    ]
    if used.position_correlation_time_s and used.attitude_correlation_time_s:
        pair = used.position_correlation_time_s, used.attitude_correlation_time_s
        are_default = pair == (Settings.position_time, Settings.attitude_time)
        position_time, attitude_time = map(shortest_number, pair)
        times = gettext(
            DEFAULT_CORRELATION_TIMES_TEXT if are_default else CORRELATION_TIMES_TEXT,
            position=position_time, attitude=attitude_time,
        )  # fmt: skip
        values.append(Fact(gettext("Correlation times (position, attitude)"), times))
    values.append(lidar)
    if adjustment is not None and used.pos_errors == "correlated":
        values.append(Fact(gettext("Estimated LiDAR noise"), _noise_factor_text(adjustment)))
    if used.surface_from_data is not None:
        values.append(
            Fact(
                gettext("Form error of the targets from line to line (1 sigma)"),
                _surface_sigma_text(used),
            )
        )
    values.append(lever_arm)
    loss = f"{gettext(LOSS_TEXTS[used.loss])} {gettext(used.loss_text)}"
    return [*values, Fact(gettext("Outliers"), loss)]


def _noise_factor_text(adjustment: AdjustmentValues) -> str:
    factors = {target.target: target.noise_factor or 1.0 for target in adjustment.targets}
    larger = noisier_targets(factors)
    if not larger:
        return gettext("not larger than the noise used on any target")
    found = [
        gettext("{target}: {factor}\u00a0times", factor=fixed_number(factors[name], 2), target=name)
        for name in larger
    ]
    return gettext(
        "{factors:names} the noise used; the sigmas of the angles are computed with this noise",
        factors=found,
    )


def _surface_sigma_text(used: SettingsUsed) -> str:
    if used.surface_sigma_m is None:
        return gettext("to be estimated from the data")
    if used.surface_sigma_m == 0:
        return gettext("zero: all sightings of a target lie on the same surface")
    if used.offset_sigma_m is None:
        sigmas = gettext("{surface}\u00a0mm", surface=_tenths_of_millimetre(used.surface_sigma_m))
    else:
        sigmas = gettext(
            "offsets {offset}\u00a0mm, tilts {surface}\u00a0mm",
            offset=_tenths_of_millimetre(used.offset_sigma_m),
            surface=_tenths_of_millimetre(used.surface_sigma_m),
        )
    if used.surface_from_data:
        return gettext("{sigmas}, estimated from the data", sigmas=sigmas)
    return gettext("{sigmas}, as given", sigmas=sigmas)


def _tenths_of_millimetre(metres: float) -> str:
    if round(1000 * metres, 1) == 0.0:
        return gettext("below {limit}", limit=fixed_number(0.1, 1))
    return millimetres(metres)
