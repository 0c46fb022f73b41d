"""Texts of messages about survey design and simulation."""

from collections.abc import Mapping

from lispac.language import N_, Advised, Template

TEXTS: Mapping[str, Template] = {
    # -- simulated surveys -------------------------------------------------------------------------
    "simulation.latency": N_(
        "With a latency of {latency:s} s the lines extend beyond the trajectory. Give a smaller "
        "latency, or a longer waiting time of the vessel (wait_s)."
    ),
    "simulation.line_outside": N_(
        "Line {number:n} lasts from {start:s.3} to {stop:s.3} s, but the trajectory ({first:s.3} "
        "to {last:s.3} s) does not cover this time or has a gap in it. Correct start_s and stop_s; "
        "they are in the time of the trajectory."
    ),
    # -- comparison with the thesis ----------------------------------------------------------------
    "visibility.differs": N_("{reason} The two lines differ by {differences:names}."),
    "visibility.unknown_reason": N_(
        "The reason for the difference from Shahraji's thesis is not known."
    ),
    "visibility.roll_facing": N_(
        "The board that is best in table 3.2 of Shahraji's thesis nearly faces the beams, so that "
        "a roll error moves its points along it. Appendix C.2.1 of the thesis also accepts the "
        "best inclination found here."
    ),
    "visibility.offset_as_roll": N_(
        "A scan-angle offset moves the points exactly as a roll error does, so both have the same "
        "best inclination. Table 3.2 of Shahraji's thesis gives different ones: -50° and "
        "-40°."
    ),
    "visibility.offset_not_kept": N_(
        "Table 3.2 of Shahraji's thesis gives -60° as the best inclination, but its appendix "
        "C.2.6 accepts only -40 to 10°. At -60° a range offset moves the points of all lines "
        "by nearly the same amount."
    ),
    "visibility.leaning_back": N_(
        "The beams rise to the board at 18°, so that a board that leans back is more sensitive "
        "to roll than a vertical one. Shahraji's thesis considers only inclinations from 0 to 90°"
        "; among these, the vertical board is the best here too."
    ),
    # -- further line ------------------------------------------------------------------------------
    "further_line.port": N_(
        "A further line at heading {heading:deg.0}°, with the middle of the targets "
        "{distance:m.1} m to port, would reduce the standard deviation of {angle} from {now:deg.4} "
        "to {then:deg.4}°."
    ),
    "further_line.starboard": N_(
        "A further line at heading {heading:deg.0}°, with the middle of the targets "
        "{distance:m.1} m to starboard, would reduce the standard deviation of {angle} from "
        "{now:deg.4} to {then:deg.4}°."
    ),
    "further_line.port_of_face": N_(
        "A further line at heading {heading:deg.0}° ({off:deg.0}° from the face of "
        "{target}), with the middle of the targets {distance:m.1} m to port, would reduce the "
        "standard deviation of {angle} from {now:deg.4}° to {then:deg.4}°."
    ),
    "further_line.starboard_of_face": N_(
        "A further line at heading {heading:deg.0}° ({off:deg.0}° from the face of "
        "{target}), with the middle of the targets {distance:m.1} m to starboard, would reduce the "
        "standard deviation of {angle} from {now:deg.4}° to {then:deg.4}°."
    ),
    "further_line.insufficient": Advised(
        N_(
            "No single further line past these targets, {distance:m.1} m from their middle, would "
            "reduce the standard deviation of {angle} from {now:deg.4}° to less than "
            "{limit:deg.4}°."
        ),
        N_("Add targets elsewhere, or repeat the survey later, when the POS error is different."),
    ),
    "further_line.prior": N_(
        "The standard deviation of {angle} is due mainly to the given standard deviation of "
        "{parameters:names}. A further line does not reduce it."
    ),
    # -- survey design -----------------------------------------------------------------------------
    "design.undetermined": N_(
        "This survey plan does not determine the boresight. Add lines in other directions."
    ),
    "design.no_sightings": N_(
        "No target is visible from any line: the targets face away, are seen too obliquely or are "
        "too far away. Place lines on the side that the targets face, within the range of the "
        "scanner."
    ),
    "design.own_flatness": N_(
        "The adjustment uses one form error for all targets, but some targets of this survey plan "
        "have their own. Choose to estimate the form error from the data."
    ),
    "design.none_adjusted": N_(
        "None of the simulated surveys could be adjusted. Add lines or targets."
    ),
    "design.no_plan": N_(
        "No survey plan within these limits determines the boresight without overlapping boards, "
        "lines too close to the wall or a single target orientation. Allow more lines, other "
        "headings, or two boards with different tilts."
    ),
    "design.site_too_small": N_(
        "A survey plan needs at least two lines, and a board or an existing plane. Increase the "
        "limits."
    ),
    "design.no_board_places": N_(
        "Positions, heights, tilts or sizes of the boards are missing. Give at least one value of "
        "each."
    ),
    "design.too_long": N_(
        "{lines:n} lines of {minutes_per_line:x.1} minutes and {boards:n} boards of "
        "{minutes_per_board:x.1} minutes take {needed:x.1} minutes, longer than the "
        "{available:x.1} minutes available on site. Allow fewer lines or boards, or more time."
    ),
    "design.lines_too_close": N_(
        "With all given headings and distances the lines come closer than {closest:m} m to the "
        "wall. Allow other headings or larger distances."
    ),
    "plan.empty": N_("The survey plan is not complete. Add a target and at least two lines."),
    "plan.line_through_wall": N_(
        "Line {line:n} crosses the wall, up to {distance:m.1} m behind it. Move the line farther "
        "from the wall or change its heading."
    ),
    "plan.line_near_wall": N_(
        "Line {line:n} passes the wall at a distance of only {distance:m.1} m. Move the line "
        "farther from the wall or change its heading."
    ),
    "plan.targets_overlap": N_("Targets {first} and {second} overlap. Move one of them."),
    "design.steps": N_(
        "The range from {low:x} to {high:x} in steps of {step:x} is not valid. Enter a step above "
        "zero and a second value not less than the first."
    ),
}
