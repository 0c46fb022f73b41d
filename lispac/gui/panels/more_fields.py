"""What else can be chosen of the finder: fewest points and largest tilt, folded away."""

from dataclasses import replace
from math import degrees, radians

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.fields import Fold
from lispac.targets.settings import USUAL, FinderChoices


class MoreFields(QWidget):
    """Begins with the usual choices; those without a field stay as they are given."""

    def __init__(self, prefix: str) -> None:
        super().__init__()
        self._given = USUAL
        self.points = widgets.number(
            f"{prefix}_min_points", suffix="", decimals=0, low=3, high=1_000_000, step=10,
            tip="Fewest points of the target in a line: less finds small or distant targets, more "
            f"keeps scraps out (usually {USUAL.min_points})",
        )  # fmt: skip
        self.tilt = widgets.number(
            f"{prefix}_max_tilt", suffix="°", decimals=1, low=0.1, high=90, step=1,
            tip="Largest angle between the target in one line and in another: more where the prior "
            "boresight may be far off, less where surfaces of other slopes are near (usually "
            f"{degrees(USUAL.max_tilt):g}°)",
        )  # fmt: skip
        body = QWidget()
        form = QFormLayout(body)
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        form.addRow(say("Fewest points"), self.points)
        form.addRow(say("Largest tilt"), self.tilt)
        self.fold = Fold("More", f"{prefix}_more", body)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.fold)
        self.show_value(USUAL)
        for field in (self.points, self.tilt):
            field.valueChanged.connect(self._summarise)

    @property
    def value(self) -> FinderChoices:
        """What is chosen."""
        tilt = round(degrees(self._given.max_tilt), 1)
        return replace(
            self._given,
            min_points=int(self.points.value()),
            # What the field has rounded and nobody has touched stays exactly what it was.
            max_tilt=self._given.max_tilt if self.tilt.value() == tilt
            else radians(self.tilt.value()),
        )  # fmt: skip

    def show_value(self, choices: FinderChoices) -> None:
        """Fill in; unfolded where something is not the usual."""
        self._given = choices
        self.points.setValue(choices.min_points)
        self.tilt.setValue(round(degrees(choices.max_tilt), 1))
        self._summarise()
        self.fold.open(choices != USUAL)

    def _summarise(self) -> None:
        words = self.value.in_words.replace(" deg", "°").split(", ")
        self.fold.set_summary(", ".join(map(say, words)))
