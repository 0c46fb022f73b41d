"""Motion of the vessel on each line, and the precision of the trajectory."""

from dataclasses import dataclass


@dataclass(frozen=True)
class LineTrajectorySummary:
    """Summary of the trajectory during one line, with its largest given standard deviations.

    Attributes
    ----------
    interval_s : usual time between two states of the trajectory
    longest_gap_s : longest time between two states
    motion_deg : standard deviations of roll and of pitch, which describe the motion of the vessel
    """

    line: str
    duration_s: float
    speed_m_s: float
    interval_s: float
    longest_gap_s: float
    motion_deg: tuple[float, float]
    sigma_horizontal_m: float
    sigma_vertical_m: float
    sigma_roll_pitch_deg: float
    sigma_heading_deg: float
