"""Every error the program raises on purpose.

A message is one plain sentence for a surveyor: what is wrong, where, and what to do about it.
The command line prints it and exits with 1; the window shows it in a dialogue.
"""

import errno

from lispac.message_texts import CONTROL, message_text
from lispac.messages import Message, note

SYSTEM_REASONS = {
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
"""Code of the message for each number of an error of the system."""


def system_reason(failure: OSError) -> Message | str:
    """Reason of an error of the system, as a parameter of a message."""
    code = SYSTEM_REASONS.get(failure.errno or 0)
    return failure.strerror or str(failure) if code is None else note(code)


class LispacError(Exception):
    """Error that the user can act on.

    Parameters
    ----------
    message : Message or str
        What is wrong. Its text is made when it is shown, in the language in use then; control
        characters, which come from names of files and the like, are replaced by spaces in it.
    """

    def __init__(self, message: Message | str = "") -> None:
        super().__init__(message)
        self._message = message

    @property
    def message(self) -> Message | None:
        """Typed message; None if the error has only a text."""
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
        return self._message.translate(CONTROL)


class InputError(LispacError):
    """A file or a value that cannot be used."""


class ProjectError(LispacError):
    """A project folder that cannot be opened or written, or lacks what a step needs."""


class ProjectChanged(ProjectError):
    """Another program has written the project since it was opened."""


class TargetNotFound(LispacError):
    """No target was found where the seed was set."""


class PlaneNotFound(TargetNotFound):
    """No plane was found where the seed was set."""


class SphereNotFound(TargetNotFound):
    """No sphere was found where the seed was set, or the points do not determine one."""


class NotComparable(LispacError):
    """A validation plane that no two lines see in common."""


class AdjustmentError(LispacError):
    """The least-squares adjustment cannot give a result."""


class RankDeficient(AdjustmentError):
    """The geometry of lines and targets does not determine the boresight."""


class TargetDisagrees(RankDeficient):
    """No point of a target agrees with the other targets and lines."""

    def __init__(self, message: Message | str, target: str = "") -> None:
        super().__init__(message)
        self.target = target


class NotConverged(AdjustmentError):
    """The iterations did not converge."""


class Cancelled(Exception):
    """The user asked a running task to stop; nothing has been changed."""
