"""Results of many projects, as values and table."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from lispac.adjustment.result import ANGLES
from lispac.former_names import accept_script_names
from lispac.message_texts import english_text
from lispac.messages import Message
from lispac.present.angles import Angles
from lispac.present.calibration.calibrations import ESTIMATE_COLUMNS
from lispac.present.tables import MILLIMETRES, YES_NO_TEXTS, Column, Table, ratio

Verdict = Literal["good", "notes", "warnings", "refused"]


@accept_script_names
@dataclass(frozen=True)
class BatchRow:
    """Result of one project in the table.

    Attributes
    ----------
    folder : Path
    name, vessel, dates : str
        Empty if not known.
    verdict : {"good", "notes", "warnings", "refused"}
        Highest level of the messages in the report; ``warnings`` also stands for errors. A project
        that cannot be calibrated is refused.
    messages : tuple of Message
        Messages of the report, after the reason why a validation was not possible; for a refused
        project, the reason.
    boresight_deg, sigma_deg : Angles or None
    sigma_0 : float or None, no unit
        A posteriori sigma_0; 1 if the errors agree with the given sigmas.
    chi_square_passed : bool or None
        Result of the chi-square test of the variance factor.
    rms_before_m, rms_after_m : float or None, metres
        RMS distances between the lines on all validation planes.
    """

    folder: Path
    name: str
    verdict: Verdict
    messages: tuple[Message, ...]
    vessel: str = ""
    dates: str = ""
    boresight_deg: Angles | None = None
    sigma_deg: Angles | None = None
    sigma_0: float | None = None
    chi_square_passed: bool | None = None
    rms_before_m: float | None = None
    rms_after_m: float | None = None


BATCH_TABLE = Table[BatchRow](
    "Calibrations",
    (
        Column("name", "Project"),
        *ESTIMATE_COLUMNS,
        Column("sigma_0", "Sigma 0", ratio(2)),
        Column("rms_before_m", "RMS before", MILLIMETRES),
        Column("rms_after_m", "RMS after", MILLIMETRES),
        Column("verdict", "Verdict"),
    ),
)
BATCH_CSV = Table[BatchRow](
    "batch",
    (
        Column("folder", "folder"),
        Column("name", "project"),
        Column("vessel", "vessel"),
        Column("dates", "dates"),
        Column("verdict", "verdict"),
        *(Column(f"boresight_deg.{name}", f"{name}_deg") for name in ANGLES),
        *(Column(f"sigma_deg.{name}", f"sigma_{name}_deg") for name in ANGLES),
        Column("sigma_0", "sigma_0"),
        Column("chi_square_passed", "chi_square_passed", texts=YES_NO_TEXTS),
        Column("rms_before_m", "rms_before_m"),
        Column("rms_after_m", "rms_after_m"),
        Column(lambda row: " | ".join(map(english_text, row.messages)), "messages"),
    ),
)
"""Table of all projects as CSV with full precision; the titles are keys."""
