"""Every error the program raises on purpose.

A message is one plain sentence for a surveyor: what is wrong, where, and what to do about it.
The command line prints it and exits with 1; the window shows it in a dialogue.
"""

CONTROL = dict.fromkeys([*range(0x20), *range(0x7F, 0xA0)], " ")
"""Characters of Unicode's category Cc, with what replaces them."""


class LispacError(Exception):
    """Something the user can act on.

    Control characters in its message, which come from names of files and the like, are replaced by
    spaces: it stays one line, and commands to a terminal remain text.
    """

    def __init__(self, message: str = "") -> None:
        super().__init__(message.translate(CONTROL))


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
    """The least-squares adjustment cannot give an answer."""


class RankDeficient(AdjustmentError):
    """The geometry of lines and targets does not determine the boresight."""


class TargetDisagrees(RankDeficient):
    """No point of a target agrees with the other targets and lines."""

    def __init__(self, message: str, target: str = "") -> None:
        super().__init__(message)
        self.target = target


class NotConverged(AdjustmentError):
    """The iterations did not settle."""


class Cancelled(Exception):
    """The user asked a running task to stop; nothing has been changed."""
