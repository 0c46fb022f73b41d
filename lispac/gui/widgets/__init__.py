"""Widgets of the panels and dialogues; the small ones are in this module."""

from collections.abc import Sequence
from functools import lru_cache
from html import escape
from textwrap import fill
from typing import Any

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QFontMetrics, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QComboBox,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QLabel,
    QMessageBox,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QStyle,
    QStyleOptionComboBox,
    QToolTip,
    QVBoxLayout,
    QWidget,
)

from lispac.gui.appearance import theme, units
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.number_field import BASE_OF_SUFFIX, NumberField
from lispac.gui.widgets.number_input import types_character
from lispac.gui.widgets.tab_order import ENTER_KEYS
from lispac.language import N_, gettext
from lispac.present.calibration.adjustment import SHORT_ANGLE_SIGNS

TIP_LENGTH = 90
"""Length of the lines of a tooltip, characters."""


def label(
    text: str = "", role: str = "", *, wrap: bool = False, name: str = "", rich: bool = False
) -> QLabel:
    """Create a label; ``role`` is a role of labels in the style sheet, such as error.

    Parameters
    ----------
    rich : bool
        Whether the text is HTML, in which names must be escaped.
    """
    widget = QLabel(text)
    widget.setTextFormat(Qt.TextFormat.RichText if rich else Qt.TextFormat.PlainText)
    widget.setProperty("role", role)
    widget.setWordWrap(wrap)
    widget.setObjectName(name)
    if wrap:
        widget.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
    return widget


def introduction(text: str, width: int, role: str = "", name: str = "") -> QLabel:
    """Wrapped text of a dialogue that is as high as it needs at the smallest width.

    The smallest height of any other wrapped label is that at the width of its size hint, which is
    much narrower; the dialogue would have a gap.

    Parameters
    ----------
    width : smallest width of the dialogue inside its margins, pixels
    """
    widget = label(text, role, wrap=True, name=name)
    widget.ensurePolished()
    widget.setFixedHeight(widget.heightForWidth(width))
    return widget


class MessageBox(QMessageBox):
    """Message box with plain text, since file names may look like HTML."""

    def __init__(self, *args: Any, **named: Any) -> None:
        super().__init__(*args, **named)
        self.setTextFormat(Qt.TextFormat.PlainText)

    def setInformativeText(self, text: str) -> None:
        """Set the text below the main one."""
        super().setInformativeText(text)
        for each in self.findChildren(QLabel):
            each.setTextFormat(Qt.TextFormat.PlainText)


def plain_tip(text: str) -> str:
    """Tooltip as plain text, even if it looks like HTML."""
    return f"<p>{escape(text)}</p>".replace("\n", "<br>") if Qt.mightBeRichText(text) else text


@lru_cache(maxsize=2048)
def wrapped_tip(text: str) -> str:
    """Tooltip in lines of readable length; Qt shows plain text of any length in one line."""
    return plain_tip("\n".join(fill(line, TIP_LENGTH) for line in text.split("\n")))


class Button(QPushButton):
    """Push button that gets the focus back when `update_enabled` enables it again.

    Enter presses the focused button, also in a dialogue with another default button.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._focus_went_to: QWidget | None = None
        self.tip = ""
        """Tip of the enabled button."""

    def set_reason(self, reason: str) -> None:
        """Disable the button, with the reason in its tip; an empty text enables it."""
        self.update_enabled(not reason)
        self.setToolTip("\n".join(text for text in (self.tip, reason) if text))

    def update_enabled(self, enabled: bool) -> None:
        """Enable or disable the button."""
        had_focus = self.hasFocus()
        self.setEnabled(enabled)
        if had_focus and not enabled:
            self._focus_went_to = QApplication.focusWidget()
        elif enabled and self._focus_went_to is not None:
            # The focus is not moved if the user has changed it meanwhile.
            if QApplication.focusWidget() is self._focus_went_to:
                self.setFocus()
            self._focus_went_to = None

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press the button with Enter only if it has the focus."""
        if event.key() in ENTER_KEYS and not event.isAutoRepeat():
            self.click()
        else:
            super().keyPressEvent(event)


def button(text: str, name: str, *, icon: str = "", tip: str = "", primary: bool = False) -> Button:
    """Create a push button."""
    widget = Button(text)
    widget.setObjectName(name)
    widget.tip = tip
    widget.setToolTip(tip)
    if primary:
        widget.setProperty("primary", True)
    if icon:
        widget.setIcon(theme.icon(icon, theme.ON_FILL if primary else ""))
        widget.setIconSize(QSize(16, 16))
    return widget


