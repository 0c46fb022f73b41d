"""Comparison of the lines on the validation planes, and edits of the acceptance criteria."""

from PySide6.QtCore import QObject, Signal

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner, preload_matplotlib
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate.validate_panel import ValidatePanel
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.language import N_, Plural, Template, gettext
from lispac.progress import Progress
from lispac.project import Project
from lispac.validation.local_models import DEFAULT_MODEL, LocalModel

VALIDATION_KEY = "validate"
"""Key of the task that validates."""
OTHER_MODEL_TEXT = N_("Comparison with another surface model: {model}. Validate again (F10).")
LOCAL_PLANES_EDIT_NAME = Plural(
    "validation with local planes through {count:n} point",
    "validation with local planes through {count:n} points",
)
LOCAL_QUADRICS_EDIT_NAME = Plural(
    "validation with local quadrics through {count:n} point",
    "validation with local quadrics through {count:n} points",
)


class Validation(QObject):
    """Runs the validation and stores its result in the document.

    Attributes
    ----------
    distance_to : LocalModel
        Surface model to which the next validation measures distances.
    """

    validated = Signal()
    model_differs = Signal(str)
    """Text that the comparison was made with another surface model than the chosen one, or ""."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        actions: Actions,
        panel: ValidatePanel,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._controller = document, runner, controller
        self._actions, self._panel = actions, panel
        self.distance_to = DEFAULT_MODEL
        panel.validate_requested.connect(actions["validate"].trigger)
        panel.shown_changed.connect(
            lambda which: actions["after" if which == "estimated" else "before"].trigger()
        )
        panel.model_changed.connect(self._set_surface_model)
        panel.acceptance_edited.connect(controller.change_acceptance)
        for name in ("before", "after", "wipe"):
            actions[name].toggled.connect(self._show_chosen_lines)
        actions.connect_slots({"validate": self.validate})
        self.model_differs.connect(panel.show_model_difference)
        document.changed.connect(self._compare_models)

    def validate(self) -> None:
        """Compare the lines on the validation planes."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return

        model = self.distance_to

        def work(progress: Progress) -> Project:
            from lispac.workflow.checking.validation import validate

            preload_matplotlib()
            return validate(project, survey, model=model, progress=progress)

        def done(validated: Project) -> None:
            if self._document.project is project:
                self._document.edit(_validation_edit_name(model), validated, **_model_params(model))
                self.validated.emit()
                for reason in validated.not_compared.values():
                    self._controller.logged.emit(message_text(reason))
                compared = Plural(
                    "Compared the lines on {count:n} validation plane",
                    "Compared the lines on {count:n} validation planes",
                )
                self._controller.logged.emit(gettext(compared, count=len(validated.validation)))

        task = self._runner.run(gettext("Validating"), work, done, key=VALIDATION_KEY)
        self._controller.cancel_on_edit(task)

    def _set_surface_model(self, model: LocalModel) -> None:
        self.distance_to = model
        self._compare_models()

    def _compare_models(self) -> None:
        """Say whether the comparison was made with another surface model than the chosen one."""
        project, text = self._document.project, ""
        if project is not None and project.validation:
            used = project.validation[0].model
            if used.name != self.distance_to.name:
                text = gettext(OTHER_MODEL_TEXT, model=message_text(used.name))
        self.model_differs.emit(text)

    def _show_chosen_lines(self) -> None:
        self._panel.show_before_after(
            before=self._actions["before"].isChecked(), after=self._actions["after"].isChecked()
        )


def _validation_edit_name(model: LocalModel) -> Template:
    """Name of the undo step of a validation, by its surface model."""
    if model.kind == "point":
        return N_("validation with distances to the nearest point")
    if model.radius is not None:
        if model.kind == "plane":
            return N_("validation with local planes within a radius of {radius:m} m")
        return N_("validation with local quadrics within a radius of {radius:m} m")
    if model.kind == "plane":
        return LOCAL_PLANES_EDIT_NAME
    return LOCAL_QUADRICS_EDIT_NAME


def _model_params(model: LocalModel) -> dict[str, float]:
    if model.radius is not None:
        return {"radius": model.radius}
    return {"count": model.neighbours}
