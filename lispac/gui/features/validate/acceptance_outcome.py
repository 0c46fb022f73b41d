"""Verdict on the calibration, and the probable causes of a failure."""

from collections.abc import Iterable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from lispac.adjustment.diagnostics.cause_warnings import EXPLAINED_CODES, main_wrong_value
from lispac.duplicate_targets import all_warnings
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate.acceptance_form import ICON_SIZE_PX, VERDICT_STYLES
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.present.calibration.cross_checks import cross_check_values
from lispac.present.checking.acceptance import (
    AcceptanceValues,
    calibration_verdict_text,
    verdict_text,
)
from lispac.present.checking.validation import ValidationPlane
from lispac.project import Project
from lispac.report.validation_warnings import acceptance_notes, probable_causes
from lispac.warning_causes import Cause, CauseKind

CAUSE_BUTTONS: dict[CauseKind, str] = {
    "field": N_("Show the POS accuracy"),
    "parameter": N_("Show the additional parameters"),
    "line": N_("Show line {name}"),
    "page": N_("Show the cross-checks"),
    "target": N_("Show {name}"),
    "step": N_("Go to the targets"),
}
"""Texts of the buttons that go to the causes of `probable_causes`."""


class AcceptanceOutcome(QWidget):
    """Verdict, and a button for each probable cause of a failure."""

    cause_requested = Signal(object)
    """The `Cause` to show."""

    def __init__(self) -> None:
        super().__init__()
        self.values: AcceptanceValues | None = None
        """Judgement that is shown; None if there is no verdict."""
        self._shown: tuple[object, ...] = ()
        layout = widgets.vertical_layout(self, 0)
        self.verdict = widgets.label("", wrap=True, name="acceptance_verdict")
        font = self.verdict.font()
        font.setBold(True)
        self.verdict.setFont(font)
        self.buttons: list[QPushButton] = []
        self._causes = QVBoxLayout()
        self._causes.setSpacing(4)
        self.notes = widgets.label("", wrap=True, name="acceptance_notes")
        self.icon = QLabel()
        self.icon.setObjectName("acceptance_icon")
        head = QHBoxLayout()
        head.addWidget(self.icon)
        head.addWidget(self.verdict, 1)
        layout.addLayout(head)
        layout.addLayout(self._causes)
        layout.addWidget(self.notes)

    def show_project(
        self,
        project: Project | None,
        problem: Message | None = None,
        *,
        is_validating: bool = False,
    ) -> None:
        """Show the verdict on the project; nothing without a result.

        Parameters
        ----------
        problem : reason why a typed criterion is not accepted, which is shown elsewhere; there is
            no verdict without it
        is_validating : whether the lines are being compared, so that there is no verdict yet
        """
        self.setVisible(project is not None and project.result is not None)
        if project is None or project.result is None:
            self.values, self._shown = None, ()
            return
        # Compared by identity: the objects are kept, so that none has the address of another
        source = (
            project.result, project.cross_checks, project.validation, project.targets,
            project.acceptance, problem, is_validating,
        )  # fmt: skip
        if len(self._shown) == len(source) and all(
            a is b for a, b in zip(source, self._shown, strict=True)
        ):
            return
        self._shown, self.values = source, None
        if problem is not None or is_validating:
            text = gettext("validating …") if problem is None else verdict_text("not judged")
            self._show_without_verdict(text, "" if problem is None else "error")
            return
        values = self.values = AcceptanceValues.of(project.judgement)
        self.verdict.setText(
            gettext("Acceptance: {verdict}", verdict=calibration_verdict_text(values))
        )
        checks = None if project.cross_checks is None else cross_check_values(project.cross_checks)
        wrong = main_wrong_value(all_warnings(project))
        notes = [
            message_text(each)
            for each in (acceptance_notes(values, checks) if values.checks else ())
            if wrong is None or each.code not in EXPLAINED_CODES
        ]
        self._show_notes(notes)
        self._show_style(*VERDICT_STYLES.get(values.verdict, ("", "")))
        planes = [ValidationPlane.of(each) for each in project.validation]
        failed = values.verdict == "fail"
        self._show_causes(probable_causes(values, planes, wrong) if failed else ())

    def _show_without_verdict(self, text: str, role: str) -> None:
        """Show that there is no verdict; the text above gives the reason."""
        self.verdict.setText(gettext("Acceptance: {verdict}", verdict=text))
        self._show_notes(())
        self._show_style("", role)
        self._show_causes(())

    def _show_notes(self, notes: Iterable[str]) -> None:
        self.notes.setText("\n".join(notes))
        self.notes.setVisible(bool(self.notes.text()))

    def _show_style(self, icon: str, role: str) -> None:
        self.icon.setVisible(bool(icon))
        if icon:
            self.icon.setPixmap(theme.quality_icon(icon).pixmap(ICON_SIZE_PX, ICON_SIZE_PX))
        self.verdict.setProperty("role", role)
        self.verdict.style().unpolish(self.verdict)
        self.verdict.style().polish(self.verdict)

    def _show_causes(self, causes: tuple[Message, ...]) -> None:
        self.buttons = []
        while (item := self._causes.takeAt(0)) is not None:
            item.widget().hide()
            item.widget().deleteLater()
        for number, message in enumerate(causes):
            text = widgets.label(
                message_text(message), wrap=True, name=f"acceptance_cause_{number}"
            )
            self._causes.addWidget(text)
            cause = message.subject
            if cause is None or (cause.kind == "step" and cause.name != "Targets"):
                continue
            title = gettext(CAUSE_BUTTONS[cause.kind], name=cause.name)
            button = widgets.button(title, f"show_cause_{number}", tip=message_text(message))
            button.clicked.connect(lambda _=False, cause=cause: self._emit(cause))
            self.buttons.append(button)
            self._causes.addWidget(button)

    def _emit(self, cause: Cause) -> None:
        self.cause_requested.emit(cause)
