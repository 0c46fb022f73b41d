"""Further options of the target search, folded: smallest number of points, largest tilt."""

from dataclasses import replace
from math import degrees, radians

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.language import gettext
from lispac.targets.finder_settings import DEFAULT_CHOICES, FinderChoices


class SearchOptionFields(QWidget):
    """Fields for the options; options without a field keep the given values."""

    def __init__(self, prefix: str) -> None:
        super().__init__()
        self._options = DEFAULT_CHOICES
        self.points = widgets.number(
            f"{prefix}_min_points", suffix="", decimals=0, low=3, high=1_000_000, step=10,
            tip=gettext(
                "Minimum number of points of the target in a line (default {count:n}). A "
                "smaller number finds small or distant targets; a larger number excludes "
                "fragments.",
                count=DEFAULT_CHOICES.min_points,
            ),
        )  # fmt: skip
        self.tilt = widgets.number(
            f"{prefix}_max_tilt", suffix="°", decimals=1, low=0.1, high=90, step=1,
            tip=gettext(
                "Largest angle between the normals of the target in two lines (default "
                "{angle:deg.0}°). Increase it for an inaccurate prior boresight; reduce it "
                "near surfaces with other slopes.",
                angle=DEFAULT_CHOICES.max_tilt,
            ),
        )  # fmt: skip
        body = QWidget()
        form = QFormLayout(body)
        form.setContentsMargins(0, 0, 0, 0)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setHorizontalSpacing(10)
        form.setVerticalSpacing(6)
        form.addRow(gettext("Minimum points"), self.points)
        form.addRow(gettext("Angle between normals"), self.tilt)
        self.fold = FoldableGroup(gettext("More settings"), f"{prefix}_more", body)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.fold)
        self.show_value(DEFAULT_CHOICES)
        for field in (self.points, self.tilt):
            field.valueChanged.connect(self._summarise)

    @property
    def value(self) -> FinderChoices:
        """The chosen options."""
        tilt = round(degrees(self._options.max_tilt), 1)
        return replace(
            self._options,
            min_points=int(self.points.value()),
            # A value that the field only rounds keeps all its digits.
            max_tilt=self._options.max_tilt if self.tilt.value() == tilt
            else radians(self.tilt.value()),
        )  # fmt: skip

    def show_value(self, choices: FinderChoices) -> None:
        """Show options, and unfold the fields if an option is not the default."""
        self._options = choices
        self.points.setValue(choices.min_points)
        self.tilt.setValue(round(degrees(choices.max_tilt), 1))
        self._summarise()
        self.fold.open(choices != DEFAULT_CHOICES)

    def _summarise(self) -> None:
        value, parts = self.value, []
        if value.min_points != DEFAULT_CHOICES.min_points:
            parts.append(gettext("at least {count:n} points", count=value.min_points))
        if value.max_tilt != DEFAULT_CHOICES.max_tilt:
            parts.append(
                gettext("angle between normals at most {angle:deg.1}°", angle=value.max_tilt)
            )
        if value.stop != DEFAULT_CHOICES.stop:
            parts.append(gettext("RANSAC confidence {value:x}", value=value.stop))
        if value.seed != DEFAULT_CHOICES.seed:
            parts.append(gettext("random-number seed {number}", number=value.seed))
        self.fold.set_summary(", ".join(parts))
