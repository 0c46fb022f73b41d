"""Files with a boresight and a lever arm for other programs."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.config.installation_files import (
    kluster_vessel,
    pdal_georeference,
    pdal_transformation,
    write_json_file,
    write_text_file,
)
from lispac.io.files import require_file
from lispac.io.format_types import IMPOSSIBLE
from lispac.io.trajectory.sbet import SbetOptions
from lispac.io.trajectory.sbet_formats import SBET_FORMAT, detect_sbet
from lispac.language import N_, LazyText, gettext_lazy, to_plain_text
from lispac.message_texts import message_text
from lispac.messages import Message, error, note
from lispac.present.output.conventions import ConventionValues
from lispac.present.output.installation_text import installation_text
from lispac.project import Project
from lispac.survey.conventions.conversion import ConventionSetup
from lispac.survey.conventions.mounting_replacement import MountingReplacement, replace_mounting
from lispac.survey.conventions.mounting_texts import UNCORRELATED_WARNING, offsets_note
from lispac.survey.conventions.systems import Convention, convention_of_key
from lispac.workflow.output.georeferencing import require_no_overwrite


@dataclass(frozen=True)
class InstallationFormat:
    """A file that a program reads, or the text of the values to enter.

    Attributes
    ----------
    ending : lower case, with the dot
    name : name in the file dialogue
    use : note on what the values in the file apply to; None for the text
    with_trajectory : whether the file names the trajectory
    """

    ending: str
    name: LazyText
    use: Message | None = None
    with_trajectory: bool = False


TEXT_FORMAT = InstallationFormat(".txt", gettext_lazy(N_("Values to enter, as text")))
_PROGRAM_FORMATS: dict[str, tuple[InstallationFormat, ...]] = {
    "pdal": (
        InstallationFormat(
            ".json", gettext_lazy(N_("PDAL pipeline, scanner to body")),
            note("convention.pdal_transformation"),
        ),
        InstallationFormat(
            ".json", gettext_lazy(N_("PDAL pipeline, scanner to earth-centred coordinates")),
            note("convention.pdal_georeference"), True,
        ),
    ),
    "kluster": (
        InstallationFormat(
            ".kfc", gettext_lazy(N_("Kluster vessel")), note("convention.kluster_vessel")
        ),
    ),
}  # fmt: skip
"""Files that the programs read, by the key of the convention, apart from the text."""


def installation_formats(
    convention: Convention, *, with_trajectory: bool
) -> tuple[InstallationFormat, ...]:
    """Files that can be written for a program, those that it reads first.

    Parameters
    ----------
    with_trajectory : bool
        Whether a trajectory is known that the program may read.
    """
    formats = _PROGRAM_FORMATS.get(convention.key, ())
    return (*(each for each in formats if with_trajectory or not each.with_trajectory), TEXT_FORMAT)


def format_of_path(
    path: Path, convention: Convention, *, with_trajectory: bool
) -> InstallationFormat:
    """Format of a file by its ending, and by whether a trajectory is given for it.

    Raises
    ------
    InputError
        If there is no such file for the program.
    """
    formats = installation_formats(convention, with_trajectory=True)
    for each in formats:
        if each.ending == path.suffix.lower() and each.with_trajectory == with_trajectory:
            return each
    if with_trajectory and not any(each.with_trajectory for each in formats):
        raise InputError(error("convention.no_trajectory_in_file", program=convention.name))
    endings = tuple(
        dict.fromkeys(each.ending for each in formats if each.with_trajectory == with_trajectory)
    )
    raise InputError(
        error("convention.file_ending", file=path.name, program=convention.name, endings=endings)
    )


def project_replacement(project: Project, key: str) -> tuple[MountingReplacement, Message | None]:
    """Estimated mounting of a project in the convention of a program, and a warning on its sigmas.

    Raises
    ------
    InputError
        If there is no such program.
    ProjectError
        If nothing has been estimated.
    """
    setup = ConventionSetup(convention_of_key(key))
    mounting = project.mounting("estimated")
    assert project.result is not None  # else mounting() has raised an error
    new = replace_mounting(
        setup, mounting, np.asarray(project.result.covariance)[:3, :3], None,
        applied=False, has_lever_arm=True,
    )  # fmt: skip
    return new, None if project.result.model.correlated else UNCORRELATED_WARNING


def write_installation(
    path: Path,
    new: MountingReplacement,
    form: InstallationFormat,
    *,
    trajectory: Path | None = None,
    sigma_warning: Message | None = None,
    project: Project | None = None,
) -> tuple[Message, ...]:
    """Write a boresight and a lever arm into a file for another program.

    Parameters
    ----------
    new : MountingReplacement
        In the convention of the program.
    trajectory : Path, optional
        SBET that a file with a trajectory names.
    project : Project, optional
        Project whose files must not be overwritten.

    Returns
    -------
    tuple of Message
        Notes on the file, which it contains too.

    Raises
    ------
    InputError
        If the program cannot use the values, or the file cannot be written.
    """
    if project is not None:
        require_no_overwrite(project, [path])
    values = ConventionValues.of_mounting(
        new.in_system, new.mounting, has_lever_arm=new.has_lever_arm, warning=sigma_warning
    )
    if form.use is None:
        write_text_file(path, installation_text(values, values.notes))
        return values.notes
    setup = new.in_system.setup
    if values.lever_arm_m is None:
        raise InputError(error("convention.file_needs_lever_arm", program=values.name))
    if not setup.is_as_documented:
        raise InputError(error("convention.file_as_documented", program=values.name))
    if form.with_trajectory:
        trajectory = _require_applanix_sbet(trajectory, values.name)
        # PDAL applies the latency too.
        values = replace(values, offsets_text=offsets_note(replace(new.mounting, latency=0.0)))
    notes = (form.use, note("convention.file_not_tried", program=values.name), *values.notes)
    remarks = [to_plain_text(message_text(each)) for each in notes]
    if form.with_trajectory:
        assert trajectory is not None
        write_json_file(
            path, pdal_georeference(values, trajectory, float(new.mounting.latency), remarks)
        )
    elif setup.convention.key == "pdal":
        write_json_file(path, pdal_transformation(values, remarks))
    else:
        write_json_file(path, kluster_vessel(values, remarks))
    return notes


def _require_applanix_sbet(trajectory: Path | None, program: str) -> Path:
    """Refuse a trajectory that a program that reads an SBET would read in another way.

    Raises
    ------
    InputError
        If it is no SBET, or not in Applanix's conventions.
    """
    if trajectory is None:
        raise InputError(error("convention.file_needs_trajectory", program=program))
    path = require_file(trajectory, "trajectory").resolve()
    if SBET_FORMAT.sniff(path) == IMPOSSIBLE:
        raise InputError(error("convention.not_sbet", file=str(trajectory), program=program))
    found = detect_sbet(path).options
    usual = SbetOptions(axes=found.axes, time=found.time)
    if found != usual:
        raise InputError(error("convention.sbet_signs", file=str(trajectory), program=program))
    return path
