"""Specifications of a scanner or a POS in TOML, with their source."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from lispac.errors import InputError
from lispac.io.config.toml_table import TomlTable, toml_string
from lispac.io.files import atomic_write
from lispac.messages import error
from lispac.project import Triple

GNSS_SOLUTIONS = ("rtk", "ppk", "degraded")
"""GNSS solutions for which the accuracies of a POS are specified."""


@dataclass(frozen=True)
class ScannerSpecification:
    """Precision of a scanner.

    Attributes
    ----------
    range_sigma : metres
    angle_sigma_deg : degrees, of the beam direction, in both directions across the beam
    divergence_mrad : milliradians, full angle
    source : origin of the figures, for example a data sheet
    unverified : whether they were not compared with the source
    """

    title: str
    range_sigma: float
    angle_sigma_deg: float
    divergence_mrad: float
    source: str
    unverified: bool = False


@dataclass(frozen=True)
class PosAccuracy:
    """Precision of a POS with one GNSS solution.

    Attributes
    ----------
    name : one of `GNSS_SOLUTIONS`
    position_sigma : metres, north, east, down
    attitude_sigma_deg : degrees, roll, pitch, heading
    source : origin of the figures, for example a data sheet
    unverified : whether they were not compared with the source
    """

    name: str
    position_sigma: Triple
    attitude_sigma_deg: Triple
    source: str
    unverified: bool = False


@dataclass(frozen=True)
class PosSpecification:
    """A POS with its precision for each GNSS solution."""

    title: str
    states: tuple[PosAccuracy, ...]


SensorSpecification = ScannerSpecification | PosSpecification


def read_scanner_specification(path: Path, *, whole: bool = True) -> ScannerSpecification:
    """Read the figures of a scanner.

    Parameters
    ----------
    whole : bool
        Whether unknown keys are refused; a scanner file of the simulator has more keys.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "scanner") as table:
        found = ScannerSpecification(
            table.text("title"),
            table.number("range_sigma_m", over=0, high=10),
            table.number("angle_sigma_deg", over=0, high=10),
            table.number("divergence_mrad", low=0, high=100),
            table.text("source"),
            table.boolean("unverified", False),
        )
        if not whole:
            table.ignore_rest()
        return found


def read_pos_specification(path: Path) -> PosSpecification:
    """Read the figures of a POS.

    Raises
    ------
    InputError
        If the content is not valid; the message names the file, the key and the action.
    """
    with TomlTable.read(path, "POS") as table:
        title = table.text("title")
        states = []
        for name in (each for each in GNSS_SOLUTIONS if each in table):
            with table.table(name) as part:
                states.append(
                    PosAccuracy(
                        name,
                        _read_sigmas(part, "position_m", 100),
                        _read_sigmas(part, "attitude_deg", 90),
                        part.text("source"),
                        part.boolean("unverified", False),
                    )
                )
        if not states:
            raise InputError(error("sensor.no_accuracies", file=str(path), tables=GNSS_SOLUTIONS))
        return PosSpecification(title, tuple(states))


def _read_sigmas(table: TomlTable, key: str, high: float) -> Triple:
    a, b, c = table.numbers(key, 3, low=0, high=high)
    if min(a, b, c) <= 0:
        raise table.refuse(key, "sensor.zero_sigma")
    return a, b, c


def write_specification(path: Path, figures: SensorSpecification) -> None:
    """Write a specification so that it reads back unchanged.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    rows = [f"title = {toml_string(figures.title)}"]
    if isinstance(figures, ScannerSpecification):
        rows += [
            f"range_sigma_m = {figures.range_sigma!r}",
            f"angle_sigma_deg = {figures.angle_sigma_deg!r}",
            f"divergence_mrad = {figures.divergence_mrad!r}",
            *_origin_lines(figures),
        ]
    else:
        for state in figures.states:
            rows += [
                "",
                f"[{state.name}]",
                f"position_m = {_numbers_text(state.position_sigma)}",
                f"attitude_deg = {_numbers_text(state.attitude_sigma_deg)}",
                *_origin_lines(state),
            ]
    with atomic_write(path) as draft:
        draft.write_text("\n".join([*rows, ""]), encoding="utf-8")


def _origin_lines(figures: ScannerSpecification | PosAccuracy) -> list[str]:
    return [
        f"source = {toml_string(figures.source)}",
        f"unverified = {str(figures.unverified).lower()}",
    ]


def _numbers_text(values: Sequence[float]) -> str:
    return f"[{', '.join(repr(float(value)) for value in values)}]"
