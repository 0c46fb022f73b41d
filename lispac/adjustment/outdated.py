"""A result that stands although another estimate was run since."""

from lispac.causes import RESULT
from lispac.messages import Message, warning


def refused_since(reason: Message | str) -> Message:
    """The warning about a result after which another estimate was refused, and why."""
    return warning("adjustment.refused_since", reason=reason, subject=RESULT)
