"""Reading of a scene from TOML: surfaces, targets among them, and the survey lines."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from lispac.errors import ProjectError
from lispac.io.config.toml_table import TomlTable
from lispac.io.points.mesh_file import read_mesh
from lispac.picked_targets import require_target_name
from lispac.simulation.motion_source import TrajectoryStretch
from lispac.simulation.scene import (
    Cylinder,
    Rectangle,
    Scene,
    Sphere,
    Surface,
    box_faces,
    tilted_rectangle,
    upright_rectangle,
)
from lispac.simulation.vessel_motion import SailedLine

SURFACE_KINDS = ("board", "wall", "box", "cylinder", "sphere", "mesh")
TARGET_ROLES = ("target", "validation")


@dataclass(frozen=True, eq=False)
class SceneFile:
    """Content of a scene file.

    Attributes
    ----------
    title : str
    vessel, scanner : str
        Names or files of the vessel and the scanner that the scene is designed for.
    origin : tuple of float or None
        Latitude and longitude (radians) and ellipsoidal height (metres) of the local frame; None
        for the mean of a recorded trajectory.
    scene : Scene
    targets, validation : tuple of str
        Names of surfaces.
    lines : tuple of SailedLine
        Courses to be sailed; empty if a recorded trajectory is replayed.
    stretches : tuple of TrajectoryStretch
        Parts of a recorded trajectory that are used as lines.
    trajectory : Path or None
        The recorded trajectory.
    pulses_per_second : float or None
        Pulse rate of the scanner; None for the scanner's default.
    """

    title: str
    vessel: str
    scanner: str
    origin: tuple[float, float, float] | None
    scene: Scene
    targets: tuple[str, ...]
    validation: tuple[str, ...]
    lines: tuple[SailedLine, ...]
    stretches: tuple[TrajectoryStretch, ...]
    trajectory: Path | None
    pulses_per_second: float | None


def read_scene(path: Path) -> SceneFile:
    """Read a scene.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "scene") as table:
        surfaces: list[Surface] = []
        roles: dict[str, list[str]] = {role: [] for role in TARGET_ROLES}
        for each in table.tables("surfaces"):
            name = each.text("name")
            role = each.one_of("role", TARGET_ROLES, None)
            if role is not None:
                _require_target_name(each, name, surfaces)
                roles[role].append(name)
            surfaces += _read_surfaces(each, name, is_target=role is not None)
        if not surfaces:
            raise table.refuse("surfaces", "scene.no_surfaces")
        lines, stretches = _read_lines(table)
        trajectory = table.text("trajectory", None)
        return SceneFile(
            table.text("title"), table.text("vessel"), table.text("scanner"), _read_origin(table),
            Scene.of(surfaces), tuple(roles["target"]), tuple(roles["validation"]), lines,
            stretches, None if trajectory is None else Path(path).parent / trajectory,
            table.number("pulses_per_second", None, over=0, high=1e7),
        )  # fmt: skip


def _read_origin(table: TomlTable) -> tuple[float, float, float] | None:
    if "origin" not in table:
        return None
    with table.table("origin") as origin:
        latitude = origin.number("latitude_deg", low=-90, high=90)
        longitude = origin.number("longitude_deg", low=-360, high=360)
        height = origin.number("height_m", low=-1000, high=10_000)
        return float(np.radians(latitude)), float(np.radians(longitude)), height


def _require_target_name(table: TomlTable, name: str, surfaces: list[Surface]) -> None:
    try:
        require_target_name(name)
    except ProjectError as failure:
        raise table.refuse("name", "scene.target_name", reason=failure.reason) from failure
    if any(surface.name == name for surface in surfaces):
        raise table.refuse("name", "scene.name_twice", name=name)


def _read_surfaces(table: TomlTable, name: str, *, is_target: bool) -> list[Surface]:
    kind = table.one_of("kind", SURFACE_KINDS)
    if is_target and kind not in ("board", "wall", "sphere"):
        raise table.refuse("role", "scene.role_of_kind", kind=kind)
    if is_target and kind == "sphere" and table.one_of("role", TARGET_ROLES) == "validation":
        raise table.refuse("role", "scene.validation_sphere")
    reflectance = table.number("reflectance", 0.4, low=0, high=1)
    if kind == "board":
        return [_read_board(table, name, reflectance)]
    if kind == "wall":
        bottom = table.number("bottom_m")
        return [
            upright_rectangle(
                name, (table.number("north_m"), table.number("west_m")), bottom,
                table.number("top_m", over=bottom), table.number("width_m", over=0),
                table.number("facing_deg"), reflectance,
            )
        ]  # fmt: skip
    if kind == "box":
        bottom = table.number("bottom_m")
        north, west = table.numbers("north_m", 2), table.numbers("west_m", 2)
        return [
            *box_faces(
                name, (north[0], north[1]), (west[0], west[1]), bottom,
                table.number("top_m", over=bottom), reflectance,
            )
        ]  # fmt: skip
    if kind == "cylinder":
        bottom = table.number("bottom_m")
        return [
            Cylinder(
                name, table.number("north_m"), table.number("west_m"), bottom,
                table.number("top_m", over=bottom), table.number("radius_m", over=0), reflectance,
            )
        ]  # fmt: skip
    if kind == "sphere":
        centre = np.array(table.three_numbers("centre_m"))
        return [Sphere(name, centre, table.number("radius_m", over=0), reflectance)]
    return [read_mesh(table.path.parent / table.text("file"), name, reflectance)]


def _read_board(table: TomlTable, name: str, reflectance: float) -> Rectangle:
    return tilted_rectangle(
        name, table.three_numbers("centre_m"), table.number("width_m", over=0),
        table.number("height_m", over=0), table.number("facing_deg"),
        table.number("elevation_deg", 0.0, low=-90, high=90), reflectance,
    )  # fmt: skip


def _read_lines(table: TomlTable) -> tuple[tuple[SailedLine, ...], tuple[TrajectoryStretch, ...]]:
    """Read the lines; a line with ``start_s`` is a part of a recorded trajectory."""
    lines: list[SailedLine] = []
    stretches: list[TrajectoryStretch] = []
    with table.table("pattern") as pattern:
        about = pattern.numbers("about_m", 2, (0.0, 0.0))
        distance = pattern.number("distance_m", None, low=0)
    for line in table.tables("lines"):
        if "start_s" in line:
            start = line.number("start_s")
            side = line.one_of("side", ("port", "starboard"))
            stop = line.number("stop_s", over=start)
            stretches.append(TrajectoryStretch(start, stop, side == "starboard"))
            continue
        if distance is None:
            raise table.refuse("pattern.distance_m", "scene.no_distance")
        heading, bearing = line.number("heading_deg"), line.number("bearing_deg")
        relative_bearing = (bearing - heading) % 360
        if relative_bearing in (0, 180):
            raise line.refuse("bearing_deg", "scene.bearing_along_heading")
        bearing_rad = np.radians(bearing)
        lines.append(
            SailedLine(
                float(np.radians(heading)),
                (
                    float(about[0] - distance * np.cos(bearing_rad)),
                    float(about[1] + distance * np.sin(bearing_rad)),
                ),
                line.number("run_in_m", low=0), line.number("run_out_m", low=0),
                relative_bearing < 180,
            )
        )  # fmt: skip
    if lines and stretches:
        raise table.refuse("lines", "scene.mixed_lines")
    if not lines and not stretches:
        raise table.refuse("lines", "scene.no_lines")
    if any(each.run_in + each.run_out < 1 for each in lines):
        raise table.refuse("lines", "scene.line_too_short")
    return tuple(lines), tuple(stretches)
