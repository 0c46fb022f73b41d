"""Reading options shared by formats of trajectories, and formats that check their options."""

from collections.abc import Callable
from pathlib import Path

from lispac.io.format_types import Choice, FileFormat, FilePreview, FormatOption, Kind
from lispac.language import N_
from lispac.messages import Message
from lispac.survey.time_base import TIME_BASE_KEYS
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

PITCH_OPTION = FormatOption(
    "pitch", N_("Direction of the bow for positive pitch."), ("bow-up", "bow-down"), "bow-up"
)
ROLL_OPTION = FormatOption(
    "roll",
    N_("Side that is down for positive roll. Starboard down is port up."),
    ("starboard-down", "port-down"),
    "starboard-down",
)
TIME_OPTION = FormatOption("time", N_("Time base."), TIME_BASE_KEYS, "gps-week")
GRID_SYSTEM_OPTION = FormatOption(
    "crs",
    N_("Coordinate system of eastings and northings where there is no latitude (EPSG:...)."),
)


def trajectory_format(
    name: Message,
    key: str,
    kind: Kind,
    endings: tuple[str, ...],
    options: tuple[FormatOption, ...],
    sniff: Callable[[Path], float],
    preview: Callable[[Path, Choice], FilePreview],
    read: Callable[[Path, Choice], Trajectory | TrajectoryAccuracy],
    *,
    has_time_base: bool = False,
) -> FileFormat:
    """Make a format that refuses unknown options before it examines or reads a file."""

    def preview_checked(path: Path, choice: Choice) -> FilePreview:
        """Make the preview of a file after a check of the options."""
        made.complete_options(choice)
        return preview(Path(path), choice)

    def read_checked(path: Path, choice: Choice) -> Trajectory | TrajectoryAccuracy:
        made.complete_options(choice)
        return read(Path(path), choice)

    made = FileFormat(
        name, key, kind, endings, options, sniff, preview_checked, read_checked,
        has_time_base=has_time_base,
    )  # fmt: skip
    return made
