"""Coordinate system of exported data."""

import math
from collections.abc import Sequence
from dataclasses import replace

from lispac.errors import InputError
from lispac.io.point_reader_common import DATUM_OPTION, EPOCH_OPTION, crs_of_options
from lispac.messages import Message, error, warning
from lispac.project import LineSource, Project
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.crs_area import area_of_use_elsewhere
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.line_chunks import LineChunks

LOCAL_FRAME = "local"
"""Text by which the user selects the local frame instead of a coordinate system."""
MIN_EPOCH, MAX_EPOCH = 1900.0, 2100.0
"""Range of accepted epochs, decimal years; others are considered typing errors."""


def utm_zone(trajectory: LocalTrajectory) -> str:
    """EPSG code of the UTM zone (WGS 84) of a trajectory's origin."""
    longitude = (math.degrees(trajectory.frame.longitude) + 180) % 360
    zone = min(int(longitude // 6) + 1, 60)
    return f"EPSG:{32600 + zone if trajectory.frame.latitude >= 0 else 32700 + zone}"


def output_system(
    chosen: Sequence[LineChunks], trajectory: LocalTrajectory, system: str, height: str = "",
    trajectory_datum: str | None = None, epoch: float | None = None,
) -> CoordinateSystem | None:  # fmt: skip
    """Coordinate system of an export: that of the lines by default, None for the local frame.

    Parameters
    ----------
    trajectory_datum : str, optional
        As for `lispac.survey.crs.coordinate_system`; by default, datum and epoch are those with
        which the lines are read.

    Raises
    ------
    InputError
        If the system is not known, the lines have different ones, or an epoch has no effect.
    """
    if epoch is not None and not MIN_EPOCH <= epoch <= MAX_EPOCH:
        raise InputError(error("export.bad_epoch", epoch=f"{epoch:g}"))
    if not system and not height and not trajectory_datum:
        own = _chunks_system(chosen)
        if own is not None:
            return own if epoch is None else _own_system_at_epoch(chosen, epoch)
    if trajectory_datum is None and system != LOCAL_FRAME:
        trajectory_datum, own_epoch = _chunks_datum(chosen)
        epoch = own_epoch if epoch is None else epoch
    return requested_system(system, trajectory, height, trajectory_datum or "", epoch)


def _own_system_at_epoch(chosen: Sequence[LineChunks], epoch: float) -> CoordinateSystem | None:
    """System of the lines, with the datum of their trajectory at another epoch."""
    georeferenced = next(chunks for chunks in chosen if chunks.system is not None)
    choice = georeferenced.choice
    _require_datum(choice[DATUM_OPTION.name], epoch)
    return crs_of_options({**choice, EPOCH_OPTION.name: repr(epoch)}, georeferenced.line.path)


def _require_datum(trajectory_datum: str, epoch: float | None) -> None:
    if epoch is not None and not trajectory_datum:
        raise InputError(error("export.epoch_without_datum", epoch=f"{epoch:g}"))


def trajectory_datum_of(lines: Sequence[LineSource]) -> tuple[str, float | None]:
    """Datum and epoch of the trajectory with which georeferenced lines are read; empty if none.

    Raises
    ------
    InputError
        If the lines are read with different ones.
    """
    return _chunks_datum([LineChunks.of(line) for line in lines])


def _chunks_datum(chosen: Sequence[LineChunks]) -> tuple[str, float | None]:
    found = {
        (str(c.choice[DATUM_OPTION.name]).strip(), str(c.choice[EPOCH_OPTION.name]).strip())
        for c in chosen if c.system is not None
    }  # fmt: skip
    if len(found) > 1:
        words = sorted(f"{datum or '–'} ({year or '–'})" for datum, year in found)
        raise InputError(error("export.different_datums", datums=words))
    datum, year = next(iter(found), ("", ""))
    return datum, float(year) if year and datum else None


def requested_system(
    text: str, trajectory: LocalTrajectory, height: str = "", trajectory_datum: str = "",
    epoch: float | None = None,
) -> CoordinateSystem | None:  # fmt: skip
    """Coordinate system chosen by the user; None for the local frame.

    Raises
    ------
    InputError
        If no system is chosen, or it is not known.
    """
    if text == LOCAL_FRAME:
        if height or trajectory_datum or epoch is not None:
            raise InputError(error("export.local_frame_options"))
        return None
    if not text:
        raise InputError(error("export.no_system", zone=utm_zone(trajectory), local=LOCAL_FRAME))
    _require_datum(trajectory_datum, epoch)
    found = coordinate_system(text, height=height, trajectory_datum=trajectory_datum, epoch=epoch)
    return replace(found, assumptions=(*found.assumptions, *_far_away_warning(found, trajectory)))


def _far_away_warning(system: CoordinateSystem, trajectory: LocalTrajectory) -> tuple[Message, ...]:
    """Warning that the survey is outside the area of use of a coordinate system."""
    latitude, longitude = trajectory.frame.latitude, trajectory.frame.longitude
    elsewhere = area_of_use_elsewhere(system.crs, math.degrees(latitude), math.degrees(longitude))
    if not elsewhere:
        return ()
    return (
        warning(
            "crs.meant_elsewhere", system=system.name, area=elsewhere, latitude=latitude,
            longitude=longitude, zone=utm_zone(trajectory),
        ),
    )  # fmt: skip


def common_system(project: Project) -> CoordinateSystem | None:
    """Coordinate system of the files of the lines; None if they are in the LiDAR frame.

    Raises
    ------
    InputError
        If the files have different coordinate systems.
    """
    return _chunks_system([LineChunks.of(line) for line in project.lines])


def _chunks_system(chosen: Sequence[LineChunks]) -> CoordinateSystem | None:
    own = {
        (c.system.written.to_wkt(), c.system.pipeline): c for c in chosen if c.system is not None
    }
    if len(own) > 1:
        systems = [_system_description(found) for found in own.values()]
        raise InputError(error("export.different_systems", systems=systems))
    return next((c.system for c in own.values()), None)


def _system_description(chunks: LineChunks) -> str:
    """Name of a line's coordinate system with height, datum and epoch."""
    assert chunks.system is not None
    details = [str(chunks.system.height)]
    if datum := str(chunks.choice[DATUM_OPTION.name]).strip():
        epoch = str(chunks.choice[EPOCH_OPTION.name]).strip()
        details.append(f"{datum}@{epoch}" if epoch else datum)
    return f"{chunks.line.name}: {chunks.system.name} ({'; '.join(details)})"


def output_system_of(
    project: Project, trajectory: LocalTrajectory, system: str, height: str = "",
    trajectory_datum: str | None = None, epoch: float | None = None,
) -> CoordinateSystem | None:  # fmt: skip
    """Coordinate system of an export for all lines of a project."""
    chosen = [] if system == LOCAL_FRAME else [LineChunks.of(line) for line in project.lines]
    return output_system(chosen, trajectory, system, height, trajectory_datum, epoch)
