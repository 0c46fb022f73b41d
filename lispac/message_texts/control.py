"""Texts of messages about surveyed control in the adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    "control.contradicts": N_(
        "Control point {name} lies {shift:mm.1} mm (± {sigma:mm.1} mm, test value w = {w:x.1+}) "
        "from the surface of {target} that all other observations give. Check its coordinates and "
        "its name and that the target was not moved, or exclude the point and estimate again."
    ),
    "control.translated": N_(
        "The control of {source} is displaced as a whole from all other observations: "
        "{components:names}. Check its coordinate system, height reference and epoch, or the lever "
        "arm of the POS, or exclude this control and estimate again."
    ),
    "control.translation_north": N_("{size:mm.1+} mm north (± {sigma:mm.1} mm)"),
    "control.translation_west": N_("{size:mm.1+} mm west (± {sigma:mm.1} mm)"),
    "control.translation_up": N_("{size:mm.1+} mm up (± {sigma:mm.1} mm)"),
    "control.position_not_finite": N_(
        "Control point {name} has coordinates that are not finite. Correct them, or exclude it."
    ),
    "control.sigma_not_positive": N_(
        "The standard deviation of control point {name} is not a positive number. Give one in "
        "metres."
    ),
    "control.centre_of_plane": N_(
        "Control point {name} is the centre of a sphere, but target {target} is a plane. Assign it "
        "to a sphere or exclude it."
    ),
}