def enlarge_button(name: str) -> Button:
    """Create a button that is checked while a panel at the bottom of the window is enlarged."""
    made = button(
        "", name, icon="arrow-expand-vertical",
        tip=gettext("Enlarge the panel for a larger plot, or restore its height"),
    )  # fmt: skip
    made.setAccessibleName(gettext("Enlarge the panel"))
    made.setStyleSheet("padding: 1px 5px;")
    made.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
    made.setCheckable(True)
    return made


def in_platform_order(accept: QPushButton, reject: QPushButton) -> tuple[QPushButton, QPushButton]:
    """Return two buttons from left to right, in the order used by dialogues of the system."""
    layouts = QDialogButtonBox.ButtonLayout
    layout = QApplication.style().styleHint(QStyle.StyleHint.SH_DialogButtonLayout)
    accept_first = layout in (layouts.WinLayout.value, layouts.KdeLayout.value)
    return (accept, reject) if accept_first else (reject, accept)


def number(
    name: str,
    *,
    suffix: str,
    decimals: int,
    low: float,
    high: float,
    step: float,
    tip: str = "",
    title: str = "",
    ranged: bool = False,
    fixed: bool = False,
) -> NumberField:
    """Create a number field with a unit; the mouse wheel changes it only if it has the focus.

    Without unit and decimals it accepts whole numbers only.

    Parameters
    ----------
    title : str
        Name of the field in messages; the tip if empty.
    suffix, decimals, low, high, step : unit of the value, and its properties in this unit
    ranged : bool
        Whether the range and the unit are added to the tip.
    fixed : bool
        Whether the value is always shown in this unit, independent of the units of the user.
    """
    base = None if fixed else BASE_OF_SUFFIX.get(suffix)
    bases = () if base is None else (base,)
    if ranged:
        tip = _tip_with_range(tip, low, high, suffix.strip(), base)
    tip = units.convert_unit_signs(tip, *bases, figures=ranged)
    field = NumberField(base)
    field.setObjectName(name)
    field.setAccessibleName(tip or name)
    field.title, field.whole = title, not suffix and not decimals
    field.setDecimals(decimals)
    field.setRange(low, high)
    field.setSingleStep(step if base is None else units.shown_step(step, base))
    field.setSuffix(f" {units.shown_unit(base).sign}" if units.is_converted(base) else suffix)
    field.setToolTip(tip)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setFont(theme.tabular_font(field.font()))
    field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    field.setKeyboardTracking(True)
    return field


def _tip_with_range(tip: str, low: float, high: float, unit: str, base: Base | None) -> str:
    first, last = (units.limit_text(each, base) for each in (low, high))
    sign = "deg" if unit == "°" else unit
    first, last = units.localised(first), units.localised(last)
    if not unit:
        return gettext("{tip}, {low} to {high}", tip=tip, low=first, high=last)
    return gettext("{tip}, {low} to {high} {unit}", tip=tip, low=first, high=last, unit=sign)


