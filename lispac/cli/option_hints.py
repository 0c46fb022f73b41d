"""Options of the command line that do what a message suggests."""

from lispac.messages import Message

OPTIONS = {
    "adjustment.only_plane": "--accept-single-orientation",
    "adjustment.parallel_planes": "--accept-single-orientation",
    "history.no_date": "lispac identity {project} --dates",
    "history.no_day": "lispac identity {project} --dates",
    "plan_survey.process_ended": "--workers",
}
"""Option or command by the code of a message, whose text also is for the window."""


def option_hint(message: Message | None) -> str:
    """Option that a message or a part of it suggests; empty if there is none."""
    if message is None:
        return ""
    if message.code in OPTIONS:
        return OPTIONS[message.code].format(**message.params)
    parts = [each for each in message.params.values() if isinstance(each, Message)]
    return next(filter(None, map(option_hint, parts)), "")
