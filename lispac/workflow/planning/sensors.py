"""Library of sensors supplied with the program and defined by the user.

A file of the user replaces the supplied file with the same name.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Generic, TypeVar

from lispac.errors import InputError, system_reason
from lispac.installation_paths import resource_path, user_folder
from lispac.io.config.sensor_file import (
    PosAccuracy,
    PosSpecification,
    ScannerSpecification,
    SensorSpecification,
    read_pos_specification,
    read_scanner_specification,
    write_specification,
)
from lispac.language import N_, gettext
from lispac.messages import Level, Message, as_message, error

UNVERIFIED_SOURCE_TEXT = N_("{source} (not verified: check the data sheet)")
"""Text of a source whose values were not compared with the data sheet."""
SUPPLIED_SOURCES = (
    N_("Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (land, 60 s without GNSS, RTK before)"),
    N_(
        "Apogee Series Hardware Manual APOGEEHM.1.5, 2.3.3 (land, no outage); base station at 10 km"
    ),
    N_(
        "HDL-32E user's manual 63-9113: range accuracy used as noise; beam direction and "
        "divergence assumed"
    ),
    N_(
        "Heading: POS MV V4 User Guide (2009), page 1-8, antennas 2 m apart; other values not "
        "from a data sheet, base station at 10 km"
    ),
    N_("No data sheet available; DGNSS without fixed ambiguities"),
    N_("No data sheet available; POSPac, antennas 2 m apart, base station at 10 km"),
    N_(
        "No data sheet available; range precision; angular resolution used as the sigma of the "
        "angle"
    ),
    N_("No data sheet available; values rounded up"),
    N_("No data sheet available; about 60 s without GNSS, values rounded up"),
    N_(
        "Ouster OS1 data sheet (128 channels up to +22.5 deg; no date): repeatability "
        "with a strong signal"
    ),
    N_("PandarXT user manual: range precision; beam direction and divergence assumed"),
    N_(
        "RIEGL VUX-1UAV data sheet: range precision; angular resolution used as the sigma of the "
        "angle"
    ),
    N_(
        "Shahraji's thesis, section 1.2.1, table 1.1, after Zoller + Fröhlich (2022); the actual "
        "beam divergence is smaller"
    ),
    N_("Shahraji's thesis, section 1.2.2, table 1.2, after iXblue (2019); base station at 10 km"),
)
"""Sources of the sensors supplied with the program, for translation."""
MAX_TEXT_LENGTH = 200
"""Largest number of characters of a title or a source."""
SIMULATED_SCANNERS = ("profiler",)
"""Scanners that exist in the simulator only."""
MIN_LIDAR_NOISE = 0.001
"""Smallest LiDAR noise on each axis, metres; search distances are derived from it."""

SpecificationT = TypeVar("SpecificationT", ScannerSpecification, PosSpecification)


@dataclass(frozen=True)
class Sensor(Generic[SpecificationT]):
    """Sensor of the library.

    Attributes
    ----------
    name : name of its file, used on the command line
    is_user_defined : whether the user added it
    """

    name: str
    figures: SpecificationT
    is_user_defined: bool


@dataclass(frozen=True)
class SensorLibrary:
    """All sensors in the order of their titles, and errors in the files of the user."""

    scanners: tuple[Sensor[ScannerSpecification], ...]
    pos: tuple[Sensor[PosSpecification], ...]
    messages: tuple[Message, ...] = ()

    def scanner(self, name: str) -> ScannerSpecification:
        """Scanner with a given name.

        Raises
        ------
        InputError
            If there is none.
        """
        return _find_sensor("sensor.no_scanner", self.scanners, name).figures

    def find_pos(self, word: str) -> tuple[PosSpecification, PosAccuracy]:
        """POS with a given name, and its sigmas for a GNSS solution: ``apogee:ppk``.

        Raises
        ------
        InputError
            If there is none, or the solution is not given and there are several.
        """
        name, _, solution = word.partition(":")
        figures = _find_sensor("sensor.no_pos", self.pos, name).figures
        states = {state.name: state for state in figures.states}
        if not solution and len(states) == 1:
            return figures, figures.states[0]
        if solution not in states:
            raise InputError(
                error("sensor.no_solution", name=word, known=[f"{name}:{each}" for each in states])
            )
        return figures, states[solution]


def user_sensors_folder() -> Path:
    """Folder of the sensors that the user has defined."""
    return user_folder() / "sensors"


def read_library(folder: Path) -> SensorLibrary:
    """Read the sensors supplied with the program and those in a folder of the user.

    Parameters
    ----------
    folder : Path
        Folder with subfolders ``scanners`` and ``pos``; it need not exist.
    """
    messages: list[Message] = []
    return SensorLibrary(
        _read_sensors(
            "scanners", folder, lambda path: read_scanner_specification(path, whole=False),
            read_scanner_specification, messages,
        ),
        _read_sensors("pos", folder, read_pos_specification, read_pos_specification, messages),
        tuple(messages),
    )  # fmt: skip


def _read_sensors(
    kind: str, folder: Path, supplied: Callable[[Path], SpecificationT],
    read: Callable[[Path], SpecificationT], messages: list[Message],
) -> tuple[Sensor[SpecificationT], ...]:  # fmt: skip
    found = {
        path.stem: Sensor(path.stem, supplied(path), is_user_defined=False)
        for path in resource_path(kind).glob("*.toml")
        if path.stem not in SIMULATED_SCANNERS
    }
    for path in sorted((folder / kind).glob("*.toml")):
        try:
            found[path.stem] = Sensor(path.stem, read(path), is_user_defined=True)
        except InputError as failure:
            messages.append(replace(as_message(failure.reason), level=Level.WARNING))
    return tuple(sorted(found.values(), key=lambda each: each.figures.title.casefold()))


def _find_sensor(
    refusal: str, sensors: Iterable[Sensor[SpecificationT]], name: str
) -> Sensor[SpecificationT]:
    known = {sensor.name: sensor for sensor in sensors}
    if name not in known:
        raise InputError(error(refusal, name=name, known=tuple(known)))
    return known[name]


# -- sensors of the user ------------------------------------------------------------------------


def store_sensor(folder: Path, figures: SensorSpecification, name: str = "") -> str:
    """Write a sensor of the user into the library, and return its name.

    Parameters
    ----------
    name : str
        Name of the user's sensor to replace; empty for a new one.

    Raises
    ------
    InputError
        If the values are not valid, the name is taken, or the file cannot be written.
    """
    require_storable(folder, figures, name)
    word = name or _file_stem(figures.title)
    write_specification(_sensor_path(folder, figures, word), figures)
    return word


def require_storable(folder: Path, figures: SensorSpecification, name: str = "") -> None:
    """Refuse a specification that cannot be stored in the library.

    Raises
    ------
    InputError
        If sigmas, title or source are missing, a text is not printable or too long, or the title is
        already used.
    """
    sources = [figures] if isinstance(figures, ScannerSpecification) else figures.states
    if not sources:
        raise InputError(error("sensor.no_sigmas"))
    if not _file_stem(figures.title):
        raise InputError(error("sensor.no_title"))
    if not all(each.source.strip() for each in sources):
        raise InputError(error("sensor.no_source"))
    for text in (figures.title, *(each.source for each in sources)):
        if len(text) > MAX_TEXT_LENGTH or not text.isprintable():
            raise InputError(error("sensor.long_text", limit=MAX_TEXT_LENGTH))
    known = read_library(folder)
    same = known.scanners if isinstance(figures, ScannerSpecification) else known.pos
    if not name and _file_stem(figures.title) in {sensor.name for sensor in same}:
        raise InputError(error("sensor.title_taken", title=figures.title))


def remove_sensor(
    folder: Path, sensor: Sensor[ScannerSpecification] | Sensor[PosSpecification]
) -> None:
    """Remove a sensor of the user from the library.

    Raises
    ------
    InputError
        If it is supplied with the program, or cannot be removed.
    """
    if not sensor.is_user_defined:
        raise InputError(error("sensor.supplied", title=sensor.figures.title))
    path = _sensor_path(folder, sensor.figures, sensor.name)
    try:
        path.unlink()
    except OSError as failure:
        raise InputError(
            error("sensor.not_removed", file=str(path), reason=system_reason(failure))
        ) from failure


def _sensor_path(folder: Path, figures: SensorSpecification, name: str) -> Path:
    kind = "scanners" if isinstance(figures, ScannerSpecification) else "pos"
    return folder / kind / f"{name}.toml"


def _file_stem(title: str) -> str:
    return re.sub(r"[\W_]+", "-", title.casefold()).strip("-")


# -- settings from a sensor ---------------------------------------------------------------------


def noise_settings(scanner: ScannerSpecification) -> dict[str, Any]:
    """LiDAR noise in range and in beam direction, by the names of `Settings`."""
    return {
        "lidar_sigma": max(scanner.range_sigma, MIN_LIDAR_NOISE),
        "lidar_sigma_xyz": None,
        "lidar_beam_sigma": (scanner.range_sigma, scanner.angle_sigma_deg),
        "beam_divergence_mrad": scanner.divergence_mrad or None,
    }


def sigma_settings(state: PosAccuracy) -> dict[str, Any]:
    """Sigmas of the POS for use without an accuracy file, by the names of `Settings`."""
    return {
        "position_sigma": state.position_sigma,
        "attitude_sigma_deg": state.attitude_sigma_deg,
    }


def source_text(figures: ScannerSpecification | PosAccuracy) -> str:
    """Source of a specification in the present language, marked if it is not verified."""
    source = gettext(figures.source)
    return gettext(UNVERIFIED_SOURCE_TEXT, source=source) if figures.unverified else source
