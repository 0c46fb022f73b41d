"""Reasons why an action on the data of the project cannot be used now."""

from lispac.gui.app.tasks import TaskRunner
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason
from lispac.gui.project.document import Document


def data_reason(document: Document, runner: TaskRunner) -> Reason:
    """Reason why no task can use the data of the project; None if one can."""
    return first_reason(
        (document.project is None, Unavailable.NO_PROJECT),
        (document.current_data[1] is None, Unavailable.READING),
        (runner.busy, Unavailable.BUSY),
    )


def result_reason(document: Document, runner: TaskRunner) -> Reason:
    """Reason why no task can use the result of the adjustment; None if one can."""
    project = document.project
    return first_reason(
        (project is None, Unavailable.NO_PROJECT),
        (project is not None and project.result is None, Unavailable.NO_RESULT),
    ) or data_reason(document, runner)
