"""Further options of the search for targets: fewest points and largest tilt, folded away."""

from dataclasses import replace
from math import degrees, radians

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from lispac.gui.panels import widgets
from lispac.gui.panels.fields import Fold
from lispac.language import gettext, number
from lispac.targets.settings import USUAL, FinderChoices


class MoreFields(QWidget):
    """Fields for the options; options without a field keep the given values."""

    def __init__(self, prefix: str) -> None:
        super().__init__()
        self._given = USUAL
        self.points = widgets.number(
            f"{prefix}_min_points", suffix="", decimals=0, low=3, high=1_000_000, step=10,
            tip=gettext(
                "Fewest points of the target in a line (default {count:n}). Fewer find small or "
                "distant targets, more exclude fragments.",
                count=USUAL.min_points,
            ),
        )  # fmt: skip
        self.tilt = widgets.number(
            f"{prefix}_max_tilt", suffix="°", decimals=1, low=0.1, high=90, step=1,
            tip=gettext(
                "Largest angle between the normals of the target in two lines (default "
                "{angle:deg.0}°). Use more for a poor prior boresight, less where other slopes are "
                "near.",
                angle=USUAL.max_tilt,
            ),
        )  # fmt: skip
        body = QWidget()
        form = QFormLayout(body)
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        form.addRow(gettext("Fewest points"), self.points)
        form.addRow(gettext("Largest tilt"), self.tilt)
        self.fold = Fold(gettext("More"), f"{prefix}_more", body)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.fold)
        self.show_value(USUAL)
        for field in (self.points, self.tilt):
            field.valueChanged.connect(self._summarise)

    @property
    def value(self) -> FinderChoices:
        """The chosen options."""
        tilt = round(degrees(self._given.max_tilt), 1)
        return replace(
            self._given,
            min_points=int(self.points.value()),
            # A value that the field has only rounded stays exact.
            max_tilt=self._given.max_tilt if self.tilt.value() == tilt
            else radians(self.tilt.value()),
        )  # fmt: skip

    def show_value(self, choices: FinderChoices) -> None:
        """Show options; unfolded if any is not the default."""
        self._given = choices
        self.points.setValue(choices.min_points)
        self.tilt.setValue(round(degrees(choices.max_tilt), 1))
        self._summarise()
        self.fold.open(choices != USUAL)

    def _summarise(self) -> None:
        self.fold.set_summary(", ".join(_differences(self.value)))


def _differences(chosen: FinderChoices) -> list[str]:
    """The options that are not the default."""
    found = []
    if chosen.min_points != USUAL.min_points:
        found.append(gettext("at least {count:n} points", count=chosen.min_points))
    if chosen.max_tilt != USUAL.max_tilt:
        tilt = round(degrees(chosen.max_tilt), 1)
        angle = number(tilt, 0 if tilt.is_integer() else 1)
        found.append(gettext("at most {angle}° of tilt", angle=angle))
    if chosen.stop != USUAL.stop:
        found.append(gettext("stop criterion {value:x}", value=chosen.stop))
    if chosen.seed != USUAL.seed:
        found.append(gettext("random seed {seed:n}", seed=chosen.seed))
    return found
