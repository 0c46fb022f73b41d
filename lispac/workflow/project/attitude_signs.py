"""Correction of the signs of roll and pitch with which the trajectory of a project is read."""

from collections.abc import Collection
from dataclasses import replace
from typing import Literal

from lispac.io.formats import format_of
from lispac.messages import Message
from lispac.project import Project
from lispac.workflow.importing.file_reading import DEFAULT_FORMATS

SignedAngle = Literal["roll", "pitch"]
SIGNED_ANGLES: tuple[SignedAngle, ...] = ("roll", "pitch")
"""Angles whose sign is a reading option of trajectories; the option has the name of the angle."""
_DETECTION_CODES = {"sbet.zero_rates", "sbet.signs_not_checked", "sbet.other_signs"}
_SIGN_CODES: dict[SignedAngle, set[str]] = {
    "roll": {"trajectory.roll_starboard_down", "trajectory.roll_port_down"} | _DETECTION_CODES,
    "pitch": {"trajectory.pitch_bow_up", "trajectory.pitch_bow_down"} | _DETECTION_CODES,
}
"""Codes of the warnings of the import about the sign of an angle."""


def reversible_angles(project: Project) -> tuple[SignedAngle, ...]:
    """Angles whose sign `with_reversed_signs` can change.

    None if a line is georeferenced: its points were recovered with the present signs, and the
    picked points would be others. None for a format without signs as reading options.
    """
    if any(dict(line.reading.options).get("frame") == "georeferenced" for line in project.lines):
        return ()
    options = _sign_options(project)
    return tuple(angle for angle in SIGNED_ANGLES if len(options.get(angle, ())) == 2)


def with_reversed_signs(project: Project, angles: Collection[SignedAngle]) -> Project:
    """Read the trajectory with the opposite signs of some angles.

    Targets and their points are kept. The results, which depend on the signs, are removed, as are
    the warnings of the import about these signs: they are now specified by the user.

    Parameters
    ----------
    angles : some of `reversible_angles`
    """
    if not angles:
        return project
    reading, choices = project.trajectory_reading, _sign_options(project)
    options = dict(reading.options)
    for angle in angles:
        usual, other = choices[angle]
        options[angle] = usual if options.get(angle, usual) == other else other
    obsolete = set[str]().union(*(_SIGN_CODES[angle] for angle in angles))

    def remaining(messages: tuple[Message, ...]) -> tuple[Message, ...]:
        return tuple(each for each in messages if each.code not in obsolete)

    return replace(
        project.without_results(),
        trajectory_reading=replace(
            reading, format=_format_key(project), options=tuple(options.items())
        ),
        reading_warnings=remaining(project.reading_warnings),
        data_messages=remaining(project.data_messages),
    )


def _sign_options(project: Project) -> dict[str, tuple[str, ...]]:
    """Values of the reading options of the trajectory for signs, the default first."""
    chosen = format_of(_format_key(project))
    return {
        option.name: (option.default, *(each for each in option.choices if each != option.default))
        for option in chosen.options
        if option.name in SIGNED_ANGLES
    }


def _format_key(project: Project) -> str:
    """Format of the trajectory; options are not used without one."""
    return project.trajectory_reading.format or DEFAULT_FORMATS["trajectory"]
