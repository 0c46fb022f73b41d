"""Threshold, search radius and the rest with which a target is to be found again."""

from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLayout, QWidget

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.more_fields import MoreFields
from lispac.project import Target
from lispac.targets.settings import FinderChoices


class FindAgainDialog(QDialog):
    """Begins with what the target was found with."""

    def __init__(self, target: Target, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("find_again_dialog")
        self.setWindowTitle(say(f"Find {target.name} again"))
        layout = widgets.column(self, 16)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetFixedSize)  # it follows the fold
        layout.addWidget(
            widgets.label(
                f"{target.name} is searched for at its seed on every line with these settings. "
                "What is found is offered in place of the present one.",
                wrap=True,
            )
        )
        self._threshold = widgets.number(
            "again_threshold", suffix=" mm", decimals=0, low=1, high=1000, step=5,
            tip="Farthest a point may lie from its plane or sphere: less keeps rough edges out, "
            "more takes in a rough or smeared surface",
        )  # fmt: skip
        self._threshold.setValue(1000 * target.threshold)
        self._radius = widgets.number(
            "again_radius", suffix=" m", decimals=2, low=0.05, high=100, step=0.25,
            tip="Only points this near to the seed can belong to the target",
        )  # fmt: skip
        self._radius.setValue(target.radius)
        form = QFormLayout()
        form.addRow(say("Threshold"), self._threshold)
        form.addRow(say("Search radius"), self._radius)
        layout.addLayout(form)
        self._more = MoreFields("again")
        self._more.show_value(target.choices)
        layout.addWidget(self._more)
        find = widgets.button("Find", "again_find", primary=True)
        find.setDefault(True)
        find.clicked.connect(self.accept)
        cancel = widgets.button("Cancel", "again_cancel")
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(find, cancel):
            row.addWidget(each)
        layout.addLayout(row)

    @property
    def settings(self) -> tuple[float, float, FinderChoices]:
        """Threshold and search radius, metres, and what else is chosen."""
        return self._threshold.value() / 1000, self._radius.value(), self._more.value
