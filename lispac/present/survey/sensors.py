"""Sensors of the library, as rows and tables."""

from collections.abc import Sequence
from dataclasses import dataclass

from lispac.language import N_, gettext
from lispac.present.tables import DEGREES, MILLIMETRES, Column, Format, Table


@dataclass(frozen=True)
class ScannerRow:
    """A scanner of the library; standard deviations of 1 sigma."""

    name: str
    range_sigma_m: float
    angle_sigma_deg: float
    divergence_mrad: float
    title: str
    source: str
    is_user_defined: bool


@dataclass(frozen=True)
class PosRow:
    """A POS of the library with one GNSS solution, which its name contains.

    The standard deviations of 1 sigma are north, east and down, and roll, pitch and heading.
    """

    name: str
    position_sigma_m: Sequence[float]
    attitude_sigma_deg: Sequence[float]
    title: str
    source: str
    is_user_defined: bool


def title_with_mark(row: ScannerRow | PosRow) -> str:
    """Title of a sensor, marked if the user defined it."""
    if row.is_user_defined:
        return gettext("{title} (user-defined)", title=row.title)
    return row.title


def _list_text(values: Sequence[float], decimals: int) -> str:
    return " ".join(Format("", decimals).text(value) for value in values)


SCANNERS_TABLE = Table[ScannerRow](
    N_("Scanners (1 sigma)"),
    (
        Column("name", N_("Name")),
        Column("range_sigma_m", N_("Range"), MILLIMETRES),
        Column("angle_sigma_deg", N_("Direction"), DEGREES),
        Column("divergence_mrad", N_("Divergence (mrad)"), Format("", 2)),
        Column(title_with_mark, N_("Title")),
        Column("source", N_("Source"), is_wide=True),
    ),
)
POS_TABLE = Table[PosRow](
    N_("INS/GNSS (1 sigma)"),
    (
        Column("name", N_("Name")),
        Column(lambda row: _list_text(row.position_sigma_m, 3), N_("North, east, down (m)")),
        Column(lambda row: _list_text(row.attitude_sigma_deg, 4), N_("Roll, pitch, heading (deg)")),
        Column(title_with_mark, N_("Title")),
        Column("source", N_("Source"), is_wide=True),
    ),
)
