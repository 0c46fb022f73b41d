"""Texts of messages about a boresight in the convention of another program."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    "convention.check_first": N_(
        "These angles are right only if the assumption is. Check it on one line over a known "
        "surface before use."
    ),
    "convention.uncorrelated": N_(
        "The POS errors were assumed uncorrelated: these sigmas are several times too small."
    ),
    "convention.offsets": N_(
        "The boresight holds together with {offsets:names}. Apply that there too."
    ),
    # -- angles ------------------------------------------------------------------------------------
    "convention.gimbal_lock": N_(
        "The {middle} is at {angle:deg.0} deg, where {first} and {last} rotate about the same "
        "axis: {last} is set to zero and {first} contains both. Sigmas have no meaning there."
    ),
    "convention.near_gimbal_lock": N_(
        "The {middle} is within 10 deg of 90 deg: {first} and {last} change much with a small "
        "rotation. Type all digits."
    ),
    # -- lever arm ---------------------------------------------------------------------------------
    "convention.lever_arm_replaced": N_(
        "The lever arm given here replaces that of the present matrix."
    ),
    "convention.lever_arm_kept": N_(
        "The lever arm is that of the present matrix, unchanged: none was given here."
    ),
    "convention.lever_arm_added": N_(
        "The lines are assumed rotated and shifted by the present 4x4 matrix, so its lever arm is "
        "part of the new one: the one given here is added to it. If they were only rotated, give "
        "the 3x3 matrix alone."
    ),
    "convention.lever_arm_turned": N_(
        "The lines are assumed rotated and shifted by the present 4x4 matrix, so its lever arm, "
        "rotated by what was found, is the new one. If they were only rotated, give the 3x3 matrix "
        "alone and the lever arm of the lines."
    ),
}
