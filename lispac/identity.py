"""Identity of a calibration for the report: person, date, equipment.

All values are texts typed by the user, empty if unknown. No computation uses them.
"""

import re
from dataclasses import asdict, dataclass, fields, replace
from datetime import date

from lispac.errors import InputError
from lispac.language import N_
from lispac.messages import Message, error, note

MAX_FIELD_LENGTH = 200
"""Largest number of characters of a field; remarks may be ten times as long."""


@dataclass(frozen=True)
class Identity:
    """Identity of a calibration in the report.

    Attributes
    ----------
    client, contract : who ordered the calibration, and the number of the order or contract
    surveyor, processed_by, checked_by : who surveyed, processed the data, and checked the result
    dates : day or days of the survey
    datum, epoch : reference frame of the trajectory and the epoch of its coordinates
    gnss_base : base station or correction service of the GNSS
    lever_arm_origin : source of the lever arm, such as a measurement or a drawing
    scanner, pos : maker and model of the LiDAR and of the INS/GNSS
    processing_software : program and version that computed the trajectory
    """

    report_number: str = ""
    revision: str = ""
    client: str = ""
    contract: str = ""
    company: str = ""
    surveyor: str = ""
    processed_by: str = ""
    checked_by: str = ""
    vessel: str = ""
    site: str = ""
    dates: str = ""
    datum: str = ""
    epoch: str = ""
    gnss_base: str = ""
    lever_arm_origin: str = ""
    scanner: str = ""
    scanner_serial: str = ""
    pos: str = ""
    pos_serial: str = ""
    processing_software: str = ""
    remarks: str = ""

    def changed(self, **texts: str) -> "Identity":
        """Copy with the given texts, without leading and trailing blanks.

        Raises
        ------
        InputError
            If a text cannot be printed in a report, or contains a date that does not exist.
        """
        for name in DATE_FIELDS:
            _require_dates(note(f"identity_field.{name}"), texts.get(name, ""))
        return replace(self, **{name: _clean_text(name, text) for name, text in texts.items()})

    @property
    def missing(self) -> tuple[str, ...]:
        """Names of the empty fields among `REQUIRED_FIELDS`."""
        return tuple(name for name in REQUIRED_FIELDS if not getattr(self, name))

    def require_sound(self) -> None:
        """Refuse texts that cannot be printed in a report.

        Dates are checked only when they are entered, so that a wrong one closes no project.

        Raises
        ------
        InputError
            If a text has control characters or several lines where one is allowed, or is too long.
        """
        for name, text in asdict(self).items():
            _clean_text(name, text)


EMPTY_IDENTITY = Identity()
_DATE_PATTERN = re.compile(
    r"(?<!\d)(?P<year>\d{4})(?P<sign>[-/.])(?P<month>\d{1,2})(?P=sign)(?P<day>\d[\da-z]?)(?!\d)",
    re.ASCII | re.IGNORECASE,
)
_YEAR_LAST_PATTERN = re.compile(
    r"(?<![\d.])(?P<first>\d{1,2})(?P<sign>[-/.])(?P<second>\d{1,2})(?P=sign)(?P<year>\d{4})(?!\d)",
    re.ASCII,
)
"""Date with the day or the month first, which depends on the country."""
FIELD_NAMES = tuple(field.name for field in fields(Identity))

FIELD_GROUPS: tuple[tuple[str, tuple[str, ...]], ...] = (
    (N_("Report"), ("report_number", "revision")),
    (N_("Client"), ("client", "contract")),
    (N_("Company and persons"), ("company", "surveyor", "processed_by", "checked_by")),
    (
        N_("Survey"),
        ("vessel", "site", "dates", "datum", "epoch", "gnss_base", "lever_arm_origin"),
    ),
    (N_("Equipment"), ("scanner", "scanner_serial", "pos", "pos_serial", "processing_software")),
    (N_("Remarks"), ("remarks",)),
)
"""Titles and fields of the groups of the dialogue, in the order of the fields."""
SIGNATURE_FIELDS = ("surveyor", "processed_by", "checked_by")
"""Fields of the persons who sign the report."""
REQUIRED_FIELDS = (
    "report_number", "client", "surveyor", "processed_by", "checked_by", "vessel", "site", "dates",
    "datum", "epoch", "gnss_base", "scanner", "pos", "processing_software",
)  # fmt: skip
"""Fields without which a signed report does not identify the calibrated system, its reference frame
and its processing, in the order of the fields."""
DATE_FIELDS = ("dates", "epoch")
"""Fields that contain dates."""
TITLE_FIELDS = ("vessel", "site")
"""Fields that are printed below the title of the report, not in its form."""
COMPANY_FIELDS = (
    *SIGNATURE_FIELDS, "datum", "epoch", "gnss_base", "scanner", "scanner_serial", "pos",
    "pos_serial", "processing_software",
)  # fmt: skip
"""Fields that a company usually gives alike in all its reports."""

