"""Quality of the trajectory on each line."""

import numpy as np

from lispac.present.survey_data import LineTrajectorySummary
from lispac.workflow.project.survey import Survey


def trajectory_on_lines(survey: Survey) -> tuple[LineTrajectorySummary, ...]:
    """Motion and accuracy of the trajectory on each line with at least two trajectory states."""
    found = []
    for name, scan in survey.scans.items():
        times = survey.trajectory.time
        # The states just before the first and after the last time of the line are included.
        first = max(int(np.searchsorted(times, scan.first_time, side="right")) - 1, 0)
        last = min(int(np.searchsorted(times, scan.last_time)) + 1, len(times))
        own = slice(first, last)
        if last - first < 2:
            continue
        times = times[own]
        steps = np.diff(times)
        way = np.linalg.norm(np.diff(survey.trajectory.position[own], axis=0), axis=1).sum()
        motion = np.degrees(survey.trajectory.attitude[own, :2]).std(axis=0)
        position, attitude = survey.accuracy.at(times)
        angles = np.degrees(attitude)
        found.append(
            LineTrajectorySummary(
                line=name,
                duration_s=scan.last_time - scan.first_time,
                speed_m_s=float(way / (times[-1] - times[0])),
                interval_s=float(np.median(steps)),
                longest_gap_s=float(steps.max()),
                motion_deg=(float(motion[0]), float(motion[1])),
                sigma_horizontal_m=float(np.hypot(position[:, 0], position[:, 1]).max()),
                sigma_vertical_m=float(position[:, 2].max()),
                sigma_roll_pitch_deg=float(angles[:, :2].max()),
                sigma_heading_deg=float(angles[:, 2].max()),
            )
        )
    return tuple(found)
