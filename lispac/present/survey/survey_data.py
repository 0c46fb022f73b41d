"""Input files, lines, trajectory and picked surfaces of a survey, as values and tables."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from lispac.geometry.frames import east_north_up
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.tables import COUNT, DEGREES, MILLIMETRES, SECONDS, Column, Format, Table
from lispac.present.targets.surface_geometry import SurfaceGeometryValues
from lispac.present.targets.targets import shape_text

IMPORT_SECONDS = Format("s", 1)
IMPORT_RATE = Format("", 2, 1e-6)
FILE_MEGABYTES = Format("", 1, 1e-6)
"""Formats of the import of a line: time, millions of points per second, size on the disk."""
FILE_ROLES = (N_("Trajectory"), N_("Trajectory accuracy"), N_("Reference"), N_("Control"))
"""Roles of the input files other than those of the lines."""
LINE_ROLE = "Line "
"""Role of the file of a line, before the name of the line."""


@dataclass(frozen=True)
class InputFile:
    """Input file of the project; size and digest are None if the file could not be read."""

    role: str
    name: str
    size_bytes: int | None
    sha256: str | None


def _role_text(file: InputFile) -> str:
    if file.role in FILE_ROLES:
        return gettext(file.role)
    return gettext("Line {name}", name=file.role.removeprefix(LINE_ROLE))


FILES_TABLE = Table[InputFile](
    N_("Input files"),
    (
        Column(_role_text, N_("Role")),
        Column("name", N_("File")),
        Column("size_bytes", N_("Size\n(bytes)"), COUNT),
        Column("sha256", "SHA-256", unknown=N_("not readable"), is_code=True),
    ),
)


@dataclass(frozen=True)
class PickedPlane:
    """Picked target or validation plane.

    ``seed_local_m`` is north, west, up from the origin of the local frame. ``sphere_radius_m`` is
    None for a plane or an unknown radius; ``radius_m`` is the search radius. ``geometry`` is None
    if the surface was found on no line.
    """

    name: str
    role: str
    shape: str
    sphere_radius_m: float | None
    used: bool
    seed_local_m: tuple[float, ...]
    threshold_m: float
    radius_m: float
    lines: tuple[str, ...]
    excluded_lines: tuple[str, ...]
    missing: Mapping[str, Message]
    geometry: SurfaceGeometryValues | None = None


def _plane_role_text(plane: PickedPlane) -> str:
    if plane.role == "target":
        return gettext("target") if plane.used else gettext("target, excluded")
    return gettext("validation plane") if plane.used else gettext("validation plane, excluded")


WHOLE_DEGREES = Format("deg", 0)
POSITION_METRES = Format("m", 2, is_grouped=False)


def position_columns(point: Callable[[Any], Sequence[float] | None]) -> tuple[Column[Any], ...]:
    """Columns of a position as read by surveyors: east, north, up.

    Parameters
    ----------
    point : function of a row that returns north, west, up, metres, or None if it is unknown
    """

    def coordinate(axis: int) -> Callable[[Any], float | None]:
        def value(row: Any) -> float | None:
            place = point(row)
            return None if place is None else float(east_north_up(place)[axis])

        return value

    return tuple(
        Column(coordinate(axis), title, POSITION_METRES)
        for axis, title in enumerate((N_("East"), N_("North"), N_("Up")))
    )


def planes_table(lines: int) -> Table[PickedPlane]:
    """Table of the picked surfaces of a survey.

    Parameters
    ----------
    lines : int
        Number of lines of the survey.
    """
    return Table(
        N_("Targets and validation planes (position from the origin of the local frame)"),
        (
            Column("name", N_("Name")),
            Column(_plane_role_text, N_("Role")),
            Column(lambda plane: shape_text(plane.shape, plane.sphere_radius_m), N_("Shape")),
            *position_columns(
                lambda plane: None if plane.geometry is None else plane.geometry.centre_local_m
            ),
            Column("geometry.size_text", N_("Width × height\n(m)")),
            Column("geometry.inclination_deg", N_("Inclination"), WHOLE_DEGREES),
            Column("geometry.azimuth_deg", N_("Azimuth of\nthe normal"), WHOLE_DEGREES),
            Column("threshold_m", N_("Threshold"), MILLIMETRES),
            Column(
                lambda plane: gettext(
                    "{count:n} of {total:n}", count=len(plane.lines), total=lines
                ),
                N_("Lines"),
            ),
        ),
    )


@dataclass(frozen=True)
class LineValues:
    """One line of the survey.

    ``track_local_m`` are places of the vessel: north and west from the origin of the local frame.
    """

    name: str
    file: str
    heading_deg: float | None
    points: int | None
    track_local_m: tuple[tuple[float, float], ...]


LINES_TABLE = Table[LineValues](
    N_("Lines"),
    (
        Column("name", N_("Line")),
        Column("file", N_("File")),
        Column(
            lambda line: None if line.heading_deg is None else line.heading_deg % 360,
            N_("Heading"), Format("deg", 1),
        ),
        Column("points", N_("Points"), COUNT),
    ),
)  # fmt: skip
WINDOW_LINES_TABLE = LINES_TABLE.without("File")
"""Table of the window, which shows the file as a tooltip."""


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


MOTION = Format("deg", 2)
TRAJECTORY_TABLE = Table[LineTrajectorySummary](
    N_("Trajectory on each line"),
    (
        Column("line", N_("Line")),
        Column("duration_s", N_("Duration"), Format("s", 1, is_grouped=False)),
        Column("speed_m_s", N_("Speed"), Format("m/s", 2)),
        Column("interval_s", N_("Sampling\ninterval"), SECONDS),
        Column("longest_gap_s", N_("Longest\ngap (s)"), Format("", 3, is_grouped=False)),
        Column(lambda line: line.motion_deg[0], N_("Roll"), MOTION),
        Column(lambda line: line.motion_deg[1], N_("Pitch"), MOTION),
        Column("sigma_horizontal_m", N_("Horizontal"), MILLIMETRES),
        Column("sigma_vertical_m", N_("Vertical"), MILLIMETRES),
        Column("sigma_roll_pitch_deg", N_("Roll, pitch"), DEGREES),
        Column("sigma_heading_deg", N_("Heading"), DEGREES),
    ),
)
