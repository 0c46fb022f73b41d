"""Codes of warnings in versions before typed messages, for scripts that read JSON."""

from collections.abc import Mapping

from lispac.messages import Message

TOPICS_WITH_FORMER_CODES = ("adjustment.", "report.", "targets.")
"""Topics of messages whose former codes did not contain the topic."""

FORMER_CODES: Mapping[str, str] = {
    "large_sigma_unseen": "large_sigma",
    "surfaces_displaced": "surfaces_differ",
    "high_correlation_parameter": "high_correlation",
    "strays_full_weight": "strays",
    "strays_reduced_weight": "strays",
    "strays_no_weight": "strays",
    "radii_roll_sign": "radii_differ",
    "radii_pitch_sign": "radii_differ",
    "radii_roll_pitch_signs": "radii_differ",
    "radii_parameter": "radii_differ",
    "known_cause_or_others": "known_cause",
    "line_position": "line_jumped",
    "line_times_early": "line_time",
    "line_times_late": "line_time",
    "sighting_cause": "sighting_disagrees",
    "chi_square_high_noise": "chi_square_high",
    "chi_square_high_classical": "chi_square_high",
    "parameter_not_seen_uncertain": "parameter_not_seen",
    "left_out_target": "left_out",
    "left_out_plane": "left_out",
    "left_out_target_on_lines": "left_out",
    "left_out_plane_on_lines": "left_out",
    "target_on_no_line": "few_lines",
    "plane_on_no_line": "few_lines",
    "plane_on_one_line": "few_lines",
    "target_on_few_lines": "few_lines",
    "plane_on_few_lines": "few_lines",
    "absolute_nearer": "absolute_off",
    "absolute_farther": "absolute_off",
    "absolute_line_off_by_chance": "absolute_line_off",
    "absolute_point_off_by_chance": "absolute_point_off",
}
"""Former code by the name in the present code (the part after the topic), if they differ."""

REMOVED_CODES = {"observability.no_main_line", "observability.no_main_lines"}
"""Codes of earlier versions in the observability of a stored result, which another replaces."""


def former_code(message: Message) -> str:
    """Return the former code of a message, or its present code if it had none."""
    reason = message.params.get("reason")
    if message.code == "data.same_on_lines" and isinstance(reason, Message):
        return reason.code
    topic, _, name = message.code.partition(".")
    if f"{topic}." not in TOPICS_WITH_FORMER_CODES:
        return message.code
    return FORMER_CODES.get(name, name.removesuffix("_alone"))
