"""Exceptions with messages for the user.

A message describes the problem, where it is, and what the user can do. The command line prints it
and exits with status 1; the window shows it in a dialogue.
"""

import errno

from lispac.message_texts import CONTROL_CHARACTERS_TO_SPACES, message_text
from lispac.messages import Message, note

SYSTEM_REASON_CODES = {
    errno.ENOENT: "system.not_found",
    errno.EIO: "system.input_output",
    errno.EACCES: "system.permission",
    errno.ENOTDIR: "system.not_a_folder",
    errno.EISDIR: "system.is_a_folder",
    errno.ENOSPC: "system.disk_full",
    errno.EROFS: "system.read_only",
    errno.ENAMETOOLONG: "system.long_name",
    errno.EDQUOT: "system.quota",
}
"""Code of the message for each error number of the operating system."""


def system_reason(failure: OSError) -> Message | str:
    """Reason of an error of the operating system, as a parameter of a message."""
    code = SYSTEM_REASON_CODES.get(failure.errno or 0)
    return failure.strerror or str(failure) if code is None else note(code)


class LispacError(Exception):
    """Error that the user can act on.

    Parameters
    ----------
    message : Message or str
        Description of the problem. Its text is created in the current language when it is shown.
        Control characters, for example in file names, are replaced by spaces.
    """

    def __init__(self, message: Message | str = "") -> None:
        super().__init__(message)
        self._message = message

    @property
    def message(self) -> Message | None:
        """Message as a value; None if the error has only a text."""
        return self._message if isinstance(self._message, Message) else None

    @property
    def code(self) -> str:
        """Code of the message; empty if the error has only a text."""
        return self.message.code if self.message is not None else ""

    @property
    def reason(self) -> Message | str:
        """Message or text of the error, as a parameter of another message."""
        return self._message

    def __str__(self) -> str:
        """Text of the message, in one line."""
        if isinstance(self._message, Message):
            return message_text(self._message)
        return self._message.translate(CONTROL_CHARACTERS_TO_SPACES)


def failure_reason(failure: BaseException) -> Message | str:
    """Reason of any failure, as a parameter of a message.

    The text of an `OSError` is not used, since it contains the path in quotation marks and with
    doubled backslashes.
    """
    if isinstance(failure, LispacError):
        return failure.reason
    if isinstance(failure, OSError):
        return system_reason(failure)
    return str(failure) or type(failure).__name__


class InputError(LispacError):
    """A file or value cannot be used."""


class ProjectError(LispacError):
    """A project cannot be opened or written, or lacks the data that a step needs."""


class ProjectChanged(ProjectError):
    """The project file was changed by another program after it was opened."""


class TargetNotFound(LispacError):
    """No target was found at the seed."""


class PlaneNotFound(TargetNotFound):
    """No plane was found at the seed, or the points do not determine one."""


class SphereNotFound(TargetNotFound):
    """No sphere was found at the seed, or the points do not determine one."""


class NotComparable(LispacError):
    """Two lines, or a line and a reference, have no common part that can be compared."""


class AdjustmentError(LispacError):
    """The least-squares adjustment cannot give a result."""


class RankDeficient(AdjustmentError):
    """The geometry of lines and targets does not determine the boresight."""


class TargetDisagrees(RankDeficient):
    """All points of a target contradict the other targets and lines."""

    def __init__(self, message: Message | str, target: str = "") -> None:
        super().__init__(message)
        self.target = target


class NotConverged(AdjustmentError):
    """The iterations did not converge."""


class Cancelled(Exception):
    """The user cancelled a running task; nothing was changed."""
