"""Number fields that may be empty, and groups that can be folded."""

import math

from PySide6.QtCore import QLocale, Qt, Signal
from PySide6.QtWidgets import QLineEdit, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.units import Base
from lispac.language import gettext
from lispac.messages import error

BASES: dict[str, Base] = {"m": "m", "mm": "mm", "°": "°"}


class OptionalNumber(QLineEdit):
    """Field for a number with its unit; an empty field means unknown.

    Parameters
    ----------
    title : name of the field in the user's language, as all texts here
    unit : sign of the base unit, in which the tooltip and errors name it
    scale : units to one metre, radian or second
    empty : what an empty field means, or what belongs into one that is ``needed``
    description : what the number is, without its unit
    """

    def __init__(
        self,
        name: str,
        title: str,
        unit: str,
        scale: float,
        empty: str,
        description: str,
        needed: bool = False,
    ) -> None:
        super().__init__()
        self.setObjectName(name)
        base = BASES.get(unit)
        shown = units.shown_unit(base) if units.is_converted(base) else units.Unit(unit)
        self.setAccessibleName(f"{title}, {shown.sign}")
        if needed:
            tip = gettext("{description}, in {unit}", description=description, unit=shown.sign)
        else:
            tip = gettext(
                "{description}, in {unit}. If empty: {meaning}.",
                description=description, unit=shown.sign, meaning=empty,
            )  # fmt: skip
        self.setToolTip(tip)
        self.setPlaceholderText(empty)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFont(theme.tabular_font(self.font()))
        self.setMinimumWidth(48)
        self._title, self._unit, self._scale = title, shown.sign, scale * shown.factor
        self._shown_value: tuple[str, float] | None = None
        self.textChanged.connect(self._mark_invalid)

    def value(self) -> float | None:
        """Value in metres, radians or seconds; None if the field is empty.

        Raises
        ------
        InputError
            Where the text is not a number.
        """
        if self._shown_value is not None and self.text() == self._shown_value[0]:
            return self._shown_value[1]  # an unchanged value keeps all its digits
        text = self.text().strip().replace(",", ".").replace("−", "-")
        if not text:
            return None
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise InputError(
                error(
                    "window.not_a_number_in", field=self._title, text=self.text().strip(),
                    unit=self._unit,
                )
            )  # fmt: skip
        return number / self._scale

    def show_value(self, value: float | None) -> None:
        """Fill in without emitting a signal."""
        self.blockSignals(True)
        shown = "" if value is None else f"{value * self._scale:.6g}"
        self.setText(shown.replace(".", QLocale().decimalPoint()))
        self._shown_value = None if value is None else (self.text(), value)
        self.blockSignals(False)
        self._mark_invalid()

    def _mark_invalid(self) -> None:
        """Show by the frame whether the text is a valid standard deviation."""
        try:
            wrong = (self.value() or 0.0) < 0
        except InputError:
            wrong = True
        self.setProperty("wrong", wrong)
        self.style().unpolish(self)
        self.style().polish(self)


class FoldableGroup(QWidget):
    """Group with a heading that folds it and shows a summary of its settings.

    Parameters
    ----------
    title : in the user's language
    """

    folded = Signal(bool)

    def __init__(self, title: str, name: str, body: QWidget) -> None:
        super().__init__()
        self._title = title
        self.head = QToolButton()
        self.head.setObjectName(name)
        self.head.setCheckable(True)
        self.head.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.head.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.head.setStyleSheet(
            "QToolButton { border: none; font-weight: 600; padding: 3px 0; background: transparent;"
            f" text-align: left; }} QToolButton:hover, QToolButton:focus {{ color: {theme.ACCENT}; "
            "}"
        )
        self.head.toggled.connect(self._show)
        self.body = body
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.head)
        layout.addWidget(body)
        self.set_summary("")
        self._show(False)

    def set_summary(self, summary: str) -> None:
        """Show the settings inside, in the user's language."""
        text = gettext("{title}: {summary}", title=self._title, summary=summary)
        self.head.setText(text if summary else self._title)
        self.head.setToolTip(widgets.plain_tip(self.head.text()))

    def open(self, unfolded: bool = True) -> None:
        """Fold, or unfold."""
        self.head.setChecked(unfolded)

    def _show(self, unfolded: bool) -> None:
        self.head.setArrowType(Qt.ArrowType.DownArrow if unfolded else Qt.ArrowType.RightArrow)
        self.body.setVisible(unfolded)
        self.folded.emit(not unfolded)
