"""Texts of warnings about an open project: its data, mounting, picks and result."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    "mounting.lever_arm_zero": N_(
        "The lever arm is zero, as if the optical centre of the scanner were at the POS centre. "
        "Enter the measured lever arm."
    ),
    "mounting.lever_arm_below": N_(
        "The lever arm puts the scanner {below:m.2} m below the POS centre, but on most vessels it "
        "is above. Check the sign of Z, which is positive upwards."
    ),
    "mounting.lever_arm_long": N_(
        "The lever arm is {length:m.1} m long, more than on most vessels. Check its unit: it is in "
        "metres."
    ),
    "project.trajectory_gaps": Plural(
        "The trajectory has {count:n} gap longer than {limit:s} s, of {longest:s.1} s. Points in "
        "the gap cannot be used.",
        "The trajectory has {count:n} gaps longer than {limit:s} s, the longest {longest:s.1} s. "
        "Points in gaps cannot be used.",
    ),
    "project.import_note": N_("Import: {reason}"),
    "project.storage": N_("Saving: {reason}"),
    "project.not_found_on_line": N_("{target} on {line}: {reason}"),
    "project.doubtful_sighting": N_("{target} on {line}: doubtful. {reasons:sentences}"),
    "project.poor_sighting": N_("{target} on {line}: poor. {reasons:sentences}"),
    "project.single_target": N_(
        "Nothing checks a single target. Pick another one with another orientation."
    ),
    "project.one_facing": N_(
        "The targets are nearly parallel, and the estimate does not accept this. Pick another one "
        "with another orientation."
    ),
    "project.refused": N_("Not estimated: {reason}"),
    "project.out_of_date": N_(
        "The boresight is out of date because the data were edited. Run Estimate again."
    ),
}
