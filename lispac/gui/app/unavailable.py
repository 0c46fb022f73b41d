"""Reasons why an action cannot be used now."""

from enum import Enum

from lispac.language import N_, gettext


class Unavailable(Enum):
    """Reason why an action cannot be used now; the value is its English text."""

    NO_PROJECT = N_("No project is open.")
    READING = N_("The files are being read.")
    BUSY = N_("A task is running. Wait until it has ended, or cancel it.")
    NO_TASK = N_("No task is running.")
    NO_TARGET = N_("Pick a target first.")
    NO_PLANE = N_("Pick a validation plane first.")
    NO_RESULT = N_("Estimate the boresight first.")
    NO_REPORT = N_("Export a report first.")
    WAITING = N_("The result is being updated.")
    NO_CANDIDATE = N_("No detected target is waiting to be accepted.")
    POOR_CANDIDATE = N_(
        "Every line of the target is rated poor, so Enter does not accept it. Press the button "
        "Accept in step 2 to accept it nevertheless."
    )
    ONE_LINE = N_("At least two lines are needed.")
    NO_OBJECT = N_("Find or add an object first.")
    NO_ANGLES = N_("Find the angles first.")
    NO_SECTION = N_("Select a target or draw a section first.")
    NO_PLOT = N_("Choose a plot first.")
    WRONG_VALUE = N_("Correct the value that is marked as wrong first.")
    NO_SELECTION = N_("Select a target first.")
    NO_TOOL = N_("No mouse tool is active, and there is one view.")
    LINKED_VIEWS = N_("An outline needs a single view: press Esc to leave the linked views.")
    FIRST_VIEW = N_("There is no previous view.")
    LAST_VIEW = N_("There is no next view.")
    SAVED = N_("There are no unsaved changes.")
    NO_EDIT = N_("There is no edit to undo.")
    NOTHING_UNDONE = N_("There is no undone edit.")
    NO_RECENT = N_("Projects that you have opened are listed here.")

    @property
    def text(self) -> str:
        """Text in the language of the window."""
        return gettext(self.value)


Reason = Unavailable | None
"""Reason why an action cannot be used; None if it can be used."""


def reason_text(reason: Reason) -> str:
    """Text of a reason; empty if there is none."""
    return "" if reason is None else reason.text


def first_reason(*reasons: tuple[bool, Unavailable]) -> Reason:
    """The first reason whose condition holds."""
    return next((reason for holds, reason in reasons if holds), None)
