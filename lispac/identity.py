"""Identity of a calibration for the report: person, date, equipment.

All values are texts typed by the user, empty if unknown. No computation uses them.
"""

from dataclasses import asdict, dataclass, fields, replace

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
    scanner, pos : maker and model of the LiDAR and of the INS/GNSS
    dates : day or days of the survey
    lever_arm_origin : source of the lever arm, such as a measurement or a drawing
    """

    surveyor: str = ""
    company: str = ""
    vessel: str = ""
    site: str = ""
    scanner: str = ""
    scanner_serial: str = ""
    pos: str = ""
    pos_serial: str = ""
    dates: str = ""
    lever_arm_origin: str = ""
    remarks: str = ""

    def changed(self, **texts: str) -> "Identity":
        """Copy with the given texts, without leading and trailing blanks.

        Raises
        ------
        InputError
            If a text cannot be printed in a report.
        """
        return replace(self, **{name: _clean_text(name, text) for name, text in texts.items()})

    def require_sound(self) -> None:
        """Refuse texts that cannot be printed in a report.

        Raises
        ------
        InputError
            If a text has control characters or several lines where one is allowed, or is too long.
        """
        self.changed(**asdict(self))


EMPTY_IDENTITY = Identity()
FIELD_NAMES = tuple(field.name for field in fields(Identity))

FIELD_LABELS = {
    "surveyor": N_("Surveyor"),
    "company": N_("Company"),
    "vessel": N_("Vessel"),
    "site": N_("Site"),
    "scanner": N_("Scanner"),
    "scanner_serial": N_("Scanner serial number"),
    "pos": N_("INS/GNSS"),
    "pos_serial": N_("INS/GNSS serial number"),
    "dates": N_("Survey dates"),
    "lever_arm_origin": N_("Origin of the lever arm"),
    "remarks": N_("Remarks"),
}
"""Labels of the fields."""

FIELD_HINTS = {
    "surveyor": "person responsible for the calibration",
    "company": "company of the surveyor",
    "vessel": "name of the vessel",
    "site": "name of the survey site",
    "scanner": "maker and model of the LiDAR",
    "scanner_serial": "serial number of the LiDAR",
    "pos": "maker and model of the INS/GNSS",
    "pos_serial": "serial number of the INS/GNSS",
    "dates": "dates of the survey, e.g. 2026-03-04",
    "lever_arm_origin": "origin of the lever arm, e.g. total station survey in dock, 2026-03-04",
    "remarks": "other information for the reader of the report",
}
"""Expected content of each field."""


def _clean_text(name: str, text: str) -> str:
    longest = MAX_FIELD_LENGTH * (10 if name == "remarks" else 1)
    field = note(f"identity_field.{name}")
    return cleaned_text(field, text, longest=longest, several_lines=name == "remarks")


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
