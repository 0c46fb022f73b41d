"""Texts of messages about TOML and JSON files: sensors, vessels, scenes, plans, projects."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- content of any JSON or TOML file, as part of another message --------------------------
    "content.not_utf8": N_("The file is not encoded in UTF-8."),
    "content.not_json": N_("The JSON text is invalid from line {line:n}."),
    "content.not_toml": N_("The TOML text is invalid ({reason})."),
    "content.nested_too_deeply": N_("Lists or tables in the file are nested too deeply."),
    "content.number_too_large": N_("An integer in the file exceeds 64 bits."),
    "content.null_character": N_("A text in the file contains a null character."),
    "content.surrogate": N_(
        "A text in the file contains a damaged character. Write the file again as UTF-8."
    ),
    "content.missing_field": N_("The field {field} is missing in the file."),
    "content.invalid_version": N_("The version of the file format is invalid: {version}."),
    "content.wrong_type": N_("A value in the file has the wrong type."),
    "content.not_integer": N_("A count in the file is not an integer."),
    "content.not_number": N_("A value in the file is not a number."),
    "content.quantity_too_large": N_("A number in the file is impossibly large."),
    "content.not_boolean": N_("A value in the file is neither true nor false."),
    "content.value_not_text": N_("A value in the file is not text."),
    "content.not_list": N_("A value in the file is not a list."),
    "content.wrong_length": N_("A list in the file has the wrong number of values."),
    "content.not_numbers": N_("A list in the file contains values that are not numbers."),
    "content.not_integers": N_("A list in the file contains values that are not integers."),
    "content.wrong_shape": N_("The array {field} in the file has the wrong dimensions."),
    "content.inconsistent_result": N_(
        "The stored result is not consistent: its values contradict each other."
    ),
    "content.wrong_form": N_(
        "The section {part} of the file is incomplete or has values of the wrong type."
    ),
    "content.unknown_fields": N_(
        "The section {part} of the file has unknown fields: {names:names}."
    ),
    "content.invalid_part": N_("The section {part} of the file cannot be used. {reason}"),
    "content.unknown_message": N_(
        "A stored message has the unknown code {code}, or parameters that do not fit this code."
    ),
    "content.unknown_role": N_("Target {target} has the unknown role {role}."),
    "content.unknown_shape": N_("Target {target} has the unknown shape {shape}."),
    "content.invalid_search": N_(
        "The seed, threshold or search radius of target {target} is invalid."
    ),
    "content.duplicate_target": N_("Two targets have the name {target}."),
    "content.duplicate_control": N_("Two files of control have the name {name}."),
    "content.duplicate_line": N_("Two lines have the name {line}."),
    "content.invalid_sighting": N_(
        "The stored values of target {target} on line {line} are outside the possible range."
    ),
    "content.invalid_truth": N_("The true boresight angles are outside the possible range."),
    "content.unknown_line": N_(
        "Target {target} has a sighting on line {line}, but the project has no such line."
    ),
    "content.invalid_angles": N_(
        "The boresight angles or the covariance of the method “{method}” are invalid."
    ),
    "content.invalid_point_count": N_(
        "The number of points of a sighting must be a whole number of zero or more."
    ),
    "content.too_many_bytes": N_(
        "A stored array has {bytes:n} bytes, too many for {count:n} points."
    ),
    "content.not_indices": N_("A stored array does not contain valid point indices."),
    "content.too_few_points": N_("A stored array has {held:n} points instead of {count:n}."),
    "content.unreadable": N_("The file cannot be read ({reason})."),
    # -- keys of a TOML file -------------------------------------------------------------------
    "toml.invalid": N_("{file}: the content of the file is not valid: {reason} Correct the file."),
    "toml.control_character": N_(
        "{file}: {key} is {value}, which contains a line break or another control character. Write "
        "it on one line."
    ),
    "toml.not_text": N_(
        "{file}: {key} is {value}, but a text is expected. Put the text in quotation marks."
    ),
    "toml.not_a_choice": N_(
        "{file}: {key} is {value}, which is not allowed. Give {choices:choices}."
    ),
    "toml.not_true_or_false": N_(
        "{file}: {key} is {value}, which is not allowed. Give true or false."
    ),
    "toml.not_numbers": N_(
        "{file}: {key} is {value}, but a list of numbers is expected. Give numbers in square "
        "brackets."
    ),
    "toml.wrong_number_count": Plural(
        "{file}: {key} is {value}, but a list of {count:n} number is expected. Give it in square "
        "brackets.",
        "{file}: {key} is {value}, but a list of {count:n} numbers is expected. Give them in "
        "square brackets.",
    ),
    "toml.not_a_table": N_(
        "{file}: {key} is {value}, but a table is expected. Write [{table}] above its keys."
    ),
    "toml.not_a_list_of_tables": N_(
        "{file}: {key} must be a list of tables. Write [[{table}]] above each of them."
    ),
    "toml.unknown_key_similar": N_(
        "{file}: {key} is not a known key. Use {similar} if you mean that, or remove the key."
    ),
    "toml.unknown_key": N_(
        "{file}: {key} is not a known key. Remove it, or use one of these: {known:names}."
    ),
    "toml.wrong_key": N_(
        "{file}: {key} is not a known key, and {wanted} is missing. Rename the key to {wanted}."
    ),
    "toml.missing_key": N_("{file}: {key} is missing. Add it."),
    "toml.not_a_number": N_("{file}: {key} is {value}, which is not a number. Correct it."),
    "toml.not_finite": N_("{file}: {key} is {value}, which is not a finite number. Correct it."),
    "toml.below_minimum": N_(
        "{file}: {key} is {value}, which is too small. Give at least {least}."
    ),
    "toml.too_near_zero": N_(
        "{file}: {key} is {value}, which is too close to zero to be a real quantity. Give zero or "
        "a larger value."
    ),
    "toml.not_above": N_("{file}: {key} is {value}, which is too small. Give more than {bound}."),
    "toml.above_maximum": N_("{file}: {key} is {value}, which is too large. Give at most {most}."),
    # -- sensors, vessels and scanners ---------------------------------------------------------
    "sensor.no_accuracies": N_(
        "{file}: the file contains no standard deviations. Add at least one of the tables "
        "{tables:names}."
    ),
    "sensor.zero_sigma": N_(
        "{file}: {key} contains zero, but a standard deviation must be larger than 0. Correct it."
    ),
    "vessel.no_pos_errors": N_(
        "{file}: {key} is missing. Add a table [[pos]] for each error of the POS."
    ),
    "vessel.boresight_too_large": N_(
        "A simulated boresight angle of {value:deg}° is larger than {most:deg}°. Give a "
        "smaller angle."
    ),
    "vessel.scan_angle_offset_too_large": N_(
        "A simulated scan-angle offset of {value:deg}° is larger than {most:deg}°. Give a "
        "smaller angle."
    ),
    "vessel.lever_arm_error_too_large": N_(
        "A simulated lever-arm error of {value:m} m is larger than {most:m} m. Give a smaller "
        "error."
    ),
    "vessel.range_offset_too_large": N_(
        "A simulated range offset of {value:m} m is larger than {most:m} m. Give a smaller offset."
    ),
    "vessel.latency_too_large": N_(
        "A simulated latency of {value:s} s is larger than {most:s} s. Give a smaller latency."
    ),
    "scanner.window": N_(
        "{file}: the second angle of {key} must exceed the first, by at most 360°. Correct the "
        "angles."
    ),
    "scanner.no_elevations": N_("{file}: {key} is empty. Give the elevation of each beam."),
    # -- scenes --------------------------------------------------------------------------------
    "scene.no_surfaces": N_("{file}: {key} is missing. Add a table [[surfaces]] for each surface."),
    "scene.target_name": N_("{file}: {key} is not a valid name of a target. {reason}"),
    "scene.name_twice": N_(
        "{file}: {key} is {name}, but another surface already has this name. Give each surface its "
        "own name."
    ),
    "scene.role_of_kind": N_(
        "{file}: {key} is given for a surface of type {kind}, but only boards, walls and spheres "
        "can be targets. Remove the role."
    ),
    "scene.validation_sphere": N_(
        '{file}: {key} of a sphere is "validation", but only planes are compared between lines. '
        'Use the role "target".'
    ),
    "scene.no_distance": N_(
        "{file}: {key} is missing. Give the distance at which the lines pass the site."
    ),
    "scene.bearing_along_heading": N_(
        "{file}: {key} is parallel to the heading of the line, but the site must lie abeam of it. "
        "Change the bearing or the heading."
    ),
    "scene.mixed_lines": N_(
        "{file}: some {key} are defined by a heading, others by start_s. Define all of them in the "
        "same way."
    ),
    "scene.no_lines": N_("{file}: {key} is missing. Add a table [[lines]] for each line."),
    "scene.line_too_short": N_(
        "{file}: a line in {key} is shorter than 1 m. Increase run_in_m or run_out_m."
    ),
    # -- plans and sites -----------------------------------------------------------------------
    "plan.no_targets": N_(
        "{file}: {key} is empty, so the survey plan has no target. Add [[boards]] or [[balls]]."
    ),
    "plan.no_lines": N_("{file}: {key} is empty, so the survey plan has no line. Add [[lines]]."),
    "plan.name_twice": N_(
        "{file}: {key} contains the name {name} twice. Give each target its own name."
    ),
    "plan.sizes_differ": N_(
        "{file}: {key} has {heights:n} values, but width_m has {widths:n}. Give one width and one "
        "height for each size."
    ),
    "plan.not_whole": N_("{file}: {key} is {value}, but a whole number is expected. Correct it."),
}
