"""Field for a number with its unit that may be empty."""

import math

from PySide6.QtCore import QLocale, Qt
from PySide6.QtWidgets import QLineEdit

from lispac.errors import InputError
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.units import Base
from lispac.language import gettext
from lispac.messages import error

BASE_OF_SIGN: dict[str, Base] = {"m": "m", "mm": "mm", "°": "°"}


class OptionalNumber(QLineEdit):
    """Field for a number with its unit; an empty field means unknown.

    Parameters
    ----------
    title : name of the field in the user's language, as all texts of this class
    unit : sign of the base unit
    scale : number of base units in one metre, radian or second
    empty : meaning of an empty field, or the expected content of a ``needed`` field
    description : description of the number, without its unit
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
        base = BASE_OF_SIGN.get(unit)
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
            If the text is not a number.
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
        """Fill in a value without emitting a signal."""
        self.blockSignals(True)
        shown = "" if value is None else f"{value * self._scale:.6g}"
        self.setText(shown.replace(".", QLocale().decimalPoint()))
        self._shown_value = None if value is None else (self.text(), value)
        self.blockSignals(False)
        self._mark_invalid()

    def _mark_invalid(self) -> None:
        """Mark the field as wrong if its text is not a number or is negative."""
        try:
            wrong = (self.value() or 0.0) < 0
        except InputError:
            wrong = True
        self.setProperty("wrong", wrong)
        self.style().unpolish(self)
        self.style().polish(self)
