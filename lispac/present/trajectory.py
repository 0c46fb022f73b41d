"""Motion of the vessel on each line, and the precision of the trajectory."""

from dataclasses import dataclass


@dataclass(frozen=True)
class LineTrajectorySummary:
    """Summary of the trajectory during one line, with its largest given standard deviations.

    Attributes
    ----------
    interval_s : usual time between two states; ``longest_gap_s`` the longest
    motion_deg : standard deviation of roll and of pitch: how much the vessel moved
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
