"""Texts of messages about a boresight in the convention of another program."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    "convention.check_first": N_(
        "These angles are valid only if the assumption is correct. Check the assumption on one "
        "line over a known surface before use."
    ),
    "convention.uncorrelated": N_(
        "The POS errors were assumed to be uncorrelated, so these standard deviations are several "
        "times too small. Estimate the boresight again with correlated POS errors."
    ),
    "convention.offsets": N_(
        "The boresight angles are valid only together with {offsets:names}. Apply these "
        "corrections in the other program too."
    ),
    # -- angles ------------------------------------------------------------------------------------
    "convention.gimbal_lock": N_(
        "The {middle} is {angle:deg.0}°, so {first} and {last} rotate about the same axis "
        "(gimbal lock). {last} is set to zero, {first} contains both rotations, and neither has a "
        "standard deviation."
    ),
    "convention.near_gimbal_lock": N_(
        "The {middle} is within 10° of 90°, so {first} and {last} are very sensitive to "
        "small rotations. Enter the angles with all digits."
    ),
    # -- lever arm ---------------------------------------------------------------------------------
    "convention.lever_arm_replaced": N_(
        "The lever arm entered here replaces the lever arm of the current matrix."
    ),
    "convention.lever_arm_kept": N_(
        "No lever arm was entered, so the lever arm of the current matrix is used unchanged."
    ),
    "convention.lever_arm_added": N_(
        "The lines are assumed to be rotated and shifted by the current 4x4 matrix, so the lever "
        "arm entered here is added to that of the matrix. If the lines were only rotated, enter "
        "the 3x3 matrix alone."
    ),
    "convention.lever_arm_turned": N_(
        "The lines are assumed to be rotated and shifted by the current 4x4 matrix, so the new "
        "lever arm is that of the matrix, rotated by the estimated boresight. If the lines were "
        "only rotated, enter the 3x3 matrix alone and the lever arm of the lines."
    ),
    # -- files for other programs ------------------------------------------------------------------
    "convention.pdal_transformation": N_(
        "The matrix applies to points in the frame of the scanner and gives points in the body "
        "frame of the POS (X forward, Y starboard, Z down), in metres. Do not apply it to "
        "georeferenced points: no constant matrix corrects the boresight of these."
    ),
    "convention.pdal_georeference": N_(
        "The pipeline applies to points in the frame of the scanner whose times have the time base "
        "of the trajectory, and gives earth-centred coordinates. Specify input and output in "
        "PDAL, and add filters.reprojection for a map."
    ),
    "convention.kluster_vessel": N_(
        "The vessel contains one system, LiDAR, with the POS centre as reference point; the "
        "scanner has the values of transmitter and receiver. Waterline and opening angles are "
        "zero: set them in Kluster."
    ),
    "convention.file_not_tried": N_(
        "The file follows the source code of {program}, but has not been opened in that program "
        "(not verified). Check one line over a known surface before use."
    ),
    "convention.file_ending": N_(
        "{file}: for {program}, the file extension must be {endings:choices}. Use one of these."
    ),
    "convention.file_needs_lever_arm": N_(
        "A file for {program} must contain the lever arm. Give the lever arm too."
    ),
    "convention.file_as_documented": N_(
        "A file for {program} can only be written with its documented axes. Use these axes, or "
        "write the values as text."
    ),
    "convention.file_needs_trajectory": N_(
        "This file for {program} names the trajectory. Give an SBET."
    ),
    "convention.no_trajectory_in_file": N_(
        "A file for {program} does not name a trajectory. Omit the trajectory."
    ),
    "convention.not_sbet": N_(
        "{file}: {program} reads trajectories in SBET only. Export the trajectory as SBET."
    ),
    "convention.sbet_signs": N_(
        "{file}: the signs, angles or byte order of this SBET differ from Applanix's convention, "
        "which {program} assumes. Export the trajectory as SBET."
    ),
}
