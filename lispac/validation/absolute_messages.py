"""Messages on a comparison with a reference: mean, deviating lines, RMS."""

from collections.abc import Iterator, Sequence

from lispac.messages import Message, note
from lispac.validation.absolute_check import AbsoluteCheck, AbsoluteState

NamedMean = tuple[str, float, float]
"""A name, a mean, and half its 95 % interval, metres."""


def absolute_check_messages(check: AbsoluteCheck) -> tuple[Message, ...]:
    """Messages on the means, significant deviations, the RMS, and other surfaces."""
    return (
        _mean_message(check.all_lines.after, "after"),
        _mean_message(check.all_lines.before, "before"),
        _line_message(check),
        *_point_messages(check),
        _rms_message(check),
        *_other_surface_messages(check),
        note("absolute.scan_error" if check.kind == "scan" else "absolute.point_errors"),
        *((note("absolute.lines_alike"),) if len(check.lines) > 1 else ()),
    )


def list_items_with_means(off: Sequence[NamedMean]) -> list[Message]:
    """Names with their means, as the items of a list."""
    return [
        note("item.mean_distance", name=name, mean=mean, interval=half) for name, mean, half in off
    ]


MEAN_CODES = {
    ("after", True): "absolute.after_nearer",
    ("after", False): "absolute.after_farther",
    ("before", True): "absolute.before_nearer",
    ("before", False): "absolute.before_farther",
}
"""Message code by state and by whether the lines are nearer to the vessel than the reference."""
FINDING_CODES = {
    ("after", True): "absolute.not_explained",
    ("after", False): "absolute.explained",
    ("before", True): "absolute.not_explained_before",
    ("before", False): "absolute.explained_before",
}
"""Message code by state and by whether the mean differs significantly from zero."""


def _mean_message(absolute_state: AbsoluteState, state: str) -> Message:
    mean = absolute_state.signed.mean
    return note(
        MEAN_CODES[state, mean > 0],
        mean=abs(mean), interval=absolute_state.interval_95,
        finding=note(FINDING_CODES[state, absolute_state.significant]),
    )  # fmt: skip


def _line_message(check: AbsoluteCheck) -> Message:
    off = [
        (line.line, line.after.signed.mean, line.after.interval_95)
        for line in check.lines
        if line.after.significant
    ]
    if not off:
        return note("absolute.no_line_off")
    return note(
        "report.absolute_line_off",
        count=len(off),
        total=len(check.lines),
        lines=list_items_with_means(off),
    )


def _point_messages(check: AbsoluteCheck) -> Iterator[Message]:
    off = [
        (point.name, point.after, point.interval_95)
        for point in check.points
        if point.interval_95 is not None and abs(point.after) > point.interval_95
    ]
    if off:
        total = len(check.points)
        yield note(
            "report.absolute_point_off",
            count=len(off),
            total=total,
            points=list_items_with_means(off),
        )


def _rms_message(check: AbsoluteCheck) -> Message:
    before, after = check.all_lines.before, check.all_lines.after
    return note(
        "absolute.rms",
        before=before.distances.rms, after=after.distances.rms,
        reference=after.rms_expected.reference, share=after.reference_share,
        expected=after.rms_expected.total,
    )  # fmt: skip


def _other_surface_messages(check: AbsoluteCheck) -> Iterator[Message]:
    """Notes on lines with a second surface, which may have been measured by mistake."""
    if check.other_surfaces is None:
        yield note("absolute.former_version")
    elif check.other_surfaces:
        places = {line.line: line.after.signed.n for line in check.lines}
        lines = [
            note(
                "item.other_surface",
                line=other.line, places=other.places, total=places[other.line],
                distance=other.distance,
            )
            for other in check.other_surfaces
        ]  # fmt: skip
        yield note("absolute.other_surface", distance=check.search_distance, lines=lines)
