"""Reading options shared by formats of trajectories, and functions that make these formats."""

from collections.abc import Callable
from pathlib import Path

from lispac.io.format_types import (
    IMPOSSIBLE,
    Choice,
    FileFormat,
    FilePreview,
    FormatOption,
    Kind,
)
from lispac.io.trajectory.trajectory_columns import (
    TrajectoryConventions,
    accuracy_of,
    trajectory_of,
)
from lispac.io.trajectory.trajectory_preview import TextLayout, has_sigmas, preview_accuracy
from lispac.language import N_
from lispac.messages import Message, note
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
    has_messages: bool = True,
) -> FileFormat:
    """Make a format that refuses unknown options before it examines or reads a file.

    ``has_messages`` is False if no preview of the format has messages.
    """

    def preview_checked(path: Path, choice: Choice) -> FilePreview:
        """Make the preview of a file after a check of the options."""
        made.complete_options(choice)
        return preview(Path(path), choice)

    def read_checked(path: Path, choice: Choice) -> Trajectory | TrajectoryAccuracy:
        made.complete_options(choice)
        return read(Path(path), choice)

    made = FileFormat(
        name, key, kind, endings, options, sniff, preview_checked, read_checked,
        read_messages=None if has_messages else lambda _path, _choice: (),
        has_time_base=has_time_base,
    )  # fmt: skip
    return made


def described_text_formats(
    trajectory: tuple[str, Message],
    accuracy: tuple[str, Message],
    options: tuple[FormatOption, ...],
    sniff: Callable[[Path], float],
    layout_of: Callable[[Path], TextLayout],
    preview: Callable[[Path, Choice], FilePreview],
    conventions_of: Callable[[TextLayout, Choice], TrajectoryConventions],
    *,
    has_time_base: bool = False,
) -> tuple[FileFormat, FileFormat]:
    """Make the formats of trajectory and standard deviations in text with described columns.

    Parameters
    ----------
    trajectory, accuracy : key and name of each format
    sniff, preview : callable
        As in `FileFormat`, for the trajectory.
    layout_of : callable
        Function of the path that returns the columns described in the header.
    conventions_of : callable
        Function of layout and options that returns the conventions of the values.
    """

    def read(path: Path, choice: Choice) -> Trajectory:
        layout = layout_of(path)
        header = note("assumed.header_columns", format=trajectory[1])
        assumptions = (header, *layout.file_warnings)
        conventions = conventions_of(layout, choice)
        return trajectory_of(path, layout.rows(path), layout.columns, conventions, assumptions)

    def sniff_accuracy(path: Path) -> float:
        confidence = sniff(path)
        return confidence if confidence and has_sigmas(layout_of(path).columns) else IMPOSSIBLE

    def preview_sigmas(path: Path, choice: Choice) -> FilePreview:
        layout = layout_of(path)
        return preview_accuracy(path, layout, conventions_of(layout, choice))

    def read_accuracy(path: Path, choice: Choice) -> TrajectoryAccuracy:
        layout = layout_of(path)
        conventions = conventions_of(layout, choice)
        return accuracy_of(path, layout.rows(path), layout.columns, conventions)

    endings = (".txt", ".csv")
    return (
        trajectory_format(
            trajectory[1], trajectory[0], "trajectory", endings, options, sniff, preview, read,
            has_time_base=has_time_base,
        ),
        trajectory_format(
            accuracy[1], accuracy[0], "accuracy", endings, options, sniff_accuracy, preview_sigmas,
            read_accuracy,
        ),
    )  # fmt: skip
