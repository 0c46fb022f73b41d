"""Texts of warnings about an open project: its data, mounting, picks and result."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    "mounting.lever_arm_zero": N_(
        "The lever arm is zero, so the optical centre of the scanner is assumed at the POS centre. "
        "Enter the measured lever arm."
    ),
    "mounting.lever_arm_below": N_(
        "With this lever arm the scanner is {below:m.2} m below the POS centre, but on most "
        "vessels it is above. Check the sign of Z, which is positive upwards."
    ),
    "mounting.lever_arm_long": N_(
        "The lever arm is {length:m.1} m long, longer than on most vessels. Check that it is in "
        "metres."
    ),
    "project.trajectory_gaps": Plural(
        "The trajectory has {count:n} gap longer than {limit:s} s; it lasts {longest:s.1} s. "
        "Points recorded in the gap cannot be used.",
        "The trajectory has {count:n} gaps longer than {limit:s} s; the longest lasts "
        "{longest:s.1} s. Points recorded in the gaps cannot be used.",
    ),
    "project.import_note": N_("Import: {reason}"),
    "project.storage": N_("Saving: {reason}"),
    "project.not_found_on_line": N_("{target} was not found on {line}. {reason}"),
    "project.not_found_on_lines": N_("{target} was not found on {lines:names}. {reason}"),
    "project.doubtful_sighting": N_(
        "{target} on {line} is a doubtful sighting. {reasons:sentences}"
    ),
    "project.doubtful_sightings": N_(
        "Sightings of {target} on {lines:names} are doubtful, most of all on {line}. "
        "{reasons:sentences}"
    ),
    "project.poor_sighting": N_("{target} on {line} is a poor sighting. {reasons:sentences}"),
    "project.single_target": N_(
        "With a single target, errors in the data cannot be detected. Pick another target with a "
        "different orientation."
    ),
    "project.one_facing": N_(
        "The targets are nearly parallel, and Estimate does not accept this. Pick another target "
        "with a different orientation."
    ),
    "project.refused": N_("The boresight could not be estimated. {reason}"),
    "project.out_of_date": N_(
        "The boresight is out of date because data or settings were changed. Run Estimate again."
    ),
}
