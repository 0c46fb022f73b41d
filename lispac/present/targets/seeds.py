"""Targets found from a list of seeds, as rows and table."""

from dataclasses import dataclass

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.tables import COUNT, MILLIMETRES, Column, Format, Table
from lispac.project import Role, Target

SEED_METRES = Format("m", 3)
"""Format of the coordinates of a seed."""
ROLE_TEXTS: dict[Role, str] = {"target": N_("Target"), "validation": N_("Validation plane")}


@dataclass(frozen=True)
class SeedOutcomeRow:
    """Result of a seed; the numbers are None if no target was found.

    Attributes
    ----------
    row : row of the seed in its file
    lines : number of lines on which the target was found, of all lines, as text
    rms_m : largest RMS of a sighting
    notes : warning or reason of the failure, and the lines without the target with the reasons
    """

    row: int
    name: str
    role: Role
    lines: str
    points: int | None
    rms_m: float | None
    notes: tuple[str, ...]


SEED_OUTCOMES_TABLE = Table[SeedOutcomeRow](
    N_("Targets found"),
    (
        Column("row", N_("Row"), COUNT),
        Column("name", N_("Name")),
        Column("role", N_("Role"), texts=ROLE_TEXTS),
        Column("lines", N_("Lines")),
        Column("points", N_("Points"), COUNT),
        Column("rms_m", N_("RMS"), MILLIMETRES),
    ),
)


def seed_outcome_row(
    row: int, name: str, role: Role, target: Target | None, message: Message | None, lines: int
) -> SeedOutcomeRow:
    """Row in the language in use; ``lines`` is the number of lines of the project."""
    notes = () if message is None else (message_text(message),)
    if target is None:
        return SeedOutcomeRow(row, name, role, gettext("none"), None, None, notes)
    missing = (
        gettext("Not found on line {line}: {reason}", line=line, reason=message_text(reason))
        for line, reason in target.missing.items()
    )
    found = target.sightings
    return SeedOutcomeRow(
        row, name, role, gettext("{count:n} of {total:n}", count=len(found), total=lines),
        sum(len(sighting.indices) for sighting in found),
        max(sighting.rms for sighting in found),
        (*notes, *missing),
    )  # fmt: skip
