"""Errors of an adjustment whose surfaces were chosen by the program."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Literal

from lispac.errors import NotConverged, RankDeficient
from lispac.messages import Message, as_message, error, note

Method = Literal["propose", "targetless"]
UNDETERMINED_CODES = {"propose": "propose.undetermined", "targetless": "targetless.undetermined"}
"""Codes of the error that the angles are not determined, by method."""
NO_RESULT_CODES = {"propose": "propose.no_result", "targetless": "targetless.no_result"}
"""Codes of the error that there is no result for another reason, by method."""
REJECTION_CODES = ("adjustment.refused_after_rejection", "adjustment.refused_after_exclusion")
"""Codes of errors that name rejected data before the reason."""


@contextmanager
def replace_suggested_actions(project: str, method: Method) -> Iterator[None]:
    """Replace the suggested actions of a failed adjustment, which are about picked targets.

    Parameters
    ----------
    project : str
        Name of the project.

    Raises
    ------
    RankDeficient
        If the angles are not determined.
    NotConverged
        If the adjustment did not converge.
    """
    try:
        yield
    except (NotConverged, RankDeficient) as failure:
        reason = _method_error(as_message(failure.reason), project, method)
        raise type(failure)(reason) from failure


def _method_error(reason: Message, project: str, method: Method) -> Message:
    if reason.code == "estimate.possible_cause":
        inner = reason.params["reason"]
        assert isinstance(inner, Message)
        return error(
            "estimate.possible_cause",
            reason=_method_error(inner, project, method), cause=reason.params["cause"],
            subject=reason.subject,
        )  # fmt: skip
    if reason.code in REJECTION_CODES:
        inner = reason.params["reason"]
        assert isinstance(inner, Message)
        return replace(
            reason, params={**reason.params, "reason": _method_error(inner, project, method)}
        )
    if reason.code in ("adjustment.undetermined", "adjustment.undetermined_because"):
        return error(
            UNDETERMINED_CODES[method],
            project=project,
            direction=reason.params["direction"],
            reason=reason.params.get("reason", note("adjustment.few_directions")),
        )
    return error(NO_RESULT_CODES[method], project=project, reason=reason)
