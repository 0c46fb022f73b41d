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
}
