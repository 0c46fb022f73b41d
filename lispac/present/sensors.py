"""Sensors of the library, as rows and tables."""

from collections.abc import Sequence
from dataclasses import dataclass

from lispac.io.config.sensor_file import PosSpecification, ScannerSpecification
from lispac.language import N_, gettext
from lispac.present.tables import DEGREES, MILLIMETRES, Column, Format, Table
from lispac.workflow.planning.sensors import Sensor, source_text

USER_DEFINED_TEXT = N_("{title} (user-defined)")


@dataclass(frozen=True)
class ScannerRow:
    """A scanner of the library; standard deviations of 1 sigma."""

    name: str
    range_sigma_m: float
    angle_sigma_deg: float
    divergence_mrad: float
    title: str
    source: str


@dataclass(frozen=True)
class PosRow:
    """A POS of the library with one GNSS solution; standard deviations of 1 sigma.

    ``name`` also has the name of the solution. The lists are north, east and down, and roll, pitch
    and heading.
    """

    name: str
    position_sigma_m: str
    attitude_sigma_deg: str
    title: str
    source: str


SCANNERS_TABLE = Table[ScannerRow](
    N_("Scanners (1 sigma)"),
    (
        Column("name", N_("Name")),
        Column("range_sigma_m", N_("Range"), MILLIMETRES),
        Column("angle_sigma_deg", N_("Direction"), DEGREES),
        Column("divergence_mrad", N_("Divergence (mrad)"), Format("", 2)),
        Column("title", N_("Title")),
        Column("source", N_("Source"), is_wide=True),
    ),
)
POS_TABLE = Table[PosRow](
    N_("INS/GNSS (1 sigma)"),
    (
        Column("name", N_("Name")),
        Column("position_sigma_m", N_("North, east, down (m)")),
        Column("attitude_sigma_deg", N_("Roll, pitch, heading (deg)")),
        Column("title", N_("Title")),
        Column("source", N_("Source"), is_wide=True),
    ),
)


def scanner_rows(sensors: Sequence[Sensor[ScannerSpecification]]) -> list[ScannerRow]:
    """Scanners in the given order."""
    return [
        ScannerRow(
            each.name, each.figures.range_sigma, each.figures.angle_sigma_deg,
            each.figures.divergence_mrad, _title(each), source_text(each.figures),
        )
        for each in sensors
    ]  # fmt: skip


def pos_rows(sensors: Sequence[Sensor[PosSpecification]]) -> list[PosRow]:
    """INS/GNSS in the given order, with a row for each GNSS solution."""
    metres, degrees = Format("", 3), Format("", 4)
    return [
        PosRow(
            f"{each.name}:{state.name}",
            " ".join(map(metres.text, state.position_sigma)),
            " ".join(map(degrees.text, state.attitude_sigma_deg)),
            _title(each), source_text(state),
        )
        for each in sensors
        for state in each.figures.states
    ]  # fmt: skip


def _title(sensor: Sensor[ScannerSpecification] | Sensor[PosSpecification]) -> str:
    title = sensor.figures.title
    return gettext(USER_DEFINED_TEXT, title=title) if sensor.is_user_defined else title
