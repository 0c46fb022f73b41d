"""Panel of the five steps, one below the other; the open step shows its panel."""

from collections.abc import Sequence
from itertools import chain

from PySide6.QtCore import (
    QDynamicPropertyChangeEvent,
    QEvent,
    QObject,
    QSize,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtWidgets import (
    QApplication,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.app.docks import SIDE_WIDTH_PX, raise_panel
from lispac.gui.appearance import theme
from lispac.gui.project.status import STEP_KEYS, STEP_NAMES, ProjectState, StepState, StepStatus
from lispac.gui.widgets.elided_label import ElidedLabel
from lispac.gui.widgets.number_input import REASON_PROPERTY, first_error_of, number_fields
from lispac.language import N_, gettext
from lispac.messages import Message

_HEADER_HEIGHT_PX = 46
"""Height of the header of a step."""
_STATE_STYLES: dict[StepState, tuple[str, str, str]] = {
    "empty": ("circle-outline", "waiting", N_("not started")),
    "todo": ("circle-slice-4", "accent", N_("to do")),
    "done": ("check-circle", "done", N_("done")),
    "warning": ("alert-circle", "warning", N_("check this step")),
    "failed": ("close-circle", "error", N_("failed")),
}
"""Icon, colour and text of each state."""


class WorkflowPanel(QWidget):
    """Headers of the five steps with their state, with one panel open at a time."""

    step_opened = Signal(int)
    input_checked = Signal()
    """The text of a field is not accepted, is not accepted for another reason, or is accepted."""

    def __init__(self, panels: Sequence[QWidget]) -> None:
        super().__init__()
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.setSpacing(0)
        names = zip(STEP_KEYS, STEP_NAMES, strict=True)
        self.headers = [_StepHeader(k + 1, *each) for k, each in enumerate(names)]
        self._areas = []
        for k, (header, panel) in enumerate(zip(self.headers, panels, strict=True)):
            header.clicked.connect(lambda _=False, k=k: self.open(k))
            area = widgets.VerticalScrollArea(_top_aligned(panel), SIDE_WIDTH_PX)
            area.setObjectName(f"area_{STEP_KEYS[k].lower()}")
            self._areas.append(area)
            outer.addWidget(header)
            outer.addWidget(area, 1)
        self._fields = [number_fields(area) for area in self._areas]
        for field in chain.from_iterable(self._fields):
            field.installEventFilter(self)
        self.opened = -1
        self._width = 0
        self.open(0)
        QApplication.instance().focusChanged.connect(self._pass_on_focus)

    def input_errors(self) -> list[Message | None]:
        """First reason why a text typed in each step is not accepted; None if all texts are."""
        return [first_error_of(fields) for fields in self._fields]

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Emit `input_checked` when the mark of a field changes."""
        if (
            isinstance(event, QDynamicPropertyChangeEvent)
            and event.propertyName().data() == REASON_PROPERTY.encode()
        ):
            self.input_checked.emit()
        return super().eventFilter(watched, event)

    def minimumSizeHint(self) -> QSize:
        """Smallest size in pixels: as wide as the widest step, so that no step moves the view."""
        hint = super().minimumSizeHint()
        widths = (area.minimumSizeHint().width() for area in self._areas)
        self._width = max(self._width, hint.width(), *widths)
        return QSize(self._width, hint.height())

    def open(self, step: int) -> None:
        """Open one step, numbered from 0, and close the others.

        If the header of another step has the focus, it moves to that of the open step.
        """
        for k, (header, area) in enumerate(zip(self.headers, self._areas, strict=True)):
            header.setChecked(k == step)
            area.setVisible(k == step)
        if step != self.opened:
            self.opened = step
            if self.window().focusWidget() in self.headers:  # also in a window not yet in front
                self.focus_open_step()
            self.step_opened.emit(step)

    def focus_open_step(self) -> None:
        """Focus the header of the open step."""
        self.headers[self.opened].setFocus(Qt.FocusReason.OtherFocusReason)

    def _pass_on_focus(self, former: QWidget | None, focused: QWidget | None) -> None:
        """Focus the open step if Qt focuses another one because a widget was hidden."""
        if former is not None and not former.isVisible() and focused in self.headers:
            self.focus_open_step()

    def go_to(self, step: int) -> None:
        """Open one step, numbered from 0, in front of other panels, and focus its header."""
        raise_panel(self)
        self.open(step)
        self.headers[step].setFocus(Qt.FocusReason.ShortcutFocusReason)

    def scroll_to(self, widget: QWidget) -> None:
        """Scroll to a widget of the open step, once it is laid out."""
        area = self._areas[self.opened]
        QTimer.singleShot(0, area, lambda: area.ensureWidgetVisible(widget, 0, 0))

    def show_state(self, state: ProjectState) -> None:
        """Show the status of each step."""
        for header, status in zip(self.headers, state.steps, strict=True):
            header.show_status(status)


class _StepHeader(QPushButton):
    """Header with number, name and status of a step; a click opens the step."""

    def __init__(self, number: int, key: str, title: str) -> None:
        super().__init__()
        self.setObjectName(f"step_{key.lower()}")
        self.setProperty("step", True)
        self.setCheckable(True)
        self.setMinimumHeight(_HEADER_HEIGHT_PX)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self._title = f"{number}  {gettext(title)}"
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 3, 12, 3)
        row.setSpacing(10)
        self._glyph = QLabel()
        name = widgets.label("", "heading")
        name.setText(self._title)
        self.sentence = ElidedLabel()
        self.sentence.setProperty("role", "muted")
        texts = QVBoxLayout()
        texts.setSpacing(0)
        texts.addWidget(name)
        texts.addWidget(self.sentence)
        row.addWidget(self._glyph)
        row.addLayout(texts, 1)
        self._shown: tuple[str, ...] = ()
        for inner in (self._glyph, name, self.sentence):
            inner.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def sizeHint(self) -> QSize:
        return QSize(300, _HEADER_HEIGHT_PX)

    def show_status(self, status: StepStatus) -> None:
        shown = (status.state, status.sentence, status.advice)
        if shown == self._shown:
            return
        self._shown = shown
        icon, colour, state = _STATE_STYLES[status.state]
        self._glyph.setPixmap(theme.icon(icon, theme.colour(colour).name()).pixmap(18, 18))
        sentence = status.sentence
        self.sentence.setText(sentence)
        described = gettext("{step}: {status}", step=self._title, status=sentence)
        self.setAccessibleName(described)
        tip = f"{described} ({gettext(state)})\n{status.advice}"
        self.setToolTip(widgets.wrapped_tip(tip))


def _top_aligned(panel: QWidget) -> QWidget:
    holder = widgets.WrappedBody()
    layout = QVBoxLayout(holder)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(panel)
    layout.addStretch(1)
    margins = panel.layout().contentsMargins()
    margins.setRight(0)  # the reserved width of the scroll bar is the margin
    panel.layout().setContentsMargins(margins)
    return holder
