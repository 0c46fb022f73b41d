"""Warning about a result that stands although a later estimate was refused."""

from lispac.messages import Message, warning
from lispac.warning_causes import RESULT


def outdated_result_warning(reason: Message | str) -> Message:
    """Warning about a result after which another estimate was refused, with the reason."""
    return warning("adjustment.refused_since", reason=reason, subject=RESULT)
