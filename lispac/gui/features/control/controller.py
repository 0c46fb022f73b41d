"""Import and use of surveyed control in the window."""

from collections.abc import Callable

from PySide6.QtCore import QObject

from lispac.control_points import with_control_use, without_control_file
from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.control.dialogs import ControlDialogs
from lispac.gui.project.availability import data_reason
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.progress import Progress
from lispac.project import Project


class ControlController(QObject):
    """Shows the control of the project, imports files, and changes which points are used."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        dialogs: ControlDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._controller, self._dialogs, self._actions = controller, dialogs, actions
        actions.connect_slots({"control": self.show})
        self._tried: Project | None = None
        """Project for which the assignment was last started."""
        for moved in (document.changed, document.survey_changed, runner.changed):
            moved.connect(self._enable_controls)
        for moved in (document.changed, runner.idle):
            moved.connect(self._follow_targets)
        self._enable_controls()

    def show(self) -> None:
        """Show the control, and apply the choices of the user."""
        project = self._document.project
        if project is None:
            return
        if self._needs_assignment():
            self._assign(self.show)
            return
        choice = self._dialogs.control(project)
        current = self._document.project
        # A result that was computed meanwhile does not change the control.
        if choice is None or current is None or current.control != project.control:
            return
        self._use(current, choice.used)
        if choice.next_step == "import":
            self.import_file()
        elif choice.next_step == "remove" and choice.file:
            self._remove(choice.file)

    def import_file(self) -> None:
        """Import a file with control as one undo step, then show the control."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        request = self._dialogs.control_file(project, survey.trajectory)
        if request is None:
            return

        def work(progress: Progress) -> tuple[Project, tuple[Message, ...]]:
            from lispac.workflow.control.control_import import import_control

            return import_control(
                project, survey, request.path, sigma=request.sigma,
                common_sigma=request.common_sigma, crs=request.crs, height=request.height,
                progress=progress,
            )  # fmt: skip

        def done(imported: tuple[Project, tuple[Message, ...]]) -> None:
            found, notes = imported
            name = request.path.name
            self._document.edit(N_("control of {file}"), found, recompute=True, file=name)
            for note in notes:
                self._controller.logged.emit(message_text(note))
            self.show()

        title = gettext("Importing the control of {file}", file=request.path.name)
        task = self._runner.run(title, work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def _follow_targets(self) -> None:
        """Assign the control again if targets were added or removed, when no task runs.

        An estimate assigns it itself.
        """
        if self._needs_assignment() and not (self._runner.active or self._document.awaits_result):
            self._assign()

    def _needs_assignment(self) -> bool:
        """Whether there are new targets; False after the assignment for this project failed."""
        project, survey = self._document.current_data
        if project is None or survey is None or project is self._tried or not project.control:
            return False
        from lispac.workflow.control.control_assignment import is_assignment_current

        return not is_assignment_current(project)

    def _assign(self, then: Callable[[], None] | None = None) -> None:
        """Assign the control to the targets within the undo step of the last edit."""
        project, survey = self._document.current_data
        assert project is not None
        assert survey is not None
        self._tried = project

        def work(progress: Progress) -> Project:
            from lispac.workflow.control.control_assignment import with_assigned_control

            return with_assigned_control(project, survey, progress=progress)

        def done(assigned: Project) -> None:
            if self._document.project is project:
                self._document.complete_last_edit(assigned)
            if then is not None:
                then()

        task = self._runner.run(
            gettext("Assigning the control to the targets"), work, done, quiet=then is None,
            key="control", modal=then is not None,
        )  # fmt: skip
        self._controller.cancel_on_edit(task)

    def _use(self, project: Project, used: tuple[str, ...]) -> None:
        """Use exactly these points, as one undo step if the use of a point changes."""
        points = [point for file in project.control for point in file.points if point.target]
        names = {point.name for point in points}
        if {point.name for point in points if point.used} == set(used):
            return
        control = with_control_use(project.control, names - set(used), used=False)
        control = with_control_use(control, names & set(used), used=True)
        self._document.edit(N_("use of control"), project.with_control(control), recompute=True)

    def _remove(self, file: str) -> None:
        """Remove the control of a file as one undo step."""
        project = self._document.project
        assert project is not None
        control = without_control_file(project.control, file)
        changed = project.with_control(control)
        self._document.edit(N_("remove control of {file}"), changed, recompute=True, file=file)

    def _enable_controls(self) -> None:
        project = self._document.project
        has_targets = project is not None and bool(project.targets_of_role("target"))
        self._actions.set_reason(
            "control",
            data_reason(self._document, self._runner)
            or first_reason((not has_targets, Unavailable.NO_TARGET)),
        )