class ChoiceBox(QComboBox):
    """Combo box; the mouse wheel changes it only if it has the focus.

    Its list is as wide as its longest item. Where the box is too narrow for the chosen item, the
    tip contains the item.
    """

    def __init__(self, name: str, items: Sequence[str], tip: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.addItems(list(items))
        self.setToolTip(wrapped_tip(tip))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        # Long items are cut off, so that they do not widen the panel.
        if max(len(item) for item in items) > 12:
            self.setSizeAdjustPolicy(self.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            self.setMinimumContentsLength(12)

    @property
    def is_cut(self) -> bool:
        """Whether the box is too narrow for the chosen item."""
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        field = self.style().subControlRect(
            QStyle.ComplexControl.CC_ComboBox, option,
            QStyle.SubControl.SC_ComboBoxEditField, self,
        )  # fmt: skip
        icon = 0 if option.currentIcon.isNull() else self.iconSize().width() + 4
        return self.fontMetrics().horizontalAdvance(self.currentText()) + icon > field.width()

    def showPopup(self) -> None:
        """Show the list with the whole text of its items."""
        view = self.view()
        bar = self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollBarExtent)
        needed = view.sizeHintForColumn(0) + 2 * view.frameWidth() + bar
        view.setMinimumWidth(min(needed, self.screen().availableGeometry().width()))
        super().showPopup()

    def event(self, event: QEvent) -> bool:
        """Add the chosen item to the tip if it is cut off."""
        if event.type() == QEvent.Type.ToolTip and self.is_cut:
            tip = "\n".join(text for text in (self.currentText(), self.toolTip()) if text)
            QToolTip.showText(event.globalPos(), plain_tip(tip), self)
            return True
        return super().event(event)

    def wheelEvent(self, event) -> None:
        """Change the value only with the focus; otherwise scroll the page."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


def in_lines(text: str, metrics: QFontMetrics, width: int) -> str:
    """Text with line breaks between words, for widgets that do not wrap their text.

    Parameters
    ----------
    width : largest width of a line of more than one word, pixels
    """
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and metrics.horizontalAdvance(longer) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return "\n".join(lines)


class VerticalScrollArea(QScrollArea):
    """Scroll area that scrolls vertically only and is as wide as its content.

    While it has the focus, a content that becomes lower does not scroll, and letters and digits
    start no action of the window, except in lists and tables: the user is typing values.

    Parameters
    ----------
    min_width : smallest width, pixels
    """

    def __init__(self, inside: QWidget, min_width: int) -> None:
        super().__init__()
        self._min_width, self._content_width = min_width, 0
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(inside)
        self.verticalScrollBar().installEventFilter(self)
        self._reserve_bar(is_shown=False)

    def _reserve_bar(self, *, is_shown: bool) -> None:
        """Keep the width of the content, whether the scroll bar is shown or not."""
        bar = self.verticalScrollBar().sizeHint().width()
        self.setViewportMargins(0, 0, 0 if is_shown else bar, 0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Update the width when the content becomes wider, or the scroll bar appears."""
        if watched is self.verticalScrollBar() and event.type() in (
            QEvent.Type.Show, QEvent.Type.Hide
        ):  # fmt: skip
            self._reserve_bar(is_shown=event.type() == QEvent.Type.Show)
        if event.type() == QEvent.Type.LayoutRequest and watched is self.widget():
            width = self.minimumSizeHint().width()
            if width != self._content_width:
                self._content_width = width
                self.updateGeometry()
        return super().eventFilter(watched, event)

    def event(self, event: QEvent) -> bool:
        """Keep typed characters that the focused widget does not use from starting an action."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            is_list = isinstance(QApplication.focusWidget(), QAbstractItemView)
            if types_character(event) and not is_list:
                event.accept()
                return True
        return super().event(event)

    @property
    def held_height(self) -> int:
        """Height of the content with which the visible part stays in place; 0 without the focus."""
        focused, place = QApplication.focusWidget(), self.verticalScrollBar().value()
        if not place or focused is None or not self.isAncestorOf(focused):
            return 0
        return place + self.viewport().height()

    def minimumSizeHint(self) -> QSize:
        """Smallest size for content and scroll bar, in pixels."""
        inside = self.widget().minimumSizeHint().width()
        bar = self.verticalScrollBar().sizeHint().width()
        return QSize(max(inside + bar, self._min_width), super().minimumSizeHint().height())


class WrappedBody(QWidget):
    """Content of a resizable scroll area, only as high as its wrapped texts at its real width.

    The smallest size of a layout has the height of texts that are wrapped at their smallest width.
    """

    def heightForWidth(self, width: int) -> int:
        """Height of the texts, or more so that a lower content does not scroll its fields."""
        viewport = self.parentWidget()
        area = None if viewport is None else viewport.parentWidget()
        held = area.held_height if isinstance(area, VerticalScrollArea) else 0
        return max(super().heightForWidth(width), held)

    def minimumSizeHint(self) -> QSize:
        """Smallest size in pixels; the scroll area adds the height for the width."""
        hint = super().minimumSizeHint()
        return QSize(hint.width(), 0) if self.layout().hasHeightForWidth() else hint


class TripleField(QWidget):
    """Three number fields side by side with a title above each."""

    def __init__(self, titles: Sequence[str], fields: Sequence[NumberField]) -> None:
        super().__init__()
        self.fields = tuple(fields)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(2)
        for column, (title, field) in enumerate(zip(titles, fields, strict=True)):
            title_label = label(title, "muted")
            title_label.setBuddy(field)
            grid.addWidget(title_label, 0, column)
            field.setMinimumWidth(86)
            grid.addWidget(field, 1, column)
            grid.setColumnStretch(column, 1)
            field.committed.connect(self._accept_all)

    def value(self) -> tuple[float, float, float]:
        """The three numbers."""
        a, b, c = (field.value() for field in self.fields)
        return a, b, c

    def set_value(self, values: Sequence[float]) -> None:
        """Set the three numbers without emitting signals."""
        for field, value in zip(self.fields, values, strict=True):
            field.blockSignals(True)
            field.setValue(value)
            field.blockSignals(False)

    def show_assumed(self, values: Sequence[float]) -> None:
        """Show three defaults that nobody gave; all are given as soon as the user types one."""
        for field, value in zip(self.fields, values, strict=True):
            field.blockSignals(True)
            field.show_assumed(value)
            field.blockSignals(False)

    @property
    def is_assumed(self) -> bool:
        """Whether the numbers are defaults that nobody gave."""
        return all(field.is_assumed for field in self.fields)

    def _accept_all(self) -> None:
        if not self.is_assumed:
            self.set_value(self.value())


_LEVER_ARM_TEXTS = (
    (N_("X forward"), N_("Lever arm X"),
     N_("Lever arm X from the POS centre to the LiDAR optical centre, metres, positive forward")),
    (N_("Y left"), N_("Lever arm Y"),
     N_("Lever arm Y from the POS centre to the LiDAR optical centre, metres, positive left")),
    (N_("Z up"), N_("Lever arm Z"),
     N_("Lever arm Z from the POS centre to the LiDAR optical centre, metres, positive up")),
)  # fmt: skip
_BORESIGHT_TEXTS = (
    (N_("Roll"), N_("Prior roll"),
     N_("Prior roll of the LiDAR in the body frame, degrees, positive port side up")),
    (N_("Pitch"), N_("Prior pitch"),
     N_("Prior pitch of the LiDAR in the body frame, degrees, positive bow down")),
    (N_("Yaw"), N_("Prior yaw"),
     N_("Prior yaw of the LiDAR in the body frame, degrees, positive clockwise from above")),
)  # fmt: skip
"""Title above each field, its name in messages, and its tip."""


def lever_arm_fields(prefix: str) -> TripleField:
    """Fields of the lever arm, metres."""
    fields = [
        number(
            f"{prefix}_{axis}", suffix=" m", decimals=4, low=-100, high=100, step=0.01,
            tip=gettext(tip), title=gettext(title),
        )
        for axis, (_, title, tip) in zip("xyz", _LEVER_ARM_TEXTS, strict=True)
    ]  # fmt: skip
    return TripleField([gettext(title) for title, *_ in _LEVER_ARM_TEXTS], fields)


LEVER_ARM_SIGMA_HINT = N_(
    "The standard deviations of the angles contain these values. If all three are 0, the lever arm "
    "is assumed exact."
)


def lever_arm_sigma_fields(prefix: str) -> TripleField:
    """Fields of the standard deviations of the lever arm, metres; zero in all if not given."""
    fields = [
        number(
            f"{prefix}_{axis}", suffix=" m", decimals=4, low=0, high=100, step=0.001,
            tip=gettext(
                "Standard deviation of the lever arm along {axis}, metres. It increases those of "
                "the angles and is part of the error budget.",
                axis=axis.upper(),
            ),
            title=gettext("Lever arm {axis} (1 σ)", axis=axis.upper()),
        )
        for axis in "xyz"
    ]  # fmt: skip
    return TripleField([gettext(title) for title, *_ in _LEVER_ARM_TEXTS], fields)


def angle_noise_field(name: str) -> NumberField:
    """Field of the noise of the beam direction, degrees; zero if it is not given."""
    field = number(
        name, suffix=" °", decimals=4, low=0, high=10, step=0.001,
        tip=gettext(
            "Standard deviation of the beam direction. If it is 0, the LiDAR noise is the same "
            "along all axes."
        ),
        title=gettext("Beam angular noise (1 σ)"),
    )  # fmt: skip
    field.setSpecialValueText(gettext("none given"))
    return field


def divergence_field(name: str) -> NumberField:
    """Field of the beam divergence, milliradians; zero if it is not given."""
    field = number(
        name, suffix=" mrad", decimals=2, low=0, high=100, step=0.1,
        tip=gettext(
            "Beam divergence as full angle, in milliradians, for the error budget. If it is 0, the "
            "beam footprint is not included."
        ),
        title=gettext("Beam divergence"),
    )  # fmt: skip
    field.setSpecialValueText(gettext("none given"))
    return field


def boresight_fields(prefix: str) -> TripleField:
    """Fields of the prior boresight, degrees."""
    fields = [
        number(
            f"{prefix}_{angle}", suffix=" °", decimals=4, low=-360, high=360, step=0.1,
            tip=gettext(tip), title=gettext(title),
        )
        for angle, (_, title, tip) in zip(
            ("roll", "pitch", "yaw"), _BORESIGHT_TEXTS, strict=True
        )
    ]  # fmt: skip
    titles = [
        f"{gettext(title)}\n{gettext(sign)}"
        for (title, *_), sign in zip(_BORESIGHT_TEXTS, SHORT_ANGLE_SIGNS, strict=True)
    ]
    return TripleField(titles, fields)


def vertical_layout(parent: QWidget, margin: int = 12) -> QVBoxLayout:
    """Vertical layout with the spacing of all panels."""
    layout = QVBoxLayout(parent)
    layout.setContentsMargins(margin, margin, margin, margin)
    layout.setSpacing(theme.SPACING)
    return layout
