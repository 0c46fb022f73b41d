"""Options and commands of the command line that do what a message suggests."""

from lispac.messages import Message

OPTIONS = {
    "adjustment.only_plane": "--accept-single-orientation",
    "adjustment.parallel_planes": "--accept-single-orientation",
    "cluster.no_certificates": "--cluster-tls CA CERTIFICATE KEY",
    "cluster.plain_tcp_refused": "--plain-tcp",
    "history.no_date": "lispac identity {project} --dates",
    "history.no_day": "lispac identity {project} --dates",
    "import.points_without_time": "lispac check",
    "import.unknown_accuracy_format": "lispac inspect FILE",
    "import.unknown_line_format": "lispac inspect FILE",
    "import.unknown_trajectory_format": "lispac inspect FILE",
    "plan_survey.process_ended": "--workers",
    "project_files.many_missing": "lispac locate PROJECT FOLDER",
    "project_files.one_missing": "lispac locate PROJECT FOLDER",
    "project_files.several_missing": "lispac locate PROJECT FOLDER",
    "simulate.no_trajectory": "--trajectory",
}
"""Option or command by the code of a message, whose text also is for the window and scripts."""


def option_hint(message: Message | None) -> str:
    """Option that a message or a part of it suggests; empty if there is none."""
    if message is None:
        return ""
    if message.code in OPTIONS:
        return OPTIONS[message.code].format(**message.params)
    parts = [each for each in message.params.values() if isinstance(each, Message)]
    return next(filter(None, map(option_hint, parts)), "")
