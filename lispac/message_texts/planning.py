"""Texts of messages about survey design and simulation."""

from collections.abc import Mapping

from lispac.language import N_, Template

TEXTS: Mapping[str, Template] = {
    # -- simulated surveys -------------------------------------------------------------------------
    "simulation.latency": N_(
        "With a latency of {latency:s} s the lines extend beyond the trajectory. Give a smaller "
        "latency, or let the vessel wait longer (wait_s)."
    ),
    "simulation.line_outside": N_(
        "Line {number:n} is recorded from {start:s.3} to {stop:s.3} s, where the trajectory "
        "({first:s.3} to {last:s.3} s) has no states or a gap. Give start_s and stop_s within it, "
        "in its own time."
    ),
    # -- comparison with the thesis ----------------------------------------------------------------
    "visibility.differs": N_("{reason} The lines differ by {differences:names}."),
    "visibility.unknown_reason": N_("The reason is not known."),
    "visibility.roll_facing": N_(
        "The choice of table 3.2 lies near the board that faces the beams (-20 deg here), where a "
        "roll error moves points along it. Appendix C.2.1 gives -40 and then 30 deg for the same "
        "figure; 30 is the upper end of what it keeps, and so is the best here."
    ),
    "visibility.offset_as_roll": N_(
        "With the scanner along the body axes this offset is a roll, to the last digit; the thesis "
        "has -40 deg for one and -50 for the other, and 30 in appendix C.2.7, where the error is 1 "
        "and not 2 deg."
    ),
    "visibility.offset_not_kept": N_(
        "Table 3.2 chooses an inclination that appendix C.2.6 does not keep (-40 to 10 deg). At "
        "-60 deg parallel and diagonal lines meet the board at nearly equal angles, so that the "
        "offset shifts both alike."
    ),
    "visibility.leaning_back": N_(
        "A board that leans back shows roll more than an upright one, since beams rise to it by "
        "18 deg. The thesis considers 0 to 90 deg only, and of these the upright one is best here "
        "too."
    ),
    # -- further line ------------------------------------------------------------------------------
    "further_line.port": N_(
        "A further line headed {heading:deg.0} deg, with the middle of the targets "
        "{distance:m.1} m to port, would bring the sigma of {angle} from {now:deg.3} to "
        "{then:deg.3} deg."
    ),
    "further_line.starboard": N_(
        "A further line headed {heading:deg.0} deg, with the middle of the targets "
        "{distance:m.1} m to starboard, would bring the sigma of {angle} from {now:deg.3} to "
        "{then:deg.3} deg."
    ),
    "further_line.port_of_face": N_(
        "A further line headed {heading:deg.0} deg ({off:deg.0} deg off the face of {target}), "
        "with the middle of the targets {distance:m.1} m to port, would bring the sigma of "
        "{angle} from {now:deg.3} to {then:deg.3} deg."
    ),
    "further_line.starboard_of_face": N_(
        "A further line headed {heading:deg.0} deg ({off:deg.0} deg off the face of {target}), "
        "with the middle of the targets {distance:m.1} m to starboard, would bring the sigma of "
        "{angle} from {now:deg.3} to {then:deg.3} deg."
    ),
    "further_line.insufficient": N_(
        "No single further line past these targets, {distance:m.1} m from their middle, would "
        "bring the sigma of {angle} from {now:deg.3} below {limit:deg.3} deg; targets elsewhere, "
        "or the survey repeated later, when the POS error is another one, would."
    ),
    "further_line.prior": N_(
        "The sigma of {angle} is mostly that of the stated {parameters:names}, and no further "
        "line lowers it."
    ),
    # -- survey design -----------------------------------------------------------------------------
    "design.undetermined": N_(
        "This plan does not determine the boresight. Add lines in other directions."
    ),
    "design.no_sightings": N_(
        "No line sees a target: the targets face away, are seen too obliquely or are too far. Plan "
        "lines on the side that the targets face, within the range of the scanner."
    ),
    "design.own_flatness": N_(
        "The adjustment accepts one flatness for all targets, but some targets of this plan have "
        "their own. Let the flatness be estimated from the data."
    ),
    "design.none_adjusted": N_(
        "None of the simulated surveys could be adjusted. Add lines or targets."
    ),
    "design.no_plan": N_(
        "No plan within these limits determines the boresight. Plans with overlapping boards, "
        "lines too close to the wall or targets that all face one way are excluded. Allow more "
        "lines, other headings, or two boards with different tilts."
    ),
    "design.site_too_small": N_(
        "A site needs at least two lines, and a board or an existing plane. Raise the limits."
    ),
    "design.no_board_places": N_(
        "Positions, heights, tilts or sizes of the boards are missing. Give at least one of each."
    ),
    "design.too_long": N_(
        "{lines:n} lines of {minutes_per_line:x.1} minutes and {boards:n} boards of "
        "{minutes_per_board:x.1} minutes take {needed:x.1} minutes, longer than the "
        "{available:x.1} minutes on site. Allow fewer, or more time."
    ),
    "design.lines_too_close": N_(
        "No heading and distance keep {closest:m} m from the wall. Allow others."
    ),
    "plan.empty": N_("Add a target and at least two lines."),
    "plan.line_through_wall": N_(
        "Line {line:n} runs through the wall, up to {distance:m.1} m behind it. Move it farther "
        "from the wall or change its heading."
    ),
    "plan.line_near_wall": N_(
        "Line {line:n} comes within {distance:m.1} m of the wall. Move it farther from the wall or "
        "change its heading."
    ),
    "plan.targets_overlap": N_("Targets {first} and {second} overlap. Move one of them."),
    "design.steps": N_(
        "From {low:x} to {high:x} in steps of {step:x}: the step must be above zero, and the "
        "second value not less than the first. Correct them."
    ),
}
