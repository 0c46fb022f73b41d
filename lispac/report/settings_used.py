"""Settings of a result as report values, with English texts that are translated later."""

from lispac.language import N_
from lispac.project import Project
from lispac.report.report_values import SettingsUsed

CONVENTION_TEXT = N_(
    "Local frame: north, west, up. Body frame: forward, left, up. Roll is positive with the left "
    "side up, pitch positive with the bow down, yaw positive clockwise seen from above. The "
    "boresight rotates LiDAR axes into body axes: R = Rz(−yaw)·Ry(pitch)·Rx(roll). Other programs "
    "use other signs and orders: convert these angles before entering them in another program."
)

POS_ERROR_TEXTS = {
    "correlated": N_(
        "All points of one sighting share the errors of position and attitude at the time of the "
        "sighting, and sightings close in time share part of them (first-order Gauss-Markov "
        "process)."
    ),
    "independent": N_(
        "Every point has its own errors of position and attitude, independent of all others."
    ),
}

LOSS_TEXTS = {
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


def settings_used(project: Project) -> SettingsUsed:
    """Settings of the result, or of the project if it has no result yet."""
    settings, result = project.settings, project.result
    typed = project.accuracy is None
    model = result.model if result else settings.stochastic_model
    beam = settings.lidar_beam_sigma
    found = result.surface if result else model.surface
    return SettingsUsed(
        lever_arm_m=settings.lever_arm,
        origin_deg_m=settings.origin_deg_m,
        position_sigma_m=settings.position_sigma if typed else None,
        attitude_sigma_deg=settings.attitude_sigma_deg if typed else None,
        lidar_sigma_m=settings.lidar_sigma,
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
        pos_errors_text=POS_ERROR_TEXTS[model.pos_errors],
        surface_sigma_m=found if model.correlated else None,
        offset_sigma_m=result.offset if result else None,
        surface_from_data=model.surface is None if model.correlated else None,
        loss=model.loss,
        loss_text=LOSS_TEXTS[model.loss],
        convention=CONVENTION_TEXT,
    )
