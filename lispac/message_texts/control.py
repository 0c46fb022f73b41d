"""Texts of messages about surveyed control in the adjustment."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
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
    "control.no_targets": N_(
        "Project {project} has no targets to which control can be assigned. Pick targets first."
    ),
    "control.sigma": N_(
        "The standard deviation of the control must be larger than 0 m ({sigma:m.4} m is given)."
    ),
    "control.sigma_out_of_range": N_(
        "The standard deviation of control point {name}, {value:m.6} m, is outside the range from "
        "{least:m.6} m to {most:m.0} m. Give it in metres."
    ),
    "control.common_sigma_out_of_range": N_(
        "The common standard deviation of the control, {value:m.4} m, is outside the range from 0 "
        "to {most:m.0} m. Give it in metres."
    ),
    "control.other_origin": N_(
        "The control of {file} was imported with another origin of the local frame. Import the "
        "file again."
    ),
    "control.unknown_point": N_("The project has no control point {name}."),
    "control.unknown_file": N_("The project has no control from a file {name}."),
    "control.far_from_target": N_(
        "Control point {name} is not used: it lies {distance:m.2} m from the surface of {target}. "
        "Check its coordinates and their system, or estimate the boresight."
    ),
    "control.beside_targets": N_(
        "Control point {name} is not used: it lies on no target. Check its coordinates, or name "
        "its target in a column plane."
    ),
    "control.ambiguous": N_(
        "Control point {name} is not used: it lies near {targets:names}. Name its target in a "
        "column plane."
    ),
    "control.target_removed": N_(
        "Control point {name} is not used: {target} was removed or picked again. It is assigned "
        "again at the next estimate."
    ),
    "control.not_in_scan": N_("{target} has no control from the static scan: {reason}"),
    "control.scan_changed": N_("{file} has changed since it was imported. Import it again."),
    "control.scan_not_readable": N_("{file} cannot be read. Import it again."),
    "control.few_scan_points": N_("The scan has only {count:n} points near {target}."),
}