FIELD_LABELS = {
    "report_number": N_("Report number"),
    "revision": N_("Revision"),
    "client": N_("Client"),
    "contract": N_("Contract"),
    "company": N_("Company"),
    "surveyor": N_("Surveyor"),
    "processed_by": N_("Processed by"),
    "checked_by": N_("Checked by"),
    "vessel": N_("Vessel"),
    "site": N_("Site"),
    "dates": N_("Survey dates"),
    "datum": N_("Datum"),
    "epoch": N_("Epoch"),
    "gnss_base": N_("GNSS base"),
    "lever_arm_origin": N_("Source of the lever arm"),
    "scanner": N_("Scanner"),
    "scanner_serial": N_("Scanner serial number"),
    "pos": N_("INS/GNSS"),
    "pos_serial": N_("INS/GNSS serial number"),
    "processing_software": N_("Processing software"),
    "remarks": N_("Remarks"),
}
"""Labels of the fields."""

FIELD_HINTS = {
    "report_number": "number of the report",
    "revision": "revision of the report",
    "client": "client of the calibration",
    "contract": "number of the contract or order",
    "company": "company of the surveyor",
    "surveyor": "person responsible for the calibration",
    "processed_by": "person who processed the data",
    "checked_by": "person who checked the result",
    "vessel": "name of the vessel",
    "site": "name of the survey site",
    "dates": "dates of the survey, e.g. 2026-03-04",
    "datum": "reference frame of the trajectory, e.g. NAD83(CSRS)v7",
    "epoch": "epoch of the coordinates, e.g. 2010.0",
    "gnss_base": "GNSS base station or correction service",
    "lever_arm_origin": "origin of the lever arm, e.g. total station survey in dock, 2026-03-04",
    "scanner": "maker and model of the LiDAR",
    "scanner_serial": "serial number of the LiDAR",
    "pos": "maker and model of the INS/GNSS",
    "pos_serial": "serial number of the INS/GNSS",
    "processing_software": "program and version that computed the trajectory",
    "remarks": "other information for the reader of the report",
}
"""Expected content of each field."""


def _clean_text(name: str, text: str) -> str:
    longest = MAX_FIELD_LENGTH * (10 if name == "remarks" else 1)
    field = note(f"identity_field.{name}")
    return cleaned_text(field, text, longest=longest, several_lines=name == "remarks")


def _require_dates(field: Message, text: str) -> None:
    """Refuse numbers that are written as a date, such as 2026-13-45 or 31/31/2026, but are none.

    Raises
    ------
    InputError
        If there is such a number.
    """
    for found in _DATE_PATTERN.finditer(text):
        if not _is_date(found["year"], found["month"], found["day"]):
            raise InputError(error("identity.no_date", field=field, text=found[0]))
    for found in _YEAR_LAST_PATTERN.finditer(text):
        year, first, second = found["year"], found["first"], found["second"]
        if not (_is_date(year, first, second) or _is_date(year, second, first)):
            raise InputError(error("identity.no_date", field=field, text=found[0]))


def _is_date(year: str, month: str, day: str) -> bool:
    try:
        date(int(year), int(month), int(day))
    except ValueError:
        return False
    return True


def cleaned_text(field: Message, text: str, *, longest: int, several_lines: bool = False) -> str:
    """Text for a report without leading and trailing blanks.

    Raises
    ------
    InputError
        If the text has control characters or several lines where one is allowed, or is too long.
    """
    tidy = "\n".join(line.strip() for line in text.strip().splitlines())
    if not several_lines and "\n" in tidy:
        raise InputError(error("identity.several_lines", field=field))
    if any(not letter.isprintable() and letter != "\n" for letter in tidy):
        raise InputError(error("identity.not_printable", field=field))
    if len(tidy) > longest:
        raise InputError(error("identity.too_long", field=field, held=len(tidy), longest=longest))
    return tidy
